// The area within the unit square that lies right of the edge from a to b, signed by the way that it runs.
float area_right_of(vec2 a, vec2 b) {
    float y0 = clamp(a.y, 0.0, 1.0), y1 = clamp(b.y, 0.0, 1.0);
    if (y0 == y1) return 0.0;
    float slope = (b.x - a.x) / (b.y - a.y);
    float x0 = a.x + (y0 - a.y) * slope, x1 = a.x + (y1 - a.y) * slope;
    vec2 x = vec2(x0, x1), c = clamp(x, 0.0, 1.0);
    vec2 sums = 0.5 * c * c + max(x - 1.0, 0.0); // integral of x kept within the square
    float run = x1 - x0;
    float mean = abs(run) > 0.001 ? (sums.y - sums.x) / run : 0.5 * (c.x + c.y);
    return (y1 - y0) * (1.0 - clamp(mean, 0.0, 1.0));
}
