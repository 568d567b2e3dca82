#version 300 es
// Shafts of light, as in core/raster/shafts.cpp: 0 finds what is bright, 1 gathers it along the way to a point, 2 colours it.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

#include "deep.glsl"

uniform usampler2D picture; // a quarter of the size
#if STAGE == 0
uniform float threshold; // 0..1
#elif STAGE == 1
uniform vec2 origin;       // pixels of this size
uniform float at[TAPS], weight[TAPS];
#elif STAGE == 2
uniform vec3 colour;
#endif
in vec2 uv;
out uvec4 result;

#if STAGE == 1
float grey(vec2 place) { // between four pixels' middles
    ivec2 last = textureSize(picture, 0) - 1;
    place = clamp(place - 0.5, vec2(0.0), vec2(last));
    ivec2 low = ivec2(place), high = min(low + 1, last);
    vec2 part = place - vec2(low);
    vec4 four = vec4(texelFetch(picture, low, 0).r, texelFetch(picture, ivec2(high.x, low.y), 0).r,
                     texelFetch(picture, ivec2(low.x, high.y), 0).r, texelFetch(picture, high, 0).r);
    vec2 row = mix(four.xy, four.zw, part.y);
    return mix(row.x, row.y, part.x);
}
#endif

void main() {
#if STAGE == 1
    vec2 way = origin - gl_FragCoord.xy;
    float sum = 0.5;
    for (int i = 0; i < TAPS; ++i)
        sum += weight[i] * grey(gl_FragCoord.xy + at[i] * way);
    result = uvec4(uint(sum), 0u, 0u, 0u);
#elif STAGE == 0
    uvec4 here = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    float most = float(max(max(here.r, here.g), here.b)) / float(FULL);
    float share = clamp((most - threshold) / (1.0 - threshold), 0.0, 1.0);
    result = uvec4(uint(float(FULL) * share + 0.5), 0u, 0u, 0u);
#else
    vec3 light = colour * float(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).r);
    result = uvec4(min(light, vec3(FULL)), 0u);
#endif
}
