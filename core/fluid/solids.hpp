#pragma once
// What stands in a fluid's way: the shares of faces that the bodies' shapes leave open (Ng, Min and Gibou 2009; Batty,
// Bertails and Bridson 2007), how the bodies move there, and where they can be pushed. From the shapes' signed distances
// at the corners of cells; only round what moved since the last step is anything made anew. Scratch: it follows from the
// bodies alone.
#include "bodies.hpp"
#include "fluid/pockets.hpp"
#include "fluid/solids_wide.hpp"
#include <span>

namespace evil {
struct World;
struct Body;
} // namespace evil

namespace evil::fluid {

struct Wall { // a face that a moving body covers, wholly or in part
    std::ptrdiff_t at;
    float closed; // share
    Vec2 place;   // its middle, in the world
    std::uint32_t body;
};

struct Shore { // a cell with gas that a body reaches into that moves
    int i, j;
    Vec2 area; // metres of the body's outline in it, times its direction into the body
    std::uint32_t body;
};

// Is a body too small for cells to see? Its radius of gyration is less than 0.6 of a cell's side.
bool is_small(const Body& body, float cell);

class Solids {
public:
    void lay_out(const Grid& grid, const std::array<bool, 4>& open, bool with_small = true);

    // Finds out what changed since the last call and draws that anew; gives the corners of cells that it touched.
    std::span<const Patch> redraw(const World& world, const Grid& grid, InstructionSet set);
    // The same, in the pressure's faces too, and finds walls and shores. True: something changed.
    bool update(const World& world, const Grid& grid, Pressure& pressure, InstructionSet set);

    const Field& across() const { return across_; } // open shares of left faces, 0..1
    const Field& up() const { return up_; }         // of lower faces
    const Field& open() const { return gas_; }      // of cells: 1 where there is gas, 0 where all is solid
    const Field& room() const { return room_; }     // 1 where smoke may be: where the middle of the cell is gas
    bool is_open(std::ptrdiff_t at, int stride) const {
        return across_[at] + across_[at + 1] + up_[at] + up_[at + stride] > 0.0f;
    }
    std::span<const Wall> walls_across() const { return walls_across_; }
    std::span<const Wall> walls_up() const { return walls_up_; }
    std::span<const Shore> shores() const { return shores_; }
    const Field& owner() const { return owner_; }       // at corners: the slot of the nearest body + 1, or 0
    const Field& distance() const { return distance_; } // cells, at corners; negative inside a body; 1e30 far from any
    bool any() const { return !pieces_.empty(); }
    template <class Visit> void each_piece(Visit visit) const { // visit(body, the corners of cells that it may be near)
        for (const Seen& seen : pieces_) visit(seen.body, seen.patch);
    }
    Pockets& pockets() { return pockets_; }

private:
    struct Seen { // a piece as it was drawn
        std::uint32_t piece = kNone, body = kNone;
        BodyKind kind{};
        std::uint32_t first = 0, count = 0; // of its corners, in the world
        float radius = 0.0f;
        Patch patch; // the corners of cells that it may be near
    };
    void look(const World& world, const Grid& grid);
    bool same(std::size_t now, std::size_t before) const;
    void draw(const Grid& grid, const Patch& patch, InstructionSet set);
    void find_gas(const Grid& grid);
    void find_walls(const World& world, const Grid& grid, const Pressure& pressure);
    void look_at(const std::vector<Body>& bodies, const Grid& grid, int i, int j);
    std::uint32_t deeper(std::ptrdiff_t a, std::ptrdiff_t b) const;
    static Patch cells_of(const Grid& grid, const Patch& patch);

    std::array<bool, 4> open_{};
    Field distance_, owner_; // at corners of cells; owner: the body's slot + 1, or 0
    Field across_, up_, gas_, room_;
    std::vector<Seen> pieces_, pieces_before_;
    std::vector<Vec2> corners_, corners_before_;
    std::vector<Patch> changed_, faces_; // corners of cells, and the faces between them
    std::vector<std::uint8_t> near_;     // by tile: is a body that moves near?
    std::vector<Wall> walls_across_, walls_up_;
    std::vector<Shore> shores_;
    Pockets pockets_;
    Outline outline_;
    bool fresh_ = true, with_small_ = true;
};

} // namespace evil::fluid
