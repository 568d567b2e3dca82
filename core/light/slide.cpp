#include "light/slide.hpp"
#include "light/light_map.hpp"
#include "math/functions.hpp"
#include "raster/texture.hpp"
#include <array>
#include <cmath>

namespace evil::light {
namespace {

// For a matrix that has one.
Affine inverse(const Affine& m) {
    const float by = 1.0f / determinant(m);
    const Affine r{m.d * by, -m.b * by, -m.c * by, m.a * by, 0, 0};
    const Vec2 to = apply_linear(r, {m.tx, m.ty});
    return {r.a, r.b, r.c, r.d, -to.x, -to.y};
}

} // namespace

Slide make_slide(const std::uint8_t* straight, int width, int height) {
    std::array<float, 256> linear;
    for (int level = 0; level < 256; ++level) linear[level] = static_cast<float>(power(level / 255.0, 1.0 / kToScreen));
    Slide slide;
    for (const raster::Picture& picture : raster::make_texture(straight, width, height).levels) {
        Slide::Level& level = slide.levels.emplace_back();
        level.width = picture.width, level.height = picture.height;
        for (int c = 0; c < 3; ++c) {
            level.planes[c].reserve(picture.texels.size());
            for (const raster::Pixel pixel : picture.texels) level.planes[c].push_back(linear[pixel >> (8 * c) & 255u]);
        }
    }
    return slide;
}

void put_slide(Lamp& lamp, const Slide& slide, const Affine& to_texel, float radius, float scale) {
    const float wide = static_cast<float>(slide.levels[0].width), high = static_cast<float>(slide.levels[0].height);
    const float pixel = 2.0f * radius / std::sqrt(wide * wide + high * high); // metres
    float texels = pixel * scale;                                             // as long as a pixel
    std::size_t which = 0;
    while (texels < 1.0f / 1.5f && which + 1 < slide.levels.size()) texels *= 2.0f, ++which;
    const Slide::Level& level = slide.levels[which];
    const float width = static_cast<float>(level.width), height = static_cast<float>(level.height);
    const Affine placed = compose(to_texel, {pixel * wide / width, 0, 0, pixel * high / height, 0, 0});
    if (!(std::fabs(determinant(placed)) > 1e-20f)) return;
    lamp.to_slide = compose({1, 0, 0, -1, 0.5f * width - 0.5f, 0.5f * height - 0.5f}, inverse(placed));
    lamp.slide_width = level.width, lamp.slide_height = level.height;
    for (int c = 0; c < 3; ++c) lamp.slide[c] = level.planes[c].data();
}

} // namespace evil::light
