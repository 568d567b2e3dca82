#pragma once
// What colour each pixel of a shape gets, apart from how much of it the shape covers.
#include "draw/draw_list.hpp"
#include "raster/spans.hpp"
#include "raster/texture.hpp"
#include <span>
#include <vector>

namespace evil::raster {

struct Plane { // a number that changes linearly over the target: at + dx * x + dy * y
    double at = 0, dx = 0, dy = 0;
};

// A triangle of the mesh, in pixels, with what is interpolated over it. One piece alone paints everything.
struct Piece {
    double x[3] = {}, y[3] = {};
    Plane u, v;                         // of the whole picture: 0..1 across
    Plane channel[4];                   // r, g, b, a, multiplied with alpha: 0..255
    double least[4] = {}, most[4] = {}; // of the channels at the corners
    const Picture *picture = nullptr, *normals = nullptr, *glows = nullptr;
};

struct Pictures { // what an instance is painted with; each may be null or empty
    const Texture *colours = nullptr, *normals = nullptr, *glows = nullptr;
};

struct PaintCorner { // of a mesh: where it lies in pixels and what it carries
    double x, y, u, v;
    double channel[4];
};

struct Paint {
    Pixel flat = 0; // the colour, or what the picture is multiplied with
    Pixel tint = 0; // the instance's
    bool textured = false, repeat = false;
    bool bumpy = false, glowing = false; // with a picture of normals, of what shines by itself
    bool coloured = false;               // channels take the place of `flat`
    std::vector<Piece> pieces;

    std::vector<PaintCorner> corners; // scratch
    struct Run {                      // scratch: pixels first..last of a row belong to a piece
        double first, last;
        const Piece* piece;
    };
    std::vector<Run> runs;
    std::vector<Pixel> colours;
};

// Without a picture of colours, the instance's tint and corners alone give them.
void prepare(Paint& paint, const draw::DrawList& list, const draw::Mesh& mesh, const draw::Instance& instance,
             Pictures pictures);

inline bool is_flat(const Paint& paint) { return !paint.textured && !paint.coloured; }

// Colours of the pixels left..right - 1 of row y. `out` has room for the count rounded up to eights.
void paint_row(Paint& paint, Set set, int y, int left, int right, Pixel* out);

// The same of the picture of what shines by itself, tinted.
void paint_glow(Paint& paint, Set set, int y, int left, int right, Pixel* out);

struct Light { // of a run: factors as light_up() takes them, and the ways of bend()
    const std::uint32_t *factors, *across, *down;
};
// What the light becomes by the picture of normals. `out` has room as above.
void bend_light(Paint& paint, Set set, int y, int left, int right, const Light& light, std::uint32_t* out);

} // namespace evil::raster
