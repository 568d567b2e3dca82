#version 300 es
// A picture gives way to a smaller one, doubled, or takes up its light (2: so that it never burns out): of each pixel's two neighbours each way, three parts of the nearer.
precision highp float;
precision highp sampler2D;

uniform sampler2D above, below;
uniform float share; // 0..1, of the smaller one
in vec2 uv;
out vec4 result;

vec4 doubled(ivec2 at) {
    ivec2 last = textureSize(below, 0) - 1, near = at / 2;
    ivec2 far = clamp(near + 2 * (at % 2) - 1, ivec2(0), last);
    near = min(near, last);
    vec4 left = 3.0 * texelFetch(below, near, 0) + texelFetch(below, ivec2(near.x, far.y), 0);
    vec4 right = 3.0 * texelFetch(below, ivec2(far.x, near.y), 0) + texelFetch(below, far, 0);
    return (3.0 * left + right) / 16.0;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
#if ADDS == 1
    result = texelFetch(above, at, 0) + doubled(at);
#elif ADDS == 2
    vec4 under = texelFetch(above, at, 0);
    result = under + doubled(at) * (1.0 - under);
#else
    result = mix(texelFetch(above, at, 0), doubled(at), share);
#endif
}
