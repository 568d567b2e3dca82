#pragma once
// What a graphics card is given for one frame: a quad round each thing to draw, in runs that one draw call can take, and
// the edges and facets that its fragment shader reads. renderer/shaders/shape.vert and shape.frag say what they do with it.
#include "draw/draw_list.hpp"
#include "gpu/liquid.hpp"
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace evil::gpu {

struct Texel { // of a data texture: four floats
    float x, y, z, w;
    friend bool operator==(const Texel&, const Texel&) = default;
};

inline constexpr std::uint32_t kRow = 1024; // texels in a row of a data texture (ROW in shape.frag)

struct Rect {
    float left = 0, low = 0, right = 0, high = 0;
    friend bool operator==(const Rect&, const Rect&) = default;
};

enum class Cover : std::uint32_t { // how the fragment shader knows which part of a pixel is covered
    all,                           // every pixel of the quad, whole
    edges,                         // by edges in the mesh's own coordinates
    pixel_edges,                   // by edges in pixels
    disc,                          // by the distance to the unit circle
    ring,                          // the same to a stroke of half width inner.left round it
};

enum Flag : std::uint32_t {
    kRepeat = 1,    // the picture repeats; otherwise its edge holds beyond it
    kPixelBox = 2,  // `box` is in pixels and drawn as it is
    kHollow = 4,    // inside `inner` nothing is covered, rather than everything
    kColoured = 8,  // the facets' colours are multiplied in
    kTextured = 16, // `unit` names a picture
    kAdds = 32,     // what is behind stays as it is (draw::Blend::add)
    kFine = 64,     // the picture's copy is picked by the way that it is squeezed less
    kLit = 128,     // multiplied with the light map
};

// One instance of the draw call. Layout known to renderer/gl/pipeline.py (INSTANCE).
struct Quad {
    float a = 1, b = 0, c = 0, d = 1; // mesh to pixels, as in Affine
    float tx = 0, ty = 0;
    float uc = 0, vc = 0;                 // u = ux * p + uy * q + uc, v = vx * p + vy * q + vc,
    Rect box;                             // what to draw, mesh coordinates or pixels
    Rect inner;                           // mesh coordinates in which the coverage needs no edges
    float ux = 0, uy = 0, vx = 0, vy = 0; // where (p, q) is the mesh coordinate, or with facets what they say
    std::uint32_t first_edge = 0;
    std::uint32_t edges = 0; // count
    std::uint32_t first_facet = 0;
    std::uint32_t how = 0; // Cover | Flag << 4 | unit << 12 | count of facets << 16
    std::uint32_t tint = 0xffffffffu;
    std::uint32_t surface = 0; // 1 + unit of normals | 1 + unit of what glows << 4 | how strongly, in kGlowSteps << 8
};
static_assert(sizeof(Quad) == 26 * 4, "no padding: the shader reads it as it is");

// A box of one picture, for the shader that draws nothing else. Layout known to renderer/gl/pipeline.py (SPRITE).
struct Sprite {
    float x = 0, y = 0;                   // its middle, pixels
    float ax = 0, ay = 0, bx = 0, by = 0; // from there to the middle of one side, and of the next
    float uc = 0, vc = 0;                 // texel of the atlas in its middle
    float ua = 0, va = 0, ub = 0, vb = 0; // ... and how much farther that is on the middle of those sides
    Rect reach;                           // what to draw, where the sides are at -1 and 1: first a, then b
    std::uint32_t how = 0;                // Flag
    std::uint32_t tint = 0xffffffffu;
};
static_assert(sizeof(Sprite) == 18 * 4, "no padding: the shader reads it as it is");

// Which of a sprite's pixels are covered in part by something that is not clear (COVER in sprite.frag).
enum class Fringe : std::uint32_t {
    none,
    sides,   // but not those in its corners
    corners, // those too
};

inline constexpr std::uint32_t kUnits = 8;           // pictures that one draw call can mix
inline constexpr std::uint32_t kMostFacets = 0xffff; // what `how` has room for
inline constexpr std::uint32_t to_how(Cover cover, std::uint32_t flags, std::uint32_t facets) {
    return static_cast<std::uint32_t>(cover) | flags << 4 | facets << 16;
}

inline constexpr float kGlowSteps = 1024.0f; // to 1 (GLOW_STEPS in shape.frag)

struct Batch { // quads of one draw call, or an interlude between such
    std::uint32_t first = 0, count = 0;
    std::optional<draw::Interlude> interlude;
    bool sprites = false;                  // rows of Frame::sprites, not of quads; textures[0] is their page
    bool facets = false;                   // whether any of them has some
    bool surfaces = false;                 // whether any of them has normals or glows
    bool lit = false;                      // whether any sprite is
    Fringe fringe = Fringe::none;          // the most that any sprite has
    draw::Blend blend = draw::Blend::over; // over, which serves add too; multiply; screen
    std::uint32_t units = 0;               // how many of `textures` are in use
    std::array<std::uint32_t, kUnits> textures{};
};

struct Frame { // results: valid until the next one
    std::vector<Quad> quads;
    std::vector<Sprite> sprites;
    std::vector<draw::Speck> specks;   // the draw list's
    std::vector<PackedLiquid> liquids; // as many as the list has, and perhaps more
    std::vector<Batch> batches;
    std::vector<Texel>
        edges; // x0 y0 x1 y1 in pixels, for Cover::pixel_edges; they follow the meshes' in the data texture
};

} // namespace evil::gpu
