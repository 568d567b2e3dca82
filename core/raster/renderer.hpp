#pragma once
// The software renderer: a DrawList into a picture, with the same bits on every machine and for any number of threads.
//
// Source over destination in sRGB, as pictures are usually mixed; light is linear (light/light_map.hpp).
#include "draw/draw_list.hpp"
#include "raster/bands.hpp"
#include "raster/instance.hpp"
#include "raster/liquid.hpp"
#include "raster/lit.hpp"
#include "raster/pyramid.hpp"
#include "raster/target.hpp"
#include "raster/texture.hpp"
#include <optional>
#include <span>
#include <vector>

namespace evil::raster {

struct Scratch {                     // losing it changes nothing
    std::vector<Desk> desks;         // by band
    std::vector<std::uint8_t> sound; // by mesh
    Bins instances, specks;
    LightRows light;
    Pyramid pyramid;
    LiquidScratch liquid;
};

struct How {
    Set set = best_instruction_set();
    int rows = 0; // of a band; 0: as many as suit the frame and its threads
};

// Fills the target with `background` (straight colour), if there is one, and draws the instances in their order. Textures are found by id;
// ids without one draw as if there were none. Instances whose indices do not fit the list, or whose positions are not
// finite, draw nothing.
void render(const draw::DrawList& list, std::optional<draw::Rgba8> background, std::span<const Texture> textures,
            const Target& target, Scratch& scratch, Threads& threads, const How& how = {});

// Pixels multiplied with alpha, as straight ones.
void unpremultiply(std::span<Pixel> pixels) noexcept;

} // namespace evil::raster
