#include "collider/continuous.hpp"
#include "collider/filter.hpp"
#include "solver/joints/joint.hpp"
#include <algorithm>

namespace evil {
namespace {

using Fast = Continuous::Fast;

constexpr float kSunk = 2.0f * kSlop; // metres that a core lies under its surface: more than resting contacts overlap
constexpr float kGap = 0.2f * kSlop;  // metres: cores stop this far from what they meet
constexpr float kFar = 0.5f;          // of the inner radius: what moves less has its centre still on the right side

// How deep a point lies in the piece; negative outside.
float depth_in(const Shapes& shapes, const Piece& piece, Vec2 point) {
    if (piece.count < 3) return piece.count == 0 ? piece.radius - length(point - piece.centre) : piece.radius;
    std::span<const Vec2> points = points_of(shapes, piece), normals = normals_of(shapes, piece);
    float inside = 1e30f;
    for (std::size_t i = 0; i < points.size(); ++i) inside = std::min(inside, dot(normals[i], points[i] - point));
    return inside + piece.radius;
}

Vec2 middle_of(const Shapes& shapes, const Piece& piece) { // surely inside
    if (piece.count == 0) return piece.centre;
    Vec2 sum;
    for (Vec2 point : points_of(shapes, piece)) sum += point;
    return (1.0f / static_cast<float>(piece.count)) * sum;
}

struct Extent {
    float inner = 1e30f; // the least depth of a piece's middle
    float reach = 0.0f;  // from the centre of mass to the farthest point
};

Extent extent_of(const Body& body, const Shapes& shapes) {
    Extent e;
    for (std::uint32_t s = body.first_shape; s != kNone; s = shapes.rows[s].next) {
        if (shapes.rows[s].traits.sensor) continue;
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next) {
            const Piece& piece = shapes.pieces[p];
            e.inner = std::min(e.inner, depth_in(shapes, piece, middle_of(shapes, piece)));
            e.reach = std::max(e.reach, length(piece.centre - body.local_centre) + piece.reach);
        }
    }
    return e;
}

Motion motion_of(const Path& path, const Body& body) {
    Rot q = rotation(path.angle);
    return {{path.start - rotate(q, body.local_centre), q},
            body.centre - path.start,
            body.angle - path.angle,
            body.local_centre};
}

Motion part_of(const Motion& m, double from, double to) {
    double share = to - from;
    Motion part = m;
    if (from > 0.0) part.start = pose_at(m, from);
    part.path = static_cast<float>(share) * m.path;
    part.turn = share * m.turn;
    return part;
}

void find_fast(Continuous& c, std::span<const Path> paths, const Bodies& bodies, const Shapes& shapes) {
    c.fast.clear();
    for (const Path& path : paths) {
        const Body& b = bodies.rows[path.body];
        if (b.kind != BodyKind::dynamic || b.first_shape == kNone) continue;
        Vec2 moved = b.centre - path.start;
        float turned = static_cast<float>(std::min(std::abs(b.angle - path.angle), 2.0));
        if (!b.bullet && length_squared(moved) < kSlop * kSlop && turned < 1e-3f) continue;
        Extent e = extent_of(b, shapes);
        if (e.reach == 0.0f) continue;
        if (!b.bullet && length(moved) + turned * e.reach <= kFar * e.inner) continue;
        Vec2 r{e.reach, e.reach};
        c.fast.push_back({path.body, min(path.start, b.centre) - r, max(path.start, b.centre) + r});
    }
}

void note_motions(Continuous& c, std::span<const Path> paths, const Bodies& bodies) {
    c.motions.clear();
    c.path_of.assign(bodies.rows.size(), kNone);
    c.fast_of.assign(bodies.rows.size(), kNone);
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        c.path_of[paths[i].body] = i;
        c.motions.push_back(motion_of(paths[i], bodies.rows[paths[i].body]));
    }
    for (std::uint32_t i = 0; i < c.fast.size(); ++i) c.fast_of[c.fast[i].body] = i;
}

// Its corners moved in, or drawn toward the middle where an edge is too short for that.
Proxy core_of(Continuous& c, const Shapes& shapes, const Piece& piece) {
    Vec2 middle = middle_of(shapes, piece);
    float inner = depth_in(shapes, piece, middle), sunk = std::min(kSunk, 0.5f * inner);
    Proxy whole = proxy_of(shapes, piece);
    float off_skin = std::min(sunk, whole.radius), in = sunk - off_skin;
    whole.radius -= off_skin;
    if (in <= 0.0f || piece.count < 3) return whole;
    std::span<const Vec2> points = points_of(shapes, piece), normals = normals_of(shapes, piece);
    std::size_t n = points.size();
    c.core.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        Vec2 m = normals[i > 0 ? i - 1 : n - 1], k = normals[i];
        c.core[i] = points[i] - (in / std::max(1.0f + dot(m, k), 1e-6f)) * (m + k);
    }
    bool flipped = false;
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t j = i + 1 < n ? i + 1 : 0;
        flipped = flipped || !(dot(c.core[j] - c.core[i], points[j] - points[i]) > 0.0f);
    }
    if (flipped)
        for (std::size_t i = 0; i < n; ++i) c.core[i] = points[i] - (in / inner) * (points[i] - middle);
    return {c.core, whole.radius};
}

// Bounds of the pieces that fast bodies may meet: of this step's start, grown by where their own bodies have gone.
void find_swept(Continuous& c, std::vector<Continuous::Swept>& list, bool dynamic_too, const Placements& placed,
                const Bodies& bodies, const Shapes& shapes) {
    list.clear();
    std::size_t there =
        std::min(shapes.pieces.size(), placed.octaves.size()); // after a restore, slots may be left over
    for (std::uint32_t p = 0; p < there; ++p) {
        if (placed.octaves[p] == kNoOctave) continue;
        const Piece& piece = shapes.pieces[p];
        const Body& body = bodies.rows[piece.body];
        if (body.kind == BodyKind::dynamic && !dynamic_too) continue;
        Vec2 low{placed.low_x[p], placed.low_y[p]}, high{placed.high_x[p], placed.high_y[p]};
        std::uint32_t path = c.path_of[piece.body];
        if (path != kNone) {
            const Motion& m = c.motions[path];
            float arm = length(piece.centre - body.local_centre) + piece.reach;
            float swing = static_cast<float>(std::min(std::abs(m.turn), 2.0)) * arm;
            low = low + min(m.path, Vec2{}) - Vec2{swing, swing};
            high = high + max(m.path, Vec2{}) + Vec2{swing, swing};
        }
        list.push_back({low, high, 0.0f, p});
    }
    std::ranges::sort(
        list, [](const auto& e, const auto& f) { return e.low.x != f.low.x ? e.low.x < f.low.x : e.piece < f.piece; });
    float right = -3.4e38f;
    for (auto& e : list) e.right = right = std::max(right, e.high.x);
}

// Those that the body may sweep over, in order of their slots. In order of low.x, nothing after the last that begins in time
// can be met, and nothing before all those that end too early.
void find_candidates(Continuous& c, const Fast& fast, const Bodies& bodies, const Shapes& shapes) {
    c.candidates.clear();
    const auto& list = bodies.rows[fast.body].bullet ? c.everything : c.walls;
    auto e = std::ranges::upper_bound(list, fast.high.x, {}, [](const auto& swept) { return swept.low.x; });
    while (e != list.begin() && (--e)->right >= fast.low.x) {
        if (e->high.x < fast.low.x || e->low.y > fast.high.y || e->high.y < fast.low.y) continue;
        if (shapes.pieces[e->piece].body != fast.body) c.candidates.push_back(e->piece);
    }
    std::ranges::sort(c.candidates);
}

// The way that a point of the one takes as seen from the other, in the axes that this one has at the start.
Vec2 way_seen(const Motion& one, Vec2 local, const Motion* other, double end) {
    Vec2 from = transform(one.start, local), to = transform(pose_at(one, end), local);
    if (other) to = transform(other->start, untransform(pose_at(*other, end), to));
    return to - from;
}

// The motion of what may be met, which ends early if that is fast itself and has been stopped.
Impact cast_against(const Continuous& c, const Proxy& core, const Motion& motion, double end, const Proxy& wall,
                    const Body& other, std::uint32_t body, double gap) {
    std::uint32_t path = c.path_of[body], fast = c.fast_of[body];
    if (path == kNone) {
        Impact hit = cast(wall, {other.pose, {}, 0.0, {}}, core, part_of(motion, 0.0, end), gap);
        hit.t *= end;
        return hit;
    }
    double stop = fast == kNone ? end : std::min(c.fast[fast].end, end);
    Impact hit = cast(wall, part_of(c.motions[path], 0.0, stop), core, part_of(motion, 0.0, stop), gap);
    if (hit.state == Meeting::touch) hit.t *= stop;
    if (hit.state != Meeting::none || stop >= end) return hit;
    Motion still{pose_at(c.motions[path], stop), {}, 0.0, {}};
    hit = cast(wall, still, core, part_of(motion, stop, end), gap);
    if (hit.state == Meeting::touch) hit.t = stop + (end - stop) * hit.t;
    return hit;
}

// When the piece meets the wall, as a share of the step. If its core does, it stops before its surface touches: contacts
// in advance are hard, those of what overlaps are soft. What was in touch already is let in as far as the core, and what was
// in deeper may at least not take its middle through.
Impact meet(const Continuous& c, const Proxy& core, const Piece& piece, const Shapes& shapes, const Motion& motion,
            double end, std::uint32_t wall_piece, const Bodies& bodies) {
    const Piece& wall = shapes.pieces[wall_piece];
    const Body& other = bodies.rows[wall.body];
    Vec2 at = middle_of(shapes, piece);
    Proxy solid = proxy_of(shapes, wall), middle{{&at, 1}, 0.0f};
    double gap = std::min(double{kGap}, 0.1 * double{piece.reach});
    Impact hit = cast_against(c, core, motion, end, solid, other, wall.body, gap);
    if (hit.state == Meeting::overlap) {
        hit = cast_against(c, middle, motion, end, solid, other, wall.body, gap);
        if (hit.state != Meeting::overlap) return hit;
        std::uint32_t path = c.path_of[wall.body];
        Vec2 way = way_seen(motion, at, path == kNone ? nullptr : &c.motions[path], end);
        if (dot(hit.normal, way) < 0.0f) hit.state = Meeting::touch; // it stays here
        return hit;
    }
    if (hit.state == Meeting::none) return hit;
    Impact first = cast_against(c, proxy_of(shapes, piece), motion, hit.t, solid, other, wall.body, gap);
    return first.state == Meeting::touch ? first : hit;
}

// When the fast body first meets something, and what.
void find_hit(Continuous& c, Fast& fast, const Bodies& bodies, const Shapes& shapes, const Joints& joints) {
    const Body& body = bodies.rows[fast.body];
    const Motion& motion = c.motions[c.path_of[fast.body]];
    fast.hit = 2.0;
    fast.wall = kNone;
    find_candidates(c, fast, bodies, shapes);
    for (std::uint32_t s = body.first_shape; s != kNone && !c.candidates.empty(); s = shapes.rows[s].next) {
        const Traits& traits = shapes.rows[s].traits;
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next) {
            const Piece& piece = shapes.pieces[p];
            Proxy core = core_of(c, shapes, piece);
            for (std::uint32_t q : c.candidates) {
                std::uint32_t wall = shapes.pieces[q].body;
                const Traits& of_wall = shapes.rows[shapes.pieces[q].shape].traits;
                if (!blocks(of_wall, bodies.rows[wall].pose.q, traits, motion.path)) continue;
                if (kept_apart(joints, fast.body, wall)) continue;
                Impact hit = meet(c, core, piece, shapes, motion, std::min(fast.end, fast.hit), q, bodies);
                if (hit.state != Meeting::touch) continue;
                fast.hit = hit.t;
                fast.wall = wall;
            }
        }
    }
}

bool cross(const Fast& a, const Fast& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

std::uint32_t earliest(const std::vector<Fast>& fast) {
    std::uint32_t first = kNone;
    for (std::uint32_t i = 0; i < fast.size(); ++i)
        if (!fast[i].settled && fast[i].hit <= 1.0 && (first == kNone || fast[i].hit < fast[first].hit)) first = i;
    return first;
}

// What a wall does after it was met, the one that met it does as well.
void go_along(Body& b, const Motion& wall, double from, double to) {
    Pose before = pose_at(wall, from), after = pose_at(wall, to);
    Vec2 local = untransform(before, b.centre);
    b.centre = transform(after, local);
    b.angle += (to - from) * wall.turn;
}

void stop(const Continuous& c, const Fast& fast, Bodies& bodies) {
    Body& b = bodies.rows[fast.body];
    const Motion& m = c.motions[c.path_of[fast.body]];
    b.centre = b.centre - static_cast<float>(1.0 - fast.end) * m.path;
    b.angle -= (1.0 - fast.end) * m.turn;
    if (fast.wall != kNone && c.path_of[fast.wall] != kNone) {
        std::uint32_t wall = c.fast_of[fast.wall];
        double end = wall == kNone ? 1.0 : c.fast[wall].end;
        if (end > fast.end) go_along(b, c.motions[c.path_of[fast.wall]], fast.end, end);
    }
    place_by_centre(b);
}

} // namespace

void stop_in_time(Continuous& c, std::span<const Path> paths, const Placements& placed, Bodies& bodies,
                  const Shapes& shapes, const Joints& joints) {
    find_fast(c, paths, bodies, shapes);
    if (c.fast.empty()) return;
    note_motions(c, paths, bodies);
    auto bullet = [&](const Fast& fast) { return bodies.rows[fast.body].bullet; };
    if (!std::ranges::all_of(c.fast, bullet)) find_swept(c, c.walls, false, placed, bodies, shapes);
    if (std::ranges::any_of(c.fast, bullet)) find_swept(c, c.everything, true, placed, bodies, shapes);
    for (Fast& fast : c.fast) find_hit(c, fast, bodies, shapes, joints);
    for (std::uint32_t i;
         (i = earliest(c.fast)) != kNone;) { // in the order of time: who stops, others may miss or meet
        auto settle = [&](std::uint32_t k, double t) {
            c.fast[k].end = t;
            c.fast[k].settled = true;
        };
        settle(i, c.fast[i].hit);
        std::uint32_t other = c.fast_of[c.fast[i].wall];
        bool both = other != kNone && !c.fast[other].settled && bodies.rows[c.fast[i].wall].bullet;
        if (both) settle(other, c.fast[i].hit);
        for (Fast& fast : c.fast) {
            bool touched = cross(fast, c.fast[i]) || (both && cross(fast, c.fast[other]));
            if (!fast.settled && touched && bodies.rows[fast.body].bullet) find_hit(c, fast, bodies, shapes, joints);
        }
    }
    for (const Fast& fast : c.fast)
        if (fast.settled) stop(c, fast, bodies);
}

} // namespace evil
