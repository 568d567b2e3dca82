#include "collider/placed_wide.hpp"
#include "math/wide_rows.hpp"

namespace evil::EVIL_ISA {
namespace {

constexpr float kFar = 1e9f;            // metres; a hundred times as far as the world's edge
constexpr std::int32_t kKindBits = 255; // of a body's first four bytes; 0: static

struct WideBody { // fields in the order that core/bodies.hpp has them
    Floats flags, spin, x, y, c, s, centre_x, centre_y, vx, vy, local_x, local_y;
};

EVIL_INLINE WideBody load_body(const PlacingRows& t, const std::uint32_t* piece) {
    std::uint32_t row[kLanes];
    for (int i = 0; i < kLanes; ++i) row[i] = t.owners[piece[i]] * t.body_rows;
    Floats a[8], b[8];
    load_rows(t.bodies, row, a);
    load_rows(t.bodies + 8, row, b);
    return {a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], b[0], b[1], b[2], b[3]};
}

EVIL_INLINE Ints octave(Floats extent) { // floor(log2), by the exponent's bits
    return (float_to_bits(extent) >> 23) - 127;
}

EVIL_INLINE void place_eight(const PlacingRows& t, std::size_t first) {
    std::uint32_t piece[kLanes];
    for (std::uint32_t i = 0; i < kLanes; ++i) {
        auto p = static_cast<std::uint32_t>(first) + i;
        piece[i] = p < t.pieces ? p : t.pieces - 1;
    }
    WideBody b = load_body(t, piece);
    Floats f[8];
    load_rows(t.forms, piece, f);
    Floats local_x = f[0], local_y = f[1], fc = f[2], fs = f[3], hx = f[4], hy = f[5], radius = f[6], reach = f[7];

    Floats arm_x = b.c * local_x - b.s * local_y, arm_y = b.s * local_x + b.c * local_y;
    Floats c = b.c * fc - b.s * fs, s = b.s * fc + b.c * fs, zero = 0.0f;
    Mask moves = (float_to_bits(b.flags) & kKindBits) > Ints(0);
    Floats path_x = select(moves, Floats(t.dt) * b.vx, zero), path_y = select(moves, Floats(t.dt) * b.vy, zero);
    Floats turn = select(moves, Floats(t.dt) * abs(b.spin), zero);

    // Each side grows by half the margin and by the piece's own reach within the step, so that two grown bounds meet
    // before the pieces can.
    Floats off_x = local_x - b.local_x, off_y = local_y - b.local_y;
    Floats grow = Floats(0.5f * t.margin) + min(turn, Floats(2.0f)) * (sqrt(off_x * off_x + off_y * off_y) + reach);
    Floats ex = min(abs(c) * hx + abs(s) * hy + radius, reach), ey = min(abs(s) * hx + abs(c) * hy + radius, reach);
    // Whatever came in, bounds are finite: cells are counted by them.
    Floats far = kFar, x = clamp(b.x + arm_x, -far, far), y = clamp(b.y + arm_y, -far, far);
    path_x = clamp(path_x, -far, far);
    path_y = clamp(path_y, -far, far);
    grow = min(grow, far);
    Floats low_x = x - ex + min(path_x, zero) - grow, high_x = x + ex + max(path_x, zero) + grow;
    Floats low_y = y - ey + min(path_y, zero) - grow, high_y = y + ey + max(path_y, zero) + grow;
    store(t.low_x + first, low_x);
    store(t.low_y + first, low_y);
    store(t.high_x + first, high_x);
    store(t.high_y + first, high_y);
    store(t.octaves + first, octave(max(high_x - low_x, high_y - low_y)));

    Floats where[8] = {b.x, b.y, arm_x, arm_y, c, s, hx, hy};
    Floats whither[8] = {path_x, path_y, turn * reach, reach, radius, grow, b.centre_x - b.x, b.centre_y - b.y};
    store_rows(t.placed + 16 * first, 2, where);
    store_rows(t.placed + 16 * first + 8, 2, whither);
}

} // namespace

void place_pieces(const PlacingRows& rows, std::size_t first, std::size_t last) noexcept {
    for (std::size_t i = first; i < last; i += kLanes) place_eight(rows, i);
}

} // namespace evil::EVIL_ISA
