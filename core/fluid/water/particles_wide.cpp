#include "fluid/water/cells_wide.hpp"
#include "math/wide_fours.hpp"

namespace evil::EVIL_ISA {

using fluid::SwarmView;

namespace {

// Four corners of two numbers each: lower left, lower right, upper left, upper right.
constexpr float kLeft[kLanes] = {1, 1, 0, 0, 1, 1, 0, 0}, kRight[kLanes] = {0, 0, 1, 1, 0, 0, 1, 1};
constexpr float kLow[kLanes] = {1, 1, 1, 1, 0, 0, 0, 0}, kHigh[kLanes] = {0, 0, 0, 0, 1, 1, 1, 1};
constexpr float kValue[kLanes] = {1, 0, 1, 0, 1, 0, 1, 0}, kOne[kLanes] = {0, 1, 0, 1, 0, 1, 0, 1};
constexpr float kValueRight[kLanes] = {0, 0, 1, 0, 0, 0, 1, 0}, kValueHigh[kLanes] = {0, 0, 0, 0, 1, 0, 1, 0};

struct Spots { // of eight particles among the values of one kind
    std::int32_t at[kLanes];
    float s[kLanes], t[kLanes]; // how far to the right and up between four of them
};

EVIL_INLINE void find_spots(Floats x, Floats y, std::int32_t stride, Spots& spots) {
    const Ints i = floor_to_int(x), j = floor_to_int(y);
    store(spots.at, j * Ints(stride) + i);
    store(spots.s, x - to_float(i));
    store(spots.t, y - to_float(j));
}

// Weights of the four corners, twice each.
EVIL_INLINE Floats corner_weights(float s, float t) {
    const Floats right(s), high(t);
    const Floats across = load(kLeft) * (Floats(1.0f) - right) + load(kRight) * right;
    return across * (load(kLow) * (Floats(1.0f) - high) + load(kHigh) * high);
}

EVIL_INLINE void add(float* pairs, std::ptrdiff_t stride, std::ptrdiff_t at, Floats more) {
    float *low = pairs + 2 * at, *high = low + 2 * stride;
    store_fours(low, high, load_fours(low, high) + more);
}

EVIL_INLINE Floats velocities(float value, float dx, float dy, float s, float t) {
    const Floats base(value - dx * s - dy * t);
    return load(kOne) + ((load(kValue) * base) + (load(kValueRight) * Floats(dx) + load(kValueHigh) * Floats(dy)));
}

} // namespace

void splat_particles(const SwarmView& p, std::ptrdiff_t stride, float* across, float* up, float* middle) noexcept {
    Spots u, v, c;
    const auto wide = static_cast<std::int32_t>(stride);
    for (std::size_t first = 0; first < p.count; first += kLanes) {
        const Floats x = load(p.x + first), y = load(p.y + first);
        find_spots(x, y - 0.5f, wide, u);
        find_spots(x - 0.5f, y, wide, v);
        find_spots(x - 0.5f, y - 0.5f, wide, c);
        const std::size_t n = p.count - first < kLanes ? p.count - first : kLanes;
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t q = first + k;
            const Floats heft(p.mass[q]);
            const Floats wu = heft * corner_weights(u.s[k], u.t[k]), wv = heft * corner_weights(v.s[k], v.t[k]);
            add(across, stride, u.at[k], wu * velocities(p.u[q], p.affine[0][q], p.affine[1][q], u.s[k], u.t[k]));
            add(up, stride, v.at[k], wv * velocities(p.v[q], p.affine[2][q], p.affine[3][q], v.s[k], v.t[k]));
            const Floats mass = load(kValue) * heft + load(kOne);
            add(middle, stride, c.at[k], corner_weights(c.s[k], c.t[k]) * mass);
        }
    }
}

namespace {

struct Corners {
    float a[kLanes], b[kLanes], c[kLanes], d[kLanes];
};
EVIL_INLINE void fetch(const float* values, std::ptrdiff_t stride, const Spots& spots, Corners& corners) {
    for (int k = 0; k < kLanes; ++k) {
        const float *low = values + spots.at[k], *high = low + stride;
        corners.a[k] = low[0], corners.b[k] = low[1], corners.c[k] = high[0], corners.d[k] = high[1];
    }
}

struct Taste { // a value, and how it changes to the right and up
    Floats value, dx, dy;
};
EVIL_INLINE Taste taste(const Corners& f, const Spots& spots) {
    const Floats s = load(spots.s), t = load(spots.t), a = load(f.a), b = load(f.b), c = load(f.c), d = load(f.d);
    const Floats low = b - a, high = d - c, dx = low + t * (high - low);
    const Floats left = c - a, right = d - b, dy = left + s * (right - left);
    return {a + s * low + t * dy, dx, dy};
}

} // namespace

void carry_particles(const SwarmView& p, std::ptrdiff_t stride, const float* u, const float* v, const float* shift_u,
                     const float* shift_v, float cells) noexcept {
    constexpr float kMostShift = 0.3f; // cells
    const auto wide = static_cast<std::int32_t>(stride);
    Spots at_u, at_v;
    Corners corners;
    for (std::size_t k = 0; k < p.count; k += kLanes) {
        const Floats x = load(p.x + k), y = load(p.y + k);
        find_spots(x, y - 0.5f, wide, at_u);
        find_spots(x - 0.5f, y, wide, at_v);
        fetch(u, stride, at_u, corners);
        const Taste flow_u = taste(corners, at_u);
        fetch(v, stride, at_v, corners);
        const Taste flow_v = taste(corners, at_v);
        fetch(shift_u, stride, at_u, corners);
        const Floats aside = clamp(taste(corners, at_u).value, -kMostShift, kMostShift);
        fetch(shift_v, stride, at_v, corners);
        const Floats aloft = clamp(taste(corners, at_v).value, -kMostShift, kMostShift);
        // half way the velocity is what it is here and how it changes along the way
        const Floats half(0.5f * cells), most(1.0f), least(-1.0f);
        auto bent = [&](const Taste& flow) {
            return flow.value + clamp(half * flow.dx, least, most) * flow_u.value +
                   clamp(half * flow.dy, least, most) * flow_v.value;
        };
        store(p.u + k, flow_u.value);
        store(p.v + k, flow_v.value);
        store(p.affine[0] + k, flow_u.dx);
        store(p.affine[1] + k, flow_u.dy);
        store(p.affine[2] + k, flow_v.dx);
        store(p.affine[3] + k, flow_v.dy);
        store(p.x + k, x + (Floats(cells) * bent(flow_u) + aside));
        store(p.y + k, y + (Floats(cells) * bent(flow_v) + aloft));
    }
}

} // namespace evil::EVIL_ISA
