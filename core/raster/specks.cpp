#include "raster/specks.hpp"
#include "raster/spans_wide.hpp"
#include <algorithm>
#include <cmath>

namespace evil::raster {
namespace {

// The box round the ellipse, cut to the target, and how its own coordinates change over it. False if nothing is left.
bool place(SpeckPaint& paint, const draw::Speck& speck, bool disc, const Target& target) {
    const float along = length(speck.along), across = speck.across;
    if (!(along > 0.0f && across > 0.0f && along < 1e6f && across < 1e6f)) return false;
    const Vec2 way = (1.0f / along) * speck.along;
    const float rim = disc ? 0.5f : 0.0f; // half a pixel, in which a disc's edge fades
    const float x = length({way.x * along, way.y * across}) + rim;
    const float y = length({way.y * along, way.x * across}) + rim;
    const float width = static_cast<float>(target.width), height = static_cast<float>(target.height);
    if (!(speck.at.x + x > 0.0f && speck.at.x - x < width && speck.at.y + y > 0.0f && speck.at.y - y < height))
        return false;
    paint.box = {static_cast<int>(std::max(speck.at.x - x, 0.0f)), static_cast<int>(std::max(speck.at.y - y, 0.0f)),
                 static_cast<int>(std::ceil(std::min(speck.at.x + x, width))),
                 static_cast<int>(std::ceil(std::min(speck.at.y + y, height)))};
    paint.u_x = way.x / along, paint.u_y = way.y / along;
    paint.v_x = -way.y / across, paint.v_y = way.x / across;
    const float dx = static_cast<float>(paint.box.left) + 0.5f - speck.at.x;
    const float dy = static_cast<float>(paint.box.top) + 0.5f - speck.at.y;
    paint.u = dx * paint.u_x + dy * paint.u_y;
    paint.v = dx * paint.v_x + dy * paint.v_y;
    paint.along = 1.0f / along, paint.across = 1.0f / across;
    paint.disc = disc;
    return true;
}

} // namespace

Rows reach_of(const draw::Speck& speck, int height) {
    const float reach = std::max(std::fabs(speck.along.x) + std::fabs(speck.along.y), speck.across) + 1.0f;
    const float top = speck.at.y - reach, bottom = speck.at.y + reach, end = static_cast<float>(height);
    if (!(bottom > 0.0f && top < end)) return {}; // nor what is no number
    return {static_cast<int>(std::max(top, 0.0f)), static_cast<int>(std::ceil(std::min(bottom, end)))};
}

void draw_specks(std::span<const draw::Speck> specks, const draw::Interlude& run, const Bins& bins, std::size_t band,
                 const Rows& rows, const Target& target, Set set) {
    SpeckPaint paint{};
    paint.blend = run.blend;
    each_thing(bins, band, run.first, run.first + run.count, [&](std::uint32_t i) {
        const draw::Speck& speck = specks[i];
        if (!place(paint, speck, run.form == draw::SpeckForm::disc, target)) return;
        paint.rows = {std::max(paint.box.top, rows.first), std::min(paint.box.bottom, rows.last)};
        if (paint.rows.first >= paint.rows.last) return;
        paint.colour = premultiply(speck.colour);
        EVIL_PICK(set, speck_wide)(target, paint);
    });
}

} // namespace evil::raster
