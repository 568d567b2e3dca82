#version 300 es
// The finished picture: bloom, tones, saturation, vignette, grain. The same sums as in core/raster/pyramid_wide.cpp.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

#include "deep.glsl"

uniform sampler2D picture;
#if BLOOM == 1
uniform usampler2D glow; // what is bright, spread out, at half the size
#endif
uniform sampler2D tones; // core/draw/post.hpp
uniform vec4 look;       // bloom, saturation, vignette, grain
uniform vec2 seed;       // high and low half of the grain's
in vec2 uv;
out vec4 result;

vec3 tone(ivec3 entry) {
    ivec3 at = min(entry, 1023);
    return vec3(texelFetch(tones, ivec2(at.r, 0), 0).r, texelFetch(tones, ivec2(at.g, 0), 0).g,
                texelFetch(tones, ivec2(at.b, 0), 0).b);
}

#if GRAIN == 1
float noise(uvec2 at) {
    uint h = at.x * 0x9e3779b1u + (uint(seed.x) << 16 | uint(seed.y)) + at.y * 0x85ebca77u;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return float(h >> 16) / 32768.0 - 1.0;
}
#endif

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 pixel = texelFetch(picture, at, 0);
    ivec3 levels = ivec3(levels_of(pixel).rgb);
#if BLOOM == 1
    vec3 light = vec3(levels) + vec3(doubled(glow, at).rgb) * (look.x / float(PARTS));
    ivec3 entry = ivec3(light); // and between two: where the table is steep, a small part of a level is seen
    vec3 toned = mix(tone(entry), tone(entry + 1), light - vec3(entry));
#else
    vec3 toned = tone(levels);
#endif
    float grey = dot(toned, vec3(0.2126, 0.7152, 0.0722));
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(textureSize(picture, 0)) - 1.0;
    float off = 0.5 * dot(place, place);
    vec3 shown = mix(vec3(grey), toned, look.y) * max(1.0 - off * off * look.z, 0.0);
#if GRAIN == 1
    shown += 255.0 * look.w * noise(uvec2(at));
#endif
    result = vec4(shown / 255.0, pixel.a);
}
