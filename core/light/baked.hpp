#pragma once
// Lightmaps (SPEC G6): what a light that stands still shows of what stands still is worked out once, for each texel of the
// world that is seen, and kept until something of it changes. Where a body that moves may cast a shadow, a patch is worked
// out as ever, so the picture is the same.
#include "light/lights.hpp"
#include "light/shade.hpp"
#include <cstdint>
#include <vector>

namespace evil::light {

struct BakedOf { // what the shares hang on; colours and brightness come later
    std::uint64_t serial = 0, casters = 0;
    Pose pose; // of its body
    Vec2 at;
    float angle = 0, cone = 0, edge = 0, radius = 0, size = 0, falloff = 0;
    float a = 0, b = 0, c = 0, d = 0; // world to texels
    std::uint32_t mask = 0;
    bool shadows = false, soft = false;
    friend bool operator==(const BakedOf&, const BakedOf&) = default;
};

struct Baked { // scratch, by a light's slot; texels keep their places in the world
    BakedOf of;
    int left = 0, top = 0; // of the first, in the world
    int stride = 0, height = 0;
    std::vector<float> shares; // kUnknown where nobody has looked
};

// Makes it begin at another texel of the world; what stays in sight is kept.
void move_to(Baked& baked, const BakedOf& of, int left, int top, int stride, int height);

inline Shares shares_of(Baked& baked, const Patch& patch) {
    return {baked.shares.data() + static_cast<std::size_t>(patch.y) * baked.stride + patch.x, baked.stride};
}

} // namespace evil::light
