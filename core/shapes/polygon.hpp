#pragma once
// Polygons: what makes one usable, its size and mass, triangles for drawing it and convex parts for colliding it (SPEC G1, C1).
// A polygon is its corners in order, without repeating the first; "simple": its edges meet only where neighbours join. It
// may have holes, which touch neither the outline nor each other.
#include "shapes/rings.hpp"
#include <string>

namespace evil {

inline constexpr std::size_t kMaxCorners =
    4096; // the holes' included; time grows with the square of it at worst; tens of milliseconds then
inline constexpr float kMaxCoordinate = 1e5f; // metres; beyond, float steps exceed a centimetre and contacts rattle
inline constexpr float kMinFeature = 1e-5f;   // metres between corners, or mean thickness; below, normals mean nothing

enum class PolygonFault : std::uint8_t {
    none,
    too_few_corners, // of ring `first`
    too_many_corners,
    not_finite,      // corner `first`
    too_large,       // corner `first` beyond kMaxCoordinate
    repeated_corner, // corners `first` and `second` nearer than kMinFeature
    crossing_edges,  // the edges that start at corners `first` and `second` cross, touch or overlap
    zero_area,       // of ring `first`
    hole_outside,    // ring `first` lies outside the outline
    hole_in_a_hole,  // ring `first` lies within ring `second`
};
struct PolygonProblem {
    PolygonFault fault = PolygonFault::none;
    std::uint32_t first = 0, second = 0;
    friend bool operator==(const PolygonProblem&, const PolygonProblem&) = default;
};

// The first thing wrong with a polygon, or `none`: then it is simple, and everything below works on it. Exact arithmetic
// decides, so corners that lie straight between their neighbours are welcome and crossings cannot slip through. Rings may
// run either way round.
PolygonProblem check_polygon(const Rings& rings);

// The problem in words, to follow a name and a colon: "corners 0 and 2 are at the same place, ...".
std::string describe(const PolygonProblem& problem, const Rings& rings);

double signed_area(std::span<const Vec2> ring) noexcept;    // square metres; positive when counter-clockwise
void make_counter_clockwise(std::span<Vec2> ring) noexcept; // reverses a clockwise one, keeping its first corner first
void turn_rings(std::span<Vec2> corners, std::span<const std::uint32_t> holes) noexcept; // the way that Rings run
bool is_convex(
    std::span<const Vec2> corners) noexcept; // of a simple, counter-clockwise polygon; straight corners count as convex

// Mass (kg), centre, and second moment about that centre (kg m^2), in the shape's coordinates. Density in kg / m^2, if water is 1.
struct MassProperties {
    double mass = 0.0, inertia = 0.0;
    Vec2 centre;
};
MassProperties circle_mass(float radius, float density) noexcept;                   // round the origin
MassProperties polygon_mass(std::span<const Vec2> corners, float density) noexcept; // simple, either way round

// Triangles of a simple polygon as corner numbers, three each, counter-clockwise, without new corners; n - 2 of them, and
// two more for each hole. Rings may run either way round. A polygon that is not simple gives triangles without meaning or,
// with false, none; it never loops for ever.
bool triangulate(const Rings& rings, std::vector<std::uint32_t>& indices);

// Convex parts of a simple polygon as corner numbers, counter-clockwise, without new corners; at most 2r + 1 for r reflex
// corners, fewer with holes. A part leaves out corners at which it runs straight. Empty when `triangulate` gives none.
std::vector<std::vector<std::uint32_t>> split_convex(const Rings& rings);

// Corners of the convex hull of any finite points, counter-clockwise from the leftmost; straight ones left out. One or two
// points when all lie in one place or line.
std::vector<std::uint32_t> convex_hull(std::span<const Vec2> points);

} // namespace evil
