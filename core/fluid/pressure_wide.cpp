#include "fluid/pressure_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

using fluid::LevelView;

namespace {

struct Row { // one colour of a row, and what lies round it
    float* p;
    const float *left, *right, *below, *above, *b, *weight[4], *diagonal, *inverse;
    const std::uint8_t* plain;
};

EVIL_INLINE Row row_of(const LevelView& level, int colour, int j) {
    const std::ptrdiff_t at = j * level.stride;
    const float* other = level.p[colour ^ 1] + at;
    const int s = (colour + j) & 1;
    Row r;
    r.p = level.p[colour] + at;
    r.left = other + s - 1;
    r.right = other + s;
    r.below = other - level.stride;
    r.above = other + level.stride;
    r.b = level.b[colour] + at;
    for (int d = 0; d < 4; ++d) r.weight[d] = level.weight[colour][d] + at;
    r.diagonal = level.diagonal[colour] + at;
    r.inverse = level.inverse[colour] + at;
    r.plain = level.plain[colour] + static_cast<std::ptrdiff_t>(j) * level.tiles;
    return r;
}

EVIL_INLINE Floats drawn(const Row& r, int k) { // what the neighbours pull to
    return load(r.weight[0] + k) * load(r.left + k) + load(r.weight[1] + k) * load(r.right + k) +
           (load(r.weight[2] + k) * load(r.below + k) + load(r.weight[3] + k) * load(r.above + k));
}

EVIL_INLINE void relax_row(const LevelView& level, int colour, int j) {
    const Row r = row_of(level, colour, j);
    for (int t = 0; t < level.tiles; ++t) {
        const int k = t * kLanes;
        if (r.plain[t]) {
            const Floats sum = load(r.left + k) + load(r.right + k) + (load(r.below + k) + load(r.above + k));
            store(r.p + k, Floats(0.25f) * (sum + load(r.b + k)));
        } else {
            store(r.p + k, load(r.inverse + k) * (drawn(r, k) + load(r.b + k)));
        }
    }
}

EVIL_INLINE Floats residual(const Row& r, int t) {
    const int k = t * kLanes;
    if (r.plain[t]) {
        const Floats sum = load(r.left + k) + load(r.right + k) + (load(r.below + k) + load(r.above + k));
        return load(r.b + k) + sum - Floats(4.0f) * load(r.p + k);
    }
    return load(r.b + k) + drawn(r, k) - load(r.diagonal + k) * load(r.p + k);
}

} // namespace

void smooth(const LevelView& level, int passes, const fluid::Band& band) noexcept {
    const int end = band.high + (passes - 1) * (band.high_step + 1);
    for (int front = band.low; front < end; ++front)
        for (int pass = 0; pass < passes; ++pass) {
            const int j = front - pass;
            if (j >= band.low + pass * band.low_step && j < band.high + pass * band.high_step)
                relax_row(level, pass & 1, j);
        }
}

void split_row(const float* row, int half, float* even, float* odd) noexcept {
    for (int k = 0; k < half; k += kLanes) {
        Floats a, b;
        load_pairs(row + 2 * k, a, b);
        store(even + k, a);
        store(odd + k, b);
    }
}

void join_row(const float* even, const float* odd, int half, float* row) noexcept {
    for (int k = 0; k < half; k += kLanes) store_pairs(row + 2 * k, load(even + k), load(odd + k));
}

// Red cells of rows 2J and 2J + 1 are the lower left and the upper right one of each coarse cell.
void restrict_rows(const LevelView& fine, const LevelView& coarse, int first, int last, float* room) noexcept {
    const int end = 2 * coarse.tiles; // of fine tiles that coarse ones cover; those beyond the fine level hold nothing
    for (int J = first; J < last; ++J) {
        const Row low = row_of(fine, 0, 2 * J), high = row_of(fine, 0, 2 * J + 1);
        for (int t = 0; t < end; ++t)
            store(room + t * kLanes, t < fine.tiles ? residual(low, t) + residual(high, t) : Floats(0.0f));
        const std::ptrdiff_t at = J * coarse.stride;
        const int even = J & 1;
        split_row(room, coarse.half, coarse.b[even] + at, coarse.b[even ^ 1] + at);
        for (int t = 0; t < coarse.tiles; ++t) {
            store(coarse.p[0] + at + t * kLanes, Floats(0.0f));
            store(coarse.p[1] + at + t * kLanes, Floats(0.0f));
        }
    }
}

void prolong_rows(const LevelView& fine, const LevelView& coarse, const float* mirror, int first, int last,
                  float* room) noexcept {
    const std::ptrdiff_t length = 2 * coarse.tiles * kLanes + 2 * kLanes;
    auto fill = [&](int J, float* to, float sign) { // a coarse row from cell -1 on, cells in order
        const std::ptrdiff_t at = J * coarse.stride;
        const int even = J & 1;
        join_row(coarse.p[even] + at, coarse.p[even ^ 1] + at, coarse.half, to + kLanes);
        for (int i = 0; i < 2 * coarse.half && sign != 1.0f; ++i) to[kLanes + i] *= sign;
        to[kLanes - 1] = mirror[0] * to[kLanes];
        to[kLanes + 2 * coarse.half] = mirror[1] * to[kLanes + 2 * coarse.half - 1];
    };
    auto row = [&](int J, float* to) {
        if (J < 0)
            fill(0, to, mirror[2]);
        else if (J >= coarse.rows)
            fill(coarse.rows - 1, to, mirror[3]);
        else
            fill(J, to, 1.0f);
    };
    float *below = room, *here = room + length, *above = room + 2 * length;
    row(first - 1, below);
    row(first, here);
    for (int J = first; J < last; ++J) {
        row(J + 1, above);
        for (int upper = 0; upper < 2; ++upper) { // black cells: lower right, upper left
            const Row r = row_of(fine, 1, 2 * J + upper);
            const float *next = upper ? above : below, *side = upper ? here - 1 : here + 1,
                        *corner = upper ? above - 1 : below + 1;
            for (int t = 0; t < fine.tiles; ++t) {
                const int k = t * kLanes, at = k + kLanes;
                const Floats d = Floats(0.5625f) * load(here + at) +
                                 Floats(0.1875f) * (load(side + at) + load(next + at)) +
                                 Floats(0.0625f) * load(corner + at);
                const Floats more = r.plain[t] ? d : select(load(r.inverse + k) > 0.0f, d, Floats(0.0f));
                store(r.p + k, load(r.p + k) + more);
            }
        }
        float* spare = below;
        below = here, here = above, above = spare;
    }
}

} // namespace evil::EVIL_ISA
