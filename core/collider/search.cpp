#include "collider/search.hpp"
#include "collider/walks.hpp"

namespace evil {
namespace {

// ---- the index -----------------------------------------------------------------------------------------------------

Target target_of(const Shapes& shapes, const Bodies& bodies, std::uint32_t p) {
    const Piece& piece = shapes.pieces[p];
    const Body& body = bodies.rows[piece.body];
    bool alone = piece.next == kNone && shapes.rows[piece.shape].first_piece == p;
    const Traits& traits = shapes.rows[piece.shape].traits;
    return {piece, body.pose, body.kind, alone, traits.sensor, traits.category};
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
    search.targets[which].clear();
    for (Search::Place& at : search.places) // also of slots that are free now: who gets them next has no place yet
        if (at.tree == which) at = {};
    for (std::uint32_t place = 0; place < tree.order.size(); ++place) {
        search.places[tree.order[place]] = {which, place};
        search.targets[which].push_back(target_of(shapes, bodies, tree.order[place]));
    }
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
    if (at.tree != which) {
        if (at.tree != kNone) clear_place(search.trees[at.tree], at.place);
        at = {which, append(search.trees[which], p, bounds)};
        search.targets[which].emplace_back();
    } else {
        (many ? put_bounds : set_bounds)(search.trees[which], at.place, bounds);
    }
    search.targets[which][at.place] = target_of(shapes, bodies, p);
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
        if (p == kNone || !shapes.piece_slots.taken(p)) continue;
        Target& target = search.targets[1][place];
        target.pose = bodies.rows[target.piece.body].pose;
        put_bounds(tree, place, safe_bounds(shapes, target.piece, target.pose));
    }
    refit(tree);
}

// ---- asking --------------------------------------------------------------------------------------------------------

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
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

// Does the ray start in another piece of the same shape? Then what it enters is a seam, not the shape.
bool starts_within(const Scene& scene, const Target& target, Vec2 start) {
    if (target.alone || target.piece.count == 2) return false;
    std::uint32_t p = scene.shapes.rows[target.piece.shape].first_piece;
    for (; p != kNone; p = scene.shapes.pieces[p].next)
        if (contains(scene.shapes, scene.shapes.pieces[p], target.pose, start)) return true;
    return false;
}

Sweep sweep_of(Vec2 start, Vec2 end) { return {start.x, start.y, end.x - start.x, end.y - start.y, 0.0f, 0.0f}; }

struct FirstEntry { // of a ray
    const Scene& scene;
    Vec2 start, end;
    Found best{};

    float limit() const { return static_cast<float>(best.fraction); }
    void operator()(std::uint32_t p, const Target& target) {
        std::optional<Entry> hit = enter(scene.shapes, target.piece, target.pose, start, end);
        if (!hit || hit->fraction > best.fraction) return;
        if (hit->fraction == best.fraction && !created_before(scene, p, best.piece)) return;
        if (!starts_within(scene, target, start)) best = {hit->fraction, p, hit->normal};
    }
};

struct EveryEntry {
    const Scene& scene;
    Vec2 start, end;
    std::vector<Found> all{};

    static float limit() { return 1.0f; }
    void operator()(std::uint32_t p, const Target& target) {
        std::optional<Entry> hit = enter(scene.shapes, target.piece, target.pose, start, end);
        if (hit && !starts_within(scene, target, start)) all.push_back({hit->fraction, p, hit->normal});
    }
};

struct NearestPiece {
    const Scene& scene;
    Vec2 point;
    double distance;
    std::uint32_t best = kNone;
    Vec2 at{};

    float limit() const { return static_cast<float>(distance * distance); }
    void operator()(std::uint32_t p, const Target& target) {
        Near near = nearest_point(scene.shapes, target.piece, target.pose, point);
        if (near.distance < distance || (near.distance == distance && created_before(scene, p, best)))
            distance = near.distance, best = p, at = near.point;
    }
};

struct Covering { // a point
    const Scene& scene;
    Vec2 point;
    std::vector<std::uint32_t>& found;

    static float limit() { return 1.0f; }
    void operator()(std::uint32_t, const Target& target) {
        if (contains(scene.shapes, target.piece, target.pose, point)) found.push_back(target.piece.body);
    }
};

struct Overlapping { // a piece in world coordinates
    const Scene& scene;
    Placed mine;
    std::vector<std::uint32_t>& found;

    static float limit() { return 1.0f; }
    void operator()(std::uint32_t, const Target& target) {
        Axis none;
        if (collide(mine, place(scene.shapes, target.piece, target.pose), 0.0f, none).count > 0)
            found.push_back(target.piece.body);
    }
};

} // namespace

void refresh(Search& search, const Shapes& shapes, const Bodies& bodies) {
    if (search.packed != shapes.packed) search.remade = true;
    if (!search.remade && !search.moved && search.edited.empty()) return;
    search.packed = shapes.packed;
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
    FirstEntry first{scene, start, end};
    along(scene, filter, sweep_of(start, end), first);
    if (first.best.piece == kNone) return {};
    return hit_at(scene, first.best, start, end);
}

void ray_cast_all(const Scene& scene, Vec2 start, Vec2 end, const Filter& filter, std::vector<RayHit>& hits) {
    EveryEntry every{scene, start, end};
    along(scene, filter, sweep_of(start, end), every);
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
    NearestPiece near{scene, point, double(within)};
    outward(scene, filter, point, near);
    if (near.best == kNone) return {};
    const Piece& piece = scene.shapes.pieces[near.best];
    return NearHit{piece.shape, piece.body, near.at, static_cast<float>(near.distance)};
}

void bodies_at(const Scene& scene, Vec2 point, const Filter& filter, std::vector<std::uint32_t>& found) {
    found.clear();
    Covering covering{scene, point, found};
    inside(scene, filter, {point, point}, covering);
    by_creation(scene.bodies, found);
}

void bodies_overlapping(const Scene& scene, const Shapes& probe, const Filter& filter,
                        std::vector<std::uint32_t>& found) {
    found.clear();
    for (std::uint32_t q = 0; q < probe.piece_slots.size(); ++q) {
        Overlapping overlapping{scene, place(probe, probe.pieces[q], Pose{}), found};
        inside(scene, filter, safe_bounds(probe, probe.pieces[q], Pose{}), overlapping);
    }
    by_creation(scene.bodies, found);
}

} // namespace evil
