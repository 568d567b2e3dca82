#include "gpu/sprites.hpp"
#include <algorithm>
#include <cmath>

namespace evil::gpu {
namespace {

constexpr float kLarge =
    8192.0f; // pixels from its middle: what is seen of a smaller box is not beyond kFar of instances.cpp
constexpr float kThin = 1.5f;   // pixels: thicker, and no pixel touches two sides that lie opposite
constexpr float kAskew = 1e-3f; // cosine between the axes from which on a box is no longer one
constexpr float kSharp = 2.25f; // texels in a pixel, squared, from which on a smaller copy is drawn from (shape.frag)

// Texels of the whole picture in one pixel, squared. `area`: of a quarter of the box. u and v are texture coordinates.
float texels_squared(const Spot& whole, const Sprite& s, float area) {
    const float each = 1.0f / area, width = whole.width * each, height = whole.height * each;
    const float ux = (s.ua * s.by - s.ub * s.ay) * width, uy = (s.ub * s.ax - s.ua * s.bx) * width;
    const float vx = (s.va * s.by - s.vb * s.ay) * height, vy = (s.vb * s.ax - s.va * s.bx) * height;
    return std::max(ux * ux + vx * vx, uy * uy + vy * vy);
}

// The copy that `soft` would draw from.
const Spot& copy_for(const Place& place, float squared) {
    if (!(squared > kSharp) || place.copies.size() < 2) return place.copies[0];
    const float level = std::ceil(0.5f * std::log2(squared / kSharp));
    return place.copies[static_cast<std::size_t>(std::min(level, static_cast<float>(place.copies.size() - 1)))];
}

// A pixel that a side covers in part has its middle at most 0.71 pixels inside; its colour is mixed from the texels up to half
// a texel from there. `whole`: the box's sides are the picture's.
Fringe fringe_of(const Spot& spot, bool whole, float squared) {
    if (!whole) return Fringe::corners;
    if (spot.border >= 2.0f || (spot.border >= 1.0f && squared < 1.21f)) return Fringe::none;
    return spot.clear_corners ? Fringe::sides : Fringe::corners;
}

// The sides from `low` to `high` move in to where a copy is no longer clear, along one of its axes. `step` texels lie between
// the middle of the box, at texel `at`, and its side; a texel shows half a texel beyond itself, the last ones for ever.
void trim(float& low, float& high, float at, float step, float first, float last, float size) {
    const float a_texel = 1.0f / step, before = (first - 0.5f - at) * a_texel, after = (last + 0.5f - at) * a_texel;
    if (step > 0) {
        if (first > 0) low = std::max(low, before);
        if (last < size) high = std::min(high, after);
    } else {
        if (first > 0) high = std::min(high, before);
        if (last < size) low = std::max(low, after);
    }
}

// What is surely clear is left out.
void trim_to_seen(Sprite& s, const Spot& spot) {
    const Rect& seen = spot.seen;
    if (seen.left == 0 && seen.low == 0 && seen.right == spot.width && seen.high == spot.height) return;
    Rect& r = s.reach;
    if (s.ub == 0 && s.va == 0 && s.ua != 0 && s.vb != 0) {
        trim(r.left, r.right, s.uc, s.ua, seen.left, seen.right, spot.width);
        trim(r.low, r.high, s.vc, s.vb, seen.low, seen.high, spot.height);
    } else if (s.ua == 0 && s.vb == 0 && s.ub != 0 && s.va != 0) {
        trim(r.low, r.high, s.uc, s.ub, seen.left, seen.right, spot.width);
        trim(r.left, r.right, s.vc, s.va, seen.low, seen.high, spot.height);
    }
}

// From coordinates of the picture to texels of the page.
void set_texels(Sprite& s, const Spot& spot) {
    s.uc *= spot.width, s.ua *= spot.width, s.ub *= spot.width;
    s.vc *= spot.height, s.va *= spot.height, s.vb *= spot.height;
    trim_to_seen(s, spot);
    s.uc += spot.left, s.vc += spot.top;
}

// Where in the picture the box's middle is, and its sides; whether those are the picture's. False if it repeats.
bool set_coordinates(Sprite& s, const Box& box, const Affine& m, bool& whole) {
    if (m == Affine{}) {
        s.uc = box.u, s.vc = box.v, s.ua = box.up, s.va = box.vp, s.ub = box.uq, s.vb = box.vq;
        whole = box.whole;
        return !box.repeats;
    }
    s.uc = m.a * box.u + m.c * box.v + m.tx, s.vc = m.b * box.u + m.d * box.v + m.ty;
    s.ua = m.a * box.up + m.c * box.vp, s.va = m.b * box.up + m.d * box.vp;
    s.ub = m.a * box.uq + m.c * box.vq, s.vb = m.b * box.uq + m.d * box.vq;
    const float across = std::fabs(s.ua) + std::fabs(s.ub), down = std::fabs(s.va) + std::fabs(s.vb);
    whole = reach(across, down);
    return !leave(s.uc, s.vc, across, down);
}

} // namespace

Spot make_spot(float left, float top, float width, float height, Rect seen, bool clear_corners) {
    const float border = std::min({seen.left, seen.low, width - seen.right, height - seen.high});
    return {left, top, width, height, seen, clear_corners, border};
}

Fit fit(Sprite& s, Way& way, const draw::Instance& instance, const Box& box, const Places& places,
        std::uint32_t texture, bool lit, Rect target) {
    if (!box.is || instance.outline != 0.0f) return Fit::other;
    const std::uint32_t alpha = instance.tint >> 24;
    if (alpha == 0) return Fit::nothing;
    if (texture >= places.pictures.size() || places.pictures[texture].copies.empty()) return Fit::other;
    const Place& place = places.pictures[texture];
    const Affine& m = instance.to_pixel;
    s.x = m.a * box.x + m.c * box.y + m.tx, s.y = m.b * box.x + m.d * box.y + m.ty;
    s.ax = m.a * box.w, s.ay = m.b * box.w, s.bx = m.c * box.h, s.by = m.d * box.h;

    const float a2 = s.ax * s.ax + s.ay * s.ay, b2 = s.bx * s.bx + s.by * s.by;
    const float least = 0.25f * kThin * kThin, askew = s.ax * s.bx + s.ay * s.by;
    if (!(std::min(a2, b2) > least) || !(askew * askew <= kAskew * kAskew * a2 * b2)) return Fit::other;
    const float x = std::fabs(s.ax) + std::fabs(s.bx), y = std::fabs(s.ay) + std::fabs(s.by);
    if (!(s.x - x < target.right && s.x + x > target.left && s.y - y < target.high && s.y + y > target.low))
        return Fit::nothing;
    if (!(std::max(x, y) < kLarge)) return Fit::other;

    s.how = 0, s.tint = instance.tint;
    if (lit) s.how |= kLit;
    if (instance.blend == draw::Blend::add) s.how |= kAdds;
    // The last pixels of which a side takes some have their middle half a pixel's width beyond it.
    const float over_a = 0.5f * (std::fabs(s.ax) + std::fabs(s.ay)) / a2;
    const float over_b = 0.5f * (std::fabs(s.bx) + std::fabs(s.by)) / b2;
    s.reach = {-1.0f - over_a, -1.0f - over_b, 1.0f + over_a, 1.0f + over_b};
    way = {place.page, Fringe::corners};
    if (texture == draw::kNoTexture) {
        const Spot& white = place.copies[0];
        s.uc = white.left + 0.5f, s.vc = white.top + 0.5f, s.ua = s.va = s.ub = s.vb = 0;
        return Fit::sprite;
    }
    bool whole = false;
    if (!set_coordinates(s, box, instance.to_texture, whole)) return Fit::other;
    const float squared = texels_squared(place.copies[0], s, s.ax * s.by - s.ay * s.bx);
    const Spot& spot = copy_for(place, squared);
    set_texels(s, spot);
    way.fringe = fringe_of(spot, whole, squared);
    return s.reach.left < s.reach.right && s.reach.low < s.reach.high ? Fit::sprite : Fit::nothing;
}

} // namespace evil::gpu
