// The solver's inner loops over joints: Catto, "Soft Constraints" (GDC 2011), with arms that turn with their bodies in
// every substep. A joint's drives (springs, motors, limits) come first and what is held last, so that it holds best.
//
// What swings keeps its energy: the pass before the bodies move aims at where the joint will hold once they have gone
// round, not along a line (SHAKE); the pass after it takes out the speed against the joint where they then are (RATTLE:
// Andersen, "Rattle: a velocity version of the Shake algorithm", 1983).
#include "solver/joints/joints_wide.hpp"
#include "solver/joints/drive_lanes.hpp"

namespace evil::EVIL_ISA {
namespace {

// ---- a point of a on a point of b ----

struct Arms {
    Pair a, b;
};

// What unit impulses along x and y change of the speeds there, inverted. With u the turned arms (Catto, "Computing
// Effective Mass"): K = m I + i_a u_a u_a' + i_b u_b u_b', whose determinant has no differences in it when written so:
EVIL_INLINE void find_mass(PointBlock& k, const Ends& e, const Arms& r) {
    Pair a = r.a, b = r.b;
    Floats m = e.a.inv_mass + e.b.inv_mass, ia = e.a.inv_inertia, ib = e.b.inv_inertia;
    Floats xx = m + ia * a.y * a.y + ib * b.y * b.y, yy = m + ia * a.x * a.x + ib * b.x * b.x;
    Floats xy = ia * a.x * a.y + ib * b.x * b.y; // negated
    Floats across = a.x * b.y - a.y * b.x;
    Floats det = m * (m + ia * (a.x * a.x + a.y * a.y) + ib * (b.x * b.x + b.y * b.y)) + ia * ib * across * across;
    Floats inv = inverse(det);
    store(k.mass_xx, yy * inv);
    store(k.mass_xy, xy * inv);
    store(k.mass_yy, xx * inv);
}

EVIL_INLINE Arms arms_of(const PointBlock& k) { return {{load(k.ax), load(k.ay)}, {load(k.bx), load(k.by)}}; }

// Arms, masses and errors where the bodies are now.
EVIL_INLINE Arms refresh(PointBlock& k, const Ends& e, Floats turned_a, Floats turned_b) {
    Floats s, c;
    sine_cosine(turned_a, s, c);
    Pair a = turn(c, s, load(k.start_ax), load(k.start_ay));
    sine_cosine(turned_b, s, c);
    Pair b = turn(c, s, load(k.start_bx), load(k.start_by));
    store(k.ax, a.x);
    store(k.ay, a.y);
    store(k.bx, b.x);
    store(k.by, b.y);
    store(k.spin_a, e.a.spin);
    store(k.spin_b, e.b.spin);
    store(k.error_x, load(k.gap_x) + (e.b.moved_x - e.a.moved_x) + (b.x - a.x));
    store(k.error_y, load(k.gap_y) + (e.b.moved_y - e.a.moved_y) + (b.y - a.y));
    find_mass(k, e, {a, b});
    return {a, b};
}

EVIL_INLINE void push_point(const Arms& r, Ends& e, Floats x, Floats y) {
    push(e.a, -1.0f, x, y, r.a.x * y - r.a.y * x);
    push(e.b, 1.0f, x, y, r.b.x * y - r.b.y * x);
}

EVIL_INLINE void begin(const JointTables& t, PointBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    Floats turned_a = e.a.turned, turned_b = e.b.turned;
    refresh(k, e, turned_a, turned_b);
    if (k.turn != kNoDrive) begin_turn(t.drives[k.turn], e, turned_b - turned_a);
}

EVIL_INLINE void warm(const JointTables& t, PointBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    push_point(arms_of(k), e, load(k.impulse_x), load(k.impulse_y));
    if (k.turn != kNoDrive) spin_ends(e, sum_of(t.drives[k.turn]));
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
}

struct Soft {
    Floats keep, pull, leak;
};

template <bool moving> EVIL_INLINE Soft softness(const JointTables& t, std::uint32_t soft) {
    if (soft == kNoDrive) {
        if (moving) return {t.pass.stiff.keep, t.pass.stiff.pull, t.pass.stiff.leak};
        return {1.0f, 0.0f, 0.0f};
    }
    const SoftLanes& s = t.softs[soft];
    if (moving) return {load(s.keep), load(s.pull), load(s.leak)};
    return {load(s.calm_keep), load(s.calm_pull), load(s.calm_leak)};
}

EVIL_INLINE Pair weakened(Pair impulse, Floats most) { // no stronger than it may be
    Floats size = sqrt(impulse.x * impulse.x + impulse.y * impulse.y);
    Mask over = size > most;
    Floats scale = select(over, most / select(over, size, Floats(1.0f)), Floats(1.0f));
    return {impulse.x * scale, impulse.y * scale};
}

template <bool moving> EVIL_INLINE void solve(const JointTables& t, PointBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    Pair error{load(k.error_x), load(k.error_y)}; // when the substep began
    Floats turned_by = 0.0f;
    Arms r;
    if (moving) {
        r = arms_of(k);
    } else {
        Floats turned_a = e.a.turned, turned_b = e.b.turned;
        turned_by = turned_b - turned_a;
        r = refresh(k, e, turned_a, turned_b);
    }
    if (k.turn != kNoDrive) drive_turn<moving>(t.drives[k.turn], e, turned_by, t.pass);
    Floats vx = (e.b.vx - e.b.spin * r.b.y) - (e.a.vx - e.a.spin * r.a.y);
    Floats vy = (e.b.vy + e.b.spin * r.b.x) - (e.a.vy + e.a.spin * r.a.x);
    Floats old_x = load(k.impulse_x), old_y = load(k.impulse_y), leak = 0.0f;
    if (moving || k.soft != kNoDrive) {
        Soft s = softness<moving>(t, k.soft);
        if (moving) { // by spins that all joints have agreed on: those halfway through a pass jitter in a net, and would be fed
            Floats a = falling_behind(load(k.spin_a), t.pass.h, t.pass.inv_h);
            Floats b = falling_behind(load(k.spin_b), t.pass.h, t.pass.inv_h);
            vx += a * r.a.x - b * r.b.x;
            vy += a * r.a.y - b * r.b.y;
        }
        vx = s.keep * vx + s.pull * error.x;
        vy = s.keep * vy + s.pull * error.y;
        leak = s.leak;
    }
    Floats xx = load(k.mass_xx), xy = load(k.mass_xy), yy = load(k.mass_yy);
    Pair now{bounded((old_x - (xx * vx + xy * vy)) - leak * old_x, kMostImpulse),
             bounded((old_y - (xy * vx + yy * vy)) - leak * old_y, kMostImpulse)};
    if (k.soft != kNoDrive) now = weakened(now, load(t.softs[k.soft].most));
    store(k.impulse_x, now.x);
    store(k.impulse_y, now.y);
    push_point(r, e, now.x - old_x, now.y - old_y);
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
    if (moving) return;
    store(k.total_x, load(k.total_x) + now.x);
    store(k.total_y, load(k.total_y) + now.y);
}

// ---- along and across a direction ----

EVIL_INLINE Mask as_mask(const std::uint32_t* lanes) { return load(lanes) < Ints(0); }

// Inverse of what unit impulses change of the speed across the axis and of turning; where turning is free, of the first.
EVIL_INLINE void guide_mass(AxisBlock& k, const Ends& e, Floats side_a, Floats side_b) {
    Floats zero = 0.0f, m = e.a.inv_mass + e.b.inv_mass, ia = e.a.inv_inertia, ib = e.b.inv_inertia;
    Floats ss = m + ia * side_a * side_a + ib * side_b * side_b, st = ia * side_a + ib * side_b, tt = ia + ib;
    Floats apart = side_a - side_b, det = m * tt + ia * ib * apart * apart;
    Floats inv = inverse(det);
    Mask both = as_mask(k.locked) & (inv > zero);
    Mask guided = as_mask(k.fixed);
    store(k.mass_ss, select(guided, select(both, tt * inv, inverse(ss)), zero));
    store(k.mass_st, select(both, -st * inv, zero));
    store(k.mass_tt, select(both, ss * inv, zero));
}

struct Way { // the axis, and what turning does along it (arm x n) and across it
    Floats nx, ny, arm_a, arm_b, side_a, side_b;
};

EVIL_INLINE Way way_of(const AxisBlock& k) {
    return {load(k.nx), load(k.ny), load(k.arm_a), load(k.arm_b), load(k.side_a), load(k.side_b)};
}

EVIL_INLINE Floats inv_mass_along(const Ends& e, const Way& w) {
    return e.a.inv_mass + e.b.inv_mass + e.a.inv_inertia * w.arm_a * w.arm_a + e.b.inv_inertia * w.arm_b * w.arm_b;
}

// The axis, arms, masses and errors where the bodies are now; `length` is what the axis measures.
EVIL_INLINE Way refresh(const JointTables& t, AxisBlock& k, const Ends& e, Floats turned_a, Floats turned_b,
                        Floats& length) {
    Floats s, c;
    sine_cosine(turned_b, s, c);
    Pair b = turn(c, s, load(k.start_bx), load(k.start_by));
    sine_cosine(turned_a, s, c);
    Pair a = turn(c, s, load(k.start_ax), load(k.start_ay));
    Pair axis = turn(c, s, load(k.axis_x), load(k.axis_y));
    Floats dx = load(k.gap_x) + (e.b.moved_x - e.a.moved_x) + (b.x - a.x);
    Floats dy = load(k.gap_y) + (e.b.moved_y - e.a.moved_y) + (b.y - a.y);
    Floats inv = inverse(sqrt(dx * dx + dy * dy));
    Mask fixed = as_mask(k.fixed) | (inv == Floats(0.0f)); // anchors in one place: any direction will do
    Way w;
    w.nx = select(fixed, axis.x, dx * inv);
    w.ny = select(fixed, axis.y, dy * inv);
    Floats far_x = a.x + dx, far_y = a.y + dy; // b's anchor from a's centre
    w.arm_a = far_x * w.ny - far_y * w.nx;
    w.arm_b = b.x * w.ny - b.y * w.nx;
    w.side_a = far_x * w.nx + far_y * w.ny;
    w.side_b = b.x * w.nx + b.y * w.ny;
    store(k.nx, w.nx);
    store(k.ny, w.ny);
    store(k.arm_a, w.arm_a);
    store(k.arm_b, w.arm_b);
    store(k.side_a, w.side_a);
    store(k.side_b, w.side_b);
    length = dx * w.nx + dy * w.ny;
    store(t.drives[k.along].mass, inverse(inv_mass_along(e, w)));
    if (k.guided) {
        store(k.error, dy * w.nx - dx * w.ny);
        store(k.error_turn, load(k.base_turn) + (turned_b - turned_a));
        guide_mass(k, e, w.side_a, w.side_b);
    }
    return w;
}

EVIL_INLINE void push_along(const Way& w, Ends& e, Floats impulse) {
    Floats x = impulse * w.nx, y = impulse * w.ny;
    push(e.a, -1.0f, x, y, impulse * w.arm_a);
    push(e.b, 1.0f, x, y, impulse * w.arm_b);
}

EVIL_INLINE void push_guide(const Way& w, Ends& e, Floats side, Floats turning) { // across = n turned left
    Floats x = -side * w.ny, y = side * w.nx;
    push(e.a, -1.0f, x, y, side * w.side_a + turning);
    push(e.b, 1.0f, x, y, side * w.side_b + turning);
}

EVIL_INLINE void begin(const JointTables& t, AxisBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    Floats turned_a = e.a.turned, turned_b = e.b.turned, length;
    refresh(t, k, e, turned_a, turned_b, length);
    store(t.drives[k.along].value, length);
    if (k.turn != kNoDrive) begin_turn(t.drives[k.turn], e, turned_b - turned_a);
}

EVIL_INLINE void warm(const JointTables& t, AxisBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    Way w = way_of(k);
    push_along(w, e, sum_of(t.drives[k.along]));
    if (k.turn != kNoDrive) spin_ends(e, sum_of(t.drives[k.turn]));
    if (k.guided) push_guide(w, e, load(k.impulse_side), load(k.impulse_turn));
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
}

EVIL_INLINE Floats speed_along(const Way& w, const Ends& e) {
    return (e.b.vx - e.a.vx) * w.nx + (e.b.vy - e.a.vy) * w.ny + e.b.spin * w.arm_b - e.a.spin * w.arm_a;
}

EVIL_INLINE Floats speed_across(const Way& w, const Ends& e) {
    return (e.b.vy - e.a.vy) * w.nx - (e.b.vx - e.a.vx) * w.ny + e.b.spin * w.side_b - e.a.spin * w.side_a;
}

template <bool moving> EVIL_INLINE void guide(AxisBlock& k, const Way& w, Ends& e, const JointPass& pass) {
    Floats speed = speed_across(w, e), turning = e.b.spin - e.a.spin, leak = 0.0f;
    Floats old_side = load(k.impulse_side), old_turn = load(k.impulse_turn);
    if (moving) { // the axis turns too, and sweeps what slides along it
        Floats keep = pass.stiff.keep, pull = pass.stiff.pull;
        Floats bend = falling_behind(e.b.spin, pass.h, pass.inv_h) * w.arm_b -
                      falling_behind(e.a.spin, pass.h, pass.inv_h) * w.arm_a -
                      Floats(pass.h) * e.a.spin * speed_along(w, e);
        speed = keep * (speed + bend) + pull * load(k.error);
        turning = keep * turning + pull * load(k.error_turn);
        leak = pass.stiff.leak;
    }
    Floats ss = load(k.mass_ss), st = load(k.mass_st), tt = load(k.mass_tt);
    Floats new_side = bounded(old_side - (ss * speed + st * turning) - leak * old_side, kMostImpulse);
    Floats new_turn = bounded(old_turn - (st * speed + tt * turning) - leak * old_turn, kMostImpulse);
    store(k.impulse_side, new_side);
    store(k.impulse_turn, new_turn);
    push_guide(w, e, new_side - old_side, new_turn - old_turn);
    if (moving) return;
    store(k.total_side, load(k.total_side) + new_side);
    store(k.total_turn, load(k.total_turn) + new_turn);
}

// Half of what the way round does to the length between two anchors: each end goes round its centre, and one round the
// other. Held to turns of a radian.
EVIL_INLINE Floats bend_of(const AxisBlock& k, const Way& w, const Ends& e, Floats length, const JointPass& pass) {
    Floats zero = 0.0f, across = speed_across(w, e) + e.a.spin * length;
    Floats round = clamp(0.5f * Floats(pass.h) * across * inverse(length), -0.5f, 0.5f) * across;
    Floats a = falling_behind(e.a.spin, pass.h, pass.inv_h), b = falling_behind(e.b.spin, pass.h, pass.inv_h);
    return select(as_mask(k.fixed), zero, round + a * (w.side_a - length) - b * w.side_b);
}

template <bool moving> EVIL_INLINE void solve(const JointTables& t, AxisBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    DriveBlock& along = t.drives[k.along];
    Floats turned_by = 0.0f, bend = 0.0f, length;
    Way w;
    if (moving) {
        w = way_of(k);
        length = load(along.value);
    } else {
        Floats turned_a = e.a.turned, turned_b = e.b.turned;
        turned_by = turned_b - turned_a;
        w = refresh(t, k, e, turned_a, turned_b, length);
    }
    if (k.turn != kNoDrive) drive_turn<moving>(t.drives[k.turn], e, turned_by, t.pass);
    if (moving) bend = bend_of(k, w, e, length, t.pass);
    push_along(w, e, drive<moving>(along, {speed_along(w, e), inv_mass_along(e, w)}, length, bend, t.pass));
    if (k.guided) guide<moving>(k, w, e, t.pass);
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
}

} // namespace

void begin_joints(const JointTables& t) noexcept {
    for (std::size_t i = 0; i < t.axis_count; ++i) begin(t, t.axes[i]);
    for (std::size_t i = 0; i < t.point_count; ++i) begin(t, t.points[i]);
}

void warm_joints(const JointTables& t) noexcept {
    for (std::size_t i = 0; i < t.axis_count; ++i) warm(t, t.axes[i]);
    for (std::size_t i = 0; i < t.point_count; ++i) warm(t, t.points[i]);
}

void move_joints(const JointTables& t) noexcept {
    for (std::size_t i = 0; i < t.axis_count; ++i) solve<true>(t, t.axes[i]);
    for (std::size_t i = 0; i < t.point_count; ++i) solve<true>(t, t.points[i]);
}

void calm_joints(const JointTables& t) noexcept {
    for (std::size_t i = 0; i < t.axis_count; ++i) solve<false>(t, t.axes[i]);
    for (std::size_t i = 0; i < t.point_count; ++i) solve<false>(t, t.points[i]);
}

} // namespace evil::EVIL_ISA
