#version 300 es
// A picture gives way to a smaller one, doubled, or takes up its light. HOW: 0 gives way, 1 takes up light; 2 and 3 are for
// the picture itself, which gives way, or takes up light so that it never burns out.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

#include "deep.glsl"

uniform usampler2D below;
uniform float share; // 0..1, of the smaller one
in vec2 uv;
#if HOW >= 2
uniform sampler2D above;
out vec4 result;
#else
uniform usampler2D above;
out uvec4 result;
#endif

uvec4 mixed(uvec4 there, uvec4 fresh) {
    uint part = uint(256.0 * share + 0.5);
    return (there * (256u - part) + fresh * part + 128u) >> 8;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 fresh = doubled(below, at);
#if HOW == 0
    result = mixed(texelFetch(above, at, 0), fresh);
#elif HOW == 1
    result = min(texelFetch(above, at, 0) + fresh, FULL);
#elif HOW == 2
    uvec4 there = levels_of(texelFetch(above, at, 0)) * PARTS;
    result = vec4((mixed(there, fresh) + PARTS / 2u) / PARTS) / 255.0;
#else
    vec4 under = texelFetch(above, at, 0);
    result = under + vec4((fresh + PARTS / 2u) / PARTS) / 255.0 * (1.0 - under);
#endif
}
