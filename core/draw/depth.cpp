#include "draw/depth.hpp"
#include "draw/layers.hpp"
#include <algorithm>
#include <cmath>

namespace evil::draw {
namespace {

constexpr float kNearest = 0.01f; // how near to the eye a thing comes, of the distance of its layer
constexpr float kFarShade = 0.3f, kNearShade = 0.75f;

float shrink(const Perspective& perspective, float size, float metres) {
    return 1.0f / std::max(1.0f + size * perspective.per_metre * metres, kNearest);
}

float reach_of(const DrawList& list, const Instance& face, Vec2 middle) { // pixels, of what is farthest from it
    const Mesh& mesh = list.meshes[face.mesh];
    float most = 0.0f;
    for (std::uint32_t i = 0; i < mesh.vertex_count; ++i)
        most = std::max(most, length(apply(face.to_pixel, list.vertices[mesh.first_vertex + i].at) - middle));
    return most + mesh.radius * std::sqrt(std::fabs(determinant(face.to_pixel)));
}

Rgba8 shaded(Rgba8 colour, float shade) {
    const auto grey = static_cast<Rgba8>(std::lround(255.0f * shade));
    return multiplied(colour, 0xff000000u | grey << 16 | grey << 8 | grey);
}

} // namespace

Affine farther(const Affine& to_pixel, const Perspective& perspective, float size, float metres) {
    const float by = shrink(perspective, size, metres);
    const Vec2 middle = (1.0f - by) * perspective.middle;
    return compose({by, 0, 0, by, middle.x, middle.y}, to_pixel);
}

void add_slices(std::vector<Slice>& slices, const DrawList& list, const Instance& face, const Perspective& perspective,
                float size, float behind, float depth) {
    const float front = shrink(perspective, size, behind), back = shrink(perspective, size, behind + depth);
    const float moved = reach_of(list, face, perspective.middle) * (1.0f - back / front);
    const float wanted = std::ceil(moved / kSlice); // too far out to say: as many as there may be
    const int count = wanted < static_cast<float>(kMostSlices) ? std::max(static_cast<int>(wanted), 1) : kMostSlices;
    for (int i = count; i >= 1; --i) {
        const float part = static_cast<float>(i) / static_cast<float>(count);
        const float by = shrink(perspective, size, behind + part * depth) / front;
        const Vec2 middle = (1.0f - by) * perspective.middle;
        Slice& slice = slices.emplace_back(behind + part * depth, face);
        slice.instance.to_pixel = compose({by, 0, 0, by, middle.x, middle.y}, face.to_pixel);
        slice.instance.tint = shaded(face.tint, kNearShade + part * (kFarShade - kNearShade));
    }
}

} // namespace evil::draw
