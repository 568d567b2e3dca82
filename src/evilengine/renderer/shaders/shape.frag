#version 300 es
// What share of a pixel a thing covers, exactly as the software renderer measures it, and with which colour.
precision highp float;
precision highp int;
precision highp sampler2D;

#ifndef PICTURES
#define PICTURES 8 // how many this draw call mixes: 0, 1, 2, 4 or 8
#endif
#ifndef FACETS
#define FACETS 1 // 0 where nothing has colours or texture coordinates that differ from triangle to triangle
#endif

#ifndef LIGHT
#define LIGHT 0 // 1 where something of the frame is lit, 3 with the ways that light comes from
#endif
#ifndef SURFACES
#define SURFACES 0 // 1 where something of this draw call has normals, or glows
#endif

uniform sampler2D shapes; // edges and facets of the meshes (core/gpu/shapes.hpp), then edges of this frame
#if PICTURES >= 1
uniform sampler2D picture0;
#endif
#if PICTURES >= 2
uniform sampler2D picture1;
#endif
#if PICTURES >= 4
uniform sampler2D picture2, picture3;
#endif
#if PICTURES >= 8
uniform sampler2D picture4, picture5, picture6, picture7;
#endif

#if LIGHT == 3
uniform sampler2D light_across, light_down; // 0 is -1, 1/2 nowhere, 1 is 1
#endif

in vec2 at;
flat in vec4 to_pixel, to_mesh, places, inside, texture_matrix, colour;
flat in uvec4 parts;
flat in uint surface;
out vec4 result;

const uint ROW = 1024u;
const uint ALL = 0u, EDGES = 1u, DISC = 3u;
const uint REPEAT = 1u << 4, HOLLOW = 4u << 4, COLOURED = 8u << 4, TEXTURED = 16u << 4, ADDS = 32u << 4, LIT = 128u << 4, FINE = 64u << 4;
const uint FACET_TEXELS = 10u;
const float GLOW_STEPS = 1024.0; // to 1
const float SLANT = 1.5;         // kSlant in core/light/light_map.hpp

vec4 texel(uint i) { return texelFetch(shapes, ivec2(i % ROW, i / ROW), 0); }

// ---- coverage ----

#include "area.glsl"

float covered_by_edges(bool in_pixels) {
    mat2 linear = in_pixels ? mat2(1.0) : mat2(to_pixel.xy, to_pixel.zw);
    vec2 from = (in_pixels ? vec2(0) : places.xy) - floor(gl_FragCoord.xy);
    float area = 0.0;
    for (uint i = parts.x, end = parts.x + parts.y; i < end; ++i) {
        vec4 edge = texel(i);
        area += area_right_of(linear * edge.xy + from, linear * edge.zw + from);
    }
    return min(abs(area), 1.0);
}

// The share of a pixel on the inner side of a straight edge: how far its centre is inside, and the edge's unit normal.
//
//   1 |      ____     a box as wide as the larger part of the normal, blurred by one as wide as the smaller
//     |     /
//   0 |____/_____ depth
float half_plane(float depth, vec2 normal) {
    vec2 n = abs(normal);
    float wide = max(n.x, n.y), narrow = min(n.x, n.y), rest = 0.5 * (wide + narrow) - abs(depth);
    if (rest <= 0.0) return depth > 0.0 ? 1.0 : 0.0;
    if (abs(depth) <= 0.5 * (wide - narrow)) return 0.5 + depth / wide;
    float outside = rest * rest / (2.0 * wide * narrow);
    return depth > 0.0 ? 1.0 - outside : outside;
}

// The unit circle, however it is stretched, by distance over steepness; `half_width` more than 0 for a stroke.
float covered_by_circle(float half_width) {
    mat2 inverse_linear = mat2(to_mesh.xy, to_mesh.zw);
    float reach = max(length(at), 1e-6);
    vec2 outward = at / reach, slope = outward * inverse_linear; // how fast `reach` grows, a pixel
    float steepness = max(length(slope), 1e-12);
    vec2 normal = slope / steepness;
    float depth = (1.0 - reach) / steepness;
    vec2 along = inverse_linear * vec2(-normal.y, normal.x);
    float turn = outward.x * along.y - outward.y * along.x;
    float bend = turn * turn / (reach * steepness) / 24.0; // a curve takes its curvature / 24 from a pixel
    if (half_width <= 0.0) return half_plane(depth - bend, normal);
    float hole = 1.0 / steepness > half_width ? half_plane(depth - half_width - bend, normal) : 0.0;
    return max(half_plane(depth + half_width - bend, normal) - hole, 0.0);
}

float coverage() {
    uint cover = parts.w & 15u;
    if (cover == ALL) return 1.0;
    if (cover >= DISC) return covered_by_circle(cover == DISC ? 0.0 : inside.x);
    // Half a pixel, and rounding, as a box in mesh coordinates: if that lies within `inside`, no edge is near.
    vec2 margin = 0.502 * (abs(to_mesh.xy) + abs(to_mesh.zw));
    if (all(greaterThan(at - margin, inside.xy)) && all(lessThan(at + margin, inside.zw)))
        return (parts.w & HOLLOW) != 0u ? 0.0 : 1.0;
    return covered_by_edges(cover != EDGES);
}

// ---- colour ----

#if FACETS == 1
// The triangle that the point lies in, or is nearest to: where the least distance to its sides is largest.
uint facet_at(uint count) {
    uint best = parts.z;
    float most = -1e30;
    for (uint i = 0u; count > 1u && i < count; ++i) {
        uint facet = parts.z + i * FACET_TEXELS;
        vec3 a = texel(facet).xyz, b = texel(facet + 1u).xyz, c = texel(facet + 2u).xyz;
        float least = min(min(dot(a.xy, at) + a.z, dot(b.xy, at) + b.z), dot(c.xy, at) + c.z);
        if (least > most) most = least, best = facet;
    }
    return best;
}

vec4 facet_colour(uint facet) {
    vec4 mixed = texel(facet + 5u) * at.x + texel(facet + 6u) * at.y + texel(facet + 7u);
    return clamp(mixed, texel(facet + 8u), texel(facet + 9u));
}
#endif

#if PICTURES >= 1
// Linear within one of the picture's copies: the largest whose texels are not much smaller than pixels, as `soft` picks it.
vec4 sample_picture(sampler2D picture, vec2 uv, vec4 steps) {
    vec2 size = vec2(textureSize(picture, 0));
    vec2 across = steps.xy * size, down = steps.zw * size;
    vec2 squared = vec2(dot(across, across), dot(down, down)); // texels in one pixel
    float texels = (parts.w & FINE) != 0u ? min(squared.x, squared.y) : max(squared.x, squared.y);
    float level = texels > 2.25 ? ceil(0.5 * log2(texels / 2.25)) : 0.0;
    level = min(level, floor(log2(max(size.x, size.y)) + 0.0001));
    if ((parts.w & REPEAT) == 0u) {
        vec2 half_texel = 0.5 / vec2(textureSize(picture, int(level)));
        uv = clamp(uv, half_texel, 1.0 - half_texel);
    }
    return textureLod(picture, uv, level);
}

// Where a point lies in its pictures, and how far that goes from pixel to pixel.
struct Place {
    vec2 uv;
    vec4 steps; // to the right, and down
};

Place picture_place(uint facet, uint count) {
    mat2 steps = mat2(to_mesh.xy, to_mesh.zw); // of mesh coordinates, then of the facet's, from pixel to pixel
    vec2 uv = at;
#if FACETS == 1
    if (count > 0u) {
        vec3 u = texel(facet + 3u).xyz, v = texel(facet + 4u).xyz;
        uv = vec2(dot(u.xy, at) + u.z, dot(v.xy, at) + v.z);
        steps = mat2(vec2(u.x, v.x), vec2(u.y, v.y)) * steps;
    }
#endif
    mat2 to_texture = mat2(texture_matrix.xz, texture_matrix.yw);
    uv = to_texture * uv + places.zw;
    steps = to_texture * steps;
    return Place(uv, vec4(steps[0], steps[1]));
}

vec4 picture_colour(uint unit, Place place) {
#if PICTURES >= 8
    if (unit == 7u) return sample_picture(picture7, place.uv, place.steps);
    if (unit == 6u) return sample_picture(picture6, place.uv, place.steps);
    if (unit == 5u) return sample_picture(picture5, place.uv, place.steps);
    if (unit == 4u) return sample_picture(picture4, place.uv, place.steps);
#endif
#if PICTURES >= 4
    if (unit == 3u) return sample_picture(picture3, place.uv, place.steps);
    if (unit == 2u) return sample_picture(picture2, place.uv, place.steps);
#endif
#if PICTURES >= 2
    if (unit == 1u) return sample_picture(picture1, place.uv, place.steps);
#endif
    return sample_picture(picture0, place.uv, place.steps);
}
#endif

// ---- light ----

#if LIGHT == 3 && SURFACES == 1 && PICTURES >= 1
// The share of the light that a surface gets by its normals (core/raster/surface_wide.cpp), as a factor of its colour.
vec3 bent(vec2 spot, Place place) {
    vec3 normal = (picture_colour((surface & 15u) - 1u, place).rgb * 255.0 - 128.0) / 127.0;
    vec2 right = place.steps.xz, up = -place.steps.yw; // how u and -v grow
    float width = length(right), height = length(up);
    vec2 lean = SLANT * (normal.x * (width > 0.0 ? right / width : vec2(0)) +
                         normal.y * (height > 0.0 ? up / height : vec2(0)));
    vec3 across = texture(light_across, spot).rgb * 2.0 - 1.0, down = texture(light_down, spot).rgb * 2.0 - 1.0;
    return sqrt(max(normal.z + lean.x * across + lean.y * down, 0.0));
}
#endif

#include "light.glsl"

void main() {
    float covered = coverage();
    result = colour * covered;
    uint facet = 0u, facets = parts.w >> 16;
#if FACETS == 1
    facet = facet_at(facets);
    if ((parts.w & COLOURED) != 0u) result *= facet_colour(facet);
#endif
#if PICTURES >= 1
    Place place;
    if ((parts.w & TEXTURED) != 0u || surface != 0u) place = picture_place(facet, facets);
    if ((parts.w & TEXTURED) != 0u) result *= picture_colour(parts.w >> 12 & 15u, place);
#endif
#if SURFACES == 1
    vec3 glow = result.rgb;
#if PICTURES >= 1
    if ((surface & 0xf0u) != 0u) glow = colour.rgb * covered * picture_colour((surface >> 4 & 15u) - 1u, place).rgb;
#endif
#endif
#if LIGHT >= 1
    if ((parts.w & LIT) != 0u) {
        vec2 spot = spot_in_light();
        vec3 factor = texture(light, spot).rgb;
#if LIGHT == 3 && SURFACES == 1 && PICTURES >= 1
        if ((surface & 15u) != 0u) factor *= bent(spot, place);
#endif
        result.rgb = lit_up(result, factor);
    }
#endif
#if SURFACES == 1
    glow *= float(surface >> 8) / GLOW_STEPS;
    if ((surface >> 8) != 0u) result.rgb = min(sqrt(result.rgb * result.rgb + glow * glow), vec3(result.a));
#endif
    if ((parts.w & ADDS) != 0u) result.a = 0.0; // then nothing is taken from what is behind
}
