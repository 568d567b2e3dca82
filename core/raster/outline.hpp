#pragma once
// From meshes to closed loops of points in pixels: fills and strokes of polygons and circles.
#include "draw/draw_list.hpp"
#include "raster/coverage.hpp"
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace evil::raster {

inline constexpr double kMitreLimit = 4.0; // tip over half width, as in SVG; sharper corners are rounded

struct Loops { // scratch
    std::vector<Point> points;
    std::vector<std::size_t> ends;             // one past each loop's last point
    std::vector<Point> path;                   // what is being stroked
    std::map<int, std::vector<Point>> circles; // corners of unit circles, by their number
};

void clear(Loops& loops);

// The outline of a mesh under `to_pixel`, or its stroke of `width` pixels if that is more than zero.
void add_mesh(Loops& loops, const draw::DrawList& list, const draw::Mesh& mesh, const Affine& to_pixel, double width);

} // namespace evil::raster
