// Bounces, once a step, when the contacts have been solved.
#include "solver/contact_constraints.hpp"

namespace evil {
namespace {

constexpr float kRestitutionSpeed = 0.25f; // m/s: slower impacts do not bounce (SPEC C7); at zero, stacks never rest

// What is left of an impact. On the way to it, within the step, the bodies still gain speed. And as velocities change
// before positions do, a fall by substeps of h arrives slower by half a substep's gain than it should, and a rise that
// starts at v gets as high as v less that half: with both, a ball that loses nothing keeps its height for ever.
float bounce_speed(const Bounce& bounce, float closing, float gap, StepSize step) {
    float gain = bounce.gained_speed / step.dt, late = 0.5f * gain * step.h();
    float before = closing > 0.0f ? clamped(std::max(gap, 0.0f) / closing, step.dt) : 0.0f;
    return bounce.restitution * (closing + gain * before + late) + late;
}

// One contact that bounces: its bodies, its normal, and the arms across it of the two points of its lane, where the bodies
// are by now (see ContactBlock).
struct Impact {
    SolverBody &a, &b;
    ContactBlock& block;
    std::size_t lane;
    Vec2 normal;
    float arm_a[2], arm_b[2];
    float past = 0.0f; // metres: how much less discs have closed in for going past each other

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
    // What an impulse at one point changes of the speed at another.
    float response(std::size_t p, std::size_t q) const {
        return a.inv_mass + b.inv_mass + a.inv_inertia * arm_a[p] * arm_a[q] + b.inv_inertia * arm_b[p] * arm_b[q];
    }
};

Impact impact_at(Solver& solver, Place place) {
    ContactBlock& k = solver.blocks[place.block];
    std::size_t i = place.lane;
    Vec2 n{k.nx[i], k.ny[i]};
    Impact impact{solver.bodies[k.a[i]], solver.bodies[k.b[i]], k, i, n, {}, {}, 0.0f};
    Vec2 moved{impact.b.moved_x - impact.a.moved_x, impact.b.moved_y - impact.a.moved_y};
    float curve = std::max(-k.lag[i], 0.0f),
          most = 0.5f * std::min(std::abs(k.arm_n[0][i]), std::abs(k.arm_n[0][i] - k.apart_n[i]));
    float slid = clamped(dot(moved, right_of(n)), most); // as in contacts_wide.cpp
    if (curve > 0.0f) {                                  // two discs
        impact.normal = normalised(n + curve * slid * right_of(n));
        impact.past = curve * slid * slid;
        slid = 0.0f;
    }
    for (std::size_t p = 0; p < 2; ++p) {
        impact.arm_b[p] = k.arm_t[p][i] - std::max(k.lag[i], 0.0f) * slid;
        impact.arm_a[p] = impact.arm_b[p] - (k.apart_t[i] - slid);
    }
    return impact;
}

// Both points at once: pushes p and q with  k11 p + k12 q = w1,  k12 p + k22 q = w2.  One after the other, each would undo
// some of the other, and boxes that meet face to face, or near an end, would gain or lose speed. False where the points
// are too near each other to be told apart, or one would have to pull.
bool bounce_both(Impact& impact, const float (&outward)[2]) {
    float k11 = impact.response(0, 0), k22 = impact.response(1, 1), k12 = impact.response(0, 1);
    float determinant = k11 * k22 - k12 * k12;
    if (!(determinant > 1e-3f * k11 * k22)) return false;
    float w1 = outward[0] - impact.speed(0), w2 = outward[1] - impact.speed(1);
    float p = (k22 * w1 - k12 * w2) / determinant, q = (k11 * w2 - k12 * w1) / determinant;
    const ContactBlock& k = impact.block;
    if (!(p >= -k.normal_impulse[0][impact.lane] && q >= -k.normal_impulse[1][impact.lane])) return false;
    impact.push(0, p);
    impact.push(1, q);
    return true;
}

} // namespace

// (4.8): the solver has brought the closing speed to 0, this adds e times that of the impact outwards. The next step's
// contacts do not start from a bounce, so it is added to the total alone.
void apply_restitution(Solver& solver, const Contacts& contacts, StepSize step) {
    for (const Bounce& bounce : solver.bounces) {
        Place place = solver.colouring.places[bounce.edge];
        Impact impact = impact_at(solver, place);
        const ContactBlock& k = impact.block;
        std::uint8_t count = contacts.rows[solver.edges[bounce.edge].contact].count;
        bool bounces[2] = {};
        float outward[2] = {};
        for (std::uint8_t p = 0; p < count; ++p) {
            float closing = solver.sources[place.block].closing_speed[p][place.lane];
            bounces[p] = k.total_impulse[p][place.lane] != 0.0f && closing - bounce.gained_speed > kRestitutionSpeed;
            outward[p] =
                bounce_speed(bounce, std::max(closing - impact.past / step.dt, 0.0f), k.gap[p][place.lane], step);
        }
        if (bounces[0] && bounces[1] && bounce_both(impact, outward)) continue;
        for (std::size_t p = 0; p < 2; ++p) {
            if (!bounces[p]) continue;
            float inv_mass = impact.response(p, p), wanted = outward[p] - impact.speed(p);
            impact.push(p, std::max(inv_mass > 0.0f ? wanted / inv_mass : 0.0f, -k.normal_impulse[p][place.lane]));
        }
    }
}

} // namespace evil
