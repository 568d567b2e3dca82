#version 300 es
// A picture at half its size: each pixel the mean of four. For bloom, only what is bright of it.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

#include "deep.glsl"

#if FIRST == 1
uniform sampler2D picture;
#else
uniform usampler2D picture;
#endif
#if BRIGHT == 1
uniform float threshold; // 0..1
#endif
in vec2 uv;
out uvec4 result;

uvec4 there(int x, int y) {
#if FIRST == 1
    return levels_of(texelFetch(picture, ivec2(x, y), 0)) * PARTS;
#else
    return texelFetch(picture, ivec2(x, y), 0);
#endif
}

void main() {
    ivec2 low = 2 * ivec2(gl_FragCoord.xy), high = min(low + 1, textureSize(picture, 0) - 1);
    result = quarter(there(low.x, low.y) + there(high.x, low.y) + there(low.x, high.y) + there(high.x, high.y));
#if BRIGHT == 1
    float most = float(max(max(result.r, result.g), result.b)), least = threshold * float(FULL);
    float share = clamp((most - least) / (256.0 * float(PARTS) - least), 0.0, 1.0);
    result = uvec4(vec3(result.rgb) * share + 0.5, 0u);
#endif
}
