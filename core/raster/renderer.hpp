#pragma once
// The software renderer: a DrawList into a picture, with the same bits on every machine.
//
// Source over destination in sRGB, as pictures are usually mixed; light is linear (light/light_map.hpp).
#include "draw/draw_list.hpp"
#include "raster/coverage.hpp"
#include "raster/liquid.hpp"
#include "raster/lit.hpp"
#include "raster/outline.hpp"
#include "raster/paint.hpp"
#include "raster/pyramid.hpp"
#include "raster/target.hpp"
#include "raster/texture.hpp"
#include <optional>
#include <span>
#include <vector>

namespace evil::raster {

struct Scratch { // losing it changes nothing
    Coverage coverage;
    Loops loops;
    Paint paint;
    LightRows light;
    std::vector<std::int32_t> mask;
    std::vector<Pixel> row, glow;    // colours of one row, and what shines by itself
    std::vector<std::uint32_t> bent; // light on it, as its normals take it up
    Pyramid pyramid;
    LiquidScratch liquid;
};

// Fills the target with `background` (straight colour), if there is one, and draws the instances in their order. Textures are found by id;
// ids without one draw as if there were none. Instances whose indices do not fit the list, or whose positions are not
// finite, draw nothing.
void render(const draw::DrawList& list, std::optional<draw::Rgba8> background, std::span<const Texture> textures,
            const Target& target, Scratch& scratch, Set set = best_instruction_set());

// Pixels multiplied with alpha, as straight ones.
void unpremultiply(std::span<Pixel> pixels) noexcept;

} // namespace evil::raster
