#version 300 es
// A quad round a speck: six corners an instance. The instance's fields are those of core/draw/specks.hpp.
precision highp float;
precision highp int;

uniform vec2 target_size; // pixels

layout(location = 0) in vec4 place;  // middle, and from there to the end of one half axis
layout(location = 1) in float across; // length of the other
layout(location = 2) in uint tint;   // straight colour, 0xAABBGGRR

out vec2 at; // 1 on the rim
flat out vec4 colour;
flat out vec2 half_axes; // pixels

const vec2 CORNERS[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));

void main() {
    float along = length(place.zw);
    vec2 way = place.zw / along;
    half_axes = vec2(along, across);
#if DISC == 1
    vec2 grown = half_axes + 1.0; // room for the edge to fade
#else
    vec2 grown = half_axes;
#endif
    vec2 corner = CORNERS[gl_VertexID % 6] * grown;
    vec2 pixel = place.xy + mat2(way, vec2(-way.y, way.x)) * corner;
    at = corner / half_axes;
    vec4 straight = vec4(uvec4(tint, tint >> 8, tint >> 16, tint >> 24) & 255u) / 255.0;
    colour = vec4(straight.rgb * straight.a, straight.a);
#if ADDS == 1
    colour.a = 0.0; // what is behind stays as bright as it is
#endif
    gl_Position = vec4(2.0 * pixel / target_size - 1.0, 0.0, 1.0);
}
