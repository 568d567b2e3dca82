// Adding, removing and changing by hand. Each function leaves the world consistent, also when it reports a problem.
#include "identity.hpp"

namespace evil {
namespace {

void grow_results(World& world) {
    std::size_t n = world.bodies.slots.size();
    world.previous.resize(n);
    world.present.resize(n);
    world.scales.resize(n, Vec2{1, 1});
    if (n <= world.arrays->capacity) return;
    world.arrays = std::make_shared<Arrays>(std::max<std::size_t>(64, 2 * n));
    publish_all(world);
}

void show_at_once(World& world, std::uint32_t body) { // a body put somewhere by hand does not glide there
    publish(world, body);
    world.previous[body] = world.present[body];
}

// Whoever changes a shape or takes one away weighs the body anew at once; so a body that has grown by one shape since it was
// weighed last has changed in nothing else.
Moments weigh(World& world, std::uint32_t slot) {
    const Body& b = world.bodies.rows[slot];
    Weighed& w = world.weighed;
    bool grown = w.body == slot && w.last_shape != kNone && b.last_shape != kNone &&
                 world.shapes.rows[w.last_shape].next == b.last_shape;
    if (!grown) w.sum = {};
    for (std::uint32_t s = grown ? b.last_shape : b.first_shape; s != kNone; s = world.shapes.rows[s].next) {
        Moments m = moments(world.shapes, s, b.scale);
        w.sum.mass += m.mass;
        w.sum.x += m.x;
        w.sum.y += m.y;
        w.sum.inertia += m.inertia;
    }
    w.body = slot;
    w.last_shape = b.last_shape;
    return w.sum;
}

// Mass, centre and inertia from the shapes, or a problem and no change.
MassProblem update_mass(World& world, std::uint32_t slot) {
    Body& b = world.bodies.rows[slot];
    b.reach = kUnknown;
    const Moments sum = weigh(world, slot);
    auto refuse = [&](MassProblem problem) {
        world.weighed = {}; // what was tried is taken back
        return problem;
    };
    bool bare = b.first_shape == kNone;
    double mass = b.set_mass > 0.0f ? double(b.set_mass) : bare ? (b.mass > 0.0f ? double(b.mass) : 1.0) : sum.mass;
    if (!(mass >= kMinMass) || (!bare && !(sum.mass > 0.0))) return refuse(MassProblem::too_small);
    if (!(mass <= kMaxMass)) return refuse(MassProblem::too_large);
    double cx = bare ? 0.0 : sum.x / sum.mass, cy = bare ? 0.0 : sum.y / sum.mass;
    double about_centre = bare ? 0.0 : sum.inertia - sum.mass * (cx * cx + cy * cy);
    double inertia = bare ? 0.0 : std::max(about_centre, 0.0) * (mass / sum.mass);
    if (!(inertia <= 1e30)) return refuse(MassProblem::too_large);
    if (inertia < 1e-30) inertia = 0.0; // a particle does not turn

    Vec2 old_centre = b.centre;
    bool dynamic = b.kind == BodyKind::dynamic;
    b.mass = static_cast<float>(mass);
    b.inertia = static_cast<float>(inertia);
    b.inv_mass = dynamic ? static_cast<float>(1.0 / mass) : 0.0f;
    b.inv_inertia = dynamic && inertia > 0.0 ? static_cast<float>(1.0 / inertia) : 0.0f;
    b.local_centre = {static_cast<float>(cx), static_cast<float>(cy)};
    place_by_origin(b);
    b.velocity += cross(b.spin, b.centre - old_centre); // the body moves on as it did
    return MassProblem::none;
}

void link_shape(World& world, std::uint32_t body, std::uint32_t shape) {
    Body& b = world.bodies.rows[body];
    (b.last_shape == kNone ? b.first_shape : world.shapes.rows[b.last_shape].next) = shape;
    b.last_shape = shape;
}

void unlink_shape(World& world, std::uint32_t body, std::uint32_t shape) {
    Body& b = world.bodies.rows[body];
    std::uint32_t before = kNone;
    for (std::uint32_t s = b.first_shape; s != shape; s = world.shapes.rows[s].next) before = s;
    (before == kNone ? b.first_shape : world.shapes.rows[before].next) = world.shapes.rows[shape].next;
    if (b.last_shape == shape) b.last_shape = before;
}

// A shape on a body whose mass does not know of it yet.
std::uint32_t attach_shape(World& world, std::uint32_t body, const NewShape& shape) {
    Shape row = shape.shape;
    row.body = body;
    row.traits = world.bodies.traits[body];
    row.born = world.steps;
    row.made = fingerprint(shape);
    std::uint32_t slot = add_shape_row(world.shapes, row, shape.rings, shape.parts);
    link_shape(world, body, slot);
    bake(world.shapes, slot, world.bodies.rows[body].scale);
    note_neighbours(world.shapes, world.bodies.rows[body], slot);
    return slot;
}

void bake_all(World& world, std::uint32_t body) {
    const Body& b = world.bodies.rows[body];
    for (std::uint32_t s = b.first_shape; s != kNone; s = world.shapes.rows[s].next) bake(world.shapes, s, b.scale);
}

// Would the shape, under this scale, still be one that the collider can hold?
MatrixProblem problem_with(const World& world, std::uint32_t shape, const Affine& local, Vec2 scale) {
    constexpr float kMinScale = 1e-4f, kMaxScale = 1e4f;
    Shape changed = world.shapes.rows[shape];
    changed.local = local;
    Affine m = definition_to_body(changed, scale);
    float size = std::max(length({m.a, m.b}), length({m.c, m.d}));
    if (!std::isfinite(size) || size > kMaxScale || !(length({m.tx, m.ty}) <= kWorldEdge))
        return MatrixProblem::too_large;
    if (!(std::abs(determinant(m)) > kMinScale * size * size) || size < kMinScale) return MatrixProblem::flat;
    if (changed.radius > 0.0f && !is_similarity(m)) return MatrixProblem::squeezes_circle;
    return MatrixProblem::none;
}

void drop_from_forces(World& world, std::uint32_t body) {
    for (std::uint32_t f = 0; f < world.forces.slots.size(); ++f) {
        if (!world.forces.slots.taken(f)) continue;
        if (world.forces.rows[f].target == body)
            destroy_force(world, f); // a spring whose other end is gone
        else
            std::erase(world.forces.rows[f].bodies, body);
    }
}

} // namespace

Added<BodyRef> add_body(World& world, const Body& body, const std::string& tag, std::span<const NewShape> shapes,
                        const Traits& traits) {
    Bodies& bodies = world.bodies;
    std::uint32_t slot = bodies.slots.take();
    if (slot >= bodies.rows.size()) {
        bodies.rows.resize(slot + 1);
        bodies.tags.resize(slot + 1);
        bodies.traits.resize(slot + 1);
    }
    Body& b = bodies.rows[slot] = body;
    bodies.tags[slot] = tag;
    bodies.traits[slot] = traits;
    b.serial = bodies.next_serial++;
    b.born = world.steps;
    b.made = fingerprint(body, tag, shapes);
    b.first_shape = b.last_shape = kNone;
    b.mass = b.set_mass > 0.0f ? b.set_mass : 1.0f;
    place_by_origin(b);
    grow_results(world);
    for (const NewShape& shape : shapes) attach_shape(world, slot, shape);
    MassProblem problem = update_mass(world, slot);
    if (problem != MassProblem::none) {
        take_back(world, slot);
        return {{}, problem};
    }
    show_at_once(world, slot);
    return {{slot, bodies.slots.generation(slot)}};
}

void destroy_body(World& world, std::uint32_t slot) {
    wake_touching(world, slot);
    drop_from_forces(world, slot);
    forget_character(world.characters, slot);
    drop_sources_of(world, slot);
    drop_joints_of(world, slot);
    forget_contacts(world.events, world.contacts, world.shapes, world.bodies,
                    [slot](const Contact& c) { return c.body_a == slot || c.body_b == slot; });
    while (world.bodies.rows[slot].first_shape != kNone) {
        std::uint32_t shape = world.bodies.rows[slot].first_shape;
        unlink_shape(world, slot, shape);
        remove_shape_row(world.shapes, shape);
    }
    world.weighed = {};
    world.bodies.slots.release(slot);
    world.bodies.rows[slot] = {};
    world.bodies.tags[slot].clear();
    world.bodies.traits[slot] = {};
    publish(world, slot);
}

void take_back(World& world, std::uint32_t slot) {
    const Body& b = world.bodies.rows[slot];
    std::uint64_t body_serial = b.serial;
    std::uint64_t shape_serial =
        b.first_shape == kNone ? world.shapes.next_serial : world.shapes.rows[b.first_shape].serial;
    destroy_body(world, slot);
    world.bodies.next_serial = body_serial;
    world.shapes.next_serial = shape_serial;
}

Added<ShapeRef> add_shape(World& world, std::uint32_t body, const NewShape& shape) {
    std::uint64_t serial = world.shapes.next_serial;
    std::uint32_t slot = attach_shape(world, body, shape);
    MassProblem problem = update_mass(world, body);
    if (problem != MassProblem::none) {
        unlink_shape(world, body, slot);
        remove_shape_row(world.shapes, slot);
        world.shapes.next_serial = serial;
        return {{}, problem};
    }
    wake_touching(world, body);
    show_at_once(world, body);
    return {{slot, world.shapes.slots.generation(slot)}, problem};
}

void destroy_shape(World& world, std::uint32_t shape) {
    std::uint32_t body = world.shapes.rows[shape].body;
    wake_touching(world, body);
    forget_contacts(world.events, world.contacts, world.shapes, world.bodies,
                    [&](const Contact& c) { return is_of_shape(c, world.shapes, shape); });
    unlink_shape(world, body, shape);
    remove_shape_row(world.shapes, shape);
    (void)update_mass(world, body); // with fewer shapes mass only shrinks; the last shape's mass is kept
    publish(world, body);
}

ForceRef add_force(World& world, Force force, Area area) {
    Forces& forces = world.forces;
    std::uint32_t slot = forces.slots.take();
    if (slot >= forces.rows.size()) {
        forces.rows.resize(slot + 1);
        forces.areas.resize(slot + 1);
    }
    force.serial = forces.next_serial++;
    force.born = world.steps;
    force.made = fingerprint(force, area);
    forces.rows[slot] = std::move(force);
    forces.areas[slot] = std::move(area);
    if (forces.rows[slot].everywhere) wake_all(world);
    return {slot, forces.slots.generation(slot)};
}

void set_area(World& world, std::uint32_t force, Area area) {
    world.forces.areas[force] = std::move(area);
    for (std::uint32_t body : world.forces.rows[force].bodies) wake(world, body);
    if (world.forces.rows[force].everywhere) wake_all(world);
}

void attach(World& world, std::uint32_t force, std::uint32_t body) {
    auto& list = world.forces.rows[force].bodies;
    if (std::ranges::find(list, body) == list.end()) list.push_back(body);
    wake(world, body);
}

void detach(World& world, std::uint32_t force, std::uint32_t body) {
    std::erase(world.forces.rows[force].bodies, body);
    wake(world, body);
}

void destroy_force(World& world, std::uint32_t force) {
    const Force& f = world.forces.rows[force];
    for (std::uint32_t body : f.bodies) wake(world, body);
    if (f.target != kNone) wake(world, f.target);
    if (f.everywhere) wake_all(world);
    world.forces.rows[force] = {};
    world.forces.areas[force] = {};
    world.forces.slots.release(force);
}

void wake(World& world, std::uint32_t body) {
    Body& b = world.bodies.rows[body];
    if (b.kind == BodyKind::dynamic) b.awake = true;
    b.still_time = 0.0f;
}

void wake_all(World& world) {
    for (std::uint32_t b = 0; b < world.bodies.slots.size(); ++b)
        if (world.bodies.slots.taken(b)) wake(world, b);
}

void allow_sleep(World& world, bool allowed) {
    world.sleep_allowed = allowed;
    if (!allowed) wake_all(world);
}

void wake_touching(World& world, std::uint32_t body) {
    wake(world, body);
    for (Contact& c : world.contacts.rows) {
        if (c.body_a != body && c.body_b != body) continue;
        c.look_again();
        if (!c.sensor()) wake(world, c.body_a == body ? c.body_b : c.body_a);
    }
    for_joints_of(world.joints, body, [&](std::uint32_t, std::uint32_t other) { wake(world, other); });
}

void move_body(World& world, std::uint32_t body, Vec2 position, double angle) {
    wake_touching(world, body);
    Body& b = world.bodies.rows[body];
    b.pose.p = position;
    b.angle = angle;
    place_by_origin(b);
    show_at_once(world, body);
}

void set_kind(World& world, std::uint32_t body, BodyKind kind) {
    Body& b = world.bodies.rows[body];
    if (b.kind == kind) return;
    wake_touching(world, body);
    b.kind = kind;
    note_neighbours(world.shapes, b);
    b.awake = true;
    if (kind == BodyKind::fixed) {
        b.velocity = {};
        b.spin = 0.0f;
    }
    (void)update_mass(world, body); // same shapes, same mass: no new problem
    publish(world, body);
}

void set_gravity(World& world, Vec2 gravity) {
    if (gravity == world.gravity) return;
    world.gravity = gravity;
    wake_all(world);
}

MassProblem set_mass(World& world, std::uint32_t body, float mass) {
    Body& b = world.bodies.rows[body];
    float before = b.set_mass;
    b.set_mass = mass;
    MassProblem problem = update_mass(world, body);
    if (problem != MassProblem::none) b.set_mass = before;
    wake(world, body);
    return problem;
}

MassProblem set_density(World& world, std::uint32_t shape, float density) {
    float& value = world.shapes.rows[shape].material.density;
    float before = value;
    value = density;
    MassProblem problem = update_mass(world, world.shapes.rows[shape].body);
    if (problem != MassProblem::none) value = before;
    wake(world, world.shapes.rows[shape].body);
    return problem;
}

MatrixProblem set_scale(World& world, std::uint32_t body, Vec2 scale) {
    Body& b = world.bodies.rows[body];
    for (std::uint32_t s = b.first_shape; s != kNone; s = world.shapes.rows[s].next) {
        MatrixProblem problem = problem_with(world, s, world.shapes.rows[s].local, scale);
        if (problem != MatrixProblem::none) return problem;
    }
    Vec2 before = b.scale;
    b.scale = scale;
    bake_all(world, body);
    MatrixProblem problem = MatrixProblem::none;
    if (update_mass(world, body) != MassProblem::none) {
        b.scale = before;
        bake_all(world, body);
        problem = MatrixProblem::mass;
    }
    wake_touching(world, body);
    publish(world, body);
    return problem;
}

// The product is split into rotation and scale again: m = R S with R the turn of the first axis. What is left over is
// shear, which a body's matrix cannot hold (a shape's can).
MatrixProblem apply_to_body(World& world, std::uint32_t body, const Affine& m) {
    const Body& b = world.bodies.rows[body];
    Affine product = compose(m, body_matrix(b));
    float sx = length({product.a, product.b});
    if (!(sx > 0.0f) || !std::isfinite(sx) || !std::isfinite(determinant(product))) return MatrixProblem::flat;
    Rot q{product.a / sx, product.b / sx};
    Vec2 second = unrotate(q, {product.c, product.d});
    constexpr float kShear = 1e-4f; // what a few float32 matrix products leave
    if (std::abs(second.x) > kShear * std::max(sx, std::abs(second.y))) return MatrixProblem::sheared;
    if (!(length({product.tx, product.ty}) <= kWorldEdge)) return MatrixProblem::too_large;
    double turned = double(atan2(q.s, q.c)) - double(atan2(b.pose.q.s, b.pose.q.c));
    if (turned > kPi) turned -= 2.0 * kPi;
    if (turned < -kPi) turned += 2.0 * kPi;
    // A turn smaller than float32 can tell is none: translations keep the angle's bits.
    double angle = std::abs(turned) < 1e-6 ? b.angle : b.angle + turned;
    Vec2 scale{sx, second.y};
    auto settle = [](float now, float before) {
        return std::abs(now - before) <= 1e-6f * std::abs(before) ? before : now;
    };
    MatrixProblem problem = set_scale(world, body, {settle(scale.x, b.scale.x), settle(scale.y, b.scale.y)});
    if (problem == MatrixProblem::none) move_body(world, body, {product.tx, product.ty}, angle);
    return problem;
}

MatrixProblem apply_to_shape(World& world, std::uint32_t shape, const Affine& m) {
    Shape& row = world.shapes.rows[shape];
    Vec2 scale = world.bodies.rows[row.body].scale;
    Affine before = row.local, after = compose(m, row.local);
    MatrixProblem problem = problem_with(world, shape, after, scale);
    if (problem != MatrixProblem::none) return problem;
    row.local = after;
    bake(world.shapes, shape, scale);
    if (update_mass(world, row.body) != MassProblem::none) {
        row.local = before;
        bake(world.shapes, shape, scale);
        problem = MatrixProblem::mass;
    }
    wake_touching(world, row.body);
    publish(world, row.body);
    return problem;
}

} // namespace evil
