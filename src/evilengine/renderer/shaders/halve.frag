#version 300 es
// A picture at half its size: each pixel the mean of four. For bloom, only what is bright of it.
precision highp float;
precision highp sampler2D;

uniform sampler2D picture;
#if BRIGHT == 1
uniform float threshold; // 0..1
#endif
in vec2 uv;
out vec4 result;

void main() {
    ivec2 low = 2 * ivec2(gl_FragCoord.xy), last = textureSize(picture, 0) - 1, high = min(low + 1, last);
    result = 0.25 * (texelFetch(picture, low, 0) + texelFetch(picture, ivec2(high.x, low.y), 0) +
                     texelFetch(picture, ivec2(low.x, high.y), 0) + texelFetch(picture, high, 0));
#if BRIGHT == 1
    float most = max(max(result.r, result.g), result.b);
    float share = clamp((most - threshold) * 255.0 / (256.0 - 255.0 * threshold), 0.0, 1.0);
    result = vec4(result.rgb * share, 0.0);
#endif
}
