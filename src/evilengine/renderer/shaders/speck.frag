#version 300 es
// A speck: brightest in the middle, or a disc with a clear edge. The same sums as in core/raster/spans_wide.cpp.
precision highp float;

in vec2 at;
flat in vec4 colour;
flat in vec2 half_axes; // pixels
out vec4 result;

void main() {
    float squared = dot(at, at);
#if DISC == 1
    float distance = sqrt(squared), slope = length(at / half_axes) / max(distance, 1e-6);
    result = colour * clamp((1.0 - distance) / max(slope, 1e-6) + 0.5, 0.0, 1.0);
#else
    float inside = max(1.0 - squared, 0.0);
    result = colour * (inside * inside);
#endif
}
