#include "collider/narrow_phase.hpp"
#include "collider/gjk.hpp"

namespace evil {
namespace {

// A switch of reference edge costs warm starting, so the other one must be better by this much (metres).
constexpr float kReferenceBias = 0.1f * kSlop;

// Pose of b in the frame of a.
Pose relative(const Pose& a, const Pose& b) {
    Vec2 d = unrotate(a.q, b.p - a.p);
    return {d, {a.q.c * b.q.c + a.q.s * b.q.s, a.q.c * b.q.s - a.q.s * b.q.c}};
}

// How far the nearest corner of `other` lies outside edge `e` of `face`; `to_other` is face's frame seen from other's.
float separation_along(const Placed& face, std::uint32_t e, const Placed& other, const Pose& to_other) {
    Vec2 normal = rotate(to_other.q, face.normals[e]);
    Vec2 start = transform(to_other, face.points[e]);
    float nearest = dot(normal, other.points[0] - start);
    for (Vec2 p : other.points.subspan(1)) nearest = std::min(nearest, dot(normal, p - start));
    return nearest;
}

struct Best {
    float separation = -1e30f;
    std::uint32_t edge = 0;
};

// The edge of `face` that keeps `other` out best. Stops at the first that keeps it out by more than the margin.
Best best_edge(const Placed& face, const Placed& other, const Pose& to_other, float margin) {
    Best best;
    for (std::uint32_t e = 0; e < face.piece.count && best.separation <= margin; ++e) {
        float s = separation_along(face, e, other, to_other);
        if (s > best.separation) best = {s, e};
    }
    return best;
}

// Two lines without a skin keep apart by twice the slop: with none, one that rests on the other would lie as much below it.
float skins_of(const Placed& a, const Placed& b) {
    float skins = a.piece.radius + b.piece.radius;
    bool bare = a.piece.count == 2 && b.piece.count == 2 && skins == 0.0f;
    return bare ? 2.0f * kSlop : skins;
}

// Clip the incident edge of `other` against the sides of reference edge `e` of `face`, and keep what is near the face.
//
//            side |            | side
//        incident \____________|___
//                 |\           |        separation of a point = its height over the reference edge
//   face  v1 -----|-*----------* v2-----
//                   reference edge
//
// Heights are the cores'; skins lie on top of the face and under the other's points.
ManifoldSketch clip(const Placed& face, std::uint32_t e, const Placed& other, float margin, bool flipped) {
    Pose to_face = relative(face.pose, other.pose);
    Vec2 v1 = face.points[e], v2 = face.points[e + 1 < face.piece.count ? e + 1 : 0], n = face.normals[e];
    Vec2 tangent = left_of(n); // from v1 to v2, as corners run counter-clockwise

    std::uint32_t incident = 0;
    float most_opposed = 1e30f;
    for (std::uint32_t i = 0; i < other.piece.count; ++i) {
        float d = dot(n, rotate(to_face.q, other.normals[i]));
        if (d < most_opposed) most_opposed = d, incident = i;
    }
    // The incident edge runs against the reference edge: its end lies near v1.
    Vec2 w2 = transform(to_face, other.points[incident]);
    Vec2 w1 = transform(to_face, other.points[incident + 1 < other.piece.count ? incident + 1 : 0]);
    float low = 0.0f, high = dot(tangent, v2 - v1);
    float t1 = dot(tangent, w1 - v1), t2 = dot(tangent, w2 - v1);

    ManifoldSketch m;
    m.normal = rotate(face.pose.q, flipped ? -n : n);
    if (!(t1 < t2)) { // the incident edge stands on end: its nearer corner alone can touch
        Vec2 w = dot(n, w1) < dot(n, w2) ? w1 : w2;
        t1 = t2 = dot(tangent, w - v1);
        w1 = w2 = w;
    }
    if (t2 < low || t1 > high) return m;
    Vec2 c1 = t1 < low && t2 > t1 ? lerp(w1, w2, (low - t1) / (t2 - t1)) : w1;
    Vec2 c2 = t2 > high && t2 > t1 ? lerp(w1, w2, (high - t1) / (t2 - t1)) : w2;
    std::uint32_t id = (flipped ? 0x80000000u : 0u) | (e & 0x3fffu) << 17 | (incident & 0x3fffu) << 3;
    float skins = skins_of(face, other);
    auto keep = [&](Vec2 c, std::uint32_t which) {
        float s = dot(n, c - v1);
        if (s - skins > margin) return;
        Vec2 midway = c - 0.5f * (s - face.piece.radius + other.piece.radius) * n;
        m.points[m.count++] = {transform(face.pose, midway), s - skins, id | which};
    };
    keep(c1, 0);
    if (t2 > t1) keep(c2, 1);
    return m;
}

ManifoldSketch one_point(Vec2 surface_a, Vec2 normal, float separation, std::uint32_t id) {
    ManifoldSketch m;
    m.count = 1;
    m.normal = normal;
    m.points[0] = {surface_a + 0.5f * separation * normal, separation, id};
    return m;
}

// Would a contact at this corner of a chain's edge push in a direction (world) that the neighbouring edge must meet first?
// A true normal at a corner has both edges behind it, on whichever side of the chain the other thing is; where the chain
// bends toward the other there is none, and only the edges' own normals are left.
//
//          n    ghost       from behind it, the ghost corner tells where the chain goes on
//           \  /
//     _______\/
bool faces_neighbour(const Placed& edge, std::uint32_t corner, Vec2 normal) {
    constexpr float kStraight = 1e-4f; // sine of a bend that counts as none; at zero, rounding could hide both edges
    if ((edge.piece.ghosts & (corner == 0 ? kGhostBefore : kGhostAfter)) == 0) return false;
    Vec2 on = edge.points.data()[2 + corner] - edge.points[corner]; // ghosts lie behind the corners in the pool
    return dot(unrotate(edge.pose.q, normal), on) > kStraight * length(on);
}

// As best_edge, but of those edges alone from which the chain's edge may be pushed.
Best best_free_edge(const Placed& face, const Placed& chain, const Pose& to_chain, float margin) {
    Best best;
    for (std::uint32_t e = 0; e < face.piece.count; ++e) {
        Vec2 n = rotate(to_chain.q, face.normals[e]), start = transform(to_chain, face.points[e]);
        float first = dot(n, chain.points[0] - start), second = dot(n, chain.points[1] - start);
        float s = std::min(first, second);
        if (s > margin) return {s, e};
        if (s <= best.separation) continue;
        Vec2 push = -rotate(face.pose.q, face.normals[e]);
        bool level = first == second;
        if (!level && faces_neighbour(chain, first < second ? 0 : 1, push)) continue;
        best = {s, e};
    }
    return best;
}

// Two cores that are apart and whose skins may touch. Where an edge faces a corner or an edge, it is as without skins; where
// two corners are nearest, they touch as two circles do.
ManifoldSketch collide_rounded(const Placed& a, const Placed& b, float margin, float apart, auto&& flat) {
    constexpr double kFlat =
        0.999; // cosine of the angle up to which the edge counts: two points hold steadier than one
    Proxy first{a.points, a.piece.radius}, second{b.points, b.piece.radius};
    Nearest n = distance(first, a.pose, second, b.pose);
    if (n.core == 0.0) return flat();
    if (n.distance > double(margin)) return {};
    if (double(apart) >= kFlat * n.core) {
        ManifoldSketch m = flat();
        if (m.count > 0) return m;
    }
    if (n.count == 1 &&
        (faces_neighbour(a, n.corner_a[0], narrow(n.normal)) || faces_neighbour(b, n.corner_b[0], narrow(-n.normal))))
        return {};
    Vec2 normal = narrow(n.normal), surface = a.pose.p + narrow(n.a) + a.piece.radius * normal;
    std::uint32_t corners = (n.corner_a[0] & 0x3fffu) << 17 | (n.corner_b[0] & 0x3fffu) << 3;
    return one_point(surface, normal, static_cast<float>(n.distance), corners | 2u);
}

ManifoldSketch collide_polygons(const Placed& a, const Placed& b, float margin, Axis& axis) {
    Pose a_in_b = relative(b.pose, a.pose), b_in_a = relative(a.pose, b.pose);
    float skins = skins_of(a, b), clip_margin = margin;
    margin += skins;  // from here on distances are the cores'
    if (axis.known) { // most pairs that were apart are kept apart by the same axis still
        const Placed &face = axis.of_b ? b : a, &other = axis.of_b ? a : b;
        if (axis.edge < face.piece.count &&
            separation_along(face, axis.edge, other, axis.of_b ? b_in_a : a_in_b) > margin)
            return {};
    }
    Best of_a = b.piece.ghosts != 0 ? best_free_edge(a, b, a_in_b, margin) : best_edge(a, b, a_in_b, margin);
    if (of_a.separation > margin) {
        axis = {static_cast<std::uint16_t>(of_a.edge), false, true};
        return {};
    }
    Best of_b = a.piece.ghosts != 0 ? best_free_edge(b, a, b_in_a, margin) : best_edge(b, a, b_in_a, margin);
    if (of_b.separation > margin) {
        axis = {static_cast<std::uint16_t>(of_b.edge), true, true};
        return {};
    }
    float bias = axis.known && axis.of_b ? -kReferenceBias : kReferenceBias; // stay with the last reference polygon
    bool use_b = of_b.separation > of_a.separation + bias;
    axis = {static_cast<std::uint16_t>(use_b ? of_b.edge : of_a.edge), use_b, true};
    auto flat = [&] {
        return use_b ? clip(b, of_b.edge, a, clip_margin, true) : clip(a, of_a.edge, b, clip_margin, false);
    };
    bool lines = a.piece.count == 2 && b.piece.count == 2; // behind one another they are apart along no edge's normal
    float apart = std::max(of_a.separation, of_b.separation);
    bool bare = a.piece.radius + b.piece.radius == 0.0f;
    if (bare || (apart <= 0.0f && !lines)) return flat();
    return collide_rounded(a, b, clip_margin, apart, flat);
}

ManifoldSketch collide_circles(const Placed& a, const Placed& b, float margin) {
    Vec2 ca = transform(a.pose, a.piece.centre), cb = transform(b.pose, b.piece.centre);
    Vec2 d = cb - ca;
    float distance = length(d), separation = distance - a.piece.radius - b.piece.radius;
    if (separation > margin) return {};
    Vec2 normal = distance > 0.0f ? (1.0f / distance) * d : Vec2{0, 1}; // one inside the other's centre: any way out
    return one_point(ca + a.piece.radius * normal, normal, separation, 0);
}

// The nearest point of the polygon to the circle's centre decides: a corner, or the face it lies over.
ManifoldSketch collide_polygon_circle(const Placed& polygon, const Placed& circle, float margin, Axis& axis,
                                      bool flipped) {
    Vec2 c = untransform(polygon.pose, transform(circle.pose, circle.piece.centre));
    float skin = polygon.piece.radius, r = circle.piece.radius + skin;
    auto height = [&](std::uint32_t e) { return dot(polygon.normals[e], c - polygon.points[e]); };
    if (axis.known && axis.edge < polygon.piece.count && height(axis.edge) > r + margin) return {};

    std::uint32_t edge = 0;
    float best = -1e30f;
    for (std::uint32_t e = 0; e < polygon.piece.count; ++e) {
        float h = height(e);
        if (h > best) best = h, edge = e;
    }
    axis = {static_cast<std::uint16_t>(edge), flipped, true};
    if (best > r + margin) return {};

    Vec2 v1 = polygon.points[edge], v2 = polygon.points[edge + 1 < polygon.piece.count ? edge + 1 : 0];
    Vec2 normal = polygon.normals[edge], surface = c - best * normal;
    float separation = best - r;
    std::uint32_t id = edge << 2;
    float along = dot(v2 - v1, c - v1), whole = length_squared(v2 - v1);
    if (best >= 0.0f && (along < 0.0f || along > whole)) { // outside, beyond an end of the face: a corner is nearest
        surface = along < 0.0f ? v1 : v2;
        float distance = length(c - surface);
        if (distance > r + margin) return {};
        if (distance > 0.0f) normal = (1.0f / distance) * (c - surface);
        std::uint32_t corner = (along < 0.0f) == (edge == 0) ? 0 : 1; // of a chain's edge
        if (polygon.piece.ghosts != 0 && faces_neighbour(polygon, corner, rotate(polygon.pose.q, normal))) return {};
        separation = distance - r;
        id |= along < 0.0f ? 1u : 2u;
    }
    Vec2 n = rotate(polygon.pose.q, normal), s = transform(polygon.pose, surface + skin * normal);
    return flipped ? one_point(s + separation * n, -n, separation, id) : one_point(s, n, separation, id);
}

} // namespace

Placed place(const Shapes& shapes, const Piece& piece, const Pose& pose) {
    return {piece, points_of(shapes, piece), normals_of(shapes, piece), pose};
}

ManifoldSketch collide(const Placed& a, const Placed& b, float margin, Axis& axis) {
    bool round_a = a.piece.count == 0, round_b = b.piece.count == 0;
    if (round_a && round_b) return collide_circles(a, b, margin);
    if (round_b) return collide_polygon_circle(a, b, margin, axis, false);
    if (round_a) return collide_polygon_circle(b, a, margin, axis, true);
    return collide_polygons(a, b, margin, axis);
}

} // namespace evil
