#include "forces/media.hpp"

namespace evil {
namespace {

struct Box {
    Vec2 low, high;
};

Box box_of(const Area& area) {
    Vec2 r{area.radius, area.radius};
    Box box{area.centre - r, area.centre + r};
    if (area.radius == 0.0f && !area.parts.empty()) box = {area.parts[0][0], area.parts[0][0]};
    for (const auto& part : area.parts)
        for (Vec2 corner : part) box = {min(box.low, corner), max(box.high, corner)};
    return box;
}

// Where a body is, seen from the medium: a medium may be carried by a body.
Pose seen_from(const Force& f, const Bodies& bodies, const Pose& pose) {
    if (f.target == kNone) return pose;
    const Pose& frame = bodies.rows[f.target].pose;
    Rot q = frame.q, p = pose.q;
    return {untransform(frame, pose.p), {q.c * p.c + q.s * p.s, q.c * p.s - q.s * p.c}};
}

Vec2 velocity_of_medium(const Force& f, const Bodies& bodies, Vec2 at) {
    if (f.target == kNone) return f.vector;
    const Body& b = bodies.rows[f.target];
    return velocity_at(b, at) + rotate(b.pose.q, f.vector);
}

template <class Visit> void each_piece(const Shapes& shapes, const Body& b, Visit&& visit) {
    for (std::uint32_t s = b.first_shape; s != kNone; s = shapes.rows[s].next) {
        if (shapes.rows[s].traits.sensor) continue;
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next)
            visit(shapes.pieces[p]);
    }
}

bool near(const Box& box, const Piece& piece, const Pose& pose) {
    Vec2 middle = transform(pose, piece.centre), r{piece.reach, piece.reach}, low = middle - r, high = middle + r;
    return low.x <= box.high.x && box.low.x <= high.x && low.y <= box.high.y && box.low.y <= high.y;
}

// How much of a body is in the medium, and the middle of that, in the world.
struct Wet {
    double area = 0.0, share = 0.0;
    Vec2 middle;
};

Wet wet(const Force& f, const Area& area, const Box& box, const Bodies& bodies, const Shapes& shapes, const Body& b,
        ImmersionScratch& scratch) {
    Pose pose = seen_from(f, bodies, b.pose);
    Immersion in;
    double whole = 0.0;
    bool any = false;
    each_piece(shapes, b, [&](const Piece& piece) { any = any || near(box, piece, pose); });
    if (!any && b.first_shape != kNone && shapes.rows[b.first_shape].kind != ShapeKind::particle) return {};
    each_piece(shapes, b, [&](const Piece& piece) {
        whole += area_of(shapes, piece);
        if (near(box, piece, pose)) in = in + immersion(shapes, piece, pose, area, scratch);
    });
    if (!(whole > 0.0)) // without extent, it is where its centre of mass is
        return {0.0, contains(area, transform(pose, b.local_centre)) ? 1.0 : 0.0, b.centre};
    if (!(in.area > 1e-9 * whole)) return {};
    Vec2 middle = narrow((1.0 / in.area) * in.moment);
    return {in.area, std::min(in.area / whole, 1.0),
            f.target == kNone ? middle : transform(bodies.rows[f.target].pose, middle)};
}

// Drag against the medium's own motion where the body is in it, implicit in the speed that the body will have: so it can
// stop the body in the medium but never turn it back, and a fall ends at the speed at which drag holds the weight.
void push_by_medium(const Force& f, const Bodies& bodies, Body& b, const Wet& in, Vec2 gravity, float dt) {
    auto share = static_cast<float>(in.share);
    Vec2 arm = in.middle - b.centre;
    Vec2 lift = -(f.density * static_cast<float>(in.area)) * gravity; // Archimedes: the weight of what it displaces
    Vec2 coming = dt * (b.gravity_scale * gravity + b.inv_mass * (b.force + lift));
    Vec2 against = velocity_at(b, in.middle) - velocity_of_medium(f, bodies, in.middle);
    float rate = share * b.drag * (f.linear + f.quadratic * length(against)); // N s/m
    float yields = b.inv_mass + b.inv_inertia * length_squared(arm);          // at the end of the arm, at most
    Vec2 force = lift - rate / (1.0f + dt * rate * yields) * (against + coming);
    float turning = rate * b.inertia * b.inv_mass; // as if its mass sat at its radius of gyration, r^2 = I / m
    float spin = b.spin - (f.target == kNone ? 0.0f : bodies.rows[f.target].spin);
    b.force = clamped(b.force + force, kMaxForce);
    b.torque =
        clamped(b.torque + cross(arm, force) - turning / (1.0f + dt * turning * b.inv_inertia) * spin, kMaxForce);
}

template <class Visit> void each_body(const Force& f, Bodies& bodies, Visit&& visit) {
    auto see = [&](std::uint32_t slot) {
        if (bodies.slots.taken(slot) && bodies.rows[slot].kind == BodyKind::dynamic && slot != f.target)
            visit(bodies.rows[slot]);
    };
    if (f.everywhere)
        for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) see(slot);
    else
        for (std::uint32_t slot : f.bodies) see(slot);
}

template <class Visit> void each_medium(const Forces& forces, Visit&& visit) {
    for (std::uint32_t i = 0; forces.slots.count() > 0 && i < forces.slots.size(); ++i)
        if (forces.slots.taken(i) && forces.rows[i].kind == ForceKind::medium) visit(forces.rows[i], forces.areas[i]);
}

bool carried_along(const Force& f, const Bodies& bodies) {
    if (f.target == kNone) return false;
    const Body& b = bodies.rows[f.target];
    return moves(b) && b.awake && (b.velocity != Vec2{} || b.spin != 0.0f);
}

} // namespace

void stir_media(const Forces& forces, Bodies& bodies, const Shapes& shapes) {
    each_medium(forces, [&](const Force& f, const Area& area) {
        if (!carried_along(f, bodies)) return;
        Box box = box_of(area);
        each_body(f, bodies, [&](Body& b) {
            if (b.awake) return;
            Pose pose = seen_from(f, bodies, b.pose);
            each_piece(shapes, b, [&](const Piece& piece) {
                if (near(box, piece, pose)) b.awake = true, b.still_time = 0.0f;
            });
        });
    });
}

void apply_media(const Forces& forces, Bodies& bodies, const Shapes& shapes, Vec2 gravity, float dt,
                 MediaScratch& scratch) {
    each_medium(forces, [&](const Force& f, const Area& area) {
        Box box = box_of(area);
        each_body(f, bodies, [&](Body& b) {
            if (!b.awake) return;
            Wet in = wet(f, area, box, bodies, shapes, b, scratch.pieces);
            if (in.share > 0.0) push_by_medium(f, bodies, b, in, gravity, dt);
        });
    });
}

} // namespace evil
