// Convex polygons of up to eight corners. Those with fewer repeat their first corner and their last edge's normal: a corner
// more changes no distance, and an edge that equals another is never better.
#include "collider/wide_forms.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr int kMost = 8; // corners

struct WideCorners { // from the middle of the form, along its axes; normal i is of the edge from corner i to i + 1
    WideVec point[kMost], normal[kMost];
};

EVIL_INLINE WideCorners load_corners(const float* corners, const std::uint32_t* pieces) {
    WideCorners w;
    Floats f[4][8];
    std::uint32_t row[kLanes];
    for (int i = 0; i < kLanes; ++i) row[i] = 4 * pieces[i];
    for (int k = 0; k < 4; ++k) load_rows(corners + 8 * k, row, f[k]);
    for (int i = 0; i < kMost; ++i) {
        w.point[i] = {f[0][i], f[1][i]};
        w.normal[i] = {f[2][i], f[3][i]};
    }
    return w;
}

EVIL_INLINE WideVec pick(const WideVec* list, Ints number) {
    WideVec v = list[0];
    for (int i = 1; i < kMost; ++i) v = select(number == Ints(i), list[i], v);
    return v;
}

EVIL_INLINE Ints after(Ints corner, Ints corners) {
    Ints next = corner + 1;
    return select(next < corners, next, Ints(0));
}

struct Search {
    WideBest best;
    Floats remembered; // separation along the edge that was asked for
};

// How far the nearest corner of `other` (in face's axes) lies outside each edge of `face`.
EVIL_INLINE Search search(const WideCorners& face, const WideVec* other, Ints corners, Ints remembered, Floats margin) {
    Search r;
    r.remembered = -1e30f;
    for (int e = 0; e < kMost; ++e) {
        WideVec n = face.normal[e];
        Floats nearest = dot(n, other[0]);
        for (int k = 1; k < kMost; ++k) nearest = min(nearest, dot(n, other[k]));
        Floats s = select(Ints(e) < corners, nearest - dot(n, face.point[e]), Floats(-1e30f));
        r.best.see(s, e, margin);
        r.remembered = select(remembered == Ints(e), s, r.remembered);
    }
    return r;
}

EVIL_INLINE Ints most_opposed(const WideCorners& other, WideVec n, Ints corners) {
    Floats most = dot(n, other.normal[0]);
    Ints edge = 0;
    for (int e = 1; e < kMost; ++e) {
        Floats d = dot(n, other.normal[e]);
        Mask more = (d < most) & (Ints(e) < corners);
        most = select(more, d, most);
        edge = select(more, Ints(e), edge);
    }
    return edge;
}

EVIL_INLINE void select_corners(Mask m, const WideCorners& yes, const WideCorners& no, WideCorners& to) {
    for (int i = 0; i < kMost; ++i) {
        to.point[i] = select(m, yes.point[i], no.point[i]);
        to.normal[i] = select(m, yes.normal[i], no.normal[i]);
    }
}

} // namespace

void collide_polygons(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    const WidePair p = load_pair(t, pairs.a, pairs.b);
    const WideCorners a = load_corners(t.corners, pairs.a), b = load_corners(t.corners, pairs.b);
    Ints corners_a = load(pairs.corners_a), corners_b = load(pairs.corners_b);
    Floats c = p.a.c * p.b.c + p.a.s * p.b.s, s = p.a.c * p.b.s - p.a.s * p.b.c; // b's turn seen from a
    WideVec b_in_a = unrotate(p.a.c, p.a.s, p.between), a_in_b = -unrotate(p.b.c, p.b.s, p.between);
    WideVec moved[kMost];
    Ints axis = load(pairs.axis), last_edge = axis & (kAxisOfB - 1);
    for (int i = 0; i < kMost; ++i) moved[i] = rotate(c, s, b.point[i]) + b_in_a;
    Search of_a = search(a, moved, corners_a, last_edge, p.margin);
    for (int i = 0; i < kMost; ++i) moved[i] = unrotate(c, s, a.point[i]) + a_in_b;
    Search of_b = search(b, moved, corners_b, last_edge, p.margin);

    Mask was_b = (axis & kAxisOfB) == Ints(kAxisOfB), known = axis > Ints(-1);
    Mask kept = known & (select(was_b, of_b.remembered, of_a.remembered) > p.margin);
    WideChoice choice = choose(kept, axis, of_a.best, of_b.best, p.margin, t.bias);

    // Clip the incident edge of the other polygon against the sides of the reference edge, in the reference's axes.
    WideCorners face, other;
    select_corners(choice.of_b, b, a, face);
    select_corners(choice.of_b, a, b, other);
    Ints face_corners = select(choice.of_b, corners_b, corners_a), other_corners = corners_a + corners_b - face_corners;
    Floats turned = select(choice.of_b, -s, s);
    WideVec middle = select(choice.of_b, a_in_b, b_in_a);
    WideVec v1 = pick(face.point, choice.edge), v2 = pick(face.point, after(choice.edge, face_corners));
    WideVec n = pick(face.normal, choice.edge), along = left_of(n);
    Ints incident = most_opposed(other, unrotate(c, turned, n), other_corners);
    WideVec w2 = rotate(c, turned, pick(other.point, incident)) + middle - v1;
    WideVec w1 = rotate(c, turned, pick(other.point, after(incident, other_corners))) + middle - v1;

    Floats low = 0.0f, high = dot(along, v2 - v1), t1 = dot(along, w1), t2 = dot(along, w2);
    Floats h1 = dot(n, w1), h2 = dot(n, w2), span = t2 - t1; // heights over the reference edge
    Mask wide = span > low;
    Mask lower1 = h1 < h2; // an incident edge that stands on end: its nearer corner alone can touch
    Floats end_t = select(lower1, t1, t2), end_h = select(lower1, h1, h2);
    t1 = select(wide, t1, end_t);
    t2 = select(wide, t2, end_t);
    h1 = select(wide, h1, end_h);
    h2 = select(wide, h2, end_h);
    Mask beside = (t2 < low) | (t1 > high);
    Floats slope = (h2 - h1) / select(wide, span, Floats(1.0f));
    Floats g1 = select(wide & (t1 < low), h1 + slope * (low - t1), h1), at1 = select(wide, max(t1, low), t1);
    Floats g2 = select(wide & (t2 > high), h1 + slope * (high - t1), h2), at2 = select(wide, min(t2, high), t2);

    Floats turn_c = select(choice.of_b, p.b.c, p.a.c), turn_s = select(choice.of_b, p.b.s, p.a.s);
    WideVec from_a = select(choice.of_b, p.between, WideVec{0.0f, 0.0f});
    Ints id = clip_id(choice.of_b, choice.edge, incident);
    auto point = [&](Floats gap, Floats at, int which) {
        WideVec here = v1 + at * along + Floats(0.5f) * gap * n;
        return WidePoint{from_a + rotate(turn_c, turn_s, here), gap, id | Ints(which)};
    };
    Mask near = ~(choice.apart | beside);
    WideVec normal = rotate(turn_c, turn_s, n);
    store_manifold(p, select(choice.of_b, -normal, normal), near & (g1 <= p.margin), point(g1, at1, 0),
                   near & wide & (g2 <= p.margin), point(g2, at2, 1), choice.axis, out);
}

namespace {

// The nearest point of the polygon to the circle's middle decides: a corner, or the face it lies over.
template <bool swapped>
EVIL_INLINE void polygon_and_circle(const FormTables& t, const EightPairs& pairs, EightManifolds& out) {
    const WidePair p = swapped ? load_pair(t, pairs.b, pairs.a) : load_pair(t, pairs.a, pairs.b);
    const WideCorners polygon = load_corners(t.corners, swapped ? pairs.b : pairs.a);
    Ints corners = load(swapped ? pairs.corners_b : pairs.corners_a);
    Floats r = p.b.radius, zero = 0.0f, remembered = -1e30f;
    WideVec c = unrotate(p.a.c, p.a.s, p.between);
    Ints axis = load(pairs.axis), last_edge = axis & (kAxisOfB - 1);
    WideBest face;
    for (int e = 0; e < kMost; ++e) {
        Floats height = select(Ints(e) < corners, dot(polygon.normal[e], c - polygon.point[e]), Floats(-1e30f));
        face.see(height, e, Floats(1e30f));
        remembered = select(last_edge == Ints(e), height, remembered);
    }
    Mask kept = (axis > Ints(-1)) & (remembered > r + p.margin);

    WideVec v1 = pick(polygon.point, face.edge), v2 = pick(polygon.point, after(face.edge, corners));
    WideVec n = pick(polygon.normal, face.edge), side = v2 - v1;
    Floats along = dot(side, c - v1), whole = dot(side, side);
    Mask before = along < zero, corner = (face.separation > zero) & (before | (along > whole));
    WideVec nearest = select(corner, select(before, v1, v2), c - face.separation * n);
    WideVec away = c - nearest;
    Floats distance = length(away);
    Mask aslant = corner & (distance > zero);
    n = select(aslant, {away.x / distance, away.y / distance}, n);
    Floats gap = select(corner, distance, face.separation) - r;

    WideVec normal = rotate(p.a.c, p.a.s, n);
    Ints id = (face.edge << 2) | select(corner, select(before, Ints(1), Ints(2)), Ints(0));
    WidePoint point{rotate(p.a.c, p.a.s, nearest) + Floats(0.5f) * gap * normal, gap, id};
    Ints found = face.edge | Ints(swapped ? kAxisOfB : 0);
    store_single<swapped>(p, normal, ~kept & (gap <= p.margin), point, select(kept, axis, found), out);
}

} // namespace

void collide_polygon_circle(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    polygon_and_circle<false>(t, pairs, out);
}
void collide_circle_polygon(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    polygon_and_circle<true>(t, pairs, out);
}

} // namespace evil::EVIL_ISA
