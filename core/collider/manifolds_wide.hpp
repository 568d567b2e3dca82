#pragma once
// Manifolds of eight pairs at a time, for the kinds of forms that most pieces are. What they say is what collide() in
// narrow_phase.cpp says, but for rounding: that is the reference, and does what these do not.
#include "math/cpu.hpp"
#include <cstddef>
#include <cstdint>

namespace evil {

struct Contact;
inline constexpr std::int32_t kNoAxis = -1, kAxisOfB = 1 << 16; // else the edge's number

struct EightPairs {
    std::uint32_t a[8], b[8];                // pieces
    std::int32_t corners_a[8], corners_b[8]; // how many they have
    std::int32_t axis[8];                    // remembered from the last step
};

struct EightManifolds {
    std::uint32_t count[8];
    std::int32_t axis[8]; // to remember
    float normal_x[8], normal_y[8];
    struct {
        float anchor_ax[8], anchor_ay[8], anchor_bx[8], anchor_by[8], separation[8];
        std::uint32_t id[8];
    } points[2];
};

// Tables of eight floats a row: two rows a placed form (collider/placed.hpp), four rows a piece's corners.
struct FormTables {
    const float *placed, *corners;
    float margin, bias; // metres
};

// clang-format off
EVIL_WIDE(
void collide_boxes(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;
void collide_circles(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;
void collide_box_circle(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;
void collide_circle_box(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;
void collide_polygons(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;
void collide_polygon_circle(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;
void collide_circle_polygon(const FormTables& t, const EightPairs& pairs, EightManifolds& out) noexcept;

// Manifolds into eight contacts that are no sensors, and what marks_of says of each; one may come twice.
void take_over(const EightManifolds& m, Contact* const* contacts, std::uint8_t* marks) noexcept;)
// clang-format on

} // namespace evil
