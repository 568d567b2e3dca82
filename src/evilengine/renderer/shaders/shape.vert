#version 300 es
// A quad round one thing to draw: six corners an instance, moved out by a pixel so that edges can fade outside the mesh.
// The instance's fields are those of core/gpu/quads.hpp.
precision highp float;
precision highp int;

uniform vec2 target_size; // pixels

layout(location = 0) in vec4 linear;     // mesh to pixels: a b c d
layout(location = 1) in vec4 offsets;    // ... tx ty, and of texture coordinates
layout(location = 2) in vec4 box;        // left, low, right, high
layout(location = 3) in vec4 inner;
layout(location = 4) in vec4 coordinates; // ux uy vx vy
layout(location = 5) in uvec4 what;      // first edge, edges, first facet, how
layout(location = 6) in uvec2 paint;     // tint: straight colour, 0xAABBGGRR; and surface

out vec2 at; // mesh coordinates
flat out vec4 to_pixel, to_mesh, places, inside, texture_matrix, colour;
flat out uvec4 parts;
flat out uint surface;

const uint PIXEL_BOX = 2u << 4;
const uint COVER = 15u, RING = 4u;
const vec2 CORNERS[6] = vec2[6](vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(0, 1));

void main() {
    vec2 corner = CORNERS[gl_VertexID % 6], x = linear.xy, y = linear.zw, pixel;
    float turn = x.x * y.y - x.y * y.x;
    to_mesh = turn == 0.0 ? vec4(0) : vec4(y.y, -x.y, -y.x, x.x) / turn;
    if ((what.w & PIXEL_BOX) != 0u) {
        pixel = mix(box.xy, box.zw, corner);
        at = mat2(to_mesh.xy, to_mesh.zw) * (pixel - offsets.xy);
    } else {
        // Each side moves out by a pixel: along the other axis, by as much more as the two are askew. A ring's by its width.
        float reach = (what.w & COVER) == RING ? 1.0 + inner.x : 1.0;
        vec2 grow = reach * vec2(length(y), length(x)) / abs(turn);
        at = mix(box.xy - grow, box.zw + grow, corner);
        pixel = mat2(x, y) * at + offsets.xy;
    }
    to_pixel = linear;
    places = offsets;
    inside = inner;
    texture_matrix = coordinates;
    uint tint = paint.x;
    vec4 straight = vec4(uvec4(tint, tint >> 8, tint >> 16, tint >> 24) & 255u) / 255.0;
    colour = vec4(straight.rgb * straight.a, straight.a);
    parts = what;
    surface = paint.y;
    gl_Position = vec4(2.0 * pixel / target_size - 1.0, 0.0, 1.0); // the target's first row is the picture's top
}
