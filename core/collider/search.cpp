#include "collider/search.hpp"
#include <tuple>

namespace evil {
namespace {

// ---- the index -----------------------------------------------------------------------------------------------------

// The box is taken from rounded corners; queries are exact. It grows by more than the rounding.
Bounds safe_bounds(const Shapes& shapes, const Piece& piece, const Pose& pose) {
    Bounds b = bounds_of(shapes, piece, pose);
    float size = std::abs(pose.p.x) + std::abs(pose.p.y) + std::abs(piece.centre.x) + std::abs(piece.centre.y);
    float grow = 1e-6f * (size + piece.reach) + 1e-7f;
    return {b.low - Vec2{grow, grow}, b.high + Vec2{grow, grow}};
}

std::uint32_t tree_of(const Bodies& bodies, const Piece& piece) { return moves(bodies.rows[piece.body]) ? 1 : 0; }

void build_tree(Search& search, const Shapes& shapes, const Bodies& bodies, std::uint32_t which) {
    search.items.clear();
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p) {
        const Piece& piece = shapes.pieces[p];
        if (shapes.piece_slots.taken(p) && tree_of(bodies, piece) == which)
            search.items.push_back({p, safe_bounds(shapes, piece, bodies.rows[piece.body].pose)});
    }
    Tree& tree = search.trees[which];
    build(tree, search.items);
    for (std::uint32_t place = 0; place < tree.order.size(); ++place) search.places[tree.order[place]] = {which, place};
}

void build_both(Search& search, const Shapes& shapes, const Bodies& bodies) {
    search.places.assign(shapes.piece_slots.size(), {});
    for (std::uint32_t which : {0u, 1u}) build_tree(search, shapes, bodies, which);
}

void follow_piece(Search& search, const Shapes& shapes, const Bodies& bodies, std::uint32_t p, bool many) {
    const Piece& piece = shapes.pieces[p];
    Search::Place& at = search.places[p];
    Bounds bounds = safe_bounds(shapes, piece, bodies.rows[piece.body].pose);
    std::uint32_t which = tree_of(bodies, piece);
    if (at.tree == which) return (many ? put_bounds : set_bounds)(search.trees[which], at.place, bounds);
    if (at.tree != kNone) clear_place(search.trees[at.tree], at.place);
    at = {which, append(search.trees[which], p, bounds)};
}

void follow_edits(Search& search, const Shapes& shapes, const Bodies& bodies) {
    bool many = search.edited.size() > 32; // from here on one pass over all nodes is less work
    search.places.resize(std::max<std::size_t>(search.places.size(), shapes.piece_slots.size()));
    for (std::uint32_t body : search.edited) {
        if (!bodies.slots.taken(body)) continue; // its pieces are known by their slots, which are free or another's
        for (std::uint32_t s = bodies.rows[body].first_shape; s != kNone; s = shapes.rows[s].next)
            for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next)
                follow_piece(search, shapes, bodies, p, many);
    }
    if (many)
        for (Tree& tree : search.trees) refit(tree);
}

void follow_step(Search& search, const Shapes& shapes, const Bodies& bodies) {
    Tree& tree = search.trees[1];
    for (std::uint32_t place = 0; place < tree.order.size(); ++place) {
        std::uint32_t p = tree.order[place];
        if (p == kNone) continue;
        if (shapes.piece_slots.taken(p))
            put_bounds(tree, place, safe_bounds(shapes, shapes.pieces[p], bodies.rows[shapes.pieces[p].body].pose));
    }
    refit(tree);
}

// ---- asking --------------------------------------------------------------------------------------------------------

bool wanted(const Scene& scene, const Filter& filter, std::uint32_t p) {
    if (p == kNone || !scene.shapes.piece_slots.taken(p)) return false;
    std::uint32_t body = scene.shapes.pieces[p].body;
    if (!(filter.kinds >> static_cast<unsigned>(scene.bodies.rows[body].kind) & 1u)) return false;
    return std::ranges::find(filter.ignored, body) == filter.ignored.end();
}

// Order of creation, down to the pieces of a shape.
auto order_of(const Scene& scene, std::uint32_t p) {
    const Piece& piece = scene.shapes.pieces[p];
    return std::tuple(scene.bodies.rows[piece.body].serial, scene.shapes.rows[piece.shape].serial, p);
}

bool created_before(const Scene& scene, std::uint32_t p, std::uint32_t q) {
    return q == kNone || order_of(scene, p) < order_of(scene, q);
}

template <class Try> float call(void* context, std::uint32_t piece) { return (*static_cast<Try*>(context))(piece); }

template <class Try> void along(const Scene& scene, Vec2 start, Vec2 end, Try& attempt) {
    Sweep sweep{start.x, start.y, end.x - start.x, end.y - start.y, 0.0f, 0.0f};
    for (const Tree& tree : scene.search.trees)
        EVIL_PICK(scene.set, walk_along)(view_of(tree), sweep, attempt.limit(), call<Try>, &attempt);
}

template <class Try> void outward(const Scene& scene, Vec2 point, Try& attempt) {
    for (const Tree& tree : scene.search.trees)
        EVIL_PICK(scene.set, walk_outward)(view_of(tree), point.x, point.y, attempt.limit(), call<Try>, &attempt);
}

template <class Try> void inside(const Scene& scene, const Bounds& b, Try& attempt) {
    float low[2] = {b.low.x, b.low.y}, high[2] = {b.high.x, b.high.y};
    for (const Tree& tree : scene.search.trees)
        EVIL_PICK(scene.set, walk_inside)(view_of(tree), low, high, call<Try>, &attempt);
}

struct Found {
    double fraction = 1.0;
    std::uint32_t piece = kNone;
    Vec2 normal;
};

RayHit hit_at(const Scene& scene, const Found& found, Vec2 start, Vec2 end) {
    const Piece& piece = scene.shapes.pieces[found.piece];
    double t = found.fraction;
    Vec2 point{static_cast<float>(double(start.x) + t * (double(end.x) - double(start.x))),
               static_cast<float>(double(start.y) + t * (double(end.y) - double(start.y)))};
    return {piece.shape, piece.body, point, found.normal, static_cast<float>(t)};
}

void by_creation(const Bodies& bodies, std::vector<std::uint32_t>& found) {
    std::ranges::sort(found, {}, [&](std::uint32_t body) { return bodies.rows[body].serial; });
    found.erase(std::ranges::unique(found).begin(), found.end());
}

// Does the ray start in another piece of the same shape? Then what it enters is a seam, not the shape.
bool starts_within(const Scene& scene, const Piece& piece, const Pose& pose, Vec2 start) {
    std::uint32_t p = scene.shapes.rows[piece.shape].first_piece;
    if (scene.shapes.pieces[p].next == kNone || piece.count == 2) return false;
    for (; p != kNone; p = scene.shapes.pieces[p].next)
        if (contains(scene.shapes, scene.shapes.pieces[p], pose, start)) return true;
    return false;
}

struct FirstEntry { // of a ray
    const Scene& scene;
    const Filter& filter;
    Vec2 start, end;
    Found best{};

    float limit() const { return static_cast<float>(best.fraction); }
    float operator()(std::uint32_t p) {
        if (!wanted(scene, filter, p)) return limit();
        const Piece& piece = scene.shapes.pieces[p];
        const Pose& pose = scene.bodies.rows[piece.body].pose;
        std::optional<Entry> hit = enter(scene.shapes, piece, pose, start, end);
        if (!hit || hit->fraction > best.fraction) return limit();
        if (hit->fraction == best.fraction && !created_before(scene, p, best.piece)) return limit();
        if (!starts_within(scene, piece, pose, start)) best = {hit->fraction, p, hit->normal};
        return limit();
    }
};

struct EveryEntry {
    const Scene& scene;
    const Filter& filter;
    Vec2 start, end;
    std::vector<Found> all{};

    static float limit() { return 1.0f; }
    float operator()(std::uint32_t p) {
        if (!wanted(scene, filter, p)) return limit();
        const Piece& piece = scene.shapes.pieces[p];
        const Pose& pose = scene.bodies.rows[piece.body].pose;
        std::optional<Entry> hit = enter(scene.shapes, piece, pose, start, end);
        if (hit && !starts_within(scene, piece, pose, start)) all.push_back({hit->fraction, p, hit->normal});
        return limit();
    }
};

struct NearestPiece {
    const Scene& scene;
    const Filter& filter;
    Vec2 point;
    double distance;
    std::uint32_t best = kNone;
    Vec2 at{};

    float limit() const { return static_cast<float>(distance * distance); }
    float operator()(std::uint32_t p) {
        if (!wanted(scene, filter, p)) return limit();
        const Piece& piece = scene.shapes.pieces[p];
        Near near = nearest_point(scene.shapes, piece, scene.bodies.rows[piece.body].pose, point);
        if (near.distance < distance || (near.distance == distance && created_before(scene, p, best)))
            distance = near.distance, best = p, at = near.point;
        return limit();
    }
};

} // namespace

void refresh(Search& search, const Shapes& shapes, const Bodies& bodies) {
    if (!search.remade && !search.moved && search.edited.empty()) return;
    if (search.remade) {
        build_both(search, shapes, bodies);
    } else {
        follow_edits(search, shapes, bodies);
        if (search.moved) follow_step(search, shapes, bodies);
        for (std::uint32_t which : {0u, 1u})
            if (worn_out(search.trees[which])) build_tree(search, shapes, bodies, which);
    }
    search.edited.clear();
    search.remade = search.moved = false;
}

std::optional<RayHit> ray_cast(const Scene& scene, Vec2 start, Vec2 end, const Filter& filter) {
    FirstEntry first{scene, filter, start, end};
    along(scene, start, end, first);
    if (first.best.piece == kNone) return {};
    return hit_at(scene, first.best, start, end);
}

void ray_cast_all(const Scene& scene, Vec2 start, Vec2 end, const Filter& filter, std::vector<RayHit>& hits) {
    EveryEntry every{scene, filter, start, end};
    along(scene, start, end, every);
    std::ranges::sort(every.all, [&](const Found& a, const Found& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction : order_of(scene, a.piece) < order_of(scene, b.piece);
    });
    hits.clear();
    for (const Found& found : every.all) {
        RayHit hit = hit_at(scene, found, start, end);
        if (std::ranges::find(hits, hit.shape, &RayHit::shape) == hits.end()) hits.push_back(hit);
    }
}

std::optional<NearHit> nearest(const Scene& scene, Vec2 point, float within, const Filter& filter) {
    NearestPiece near{scene, filter, point, double(within)};
    outward(scene, point, near);
    if (near.best == kNone) return {};
    const Piece& piece = scene.shapes.pieces[near.best];
    return NearHit{piece.shape, piece.body, near.at, static_cast<float>(near.distance)};
}

void bodies_at(const Scene& scene, Vec2 point, const Filter& filter, std::vector<std::uint32_t>& found) {
    found.clear();
    auto attempt = [&](std::uint32_t p) {
        if (!wanted(scene, filter, p)) return 1.0f;
        const Piece& piece = scene.shapes.pieces[p];
        if (contains(scene.shapes, piece, scene.bodies.rows[piece.body].pose, point)) found.push_back(piece.body);
        return 1.0f;
    };
    inside(scene, {point, point}, attempt);
    by_creation(scene.bodies, found);
}

void bodies_overlapping(const Scene& scene, const Shapes& probe, const Filter& filter,
                        std::vector<std::uint32_t>& found) {
    found.clear();
    for (std::uint32_t q = 0; q < probe.piece_slots.size(); ++q) {
        const Piece& mine = probe.pieces[q];
        auto attempt = [&](std::uint32_t p) {
            if (!wanted(scene, filter, p)) return 1.0f;
            const Piece& piece = scene.shapes.pieces[p];
            Axis none;
            ManifoldSketch m = collide(place(probe, mine, Pose{}),
                                       place(scene.shapes, piece, scene.bodies.rows[piece.body].pose), 0.0f, none);
            if (m.count > 0) found.push_back(piece.body);
            return 1.0f;
        };
        inside(scene, safe_bounds(probe, mine, Pose{}), attempt);
    }
    by_creation(scene.bodies, found);
}

} // namespace evil
