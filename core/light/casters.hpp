#pragma once
// What casts shadows: every shape of the world but sensors and particles, as convex casters in the light map's coordinates.
#include "light/shade.hpp"
#include "world.hpp"
#include <span>
#include <vector>

namespace evil::light {

struct Casters {
    std::vector<Caster> rows; // in the order of bodies, shapes and pieces
    std::vector<Vec2> corners;
};

// Where things are at `alpha` (0..1) between the last two steps. Keeps the memory of last time.
void gather(Casters& casters, const World& world, const Affine& to_texel, float alpha);

// A number that changes when anything that stands still and casts shadows does. `words` is scratch.
std::uint64_t sum_of_still(const World& world, std::vector<std::uint32_t>& words);

bool holds(const Casters& casters, const Caster& caster, Vec2 point); // strictly inside

enum class Covers : std::uint8_t { any, middle }; // of a texel

// `value` for texels of which the caster covers so much, on rows of `stride`; others stay as they are.
template <class Value>
void fill(const Casters& casters, const Caster& caster, int width, int height, int stride, std::span<Value> texels,
          Value value, Covers covers);

} // namespace evil::light
