#pragma once
// The form of a piece, as what looks at many pieces at once wants it: a box that holds it, 32 bytes for any kind.
#include "math/transform.hpp"
#include <cstdint>
#include <span>

namespace evil {

struct Piece;

// A box round the piece in the body's frame, its sides along `turn`, thickened by `radius`. Exact for boxes and circles.
//
//        ________________
//       |   y|           |  half.y        the box's edges 0 to 3 are the piece's, if it is one:
//       |    |___ x      |                edge 0 below, 1 right, 2 above, 3 left
//       |  centre        |
//       |________________|
//             half.x
struct alignas(32) Form {
    Vec2 centre;
    Rot turn;
    Vec2 half;
    float radius = 0.0f;
    float reach = 0.0f; // distance from `centre` to the farthest point, radius and all
};
static_assert(sizeof(Form) == 32);

enum class FormKind : std::uint8_t { circle, box, polygon, other };

inline constexpr std::uint32_t kFewCorners = 8; // polygons of up to so many are of kind `polygon`

// Corners and outward normals of a box or a polygon, from the middle of its form and along its axes. Fewer than eight repeat
// the last.
struct alignas(32) FewCorners {
    float x[kFewCorners], y[kFewCorners], normal_x[kFewCorners], normal_y[kFewCorners];
};
FewCorners few_corners(const Form& form, std::span<const Vec2> corners, std::span<const Vec2> normals);

// Its form, and what it is to whoever has shorter ways with circles, boxes and polygons of few corners.
struct FormOf {
    Form form;
    FormKind kind;
};
FormOf form_of(const Piece& piece, std::span<const Vec2> corners, std::span<const Vec2> normals);

} // namespace evil
