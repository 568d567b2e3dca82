#include "solver/islands.hpp"
#include "solver/solver.hpp"
#include <atomic>

namespace evil {
namespace {

constexpr float kSleepSpeed = 0.05f;       // m/s of a body's fastest point; more, and slow things freeze in the air
constexpr float kTimeToSleep = 0.5f;       // seconds of stillness of a whole island
constexpr std::size_t kBodiesAtOnce = 512; // a chunk for threads

// Union-find with path halving; the lower slot is the root, so the result does not depend on the order of contacts.
std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t slot) {
    while (parent[slot] != slot) slot = parent[slot] = parent[parent[slot]];
    return slot;
}
void unite(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
    a = root(parent, a);
    b = root(parent, b);
    if (a != b) parent[std::max(a, b)] = std::min(a, b);
}

bool dynamic(const Bodies& bodies, std::uint32_t slot) { return bodies.rows[slot].kind == BodyKind::dynamic; }

bool stirs(const Body& b) { // a moving platform wakes what it touches
    return b.kind == BodyKind::kinematic && (length_squared(b.velocity) > 0.0f || b.spin != 0.0f);
}

bool anyone_sleeps(const Bodies& bodies) {
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
        if (bodies.slots.taken(slot) && dynamic(bodies, slot) && !bodies.rows[slot].awake) return true;
    return false;
}

float reach_of(const Body& b, const Shapes& shapes) {
    float reach = 0.0f;
    for (std::uint32_t s = b.first_shape; s != kNone; s = shapes.rows[s].next)
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next)
            reach = std::max(reach, length(shapes.pieces[p].centre - b.local_centre) + shapes.pieces[p].reach);
    return reach;
}

float fastest_point(Body& b, const Shapes& shapes) {
    if (b.reach == kUnknown) b.reach = reach_of(b, shapes);
    return length(b.velocity) + std::abs(b.spin) * b.reach;
}

struct Stillness {
    bool untold;      // does anyone sleep of whom the contrary was told last, or the other way round?
    bool long_enough; // has anyone been still for long enough to fall asleep?
};

Stillness count_still_time(Bodies& bodies, const Shapes& shapes, float dt, Threads& threads) {
    std::atomic<bool> any_untold = false, any_tired = false;
    parallel_for(threads, bodies.slots.size(), kBodiesAtOnce, [&](std::size_t first, std::size_t last) {
        bool untold = false, tired = false;
        for (auto slot = static_cast<std::uint32_t>(first); slot < last; ++slot) {
            Body& b = bodies.rows[slot];
            untold |= b.awake != b.told_awake;
            if (!bodies.slots.taken(slot) || !dynamic(bodies, slot) || !b.awake) continue;
            b.still_time = fastest_point(b, shapes) < kSleepSpeed ? std::min(b.still_time + dt, 1e3f) : 0.0f;
            tired |= b.still_time >= kTimeToSleep;
        }
        if (untold) any_untold.store(true, std::memory_order_relaxed);
        if (tired) any_tired.store(true, std::memory_order_relaxed);
    });
    return {any_untold.load(), any_tired.load()};
}

} // namespace

void find_islands(std::vector<std::uint32_t>& island, const Bodies& bodies, const Contacts& contacts,
                  const Joints& joints, const Forces& forces) {
    island.resize(bodies.slots.size());
    for (std::uint32_t slot = 0; slot < island.size(); ++slot) island[slot] = slot;
    for (const Contact& c : contacts.rows)
        if (c.count > 0 && dynamic(bodies, c.body_a) && dynamic(bodies, c.body_b)) unite(island, c.body_a, c.body_b);
    for (std::uint32_t i = 0; i < joints.slots.size(); ++i) {
        if (!joints.slots.taken(i)) continue;
        const Joint& j = joints.rows[i];
        if (dynamic(bodies, j.body_a) && dynamic(bodies, j.body_b)) unite(island, j.body_a, j.body_b);
    }
    for (std::uint32_t i = 0; i < forces.slots.size(); ++i) {
        if (!forces.slots.taken(i) || forces.rows[i].target == kNone || !dynamic(bodies, forces.rows[i].target))
            continue;
        for (std::uint32_t slot : forces.rows[i].bodies)
            if (dynamic(bodies, slot)) unite(island, forces.rows[i].target, slot);
    }
    for (std::uint32_t slot = 0; slot < island.size(); ++slot) island[slot] = root(island, slot);
}

void wake_islands(Solver& solver, Bodies& bodies, const Contacts& contacts, const Joints& joints,
                  const Forces& forces) {
    solver.islands_known = false;
    if (!anyone_sleeps(bodies)) return; // nobody to wake: whoever may fall asleep looks for the islands then
    find_islands(solver.island_of, bodies, contacts, joints, forces);
    solver.islands_known = true;
    solver.island_awake.assign(bodies.slots.size(), 0);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
        if (bodies.slots.taken(slot) && dynamic(bodies, slot) && bodies.rows[slot].awake)
            solver.island_awake[solver.island_of[slot]] = 1;
    for (const Contact& c : contacts.rows) {
        if (c.count == 0) continue;
        bool belt = c.surface_speed != 0.0f;
        if (belt || stirs(bodies.rows[c.body_a])) solver.island_awake[solver.island_of[c.body_b]] = 1;
        if (belt || stirs(bodies.rows[c.body_b])) solver.island_awake[solver.island_of[c.body_a]] = 1;
    }
    for (std::uint32_t i = 0; i < joints.slots.size(); ++i) {
        if (!joints.slots.taken(i)) continue;
        const Joint& j = joints.rows[i];
        if (stirs(bodies.rows[j.body_a])) solver.island_awake[solver.island_of[j.body_b]] = 1;
        if (stirs(bodies.rows[j.body_b])) solver.island_awake[solver.island_of[j.body_a]] = 1;
    }
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& b = bodies.rows[slot];
        if (!bodies.slots.taken(slot) || b.awake || !dynamic(bodies, slot)) continue;
        if (!solver.island_awake[solver.island_of[slot]]) continue;
        b.awake = true;
        b.still_time = 0.0f;
    }
}

bool sleep_islands(Solver& solver, Bodies& bodies, const Contacts& contacts, const Joints& joints, const Forces& forces,
                   const Shapes& shapes, float dt, bool allowed, Threads& threads) {
    Stillness stillness = count_still_time(bodies, shapes, dt, threads);
    if (!allowed || !stillness.long_enough) return stillness.untold;
    if (!solver.islands_known) find_islands(solver.island_of, bodies, contacts, joints, forces);
    solver.island_still.assign(bodies.slots.size(), 1e30f);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const Body& b = bodies.rows[slot];
        if (!bodies.slots.taken(slot) || !dynamic(bodies, slot) || !b.awake) continue;
        float& shortest = solver.island_still[solver.island_of[slot]];
        shortest = std::min(shortest, b.still_time);
    }
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& b = bodies.rows[slot];
        if (!bodies.slots.taken(slot) || !dynamic(bodies, slot) || !b.awake) continue;
        if (solver.island_still[solver.island_of[slot]] < kTimeToSleep) continue;
        b.awake = false;
        b.velocity = {};
        b.spin = 0.0f;
    }
    return true;
}

} // namespace evil
