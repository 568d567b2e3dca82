#version 300 es
// Shafts of light, as in core/raster/shafts.cpp: 0 finds what is bright, 1 gathers it along the way to a point, 2 colours it.
precision highp float;
precision highp sampler2D;

uniform sampler2D picture; // a quarter of the size
#if STAGE == 0
uniform float threshold; // 0..1
#elif STAGE == 1
uniform vec2 origin;       // pixels of this size
uniform float at[TAPS], weight[TAPS];
#else
uniform vec3 colour;
#endif
in vec2 uv;
out vec4 result;

void main() {
#if STAGE == 1
    vec2 size = vec2(textureSize(picture, 0)), way = origin - gl_FragCoord.xy;
    float sum = 0.0;
    for (int i = 0; i < TAPS; ++i) {
        vec2 place = clamp(gl_FragCoord.xy + at[i] * way, vec2(0.5), size - 0.5);
        sum += weight[i] * textureLod(picture, place / size, 0.0).r;
    }
    result = vec4(sum, 0.0, 0.0, 0.0);
#else
    vec4 here = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
#if STAGE == 0
    result = vec4((max(max(here.r, here.g), here.b) - threshold) / (1.0 - threshold), 0.0, 0.0, 0.0);
#else
    result = vec4(colour * here.r, 0.0);
#endif
#endif
}
