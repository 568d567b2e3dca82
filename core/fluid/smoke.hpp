#pragma once
// Smoke and fire (SPEC F1 to F6): gas in a box of cells. It carries density, heat, fuel and colour; heat lifts it, fuel
// burns, bodies stand in its way.
#include "fluid/fluids.hpp"
#include "fluid/grid.hpp"
#include "forces/forces.hpp"
#include <array>

namespace evil::fluid {

enum class Method : std::uint8_t { staggered, stam }; // stam: as the thesis has it (4.5.3 to 4.5.5), for comparison
enum class Quality : std::uint8_t { fast, high };     // high: advection-reflection, two projections a step
enum Side { kLeft, kRight, kBottom, kTop };

struct Colour {
    float r = 1.0f, g = 1.0f, b = 1.0f; // sRGB, as given
    friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr float kMostDensity = 1e4f; // of a cell: a source in a sealed box may run for ever
inline constexpr float kMostHeat = 1e3f;    // and fire may burn there

// What may be changed while it runs.
struct Gas {
    float viscosity = 0.0f; // m2/s
    float diffusion = 0.0f; // m2/s, of what it carries
    float buoyancy = 1.0f;  // a temperature of 1 rises with so many times the world's gravity
    float vorticity = 0.0f; // how strongly small whirls are kept alive, m/s a cell of a second
    float cooling = 0.0f;   // share of the heat lost a second
    float fade = 0.0f;      // share of the density lost a second
    float burning = 0.0f;   // share of the fuel that burns in a second
    float heat = 0.0f;      // temperature that a unit of fuel gives
    float soot = 0.0f;      // density that a unit of fuel leaves
    float weight = 0.0f;    // kg/m2: how hard it pushes bodies
    Vec2 wind;              // m/s that it is drawn towards
    float wind_pull = 0.0f; // share of the difference a second
};

// One cell, as it lies in memory and as Python sees it.
struct Cell {
    float density = 0.0f, temperature = 0.0f, fuel = 0.0f;
    float open =
        1.0f; // 1 where there is gas, 0 inside a solid: interpolating it along tells how much of a value is real
};
static_assert(sizeof(Cell) == 16);

struct Source {
    std::uint32_t smoke = kNone;
    std::uint32_t body = kNone; // that carries it
    Area area;                  // in its frame, or the world's
    float rate = 0.0f;          // density a second; negative: a sink
    float fuel = 0.0f;          // a second
    float temperature = 0.0f;   // that it heats to
    bool blows = false;         // has it a velocity?
    Vec2 velocity;              // of the body's frame, beside the body's own
    Colour colour;
    bool running = true;
    std::uint64_t serial = 0, born = 0;
};

struct Views { // what Python may look at and write; whoever looks keeps it alive
    explicit Views(std::size_t cells) : content(cells), velocity(2 * cells, 0.0f) {}
    std::vector<Cell> content;
    std::vector<float>
        velocity; // of the middle of each cell, x and y; State with Stam's method, else made from the faces
    std::vector<float> colour; // r, g, b and nothing, times density; empty while all of it is of one colour
    bool lent = false;         // may have been written
};

struct Scratch;

struct Smoke {
    Smoke();
    ~Smoke();

    // State
    Grid grid;
    Method method = Method::staggered;
    Quality quality = Quality::fast;
    std::array<bool, 4> open{};         // sides that gas may leave and enter by
    std::array<float, 4> side_speeds{}; // m/s at which a closed side slides along itself, to the right or up
    bool stick = true;                  // does gas that has a viscosity stick to closed sides?
    Gas gas;
    Colour colour; // of all of it, until a source brings another
    Field u, v;    // m/s, on faces
    Field pressure, half_pressure;
    std::shared_ptr<Views> views;
    std::uint64_t serial = 0, born = 0;

    std::unique_ptr<Scratch> scratch;
};

// A new one, at rest; its numbers were checked.
SmokeRef add_smoke(World& world, std::unique_ptr<Smoke> smoke);
std::unique_ptr<Smoke> make_smoke(const Grid& grid, Method method);
void destroy_smoke(World& world, std::uint32_t smoke);
SourceRef add_source(World& world, Source source);
void destroy_source(World& world, std::uint32_t source);
void paint(Smoke& smoke); // from now on, each of its cells has a colour of its own

} // namespace evil::fluid
