#pragma once
// For joints_wide.cpp alone: eight joints' bodies, and the springs, motors and limits along one coordinate of each.
#include "math/wide_rows.hpp"
#include "solver/joints/joints_wide.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr float kMostImpulse = 1e30f; // newton seconds: finite, whatever came in

struct Body {
    Floats vx, vy, spin, inv_mass, moved_x, moved_y, turned, inv_inertia;
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

// Half of what turning at `spin` does to the speed of an arm's end within the substep: the end goes round, and so falls
// behind the straight line by spin^2 h / 2 for each metre of arm. Held to turns of a radian, where a line says nothing.
EVIL_INLINE Floats falling_behind(Floats spin, Floats h, Floats inv_h) {
    return min(0.5f * h * spin * spin, 0.5f * inv_h);
}

// ---- drives ----

EVIL_INLINE Floats sum_of(const DriveBlock& d) {
    return (load(d.spring) + load(d.motor)) + (load(d.to_lower) - load(d.to_upper));
}

struct Speed { // of a coordinate, and what a unit impulse changes of it
    Floats now, inv_mass;
};

template <bool moving> EVIL_INLINE Floats pull_spring(DriveBlock& d, Speed& v, Floats mass, Floats bend) {
    const SoftLanes& s = d.soft;
    Floats before = load(d.spring), error = load(d.value) - load(d.rest), speed = v.now;
    if (moving) speed += load(d.held) * bend;
    Floats keep = load(moving ? s.keep : s.calm_keep), pull = load(moving ? s.pull : s.calm_pull);
    Floats leak = load(moving ? s.leak : s.calm_leak), most = load(s.most);
    Floats after = bounded(before - mass * (keep * speed + pull * error) - leak * before, most);
    store(d.spring, after);
    v.now += v.inv_mass * (after - before);
    return after - before;
}

// A motor wants no further than the limits: a strong one that went on would push ever harder against them.
EVIL_INLINE Floats run_motor(DriveBlock& d, Speed& v, Floats value, Floats mass, const JointPass& pass) {
    Floats zero = 0.0f, before = load(d.motor), inv_h = pass.inv_h;
    Floats back = min(load(d.lower) - value, zero), ahead = max(load(d.upper) - value, zero);
    Floats wanted = clamp(load(d.speed), inv_h * back, inv_h * ahead);
    Floats after = bounded(before - mass * (v.now - wanted), load(d.motor_most));
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

// Springs go by where the coordinate was when the substep began, in both passes: so their work is that of the path gone.
// Limits go by where it is. `bend`: what the way round does to the speed beyond a straight line's.
template <bool moving>
EVIL_INLINE Floats drive(DriveBlock& d, Speed v, Floats value, Floats bend, const JointPass& pass) {
    Floats mass = load(d.mass);
    Floats impulse = pull_spring<moving>(d, v, mass, bend);
    impulse += run_motor(d, v, value, mass, pass);
    Floats opening = v.now;
    if (moving) opening += bend;
    Floats up = push_from_limit<moving>(d.to_lower, value - load(d.lower), opening, mass, pass);
    opening += v.inv_mass * up;
    Floats down = push_from_limit<moving>(d.to_upper, load(d.upper) - value, -opening, mass, pass);
    if (!moving) {
        store(d.value, value);
        store(d.total, load(d.total) + sum_of(d));
    }
    return impulse + (up - down);
}

EVIL_INLINE void spin_ends(Ends& e, Floats impulse) {
    e.a.spin -= e.a.inv_inertia * impulse;
    e.b.spin += e.b.inv_inertia * impulse;
}

EVIL_INLINE void begin_turn(DriveBlock& d, const Ends& e, Floats turned) {
    store(d.value, load(d.base) + turned);
    store(d.mass, inverse(e.a.inv_inertia + e.b.inv_inertia));
}

template <bool moving> EVIL_INLINE void drive_turn(DriveBlock& d, Ends& e, Floats turned, const JointPass& pass) {
    Speed v{e.b.spin - e.a.spin, e.a.inv_inertia + e.b.inv_inertia};
    Floats value = moving ? load(d.value) : load(d.base) + turned;
    spin_ends(e, drive<moving>(d, v, value, 0.0f, pass));
}

} // namespace
} // namespace evil::EVIL_ISA
