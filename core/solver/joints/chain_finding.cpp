#include "solver/joints/chain_finding.hpp"
#include "solver/joints/joint_solver.hpp"

namespace evil {
namespace {

constexpr std::size_t kLeastChain = 3; // links; two are as quick one after the other
constexpr std::uint32_t kCrowd = kNone - 1;

// By row of a body, the two joints at points that it links; kCrowd first where there are more, kNone second where fewer.
void find_ends(JointSolver& solver, std::span<const SolverBody> rows) {
    solver.ends.assign(2 * rows.size(), kNone);
    for (std::uint32_t n = 0; n < solver.at_points.size(); ++n) {
        const SolvedJoint& s = solver.at_points[n];
        if (!s.link) continue;
        for (std::uint32_t body : {s.a, s.b}) {
            std::uint32_t* end = &solver.ends[2 * std::size_t{body}];
            if (!(rows[body].inv_mass > 0.0f) || end[0] == kCrowd) continue;
            if (end[0] == kNone)
                end[0] = n;
            else if (end[1] == kNone)
                end[1] = n;
            else
                end[0] = kCrowd;
        }
    }
}

std::uint32_t beyond(const JointSolver& solver, std::uint32_t n, std::uint32_t body) { // the joint at its other end
    const std::uint32_t* end = &solver.ends[2 * std::size_t{body}];
    if (end[0] == kCrowd || end[1] == kNone) return kNone;
    return end[0] == n ? end[1] : end[0];
}

ChainLink link_of(const SolvedJoint& s, const Joint& j, const Bodies& bodies) {
    const Body &a = bodies.rows[j.body_a], &b = bodies.rows[j.body_b];
    ChainLink k;
    k.joint = s.joint;
    k.a = s.a;
    k.b = s.b;
    k.start_a = arm_of(a, j.anchor_a);
    k.start_b = arm_of(b, j.anchor_b);
    k.gap = b.centre - a.centre;
    k.impulse = j.impulse;
    return k;
}

// From a joint with an open end to the last one in its row.
void follow(JointSolver& solver, std::uint32_t first, const Bodies& bodies, const Joints& joints) {
    std::size_t before = solver.links.size();
    bool from_a = beyond(solver, first, solver.at_points[first].a) == kNone; // the open end
    solver.row.clear();
    for (std::uint32_t n = first; n != kNone;) {
        SolvedJoint& s = solver.at_points[n];
        s.seen = true;
        solver.row.push_back(n);
        ChainLink& k = solver.links.emplace_back(link_of(s, joints.rows[s.joint], bodies));
        k.begins = n == first;
        k.shares_a = from_a;
        std::uint32_t body = from_a ? s.b : s.a;
        n = beyond(solver, n, body);
        if (n != kNone) from_a = solver.at_points[n].a == body;
    }
    if (solver.row.size() < kLeastChain)
        solver.links.resize(before);
    else
        for (std::uint32_t n : solver.row) solver.at_points[n].in_chain = true;
}

} // namespace

void find_chains(JointSolver& solver, std::span<const SolverBody> rows, const Bodies& bodies, const Joints& joints) {
    solver.links.clear();
    if (solver.at_points.size() < kLeastChain) return;
    find_ends(solver, rows);
    for (std::uint32_t n = 0; n < solver.at_points.size(); ++n) {
        const SolvedJoint& s = solver.at_points[n];
        if (s.seen || !s.link) continue;
        bool open_a = beyond(solver, n, s.a) == kNone, open_b = beyond(solver, n, s.b) == kNone;
        if (open_a != open_b) follow(solver, n, bodies, joints);
    }
}

} // namespace evil
