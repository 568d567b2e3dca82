#include "solver/joints/joint_solver.hpp"
#include "solver/joints/chain_finding.hpp"
#include "solver/joints/joints_wide.hpp"
#include "solver/joints/lone_joints.hpp"
#include "solver/joints/softness.hpp"
#include "solver/solver.hpp"

namespace evil {
namespace {

// A joint is mended at the fastest rate that stays calm: within a few substeps, and stiffer the more of them there are.
constexpr float kHertzOfSubsteps = 0.25f;
constexpr float kJointDamping = 2.0f; // damping ratio: an error goes away without swinging
// Joints in a row are solved as one and can be ten times as stiff; at thirty times, boxes twenty times as heavy as the
// planks of a bridge would fall through it.
constexpr float kChainHertzOfSubsteps = 0.79f, kChainDamping = 6.3f;

struct Arms { // of a joint when the step begins: from the centres of mass, and from one of those to the other
    Vec2 a, b, gap;
    Vec2 between() const { return gap + b - a; }
};

Arms arms_of(const Joint& j, const Body& a, const Body& b) {
    return {arm_of(a, j.anchor_a), arm_of(b, j.anchor_b), b.centre - a.centre};
}

// ---- drives ----

// A spring of a drive; `mass` is what it moves: 1 / (what a unit impulse changes of its speed).
Softness softness_of(const JointDrive& d, float inv_mass, float h) {
    if (d.frequency > 0.0f) {
        float omega = static_cast<float>(2.0 * kPi) * d.frequency;
        return spring_softness(omega * omega, 2.0f * d.damping_ratio * omega, h);
    }
    return spring_softness(clamped(d.stiffness * inv_mass, kMaxForce), clamped(d.damping * inv_mass, kMaxForce), h);
}

bool sprung(const JointDrive& d) { return d.frequency > 0.0f || d.stiffness > 0.0f || d.damping > 0.0f; }
bool driven(const JointDrive& d) { return d.held || d.limited || d.motor || sprung(d); }

void fill_soft(SoftLanes& s, std::size_t i, const JointDrive& d, float inv_mass, const JointPass& pass) {
    Softness moving{0, 0, 0}, calm{0, 0, 0};
    if (d.held) {
        moving = pass.stiff;
        calm = {1, 0, 0};
    } else if (sprung(d)) {
        moving = calm = softness_of(d, inv_mass, pass.h);
    }
    s.keep[i] = moving.keep;
    s.pull[i] = moving.pull;
    s.leak[i] = moving.leak;
    s.calm_keep[i] = calm.keep;
    s.calm_pull[i] = calm.pull;
    s.calm_leak[i] = calm.leak;
    s.most[i] = std::min(d.spring_most, kNoLimit) * std::min(pass.h, 1.0f);
}

void fill_drive(DriveBlock& k, std::size_t i, const JointDrive& d, float base, float inv_mass, const JointPass& pass) {
    fill_soft(k.soft, i, d, inv_mass, pass);
    k.base[i] = k.value[i] = base;
    k.rest[i] = d.rest;
    k.held[i] = d.held ? 1.0f : 0.0f;
    k.lower[i] = d.limited ? d.lower : -kNoLimit;
    k.upper[i] = d.limited ? d.upper : kNoLimit;
    k.speed[i] = d.speed;
    k.motor_most[i] = d.motor ? d.most * pass.h : 0.0f;
    k.spring[i] = d.held || sprung(d) ? d.spring_impulse : 0.0f;
    k.motor[i] = d.motor ? d.motor_impulse : 0.0f;
    k.to_lower[i] = d.limited ? d.lower_impulse : 0.0f;
    k.to_upper[i] = d.limited ? d.upper_impulse : 0.0f;
}

DriveBlock& own_drive(std::vector<DriveBlock>& drives, std::uint32_t& of_block) {
    if (of_block == kNoDrive) {
        of_block = static_cast<std::uint32_t>(drives.size());
        DriveBlock& k = drives.emplace_back(); // lanes without a drive do nothing
        for (std::size_t i = 0; i < 8; ++i) {
            k.lower[i] = -kNoLimit;
            k.upper[i] = kNoLimit;
        }
    }
    return drives[of_block];
}

SoftLanes& own_softness(JointSolver& js, std::uint32_t& of_block) {
    if (of_block == kNoDrive) {
        of_block = static_cast<std::uint32_t>(js.softs.size());
        SoftLanes& s = js.softs.emplace_back(); // lanes that are stiff all the same
        for (std::size_t i = 0; i < 8; ++i) {
            s.keep[i] = js.pass.stiff.keep;
            s.pull[i] = js.pass.stiff.pull;
            s.leak[i] = js.pass.stiff.leak;
            s.calm_keep[i] = 1.0f;
            s.most[i] = kNoLimit;
        }
    }
    return js.softs[of_block];
}

// ---- lanes ----

struct Lane {
    const Joint& joint;
    const Body &a, &b;
    const SolverBody &row_a, &row_b;
    std::size_t i;
    bool in_chain;
};

float turned_between(const Joint& j, const Body& a, const Body& b) {
    return static_cast<float>(b.angle - a.angle - j.reference);
}

void fill_point(JointSolver& js, PointBlock& k, const Lane& l) {
    Arms arms = arms_of(l.joint, l.a, l.b);
    std::size_t i = l.i;
    k.start_ax[i] = arms.a.x;
    k.start_ay[i] = arms.a.y;
    k.start_bx[i] = arms.b.x;
    k.start_by[i] = arms.b.y;
    k.gap_x[i] = arms.gap.x;
    k.gap_y[i] = arms.gap.y;
    k.impulse_x[i] = l.joint.impulse.x;
    k.impulse_y[i] = l.joint.impulse.y;
    if (driven(l.joint.turn))
        fill_drive(own_drive(js.drives, k.turn), i, l.joint.turn, turned_between(l.joint, l.a, l.b),
                   l.row_a.inv_inertia + l.row_b.inv_inertia, js.pass);
    if (l.in_chain) // which holds the point: here it only turns
        own_softness(js, k.soft).most[i] = k.impulse_x[i] = k.impulse_y[i] = 0.0f;
    else if (!l.joint.along
                  .held) // a soft weld, or a motor's pull: of what mass does not matter, as its frequency is given
        fill_soft(own_softness(js, k.soft), i, l.joint.along, l.row_a.inv_mass + l.row_b.inv_mass, js.pass);
    else if (l.joint.along.spring_most < kNoLimit)
        own_softness(js, k.soft).most[i] = l.joint.along.spring_most * js.pass.h;
}

void fill_axis(JointSolver& js, AxisBlock& k, const Lane& l) {
    Arms arms = arms_of(l.joint, l.a, l.b);
    std::size_t i = l.i;
    bool fixed = is_axial(l.joint.kind);
    Vec2 axis = rotate(l.a.pose.q, l.joint.axis), d = arms.between();
    float size = length(d);
    Vec2 n = fixed || !(size > 0.0f) ? axis : (1.0f / size) * d;
    k.start_ax[i] = arms.a.x;
    k.start_ay[i] = arms.a.y;
    k.start_bx[i] = arms.b.x;
    k.start_by[i] = arms.b.y;
    k.gap_x[i] = arms.gap.x;
    k.gap_y[i] = arms.gap.y;
    k.axis_x[i] = axis.x;
    k.axis_y[i] = axis.y;
    k.fixed[i] = fixed ? kFixedAxis : 0;
    k.locked[i] = l.joint.kind == JointKind::slider ? kFixedAxis : 0;
    k.guided |= fixed ? 1u : 0u;
    k.base_turn[i] = turned_between(l.joint, l.a, l.b);
    k.impulse_side[i] = l.joint.impulse.x;
    k.impulse_turn[i] = l.joint.impulse.y;
    float arm_a = cross(arms.a + d, n), arm_b = cross(arms.b, n);
    float inv_mass =
        l.row_a.inv_mass + l.row_b.inv_mass + l.row_a.inv_inertia * arm_a * arm_a + l.row_b.inv_inertia * arm_b * arm_b;
    fill_drive(own_drive(js.drives, k.along), i, l.joint.along, dot(d, n), inv_mass, js.pass);
    if (driven(l.joint.turn))
        fill_drive(own_drive(js.drives, k.turn), i, l.joint.turn, k.base_turn[i],
                   l.row_a.inv_inertia + l.row_b.inv_inertia, js.pass);
}

void find_colours(JointColours& colours, std::span<const SolverBody> bodies, std::span<const SolvedJoint> list) {
    bool same = colours.edges.size() == list.size();
    colours.edges.resize(list.size());
    for (std::size_t n = 0; n < list.size(); ++n) {
        const SolvedJoint& s = list[n];
        bool a_moves = bodies[s.a].inv_mass > 0.0f, b_moves = bodies[s.b].inv_mass > 0.0f;
        Edge edge{a_moves ? s.a : s.b, s.b, a_moves && b_moves ? 0u : Edge::kWall};
        same = same && edge == colours.edges[n];
        colours.edges[n] = edge;
    }
    if (!same) colour(colours.colouring, colours.edges, static_cast<std::uint32_t>(bodies.size()), kBlockLanes);
}

// Joints lie apart from each other, and so do their bodies: the memory is told of them a few ahead.
constexpr std::size_t kAhead = 6;

template <class T> void foretell(const T& row) {
    for (std::size_t at = 0; at < sizeof(T); at += 64) __builtin_prefetch(reinterpret_cast<const char*>(&row) + at);
}

template <class Block, class Fill>
void fill_blocks(Solver& solver, const Bodies& bodies, const Joints& joints, std::vector<SolvedJoint>& list,
                 JointColours& colours, std::vector<Block>& blocks, Fill&& fill) {
    JointSolver& js = solver.joints;
    find_colours(colours, solver.bodies, list);
    blocks.assign(list.empty() ? 0 : colours.colouring.blocks, Block{});
    for (std::size_t n = 0; n < list.size(); ++n) {
        if (n + kAhead < list.size()) foretell(joints.rows[list[n + kAhead].joint]);
        SolvedJoint& s = list[n];
        s.place = colours.colouring.places[n];
        Block& block = blocks[s.place.block];
        const Joint& j = joints.rows[s.joint];
        block.a[s.place.lane] = s.a;
        block.b[s.place.lane] = s.b;
        fill(js, block,
             Lane{j, bodies.rows[j.body_a], bodies.rows[j.body_b], solver.bodies[s.a], solver.bodies[s.b], s.place.lane,
                  s.in_chain});
    }
}

// Soft welds and a motor's pull are no links.
bool is_link(const Joint& j) { return j.along.held && !(j.along.spring_most < kNoLimit); }

// Which joints are solved, and where.
void sort_joints(Solver& solver, const Bodies& bodies, const Joints& joints) {
    JointSolver& js = solver.joints;
    js.at_points.clear();
    js.at_axes.clear();
    js.alone.clear();
    for (std::uint32_t slot = 0; slot < joints.slots.size(); ++slot) {
        if (!joints.slots.taken(slot)) continue;
        const Joint& j = joints.rows[slot];
        std::uint32_t a = solver.number_of[j.body_a], b = solver.number_of[j.body_b];
        if (!(solver.bodies[a].inv_mass > 0.0f || solver.bodies[b].inv_mass > 0.0f)) continue;
        if (j.kind == JointKind::gear || j.kind == JointKind::pulley)
            js.alone.push_back(lone_joint(j, slot, a, b, bodies));
        else if (is_axial(j.kind) || j.kind == JointKind::distance || j.kind == JointKind::rope)
            js.at_axes.push_back({slot, a, b, {}});
        else
            js.at_points.push_back({slot, a, b, {}, is_link(j)});
    }
}

JointTables tables(Solver& solver) {
    JointSolver& js = solver.joints;
    return {solver.bodies.data(), js.points.data(), js.points.size(), js.axes.data(),
            js.axes.size(),       js.drives.data(), js.softs.data(),  js.pass};
}

// ---- at the end of the step ----

float finite_impulse(float impulse) { return impulse > -kMaxForce && impulse < kMaxForce ? impulse : 0.0f; }

// Impulses into the row; the sum of what it did in the step.
float store_drive(JointDrive& d, const DriveBlock& k, std::size_t i) {
    d.spring_impulse = finite_impulse(k.spring[i]);
    d.motor_impulse = finite_impulse(k.motor[i]);
    d.lower_impulse = finite_impulse(k.to_lower[i]);
    d.upper_impulse = finite_impulse(k.to_upper[i]);
    return k.total[i];
}

} // namespace

void prepare_joints(Solver& solver, const Bodies& bodies, const Joints& joints, StepSize step) {
    JointSolver& js = solver.joints;
    sort_joints(solver, bodies, joints);
    find_chains(js, solver.bodies, bodies, joints);
    std::erase_if(js.at_points, [&](const SolvedJoint& s) { return s.in_chain && !driven(joints.rows[s.joint].turn); });
    float h = step.h();
    js.pass = {h, 1.0f / h, stiff_softness(kHertzOfSubsteps / h, kJointDamping, h),
               stiff_softness(kChainHertzOfSubsteps / h, kChainDamping, h)};
    js.fresh = true;
    js.drives.clear();
    js.softs.clear();
    fill_blocks(solver, bodies, joints, js.at_points, js.point_colours, js.points, fill_point);
    fill_blocks(solver, bodies, joints, js.at_axes, js.axis_colours, js.axes, fill_axis);
}

void warm_start_joints(Solver& solver, InstructionSet set) {
    if (solver.joints.fresh) {
        begin_lone(solver.joints.alone, solver.bodies);
        begin_chains(solver.joints.links, solver.bodies, solver.joints.pass);
        EVIL_PICK(set, begin_joints)(tables(solver));
        solver.joints.fresh = false;
    }
    warm_lone(solver.joints.alone, solver.bodies);
    warm_chains(solver.joints.links, solver.bodies);
    EVIL_PICK(set, warm_joints)(tables(solver));
}

void solve_joints(Solver& solver, InstructionSet set) {
    move_lone(solver.joints.alone, solver.bodies, solver.joints.pass);
    EVIL_PICK(set, move_joints)(tables(solver));
    move_chains(solver.joints.links, solver.bodies, solver.joints.pass);
}

void relax_joints(Solver& solver, InstructionSet set) {
    calm_lone(solver.joints.alone, solver.bodies);
    EVIL_PICK(set, calm_joints)(tables(solver));
    calm_chains(solver.joints.links, solver.bodies, solver.joints.pass);
}

void store_joints(const Solver& solver, Joints& joints, StepSize step) {
    const JointSolver& js = solver.joints;
    float by_time = 1.0f / step.dt;
    auto note = [&](const Joint& j) { joints.unchecked |= !holds(j); };
    for (const SolvedJoint& s : js.at_points) {
        Joint& j = joints.rows[s.joint];
        const PointBlock& k = js.points[s.place.block];
        std::size_t i = s.place.lane;
        j.impulse = {finite_impulse(k.impulse_x[i]), finite_impulse(k.impulse_y[i])};
        j.force = clamped(by_time * Vec2{k.total_x[i], k.total_y[i]}, kMaxForce);
        j.torque = k.turn == kNoDrive ? 0.0f : clamped(by_time * store_drive(j.turn, js.drives[k.turn], i), kMaxForce);
        if (!s.in_chain) note(j); // else its force is still to come
    }
    for (const ChainLink& k : js.links) {
        Joint& j = joints.rows[k.joint];
        j.impulse = {finite_impulse(k.impulse.x), finite_impulse(k.impulse.y)};
        j.force = clamped(by_time * k.total, kMaxForce);
        if (!driven(j.turn)) j.torque = 0.0f;
        note(j);
    }
    for (const SolvedJoint& s : js.at_axes) {
        Joint& j = joints.rows[s.joint];
        const AxisBlock& k = js.axes[s.place.block];
        std::size_t i = s.place.lane;
        j.impulse = {finite_impulse(k.impulse_side[i]), finite_impulse(k.impulse_turn[i])};
        float along = store_drive(j.along, js.drives[k.along], i), across = k.total_side[i];
        float turning = k.turn == kNoDrive ? 0.0f : store_drive(j.turn, js.drives[k.turn], i);
        Vec2 n{k.nx[i], k.ny[i]};
        j.force = clamped(by_time * (along * n + across * left_of(n)), kMaxForce);
        j.torque = clamped(by_time * (turning + k.total_turn[i]), kMaxForce);
        note(j);
    }
    for (const LoneJoint& k : js.alone) {
        Joint& j = joints.rows[k.joint];
        j.impulse = {finite_impulse(k.impulse), 0.0f};
        float size = by_time * k.total;
        j.force = clamped(size * Vec2{k.bx, k.by}, kMaxForce);
        j.torque = k.pulley ? 0.0f : clamped(size * k.turn_b, kMaxForce);
        note(j);
    }
}

} // namespace evil
