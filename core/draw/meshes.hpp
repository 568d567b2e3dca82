#pragma once
// The shapes that drawings share. A mesh with the same corners is made once and lives as long as a drawing uses it.
#include "draw/draw_list.hpp"
#include "refs.hpp"
#include <span>
#include <unordered_map>

namespace evil::draw {

inline constexpr std::uint32_t kSliced = 16, kSlicedInside = 4;

class Meshes {
public:
    // Each takes a use of the mesh, which is made when it is new. `corners`: a polygon, counter-clockwise, and the first of
    // each of its holes; one that is not simple gets no triangles and is filled where it winds round.
    std::uint32_t take_polygon(std::span<const Vertex> corners, std::span<const std::uint32_t> holes = {});
    std::uint32_t take_circle(float radius);
    // A rectangle of nine parts, each with its own part of a picture: kSliced corners, counter-clockwise round the outside
    // from the lower left, then the four inside.
    std::uint32_t take_sliced(std::span<const Vertex> corners);
    void release(std::uint32_t mesh); // gives a use back; the last one frees the mesh

    const std::vector<Vertex>& vertices() const { return vertices_; }
    const std::vector<std::uint32_t>& indices() const { return indices_; }
    const std::vector<std::uint32_t>& holes() const { return holes_; }
    const std::vector<Mesh>& meshes() const { return meshes_; } // a freed one has no vertices
    std::span<const Vertex> corners_of(const Mesh& mesh) const {
        return std::span(vertices_).subspan(mesh.first_vertex, mesh.vertex_count + mesh.inside);
    }
    std::span<const std::uint32_t> holes_of(const Mesh& mesh) const {
        return std::span(holes_).subspan(mesh.first_hole, mesh.hole_count);
    }
    std::uint32_t count() const { return slots_.count(); }
    std::uint64_t revision() const { return revision_; } // changes whenever one of the four does

private:
    std::uint32_t take(const Mesh& kind, std::span<const Vertex> corners, std::span<const std::uint32_t> holes = {});
    void compact();

    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint32_t> holes_;
    std::vector<Mesh> meshes_;
    Slots slots_;
    std::vector<std::uint32_t> uses_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> by_content_; // looked up by key, never walked
    std::vector<Vec2> outline_;                                        // scratch of triangulation
    std::vector<std::uint32_t> triangles_;
    std::size_t unused_vertices_ = 0; // left behind by freed meshes, until compact()
    std::uint64_t revision_ = 0;
};

} // namespace evil::draw
