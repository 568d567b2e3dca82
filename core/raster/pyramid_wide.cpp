#include "raster/pyramid_wide.hpp"
#include "math/wide.hpp"
#include <cstring>

namespace evil::EVIL_ISA {
namespace {

using raster::Deep, raster::kParts, raster::Pixel;

constexpr std::int32_t kPair = 0x00ff00ff;                  // two channels share a lane, 16 bits each
constexpr std::int32_t kLow = 0xffff, kFull = 255 * kParts; // of a channel
constexpr std::int32_t kTwo = 0x00020002;                   // half of four, in both

EVIL_INLINE Ints low_pair(Ints pixels) { return pixels & kPair; }
EVIL_INLINE Ints high_pair(Ints pixels) { return shift_right_unsigned(pixels, 8) & kPair; }

EVIL_INLINE Ints quarter(Ints pair) { return shift_right_unsigned(pair + kTwo, 2) & 0x3fff3fff; }
EVIL_INLINE Ints three_to_one(Ints a, Ints b) { return quarter(a * 3 + b); }

// Something done to each half of a lane.
template <class Do> EVIL_INLINE Ints each_half(Ints a, Ints b, Do what) {
    return what(a & kLow, b & kLow) | (what(shift_right_unsigned(a, 16), shift_right_unsigned(b, 16)) << 16);
}

// a + (b - a) * share / 256
EVIL_INLINE Ints mixed(Ints a, Ints b, Ints share) {
    return each_half(a, b, [&](Ints x, Ints y) {
        return shift_right_unsigned((x << 8) + (y - x) * share + 128, 8); // not negative: between x and y
    });
}

EVIL_INLINE Ints summed(Ints a, Ints b) {
    return each_half(a, b, [](Ints x, Ints y) { return min(x + y, Ints(kFull)); });
}

EVIL_INLINE Ints whole(Ints pair) { return shift_right_unsigned(pair + 0x00200020, 6) & kPair; } // levels of kParts

EVIL_INLINE void load_twice(const Pixel* from, Ints& even, Ints& odd) {
    Floats x, y;
    float bits[16]; // pixels, not numbers: they are only sorted
    std::memcpy(bits, from, sizeof bits);
    load_pairs(bits, x, y);
    even = float_to_bits(x), odd = float_to_bits(y);
}

EVIL_INLINE Floats channel(Ints pixels, int shift) { return to_float(shift_right_unsigned(pixels, shift) & 255); }

EVIL_INLINE Floats tone(const float* table, Ints entry, int which) {
    return gather(table + which, min(entry, Ints(1023)) << 2);
}

// Between two entries: where the table is steep, a small part of a level is seen.
EVIL_INLINE Floats tone(const float* table, Floats light, int which) {
    const Ints below = to_int(light);
    const Floats first = tone(table, below, which);
    return first + (tone(table, below + 1, which) - first) * (light - to_float(below));
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

void halve_picture_wide(Deep to, const Pixel* a, const Pixel* b, int count) noexcept {
    for (int i = 0; i < count; i += 8) {
        Ints p, q, r, s;
        load_twice(a + 2 * i, p, q);
        load_twice(b + 2 * i, r, s);
        store(to.rb + i, (low_pair(p) + low_pair(q) + low_pair(r) + low_pair(s)) * (kParts / 4));
        store(to.ga + i, (high_pair(p) + high_pair(q) + high_pair(r) + high_pair(s)) * (kParts / 4));
    }
}

static EVIL_INLINE void halve(std::uint32_t* to, const std::uint32_t* a, const std::uint32_t* b, int count) {
    for (int i = 0; i < count; i += 8) {
        Ints p, q, r, s;
        load_twice(a + 2 * i, p, q);
        load_twice(b + 2 * i, r, s);
        store(to + i, quarter(p + q + r + s));
    }
}

void halve_row_wide(Deep to, Deep a, Deep b, int count) noexcept {
    halve(to.rb, a.rb, b.rb, count);
    halve(to.ga, a.ga, b.ga, count);
}

void mix_rows_wide(Deep to, Deep near, Deep far, int count) noexcept {
    for (int i = 0; i < count; i += 8) {
        store(to.rb + i, three_to_one(load(near.rb + i), load(far.rb + i)));
        store(to.ga + i, three_to_one(load(near.ga + i), load(far.ga + i)));
    }
}

//   from:      -1        0        1          pixel 2i lies a quarter before from[i], pixel 2i + 1 a quarter behind it
//   to:           0   1    2   3
static EVIL_INLINE void doubled(const std::uint32_t* half, Ints out[2]) {
    const Ints middle = load(half);
    float bits[16];
    store_pairs(bits, bits_to_float(three_to_one(middle, load(half - 1))),
                bits_to_float(three_to_one(middle, load(half + 1))));
    out[0] = float_to_bits(load(bits)), out[1] = float_to_bits(load(bits + 8));
}

// Each sixteen of half a row, doubled, meet what is there: `meet(there, fresh)`.
template <class Meet>
static EVIL_INLINE void double_half(std::uint32_t* to, const std::uint32_t* from, int count, Meet meet) {
    for (int i = 0; i < count; i += 16) {
        Ints fresh[2];
        doubled(from + i / 2, fresh);
        for (int k = 0; k < 2; ++k) store(to + i + 8 * k, meet(load(to + i + 8 * k), fresh[k]));
    }
}

void double_row_wide(Deep to, Deep from, int count, int share) noexcept {
    const auto meet = [&](Ints there, Ints fresh) { return share == 256 ? fresh : mixed(there, fresh, Ints(share)); };
    double_half(to.rb, from.rb, count, meet);
    double_half(to.ga, from.ga, count, meet);
}

void double_picture_wide(Pixel* to, Deep from, int count, int share) noexcept {
    const auto meet = [&](Ints there, Ints fresh) {
        return share == 256 ? whole(fresh) : whole(mixed(there * kParts, fresh, Ints(share)));
    };
    for (int i = 0; i < count; i += 16) {
        Ints rb[2], ga[2];
        doubled(from.rb + i / 2, rb);
        doubled(from.ga + i / 2, ga);
        for (int k = 0; k < 2; ++k) {
            const Ints there = load(to + i + 8 * k);
            store(to + i + 8 * k, meet(low_pair(there), rb[k]) | (meet(high_pair(there), ga[k]) << 8));
        }
    }
}

void add_double_row_wide(Deep to, Deep from, int count) noexcept {
    const auto meet = [](Ints there, Ints fresh) { return summed(there, fresh); };
    double_half(to.rb, from.rb, count, meet);
    double_half(to.ga, from.ga, count, meet);
}

void keep_bright_wide(Deep row, int count, float threshold) noexcept {
    const float least = threshold * kFull, per_part = 1.0f / (256.0f * kParts - least);
    for (int i = 0; i < count; i += 8) {
        const Ints rb = load(row.rb + i), ga = load(row.ga + i);
        const Floats r = to_float(rb & kLow), g = to_float(ga & kLow), b = to_float(shift_right_unsigned(rb, 16));
        const Floats share = clamp((max(max(r, g), b) - least) * per_part, 0.0f, 1.0f);
        store(row.rb + i, round_to_int(r * share) | (round_to_int(b * share) << 16));
        store(row.ga + i, round_to_int(g * share));
    }
}

void finish_row_wide(Pixel* row, int count, const raster::Finish& how) noexcept {
    const Floats lanes = to_float(lane_numbers());
    const float y = (static_cast<float>(how.y) + 0.5f) * how.down - 1.0f;
    for (int i = 0; i < count; i += 8) {
        const Ints pixels = count - i >= 8 ? load(row + i) : load_first(row + i, count - i);
        Floats r = channel(pixels, 0), g = channel(pixels, 8), b = channel(pixels, 16);
        if (how.glow.rb) {
            const Ints rb = load(how.glow.rb + i), ga = load(how.glow.ga + i);
            const float strength = how.bloom / kParts;
            r = tone(how.table, r + to_float(rb & kLow) * strength, 0);
            g = tone(how.table, g + to_float(ga & kLow) * strength, 1);
            b = tone(how.table, b + to_float(shift_right_unsigned(rb, 16)) * strength, 2);
        } else {
            r = tone(how.table, pixels & 255, 0);
            g = tone(how.table, shift_right_unsigned(pixels, 8) & 255, 1);
            b = tone(how.table, shift_right_unsigned(pixels, 16) & 255, 2);
        }
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
