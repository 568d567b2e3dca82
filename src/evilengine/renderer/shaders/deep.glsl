// Pictures that are being spread out: whole numbers, in parts of a level, as in core/raster/pyramid_wide.hpp, so that both
// renderers do the same sums.
const uint PARTS = 64u, FULL = 255u * PARTS;

uvec4 quarter(uvec4 sum) {
    return (sum + 2u) >> 2;
}

// A texel of twice the size: of its two neighbours each way, three parts of the nearer.
uvec4 doubled(highp usampler2D half_size, ivec2 at) {
    ivec2 last = textureSize(half_size, 0) - 1, near = min(at / 2, last);
    ivec2 far = clamp(at / 2 + 2 * (at % 2) - 1, ivec2(0), last);
    uvec4 left = quarter(3u * texelFetch(half_size, near, 0) + texelFetch(half_size, ivec2(near.x, far.y), 0));
    uvec4 right = quarter(3u * texelFetch(half_size, ivec2(far.x, near.y), 0) + texelFetch(half_size, far, 0));
    return quarter(3u * left + right);
}

uvec4 levels_of(vec4 pixel) {
    return uvec4(255.0 * pixel + 0.5);
}
