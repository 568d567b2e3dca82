#include "solver/contact_constraints.hpp"

namespace evil {
namespace {

constexpr float kContactHertz = 30.0f;   // stiffness of a soft contact; at most a quarter of the substep rate is stable
constexpr float kContactDamping = 10.0f; // damping ratio: overlap is pushed out without a bounce
constexpr float kRestitutionSpeed = 0.25f; // m/s: slower impacts do not bounce (SPEC C7); at zero, stacks never rest

// Catto, "Soft Constraints", GDC 2011: a spring of that frequency and damping ratio, integrated implicitly over h.
void soften(ContactBlock& block, float hertz, float h) {
    float omega = static_cast<float>(2.0 * kPi) * hertz;
    float a1 = 2.0f * kContactDamping + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
    block.bias_rate = omega / a1;
    block.mass_scale = a2 * a3;
    block.impulse_scale = a3;
}

float inverse(float k) { return k > 0.0f ? 1.0f / k : 0.0f; }

Vec2 acceleration_of(const Bodies& bodies, std::uint32_t slot) {
    const Body& b = bodies.rows[slot];
    return b.kind == BodyKind::dynamic ? b.acceleration : Vec2{};
}

// The pair of a contact in its own frame: along n, and along t, which is n turned right.
struct Frame {
    Vec2 n, t;
    float along_n(Vec2 v) const { return dot(v, n); }
    float along_t(Vec2 v) const { return dot(v, t); }
};

struct Speeds { // relative velocity of the bodies, and their spins
    float n, spin_a, spin_b;
};

Speeds speeds(const SolverBody& a, const SolverBody& b, const Frame& frame) {
    return {frame.along_n({b.vx - a.vx, b.vy - a.vy}), a.spin, b.spin};
}

float normal_speed(const Speeds& v, const BlockPoint& q, std::size_t lane) {
    return v.n + v.spin_b * q.arm_bt[lane] - v.spin_a * q.arm_at[lane];
}

// The denominator of (4.8): what one newton second changes of the relative speed, by the arms across its direction.
float effective_mass(const SolverBody& a, const SolverBody& b, float across_a, float across_b) {
    return inverse(a.inv_mass + b.inv_mass + a.inv_inertia * across_a * across_a + b.inv_inertia * across_b * across_b);
}

void fill_point(BlockPoint& q, std::size_t i, const ManifoldPoint& p, const Frame& frame, const SolverBody& a,
                const SolverBody& b) {
    q.arm_an[i] = frame.along_n(p.anchor_a);
    q.arm_at[i] = frame.along_t(p.anchor_a);
    q.arm_bn[i] = frame.along_n(p.anchor_b);
    q.arm_bt[i] = frame.along_t(p.anchor_b);
    q.base[i] = p.separation - (q.arm_bn[i] - q.arm_an[i]);
    q.normal_mass[i] = effective_mass(a, b, q.arm_at[i], q.arm_bt[i]);
    q.tangent_mass[i] = effective_mass(a, b, q.arm_an[i], q.arm_bn[i]);
    q.normal_impulse[i] = p.normal_impulse;
    q.tangent_impulse[i] = p.tangent_impulse;
}

// Which contacts are solved, by whom, and what they did before.
void find_edges(Solver& solver, const Bodies& bodies, const Contacts& contacts, float dt) {
    solver.edges.clear();
    solver.bounces.clear();
    for (std::uint32_t row = 0; row < contacts.rows.size(); ++row) {
        const Contact& c = contacts.rows[row];
        std::uint32_t a = solver.number_of[c.body_a], b = solver.number_of[c.body_b];
        if (c.count == 0 || (a == 0 && b == 0)) continue;
        bool a_moves = solver.bodies[a].inv_mass > 0.0f, b_moves = solver.bodies[b].inv_mass > 0.0f;
        bool wall = !(a_moves && b_moves);
        solver.edges.push_back({wall && b_moves ? b : a, b, wall});
        Vec2 gained = acceleration_of(bodies, c.body_b) - acceleration_of(bodies, c.body_a);
        solver.bounces.push_back({row, {}, c.restitution, {}, {}, std::max(0.0f, -dt * dot(gained, c.normal))});
    }
}

void fill_lane(Solver& solver, Bounce& bounce, const Contact& c) {
    ContactBlock& block = solver.blocks[bounce.place.block];
    std::size_t i = bounce.place.lane;
    block.a[i] = solver.number_of[c.body_a];
    block.b[i] = solver.number_of[c.body_b];
    const SolverBody &a = solver.bodies[block.a[i]], &b = solver.bodies[block.b[i]];
    Frame frame{c.normal, right_of(c.normal)};
    block.nx[i] = c.normal.x;
    block.ny[i] = c.normal.y;
    block.friction[i] = c.friction;
    block.surface_speed[i] = c.surface_speed;
    Speeds v = speeds(a, b, frame);
    for (std::uint8_t p = 0; p < c.count; ++p) {
        fill_point(block.points[p], i, c.points[p], frame, a, b);
        bounce.closing_speed[p] = -normal_speed(v, block.points[p], i);
        bounce.gap[p] = c.points[p].separation;
    }
}

// What is left of an impact. On the way to it, within the step, the bodies still gain speed. And as velocities change
// before positions do, a fall by substeps of h arrives slower by half a substep's gain than it should, and a rise that
// starts at v gets as high as v less that half: with both, a ball that loses nothing keeps its height for ever.
float bounce_speed(const Bounce& bounce, float closing, float gap, StepSize step) {
    float gain = bounce.gained_speed / step.dt, late = 0.5f * gain * step.h();
    float before = closing > 0.0f ? clamped(std::max(gap, 0.0f) / closing, step.dt) : 0.0f;
    return bounce.restitution * (closing + gain * before + late) + late;
}

} // namespace

void fill_blocks(Solver& solver, const Bodies& bodies, const Contacts& contacts, StepSize step) {
    find_edges(solver, bodies, contacts, step.dt);
    colour(solver.colouring, solver.edges, static_cast<std::uint32_t>(solver.bodies.size()), kBlockLanes);
    solver.blocks.assign(solver.colouring.blocks, ContactBlock{}); // lanes without a contact have no mass
    float h = step.h(), hertz = std::min(kContactHertz, 0.25f / h);
    for (std::uint32_t i = 0; i < solver.colouring.blocks; ++i)
        soften(solver.blocks[i], i >= solver.colouring.wall_blocks_from ? 2.0f * hertz : hertz, h);
    for (std::size_t i = 0; i < solver.bounces.size(); ++i) {
        solver.bounces[i].place = solver.colouring.places[i];
        fill_lane(solver, solver.bounces[i], contacts.rows[solver.bounces[i].contact]);
    }
}

namespace {

// One contact that bounces: its bodies, its frame, and the two points of its lane.
struct Impact {
    SolverBody &a, &b;
    Vec2 normal;
    ContactBlock& block;
    std::size_t lane;

    float speed(std::size_t p) const {
        return normal_speed(speeds(a, b, Frame{normal, right_of(normal)}), block.points[p], lane);
    }
    void push(std::size_t p, float impulse) { // (4.9), (4.10)
        BlockPoint& q = block.points[p];
        q.total_impulse[lane] += impulse;
        a.vx -= a.inv_mass * impulse * normal.x;
        a.vy -= a.inv_mass * impulse * normal.y;
        a.spin -= a.inv_inertia * impulse * q.arm_at[lane];
        b.vx += b.inv_mass * impulse * normal.x;
        b.vy += b.inv_mass * impulse * normal.y;
        b.spin += b.inv_inertia * impulse * q.arm_bt[lane];
    }
};

// Both points at once: pushes p and q with  k11 p + k12 q = w1,  k12 p + k22 q = w2.  One after the other, each would undo
// some of the other, and boxes that meet face to face, or near an end, would gain or lose speed. False where the points
// are too near each other to be told apart, or one would have to pull.
bool bounce_both(Impact& impact, const float (&outward)[2]) {
    const std::size_t i = impact.lane;
    BlockPoint &first = impact.block.points[0], &second = impact.block.points[1];
    const SolverBody &a = impact.a, &b = impact.b;
    float k11 = inverse(first.normal_mass[i]), k22 = inverse(second.normal_mass[i]);
    float k12 = a.inv_mass + b.inv_mass + a.inv_inertia * first.arm_at[i] * second.arm_at[i] +
                b.inv_inertia * first.arm_bt[i] * second.arm_bt[i];
    float determinant = k11 * k22 - k12 * k12;
    if (!(determinant > 1e-3f * k11 * k22)) return false;
    float w1 = outward[0] - impact.speed(0), w2 = outward[1] - impact.speed(1);
    float p = (k22 * w1 - k12 * w2) / determinant, q = (k11 * w2 - k12 * w1) / determinant;
    if (!(p >= -first.normal_impulse[i] && q >= -second.normal_impulse[i])) return false;
    impact.push(0, p);
    impact.push(1, q);
    return true;
}

} // namespace

// (4.8): the solver has brought the closing speed to 0, this adds e times that of the impact outwards. The next step's
// contacts do not start from a bounce, so it is added to the total alone.
void apply_restitution(Solver& solver, StepSize step) {
    for (const Bounce& bounce : solver.bounces) {
        if (bounce.restitution == 0.0f) continue;
        ContactBlock& block = solver.blocks[bounce.place.block];
        std::size_t i = bounce.place.lane;
        Impact impact{solver.bodies[block.a[i]], solver.bodies[block.b[i]], {block.nx[i], block.ny[i]}, block, i};
        bool bounces[2];
        float outward[2];
        for (std::size_t p = 0; p < 2; ++p) {
            float closing = bounce.closing_speed[p];
            bounces[p] = block.points[p].total_impulse[i] != 0.0f && closing - bounce.gained_speed > kRestitutionSpeed;
            outward[p] = bounce_speed(bounce, closing, bounce.gap[p], step);
        }
        if (bounces[0] && bounces[1] && bounce_both(impact, outward)) continue;
        for (std::size_t p = 0; p < 2; ++p) {
            if (!bounces[p]) continue;
            const BlockPoint& q = block.points[p];
            impact.push(p, std::max(q.normal_mass[i] * (outward[p] - impact.speed(p)), -q.normal_impulse[i]));
        }
    }
}

void store_impulses(const Solver& solver, Contacts& contacts) {
    for (const Bounce& bounce : solver.bounces) {
        Contact& c = contacts.rows[bounce.contact];
        const ContactBlock& block = solver.blocks[bounce.place.block];
        for (std::uint8_t p = 0; p < c.count; ++p) {
            const BlockPoint& q = block.points[p];
            c.points[p].normal_impulse = clamped(q.normal_impulse[bounce.place.lane], kMaxForce);
            c.points[p].tangent_impulse = clamped(q.tangent_impulse[bounce.place.lane], kMaxForce);
            c.points[p].total_impulse = clamped(q.total_impulse[bounce.place.lane], kMaxForce);
            c.points[p].closing_speed = clamped(bounce.closing_speed[p], kMaxForce);
        }
    }
}

} // namespace evil
