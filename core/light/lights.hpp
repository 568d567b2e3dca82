#pragma once
// The lights of a scene (SPEC G5): State, by slot.
#include "light/slide.hpp"
#include "math/vec2.hpp"
#include "refs.hpp"
#include <array>

namespace evil::light {

using LightRef = Ref<struct LightTag>;
using Rgb = std::array<float, 3>;

enum class Reach : std::uint8_t { round, cone, parallel }; // a lamp, a spot, a sun

struct Light {
    Reach reach = Reach::round;
    BodyRef body;             // it moves with this body, which casts no shadow in it; slot kNone: stands by itself
    Vec2 at;                  // metres, in the world or in the body's frame
    float angle = 0.0f;       // radians, as `at`: where a spot or a sun shines to
    float cone = 1.0f;        // radians: a spot's opening, from side to side
    float edge = 0.3f;        // of a spot: the share of its opening in which it fades
    float radius = 8.0f;      // metres: where its light ends
    float size = 0.2f;        // metres from its middle to its rim: how soft shadows are. A sun's: metres, a metre away
    float falloff = 2.0f;     // exponent of 1 - distance / radius, counted in quarters
    float intensity = 1.0f;   // 1: in its middle as bright as the colour says
    Rgb colour{1, 1, 1};      // as on the screen
    float temperature = 0.0f; // kelvin; 0: none
    Rgb tint{1, 1, 1};        // linear: what the temperature makes of white
    std::uint32_t mask = 0xffffffffu; // categories of the shapes that cast shadows in it
    std::uint32_t slide = kNone;      // of Lights::slides: what it shines through
    bool on = true, shadows = true;
    bool still = false; // what it does is worked out once and kept, as long as neither it nor what stands still changes
    std::uint64_t serial = 0; // order of creation, never used again
};

struct Lights {
    Slots slots;
    std::vector<Light> rows; // by slot
    std::vector<Slide> slides;
    std::uint64_t next_serial = 0;
};

inline LightRef add(Lights& lights, const Light& light) {
    const std::uint32_t slot = lights.slots.take();
    if (slot == lights.rows.size()) lights.rows.emplace_back();
    lights.rows[slot] = light;
    lights.rows[slot].serial = lights.next_serial++;
    return {slot, lights.slots.generation(slot)};
}

} // namespace evil::light
