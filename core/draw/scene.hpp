#pragma once
// What is drawn (SPEC A5, G13): drawings that follow a body or stand by themselves, in layers.
#include "draw/depth.hpp"
#include "draw/draw_list.hpp"
#include "draw/flipbook.hpp"
#include "draw/layers.hpp"
#include "draw/meshes.hpp"
#include "published.hpp"
#include "shapes/shapes.hpp"

namespace evil::draw {

using DrawingRef = Ref<struct DrawingTag>;

struct Surface { // pictures that say more of a surface than its colours
    std::uint32_t normals = kNoTexture, glows = kNoTexture;
};

inline constexpr float kGlowAsShown = -1.0f; // 1 with a picture of what glows, 0 without

struct Drawing {            // draw/saving.cpp says which of it is saved
    BodyRef body;           // slot kNone: stands by itself
    ShapeRef shape;         // of that body, whose matrix it follows too (SPEC P4); slot kNone: no shape
    Affine local;           // mesh to shape, to body, or to world
    Affine texture_matrix;  // applied to the texture coordinates
    std::uint32_t mesh = 0; // of Scene::meshes; the drawing owns one use
    std::uint32_t texture = kNoTexture;
    Rgba8 tint = 0xffffffffu;
    Rgba8 edge = 0;          // colour of a line round the shape
    float edge_width = 0.0f; // logical points; 0: no such line
    std::int32_t layer = 0;  // higher is nearer
    bool visible = true;
    bool lit = false;
    bool flip_x = false, flip_y = false; // the picture mirrored, left for right and top for bottom
    Blend blend = Blend::over;
    Surface surface;                   // none: those of the picture that it shows
    float glow = kGlowAsShown;         // how strongly it shines by itself
    float behind = 0.0f, depth = 0.0f; // metres, in perspective: how far off its face is, and how far it reaches back
    Playing playing;
    std::uint64_t serial = 0; // order of creation, never used again
};

struct Scene { // State
    Meshes meshes;
    std::vector<Clip> clips;
    std::vector<Surface> surfaces; // by texture; ids beyond have none
    Slots slots;
    std::vector<Drawing> drawings; // by slot
    std::vector<DrawingRef> order; // back to front; removed ones leave at the next collect()
    bool sorted = true;            // `order` follows layer and serial
    std::uint64_t next_serial = 0;
    std::vector<LayerLook> looks; // of this frame: layers that are not seen as the world is
    Perspective perspective;      // of this frame
    std::vector<Slice> slices;    // scratch
};

// The drawing takes over one use of its mesh. Serial is given here.
DrawingRef add(Scene& scene, const Drawing& drawing);
void remove(Scene& scene, DrawingRef drawing); // must be alive
void set_layer(Scene& scene, DrawingRef drawing, std::int32_t layer);

// One frame: where things are at `alpha` (0..1) between the last two steps, seen through `view` (world to pixels).
// Drawings whose body or shape is gone are removed. `now`: the world's steps at
// that moment. `points`: pixels of a logical point. `out` must be a list of this scene alone: meshes
// are copied into it only when they changed. No allocation once the vectors have grown.
void collect(Scene& scene, const Poses& poses, const Shapes& shapes, const Affine& view, float alpha, double now,
             float points, DrawList& out);

// What a drawing shows at that moment, and where on it.
std::uint32_t shown_texture(const Scene& scene, const Drawing& drawing, double now);
Affine texture_place(const Drawing& drawing);
Surface surface_of(const Scene& scene, const Drawing& drawing, std::uint32_t shown);
float glow_of(const Drawing& drawing, const Surface& surface);

// The pose part of the way (0..1) from a to b, turning the shorter way round.
Pose between(const Pose& a, const Pose& b, float part);

} // namespace evil::draw
