#include "fluid/solids_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

void draw_outline(const fluid::Outline& o, int j, int left, int right, float owner, float* distance,
                  float* owners) noexcept {
    const Floats y(static_cast<float>(j));
    for (int i = left; i < right; i += kLanes) {
        const Floats x = to_float(lane_numbers() + Ints(i));
        Floats nearest(1e30f), inside(1.0f);
        for (int e = 0; e < o.edges; ++e) {
            const Floats px = x - Floats(o.x[e]), py = y - Floats(o.y[e]), dx(o.dx[e]), dy(o.dy[e]);
            const Floats t = clamp((px * dx + py * dy) * Floats(o.per_length[e]), 0.0f, 1.0f);
            const Floats ex = px - t * dx, ey = py - t * dy;
            nearest = min(nearest, ex * ex + ey * ey);
            inside = min(inside, dx * py - dy * px);
        }
        Floats far = sqrt(nearest);
        if (o.edges > 2) far = select(inside > 0.0f, -far, far);
        far = far - Floats(o.radius);
        const int count = right - i < kLanes ? right - i : kLanes;
        const Floats before = load_first(distance + i, count);
        const Mask nearer = far < before;
        store_first(distance + i, count, select(nearer, far, before));
        store_first(owners + i, count, select(nearer, Floats(owner), load_first(owners + i, count)));
    }
}

namespace {

// The share of an edge between two distances that is outside; slivers are closed, and what is nearly open is open.
EVIL_INLINE Floats open_share(Floats a, Floats b) {
    constexpr float kSliver = 0.05f; // a narrower gap lets jets through: its cell can lose no more than it lets in
    const Floats low = min(a, b), high = max(a, b);
    Floats share = select(low > 0.0f, Floats(1.0f), select(high > 0.0f, high / max(high - low, 1e-6f), Floats(0.0f)));
    share = select(share < kSliver, Floats(0.0f), share);
    return select(share > 1.0f - kSliver, Floats(1.0f), share);
}

} // namespace

void open_faces(const float* nodes, const float* above, int left, int right, float* across, float* up) noexcept {
    for (int i = left; i < right; i += kLanes) {
        const int count = right - i < kLanes ? right - i : kLanes;
        const Floats here = load_first(nodes + i, count);
        store_first(across + i, count, open_share(here, load_first(above + i, count)));
        store_first(up + i, count, open_share(here, load_first(nodes + i + 1, count)));
    }
}

} // namespace evil::EVIL_ISA
