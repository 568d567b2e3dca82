#pragma once
// Water and other liquids (SPEC F5, F7): particles in a box of cells. The particles carry mass and velocity (APIC: Jiang,
// Schroeder, Selle, Teran and Stomakhin 2015); each step the cells find the pressure that keeps their room, bodies
// included (Batty, Bertails and Bridson 2007).
#include "fluid/smoke.hpp"

namespace evil::fluid {

inline constexpr std::size_t kMostParticles = std::size_t{1} << 22; // in one water
inline constexpr std::size_t kMostLiquids = 16;                     // kinds in one water
inline constexpr float kCellsOfParticle = 2.0f;                     // a cell's side in particles: about four lie in one
inline constexpr float kMostSwim = 1e4f;                            // m/s of a particle

struct Liquid {
    float density = 1.0f;         // kg/m2, as shapes have it
    float viscosity = 0.0f;       // m2/s
    float surface_tension = 0.0f; // N/m
    Colour colour{0.25f, 0.55f, 0.85f};
    std::uint64_t serial = 0;
};

// What Python sees of the particles; whoever looks keeps it alive. The first `Water::count` of each are in use.
struct Particles {
    explicit Particles(std::size_t room)
        : positions(2 * room), velocities(2 * room), affine(4 * room), liquid(room), capacity(room) {}
    std::vector<float> positions;     // metres: x, y
    std::vector<float> velocities;    // m/s: x, y
    std::vector<float> affine;        // 1/s, how velocity changes round it: du/dx, du/dy, dv/dx, dv/dy
    std::vector<std::uint8_t> liquid; // which one of Water::liquids
    std::size_t capacity = 0;
    bool lent = false; // may have been written
};

struct Stream { // pours liquid, or drains it
    std::uint32_t water = kNone;
    std::uint32_t body = kNone; // that carries it
    Area area;                  // in its frame, or the world's
    float rate = 0.0f;          // m2 a second; negative: it drains
    Vec2 velocity;              // of the body's frame, beside the body's own
    std::uint32_t liquid = 0;
    float due = 0.0f;         // particles that a step was too short for
    std::uint64_t poured = 0; // spots that it has tried
    bool running = true;
    std::uint64_t serial = 0, born = 0;
};

// A body that the liquid touched in the last step, and what it was to do after it: what joints and contacts kept it from
// says how free it is.
struct Afloat {
    std::uint32_t body = kNone;
    std::uint64_t serial = 0;
    Vec2 velocity, gained; // m/s that it was to have, and how much of that it was to gain
    float spin = 0.0f, gained_spin = 0.0f;
    Vec2 force; // of the liquid
    float torque = 0.0f;
};

struct WaterScratch;

struct Water {
    Water();
    ~Water();

    // State
    Grid grid;
    float particle_size = 0.1f; // metres: a particle stands for a square of that side
    std::array<bool, 4> open{}; // sides that liquid may leave by
    std::shared_ptr<Particles> particles;
    std::size_t count = 0; // of particles
    std::vector<Liquid> liquids;
    Field pressure;             // of the last step, where the next begins to look; 0 where there is no liquid
    std::vector<Afloat> afloat; // by body slot
    std::uint64_t serial = 0, born = 0;

    std::unique_ptr<WaterScratch> scratch;
};

// A new one, empty; its numbers were checked.
std::unique_ptr<Water> make_water(const Grid& grid, float particle_size);
WaterRef add_water(World& world, std::unique_ptr<Water> water);
void destroy_water(World& world, std::uint32_t water);

float heaviest(const Water& water); // density of its liquids

// Room for so many particles in all; false: that is more than one water holds.
[[nodiscard]] bool make_room(Water& water, std::size_t count);

// Particles on a lattice wherever the area is, no body is and no particle is yet; returns how many came.
std::size_t fill(World& world, Water& water, const Area& area, std::uint32_t liquid, Vec2 velocity);

void step_waters(World& world, float dt);

} // namespace evil::fluid
