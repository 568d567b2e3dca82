// Boxes and circles. A box is a middle, a turn and two halves, so its axes need no corners.
#include "collider/wide_forms.hpp"

namespace evil::EVIL_ISA {
namespace {

// An edge's own axes: outward along n, and t = n turned left, the way the corners run.
//
//        2            edge 0: n = -y   1: n = x   2: n = y   3: n = -x
//      3   1
//        0
struct EdgeAxes {
    Mask sideways; // edges 1 and 3
    Floats sign;
    EVIL_INLINE explicit EdgeAxes(Ints edge) {
        sideways = (edge & 1) == Ints(1);
        sign = select((edge == Ints(1)) | (edge == Ints(2)), Floats(1.0f), Floats(-1.0f));
    }
    EVIL_INLINE WideVec to(WideVec v) const { // {along n, along t}
        return {sign * select(sideways, v.x, v.y), sign * select(sideways, v.y, -v.x)};
    }
    EVIL_INLINE WideVec from(WideVec v) const {
        return {sign * select(sideways, v.x, -v.y), sign * select(sideways, v.y, v.x)};
    }
    EVIL_INLINE WideVec halves(Floats x, Floats y) const { // across the edge, along it
        return {select(sideways, x, y), select(sideways, y, x)};
    }
};

// How far edges 0 to 3 of a box keep out another form: its middle lies at v, and it reaches x and y to either side.
struct Separations {
    Floats of[4];
};
EVIL_INLINE Separations separations(WideVec v, Floats x, Floats y) { return {{-v.y - y, v.x - x, v.y - y, -v.x - x}}; }

EVIL_INLINE Floats at(const Separations& s, Ints edge) {
    Floats r = s.of[0];
    for (int e = 1; e < 4; ++e) r = select(edge == Ints(e), s.of[e], r);
    return r;
}

EVIL_INLINE WideBest best(const Separations& s, Floats margin) {
    WideBest b;
    for (int e = 0; e < 4; ++e) b.see(s.of[e], e, margin);
    return b;
}

// The side of the other box that faces the reference edge most, in the edge's axes; u is the other box's x axis there.
struct Incident {
    Ints edge;
    WideVec normal;
    Floats across, along; // halves of the other box
};
EVIL_INLINE Incident incident(WideVec u, Floats half_x, Floats half_y) {
    Floats opposed[4] = {u.y, u.x, -u.y, -u.x}; // of the normals -y, x, y, -x, where y = u turned left
    Floats most = opposed[0];
    Ints edge = 0;
    for (int e = 1; e < 4; ++e) {
        Mask more = opposed[e] < most;
        most = select(more, opposed[e], most);
        edge = select(more, Ints(e), edge);
    }
    EdgeAxes axes(edge);
    WideVec halves = axes.halves(half_x, half_y);
    return {edge, axes.sign * select(axes.sideways, u, left_of(u)), halves.x, halves.y};
}

} // namespace

void collide_boxes(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    const WidePair p = load_pair(t, pairs.a, pairs.b);
    const WideForm &a = p.a, &b = p.b;
    Floats c = a.c * b.c + a.s * b.s, s = a.c * b.s - a.s * b.c, ac = abs(c), as = abs(s); // b's turn seen from a
    WideVec b_in_a = unrotate(a.c, a.s, p.between), a_in_b = -unrotate(b.c, b.s, p.between);
    Separations of_a =
        separations(b_in_a, a.half_x + (ac * b.half_x + as * b.half_y), a.half_y + (as * b.half_x + ac * b.half_y));
    Separations of_b =
        separations(a_in_b, b.half_x + (ac * a.half_x + as * a.half_y), b.half_y + (as * a.half_x + ac * a.half_y));

    Ints axis = load(pairs.axis), last_edge = axis & (kAxisOfB - 1);
    Mask was_b = (axis & kAxisOfB) == Ints(kAxisOfB), known = (axis > Ints(-1)) & (last_edge < Ints(4));
    Mask kept = known & (select(was_b, at(of_b, last_edge), at(of_a, last_edge)) > p.margin);
    WideChoice choice = choose(kept, axis, best(of_a, p.margin), best(of_b, p.margin), p.margin, t.bias);

    // In the axes of the reference edge: the other box's middle, its x axis, and its incident side from w2 to w1.
    EdgeAxes axes(choice.edge);
    WideVec halves = axes.halves(select(choice.of_b, b.half_x, a.half_x), select(choice.of_b, b.half_y, a.half_y));
    WideVec middle = axes.to(select(choice.of_b, a_in_b, b_in_a));
    Incident side = incident(axes.to({c, select(choice.of_b, -s, s)}), select(choice.of_b, a.half_x, b.half_x),
                             select(choice.of_b, a.half_y, b.half_y));
    WideVec face = middle + side.across * side.normal, reach = side.along * left_of(side.normal);
    WideVec w1 = face + reach, w2 = face - reach;

    Floats low = -halves.y, high = halves.y, span = w2.y - w1.y;
    Mask wide = span > Floats(0.0f), beside = (w2.y < low) | (w1.y > high);
    Floats slope = (w2.x - w1.x) / select(wide, span, Floats(1.0f));
    Mask cut1 = w1.y<low, cut2 = w2.y> high;
    WideVec c1 = {select(cut1, w1.x + slope * (low - w1.y), w1.x), max(w1.y, low)};
    WideVec c2 = {select(cut2, w1.x + slope * (high - w1.y), w2.x), min(w2.y, high)};

    Floats turn_c = select(choice.of_b, b.c, a.c), turn_s = select(choice.of_b, b.s, a.s);
    WideVec from_a = select(choice.of_b, p.between, WideVec{0.0f, 0.0f});
    Ints id = clip_id(choice.of_b, choice.edge, side.edge);
    auto point = [&](WideVec corner, int which) { // midway between corner and reference edge
        Floats gap = corner.x - halves.x;
        WideVec here = {corner.x - Floats(0.5f) * gap, corner.y};
        return WidePoint{from_a + rotate(turn_c, turn_s, axes.from(here)), gap, id | Ints(which)};
    };
    WidePoint one = point(c1, 0), two = point(c2, 1);
    Mask near = ~(choice.apart | beside);
    Mask first = near & (one.separation <= p.margin), second = near & wide & (two.separation <= p.margin);
    WideVec normal = rotate(turn_c, turn_s, axes.from({1.0f, 0.0f}));
    store_manifold(p, select(choice.of_b, -normal, normal), first, one, second, two, choice.axis, out);
}

void collide_circles(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    const WidePair p = load_pair(t, pairs.a, pairs.b);
    Floats distance = length(p.between), gap = distance - p.a.radius - p.b.radius;
    Mask separate = distance > Floats(0.0f);
    // Centre on centre any way out will do, but another for each pair: a crowd made in one point would rise as a column.
    Floats x = to_float((load(pairs.a) ^ (load(pairs.b) * Ints(0x2545f491))) >> 7) * Floats(1.0f / (1 << 24));
    WideVec normal = {select(separate, p.between.x / distance, x),
                      select(separate, p.between.y / distance, sqrt(Floats(1.0f) - x * x))};
    WidePoint point{(p.a.radius + Floats(0.5f) * gap) * normal, gap, 0};
    store_single<false>(p, normal, gap <= p.margin, point, load(pairs.axis), out);
}

namespace {

// The nearest point of the box to the circle's middle decides: a corner, or the side it lies over.
template <bool swapped>
EVIL_INLINE void box_and_circle(const FormTables& t, const EightPairs& pairs, EightManifolds& out) {
    const WidePair p = swapped ? load_pair(t, pairs.b, pairs.a) : load_pair(t, pairs.a, pairs.b);
    const WideForm& box = p.a;
    Floats r = p.b.radius, zero = 0.0f;
    WideVec c = unrotate(box.c, box.s, p.between);
    Separations heights = separations(c, box.half_x, box.half_y);

    Ints axis = load(pairs.axis), last_edge = axis & (kAxisOfB - 1);
    Mask known = (axis > Ints(-1)) & (last_edge < Ints(4));
    Mask kept = known & (at(heights, last_edge) > r + p.margin);
    WideBest side = best(heights, Floats(1e30f));

    EdgeAxes axes(side.edge);
    WideVec halves = axes.halves(box.half_x, box.half_y), here = axes.to(c); // {over the side's plane, along it}
    Mask before = here.y<-halves.y, beyond = here.y> halves.y;
    Mask corner = (side.separation > zero) & (before | beyond);
    WideVec nearest = {halves.x, select(corner, clamp(here.y, -halves.y, halves.y), here.y)};
    WideVec away = here - nearest;
    Floats distance = length(away);
    Mask aslant = corner & (distance > zero);
    WideVec n = {select(aslant, away.x / distance, Floats(1.0f)), select(aslant, away.y / distance, zero)};
    Floats gap = select(corner, distance, side.separation) - r;

    WideVec normal = rotate(box.c, box.s, axes.from(n));
    WideVec at_surface = rotate(box.c, box.s, axes.from(nearest));
    Ints id = (side.edge << 2) | select(corner, select(before, Ints(1), Ints(2)), Ints(0));
    WidePoint point{at_surface + Floats(0.5f) * gap * normal, gap, id};
    Ints found = side.edge | Ints(swapped ? kAxisOfB : 0);
    store_single<swapped>(p, normal, ~kept & (gap <= p.margin), point, select(kept, axis, found), out);
}

} // namespace

void collide_box_circle(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    box_and_circle<false>(t, pairs, out);
}
void collide_circle_box(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept {
    box_and_circle<true>(t, pairs, out);
}

} // namespace evil::EVIL_ISA
