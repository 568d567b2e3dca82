// The solver's inner loop. Relative velocity is projected onto normal and tangent once for a block and kept there while
// the points push; the sum of impulses is applied once. So the two points of a contact still see each other's work.
#include "solver/contacts_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr float kPushSpeed = 3.0f;    // m/s: the fastest that overlap is pushed out; more, and piles burst apart
constexpr float kMostImpulse = 1e30f; // newton seconds: finite, whatever came in

struct Body {
    Floats vx, vy, spin, inv_mass, moved_x, moved_y, sine, inv_inertia;
};
static_assert(sizeof(Body) == 8 * sizeof(Floats));

struct Ends { // the two bodies of eight contacts
    Body a, b;
};

EVIL_INLINE Body load_bodies(const SolverBody* bodies, const std::uint32_t* rows) {
    Floats field[8];
    load_rows(&bodies->vx, rows, field);
    return {field[0], field[1], field[2], field[3], field[4], field[5], field[6], field[7]};
}

EVIL_INLINE void store_bodies(SolverBody* bodies, const std::uint32_t* rows, const Body& body) {
    Floats field[4] = {body.vx, body.vy, body.spin, body.inv_mass};
    store_half_rows(&bodies->vx, rows, field);
}

EVIL_INLINE void apply(Ends& e, Floats nx, Floats ny, Floats along_n, Floats along_t) { // t = (ny, -nx); (4.9)
    Floats px = along_n * nx + along_t * ny, py = along_n * ny - along_t * nx;
    e.a.vx -= e.a.inv_mass * px;
    e.a.vy -= e.a.inv_mass * py;
    e.b.vx += e.b.inv_mass * px;
    e.b.vy += e.b.inv_mass * py;
}

// Relative velocity along n and t, and what a unit impulse changes of it, by the bodies' masses.
struct Relative {
    Floats n, t, inv_mass;
};

EVIL_INLINE Relative relative(const Ends& e, Floats nx, Floats ny) {
    Floats x = e.b.vx - e.a.vx, y = e.b.vy - e.a.vy;
    return {x * nx + y * ny, x * ny - y * nx, e.a.inv_mass + e.b.inv_mass};
}

EVIL_INLINE Floats cosine(Floats sine) { return sqrt(max(Floats(1.0f) - sine * sine, Floats(0.0f))); }

struct Turned { // how far the arms have moved along the normal since the step began
    Floats moved, cos_a, cos_b;
};

EVIL_INLINE Turned turned(const Ends& e, Floats nx, Floats ny) {
    Floats moved = (e.b.moved_x - e.a.moved_x) * nx + (e.b.moved_y - e.a.moved_y) * ny;
    return {moved, cosine(e.a.sine), cosine(e.b.sine)};
}

EVIL_INLINE Floats separation(const BlockPoint& p, const Turned& t, const Ends& e) {
    Floats b = t.cos_b * load(p.arm_bn) + e.b.sine * load(p.arm_bt);
    Floats a = t.cos_a * load(p.arm_an) + e.a.sine * load(p.arm_at);
    return load(p.base) + t.moved + (b - a);
}

// (4.8) with e = 0: a soft push while they overlap, and in advance of touching only what would make them overlap.
template <bool soft>
EVIL_INLINE Floats push_normal(BlockPoint& p, const ContactBlock& k, const Turned& t, Relative& v, Ends& e,
                               Floats inv_h) {
    Floats zero = 0.0f, at_a = load(p.arm_at), at_b = load(p.arm_bt), before = load(p.normal_impulse);
    Floats gap = separation(p, t, e), bias = max(gap, zero) * inv_h, mass = load(p.normal_mass), leak = zero;
    if (soft) {
        Mask apart = gap > zero;
        bias = select(apart, bias, max(Floats(k.bias_rate) * gap, Floats(-kPushSpeed)));
        mass = select(apart, mass, mass * Floats(k.mass_scale));
        leak = select(apart, zero, Floats(k.impulse_scale));
    }
    Floats speed = v.n + e.b.spin * at_b - e.a.spin * at_a;
    Floats after = min(max(before - mass * (speed + bias) - leak * before, zero), Floats(kMostImpulse));
    Floats impulse = after - before;
    store(p.normal_impulse, after);
    v.n += v.inv_mass * impulse;
    e.a.spin -= e.a.inv_inertia * impulse * at_a; // (4.10)
    e.b.spin += e.b.inv_inertia * impulse * at_b;
    return impulse;
}

// Friction within Coulomb's cone, at rest and sliding (SPEC C5).
EVIL_INLINE Floats push_tangent(BlockPoint& p, Floats friction, Floats surface_speed, Relative& v, Ends& e) {
    Floats an = load(p.arm_an), bn = load(p.arm_bn), before = load(p.tangent_impulse);
    Floats speed = v.t - e.b.spin * bn + e.a.spin * an - surface_speed;
    Floats most = friction * load(p.normal_impulse);
    Floats after = clamp(before - load(p.tangent_mass) * speed, -most, most);
    Floats impulse = after - before;
    store(p.tangent_impulse, after);
    v.t += v.inv_mass * impulse;
    e.a.spin += e.a.inv_inertia * impulse * an;
    e.b.spin -= e.b.inv_inertia * impulse * bn;
    return impulse;
}

template <bool soft> EVIL_INLINE void solve(SolverBody* bodies, ContactBlock& k, Floats inv_h) {
    Ends e{load_bodies(bodies, k.a), load_bodies(bodies, k.b)};
    Floats nx = load(k.nx), ny = load(k.ny), friction = load(k.friction), belt = load(k.surface_speed);
    Relative v = relative(e, nx, ny);
    Turned t = turned(e, nx, ny);
    Floats along_n = push_normal<soft>(k.points[0], k, t, v, e, inv_h);
    along_n += push_normal<soft>(k.points[1], k, t, v, e, inv_h);
    Floats along_t = push_tangent(k.points[0], friction, belt, v, e);
    along_t += push_tangent(k.points[1], friction, belt, v, e);
    apply(e, nx, ny, along_n, along_t);
    store_bodies(bodies, k.a, e.a);
    store_bodies(bodies, k.b, e.b);
}

EVIL_INLINE void add_up(BlockPoint& p) { store(p.total_impulse, load(p.total_impulse) + load(p.normal_impulse)); }

EVIL_INLINE void warm_point(const BlockPoint& p, Ends& e, Floats& along_n, Floats& along_t) {
    Floats n = load(p.normal_impulse), t = load(p.tangent_impulse);
    along_n += n;
    along_t += t;
    e.a.spin -= e.a.inv_inertia * (n * load(p.arm_at) - t * load(p.arm_an));
    e.b.spin += e.b.inv_inertia * (n * load(p.arm_bt) - t * load(p.arm_bn));
}

} // namespace

void warm_start(SolverBody* bodies, const ContactBlock* blocks, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        const ContactBlock& k = blocks[i];
        Ends e{load_bodies(bodies, k.a), load_bodies(bodies, k.b)};
        Floats along_n = 0.0f, along_t = 0.0f;
        warm_point(k.points[0], e, along_n, along_t);
        warm_point(k.points[1], e, along_n, along_t);
        apply(e, load(k.nx), load(k.ny), along_n, along_t);
        store_bodies(bodies, k.a, e.a);
        store_bodies(bodies, k.b, e.b);
    }
}

void push_apart(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept {
    for (std::size_t i = 0; i < count; ++i) solve<true>(bodies, blocks[i], inv_h);
}

void relax(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        solve<false>(bodies, blocks[i], inv_h);
        add_up(blocks[i].points[0]);
        add_up(blocks[i].points[1]);
    }
}

} // namespace evil::EVIL_ISA
