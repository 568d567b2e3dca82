#pragma once
// Signed distances to a convex piece, at eight corners of cells at a time.
#include "math/cpu.hpp"

namespace evil::fluid {

inline constexpr int kMostEdges = 64; // of a piece, as the kernel takes it; the collider's pieces have fewer

// A convex outline in cells: edge i goes from corner (x, y) by (dx, dy); one corner alone is a point, two are a segment.
struct Outline {
    int edges = 0;
    float radius = 0.0f;                                                                        // of the skin round it
    float x[kMostEdges], y[kMostEdges], dx[kMostEdges], dy[kMostEdges], per_length[kMostEdges]; // 1 / length^2, or 0
};

} // namespace evil::fluid

namespace evil {

// Nodes (left..right, j): the distance to the outline, negative inside, where it is less than what stands there; `owner`
// becomes the body's number there.
EVIL_WIDE(void draw_outline(const fluid::Outline& outline, int j, int left, int right, float owner, float* distance,
                            float* owners) noexcept;)
// How open each face of a row is: left faces between nodes (i, j) and (i, j + 1), lower faces between (i, j) and (i + 1, j).
EVIL_WIDE(void open_faces(const float* nodes, const float* nodes_above, int left, int right, float* across,
                          float* up) noexcept;)

} // namespace evil
