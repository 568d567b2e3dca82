#version 300 es
// A box of one picture: what share of a pixel it covers, exactly as the software renderer measures it, and its colour.
precision highp float;
precision highp int;
precision highp sampler2D;

uniform sampler2D page; // of the atlas

#ifndef LIGHT
#define LIGHT 0 // 1 where something of the draw call is lit
#endif
#ifndef COVER
#define COVER 2 // 0: the pictures are clear along their sides; 1: in their corners; 2: anything
#endif

in vec4 spot;
flat in vec4 colour;
#if COVER >= 1
flat in vec4 sides;
flat in vec2 fade;
#endif
#if COVER >= 2
flat in vec4 axes;
flat in vec2 middle;
#endif
#if LIGHT >= 1
flat in uint how;
#endif
out vec4 result;

const uint ADDS = 32u, LIT = 128u;

#include "light.glsl"
#include "area.glsl"

#if COVER >= 1
// By the depth below two sides; by all four edges where a corner is so near that both take a part of the pixel.
float coverage() {
    vec2 near = clamp(sides.xy - abs(spot.xy), -sides.z, sides.z);
    vec2 bent = near - clamp(near, -sides.w, sides.w);
    vec2 shares = 0.5 + near * fade.x - bent * abs(bent) * fade.y;
    float share = shares.x * shares.y;
#if COVER >= 2
    vec2 from = middle - floor(gl_FragCoord.xy), a = vec2(-1, -1), on = vec2(2, 0);
    float area = 0.0;
    int edges = max(abs(near.x), abs(near.y)) < sides.z ? 4 : 0;
    for (int i = 0; i < edges; ++i) {
        vec2 b = a + on;
        area += area_right_of(from + axes.xy * a.x + axes.zw * a.y, from + axes.xy * b.x + axes.zw * b.y);
        a = b;
        on = vec2(-on.y, on.x);
    }
    if (edges > 0) share = min(abs(area), 1.0);
#endif
    return share;
}
#endif

void main() {
    result = colour * texture(page, spot.zw);
#if COVER >= 1
    result *= coverage();
#endif
#if LIGHT >= 1
    if ((how & LIT) != 0u) result.rgb = lit_up(result, texture(light, spot_in_light()).rgb);
    if ((how & ADDS) != 0u) result.a = 0.0; // then nothing is taken from what is behind
#endif
}
