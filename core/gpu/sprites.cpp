#include "gpu/sprites.hpp"
#include <algorithm>
#include <cmath>

namespace evil::gpu {
namespace {

constexpr float kFar = 32768.0f; // pixels, as in batches.cpp
constexpr float kThin = 1.5f;    // pixels: thicker, and no pixel touches two sides that lie opposite
constexpr float kAskew = 1e-3f;  // cosine between the axes from which on a box is no longer one
constexpr float kSharp = 2.25f;  // texels in a pixel, squared, from which on a smaller copy is drawn from (shape.frag)

// Texels of the whole picture in one pixel, squared. `area`: of a quarter of the box. u and v are texture coordinates.
float texels_squared(const Spot& whole, const Sprite& s, float area) {
    const float width = whole.width / area, height = whole.height / area;
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
// a texel from there. u and v are texels of the copy.
Fringe fringe_of(const Spot& spot, const Sprite& s, float squared) {
    const bool whole = std::fabs(s.ua) + std::fabs(s.ub) > 0.5f * spot.width - 0.01f &&
                       std::fabs(s.va) + std::fabs(s.vb) > 0.5f * spot.height - 0.01f;
    if (!whole) return Fringe::corners;
    const Rect& seen = spot.seen;
    const float border = std::min({seen.left, seen.low, spot.width - seen.right, spot.height - seen.high});
    if (border >= 2.0f || (border >= 1.0f && squared < 1.21f)) return Fringe::none;
    return spot.clear_corners ? Fringe::sides : Fringe::corners;
}

// The sides from `low` to `high` move in to where a copy is no longer clear, along one of its axes. `step` texels lie between
// the middle of the box, at texel `at`, and its side; a texel shows half a texel beyond itself, the last ones for ever.
void trim(float& low, float& high, float at, float step, float first, float last, float size) {
    const float before = (first - 0.5f - at) / step, after = (last + 0.5f - at) / step;
    if (step > 0) {
        if (first > 0) low = std::max(low, before);
        if (last < size) high = std::min(high, after);
    } else {
        if (first > 0) high = std::min(high, before);
        if (last < size) low = std::max(low, after);
    }
}

// From coordinates of the picture to texels of the page; what is surely clear is left out.
void set_texels(Sprite& s, const Spot& spot) {
    s.uc *= spot.width, s.ua *= spot.width, s.ub *= spot.width;
    s.vc *= spot.height, s.va *= spot.height, s.vb *= spot.height;
    const auto trim_u = [&](float& low, float& high, float step) {
        trim(low, high, s.uc, step, spot.seen.left, spot.seen.right, spot.width);
    };
    const auto trim_v = [&](float& low, float& high, float step) {
        trim(low, high, s.vc, step, spot.seen.low, spot.seen.high, spot.height);
    };
    if (s.ub == 0 && s.va == 0 && s.ua != 0 && s.vb != 0)
        trim_u(s.reach.left, s.reach.right, s.ua), trim_v(s.reach.low, s.reach.high, s.vb);
    else if (s.ua == 0 && s.vb == 0 && s.ub != 0 && s.va != 0)
        trim_u(s.reach.low, s.reach.high, s.ub), trim_v(s.reach.left, s.reach.right, s.va);
    s.uc += spot.left, s.vc += spot.top;
}

// Where in the picture the box's middle is, and its sides.
void set_coordinates(Sprite& s, const Box& box, const Affine& m) {
    if (m == Affine{}) {
        s.uc = box.u, s.vc = box.v, s.ua = box.up, s.va = box.vp, s.ub = box.uq, s.vb = box.vq;
        return;
    }
    s.uc = m.a * box.u + m.c * box.v + m.tx, s.vc = m.b * box.u + m.d * box.v + m.ty;
    s.ua = m.a * box.up + m.c * box.vp, s.va = m.b * box.up + m.d * box.vp;
    s.ub = m.a * box.uq + m.c * box.vq, s.vb = m.b * box.uq + m.d * box.vq;
}

bool repeats(const Sprite& s) {
    const float u = std::fabs(s.ua) + std::fabs(s.ub), v = std::fabs(s.va) + std::fabs(s.vb);
    return !(s.uc - u > -0.001f && s.uc + u < 1.001f && s.vc - v > -0.001f && s.vc + v < 1.001f);
}

} // namespace

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
    if (!(s.x + x < kFar && s.x - x > -kFar && s.y + y < kFar && s.y - y > -kFar)) return Fit::other;

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
    set_coordinates(s, box, instance.to_texture);
    if (repeats(s)) return Fit::other;
    const float squared = texels_squared(place.copies[0], s, s.ax * s.by - s.ay * s.bx);
    const Spot& spot = copy_for(place, squared);
    set_texels(s, spot);
    way.fringe = fringe_of(spot, s, squared);
    return s.reach.left < s.reach.right && s.reach.low < s.reach.high ? Fit::sprite : Fit::nothing;
}

} // namespace evil::gpu
