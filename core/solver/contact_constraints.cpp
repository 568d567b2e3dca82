#include "solver/contact_constraints.hpp"
#include "solver/contacts_wide.hpp"
#include <cstring>
#include <span>

namespace evil {
namespace {

// A soft contact's frequency, as a share of the substeps' rate, and its damping ratio. What calms a pile is the share of its
// load that a contact forgets in a substep, 1 / (1 + a2) below: at under 5% the top of a pyramid of 30 rows dances. What
// makes it stiff is the frequency: stacks of ten small boxes buckle at a share of 1/8. So both at once.
constexpr float kContactRate = 3.0f / 16.0f;
constexpr float kContactDamping = 6.3f;

// Catto, "Soft Constraints", GDC 2011: a spring of that frequency and damping ratio, integrated implicitly over h.
ContactSoftness soft(float hertz, float h) {
    float omega = static_cast<float>(2.0 * kPi) * hertz;
    float a1 = 2.0f * kContactDamping + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

Vec2 acceleration_of(const Bodies& bodies, std::uint32_t slot) {
    const Body& b = bodies.rows[slot];
    return b.kind == BodyKind::dynamic ? b.acceleration : Vec2{};
}

// A contact that bounces, and how much faster the bodies close in for what forces have done to them in a step.
Bounce bounce_of(const Contact& c, const Bodies& bodies, std::size_t edge, float dt) {
    Vec2 gained = acceleration_of(bodies, c.body_b) - acceleration_of(bodies, c.body_a);
    return {static_cast<std::uint32_t>(edge), c.restitution, std::max(0.0f, -dt * dot(gained, c.normal))};
}

// Which contacts are solved, and by whom. The same list as before needs no new colours: it is compared as it is written.
bool find_edges(Solver& solver, const Bodies& bodies, Contacts& contacts, float dt) {
    auto& s = contacts.scratch;
    std::size_t before = solver.edges.size(), count = 0;
    solver.edges.resize(std::max(before, s.marks.size()));
    solver.bounces.clear();
    solver.unsolved.clear();
    Edge* edges = solver.edges.data();
    const std::uint32_t* number_of = solver.number_of.data();
    const std::uint8_t* pushed = solver.pushed.data();
    bool same = true;
    for (std::uint32_t row = 0; row < s.marks.size(); ++row) {
        std::uint8_t mark = s.marks[row];
        if (!(mark & kMeets)) continue;
        std::uint32_t a = number_of[s.bodies[row].a], b = number_of[s.bodies[row].b];
        bool a_moves = pushed[a] != 0, b_moves = pushed[b] != 0;
        if (!a_moves && !b_moves) {
            solver.unsolved.push_back(row);
            continue;
        }
        if (mark & kBounces) solver.bounces.push_back(bounce_of(contacts.rows[row], bodies, count, dt));
        std::uint32_t sort = a_moves && b_moves ? 0u : a_moves ? Edge::kWall | Edge::kTurn : Edge::kWall;
        Edge edge{a_moves ? a : b, a_moves ? b : a, sort, row};
        if (!(edges[count] == edge)) edges[count] = edge, same = false;
        ++count;
    }
    solver.edges.resize(count);
    return !same || count != before;
}

bool meet_as_before(std::span<const std::uint8_t> marks, std::span<const std::uint8_t> before) {
    constexpr std::uint8_t kAsked = kMeets | kBounces; // bounces go with the velocities
    std::uint8_t other = 0;
    for (std::size_t row = 0; row < marks.size(); ++row)
        other |= static_cast<std::uint8_t>(((marks[row] ^ before[row]) & kMeets) | (marks[row] & kBounces));
    return (other & kAsked) == 0;
}

template <class T> bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// Are the edges those of the last step? Then nobody has to go through them.
bool edges_stay(const Solver& solver, const Contacts& contacts) {
    const EdgesFrom& from = solver.edges_from;
    const auto& s = contacts.scratch;
    return s.marks.size() == from.marks.size() && meet_as_before(s.marks, from.marks) &&
           same_bytes(s.bodies, from.bodies) && same_bytes(solver.number_of, from.number_of) &&
           same_bytes(solver.pushed, from.pushed);
}

// Are there others than in the last step?
bool renew_edges(Solver& solver, const Bodies& bodies, Contacts& contacts, float dt) {
    bool changed = false;
    if (!edges_stay(solver, contacts)) {
        changed = find_edges(solver, bodies, contacts, dt);
        EdgesFrom& from = solver.edges_from;
        from.marks = contacts.scratch.marks;
        from.bodies = contacts.scratch.bodies;
        from.number_of = solver.number_of;
        from.pushed = solver.pushed;
    }
    for (std::uint32_t row : solver.unsolved) // the solver will not say whether anything has changed
        contacts.scratch.marks[row] |= kTelling;
    return changed;
}

void place_edges(Solver& solver) {
    Colouring& colouring = solver.colouring;
    colour(colouring, solver.edges, static_cast<std::uint32_t>(solver.bodies.size()), kBlockLanes);
    solver.blocks.resize(colouring.blocks);
    solver.sources.resize(colouring.blocks);
    for (std::uint32_t i = 0; i < colouring.blocks; ++i) {
        for (std::uint32_t lane = 0; lane < kBlockLanes; ++lane) {
            solver.blocks[i].a[lane] = solver.blocks[i].b[lane] = 0;
            solver.sources[i].contact[lane] = kNone;
            solver.sources[i].turn[lane] = 0;
        }
    }
    for (std::size_t i = 0; i < solver.edges.size(); ++i) {
        const Edge& e = solver.edges[i];
        auto [block, lane] = colouring.places[i];
        solver.blocks[block].a[lane] = kBodyFloats * (e.wall() ? e.b : e.a); // what does not move
        solver.blocks[block].b[lane] = kBodyFloats * (e.wall() ? e.a : e.b);
        solver.sources[block].contact[lane] = e.contact;
        solver.sources[block].turn[lane] = e.turn() ? ~0u : 0u;
    }
}

} // namespace

ContactSoftnesses softness_of(StepSize step) {
    float h = step.h(), hertz = kContactRate / h;
    return {soft(hertz, h), soft(2.0f * hertz, h)}; // what cannot give way is pushed out of faster
}

void prepare_contacts(Solver& solver, const Bodies& bodies, Contacts& contacts, StepSize step, Threads& threads) {
    if (renew_edges(solver, bodies, contacts, step.dt)) place_edges(solver);
    parallel_for(threads, solver.blocks.size(), 32, [&](std::size_t first, std::size_t last) {
        EVIL_PICK(step.set, fill_blocks)
        (solver.bodies.data(), contacts.rows.data(), &solver.blocks[first], &solver.sources[first], last - first);
    });
}

void finish_contacts(Solver& solver, Contacts& contacts, StepSize step, Threads& threads) {
    parallel_for(threads, solver.blocks.size(), 32, [&](std::size_t first, std::size_t last) {
        EVIL_PICK(step.set, store_impulses)
        (&solver.blocks[first], &solver.sources[first], contacts.rows.data(), contacts.scratch.marks.data(),
         last - first, step.hit_speed);
    });
}

} // namespace evil
