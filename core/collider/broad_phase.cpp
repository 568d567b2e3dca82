#include "collider/broad_phase.hpp"

namespace evil {

Bounds bounds_of(const Shapes& shapes, const Piece& piece, const Pose& pose) {
    if (piece.count == 0) {
        Vec2 centre = transform(pose, piece.centre), r{piece.radius, piece.radius};
        return {centre - r, centre + r};
    }
    std::span<const Vec2> points = points_of(shapes, piece);
    Vec2 low = transform(pose, points[0]), high = low;
    for (Vec2 local : points.subspan(1)) {
        Vec2 p = transform(pose, local);
        low = min(low, p);
        high = max(high, p);
    }
    return {low, high};
}

namespace {

// Each side grows by half the margin and by the piece's own reach within the step, so that two grown bounds meet before
// the pieces can.
Bounds swept_bounds(const Shapes& shapes, const Piece& piece, const Body& body, float dt) {
    Bounds bounds = bounds_of(shapes, piece, body.pose);
    float grow = 0.5f * kMargin;
    if (moves(body)) {
        float arm = length(piece.centre - body.local_centre) + piece.reach;
        float turn = std::min(std::abs(body.spin) * dt, 2.0f);
        grow += turn * arm;
        Vec2 path = dt * body.velocity;
        bounds.low = bounds.low + min(path, Vec2{});
        bounds.high = bounds.high + max(path, Vec2{});
    }
    Vec2 g{grow, grow};
    return {bounds.low - g, bounds.high + g};
}

} // namespace

// Sort and sweep along x (Cohen, Lin, Manocha, Ponamgi 1995, "I-COLLIDE", section 3): an entry meets only those that
// begin before it ends.
void find_pairs(BroadPhase& broad, const Shapes& shapes, const Bodies& bodies, float dt, std::vector<Pair>& pairs) {
    auto& entries = broad.entries;
    entries.clear();
    pairs.clear();
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p) {
        if (!shapes.piece_slots.taken(p)) continue;
        const Piece& piece = shapes.pieces[p];
        entries.push_back({swept_bounds(shapes, piece, bodies.rows[piece.body], dt), p, piece.body});
    }
    std::ranges::sort(entries, [](const auto& e, const auto& f) {
        return e.bounds.low.x != f.bounds.low.x ? e.bounds.low.x < f.bounds.low.x : e.piece < f.piece;
    });
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto& e = entries[i];
        bool dynamic = bodies.rows[e.body].kind == BodyKind::dynamic;
        for (std::size_t j = i + 1; j < entries.size() && entries[j].bounds.low.x <= e.bounds.high.x; ++j) {
            const auto& f = entries[j];
            if (f.bounds.low.y > e.bounds.high.y || e.bounds.low.y > f.bounds.high.y || e.body == f.body) continue;
            if (!dynamic && bodies.rows[f.body].kind != BodyKind::dynamic) continue;
            pairs.push_back({std::min(e.piece, f.piece), std::max(e.piece, f.piece)});
        }
    }
    std::ranges::sort(pairs);
}

} // namespace evil
