#version 300 es
// A box: six corners an instance, as far out as a pixel's part can be covered, or as the picture is not clear.
// The instance's fields are those of core/gpu/quads.hpp.
precision highp float;
precision highp int;
precision highp sampler2D;

uniform vec2 target_size; // pixels
uniform sampler2D page;   // of the atlas

layout(location = 0) in vec4 place;  // the box's middle; from there to the middle of a side
layout(location = 1) in vec4 beside; // ... of the next side; the texel in the middle
layout(location = 2) in vec4 steps;  // texels from there to the first side, and to the next
layout(location = 3) in vec4 reach;  // what to draw: left, low, right, high, with the sides at -1 and 1
layout(location = 4) in uvec2 what;  // flags, straight colour 0xAABBGGRR

#ifndef LIGHT
#define LIGHT 0
#endif
#ifndef COVER
#define COVER 2
#endif

out vec4 spot; // pixels from the middle, towards the two sides; texture coordinates
flat out vec4 colour;
#if COVER >= 1
flat out vec4 sides; // pixels from the middle to the sides; half the width in which a side fades, half of it evenly
flat out vec2 fade;  // how fast it does: evenly, and where it bends
#endif
#if COVER >= 2
flat out vec4 axes;
flat out vec2 middle;
#endif
#if LIGHT == 1
flat out uint how;
#else
const uint ADDS = 32u;
#endif

const vec2 CORNERS[6] = vec2[6](vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(0, 1));

void main() {
    vec2 at = mix(reach.xy, reach.zw, CORNERS[gl_VertexID % 6]);
    vec2 pixel = place.xy + place.zw * at.x + beside.xy * at.y;
    vec2 lengths = vec2(length(place.zw), length(beside.xy));
    spot = vec4(lengths * at, (beside.zw + steps.xy * at.x + steps.zw * at.y) / vec2(textureSize(page, 0)));
    vec4 straight = vec4(uvec4(what.y, what.y >> 8, what.y >> 16, what.y >> 24) & 255u) / 255.0;
    colour = vec4(straight.rgb * straight.a, straight.a);
#if COVER >= 1
    // A pixel seen along the side: a box `wide` wide, blurred by one `narrow` wide.
    vec2 normal = abs(place.zw) / lengths.x;
    float wide = max(normal.x, normal.y), narrow = max(min(normal.x, normal.y), 0.001);
    sides = vec4(lengths, 0.5 * (wide + narrow), 0.5 * (wide - narrow));
    fade = vec2(1.0 / wide, 0.5 / (wide * narrow));
#endif
#if COVER >= 2
    axes = vec4(place.zw, beside.xy);
    middle = place.xy;
#endif
#if LIGHT == 1
    how = what.x;
#else
    if ((what.x & ADDS) != 0u) colour.a = 0.0; // then nothing is taken from what is behind
#endif
    gl_Position = vec4(2.0 * pixel / target_size - 1.0, 0.0, 1.0); // the target's first row is the picture's top
}
