#include "gpu/shapes.hpp"
#include "math/functions.hpp"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace evil::gpu {
namespace {

using draw::Mesh;
using draw::Vertex;

constexpr int kChords[] = {8, 12, 16, 24, 32, 48, 64, 96, 128};

template <class T> bool same(const std::vector<T>& a, const std::vector<T>& b) { // to the bit, NaN included
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_meshes(std::span<const Mesh> a, std::span<const Mesh> b) { // Mesh has padding, which memcmp would see
    return std::ranges::equal(a, b, [](const Mesh& p, const Mesh& q) {
        return p.kind == q.kind && p.coloured_corners == q.coloured_corners && p.first_vertex == q.first_vertex &&
               p.vertex_count == q.vertex_count && p.inside == q.inside && p.first_index == q.first_index &&
               p.index_count == q.index_count && p.first_hole == q.first_hole && p.hole_count == q.hole_count &&
               p.radius == q.radius;
    });
}

std::uint32_t add(std::vector<Texel>& texels, float x, float y, float z, float w) {
    texels.push_back({x, y, z, w});
    return static_cast<std::uint32_t>(texels.size() - 1);
}

Circle unit_circle(std::vector<Texel>& texels, int chords) {
    auto on_circle = [&](int i) { return sincos(2.0 * kPi * (i % chords) / chords); };
    const double area = 0.5 * chords * on_circle(1).sin, grow = std::sqrt(kPi / area);
    auto corner = [&](int i) {
        return Vec2{static_cast<float>(grow * on_circle(i).cos), static_cast<float>(grow * on_circle(i).sin)};
    };
    Circle circle{static_cast<std::uint32_t>(texels.size()), static_cast<std::uint32_t>(chords)};
    for (int i = 0; i < chords; ++i) {
        const Vec2 a = corner(i), b = corner(i + 1);
        add(texels, a.x, a.y, b.x, b.y);
    }
    return circle;
}

// ---- a box inside a polygon ----

// Whether the segment passes through the inside of the box: cut it by the four sides in turn (Liang and Barsky 1984).
bool crosses(Vec2 a, Vec2 b, const Rect& box) {
    double from = 0, to = 1;
    auto cut = [&](double start, double step, double low, double high) {
        if (step == 0) return start > low && start < high;
        double enter = (low - start) / step, leave = (high - start) / step;
        if (enter > leave) std::swap(enter, leave);
        from = std::max(from, enter), to = std::min(to, leave);
        return from < to;
    };
    return cut(a.x, double{b.x} - a.x, box.left, box.right) && cut(a.y, double{b.y} - a.y, box.low, box.high);
}

using Edges = std::span<const Texel>; // x0 y0 x1 y1

bool is_inside(Edges edges, Vec2 p) { // even-odd, along a ray to the right
    bool inside = false;
    for (const Texel& edge : edges) {
        const Vec2 a{edge.x, edge.y}, b{edge.z, edge.w};
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (double{p.y} - a.y) / (double{b.y} - a.y) * (double{b.x} - a.x)) inside = !inside;
    }
    return inside;
}

// The largest box round `centre`, shaped as the bounds are, that lies within the polygon; by halving. It need not be the
// largest there is: it only spares the shader the edges of pixels that are surely covered.
Rect box_round(Edges edges, const Rect& bounds, Vec2 centre) {
    if (!is_inside(edges, centre)) return {};
    const float width = bounds.right - bounds.left, height = bounds.high - bounds.low;
    auto box = [&](float part) {
        const float x = 0.5f * part * width, y = 0.5f * part * height;
        return Rect{centre.x - x, centre.y - y, centre.x + x, centre.y + y};
    };
    auto fits = [&](const Rect& candidate) {
        return std::ranges::none_of(
            edges, [&](const Texel& edge) { return crosses({edge.x, edge.y}, {edge.z, edge.w}, candidate); });
    };
    if (fits(box(1.0f))) return box(1.0f);
    float good = 0.0f, bad = 1.0f;
    for (int i = 0; i < 10; ++i) {
        const float middle = 0.5f * (good + bad);
        (fits(box(middle)) ? good : bad) = middle;
    }
    return box(good);
}

// A polygon that is wound twice round something, or crosses itself, has no box: even-odd would not do for it.
Rect inner_box(Edges edges, std::span<const Vertex> vertices, std::span<const std::uint32_t> triangles,
               const Rect& bounds) {
    if (triangles.empty()) return {};
    Rect best = box_round(edges, bounds, {0.5f * (bounds.left + bounds.right), 0.5f * (bounds.low + bounds.high)});
    if (best.right - best.left >= 0.5f * (bounds.right - bounds.left)) return best;
    double largest = 0;
    Vec2 middle;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const Vec2 a = vertices[triangles[i]].at, b = vertices[triangles[i + 1]].at, c = vertices[triangles[i + 2]].at;
        const double area =
            std::fabs((double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x));
        if (area > largest) largest = area, middle = (1.0f / 3.0f) * (a + b + c);
    }
    const Rect other = box_round(edges, bounds, middle);
    return other.right - other.left > best.right - best.left ? other : best;
}

// ---- facets ----

struct Facet {
    const Vertex* corner[3];
    double area = 0; // doubled, signed
    Plane u, v, channel[4];
    double least[4], most[4];
};

// r, g, b, a in 0..1, colours multiplied with alpha.
void premultiplied(draw::Rgba8 colour, double channel[4]) {
    const double alpha = static_cast<double>(colour >> 24) / 255.0;
    for (int i = 0; i < 3; ++i) channel[i] = static_cast<double>(colour >> (8 * i) & 255u) / 255.0 * alpha;
    channel[3] = alpha;
}

double at(const Plane& plane, Vec2 p) { return plane.dx * p.x + plane.dy * p.y + plane.at; }

bool make_facet(Facet& facet, const Vertex& a, const Vertex& b, const Vertex& c) {
    const double bx = double{b.at.x} - a.at.x, by = double{b.at.y} - a.at.y;
    const double cx = double{c.at.x} - a.at.x, cy = double{c.at.y} - a.at.y;
    facet.area = bx * cy - by * cx;
    const double reach = std::max({std::fabs(bx), std::fabs(by), std::fabs(cx), std::fabs(cy)});
    if (!(std::fabs(facet.area) > 1e-9 * reach * reach)) return false;
    auto plane = [&](double at_a, double at_b, double at_c) {
        const double fb = at_b - at_a, fc = at_c - at_a;
        const double dx = (fb * cy - fc * by) / facet.area, dy = (fc * bx - fb * cx) / facet.area;
        return Plane{dx, dy, at_a - dx * a.at.x - dy * a.at.y};
    };
    facet.corner[0] = &a, facet.corner[1] = &b, facet.corner[2] = &c;
    facet.u = plane(a.uv.x, b.uv.x, c.uv.x);
    facet.v = plane(a.uv.y, b.uv.y, c.uv.y);
    double colour[3][4];
    for (int i = 0; i < 3; ++i) premultiplied(facet.corner[i]->colour, colour[i]);
    for (int i = 0; i < 4; ++i) {
        facet.channel[i] = plane(colour[0][i], colour[1][i], colour[2][i]);
        facet.least[i] = std::min({colour[0][i], colour[1][i], colour[2][i]});
        facet.most[i] = std::max({colour[0][i], colour[1][i], colour[2][i]});
    }
    return true;
}

// Whether the facet's planes give every corner what it carries: then they serve for the whole mesh.
bool fits(const Facet& facet, std::span<const Vertex> corners) {
    for (const Vertex& corner : corners) {
        if (std::fabs(at(facet.u, corner.at) - corner.uv.x) > 1e-4) return false;
        if (std::fabs(at(facet.v, corner.at) - corner.uv.y) > 1e-4) return false;
        double colour[4];
        premultiplied(corner.colour, colour);
        for (int i = 0; i < 4; ++i)
            if (std::fabs(at(facet.channel[i], corner.at) - colour[i]) > 0.5 / 255.0) return false;
    }
    return true;
}

void add_facet(std::vector<Texel>& texels, const Facet& facet) {
    const double turn = facet.area > 0 ? 1.0 : -1.0;
    for (int i = 0; i < 3; ++i) { // distance to the side, more than zero inside
        const Vec2 a = facet.corner[i]->at, b = facet.corner[(i + 1) % 3]->at;
        const double x = double{b.x} - a.x, y = double{b.y} - a.y, scale = turn / std::sqrt(x * x + y * y);
        const double nx = -y * scale, ny = x * scale;
        add(texels, static_cast<float>(nx), static_cast<float>(ny), static_cast<float>(-nx * a.x - ny * a.y), 0.0f);
    }
    for (const Plane& plane : {facet.u, facet.v})
        add(texels, static_cast<float>(plane.dx), static_cast<float>(plane.dy), static_cast<float>(plane.at), 0.0f);
    auto four = [&](auto value) {
        add(texels, static_cast<float>(value(0)), static_cast<float>(value(1)), static_cast<float>(value(2)),
            static_cast<float>(value(3)));
    };
    four([&](int i) { return facet.channel[i].dx; });
    four([&](int i) { return facet.channel[i].dy; });
    four([&](int i) { return facet.channel[i].at; });
    four([&](int i) { return facet.least[i]; });
    four([&](int i) { return facet.most[i]; });
}

// One facet of all the triangles if that will do, and none if there is nothing but a plain texture to know.
void add_facets(Shapes& shapes, Shape& shape, const Mesh& mesh, std::span<const Vertex> corners,
                std::span<const std::uint32_t> triangles) {
    Facet largest, facet;
    bool found = false;
    auto offer = [&](const Vertex& a, const Vertex& b, const Vertex& c) {
        if (make_facet(facet, a, b, c) && (!found || std::fabs(facet.area) > std::fabs(largest.area)))
            largest = facet, found = true;
    };
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        offer(corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]);
    if (triangles.empty())
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) offer(corners[0], corners[i], corners[i + 1]);
    if (!found) { // all corners in a line: only a stroke of it is seen
        shape.u.at = corners[0].uv.x, shape.v.at = corners[0].uv.y;
        return;
    }
    shape.u = largest.u, shape.v = largest.v;
    const bool one = fits(largest, corners) || triangles.empty() || triangles.size() / 3 > kMostFacets;
    if (one && !mesh.coloured_corners) return;

    shape.first_facet = static_cast<std::uint32_t>(shapes.texels.size());
    if (one) {
        for (const Vertex& corner : corners) {
            double colour[4];
            premultiplied(corner.colour, colour);
            for (int i = 0; i < 4; ++i) {
                largest.least[i] = std::min(largest.least[i], colour[i]);
                largest.most[i] = std::max(largest.most[i], colour[i]);
            }
        }
        add_facet(shapes.texels, largest);
        shape.facets = 1;
        return;
    }
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        if (make_facet(facet, corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]))
            add_facet(shapes.texels, facet), ++shape.facets;
}

Box box_of(const Shape& shape, const Mesh& mesh) {
    Box box;
    box.is = mesh.vertex_count == 4 && mesh.hole_count == 0 && shape.facets == 0 && shape.inner == shape.bounds &&
             shape.bounds.left < shape.bounds.right && shape.bounds.low < shape.bounds.high;
    if (!box.is) return box;
    const Rect& r = shape.bounds;
    const double x = 0.5 * (double{r.left} + r.right), y = 0.5 * (double{r.low} + r.high);
    const double w = 0.5 * (double{r.right} - r.left), h = 0.5 * (double{r.high} - r.low);
    box.x = static_cast<float>(x), box.y = static_cast<float>(y);
    box.w = static_cast<float>(w), box.h = static_cast<float>(h);
    box.u = static_cast<float>(shape.u.dx * x + shape.u.dy * y + shape.u.at);
    box.v = static_cast<float>(shape.v.dx * x + shape.v.dy * y + shape.v.at);
    box.up = static_cast<float>(shape.u.dx * w), box.vp = static_cast<float>(shape.v.dx * w);
    box.uq = static_cast<float>(shape.u.dy * h), box.vq = static_cast<float>(shape.v.dy * h);
    const float across = std::fabs(box.up) + std::fabs(box.uq), down = std::fabs(box.vp) + std::fabs(box.vq);
    box.repeats = leave(box.u, box.v, across, down), box.whole = reach(across, down);
    return box;
}

Shape polygon(Shapes& shapes, const draw::DrawList& list, const Mesh& mesh) {
    const std::span<const Vertex> vertices{list.vertices.data() + mesh.first_vertex, mesh.vertex_count + mesh.inside};
    const std::span<const std::uint32_t> triangles{list.indices.data() + mesh.first_index, mesh.index_count};
    const std::span<const Vertex> corners = vertices.first(mesh.vertex_count); // of the outline and the holes
    Shape shape;
    shape.first_edge = static_cast<std::uint32_t>(shapes.texels.size());
    shape.edges = static_cast<std::uint32_t>(corners.size());
    Vec2 low = corners[0].at, high = low;
    draw::each_ring(list, mesh, [&](std::span<const Vertex> ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 a = ring[i].at, b = ring[i + 1 == ring.size() ? 0 : i + 1].at;
            add(shapes.texels, a.x, a.y, b.x, b.y);
            low = min(low, a), high = max(high, a);
        }
    });
    shape.bounds = {low.x, low.y, high.x, high.y};
    shape.inner = inner_box(Edges(shapes.texels).subspan(shape.first_edge), vertices, triangles, shape.bounds);
    add_facets(shapes, shape, mesh, vertices, triangles);
    shape.box = box_of(shape, mesh);
    return shape;
}

// A circle is drawn as the unit circle, whose texture coordinates span the square round it.
Shape circle() {
    Shape shape;
    shape.edges = 1;
    shape.bounds = {-1, -1, 1, 1};
    shape.u = {0.5, 0.0, 0.5};
    shape.v = {0.0, -0.5, 0.5};
    return shape;
}

} // namespace

bool leave(float u, float v, float width, float height) {
    return !(u - width > -0.001f && u + width < 1.001f && v - height > -0.001f && v + height < 1.001f);
}

bool reach(float width, float height) { return width > 0.4999f && height > 0.4999f; }

void update(Shapes& shapes, const draw::DrawList& list) {
    if (shapes.revision > 0 && same_meshes(shapes.meshes, list.meshes) && same(shapes.vertices, list.vertices) &&
        same(shapes.indices, list.indices) && same(shapes.holes, list.holes))
        return;
    shapes.vertices = list.vertices, shapes.indices = list.indices, shapes.holes = list.holes;
    shapes.meshes = list.meshes;
    shapes.texels.clear(), shapes.shapes.clear(), shapes.circles.clear();
    for (const int chords : kChords) shapes.circles.push_back(unit_circle(shapes.texels, chords));
    for (const Mesh& mesh : list.meshes) {
        const bool drawn = draw::is_sound(list, mesh);
        if (!drawn)
            shapes.shapes.emplace_back();
        else if (mesh.kind == draw::MeshKind::circle)
            shapes.shapes.push_back(circle());
        else
            shapes.shapes.push_back(polygon(shapes, list, mesh));
    }
    shapes.texels.resize((shapes.texels.size() + kRow - 1) / kRow * kRow);
    ++shapes.revision;
}

} // namespace evil::gpu
