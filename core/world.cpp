#include "world.hpp"

namespace evil {

void World::step(float dt, int substeps) {
    Threads::Shift shift(threads);
    std::swap(previous, present); // publish_all fills the latter anew
    move_characters(*this, dt);
    place_pieces(placed, shapes, bodies, dt, instruction_set, threads);
    // approximate: whose bounds meet
    bool changed = find_pairs(broad, placed, contacts.scratch.pairs, instruction_set, threads);
    match_pairs(contacts, shapes, joints, changed);
    update_manifolds(contacts, placed, shapes, bodies, dt, instruction_set, threads); // exact: SAT, contact points
    drop_ghosts(seams, contacts, shapes, bodies);
    stir_media(forces, bodies, shapes);
    step_fluids(*this, dt); // gas round the bodies and their push on each other
    wake_islands(solver, bodies, contacts, joints, forces);
    find_buried(buried, contacts, bodies);
    apply_media(forces, bodies, shapes, gravity, dt, media);
    solve(solver, bodies, contacts, joints, forces, gravity, {dt, substeps, instruction_set, events.hit_speed},
          threads);
    calm_buried(buried, bodies);
    stop_in_time(continuous, solver.paths, placed, bodies, shapes, joints);
    break_joints(*this);
    bool slept = sleep_islands(solver, bodies, contacts, joints, forces, shapes, dt, sleep_allowed, threads);
    find_events(events, contacts, shapes, bodies, slept);
    ++steps;
    time += double(dt);
    search.moved = true;
    publish_all(*this);
}

Scene World::scene() {
    refresh(search, shapes, bodies);
    return {shapes, bodies, search, instruction_set};
}

Affine body_matrix(const Body& body) {
    return compose(affine(body.pose), Affine{body.scale.x, 0, 0, body.scale.y, 0, 0});
}

namespace {

// Straight into the arrays, number by number: a matrix made first and then copied would wait for its own numbers.
void publish_row(World& world, std::uint32_t slot) {
    const Body& b = world.bodies.rows[slot];
    world.present[slot] = b.pose;
    world.scales[slot] = b.scale;
    Arrays& out = *world.arrays;
    bool taken = world.bodies.slots.taken(slot);
    Pose pose = taken ? b.pose : Pose{};
    Vec2 scale = taken ? b.scale : Vec2{1, 1}, velocity = taken ? b.velocity : Vec2{};
    float* position = &out.positions[2 * slot];
    position[0] = pose.p.x;
    position[1] = pose.p.y;
    float* speed = &out.velocities[2 * slot];
    speed[0] = velocity.x;
    speed[1] = velocity.y;
    out.angles[slot] = taken ? static_cast<float>(b.angle) : 0.0f;
    float* m = &out.matrices[16 * std::size_t{slot}]; // the zeros of all of them lie there already
    m[0] = scale.x * pose.q.c;
    m[1] = scale.x * pose.q.s;
    m[4] = 0.0f - scale.y * pose.q.s; // not -0
    m[5] = scale.y * pose.q.c;
    m[10] = m[15] = 1.0f;
    m[12] = pose.p.x;
    m[13] = pose.p.y;
}

} // namespace

void publish(World& world, std::uint32_t slot) {
    note_edit(world.search, slot);
    publish_row(world, slot);
}

void publish_all(World& world) {
    parallel_for(world.threads, world.bodies.slots.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t slot = first; slot < last; ++slot) publish_row(world, static_cast<std::uint32_t>(slot));
    });
}

} // namespace evil
