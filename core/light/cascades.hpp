#pragma once
// Light that surfaces send on to each other and to the air, and how much of the sky is seen from where: by radiance
// cascades, which keep few long rays in many directions and many short ones in few (Sannikov 2023, "Radiance Cascades").
//
// Short rays are joined to longer ones instead of being traced, so nothing leaks through walls and no rings show round
// lights: the holographic form (Freeman, Sannikov, Margel 2025). Each quarter of all directions is worked out by itself,
// turned so that its rays go from row to row. Rays of level n are 2^n rows long; there are 2^n + 1 of them, whose ends lie
// two cells apart, and 2^n cones between them:
//
//      row m        p                      level 2, from one p:   ray 0  1  2  3  4
//      row m + 1   /|\.                    cones 0, 1, 2, 3              \  \ | /  /
//      row m + 2  . . .                    each is split in two by the rays of level 3
//
// On the way up, level n + 1 has its rays from two of level n one behind the other; on the way down, what comes through a
// cone is what its rays meet, and through what they leave, the light of the next level's cones at their ends.
#include "math/cpu.hpp"
#include "threads.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace evil::light {

// What rays meet, by cell. Rows have a border of air, so that neighbours can be read.
struct Cells {
    static constexpr int kBorder = 8;
    // Whether it is solid, 0 or 1; in red, green, blue what share of light that sends back, or how much is in the air; and,
    // where anything glows, how strongly.
    enum Plane : int { solid, colour, glow = colour + 3 };
    int width = 0, height = 0, stride = 0;
    bool glows = false;
    std::vector<float> values;

    void resize(int w, int h, bool with_glow) { // all air, and dark
        width = w, height = h, stride = (w + 7) / 8 * 8 + 2 * kBorder, glows = with_glow;
        values.assign(static_cast<std::size_t>(planes()) * plane_size(), 0.0f);
    }
    int planes() const { return glows ? glow + 3 : glow; }
    std::size_t plane_size() const { return static_cast<std::size_t>(stride) * height; }
    float* row(int plane, int y) {
        return values.data() + plane * plane_size() + static_cast<std::size_t>(y) * stride + kBorder;
    }
    const float* row(int plane, int y) const { return const_cast<Cells*>(this)->row(plane, y); }
};

struct Sky {                     // the light that is everywhere
    std::array<float, 3> colour; // linear
    float reach = 1.0f;          // cells: what is nearer hides some of it, what is as far none
};

struct Cascades { // scratch
    Cells turned;
    std::vector<float> rays;                   // levels one after another: by row, ray and plane, a row of cells
    std::array<std::vector<float>, 2> cones;   // two levels: by row, cone and colour, a row of cells
    std::vector<float> angles;                 // share of all directions, of cone i of level n at 2^n + i
    std::array<std::vector<float>, 2> results; // of the two ways of turning
    std::array<std::vector<float>, 2> leans;   // what comes from ahead less what comes from behind
};

// Three planes each, of `stride` wide rows: the light, and the ways that it comes from, right and down, if they are asked for.
struct Found {
    float *light[3], *across[3], *down[3];
    int stride;
};

// The light in the air of each cell that comes from surfaces and from the sky. Solid cells get what one would see that
// stood in them.
void spread(Cascades& scratch, const Cells& cells, const Sky& sky, const Found& found, Threads& threads,
            InstructionSet set);

} // namespace evil::light
