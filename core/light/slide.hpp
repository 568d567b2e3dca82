#pragma once
// A picture that a light shines through, as through a slide or a stained window.
#include "light/shade.hpp"
#include "math/transform.hpp"
#include <cstdint>
#include <vector>

namespace evil::light {

struct Slide { // linear light; and smaller copies, each half as wide and high
    struct Level {
        int width = 0, height = 0;
        std::vector<float> planes[3];
    };
    std::vector<Level> levels;
};

// From width * height * 4 bytes of straight r, g, b, a; what is transparent lets no light through.
Slide make_slide(const std::uint8_t* straight, int width, int height);

// Puts it before a lamp: its middle where the lamp's is, its corners `radius` metres away. `to_texel`: from the lamp's own
// coordinates, in metres, to the map's, where a metre is `scale` texels.
void put_slide(Lamp& lamp, const Slide& slide, const Affine& to_texel, float radius, float scale);

} // namespace evil::light
