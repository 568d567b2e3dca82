#version 300 es
// The finished picture: bloom, tones, saturation, vignette, grain. The same sums as in core/raster/pyramid_wide.cpp.
precision highp float;
precision highp int;
precision highp sampler2D;

uniform sampler2D picture;
uniform sampler2D glow;  // what is bright, spread out, at half the size
uniform sampler2D tones; // core/draw/post.hpp
uniform vec4 look;       // bloom, saturation, vignette, grain
uniform vec2 seed;       // high and low half of the grain's
in vec2 uv;
out vec4 result;

#if BLOOM == 1
vec3 glow_at(ivec2 at) {
    ivec2 last = textureSize(glow, 0) - 1, near = min(at / 2, last);
    ivec2 far = clamp(at / 2 + 2 * (at % 2) - 1, ivec2(0), last);
    vec3 left = 3.0 * texelFetch(glow, near, 0).rgb + texelFetch(glow, ivec2(near.x, far.y), 0).rgb;
    vec3 right = 3.0 * texelFetch(glow, ivec2(far.x, near.y), 0).rgb + texelFetch(glow, far, 0).rgb;
    return (3.0 * left + right) / 16.0;
}
#endif

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
    vec3 light = 255.0 * pixel.rgb;
#if BLOOM == 1
    light += 255.0 * look.x * glow_at(at);
#endif
    ivec3 entry = min(ivec3(light + 0.5), 1023);
    vec3 tone = vec3(texelFetch(tones, ivec2(entry.r, 0), 0).r, texelFetch(tones, ivec2(entry.g, 0), 0).g,
                     texelFetch(tones, ivec2(entry.b, 0), 0).b);
    float grey = dot(tone, vec3(0.2126, 0.7152, 0.0722));
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(textureSize(picture, 0)) - 1.0;
    float off = 0.5 * dot(place, place);
    vec3 shown = mix(vec3(grey), tone, look.y) * max(1.0 - off * off * look.z, 0.0);
#if GRAIN == 1
    shown += 255.0 * look.w * noise(uvec2(at));
#endif
    result = vec4(shown / 255.0, pixel.a);
}
