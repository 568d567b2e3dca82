#pragma once
// Where gas comes from and goes to.
#include "fluid/smoke.hpp"

namespace evil::fluid {

// What the running sources give and take within dt: density, fuel, heat and colour now; velocity as a wish to each face.
void apply_sources(Smoke& smoke, std::uint32_t slot, const World& world, float dt);

// Where a source is now: the middle of its area.
Vec2 middle_of(const Source& source, const World& world);

// A push by hand: gas within `radius` of a point moves on with that velocity, the more the nearer it is.
void stir(World& world, Smoke& smoke, Vec2 at, float radius, Vec2 velocity);

} // namespace evil::fluid
