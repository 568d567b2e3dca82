#version 300 es
// One triangle over the whole screen.
precision highp float;

out vec2 uv;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    uv = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y); // the target's first row is the picture's top
    gl_Position = vec4(corner, 0.0, 1.0);
}
