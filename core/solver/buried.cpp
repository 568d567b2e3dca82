#include "solver/buried.hpp"
#include <algorithm>

namespace evil {
namespace {

constexpr float kBuried = 0.35f;  // of the way from a contact to the centre; a light box under a heavy one gives 0.1
constexpr std::size_t kCrowd = 3; // bodies; with fewer it is a hit, whose momentum counts
constexpr float kCalm = 3.0f;     // m/s: as fast as one contact pushes overlap out (kPushSpeed)
constexpr float kCalmSpin = 6.0f; // radians a second

bool is_deep(const ManifoldPoint& p, Vec2 arm) {
    return p.separation * p.separation > kBuried * kBuried * dot(arm, arm);
}

} // namespace

void find_buried(Buried& buried, const Contacts& contacts, const Bodies& bodies) {
    buried.deep.clear();
    buried.rows.clear();
    for_each_marked(contacts.scratch.marks, kDeep, [&](std::uint32_t row) {
        const Contact& c = contacts.rows[row];
        const ManifoldPoint& p = c.points[c.count > 1 && c.points[1].separation < c.points[0].separation];
        if (is_deep(p, p.anchor_a)) buried.deep.push_back({c.body_a, c.body_b});
        if (is_deep(p, p.anchor_b)) buried.deep.push_back({c.body_b, c.body_a});
    });
    if (buried.deep.size() < kCrowd) return;
    std::ranges::sort(buried.deep);
    // Bodies of several pieces touch each other many times.
    buried.deep.erase(std::unique(buried.deep.begin(), buried.deep.end()), buried.deep.end());
    for (std::size_t i = 0, end = 0; i < buried.deep.size(); i = end) {
        std::uint32_t slot = buried.deep[i].slot;
        while (end < buried.deep.size() && buried.deep[end].slot == slot) ++end;
        const Body& b = bodies.rows[slot];
        if (end - i >= kCrowd && b.kind == BodyKind::dynamic && b.awake)
            buried.rows.push_back({slot, length(b.velocity), std::abs(b.spin)});
    }
}

void calm_buried(const Buried& buried, Bodies& bodies) {
    for (const Buried::Row& row : buried.rows) {
        Body& b = bodies.rows[row.slot];
        float speed = length(b.velocity), most = std::max(row.speed, kCalm);
        if (speed > most) b.velocity = (most / speed) * b.velocity;
        b.spin = clamped(b.spin, std::max(row.spin, kCalmSpin));
    }
}

} // namespace evil
