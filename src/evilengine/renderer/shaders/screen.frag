#version 300 es
// The finished picture, on the screen. Windows of some desktops show alpha, so it is set to 1.
precision highp float;
precision highp sampler2D;

uniform sampler2D picture;
in vec2 uv;
out vec4 result;

void main() {
    // Pixel for pixel where the window is as large as the picture, which no filter then touches.
    vec2 place = uv * vec2(textureSize(picture, 0)), off_centre = abs(fract(place) - 0.5);
    bool same = max(off_centre.x, off_centre.y) < 0.01;
    vec4 colour = same ? texelFetch(picture, ivec2(place), 0) : textureLod(picture, uv, 0.0);
    result = vec4(colour.rgb, 1.0);
}
