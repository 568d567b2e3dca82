// What is lit is multiplied with the light map.
#if LIGHT >= 1
uniform sampler2D light; // what colours are multiplied with (core/light/light_map.hpp)
uniform vec4 light_place; // pixels: the middle of the first texel; texels a pixel, twice

// How far from its middle a pixel's rounding is moved: as `soft` does it (core/raster/lit.cpp), so that faint light has
// no steps.
float dither() {
    uvec2 pixel = uvec2(gl_FragCoord.xy) & 7u;
    uint rank = 0u;
    for (uint bit = 0u; bit < 3u; ++bit) {
        uint across = pixel.x >> bit & 1u, down = pixel.y >> bit & 1u;
        rank |= ((across ^ down) << 1 | down) << (2u * (2u - bit));
    }
    return (float(rank) * 8.0 + 4.0) / 512.0 - 0.5;
}

vec2 spot_in_light() {
    return ((gl_FragCoord.xy - light_place.xy) * light_place.zw + 0.5) / vec2(textureSize(light, 0));
}

vec3 lit_up(vec4 unlit, vec3 factor) {
    return min(unlit.rgb * factor + unlit.a * dither() / 255.0, vec3(unlit.a));
}
#endif
