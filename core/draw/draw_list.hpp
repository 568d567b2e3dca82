#pragma once
// What the scene hands to a renderer: geometry that is shared, and one instance for each thing to draw, back to front.
// A renderer reads this and nothing else of the engine.
#include "draw/blend.hpp"
#include "draw/interludes.hpp"
#include "light/light_map.hpp"
#include "math/transform.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace evil::draw {

using Rgba8 = std::uint32_t; // 0xAABBGGRR: bytes r, g, b, a in memory; straight alpha, sRGB

struct Vertex { // local coordinates; texture coordinates 0..1 with v down, as images are stored
    Vec2 at;
    Vec2 uv;
    Rgba8 colour = 0xffffffffu; // multiplied with the instance's tint and the texture
};

enum class MeshKind : std::uint8_t { polygon, circle };

// A simple polygon (its corners in counter-clockwise order, those of its holes after them clockwise, and its triangles) or a
// circle round vertices[first_vertex].
struct Mesh {
    MeshKind kind = MeshKind::polygon;
    bool coloured_corners = false; // false: every corner is white, so a renderer can fill flat
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::uint32_t inside = 0;                       // vertices that follow those of the outline, for triangles alone
    std::uint32_t first_index = 0, index_count = 0; // triangles, relative to first_vertex; none for a circle
    std::uint32_t first_hole = 0, hole_count = 0;   // where each hole begins, relative to first_vertex
    float radius = 0.0f;                            // circle; texture coordinates span its bounding square
};

inline constexpr std::uint32_t kNoTexture = 0;

inline constexpr float kMostGlow = 64.0f;

struct Instance {
    Affine to_pixel;                    // mesh coordinates to target pixels (x right, y down, pixel centres at .5)
    Affine to_texture;                  // applied to the vertices' texture coordinates (the texture matrix)
    std::uint32_t mesh = 0;             // index into meshes
    std::uint32_t texture = kNoTexture; // id given out by the renderer's texture table
    Rgba8 tint = 0xffffffffu;
    float outline = 0.0f; // 0: filled; otherwise only a stroke of this many pixels, centred on the edge
    Blend blend = Blend::over;
    bool lit = false;                   // multiplied with the light map, where that is on
    std::uint32_t normals = kNoTexture; // picture of the surface's normals, for light that falls aslant
    std::uint32_t glows = kNoTexture;   // picture of what shines by itself; none: as the instance looks
    float glow = 0.0f;                  // how strongly: added to what light shows; 0 to kMostGlow
};

struct LayerStart { // where a layer's instances begin
    std::int32_t layer = 0;
    std::uint32_t first = 0;
};

struct DrawList {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> holes;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances; // sorted: layer, then order of creation
    std::vector<LayerStart> layers;  // those that have instances, back to front
    Interludes interludes;           // between the instances
    light::LightMap light;
    std::uint64_t copied_meshes = ~0ull; // revision of the scene's meshes that it holds
};

inline void clear(DrawList& list) { // keeps the memory for the next frame
    list.vertices.clear();
    list.indices.clear();
    list.holes.clear();
    list.meshes.clear();
    list.instances.clear();
    list.layers.clear();
    list.interludes.clear();
    list.light.on = list.light.directed = false;
    list.copied_meshes = ~0ull;
}

// Whether everything that the mesh names is there: a renderer draws nothing else.
inline bool is_sound(const DrawList& list, const Mesh& mesh) {
    const std::uint64_t vertices = std::uint64_t{mesh.first_vertex} + mesh.vertex_count + mesh.inside;
    const std::uint64_t indices = std::uint64_t{mesh.first_index} + mesh.index_count;
    const std::uint64_t holes = std::uint64_t{mesh.first_hole} + mesh.hole_count;
    if (vertices > list.vertices.size() || indices > list.indices.size() || holes > list.holes.size()) return false;
    if (mesh.vertex_count < (mesh.kind == MeshKind::circle ? 1u : 3u)) return false;
    for (std::uint64_t i = mesh.first_index; i < indices; ++i)
        if (list.indices[i] >= mesh.vertex_count + mesh.inside) return false;
    std::uint32_t first = 0; // of a ring
    for (std::uint64_t i = mesh.first_hole; i < holes; ++i) {
        if (list.holes[i] <= first || list.holes[i] >= mesh.vertex_count) return false;
        first = list.holes[i];
    }
    return true;
}

// Calls f with the corners of each ring of a polygon: its outline, then its holes.
template <class F> void each_ring(const DrawList& list, const Mesh& mesh, F&& f) {
    const std::span<const Vertex> corners{list.vertices.data() + mesh.first_vertex, mesh.vertex_count};
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < mesh.hole_count; ++i) {
        const std::uint32_t end = list.holes[mesh.first_hole + i];
        f(corners.subspan(first, end - first));
        first = end;
    }
    f(corners.subspan(first));
}

// Adds a polygon and returns its mesh's index. `triangles` holds indices into `corners`.
inline std::uint32_t add_polygon(DrawList& list, std::span<const Vertex> corners,
                                 std::span<const std::uint32_t> triangles) {
    Mesh mesh;
    mesh.first_vertex = static_cast<std::uint32_t>(list.vertices.size());
    mesh.vertex_count = static_cast<std::uint32_t>(corners.size());
    mesh.first_index = static_cast<std::uint32_t>(list.indices.size());
    mesh.index_count = static_cast<std::uint32_t>(triangles.size());
    for (const Vertex& corner : corners) mesh.coloured_corners |= corner.colour != 0xffffffffu;
    list.vertices.insert(list.vertices.end(), corners.begin(), corners.end());
    list.indices.insert(list.indices.end(), triangles.begin(), triangles.end());
    list.meshes.push_back(mesh);
    return static_cast<std::uint32_t>(list.meshes.size() - 1);
}

// Adds a circle round `centre` and returns its mesh's index. The centre's colour holds for all of it.
inline std::uint32_t add_circle(DrawList& list, const Vertex& centre, float radius) {
    Mesh mesh;
    mesh.kind = MeshKind::circle;
    mesh.coloured_corners = centre.colour != 0xffffffffu;
    mesh.first_vertex = static_cast<std::uint32_t>(list.vertices.size());
    mesh.vertex_count = 1;
    mesh.radius = radius;
    list.vertices.push_back(centre);
    list.meshes.push_back(mesh);
    return static_cast<std::uint32_t>(list.meshes.size() - 1);
}

} // namespace evil::draw
