// The solver's inner loop. Relative velocity is projected onto normal and tangent once for a block and kept there while
// the points push; the sum of impulses is applied once. So the two points of a contact still see each other's work.
#include "solver/contacts_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr float kPushSpeed = 3.0f;    // m/s: the fastest that overlap is pushed out; more, and piles burst apart
constexpr float kMostImpulse = 1e30f; // newton seconds: finite, whatever came in
constexpr float kStill = 5e-4f; // metres in a step; more, and what slides would be turned by arms of the last substep
constexpr float kFar = 1e15f;   // metres
constexpr float kQuarterTurn = 1.5707964f;

struct Row {
    Floats vx, vy, spin, inv_mass, moved_x, moved_y, turned, inv_inertia;
};

struct Ends { // the two bodies of eight contacts
    Row a, b;
};

EVIL_INLINE Row load_bodies(const SolverBody* bodies, const std::uint32_t* starts) {
    Floats field[8];
    load_rows<1>(&bodies->vx, starts, field);
    return {field[0], field[1], field[2], field[3], field[4], field[5], field[6], field[7]};
}

EVIL_INLINE void store_bodies(SolverBody* bodies, const std::uint32_t* starts, const Row& row) {
    Floats field[4] = {row.vx, row.vy, row.spin, row.inv_mass};
    store_half_rows<1>(&bodies->vx, starts, field);
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
// What stands still may change by anything.
struct Slack {
    Floats a, b;
};

EVIL_INLINE Slack slack_of(const ContactBlock& k, const Ends& e) {
    Floats bn = load(k.arm_n[0]), half = 0.5f;
    return {select(e.a.inv_mass == Floats(0.0f), Floats(kFar), half * abs(bn - load(k.apart_n))), half * abs(bn)};
}

// Of what the two have slid, what b's arm is shorter by: its share, unless that is more than it, or a's arm, may change by.
EVIL_INLINE Floats lag_of(Floats share, Floats slid, const Slack& most) {
    Floats b = clamp(share * slid, -most.b, most.b);
    return clamp(b, slid - most.a, slid + most.a);
}

EVIL_INLINE Frame frame_of(const ContactBlock& k, const Ends& e) {
    Floats nx = load(k.nx), ny = load(k.ny), follow = load(k.lag), zero = 0.0f, lag = max(follow, zero);
    Floats apart_n = load(k.apart_n), apart_t = load(k.apart_t);
    Slack slack = slack_of(k, e);
    Floats most = slack.a + slack.b;
    Floats x = e.b.moved_x - e.a.moved_x, y = e.b.moved_y - e.a.moved_y, parted = x * nx + y * ny;
    Floats n = clamp(parted, -most, most), t = clamp(x * ny - y * nx, -most, most);
    Frame f{nx, ny, parted, apart_n - n, apart_t - t, lag_of(lag, n, slack), lag_of(lag, t, slack)};
    Mask discs = follow < zero;
    if (!any(discs)) return f;
    Floats turn = max(-follow, zero) * t; // the normal goes along with the line of their centres, and the arms with it
    Floats shrink = Floats(1.0f) - Floats(0.5f) * (turn * turn);
    Floats curved = parted + Floats(0.5f) * (turn * t), near = clamp(curved, -most, most);
    return {shrink * (nx + turn * ny),
            shrink * (ny - turn * nx),
            curved,
            select(discs, apart_n - near, f.apart_n),
            select(discs, apart_t, f.apart_t),
            select(discs, Floats(0.5f) * near, f.lag_n),
            f.lag_t};
}

// Do two that push each other stand elsewhere to each other than when the step began?
EVIL_INLINE Mask slides(const ContactBlock& k, const Ends& e) {
    Mask pushes = (load(k.normal_impulse[0]) > Floats(0.0f)) | (load(k.normal_impulse[1]) > Floats(0.0f));
    Floats x = abs(e.b.moved_x - e.a.moved_x), y = abs(e.b.moved_y - e.a.moved_y);
    return pushes & (max(x, y) > Floats(kStill));
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

EVIL_INLINE void add_up(ContactBlock& k, int point) {
    store(k.total_impulse[point], load(k.total_impulse[point]) + load(k.normal_impulse[point]));
}

// Some blocks of one colour, n of them side by side: what each waits for in itself is time for the others. They share no
// body that contacts change, so it is all the same to the numbers.
template <int n> struct Several {
    Ends ends[n];
    Frame frame[n];
    Relative v[n];
    Arms p[n], q[n];
    Turn turn_a[n], turn_b[n];
    Floats along_n[n], along_t[n];
};

template <int n> EVIL_INLINE void begin(Several<n>& s, const SolverBody* bodies, const ContactBlock* k) {
    for (int i = 0; i < n; ++i) s.ends[i] = {load_bodies(bodies, k[i].a), load_bodies(bodies, k[i].b)};
    for (int i = 0; i < n; ++i) s.frame[i] = frame_of(k[i], s.ends[i]);
    for (int i = 0; i < n; ++i) {
        s.p[i] = arms_of(k[i], s.frame[i], 0);
        s.q[i] = arms_of(k[i], s.frame[i], 1);
    }
}

template <bool wall, int n> EVIL_INLINE void finish(Several<n>& s, SolverBody* bodies, const ContactBlock* k) {
    for (int i = 0; i < n; ++i) {
        apply<wall>(s.ends[i], s.frame[i], s.along_n[i], s.along_t[i]);
        store_ends<wall>(bodies, k[i], s.ends[i]);
    }
}

// Both passes need friction: without it in the first, what overlaps deepest squeezes its neighbours out sideways.
template <bool soften, bool wall, int n>
EVIL_INLINE void solve_blocks(SolverBody* bodies, ContactBlock* k, Floats inv_h, const ContactSoftness& soft,
                              Mask& slid) {
    Several<n> s;
    begin(s, bodies, k);
    for (int i = 0; i < n; ++i) {
        s.v[i] = relative<wall>(s.ends[i], s.frame[i]);
        Floats turned = s.ends[i].b.turned, zero = 0.0f;
        if (wall) turned = select(load(k[i].lag) < zero, zero, turned); // a disc may roll as it likes: it rises not
        s.turn_a[i] = turn_of(s.ends[i].a.turned);
        s.turn_b[i] = turn_of(turned);
    }
    auto push = [&](int i, int point, const Arms& arm) {
        Floats gap = separation(load(k[i].gap[point]), s.frame[i], arm, s.turn_a[i], s.turn_b[i]);
        return push_normal<soften, wall>(k[i], point, arm, gap, s.v[i], s.ends[i], inv_h, soft);
    };
    for (int i = 0; i < n; ++i) s.along_n[i] = push(i, 0, s.p[i]);
    for (int i = 0; i < n; ++i) s.along_n[i] += push(i, 1, s.q[i]);
    auto rub = [&](int i, int point, const Arms& arm) {
        return push_tangent<wall>(k[i], point, arm, load(k[i].friction), load(k[i].surface_speed), s.v[i], s.ends[i]);
    };
    for (int i = 0; i < n; ++i) s.along_t[i] = rub(i, 0, s.p[i]);
    for (int i = 0; i < n; ++i) s.along_t[i] += rub(i, 1, s.q[i]);
    for (int i = 0; i < n && !soften; ++i) {
        add_up(k[i], 0);
        add_up(k[i], 1);
    }
    finish<wall>(s, bodies, k);
    for (int i = 0; i < n && !soften && !wall; ++i) slid = slid | slides(k[i], s.ends[i]);
}

template <bool wall, int n> EVIL_INLINE void warm_blocks(SolverBody* bodies, ContactBlock* k) {
    Several<n> s;
    begin(s, bodies, k);
    for (int i = 0; i < n; ++i) {
        s.along_n[i] = s.along_t[i] = 0.0f;
        for (int point = 0; point < 2; ++point) {
            const Arms& arm = point == 0 ? s.p[i] : s.q[i];
            Floats along_n = load(k[i].normal_impulse[point]), along_t = load(k[i].tangent_impulse[point]);
            turn_by_normal<wall>(s.ends[i], arm, along_n);
            turn_by_tangent<wall>(s.ends[i], arm, along_t);
            s.along_n[i] += along_n;
            s.along_t[i] += along_t;
        }
    }
    finish<wall>(s, bodies, k);
}

// Two side by side: more would not fit the registers.
template <class Work> EVIL_INLINE void by_twos(std::size_t count, Work work) {
    std::size_t i = 0;
    for (; i + 1 < count; i += 2) work.template operator()<2>(i);
    if (i < count) work.template operator()<1>(i);
}

} // namespace

void warm_start(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept {
    by_twos(count, [&]<int n>(std::size_t i) { warm_blocks<false, n>(bodies, blocks + i); });
}
void warm_start_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept {
    by_twos(count, [&]<int n>(std::size_t i) { warm_blocks<true, n>(bodies, blocks + i); });
}
void push_apart(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                ContactSoftness soft) noexcept {
    Mask none = first_lanes(0);
    by_twos(count, [&]<int n>(std::size_t i) { solve_blocks<true, false, n>(bodies, blocks + i, inv_h, soft, none); });
}
void push_apart_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                      ContactSoftness soft) noexcept {
    Mask none = first_lanes(0);
    by_twos(count, [&]<int n>(std::size_t i) { solve_blocks<true, true, n>(bodies, blocks + i, inv_h, soft, none); });
}
bool relax(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept {
    Mask slid = first_lanes(0);
    by_twos(count, [&]<int n>(std::size_t i) { solve_blocks<false, false, n>(bodies, blocks + i, inv_h, {}, slid); });
    return any(slid);
}
void relax_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept {
    Mask none = first_lanes(0);
    by_twos(count, [&]<int n>(std::size_t i) { solve_blocks<false, true, n>(bodies, blocks + i, inv_h, {}, none); });
}

} // namespace evil::EVIL_ISA
