#include "draw/meshes.hpp"
#include "hash.hpp"
#include "shapes/polygon.hpp"
#include <algorithm>
#include <cstring>
#include <utility>

namespace evil::draw {
namespace {

// Good enough to find equal corners; equality is checked in full.
std::uint64_t hash_of(const Mesh& kind, std::span<const Vertex> corners, std::span<const std::uint32_t> holes) {
    static_assert(sizeof(Vertex) == 20, "no padding: corners are compared and hashed byte by byte");
    auto sum = [](auto list) { return hash({reinterpret_cast<const std::uint8_t*>(list.data()), list.size_bytes()}); };
    return sum(corners) ^ (sum(holes) << 1) ^ std::bit_cast<std::uint32_t>(kind.radius) ^ kind.inside;
}

bool same_bytes(std::span<const Vertex> a, std::span<const Vertex> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

// A circle is one vertex, its centre; a renderer adds the corners it wants.
constexpr Vertex kCentre{{0, 0}, {0.5f, 0.5f}, 0xffffffffu};

// Nine parts of two triangles each:
//
//    9---8---7---6
//    |   |   |   |
//   10--15--14---5
//    |   |   |   |
//   11--12--13---4
//    |   |   |   |
//    0---1---2---3
constexpr std::uint32_t kNineParts[][4] = {{0, 1, 12, 11},   {1, 2, 13, 12},   {2, 3, 4, 13},
                                           {11, 12, 15, 10}, {12, 13, 14, 15}, {13, 4, 5, 14},
                                           {10, 15, 8, 9},   {15, 14, 7, 8},   {14, 5, 6, 7}};

constexpr std::size_t kFewUnused = 4096; // below this, gaps cost less than moving everything up

} // namespace

std::uint32_t Meshes::take_polygon(std::span<const Vertex> corners, std::span<const std::uint32_t> holes) {
    Mesh kind;
    kind.coloured_corners = std::ranges::any_of(corners, [](const Vertex& v) { return v.colour != 0xffffffffu; });
    return take(kind, corners, holes);
}

std::uint32_t Meshes::take_circle(float radius) {
    Mesh kind;
    kind.kind = MeshKind::circle;
    kind.radius = radius;
    return take(kind, {&kCentre, 1});
}

std::uint32_t Meshes::take_sliced(std::span<const Vertex> corners) {
    Mesh kind;
    kind.inside = kSlicedInside;
    return take(kind, corners);
}

std::uint32_t Meshes::take(const Mesh& kind, std::span<const Vertex> corners, std::span<const std::uint32_t> holes) {
    const std::uint64_t hash = hash_of(kind, corners, holes);
    for (auto [it, last] = by_content_.equal_range(hash); it != last; ++it) {
        const Mesh& known = meshes_[it->second];
        if (known.kind == kind.kind && known.radius == kind.radius && known.inside == kind.inside &&
            same_bytes(corners, corners_of(known)) && std::ranges::equal(holes, holes_of(known))) {
            ++uses_[it->second];
            return it->second;
        }
    }

    triangles_.clear();
    if (kind.inside > 0) {
        for (const auto& [a, b, c, d] : kNineParts) triangles_.insert(triangles_.end(), {a, b, c, a, c, d});
    } else if (kind.kind == MeshKind::polygon) {
        outline_.clear();
        for (const Vertex& v : corners) outline_.push_back(v.at);
        const Rings rings(outline_, holes);
        bool simple = check_polygon(rings).fault == PolygonFault::none; // not so where a chain crosses itself
        if (simple) triangulate(rings, triangles_);
    }
    const std::uint32_t slot = slots_.take();
    if (slot == meshes_.size()) {
        meshes_.emplace_back();
        uses_.push_back(0);
    }
    Mesh& mesh = meshes_[slot] = kind;
    mesh.first_vertex = static_cast<std::uint32_t>(vertices_.size());
    mesh.vertex_count = static_cast<std::uint32_t>(corners.size()) - kind.inside;
    mesh.first_index = static_cast<std::uint32_t>(indices_.size());
    mesh.index_count = static_cast<std::uint32_t>(triangles_.size());
    vertices_.insert(vertices_.end(), corners.begin(), corners.end());
    indices_.insert(indices_.end(), triangles_.begin(), triangles_.end());
    mesh.first_hole = static_cast<std::uint32_t>(holes_.size());
    mesh.hole_count = static_cast<std::uint32_t>(holes.size());
    holes_.insert(holes_.end(), holes.begin(), holes.end());
    by_content_.emplace(hash, slot);
    uses_[slot] = 1;
    ++revision_;
    return slot;
}

void Meshes::release(std::uint32_t slot) {
    if (--uses_[slot] > 0) return;
    Mesh& mesh = meshes_[slot];
    auto [it, last] = by_content_.equal_range(hash_of(mesh, corners_of(mesh), holes_of(mesh)));
    it = std::find_if(it, last, [slot](const auto& entry) { return entry.second == slot; });
    by_content_.erase(it);
    unused_vertices_ += mesh.vertex_count + mesh.inside;
    mesh = Mesh{};
    slots_.release(slot);
    ++revision_;
    if (unused_vertices_ > kFewUnused && 2 * unused_vertices_ > vertices_.size()) compact();
}

// Move what is used to the front. Meshes are not in the order of their vertices, so each is copied to new storage.
void Meshes::compact() {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices, all_holes;
    for (std::uint32_t slot = 0; slot < meshes_.size(); ++slot) {
        if (!slots_.taken(slot)) continue;
        Mesh& mesh = meshes_[slot];
        auto corners = corners_of(mesh);
        auto holes = holes_of(mesh);
        auto triangles = std::span(indices_).subspan(mesh.first_index, mesh.index_count);
        mesh.first_vertex = static_cast<std::uint32_t>(vertices.size());
        mesh.first_index = static_cast<std::uint32_t>(indices.size());
        mesh.first_hole = static_cast<std::uint32_t>(all_holes.size());
        vertices.insert(vertices.end(), corners.begin(), corners.end());
        indices.insert(indices.end(), triangles.begin(), triangles.end());
        all_holes.insert(all_holes.end(), holes.begin(), holes.end());
    }
    vertices_ = std::move(vertices);
    indices_ = std::move(indices);
    holes_ = std::move(all_holes);
    unused_vertices_ = 0;
}

} // namespace evil::draw
