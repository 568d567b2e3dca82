// Bounces, once a step, when the contacts have been solved.
#include "solver/contact_constraints.hpp"

namespace evil {
namespace {

constexpr float kFar = 1e15f; // metres

constexpr float kRestitutionSpeed = 0.25f; // m/s: slower impacts do not bounce (SPEC C7); at zero, stacks never rest

// What is left of an impact. On the way to it, within the step, the bodies still gain speed. And as velocities change
// before positions do, a fall by substeps of h arrives slower by half a substep's gain than it should, and a rise that
// starts at v gets as high as v less that half: with both, a ball that loses nothing keeps its height for ever.
struct Outcome { // outward
    float speed = 0.0f;
    float gathered = 0.0f; // of it, what acceleration gives and takes; the impulse of the impact gives back the rest
};

Outcome outcome_of(const Bounce& bounce, float closing, float gap, StepSize step) {
    float gain = bounce.gained_speed / step.dt, late = 0.5f * gain * step.h();
    float before = closing > 0.0f ? clamped(std::max(gap, 0.0f) / closing, step.dt) : 0.0f;
    return {bounce.restitution * (closing + gain * before + late) + late,
            bounce.restitution * (late - gain * (step.dt - before)) + late};
}

// One contact that bounces: its bodies, its normal, and the arms across it of the two points of its lane, where the bodies
// are by now (see ContactBlock).
struct Impact {
    SolverBody &a, &b;
    ContactBlock& block;
    std::size_t lane;
    Vec2 normal;
    float arm_a[2] = {}, arm_b[2] = {};
    float past = 0.0f; // metres: how much less discs have closed in for going past each other
    float restitution = 0.0f;
    bool bounces[2] = {};
    Outcome outcome[2] = {};

    float speed(std::size_t p) const {
        return dot(Vec2{b.vx - a.vx, b.vy - a.vy}, normal) + b.spin * arm_b[p] - a.spin * arm_a[p];
    }
    void push(std::size_t p, float impulse) { // (4.9), (4.10)
        block.total_impulse[p][lane] += impulse;
        a.vx -= a.inv_mass * impulse * normal.x;
        a.vy -= a.inv_mass * impulse * normal.y;
        a.spin -= a.inv_inertia * impulse * arm_a[p];
        b.vx += b.inv_mass * impulse * normal.x;
        b.vy += b.inv_mass * impulse * normal.y;
        b.spin += b.inv_inertia * impulse * arm_b[p];
    }
    float least(std::size_t p) const { return -block.normal_impulse[p][lane]; }
    float most(std::size_t p) const {
        float inv_mass = response(p, p), gathered = inv_mass > 0.0f ? outcome[p].gathered / inv_mass : 0.0f;
        return std::max(restitution * block.total_impulse[p][lane] + gathered, 0.0f);
    }
    // What an impulse at one point changes of the speed at another.
    float response(std::size_t p, std::size_t q) const {
        return a.inv_mass + b.inv_mass + a.inv_inertia * arm_a[p] * arm_a[q] + b.inv_inertia * arm_b[p] * arm_b[q];
    }
};

Impact impact_at(Solver& solver, Place place) {
    ContactBlock& k = solver.blocks[place.block];
    std::size_t i = place.lane;
    Vec2 n{k.nx[i], k.ny[i]};
    Impact impact{solver.bodies[k.a[i] / kBodyFloats], solver.bodies[k.b[i] / kBodyFloats], k, i, n};
    Vec2 moved{impact.b.moved_x - impact.a.moved_x, impact.b.moved_y - impact.a.moved_y};
    float curve = std::max(-k.lag[i], 0.0f); // all as in contacts_wide.cpp
    float most_b = 0.5f * std::abs(k.arm_n[0][i]), most_a = 0.5f * std::abs(k.arm_n[0][i] - k.apart_n[i]);
    if (impact.a.inv_mass == 0.0f) most_a = kFar;
    float slid = clamped(dot(moved, right_of(n)), most_a + most_b);
    float lag = clamped(std::max(k.lag[i], 0.0f) * slid, most_b);
    lag = std::clamp(lag, slid - most_a, slid + most_a);
    if (curve > 0.0f) { // two discs
        impact.normal = normalised(n + curve * slid * right_of(n));
        impact.past = curve * slid * slid;
        slid = lag = 0.0f;
    }
    for (std::size_t p = 0; p < 2; ++p) {
        impact.arm_b[p] = k.arm_t[p][i] - lag;
        impact.arm_a[p] = impact.arm_b[p] - (k.apart_t[i] - slid);
    }
    return impact;
}

// Pushes at the points that bounce that give them these speeds outwards. Both at once: with  k11 p + k12 q = w1,
// k12 p + k22 q = w2; one after the other, each would undo some of the other, and boxes that meet face to face, or near an
// end, would gain or lose speed. False where the points are too near each other to be told apart, or one would have to pull.
bool solve_both(const Impact& impact, const float (&wanted)[2], float (&push)[2]) {
    float k11 = impact.response(0, 0), k22 = impact.response(1, 1), k12 = impact.response(0, 1);
    float determinant = k11 * k22 - k12 * k12;
    if (!impact.bounces[0] || !impact.bounces[1] || !(determinant > 1e-3f * k11 * k22)) return false;
    float w1 = wanted[0] - impact.speed(0), w2 = wanted[1] - impact.speed(1);
    push[0] = (k22 * w1 - k12 * w2) / determinant;
    push[1] = (k11 * w2 - k12 * w1) / determinant;
    return push[0] >= impact.least(0) && push[1] >= impact.least(1);
}

void push_one(Impact& impact, std::size_t p, float wanted, float most) {
    float inv_mass = impact.response(p, p), push = inv_mass > 0.0f ? (wanted - impact.speed(p)) / inv_mass : 0.0f;
    impact.push(p, std::max(std::min(push, most), impact.least(p)));
}

// What the step has not stopped, as it would only have met at its end, is stopped now.
void stop(Impact& impact) {
    float wanted[2] = {std::max(impact.speed(0), 0.0f), std::max(impact.speed(1), 0.0f)}, push[2];
    if (solve_both(impact, wanted, push)) {
        impact.push(0, push[0]);
        impact.push(1, push[1]);
        return;
    }
    for (std::size_t p = 0; p < 2; ++p)
        if (impact.bounces[p] && impact.speed(p) < 0.0f) push_one(impact, p, 0.0f, kMaxForce);
}

// Poisson's hypothesis: an impact gives back no more than its share of the impulse that stopped it. Where a body meets
// several at once, or turns on its way, speeds alone would ask for more than that, and energy would grow.
void bounce(Impact& impact) {
    float wanted[2] = {impact.outcome[0].speed, impact.outcome[1].speed}, push[2];
    float most[2] = {impact.most(0), impact.most(1)};
    if (solve_both(impact, wanted, push)) {
        float sum = push[0] + push[1], both = most[0] + most[1], share = sum > both ? both / sum : 1.0f;
        impact.push(0, share * push[0]);
        impact.push(1, share * push[1]);
        return;
    }
    for (std::size_t p = 0; p < 2; ++p)
        if (impact.bounces[p]) push_one(impact, p, wanted[p], most[p]);
}

Impact impact_of(Solver& solver, const Bounce& bounce, const Contacts& contacts, StepSize step) {
    Place place = solver.colouring.places[bounce.edge];
    Impact impact = impact_at(solver, place);
    impact.restitution = bounce.restitution;
    std::uint8_t count = contacts.rows[solver.edges[bounce.edge].contact].count;
    for (std::uint8_t p = 0; p < count; ++p) {
        float closing = solver.sources[place.block].closing_speed[p][place.lane];
        impact.bounces[p] =
            impact.block.total_impulse[p][place.lane] != 0.0f && closing - bounce.gained_speed > kRestitutionSpeed;
        closing = std::max(closing - impact.past / step.dt, 0.0f);
        impact.outcome[p] = outcome_of(bounce, closing, impact.block.gap[p][place.lane], step);
    }
    return impact;
}

} // namespace

// (4.8): the solver has brought the closing speed to 0, this adds e times that of the impact outwards. The next step's
// contacts do not start from a bounce, so it is added to the total alone.
void apply_restitution(Solver& solver, const Contacts& contacts, StepSize step) {
    for (const Bounce& each : solver.bounces) {
        Impact impact = impact_of(solver, each, contacts, step);
        stop(impact);
    }
    for (const Bounce& each : solver.bounces) {
        Impact impact = impact_of(solver, each, contacts, step);
        bounce(impact);
    }
}

} // namespace evil
