#pragma once
// Meshes as a fragment shader wants them: each edge a texel, and planes that give texture coordinates and colours. They
// stay on the graphics card until the draw list holds other meshes.
#include "draw/draw_list.hpp"
#include "gpu/quads.hpp"
#include <span>
#include <vector>

namespace evil::gpu {

struct Plane { // a number that changes linearly over the mesh: dx * x + dy * y + at
    double dx = 0, dy = 0, at = 0;
};

struct Box { // a mesh that is all of its bounds, white, with one map to texture coordinates
    bool is = false;
    bool repeats = false;             // its texture coordinates leave the picture
    bool whole = false;               // ... and reach the picture's sides
    float x = 0, y = 0, w = 0, h = 0; // middle, half sides
    float u = 0, v = 0;               // texture coordinates in the middle
    float up = 0, vp = 0, uq = 0,
          vq = 0; // ... and how they change to the middle of the right side, and of the high one
};

// Whether texture coordinates that lie so far to both sides of a middle leave the picture; and whether they reach its sides.
bool leave(float u, float v, float width, float height);
bool reach(float width, float height);

struct Shape {                                 // one mesh
    std::uint32_t first_edge = 0, edges = 0;   // none: nothing to draw
    std::uint32_t first_facet = 0, facets = 0; // none: u and v below serve for all of it, and every corner is white
    Rect bounds, inner;                        // inner: a box that lies inside; empty if none was found
    Plane u, v;
    Box box;
};

struct Circle { // a polygon of the unit circle's area, for discs too small to go by distance
    std::uint32_t first_edge = 0, edges = 0;
};

struct Shapes {
    std::vector<Texel> texels;   // edges x0 y0 x1 y1, and facets of kFacetTexels each; whole rows
    std::vector<Shape> shapes;   // by mesh
    std::vector<Circle> circles; // from few edges to many
    std::uint64_t revision = 0;  // changes when `texels` do

    std::vector<draw::Vertex> vertices; // what the above was made from
    std::vector<std::uint32_t> indices, holes;
    std::vector<draw::Mesh> meshes;
};

inline constexpr std::uint32_t kFacetTexels = 10; // three sides, u, v, colour by x, by y, at the origin, least, most

// Makes everything anew if the list's meshes are not those of the last call: comparing costs less than an upload.
void update(Shapes& shapes, const draw::DrawList& list);

} // namespace evil::gpu
