#include "raster/pyramid_wide.hpp"
#include "math/wide.hpp"
#include <cstring>

namespace evil::EVIL_ISA {
namespace {

using raster::Pixel;

constexpr std::int32_t kPair = 0x00ff00ff; // two channels share a lane, 16 bits each

EVIL_INLINE Ints low_pair(Ints pixels) { return pixels & kPair; }
EVIL_INLINE Ints high_pair(Ints pixels) { return shift_right_unsigned(pixels, 8) & kPair; }

// What a half of a level becomes: rounded up after one step and down after the next, so that many steps make no light.
constexpr std::int32_t kUp = 0x00020002, kDown = 0x00010001;

// (3 a + b) / 4 in each channel.
EVIL_INLINE Ints three_to_one(Ints a, Ints b, Ints rounding) {
    Ints rb = shift_right_unsigned(low_pair(a) * 3 + low_pair(b) + rounding, 2) & kPair;
    Ints ga = shift_right_unsigned(high_pair(a) * 3 + high_pair(b) + rounding, 2) & kPair;
    return rb | (ga << 8);
}

// a + (b - a) * share / 256. Halves may borrow from each other on the way; the sum is right again.
EVIL_INLINE Ints mixed(Ints a, Ints b, Ints share) {
    Ints rb = low_pair(a), ga = high_pair(a);
    rb = shift_right_unsigned((rb << 8) + (low_pair(b) - rb) * share + 0x00800080, 8) & kPair;
    ga = shift_right_unsigned((ga << 8) + (high_pair(b) - ga) * share + 0x00800080, 8) & kPair;
    return rb | (ga << 8);
}

EVIL_INLINE Ints saturated(Ints pair) { // sums of two, in halves of 16 bits
    const Ints past = shift_right_unsigned(pair, 8) & 0x00010001;
    return (pair | ((past << 8) - past)) & kPair;
}

EVIL_INLINE void load_twice(const Pixel* from, Ints& even, Ints& odd) {
    Floats x, y;
    float bits[16]; // pixels, not numbers: they are only sorted
    std::memcpy(bits, from, sizeof bits);
    load_pairs(bits, x, y);
    even = float_to_bits(x), odd = float_to_bits(y);
}

EVIL_INLINE Floats channel(Ints pixels, int shift) { return to_float(shift_right_unsigned(pixels, shift) & 255); }

EVIL_INLINE Floats tone(const float* table, Floats light, int which) {
    const Ints at = min(round_to_int(light), Ints(1023));
    return gather(table + which, at << 2);
}

EVIL_INLINE Ints byte(Floats value) { return round_to_int(clamp(value, 0.0f, 255.0f)); }

// Noise from -1 to 1 for a pixel: a hash of its place (multiply, fold, multiply).
EVIL_INLINE Floats noise(Ints x, std::int32_t y, std::uint32_t seed) {
    Ints h = x * Ints(static_cast<std::int32_t>(0x9e3779b1u)) + Ints(static_cast<std::int32_t>(seed)) +
             Ints(y) * Ints(static_cast<std::int32_t>(0x85ebca77u));
    h = (h ^ shift_right_unsigned(h, 15)) * Ints(static_cast<std::int32_t>(0x2c1b3c6du));
    h = (h ^ shift_right_unsigned(h, 12)) * Ints(static_cast<std::int32_t>(0x297a2d39u));
    return to_float(shift_right_unsigned(h, 16) & 0xffff) * (1.0f / 32768.0f) - 1.0f;
}

} // namespace

void halve_row_wide(Pixel* to, const Pixel* a, const Pixel* b, int count) noexcept {
    const Ints rounding = (lane_numbers() & 1) * kDown + kDown; // by turns
    for (int i = 0; i < count; i += 8) {
        Ints p, q, r, s;
        load_twice(a + 2 * i, p, q);
        load_twice(b + 2 * i, r, s);
        Ints rb = low_pair(p) + low_pair(q) + low_pair(r) + low_pair(s) + rounding;
        Ints ga = high_pair(p) + high_pair(q) + high_pair(r) + high_pair(s) + rounding;
        store(to + i, (shift_right_unsigned(rb, 2) & kPair) | ((shift_right_unsigned(ga, 2) & kPair) << 8));
    }
}

void mix_rows_wide(Pixel* to, const Pixel* near, const Pixel* far, int count) noexcept {
    for (int i = 0; i < count; i += 8) store(to + i, three_to_one(load(near + i), load(far + i), kUp));
}

//   from:      -1        0        1          pixel 2i lies a quarter before from[i], pixel 2i + 1 a quarter behind it
//   to:           0   1    2   3
static EVIL_INLINE void doubled(const Pixel* half, Ints out[2]) {
    const Ints middle = load(half);
    float bits[16];
    store_pairs(bits, bits_to_float(three_to_one(middle, load(half - 1), kDown)),
                bits_to_float(three_to_one(middle, load(half + 1), kDown)));
    out[0] = float_to_bits(load(bits)), out[1] = float_to_bits(load(bits + 8));
}

void double_row_wide(Pixel* to, const Pixel* from, int count, int share) noexcept {
    const Ints part(share);
    for (int i = 0; i < count; i += 16) {
        Ints fresh[2];
        doubled(from + i / 2, fresh);
        for (int k = 0; k < 2; ++k)
            store(to + i + 8 * k, share == 256 ? fresh[k] : mixed(load(to + i + 8 * k), fresh[k], part));
    }
}

void add_double_row_wide(Pixel* to, const Pixel* from, int count) noexcept {
    for (int i = 0; i < count; i += 16) {
        Ints fresh[2];
        doubled(from + i / 2, fresh);
        for (int k = 0; k < 2; ++k) {
            const Ints there = load(to + i + 8 * k);
            store(to + i + 8 * k, saturated(low_pair(there) + low_pair(fresh[k])) |
                                      (saturated(high_pair(there) + high_pair(fresh[k])) << 8));
        }
    }
}

void keep_bright_wide(Pixel* row, int count, float threshold) noexcept {
    const float least = threshold * 255.0f, per_level = 1.0f / (256.0f - least);
    for (int i = 0; i < count; i += 8) {
        Ints pixels = load(row + i);
        Floats r = channel(pixels, 0), g = channel(pixels, 8), b = channel(pixels, 16);
        Floats share = clamp((max(max(r, g), b) - least) * per_level, 0.0f, 1.0f);
        store(row + i, byte(r * share) | (byte(g * share) << 8) | (byte(b * share) << 16));
    }
}

void finish_row_wide(Pixel* row, int count, const raster::Finish& how) noexcept {
    const Floats lanes = to_float(lane_numbers());
    const float y = (static_cast<float>(how.y) + 0.5f) * how.down - 1.0f;
    for (int i = 0; i < count; i += 8) {
        const Ints pixels = count - i >= 8 ? load(row + i) : load_first(row + i, count - i);
        Floats r = channel(pixels, 0), g = channel(pixels, 8), b = channel(pixels, 16);
        if (how.glow) {
            const Ints glow = load(how.glow + i);
            r += channel(glow, 0) * how.bloom, g += channel(glow, 8) * how.bloom, b += channel(glow, 16) * how.bloom;
        }
        r = tone(how.table, r, 0), g = tone(how.table, g, 1), b = tone(how.table, b, 2);
        const Floats grey = r * 0.2126f + g * 0.7152f + b * 0.0722f;
        const Floats x = (lanes + (static_cast<float>(i) + 0.5f)) * how.across - 1.0f;
        const Floats off = (x * x + y * y) * 0.5f;
        const Floats left = max(Floats(1.0f) - off * off * how.vignette, 0.0f);
        Floats spot = 0.0f;
        if (how.grain > 0.0f) spot = noise(lane_numbers() + i, how.y, how.seed) * (how.grain * 255.0f);
        r = (grey + (r - grey) * how.saturation) * left + spot;
        g = (grey + (g - grey) * how.saturation) * left + spot;
        b = (grey + (b - grey) * how.saturation) * left + spot;
        const Ints done = byte(r) | (byte(g) << 8) | (byte(b) << 16) | (pixels & static_cast<std::int32_t>(0xff000000));
        if (count - i >= 8)
            store(row + i, done);
        else
            store_first(row + i, count - i, done);
    }
}

} // namespace evil::EVIL_ISA
