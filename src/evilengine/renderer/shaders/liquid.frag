#version 300 es
// A liquid over the picture. The same sums as in core/raster/liquid_wide.cpp; core/draw/liquid_map.hpp has them.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "light.glsl"

uniform sampler2D picture;
uniform sampler2D surface; // pixels inside, displacement of what lies behind, rim
uniform sampler2D through;
uniform sampler2D own;
uniform vec3 place; // pixels: the middle of the first texel; texels a pixel
uniform vec2 used;  // texels
uniform float rim_slope;
in vec2 uv;
out vec4 result;

vec4 cubic(float t) { // a uniform B-spline's weights
    float u = 1.0 - t;
    return vec4(u * u * u, 4.0 + t * t * (3.0 * t - 6.0), 1.0 + 3.0 * t * (1.0 + t - t * t), t * t * t) / 6.0;
}

float depth_at(vec2 at) {
    ivec2 low = ivec2(floor(at));
    vec4 across = cubic(at.x - floor(at.x)), down = cubic(at.y - floor(at.y));
    float sum = 0.0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            sum += across[i] * down[j] * texelFetch(surface, low + ivec2(i, j) - 1, 0).r;
    return sum;
}

void main() {
    vec4 here = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    result = here;
    vec2 at = (gl_FragCoord.xy - place.xy) * place.z;
    if (min(at.x, at.y) < 1.0 || at.x >= used.x - 2.0 || at.y >= used.y - 2.0) return;
    float depth = depth_at(at), inside = clamp(depth + 0.5, 0.0, 1.0);
    if (inside == 0.0) return;
    vec2 spot = (at + 0.5) / vec2(textureSize(surface, 0)), size = vec2(textureSize(picture, 0));
    vec4 bent = textureLod(surface, spot, 0.0);
    float line = clamp(1.0 - depth * rim_slope, 0.0, 1.0);
    vec2 from = clamp(gl_FragCoord.xy + bent.yz, vec2(0.5), size - 0.5);
    vec3 colour = textureLod(own, spot, 0.0).rgb + bent.w * line * line;
#if LIGHT >= 1
    colour *= textureLod(light, spot_in_light(), 0.0).rgb;
#endif
    vec3 seen = textureLod(picture, from / size, 0.0).rgb * textureLod(through, spot, 0.0).rgb + colour;
    result = vec4(mix(here.rgb, clamp(seen, 0.0, 1.0), inside), here.a);
}
