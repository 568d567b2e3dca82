#include "light/glowing.hpp"
#include "draw/draw_list.hpp"
#include "light/light_map.hpp"
#include "math/functions.hpp"
#include <algorithm>
#include <cmath>

namespace evil::light {
namespace {

constexpr int kRound = 24;          // corners of a circle: the light of so many is as good as round
constexpr float kBrightest = 4.0f;  // of what glows; more would only be seen as a white that has no end
constexpr float kOfPicture = 0.25f; // pictures of what glows are mostly dark, and the core does not know them

void add_piece(Glowing& glowing, std::uint32_t first) {
    std::vector<Vec2>& corners = glowing.pieces.corners;
    Caster piece;
    piece.first = first, piece.count = static_cast<std::uint32_t>(corners.size()) - first;
    piece.body = static_cast<std::uint32_t>(glowing.colours.size());
    glowing.pieces.rows.push_back(piece);
}

void add_shape(Glowing& glowing, const draw::DrawList& list, const draw::Mesh& mesh, const Affine& to_pixel) {
    std::vector<Vec2>& corners = glowing.pieces.corners;
    const draw::Vertex* vertices = list.vertices.data() + mesh.first_vertex;
    const auto first = static_cast<std::uint32_t>(corners.size());
    if (mesh.kind == draw::MeshKind::circle) {
        for (int i = 0; i < kRound; ++i) {
            const Rot turn = rotation(2.0 * kPi * i / kRound);
            corners.push_back(apply(to_pixel, vertices[0].at + mesh.radius * Vec2{turn.c, turn.s}));
        }
        add_piece(glowing, first);
    }
    for (std::uint32_t i = 0; i + 2 < mesh.index_count; i += 3) {
        const auto begin = static_cast<std::uint32_t>(corners.size());
        for (std::uint32_t k = 0; k < 3; ++k)
            corners.push_back(apply(to_pixel, vertices[list.indices[mesh.first_index + i + k]].at));
        add_piece(glowing, begin);
    }
}

// The middle, and the radius round it that holds all corners.
void measure(Caster& piece, std::span<const Vec2> corners) {
    Vec2 low = corners[0], high = corners[0];
    for (const Vec2 p : corners)
        low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    piece.middle = 0.5f * (low + high);
    piece.radius = 0.5f * length(high - low);
}

} // namespace

void find_glowing(Glowing& glowing, const draw::DrawList& list, const std::vector<float>& levels) {
    glowing.pieces.rows.clear();
    glowing.pieces.corners.clear();
    glowing.colours.clear();
    for (const draw::Instance& one : list.instances) {
        if (!(one.glow > 0.0f) || one.outline > 0.0f || !is_sound(list, list.meshes[one.mesh])) continue;
        const float share = one.glows != draw::kNoTexture ? kOfPicture : one.texture != draw::kNoTexture ? 0.5f : 1.0f;
        const float strength = share * static_cast<float>(power(std::min(one.glow, kBrightest), 1.0 / kToScreen) *
                                                          (one.tint >> 24) / 255.0);
        Rgb colour;
        for (int c = 0; c < 3; ++c) colour[c] = strength * levels[one.tint >> 8 * c & 255u];
        add_shape(glowing, list, list.meshes[one.mesh], one.to_pixel);
        glowing.colours.push_back(colour);
    }
}

void move_to(Glowing& glowing, const Affine& to_texel) {
    for (Vec2& corner : glowing.pieces.corners) corner = apply(to_texel, corner);
    for (Caster& piece : glowing.pieces.rows)
        measure(piece, std::span(glowing.pieces.corners).subspan(piece.first, piece.count));
}

} // namespace evil::light
