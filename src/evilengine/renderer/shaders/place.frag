#version 300 es
// A picture, pixel for pixel, on a part of another one.
precision highp float;
precision highp sampler2D;

uniform sampler2D picture;
uniform vec2 corner; // where its first pixel goes
out vec4 result;

void main() {
    result = texelFetch(picture, ivec2(gl_FragCoord.xy - corner), 0);
}
