#pragma once
// The pressure of liquid with a free surface: (A + J M^-1 J^T) p = b, where A is the sum over open faces of
// weight * (p - p_neighbour), and J what bodies that the pressure moves add to the divergence of cells (Batty, Bertails and
// Bridson 2007). Conjugate gradients; what leads them is one cycle of multigrid (McAdams, Sifakis and Teran 2010) on the
// tiles that hold liquid, so that its cost does not grow with the box.
#include "fluid/grid.hpp"
#include "fluid/water/press_wide.hpp"
#include "math/vec2.hpp"
#include "refs.hpp"
#include <span>
#include <vector>

namespace evil::fluid {

// A body's share in the divergence of a cell: what flows out of the cell when the body moves.
struct Reach {
    std::int32_t at;
    float x, y, turn; // for 1 m/s each way, and for 1 rad/s
    std::uint32_t body;
};

struct Rider { // a body in the equation
    std::uint32_t body = kNone;
    std::uint32_t first = 0, last = 0; // its reaches
    bool free = false;                 // does the pressure move it?
    Vec2 velocity;                     // before the pressure acts
    float spin = 0.0f;
    float per_mass = 0.0f, per_inertia = 0.0f; // what a pressure of 1 on a reach of 1 changes its velocity and spin by
    Vec2 stop;                                 // a direction that it is held in, by that length: 1 is wholly
};

struct Riders {
    std::span<const Rider> all;
    std::span<const Reach> reaches;
};

struct PushOf { // what a pressure does to a rider: sums over its reaches
    double x = 0.0, y = 0.0, turn = 0.0;
};
PushOf push_of(const Rider& rider, std::span<const Reach> reaches, const float* pressure);

struct PressLevel {
    Grid grid;
    Field left, right, below, above; // weights of the faces to neighbours that hold liquid, too
    Field drain;                     // weights of those to air
    Field total, inverse;            // of all of a cell's weights; inverse: 0 where there is no liquid
    Field z, b;
    std::vector<Tile> tiles;
    std::vector<std::uint8_t> marked;
    PressView view();
};

class Press {
public:
    void lay_out(const Grid& grid);

    // Between these two, the finest level's weights are set: all but the tiles named are without liquid.
    void begin();
    void add_tile(const Tile& tile) { levels_[0].tiles.push_back(tile); }
    void finish(InstructionSet set);

    PressLevel& finest() { return levels_[0]; }
    bool any() const { return !levels_[0].tiles.empty(); }

    // p from the p that is there, which is 0 where there is no liquid. Returns how many rounds it took.
    int solve(const Field& b, Field& p, const Riders& riders, float tolerance, int most_rounds, InstructionSet set);

private:
    void cycle(std::size_t level, InstructionSet set);
    void find_pockets();
    void join_pockets(const Riders& riders);
    std::size_t whole(std::int32_t pocket) const;
    void balance(const Field& b,
                 const Riders& riders); // the finest level's b becomes this one, as far as a flow can bring it about
    void add_riders(const Riders& riders, const float* p, float* result, double* energy) const;
    std::vector<PressLevel> levels_;
    Field search_, image_; // of the conjugate gradients; the residual is the finest level's b

    // Cells that are joined by open faces. Where no air is and no body gives way, what they gather on the whole stays: no
    // pressure could change it.
    struct Pocket {
        float cells = 0.0f;
        Vec2 way; // by how much it grows when a body moves along
        bool drained = false;
        std::int32_t part_of = 0;              // the pocket that stands for all that bodies join to one
        float sum = 0.0f, cells_in_all = 0.0f; // of that
        bool gives_way = false;
    };
    std::vector<std::int32_t> pocket_of_; // by cell
    std::vector<std::int32_t> joined_;    // pockets to lower ones
    std::vector<Pocket> pockets_;
    bool any_closed_ = false;
};

} // namespace evil::fluid
