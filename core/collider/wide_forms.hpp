#pragma once
// What the kernels for pairs share: two placed forms in eight lanes, and how a manifold leaves.
#include "collider/manifolds_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {

struct WideForm { // fields of PlacedForm in their order
    Floats origin_x, origin_y, arm_x, arm_y, c, s, half_x, half_y;
    Floats path_x, path_y, swing, reach, radius, grow, centre_x, centre_y;
};

EVIL_INLINE WideForm load_form(const float* placed, const std::uint32_t* pieces) {
    std::uint32_t row[kLanes];
    for (int i = 0; i < kLanes; ++i) row[i] = 2 * pieces[i];
    Floats f[8], g[8];
    load_rows(placed, row, f);
    load_rows(placed + 8, row, g);
    return {f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7]};
}

struct WideVec {
    Floats x, y;
};
EVIL_INLINE WideVec operator+(WideVec a, WideVec b) { return {a.x + b.x, a.y + b.y}; }
EVIL_INLINE WideVec operator-(WideVec a, WideVec b) { return {a.x - b.x, a.y - b.y}; }
EVIL_INLINE WideVec operator-(WideVec a) { return {-a.x, -a.y}; }
EVIL_INLINE WideVec operator*(Floats k, WideVec a) { return {k * a.x, k * a.y}; }
EVIL_INLINE Floats dot(WideVec a, WideVec b) { return a.x * b.x + a.y * b.y; }
EVIL_INLINE WideVec left_of(WideVec a) { return {-a.y, a.x}; }
EVIL_INLINE Floats length(WideVec a) { return sqrt(dot(a, a)); }
EVIL_INLINE WideVec rotate(Floats c, Floats s, WideVec a) { return {c * a.x - s * a.y, s * a.x + c * a.y}; }
EVIL_INLINE WideVec unrotate(Floats c, Floats s, WideVec a) { return {c * a.x + s * a.y, c * a.y - s * a.x}; }
EVIL_INLINE WideVec select(Mask m, WideVec a, WideVec b) { return {select(m, a.x, b.x), select(m, a.y, b.y)}; }

struct WidePair {
    WideForm a, b;
    WideVec apart;   // from a's origin to b's
    WideVec between; // from a's middle to b's
    Floats margin;   // see margin_of in manifolds.cpp
};

EVIL_INLINE WidePair load_pair(const FormTables& t, const std::uint32_t* a, const std::uint32_t* b) {
    WidePair p{load_form(t.placed, a), load_form(t.placed, b), {}, {}, {}};
    p.apart = {p.b.origin_x - p.a.origin_x, p.b.origin_y - p.a.origin_y};
    p.between = p.apart + WideVec{p.b.arm_x - p.a.arm_x, p.b.arm_y - p.a.arm_y};
    Floats path = length({p.b.path_x - p.a.path_x, p.b.path_y - p.a.path_y}) + p.a.swing + p.b.swing;
    p.margin = Floats(t.margin) + min(path, Floats(0.5f) * min(p.a.reach, p.b.reach));
    return p;
}

struct WidePoint {
    WideVec at; // from a's middle, world axes
    Floats separation;
    Ints id;
};

EVIL_INLINE WidePoint select(Mask m, const WidePoint& p, const WidePoint& q) {
    return {select(m, p.at, q.at), select(m, p.separation, q.separation), select(m, p.id, q.id)};
}

EVIL_INLINE Ints count_of(Mask m) { return select(m, Ints(1), Ints(0)); }

// Anchors go from the centres of mass. `swapped`: the pair was loaded the other way round.
template <bool swapped = false>
EVIL_INLINE void store_point(const WidePair& p, const WidePoint& point, EightManifolds& out, int i) {
    WideVec from_a = point.at + WideVec{p.a.arm_x, p.a.arm_y}, from_b = from_a - p.apart;
    WideVec anchor_a = from_a - WideVec{p.a.centre_x, p.a.centre_y};
    WideVec anchor_b = from_b - WideVec{p.b.centre_x, p.b.centre_y};
    auto& to = out.points[i];
    store(to.anchor_ax, swapped ? anchor_b.x : anchor_a.x);
    store(to.anchor_ay, swapped ? anchor_b.y : anchor_a.y);
    store(to.anchor_bx, swapped ? anchor_a.x : anchor_b.x);
    store(to.anchor_by, swapped ? anchor_a.y : anchor_b.y);
    store(to.separation, point.separation);
    store(to.id, point.id);
}

// One or two points that are kept, the first of them first.
EVIL_INLINE void store_manifold(const WidePair& p, WideVec normal, Mask first, const WidePoint& one, Mask second,
                                const WidePoint& two, Ints axis, EightManifolds& out) {
    store(out.count, count_of(first) + count_of(second));
    store(out.axis, axis);
    store(out.normal_x, normal.x);
    store(out.normal_y, normal.y);
    store_point(p, select(first, one, two), out, 0);
    store_point(p, two, out, 1);
}

// A circle is p.b; `swapped` when the contact has it first.
template <bool swapped>
EVIL_INLINE void store_single(const WidePair& p, WideVec normal, Mask kept, const WidePoint& point, Ints axis,
                              EightManifolds& out) {
    store(out.count, count_of(kept));
    store(out.axis, axis);
    store(out.normal_x, swapped ? -normal.x : normal.x);
    store(out.normal_y, swapped ? -normal.y : normal.y);
    store_point<swapped>(p, point, out, 0);
    store_point<swapped>(p, point, out, 1);
}

// The edge that keeps the other form out best; the search stops at the first that keeps it out by more than the margin.
struct WideBest {
    Floats separation = -1e30f;
    Ints edge = 0;
    EVIL_INLINE void see(Floats s, int e, Floats margin) {
        Mask better = (separation <= margin) & (s > separation);
        separation = select(better, s, separation);
        edge = select(better, Ints(e), edge);
    }
};

// What SAT says of two polygons: kept apart, by which axis; or which edge of which is the reference (SPEC C3).
struct WideChoice {
    Mask apart, of_b;
    Ints edge, axis;
};

EVIL_INLINE WideChoice choose(Mask kept, Ints axis, const WideBest& a, const WideBest& b, Floats margin, float bias) {
    Mask apart_a = a.separation > margin, apart_b = ~apart_a & (b.separation > margin);
    Mask had_b = (axis > Ints(0)) & ((axis & kAxisOfB) == Ints(kAxisOfB));
    Mask better_b = b.separation > a.separation + select(had_b, Floats(-bias), Floats(bias));
    Mask of_b = apart_b | (~apart_a & better_b);
    Ints edge = select(of_b, b.edge, a.edge);
    Ints chosen = edge | select(of_b, Ints(kAxisOfB), Ints(0));
    return {kept | apart_a | apart_b, of_b, edge, select(kept, axis, chosen)};
}

EVIL_INLINE Ints clip_id(Mask of_b, Ints edge, Ints incident) {
    return select(of_b, Ints(INT32_MIN), Ints(0)) | (edge << 17) | (incident << 3);
}

} // namespace evil::EVIL_ISA
