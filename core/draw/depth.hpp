#pragma once
// Depth of things in perspective: how far behind the plane of their layer they are, and how far back they reach (SPEC G10).
#include "draw/draw_list.hpp"

namespace evil::draw {

struct Perspective {
    bool on = false;
    Vec2 middle;            // pixels: where everything goes that is infinitely far off
    float per_metre = 0.0f; // zoom / distance of the eye: one over that, in metres, is how far the world is
};

inline constexpr float kDeepest = 1e4f; // metres
inline constexpr int kMostSlices = 48;  // of one thing
inline constexpr float kSlice = 1.5f;   // pixels that two of them are apart at most, where there may be so many

// What is at `to_pixel`, in a layer that is `size` times as large as it would be in the world's plane, so many metres
// farther off.
Affine farther(const Affine& to_pixel, const Perspective& perspective, float size, float metres);

// The sides of things, behind the faces of all of them: each is its face again and again, farther and farther off and
// darker, from the farthest on. So a picture, a disc or a ring has depth as well as a box, and no mesh is made for it.
struct Slice {
    float behind = 0.0f; // metres
    Instance instance;
};
void add_slices(std::vector<Slice>& slices, const DrawList& list, const Instance& face, const Perspective& perspective,
                float size, float behind, float depth);

} // namespace evil::draw
