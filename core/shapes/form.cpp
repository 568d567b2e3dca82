#include "shapes/form.hpp"
#include "shapes/shapes.hpp"

namespace evil {
namespace {

constexpr float kSquare = 1e-6f; // of a side: what baking a rectangle in float32 leaves of its right angles

bool is_box(std::span<const Vec2> corners, std::span<const Vec2> normals) {
    if (corners.size() != 4) return false;
    Vec2 along = corners[1] - corners[0], up = corners[3] - corners[0];
    Vec2 gap = corners[0] + corners[2] - corners[1] - corners[3];
    float shorter = std::min(length(along), length(up));
    return shorter > 0.0f && length(gap) <= kSquare * shorter && std::abs(dot(normals[0], normals[1])) <= kSquare;
}

Form box_form(const Piece& piece, std::span<const Vec2> corners, std::span<const Vec2> normals) {
    Form form;
    form.centre = piece.centre;
    form.turn = {normals[1].x, normals[1].y};
    form.half = 0.5f * Vec2{length(corners[1] - corners[0]), length(corners[3] - corners[0])};
    return form;
}

Form upright_form(const Piece& piece, std::span<const Vec2> corners) {
    Form form;
    form.centre = piece.centre;
    for (Vec2 corner : corners) form.half = max(form.half, max(corner - piece.centre, piece.centre - corner));
    return form;
}

} // namespace

FormOf form_of(const Piece& piece, std::span<const Vec2> corners, std::span<const Vec2> normals) {
    bool sharp = piece.radius == 0.0f, box = is_box(corners, normals);
    Form form = box ? box_form(piece, corners, normals) : upright_form(piece, corners);
    form.radius = piece.radius;
    form.reach = piece.reach;
    FormKind kind = corners.empty()                                        ? FormKind::circle
                    : !sharp                                               ? FormKind::other
                    : box                                                  ? FormKind::box
                    : corners.size() >= 3 && corners.size() <= kFewCorners ? FormKind::polygon
                                                                           : FormKind::other;
    return {form, kind};
}

FewCorners few_corners(const Form& form, std::span<const Vec2> corners, std::span<const Vec2> normals) {
    FewCorners few{};
    for (std::size_t i = 0; i < kFewCorners; ++i) {
        std::size_t from = std::min(i, corners.size() - 1);
        Vec2 corner = unrotate(form.turn, corners[from] - form.centre), normal = unrotate(form.turn, normals[from]);
        few.x[i] = corner.x;
        few.y[i] = corner.y;
        few.normal_x[i] = normal.x;
        few.normal_y[i] = normal.y;
    }
    return few;
}

} // namespace evil
