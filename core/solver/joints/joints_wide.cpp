// The solver's inner loops over joints: Catto, "Soft Constraints" (GDC 2011), with arms that turn with their bodies in
// every substep. A joint's drives (springs, motors, limits) come first and what is held last, so that it holds best.
#include "solver/joints/joints_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr float kMostImpulse = 1e30f; // newton seconds: finite, whatever came in

struct Body {
    Floats vx, vy, spin, inv_mass, moved_x, moved_y, sine, inv_inertia;
};
static_assert(sizeof(Body) == 8 * sizeof(Floats));

struct Ends { // the two bodies of eight joints
    Body a, b;
};

struct Pair {
    Floats x, y;
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

EVIL_INLINE Floats bounded(Floats impulse, Floats most) { return clamp(impulse, -most, most); }

EVIL_INLINE Floats inverse(Floats k) { // 0 where nothing moves, and where it moves too easily to be told
    Floats one = 1.0f, zero = 0.0f;
    Mask good = (k > zero) & (k < Floats(1e38f));
    return select(good, one / select(good, k, one), zero);
}

// Sine and cosine to 3e-7, of any angle that a body turns by within a step: the nearest quarter turn is taken off, and
// what is left within an eighth goes through the first terms of Taylor's series.
EVIL_INLINE void sine_cosine(Floats angle, Floats& sine, Floats& cosine) {
    Floats x = clamp(angle, -2e6f, 2e6f);
    Ints quarter = round_to_int(x * 0.63661977f);
    Floats turns = to_float(quarter);
    x = (x - turns * 1.5707964f) + turns * 4.3711388e-8f; // pi/2 in two parts
    Floats x2 = x * x;
    Floats s = x - x * x2 * (0.16666667f - x2 * (0.0083333333f - x2 * 0.00019841270f));
    Floats c = 1.0f - x2 * (0.5f - x2 * (0.041666667f - x2 * (0.0013888889f - x2 * 0.000024801587f)));
    Mask odd = (quarter & 1) == Ints(1), minus_s = (quarter & 2) == Ints(2), minus_c = ((quarter + 1) & 2) == Ints(2);
    Floats at_s = select(odd, c, s), at_c = select(odd, s, c);
    sine = select(minus_s, -at_s, at_s);
    cosine = select(minus_c, -at_c, at_c);
}

EVIL_INLINE Pair turn(Floats cosine, Floats sine, Floats x, Floats y) {
    return {cosine * x - sine * y, sine * x + cosine * y};
}

EVIL_INLINE void push(Body& body, Floats sign, Floats x, Floats y, Floats turning) {
    Floats m = sign * body.inv_mass;
    body.vx += m * x;
    body.vy += m * y;
    body.spin += sign * body.inv_inertia * turning;
}

// ---- drives ----

EVIL_INLINE Floats sum_of(const DriveBlock& d) {
    return (load(d.spring) + load(d.motor)) + (load(d.to_lower) - load(d.to_upper));
}

struct Speed { // of a coordinate, and what a unit impulse changes of it
    Floats now, inv_mass;
};

template <bool moving> EVIL_INLINE Floats pull_spring(DriveBlock& d, Speed& v, Floats mass) {
    const SoftLanes& s = d.soft;
    Floats before = load(d.spring), error = load(d.value) - load(d.rest);
    Floats keep = load(moving ? s.keep : s.calm_keep), pull = load(moving ? s.pull : s.calm_pull);
    Floats leak = load(moving ? s.leak : s.calm_leak), most = load(s.most);
    Floats after = bounded(before - mass * (keep * v.now + pull * error) - leak * before, most);
    store(d.spring, after);
    v.now += v.inv_mass * (after - before);
    return after - before;
}

EVIL_INLINE Floats run_motor(DriveBlock& d, Speed& v, Floats mass) {
    Floats before = load(d.motor);
    Floats after = bounded(before - mass * (v.now - load(d.speed)), load(d.motor_most));
    store(d.motor, after);
    v.now += v.inv_mass * (after - before);
    return after - before;
}

// Push so that `gap` will not be used up within the substep; where it is negative already, out of that by and by.
template <bool moving>
EVIL_INLINE Floats push_from_limit(float* impulse, Floats gap, Floats opening, Floats mass, const JointPass& pass) {
    Floats zero = 0.0f, before = load(impulse);
    Mask open = gap > zero;
    Floats bias = max(gap, zero) * Floats(pass.inv_h), keep = 1.0f, leak = zero;
    if (moving) {
        keep = select(open, keep, Floats(pass.stiff.keep));
        bias = select(open, bias, Floats(pass.stiff.pull) * gap);
        leak = select(open, zero, Floats(pass.stiff.leak));
    }
    Floats after = min(max(before - mass * (keep * opening + bias) - leak * before, zero), Floats(kMostImpulse));
    store(impulse, after);
    return after - before;
}

template <bool moving> EVIL_INLINE Floats drive(DriveBlock& d, Speed v, const JointPass& pass) {
    Floats mass = load(d.mass), value = load(d.value);
    Floats impulse = pull_spring<moving>(d, v, mass);
    impulse += run_motor(d, v, mass);
    Floats up = push_from_limit<moving>(d.to_lower, value - load(d.lower), v.now, mass, pass);
    v.now += v.inv_mass * up;
    Floats down = push_from_limit<moving>(d.to_upper, load(d.upper) - value, -v.now, mass, pass);
    return impulse + (up - down);
}

EVIL_INLINE void begin_turn(DriveBlock& d, Ends& e, Floats turned) {
    store(d.value, load(d.base) + turned);
    store(d.mass, inverse(e.a.inv_inertia + e.b.inv_inertia));
    Floats impulse = sum_of(d);
    e.a.spin -= e.a.inv_inertia * impulse;
    e.b.spin += e.b.inv_inertia * impulse;
}

template <bool moving> EVIL_INLINE void drive_turn(DriveBlock& d, Ends& e, const JointPass& pass) {
    Speed v{e.b.spin - e.a.spin, e.a.inv_inertia + e.b.inv_inertia};
    Floats impulse = drive<moving>(d, v, pass);
    e.a.spin -= e.a.inv_inertia * impulse;
    e.b.spin += e.b.inv_inertia * impulse;
}

EVIL_INLINE void add_up(DriveBlock& d) { store(d.total, load(d.total) + sum_of(d)); }

// ---- a point of a on a point of b ----

// What unit impulses along x and y change of the speeds there, inverted. With u the turned arms (Catto, "Computing
// Effective Mass"): K = m I + i_a u_a u_a' + i_b u_b u_b', whose determinant has no differences in it when written so:
EVIL_INLINE void point_mass(PointBlock& k, const Ends& e, Pair a, Pair b) {
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

EVIL_INLINE void push_point(const PointBlock& k, Ends& e, Floats x, Floats y) {
    push(e.a, -1.0f, x, y, load(k.ax) * y - load(k.ay) * x);
    push(e.b, 1.0f, x, y, load(k.bx) * y - load(k.by) * x);
}

EVIL_INLINE void begin(const JointTables& t, PointBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    Floats turned_a = gather(t.turned, load(k.a)), turned_b = gather(t.turned, load(k.b)), s, c;
    sine_cosine(turned_a, s, c);
    Pair a = turn(c, s, load(k.start_ax), load(k.start_ay));
    sine_cosine(turned_b, s, c);
    Pair b = turn(c, s, load(k.start_bx), load(k.start_by));
    store(k.ax, a.x);
    store(k.ay, a.y);
    store(k.bx, b.x);
    store(k.by, b.y);
    store(k.error_x, load(k.gap_x) + (e.b.moved_x - e.a.moved_x) + (b.x - a.x));
    store(k.error_y, load(k.gap_y) + (e.b.moved_y - e.a.moved_y) + (b.y - a.y));
    point_mass(k, e, a, b);
    push_point(k, e, load(k.impulse_x), load(k.impulse_y));
    if (k.turn != kNoDrive) begin_turn(t.drives[k.turn], e, turned_b - turned_a);
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

template <bool moving> EVIL_INLINE void solve(const JointTables& t, PointBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    if (k.turn != kNoDrive) drive_turn<moving>(t.drives[k.turn], e, t.pass);
    Floats ax = load(k.ax), ay = load(k.ay), bx = load(k.bx), by = load(k.by);
    Floats vx = (e.b.vx - e.b.spin * by) - (e.a.vx - e.a.spin * ay);
    Floats vy = (e.b.vy + e.b.spin * bx) - (e.a.vy + e.a.spin * ax);
    if (moving || k.soft != kNoDrive) {
        Soft s = softness<moving>(t, k.soft);
        vx = s.keep * vx + s.pull * load(k.error_x);
        vy = s.keep * vy + s.pull * load(k.error_y);
    }
    Floats xx = load(k.mass_xx), xy = load(k.mass_xy), yy = load(k.mass_yy);
    Floats old_x = load(k.impulse_x), old_y = load(k.impulse_y);
    Floats new_x = old_x - (xx * vx + xy * vy), new_y = old_y - (xy * vx + yy * vy);
    if (moving || k.soft != kNoDrive) {
        Soft s = softness<moving>(t, k.soft);
        new_x -= s.leak * old_x;
        new_y -= s.leak * old_y;
    }
    new_x = bounded(new_x, kMostImpulse);
    new_y = bounded(new_y, kMostImpulse);
    if (k.soft != kNoDrive) { // no stronger than it may be
        Floats most = load(t.softs[k.soft].most), size = sqrt(new_x * new_x + new_y * new_y);
        Mask over = size > most;
        Floats scale = select(over, most / select(over, size, Floats(1.0f)), Floats(1.0f));
        new_x *= scale;
        new_y *= scale;
    }
    store(k.impulse_x, new_x);
    store(k.impulse_y, new_y);
    push_point(k, e, new_x - old_x, new_y - old_y);
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
    if (moving) return;
    store(k.total_x, load(k.total_x) + new_x);
    store(k.total_y, load(k.total_y) + new_y);
    if (k.turn != kNoDrive) add_up(t.drives[k.turn]);
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

EVIL_INLINE void push_along(const AxisBlock& k, Ends& e, Floats impulse) {
    Floats x = impulse * load(k.nx), y = impulse * load(k.ny);
    push(e.a, -1.0f, x, y, impulse * load(k.arm_a));
    push(e.b, 1.0f, x, y, impulse * load(k.arm_b));
}

EVIL_INLINE void push_guide(const AxisBlock& k, Ends& e, Floats side, Floats turning) { // across = n turned left
    Floats x = -side * load(k.ny), y = side * load(k.nx);
    push(e.a, -1.0f, x, y, side * load(k.side_a) + turning);
    push(e.b, 1.0f, x, y, side * load(k.side_b) + turning);
}

// From a's anchor to b's where the bodies are now, and the direction and arms of the pushes along it.
EVIL_INLINE Pair aim(const JointTables& t, AxisBlock& k, const Ends& e) {
    Floats s, c;
    sine_cosine(gather(t.turned, load(k.b)), s, c);
    Pair b = turn(c, s, load(k.start_bx), load(k.start_by));
    sine_cosine(gather(t.turned, load(k.a)), s, c);
    Pair a = turn(c, s, load(k.start_ax), load(k.start_ay));
    Pair axis = turn(c, s, load(k.axis_x), load(k.axis_y));
    Floats dx = load(k.gap_x) + (e.b.moved_x - e.a.moved_x) + (b.x - a.x);
    Floats dy = load(k.gap_y) + (e.b.moved_y - e.a.moved_y) + (b.y - a.y);
    Floats size = sqrt(dx * dx + dy * dy), inv = inverse(size);
    Mask fixed = as_mask(k.fixed) | (inv == Floats(0.0f)); // anchors in one place: any direction will do
    Floats nx = select(fixed, axis.x, dx * inv), ny = select(fixed, axis.y, dy * inv);
    Floats far_x = a.x + dx, far_y = a.y + dy; // b's anchor from a's centre
    store(k.nx, nx);
    store(k.ny, ny);
    store(k.arm_a, far_x * ny - far_y * nx);
    store(k.arm_b, b.x * ny - b.y * nx);
    store(k.side_a, far_x * nx + far_y * ny);
    store(k.side_b, b.x * nx + b.y * ny);
    return {dx, dy};
}

EVIL_INLINE void begin(const JointTables& t, AxisBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    Pair d = aim(t, k, e);
    Floats nx = load(k.nx), ny = load(k.ny), dx = d.x, dy = d.y;
    Floats arm_a = load(k.arm_a), arm_b = load(k.arm_b), side_a = load(k.side_a), side_b = load(k.side_b);
    Floats turned = gather(t.turned, load(k.b)) - gather(t.turned, load(k.a));
    DriveBlock& along = t.drives[k.along];
    store(along.value, dx * nx + dy * ny);
    store(along.mass,
          inverse(e.a.inv_mass + e.b.inv_mass + e.a.inv_inertia * arm_a * arm_a + e.b.inv_inertia * arm_b * arm_b));
    push_along(k, e, sum_of(along));
    if (k.turn != kNoDrive) begin_turn(t.drives[k.turn], e, turned);
    if (k.guided) {
        store(k.error, dy * nx - dx * ny);
        store(k.error_turn, load(k.base_turn) + turned);
        guide_mass(k, e, side_a, side_b);
        push_guide(k, e, load(k.impulse_side), load(k.impulse_turn));
    }
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
}

template <bool moving> EVIL_INLINE void guide(AxisBlock& k, Ends& e, const JointPass& pass) {
    Floats nx = load(k.nx), ny = load(k.ny);
    Floats speed =
        (e.b.vy - e.a.vy) * nx - (e.b.vx - e.a.vx) * ny + e.b.spin * load(k.side_b) - e.a.spin * load(k.side_a);
    Floats turning = e.b.spin - e.a.spin, old_side = load(k.impulse_side), old_turn = load(k.impulse_turn);
    Floats leak = 0.0f;
    if (moving) {
        Floats keep = pass.stiff.keep, pull = pass.stiff.pull;
        speed = keep * speed + pull * load(k.error);
        turning = keep * turning + pull * load(k.error_turn);
        leak = pass.stiff.leak;
    }
    Floats ss = load(k.mass_ss), st = load(k.mass_st), tt = load(k.mass_tt);
    Floats new_side = bounded(old_side - (ss * speed + st * turning) - leak * old_side, kMostImpulse);
    Floats new_turn = bounded(old_turn - (st * speed + tt * turning) - leak * old_turn, kMostImpulse);
    store(k.impulse_side, new_side);
    store(k.impulse_turn, new_turn);
    push_guide(k, e, new_side - old_side, new_turn - old_turn);
    if (moving) return;
    store(k.total_side, load(k.total_side) + new_side);
    store(k.total_turn, load(k.total_turn) + new_turn);
}

// While relaxing, along where the bodies are by then: a push along where they were would brake what turns.
template <bool moving> EVIL_INLINE void solve(const JointTables& t, AxisBlock& k) {
    Ends e{load_bodies(t.bodies, k.a), load_bodies(t.bodies, k.b)};
    if (!moving) aim(t, k, e);
    DriveBlock& along = t.drives[k.along];
    if (k.turn != kNoDrive) drive_turn<moving>(t.drives[k.turn], e, t.pass);
    Floats nx = load(k.nx), ny = load(k.ny), arm_a = load(k.arm_a), arm_b = load(k.arm_b);
    Floats inv_mass = e.a.inv_mass + e.b.inv_mass + e.a.inv_inertia * arm_a * arm_a + e.b.inv_inertia * arm_b * arm_b;
    Floats speed = (e.b.vx - e.a.vx) * nx + (e.b.vy - e.a.vy) * ny + e.b.spin * arm_b - e.a.spin * arm_a;
    push_along(k, e, drive<moving>(along, {speed, inv_mass}, t.pass));
    if (k.guided) guide<moving>(k, e, t.pass);
    store_bodies(t.bodies, k.a, e.a);
    store_bodies(t.bodies, k.b, e.b);
    if (moving) return;
    add_up(along);
    if (k.turn != kNoDrive) add_up(t.drives[k.turn]);
}

} // namespace

void begin_joints(const JointTables& t) noexcept {
    for (std::size_t i = 0; i < t.axis_count; ++i) begin(t, t.axes[i]);
    for (std::size_t i = 0; i < t.point_count; ++i) begin(t, t.points[i]);
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
