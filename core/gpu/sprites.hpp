#pragma once
// Boxes with a picture, or of one colour: what most of a game's things are. A fragment shader that knows nothing else needs
// no edges and one texture, so such boxes are drawn apart, as long as enough of them follow each other.
#include "draw/draw_list.hpp"
#include "gpu/quads.hpp"
#include "gpu/shapes.hpp"
#include <vector>

namespace evil::gpu {

// One copy of a picture in a page of the atlas. All in texels.
struct Spot {
    float left = 0, top = 0; // in the page
    float width = 0, height = 0;
    Rect seen;                  // of the copy: outside, it is clear. low is its top
    bool clear_corners = false; // two texels each way
    float border = 0;           // how many texels are clear along all sides
};

Spot make_spot(float left, float top, float width, float height, Rect seen, bool clear_corners);

struct Place { // of a picture in the atlas
    std::uint32_t page = 0;
    std::vector<Spot> copies; // each half as large as the one before; none: the picture has no place
};

struct Places {
    std::vector<Place> pictures; // by texture id; that of kNoTexture is a white texel
};

// What a thing is to the sprite shader.
enum class Fit {
    sprite,  // drawn
    nothing, // nothing of it is seen
    other,   // it takes the shader that draws everything
};

struct Way { // how a sprite is drawn, beside its own row
    std::uint32_t page = 0;
    Fringe fringe = Fringe::none;
};

// `sprite` and `way` are set for Fit::sprite alone. `lit`: the frame has light for it.
Fit fit(Sprite& sprite, Way& way, const draw::Instance& instance, const Box& box, const Places& places,
        std::uint32_t texture, bool lit, Rect target);

} // namespace evil::gpu
