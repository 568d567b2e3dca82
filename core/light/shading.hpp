#pragma once
// Adds up the light of a frame's lamps: a map is divided into squares, and each lamp's casters with it.
#include "light/baked.hpp"
#include "light/casters.hpp"
#include "light/haze.hpp"
#include "light/hiding.hpp"
#include "world.hpp"
#include <span>
#include <vector>

namespace evil::light {

inline constexpr int kBlock = 8 * kPatch; // texels: the largest squares, which threads take one by one

struct Cast { // a lamp and what may hide it
    Lamp lamp;
    Baked* baked = nullptr; // of one that stands still
    std::vector<std::uint32_t> casters;
    Veil veil;              // of smoke
    std::size_t moving = 0; // how many of them, the first ones, move: of a lamp that is baked
};

struct Block { // scratch, for whoever works on one
    Hiding hiding;
    std::vector<std::uint32_t> both; // casters that move, and others
    float shares[kPatch * kPatch];   // of a patch
    float veiled[kPatch * kPatch];   // the same behind smoke
};

struct Field {                           // what is lit
    int width, height, stride;           // texels
    std::span<const std::uint8_t> solid; // patches that are solid all over need no light
    const Casters& casters;
};

void shade(std::vector<Block>& blocks, std::span<const Cast> casts, const Field& field, const Planes& to,
           Threads& threads, InstructionSet set);

} // namespace evil::light
