#pragma once
// How a query walks through a world's index: what every kind of question has in common.
#include "collider/search.hpp"
#include <tuple>

namespace evil {

// The box is taken from rounded corners; queries are exact. It grows by more than the rounding.
inline Bounds safe_bounds(const Shapes& shapes, const Piece& piece, const Pose& pose) {
    Bounds b = bounds_of(shapes, piece, pose);
    float size = std::abs(pose.p.x) + std::abs(pose.p.y) + std::abs(piece.centre.x) + std::abs(piece.centre.y);
    float grow = 1e-6f * (size + piece.reach) + 1e-7f;
    return {b.low - Vec2{grow, grow}, b.high + Vec2{grow, grow}};
}

// A place of a tree, as a query sees it: its number and what is there; or nothing, or nothing that it is about.
struct Seen {
    std::uint32_t number; // of the piece
    const Target* target;
};

inline bool wanted(const Scene& scene, const Filter& filter, const Seen& seen) {
    if (seen.number == kNone || !scene.shapes.piece_slots.taken(seen.number)) return false;
    if (!(filter.kinds >> static_cast<unsigned>(seen.target->kind) & 1u)) return false;
    if ((seen.target->sensor && !filter.sensors) || !(filter.mask & seen.target->category)) return false;
    return filter.ignored.empty() || std::ranges::find(filter.ignored, seen.target->piece.body) == filter.ignored.end();
}

// Order of creation, down to the pieces of a shape.
inline auto order_of(const Scene& scene, std::uint32_t p) {
    const Piece& piece = scene.shapes.pieces[p];
    return std::tuple(scene.bodies.rows[piece.body].serial, scene.shapes.rows[piece.shape].serial, p);
}

inline bool created_before(const Scene& scene, std::uint32_t p, std::uint32_t q) {
    return q == kNone || order_of(scene, p) < order_of(scene, q);
}

// A walk through both trees that calls attempt(number, target) for each place that the filter lets through.
template <class Try> struct Walk {
    const Scene& scene;
    const Filter& filter;
    Try& attempt;
    std::uint32_t tree = 0;

    static float visit(void* context, std::uint32_t place) {
        Walk& walk = *static_cast<Walk*>(context);
        const Search& search = walk.scene.search;
        Seen seen{search.trees[walk.tree].order[place], &search.targets[walk.tree][place]};
        if (wanted(walk.scene, walk.filter, seen)) walk.attempt(seen.number, *seen.target);
        return walk.attempt.limit();
    }
};

// The way of a box along `path`, as walks take it.
inline Sweep sweep_of(const Bounds& box, Vec2 path, float gap) {
    Vec2 centre = 0.5f * box.low + 0.5f * box.high, half = box.high - centre;
    float grow = gap + 1e-6f * (std::abs(centre.x) + std::abs(centre.y) + std::abs(path.x) + std::abs(path.y));
    return {centre.x, centre.y, path.x, path.y, half.x + grow, half.y + grow};
}

// Along a sweep, which what `attempt` finds may shorten.
template <class Try> void along(const Scene& scene, const Filter& filter, const Sweep& sweep, Try& attempt) {
    for (Walk<Try> walk{scene, filter, attempt}; walk.tree < 2; ++walk.tree) EVIL_PICK(scene.set, walk_along)
    (view_of(scene.search.trees[walk.tree]), sweep, attempt.limit(), Walk<Try>::visit, &walk);
}

template <class Try> void outward(const Scene& scene, const Filter& filter, Vec2 point, Try& attempt) {
    for (Walk<Try> walk{scene, filter, attempt}; walk.tree < 2; ++walk.tree) EVIL_PICK(scene.set, walk_outward)
    (view_of(scene.search.trees[walk.tree]), point.x, point.y, attempt.limit(), Walk<Try>::visit, &walk);
}

template <class Try> void inside(const Scene& scene, const Filter& filter, const Bounds& b, Try& attempt) {
    float low[2] = {b.low.x, b.low.y}, high[2] = {b.high.x, b.high.y};
    for (Walk<Try> walk{scene, filter, attempt}; walk.tree < 2; ++walk.tree) EVIL_PICK(scene.set, walk_inside)
    (view_of(scene.search.trees[walk.tree]), low, high, Walk<Try>::visit, &walk);
}

} // namespace evil
