#include "draw/overlay.hpp"
#include <algorithm>

namespace evil::draw {
namespace {

// Nothing of an overlay that starts this many pixels away can be seen; it also keeps NaN out.
constexpr float kFar = 1e6f;

bool near(Vec2 a) { return std::abs(a.x) < kFar && std::abs(a.y) < kFar; }

void square(const Overlay& overlay, const Affine& to_pixel, Rgba8 colour) {
    overlay.list.instances.push_back({to_pixel, {}, overlay.square, kNoTexture, colour, 0.0f});
}

} // namespace

Overlay begin_overlay(DrawList& list) {
    constexpr Vertex kSquare[] = {
        {{0, 0}, {0, 0}, ~0u}, {{1, 0}, {1, 0}, ~0u}, {{1, 1}, {1, 1}, ~0u}, {{0, 1}, {0, 1}, ~0u}};
    constexpr Vertex kTriangle[] = {{{0, 0}, {0, 0}, ~0u}, {{1, -1}, {0, 0}, ~0u}, {{1, 1}, {0, 0}, ~0u}};
    constexpr std::uint32_t kIndices[] = {0, 1, 2, 0, 2, 3};
    const std::uint32_t square = add_polygon(list, kSquare, kIndices);
    const std::uint32_t triangle = add_polygon(list, kTriangle, std::span(kIndices).first(3));
    const std::uint32_t disc = add_circle(list, {{0, 0}, {0.5f, 0.5f}, ~0u}, 1.0f);
    return {list, square, triangle, disc};
}

//   low right corner of the unit square -> `to`, its left side lies across `from`:
//     +---------------------------+
//   from                          to      width
//     +---------------------------+
void line(const Overlay& overlay, Vec2 from, Vec2 to, float width, Rgba8 colour) {
    if (!near(from) || !near(to)) return;
    const Vec2 along = to - from, across = width * left_of(normalised(along)), corner = from - 0.5f * across;
    square(overlay, {along.x, along.y, across.x, across.y, corner.x, corner.y}, colour);
}

//                            |\.
//   from --------------------+  > to     shaft up to the base of the head
//                            |/
void arrow(const Overlay& overlay, Vec2 from, Vec2 to, float width, Rgba8 colour) {
    const float reach = length(to - from);
    if (!near(from) || !near(to) || reach <= 0.0f) return;
    const float head = std::min(0.6f * reach, 5.0f * width);
    const Vec2 back = (head / reach) * (from - to), half_base = 0.5f * left_of(back);
    line(overlay, from, to + 0.9f * back, width, colour);
    overlay.list.instances.push_back(
        {{back.x, back.y, half_base.x, half_base.y, to.x, to.y}, {}, overlay.triangle, kNoTexture, colour, 0.0f});
}

void disc(const Overlay& overlay, Vec2 centre, float radius, Rgba8 colour) {
    if (!near(centre)) return;
    overlay.list.instances.push_back(
        {{radius, 0, 0, radius, centre.x, centre.y}, {}, overlay.disc, kNoTexture, colour, 0.0f});
}

void ring(const Overlay& overlay, Vec2 centre, float radius, float width, Rgba8 colour) {
    if (!near(centre)) return;
    overlay.list.instances.push_back(
        {{radius, 0, 0, radius, centre.x, centre.y}, {}, overlay.disc, kNoTexture, colour, width});
}

//          /\    /\    /\.
//   from --  \  /  \  /  \  -- to      as many turns however long it is: so one sees how far it is stretched
//              \/    \/    \/
void coil(const Overlay& overlay, Vec2 from, Vec2 to, float half, float width, Rgba8 colour) {
    constexpr int kBends = 12;
    const Vec2 along = to - from, side = half * left_of(normalised(along));
    Vec2 last = from;
    for (int i = 0; i <= kBends; ++i) { // a straight end as long as two bends on either side
        const float part = (2.0f + static_cast<float>(i)) / (kBends + 4);
        const float out = i == 0 || i == kBends ? 0.0f : i % 2 == 0 ? -1.0f : 1.0f;
        const Vec2 next = from + part * along + out * side;
        line(overlay, last, next, width, colour);
        last = next;
    }
    line(overlay, last, to, width, colour);
}

void box(const Overlay& overlay, Vec2 low, Vec2 high, Rgba8 colour) {
    square(overlay, {high.x - low.x, 0, 0, high.y - low.y, low.x, low.y}, colour);
}

void glyphs(const Overlay& overlay, std::span<const Glyph> row, Vec2 at, std::uint32_t texture, Rgba8 colour) {
    for (const Glyph& glyph : row) {
        const Vec2 size = glyph.high - glyph.low, low = at + glyph.low, piece = glyph.texture_high - glyph.texture_low;
        overlay.list.instances.push_back({{size.x, 0, 0, size.y, low.x, low.y},
                                          {piece.x, 0, 0, piece.y, glyph.texture_low.x, glyph.texture_low.y},
                                          overlay.square,
                                          texture,
                                          colour,
                                          0.0f});
    }
}

} // namespace evil::draw
