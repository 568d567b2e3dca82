#include "draw/debug_marks.hpp"
#include "fluid/smoke.hpp"

namespace evil::draw {
namespace {

constexpr float kLineEvery = 8.0f; // in logical points, as all lengths here
constexpr float kArrow = 1.4f, kThin = 1.0f, kEdge = 1.5f;
constexpr float kLongest = 1.25f; // of what flows as fast as the scale, in places between arrows
constexpr float kSlowest = 0.02f; // of the scale: slower is not drawn
constexpr Rgba8 kOpaque = 0xff000000u;

Rgba8 faded(Rgba8 colour, float by) {
    const auto alpha = static_cast<std::uint32_t>(std::lround(static_cast<float>(colour >> 24) * by));
    return (colour & ~kOpaque) | alpha << 24;
}

// 1, 2 or 5 times a power of ten, at least as large: a scale that seldom changes and is easily said.
float round_number(float value) {
    const float ten = std::pow(10.0f, std::floor(std::log10(value)));
    for (const float step : {1.0f, 2.0f, 5.0f})
        if (value <= step * ten * 1.001f) return step * ten;
    return 10.0f * ten;
}

void draw_line(const FluidFrame& f, Vec2 from, Vec2 to, float width, Rgba8 colour) {
    line(f.overlay, apply(f.view, from), apply(f.view, to), width * f.points, colour);
}

// The sides that are closed.
void draw_walls(const FluidFrame& f, const fluid::Grid& g, const std::array<bool, 4>& open, Rgba8 ink) {
    const Vec2 corners[] = {corner_of(g, 0, 0), corner_of(g, g.nx, 0), corner_of(g, g.nx, g.ny), corner_of(g, 0, g.ny)};
    constexpr fluid::Side kSides[] = {fluid::kBottom, fluid::kRight, fluid::kTop, fluid::kLeft};
    for (std::size_t k = 0; k < 4; ++k)
        if (!open[kSides[k]]) draw_line(f, corners[k], corners[(k + 1) % 4], kEdge, ink);
}

} // namespace

float pixels_a_metre(const FluidFrame& f) { return std::sqrt(std::fabs(determinant(f.view))); }

// The squares of a grid that are seen, each at least so many points wide, and the same ones wherever the camera goes.
Squares seen(const FluidFrame& f, const fluid::Grid& g, float points) {
    Squares s;
    const float cell = g.h * pixels_a_metre(f), det = determinant(f.view);
    if (!(cell > 0.0f) || !(std::fabs(det) > 0.0f)) return s;
    const int most = std::max(g.nx, g.ny);
    s.side = static_cast<int>(std::clamp(std::ceil(points * f.points / cell), 1.0f, static_cast<float>(most)));
    Vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f}; // of the picture, in cells
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{f.screen.x, 0}, f.screen, Vec2{0, f.screen.y}}) {
        const Vec2 p = corner - Vec2{f.view.tx, f.view.ty};
        const Vec2 at{(f.view.d * p.x - f.view.c * p.y) / det, (f.view.a * p.y - f.view.b * p.x) / det};
        low = min(low, (1.0f / g.h) * (at - g.low)), high = max(high, (1.0f / g.h) * (at - g.low));
    }
    const auto cells = [](float at, int count) {
        return static_cast<int>(std::clamp(std::floor(at), 0.0f, static_cast<float>(count)));
    };
    s.first_i = cells(low.x, g.nx) / s.side * s.side, s.last_i = cells(high.x + 1.0f, g.nx);
    s.first_j = cells(low.y, g.ny) / s.side * s.side, s.last_j = cells(high.y + 1.0f, g.ny);
    return s;
}

// On whole pixels where the picture is upright: no edges show between squares side by side.
void fill(const FluidFrame& f, Vec2 low, Vec2 high, Rgba8 colour) {
    Affine to_pixel = compose(f.view, {high.x - low.x, 0, 0, high.y - low.y, low.x, low.y});
    if (to_pixel.b == 0.0f && to_pixel.c == 0.0f) {
        const Vec2 from{std::round(to_pixel.tx), std::round(to_pixel.ty)};
        const Vec2 to{std::round(to_pixel.tx + to_pixel.a), std::round(to_pixel.ty + to_pixel.d)};
        to_pixel = {to.x - from.x, 0, 0, to.y - from.y, from.x, from.y};
    }
    f.overlay.list.instances.push_back({to_pixel, {}, f.overlay.square, kNoTexture, colour, 0.0f});
}

// As many lines as have room.
void draw_grid(const FluidFrame& f, const fluid::Grid& g, const std::array<bool, 4>& open) {
    const Squares s = seen(f, g, kLineEvery);
    const Rgba8 ink = f.ink(FluidInk::grid), thin = faded(ink, 0.25f);
    for (int i = s.first_i; i <= s.last_i; i += s.side)
        draw_line(f, corner_of(g, i, s.first_j), corner_of(g, i, s.last_j), kThin, thin);
    for (int j = s.first_j; j <= s.last_j; j += s.side)
        draw_line(f, corner_of(g, s.first_i, j), corner_of(g, s.last_i, j), kThin, thin);
    draw_walls(f, g, open, ink);
}

float draw_arrows(const FluidFrame& f, const std::vector<Arrow>& arrows) {
    double sum = 0.0; // of speeds, weighed by themselves: what is still does not count
    double weight = 0.0;
    for (const Arrow& one : arrows) {
        const double speed = double(length(one.velocity));
        sum += speed * speed, weight += speed;
    }
    if (!(sum > 1e-6)) return 0.0f;
    const float scale = round_number(static_cast<float>(1.5 * sum / weight));
    for (const Arrow& one : arrows) {
        const float part = std::min(std::sqrt(length(one.velocity) / scale), 1.0f); // slow flow is seen beside fast
        if (part < std::sqrt(kSlowest)) continue;
        const Vec2 way = normalised(apply_linear(f.view, one.velocity)), at = apply(f.view, one.at);
        const Vec2 half = 0.5f * kLongest * part * one.room * way;
        arrow(f.overlay, at - half, at + half, kArrow * f.points, faded(f.ink(FluidInk::flow), 0.3f + 0.7f * part));
    }
    return scale;
}

float draw_tiles(const FluidFrame& f, const std::vector<Tile>& tiles) {
    double sum = 0.0;
    for (const Tile& tile : tiles) sum += double(tile.divergence) * double(tile.divergence);
    const float usual = static_cast<float>(std::sqrt(sum / std::max(double(tiles.size()), 1.0)));
    if (!(usual > 1e-7f)) return 0.0f;
    const float scale = round_number(2.0f * usual);
    for (const Tile& tile : tiles) {
        const float part = std::min(std::fabs(tile.divergence) / scale, 1.0f);
        const Rgba8 ink = f.ink(tile.divergence > 0.0f ? FluidInk::spreading : FluidInk::gathering);
        if (part > 0.02f) fill(f, tile.low, tile.high, faded(ink, part));
    }
    return scale;
}

} // namespace evil::draw
