#pragma once
// Layers that are seen in another way than the world: farther off, in one colour, through fog, out of focus (SPEC G10).
#include "draw/draw_list.hpp"
#include <span>

namespace evil::draw {

struct LayerLook {
    std::int32_t layer = 0;
    Affine to_world; // where in the world its things are seen, from where they are: parallax
    Rgba8 tint = 0xffffffffu;
    bool visible = true;
};

constexpr Rgba8 multiplied(Rgba8 a, Rgba8 b) { // straight colours
    if (b == 0xffffffffu) return a;
    Rgba8 result = 0;
    for (int shift = 0; shift < 32; shift += 8)
        result |= ((a >> shift & 255u) * (b >> shift & 255u) + 127u) / 255u << shift;
    return result;
}

class LayerCursor { // how each layer is seen, asked from the deepest to the nearest
public:
    LayerCursor(std::span<const LayerLook> looks, const Affine& world) : looks_(looks), world_(world), view(world) {}

    bool go_to(std::int32_t layer) { // false: nothing of it is seen
        if (begun_ && layer == layer_) return seen_;
        begun_ = true, layer_ = layer;
        while (!looks_.empty() && looks_.front().layer < layer) looks_ = looks_.subspan(1);
        const bool own = !looks_.empty() && looks_.front().layer == layer;
        view = own ? compose(world_, looks_.front().to_world) : world_;
        tint = own ? looks_.front().tint : 0xffffffffu;
        size = own ? looks_.front().to_world.a : 1.0f;
        return seen_ = !own || looks_.front().visible;
    }

private:
    std::span<const LayerLook> looks_; // sorted by layer; those that are still to come
    Affine world_;                     // world to pixels
    std::int32_t layer_ = 0;
    bool begun_ = false, seen_ = true;

public:
    Affine view; // of this layer
    Rgba8 tint = 0xffffffffu;
    float size = 1.0f; // in perspective, of what would be as large in the world's plane
};

// The index at which the instances of nearer layers begin.
std::uint32_t end_of_layer(const DrawList& list, std::int32_t layer);

// Moves instances that were appended, from `first` on, to the end of a layer.
void move_to_layer(DrawList& list, std::uint32_t first, std::int32_t layer);

// A sheet of fog over all of a layer and what lies behind it: from one colour at the picture's top to one at its bottom.
void add_fog(DrawList& list, std::int32_t layer, Rgba8 top, Rgba8 bottom, Vec2 screen, bool lit);

// Shafts of light over all of a layer and what lies behind it.
void add_shafts(DrawList& list, std::int32_t layer, const Shafts& shafts);

// A map to fill for a liquid that lies over a layer; drop_liquid takes the last one back.
LiquidMap& add_liquid(DrawList& list, std::int32_t layer);
void drop_liquid(DrawList& list);

// All of a layer and what lies behind it goes out of focus; `radius` in pixels.
void add_blur(DrawList& list, std::int32_t layer, float radius);

} // namespace evil::draw
