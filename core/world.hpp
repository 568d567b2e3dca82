#pragma once
// One World: the State of every module side by side (SPEC A3), and the step that moves it.
#include "character/character.hpp"
#include "collider/broad_phase.hpp"
#include "collider/contacts.hpp"
#include "collider/continuous.hpp"
#include "collider/events.hpp"
#include "collider/seams.hpp"
#include "collider/search.hpp"
#include "door.hpp"
#include "fluid/fluids.hpp"
#include "forces/media.hpp"
#include "published.hpp"
#include "solver/buried.hpp"
#include "solver/joints/joint.hpp"
#include "solver/solver.hpp"
#include "threads.hpp"
#include <memory>
#include <optional>
#include <string>

namespace evil {

inline constexpr float kMaxStep = 1.0f; // seconds; a longer step is a mistake in units
inline constexpr int kMaxSubsteps = 256;

// Slot-indexed arrays for readers outside: refreshed after each step. Growing makes a new one, and whoever looks at the
// old one keeps it alive.
struct Arrays {
    explicit Arrays(std::size_t n) : capacity(n), positions(2 * n), angles(n), velocities(2 * n), matrices(16 * n) {}
    std::size_t capacity;
    std::vector<float> positions, angles, velocities, matrices;
};

struct World {
    // State: what a snapshot holds
    Vec2 gravity{0.0f, -9.81f};
    bool sleep_allowed = true;
    std::uint64_t steps = 0;
    double time = 0.0; // seconds simulated
    Bodies bodies;
    Shapes shapes;
    Contacts contacts;
    Events events;
    Forces forces;
    Joints joints;
    Characters characters;
    Fluids fluids;

    // Which kernels it runs on; the bits are the same with any
    InstructionSet instruction_set = best_instruction_set();

    // Who works on it; the bits are the same with any number
    Threads threads;

    // Who may look: one thread at a time, for the binding to keep
    mutable Door door;

    // Scratch: losing it changes nothing
    Placements placed;
    BroadPhase broad;
    Seams seams;
    Continuous continuous;
    MediaScratch media;
    Weighed weighed;
    Solver solver;
    Buried buried;
    Search search;

    // Results: what readers see
    std::vector<Pose> previous, present;
    std::vector<Vec2> scales;
    std::shared_ptr<Arrays> arrays = std::make_shared<Arrays>(0);

    void step(float dt, int substeps);
    Scene scene(); // for queries, up to date
    Poses poses() const { return {previous, present, scales, bodies.slots.generations()}; }
};

// Adding and removing. Arguments are checked at the door; what only shows when it is done comes back as a problem.
enum class MassProblem { none, too_small, too_large };
struct NewShape {
    Shape shape;
    OwnedRings rings;
    std::vector<Part> parts;
};
template <class Reference> struct Added {
    Reference ref;
    MassProblem problem = MassProblem::none; // not none: nothing was added
};
Added<BodyRef> add_body(World& world, const Body& body, const std::string& tag, std::span<const NewShape> shapes,
                        const Traits& traits = {});
void destroy_body(World& world, std::uint32_t body);
void take_back(World& world, std::uint32_t body); // the one added last: as if it had never been tried
Added<ShapeRef> add_shape(World& world, std::uint32_t body, const NewShape& shape);
void destroy_shape(World& world, std::uint32_t shape);

ForceRef add_force(World& world, Force force, Area area);
void set_area(World& world, std::uint32_t force, Area area);
void attach(World& world, std::uint32_t force, std::uint32_t body);
void detach(World& world, std::uint32_t force, std::uint32_t body);
void destroy_force(World& world, std::uint32_t force);

JointRef add_joint(World& world, Joint joint);
void destroy_joint(World& world, std::uint32_t joint);
void drop_joints_of(World& world, std::uint32_t body);
void break_joints(World& world); // those that the last step pulled too hard

// Changing by hand.
void wake(World& world, std::uint32_t body);
void wake_all(World& world);
void allow_sleep(World& world, bool allowed);
void wake_touching(World& world, std::uint32_t body); // and what rests on it
void set_traits(World& world, std::uint32_t shape, const Traits& traits);
void move_body(World& world, std::uint32_t body, Vec2 position, double angle);
void set_kind(World& world, std::uint32_t body, BodyKind kind);
void set_gravity(World& world, Vec2 gravity);
[[nodiscard]] MassProblem set_mass(World& world, std::uint32_t body, float mass); // 0: by the shapes' densities
[[nodiscard]] MassProblem set_density(World& world, std::uint32_t shape, float density);

enum class MatrixProblem { none, flat, sheared, squeezes_circle, too_large, mass };
[[nodiscard]] MatrixProblem set_scale(World& world, std::uint32_t body, Vec2 scale);
[[nodiscard]] MatrixProblem apply_to_body(World& world, std::uint32_t body, const Affine& m);
[[nodiscard]] MatrixProblem apply_to_shape(World& world, std::uint32_t shape, const Affine& m);

Affine body_matrix(const Body& body); // position, rotation, scale
void publish(World& world, std::uint32_t body);
void publish_all(World& world);

} // namespace evil
