#pragma once
// What a water needs within a step, and would find again if it were lost.
#include "fluid/solids.hpp"
#include "fluid/water/cells_wide.hpp"
#include "fluid/water/press.hpp"
#include "fluid/water/water.hpp"

namespace evil::fluid {

inline constexpr float kRound = 6.2f;    // area by the square of the radius of gyration: 2 pi of a disc, 6 of a square
inline constexpr float kMostPush = 1e4f; // m/s2 of a body: a squeezed pocket may press without bounds

// Particles in the order of their cells, in cells and m/s; arrays have room for eight more.
struct Swarm {
    std::vector<float> x, y, u, v;
    std::array<std::vector<float>, 4> affine; // m/s a cell: du/dx, du/dy, dv/dx, dv/dy
    std::vector<float> mass;                  // of its liquid, as a share of the heaviest's
    std::vector<std::uint8_t> liquid;
    std::vector<std::int32_t> cell; // of each particle as it came
    std::vector<Vec2> place;        // the same, in cells
    std::size_t count = 0;
    float fastest = 0.0f; // m/s along an axis
};

// A body's outline as cells see it: closed, so that what no open cell sees is the negative of the sum of what they do.
struct Loop {
    Vec2 seen;                // sum of closed shares of faces, by direction
    Vec2 right_up, left_down; // sums of the directions in which others touch it
    bool in_water = false;
    Vec2 lift; // N, and Nm: of films, beside the pressure of the liquid that they come from
    float turn = 0.0f;
    Patch patch; // of the grid's corners
};
struct Touch { // where something is less than a cell from a body
    std::uint32_t body;
    std::int32_t at; // the wet cell nearest to it; negative: there is air
    Vec2 arm, into;  // from the body's centre; the direction into the body
};

struct Film {    // a part of one
    Reach reach; // its cell is the one that liquid comes from
    Vec2 place;
};
struct GapCell {
    std::int32_t at, end; // the wet cell nearest to it
};

// Pairs of numbers on a grid: sums of weight times value, and of weights.
class Pairs {
public:
    void lay_out(const Grid& grid) {
        begin_ = 2 * (grid.stride + kRim);
        values_.assign(static_cast<std::size_t>(2 * (grid.stride * (grid.ny + 3) + 2 * kRim)), 0.0f);
    }
    float* data() { return values_.data() + begin_; } // of (0, 0)

private:
    std::vector<float> values_;
    std::ptrdiff_t begin_ = 0;
};

struct PouringRoom { // of one stream at a time
    std::vector<std::int32_t> first, next;
    std::vector<Vec2> places;
    std::vector<std::uint32_t> gone;
};

struct ThickFace { // in the equation of viscosity
    std::int32_t at, i, j;
    std::int32_t next[4]; // faces beside it, or -1
    float k[4];
    float total, wanted;
};

struct Rub { // of liquid on a body, at a face
    std::uint32_t body;
    std::size_t face; // in the row of them
    float arm, firm;  // speed there that a spin of 1 makes; how firmly
};
struct Drag { // of a body by what rubs on it, within the step: how its velocity changes
    float x = 0.0f, y = 0.0f, spin = 0.0f;
};

struct ThickScratch {
    std::vector<std::int32_t> numbers; // of faces
    std::vector<ThickFace> faces;
    std::vector<float> x, r, s, q;
    std::vector<Rub> rubs;
    std::vector<Drag> drags; // by body
};

struct WaterScratch {
    PouringRoom pouring;
    bool laid_out = false;
    Solids solids;
    std::vector<std::uint8_t> near; // by tile: may a body be nearer than a cell?
    Field volume;                   // share of each cell that no body takes
    Field per_room;                 // 1 / particles that a cell sees at rest; 0 in a solid
    Swarm swarm;

    // Tiles of eight cells that hold particles; with all round them; with liquid.
    std::vector<std::uint8_t> marked; // by tile, with a row more at either end
    std::vector<Tile> occupied, active, active_before, wet_tiles;
    std::vector<std::uint8_t> any_wet; // of the active tiles
    std::vector<std::uint32_t> first;  // of each cell's particles in the swarm

    Pairs gathered_u, gathered_v, gathered;
    Field u, v;                          // m/s on faces
    Field shift_u, shift_v;              // cells on faces: what keeps the volume
    Field rho;                           // how full cells are of particles, 1 at rest; 2 in a solid
    Field wet;                           // 1 in cells with liquid
    Field mass;                          // of what is in a cell, as a share of the heaviest liquid's
    Field skin;                          // pressure that the surface has by its tension; 0 without
    Field inflow;                        // of cells, and what else pressure shall bring about
    Field spread;                        // the pressure that moves particles apart
    std::vector<std::uint8_t> live;      // by tile, while gaps are looked for: is it active?
    std::vector<std::uint32_t> met;      // by cell: in which gap's turn
    std::vector<std::int32_t> met_cells; // all of those
    std::vector<GapCell> gap, found;     // of one gap
    std::vector<std::int32_t> dried;     // cells
    std::vector<std::int32_t> film_cells;
    Press press;
    ThickScratch thick;
    Field viscosity, tension; // of what is in cells; empty until there is any
    bool has_skin = false;
    std::vector<Reach> reaches, unsorted_reaches;
    std::vector<Film> films;
    std::vector<Rider> riders;
    std::vector<std::uint32_t> reaches_of; // by body
    std::vector<Afloat> afloat;
    std::vector<Loop> loops;           // by body
    std::vector<Touch> touches;        // of those that are wet
    int rounds = 0, spread_rounds = 0; // that the pressures took
    CellsView view(const Water& water);
};

void lay_out(Water& water);

// banks.cpp: where bodies are now, and what that leaves of cells.
void update_banks(const World& world, Water& water);
struct Bank {
    float distance; // cells to the nearest body, negative inside one, by what stands at the corners of the cell
    Vec2 away;      // the way out
    std::uint32_t body;
};
Bank bank_at(const Water& water, float x, float y); // in cells
// From the middle of a cell to a body's surface, in cells; none if another body is nearer.
Vec2 surface_near(const Water& water, int i, int j, std::uint32_t body);

// swarm.cpp: particles to the swarm, sorted, and back.
void take_in(const World& world, Water& water);
void give_out(const World& world, Water& water, float dt);

// flow.cpp: from particles to faces and back; what pressure does to them.
void gather_flow(const World& world, Water& water, float dt);
void find_liquid(const World& world, Water& water);
void find_gaps(const World& world, Water& water); // gaps.cpp
void still_films(Water& water); // what flows into them, bodies say: no pressure holds back what falls out of them
void press_flow(World& world, Water& water, float dt);
void scatter_flow(const World& world, Water& water, float dt);

// thick.cpp: viscosity and the surface's tension.
void thicken(World& world, Water& water, float dt);
void stretch_skin(Water& water, float dt); // for one solution
void drop_skin(Water& water);

// riders.cpp: bodies in the pressure's equation.
void find_riders(const World& world, Water& water, float dt);
void push_riders(World& world, Water& water, float dt);
float most_flow(const World& world, const Water& water, float dt); // m/s that the pressure may bring a velocity to
void add_films(const World& world, Water& water, float dt);        // films.cpp

// drift.cpp: bodies that the cells do not see.
void drift_small_bodies(World& world, Water& water, float dt);

} // namespace evil::fluid
