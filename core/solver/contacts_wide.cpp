// The solver's inner loop. Relative velocity is projected onto normal and tangent once for a block and kept there while
// the points push; the sum of impulses is applied once. So the two points of a contact still see each other's work.
#include "solver/contacts_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr float kPushSpeed = 3.0f;    // m/s: the fastest that overlap is pushed out; more, and piles burst apart
constexpr float kMostImpulse = 1e30f; // newton seconds: finite, whatever came in
constexpr float kQuarterTurn = 1.5707964f;

struct Row {
    Floats vx, vy, spin, inv_mass, moved_x, moved_y, turned, inv_inertia;
};

struct Ends { // the two bodies of eight contacts
    Row a, b;
};

EVIL_INLINE Row load_bodies(const SolverBody* bodies, const std::uint32_t* rows) {
    Floats field[8];
    load_rows(&bodies->vx, rows, field);
    return {field[0], field[1], field[2], field[3], field[4], field[5], field[6], field[7]};
}

EVIL_INLINE void store_bodies(SolverBody* bodies, const std::uint32_t* rows, const Row& row) {
    Floats field[4] = {row.vx, row.vy, row.spin, row.inv_mass};
    store_half_rows(&bodies->vx, rows, field);
}

template <bool wall> EVIL_INLINE void store_ends(SolverBody* bodies, const ContactBlock& k, const Ends& e) {
    if (!wall) store_bodies(bodies, k.a, e.a);
    store_bodies(bodies, k.b, e.b);
}

// How the contact lies now.
struct Frame {
    Floats nx, ny;           // t = (ny, -nx)
    Floats parted;           // along the normal, since the step began
    Floats apart_n, apart_t; // from the centre of b to that of a
    Floats lag_n, lag_t;     // what the arms from b are shorter by
};

// Masses are those of the arms at the start of the step: an arm may change by half its length, or pushes would overshoot.
EVIL_INLINE Floats longest_slide(const ContactBlock& k) {
    Floats bn = load(k.arm_n[0]);
    return Floats(0.5f) * min(abs(bn), abs(bn - load(k.apart_n)));
}

EVIL_INLINE Frame frame_of(const ContactBlock& k, const Ends& e) {
    Floats nx = load(k.nx), ny = load(k.ny), follow = load(k.lag), zero = 0.0f, lag = max(follow, zero);
    Floats apart_n = load(k.apart_n), apart_t = load(k.apart_t), most = longest_slide(k);
    Floats x = e.b.moved_x - e.a.moved_x, y = e.b.moved_y - e.a.moved_y, parted = x * nx + y * ny;
    Floats n = clamp(parted, -most, most), t = clamp(x * ny - y * nx, -most, most);
    Frame f{nx, ny, parted, apart_n - n, apart_t - t, lag * n, lag * t};
    Mask discs = follow < zero;
    if (!any(discs)) return f;
    Floats turn = max(-follow, zero) * t; // the normal goes along with the line of their centres, and the arms with it
    Floats shrink = Floats(1.0f) - Floats(0.5f) * (turn * turn);
    return {shrink * (nx + turn * ny),
            shrink * (ny - turn * nx),
            parted + Floats(0.5f) * (turn * t),
            select(discs, apart_n, f.apart_n),
            select(discs, apart_t, f.apart_t),
            f.lag_n,
            f.lag_t};
}

struct Arms {
    Floats an, at, bn, bt;
};

EVIL_INLINE Arms arms_of(const ContactBlock& k, const Frame& f, int point) {
    Floats bn = load(k.arm_n[point]) - f.lag_n, bt = load(k.arm_t[point]) - f.lag_t;
    return {bn - f.apart_n, bt - f.apart_t, bn, bt};
}

// Relative velocity along n and t, and what a unit impulse changes of it, by the bodies' masses.
struct Relative {
    Floats n, t, inv_mass;
};

template <bool wall> EVIL_INLINE Relative relative(const Ends& e, const Frame& f) {
    Floats x = e.b.vx - e.a.vx, y = e.b.vy - e.a.vy;
    return {x * f.nx + y * f.ny, x * f.ny - y * f.nx, wall ? e.b.inv_mass : e.a.inv_mass + e.b.inv_mass};
}

template <bool wall> EVIL_INLINE void apply(Ends& e, const Frame& f, Floats along_n, Floats along_t) { // (4.9)
    Floats px = along_n * f.nx + along_t * f.ny, py = along_n * f.ny - along_t * f.nx;
    if (!wall) {
        e.a.vx -= e.a.inv_mass * px;
        e.a.vy -= e.a.inv_mass * py;
    }
    e.b.vx += e.b.inv_mass * px;
    e.b.vy += e.b.inv_mass * py;
}

template <bool wall> EVIL_INLINE void turn_by_normal(Ends& e, const Arms& arm, Floats impulse) { // (4.10)
    if (!wall) e.a.spin -= e.a.inv_inertia * (impulse * arm.at);
    e.b.spin += e.b.inv_inertia * (impulse * arm.bt);
}

template <bool wall> EVIL_INLINE void turn_by_tangent(Ends& e, const Arms& arm, Floats impulse) {
    if (!wall) e.a.spin += e.a.inv_inertia * (impulse * arm.an);
    e.b.spin -= e.b.inv_inertia * (impulse * arm.bn);
}

struct Turn {
    Floats sine, cosine_less_one;
};

// To 2e-5 within half a radian, and sane up to a quarter turn: contacts only ask how far their points have moved.
EVIL_INLINE Turn turn_of(Floats angle) {
    Floats x = clamp(angle, Floats(-kQuarterTurn), Floats(kQuarterTurn)), x2 = x * x;
    return {x + x * x2 * (x2 * (1.0f / 120.0f) - Floats(1.0f / 6.0f)), x2 * (x2 * (1.0f / 24.0f) - Floats(0.5f))};
}

EVIL_INLINE Floats separation(Floats gap, const Frame& f, const Arms& arm, const Turn& a, const Turn& b) {
    return gap + f.parted +
           ((b.cosine_less_one * arm.bn + b.sine * arm.bt) - (a.cosine_less_one * arm.an + a.sine * arm.at));
}

// (4.8) with e = 0: a soft push while they overlap, and in advance of touching only what would make them overlap.
template <bool soften, bool wall>
EVIL_INLINE Floats push_normal(ContactBlock& k, int point, const Arms& arm, Floats gap, Relative& v, Ends& e,
                               Floats inv_h, const ContactSoftness& soft) {
    Floats zero = 0.0f, before = load(k.normal_impulse[point]);
    Floats bias = max(gap, zero) * inv_h, mass = load(k.normal_mass[point]), leak = zero;
    if (soften) {
        Mask apart = gap > zero;
        bias = select(apart, bias, max(Floats(soft.bias_rate) * gap, Floats(-kPushSpeed)));
        mass = select(apart, mass, mass * Floats(soft.mass_scale));
        leak = select(apart, zero, Floats(soft.impulse_scale) * before);
    }
    Floats speed = v.n + (e.b.spin * arm.bt - e.a.spin * arm.at);
    Floats after = min(max(before - mass * (speed + bias) - leak, zero), Floats(kMostImpulse));
    Floats impulse = after - before;
    store(k.normal_impulse[point], after);
    v.n += v.inv_mass * impulse;
    turn_by_normal<wall>(e, arm, impulse);
    return impulse;
}

// Friction within Coulomb's cone, at rest and sliding (SPEC C5).
template <bool wall>
EVIL_INLINE Floats push_tangent(ContactBlock& k, int point, const Arms& arm, Floats friction, Floats belt, Relative& v,
                                Ends& e) {
    Floats before = load(k.tangent_impulse[point]), most = friction * load(k.normal_impulse[point]);
    Floats speed = v.t - (e.b.spin * arm.bn - e.a.spin * arm.an) - belt;
    Floats after = clamp(before - load(k.tangent_mass[point]) * speed, -most, most);
    Floats impulse = after - before;
    store(k.tangent_impulse[point], after);
    v.t += v.inv_mass * impulse;
    turn_by_tangent<wall>(e, arm, impulse);
    return impulse;
}

// Both passes need it: without friction in the first, what overlaps deepest squeezes its neighbours out sideways.
template <bool wall> EVIL_INLINE Floats rub(ContactBlock& k, const Arms& p, const Arms& q, Relative& v, Ends& e) {
    Floats friction = load(k.friction), belt = load(k.surface_speed);
    Floats along_t = push_tangent<wall>(k, 0, p, friction, belt, v, e);
    return along_t + push_tangent<wall>(k, 1, q, friction, belt, v, e);
}

template <bool wall>
EVIL_INLINE void push_block(SolverBody* bodies, ContactBlock& k, Floats inv_h, const ContactSoftness& soft) {
    Ends e{load_bodies(bodies, k.a), load_bodies(bodies, k.b)};
    Frame f = frame_of(k, e);
    Relative v = relative<wall>(e, f);
    Turn ta = turn_of(e.a.turned), tb = turn_of(e.b.turned);
    Arms p = arms_of(k, f, 0), q = arms_of(k, f, 1);
    Floats along_n = push_normal<true, wall>(k, 0, p, separation(load(k.gap[0]), f, p, ta, tb), v, e, inv_h, soft);
    along_n += push_normal<true, wall>(k, 1, q, separation(load(k.gap[1]), f, q, ta, tb), v, e, inv_h, soft);
    apply<wall>(e, f, along_n, rub<wall>(k, p, q, v, e));
    store_ends<wall>(bodies, k, e);
}

EVIL_INLINE void add_up(ContactBlock& k, int point) {
    store(k.total_impulse[point], load(k.total_impulse[point]) + load(k.normal_impulse[point]));
}

template <bool wall> EVIL_INLINE void relax_block(SolverBody* bodies, ContactBlock& k, Floats inv_h) {
    Ends e{load_bodies(bodies, k.a), load_bodies(bodies, k.b)};
    Frame f = frame_of(k, e);
    Relative v = relative<wall>(e, f);
    Turn ta = turn_of(e.a.turned), tb = turn_of(e.b.turned);
    Arms p = arms_of(k, f, 0), q = arms_of(k, f, 1);
    ContactSoftness hard{};
    Floats along_n = push_normal<false, wall>(k, 0, p, separation(load(k.gap[0]), f, p, ta, tb), v, e, inv_h, hard);
    along_n += push_normal<false, wall>(k, 1, q, separation(load(k.gap[1]), f, q, ta, tb), v, e, inv_h, hard);
    add_up(k, 0);
    add_up(k, 1);
    apply<wall>(e, f, along_n, rub<wall>(k, p, q, v, e));
    store_ends<wall>(bodies, k, e);
}

template <bool wall> EVIL_INLINE void warm_block(SolverBody* bodies, ContactBlock& k) {
    Ends e{load_bodies(bodies, k.a), load_bodies(bodies, k.b)};
    Frame f = frame_of(k, e);
    Floats along_n = 0.0f, along_t = 0.0f;
    for (int point = 0; point < 2; ++point) {
        Arms arm = arms_of(k, f, point);
        Floats n = load(k.normal_impulse[point]), t = load(k.tangent_impulse[point]);
        turn_by_normal<wall>(e, arm, n);
        turn_by_tangent<wall>(e, arm, t);
        along_n += n;
        along_t += t;
    }
    apply<wall>(e, f, along_n, along_t);
    store_ends<wall>(bodies, k, e);
}

} // namespace

void warm_start(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) warm_block<false>(bodies, blocks[i]);
}
void warm_start_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) warm_block<true>(bodies, blocks[i]);
}
void push_apart(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                ContactSoftness soft) noexcept {
    for (std::size_t i = 0; i < count; ++i) push_block<false>(bodies, blocks[i], inv_h, soft);
}
void push_apart_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                      ContactSoftness soft) noexcept {
    for (std::size_t i = 0; i < count; ++i) push_block<true>(bodies, blocks[i], inv_h, soft);
}
void relax(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept {
    for (std::size_t i = 0; i < count; ++i) relax_block<false>(bodies, blocks[i], inv_h);
}
void relax_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept {
    for (std::size_t i = 0; i < count; ++i) relax_block<true>(bodies, blocks[i], inv_h);
}

} // namespace evil::EVIL_ISA
