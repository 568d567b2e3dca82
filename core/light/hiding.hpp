#pragma once
// Which casters matter to a square of texels, of the many that may stand between it and a lamp.
//
// Of each that is in front of all of the square, two intervals of the lamp's line are known: what it surely hides, from
// every texel, and what it hides at most. Where sure ones together hide the whole line, the square is dark; and a caster
// that hides nothing but what is surely hidden by others is left out. Squares are split in four, down to patches, each with
// what is left of the casters of the larger one: so a thousand casters cost little where most of them are in the dark.
#include "light/shade.hpp"
#include "math/cpu.hpp"
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace evil::light {

struct Hiding { // scratch: for whoever works on a square
    struct Sure {
        float from, to;
        std::uint32_t place; // in the list of casters
    };
    std::array<std::vector<std::uint32_t>, 4> lists; // casters, by number, for squares in squares
    std::vector<Outline> outlines;
    std::vector<Sure> sure;
    std::vector<bool> needed;
    std::vector<std::pair<float, std::uint32_t>> order;
    std::vector<Hidden> hidden;
};

// Keeps those that may stand between the lamp and a disc round `middle`: they must come near the strip between the two.
void keep_near(std::vector<std::uint32_t>& which, const Lamp& lamp, std::span<const Caster> casters, Vec2 middle,
               float radius, InstructionSet set);

// Puts those of `among` that matter into `near`; for small squares without what others hide, and in the order in which they
// hide the line. False: the square is dark.
bool find_what_matters(std::vector<std::uint32_t>& near, Hiding& hiding, std::span<const std::uint32_t> among,
                       const Lamp& lamp, std::span<const Caster> casters, std::span<const Vec2> corners,
                       const Square& square, InstructionSet set);

} // namespace evil::light
