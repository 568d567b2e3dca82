// Eight pixels at a time. Two channels share a 32-bit lane, 16 bits each: products of bytes fit.
#include "raster/spans_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

using raster::Pixel;

constexpr std::int32_t kPair = 0x00ff00ff;

struct Channels { // eight pixels: red and blue, green and alpha
    Ints rb, ga;
};

EVIL_INLINE Channels split(Ints pixels) { return {pixels & kPair, shift_right_unsigned(pixels, 8) & kPair}; }

EVIL_INLINE Ints join(Channels c) { return c.rb | (c.ga << 8); }

// Both halves times 0..255, divided by 255, rounded.
EVIL_INLINE Ints multiply_255(Ints pair, Ints by) {
    Ints t = pair * by + 0x00800080;
    return shift_right_unsigned(t + (shift_right_unsigned(t, 8) & kPair), 8) & kPair;
}

EVIL_INLINE Channels multiply_255(Channels c, Ints by) { return {multiply_255(c.rb, by), multiply_255(c.ga, by)}; }

// Source over destination; both multiplied with their alpha.
EVIL_INLINE Ints over(Channels source, Ints destination) {
    Ints left = Ints(255) - shift_right_unsigned(source.ga, 16);
    Channels under = multiply_255(split(destination), left);
    return join({source.rb + under.rb, source.ga + under.ga}); // rounding is monotone, so sums stay below 256
}

// a + (b - a) * f / 256 for f in 0..255. Halves may borrow from each other on the way; the sum is right again.
EVIL_INLINE Ints mix(Ints a, Ints b, Ints f) {
    return shift_right_unsigned((a << 8) + (b - a) * f + 0x00800080, 8) & kPair;
}

EVIL_INLINE Ints bilinear(Ints a, Ints b, Ints c, Ints d, Ints fx, Ints fy) {
    Channels p = split(a), q = split(b), r = split(c), s = split(d);
    return join({mix(mix(p.rb, q.rb, fx), mix(r.rb, s.rb, fx), fy), mix(mix(p.ga, q.ga, fx), mix(r.ga, s.ga, fx), fy)});
}

EVIL_INLINE Ints lanes_from(std::uint32_t start, std::uint32_t step) {
    return Ints(static_cast<std::int32_t>(start)) + lane_numbers() * Ints(static_cast<std::int32_t>(step));
}

// A phase of which 2^32 is `size` texels, as texels in 16.16: the high half of a product of 32 bits and 16.
EVIL_INLINE Ints texels_of(Ints phase, Ints size) {
    return shift_right_unsigned(phase, 16) * size + shift_right_unsigned((phase & 0xffff) * size, 16);
}

struct Taps { // along one axis: two texels and where between them, 0..255
    Ints first, second, between;
};

EVIL_INLINE Taps taps(Ints position, Ints size, bool repeat) {
    if (repeat) {
        Ints at = texels_of(position, size);
        Ints first = shift_right_unsigned(at, 16), second = first + 1;
        return {first, select(second == size, Ints(0), second), shift_right_unsigned(at, 8) & 255};
    }
    Ints at = position >> 16, last = size - 1;
    return {min(max(at, Ints(0)), last), min(max(at + 1, Ints(0)), last), shift_right_unsigned(position, 8) & 255};
}

// Lane i becomes the sum of lanes 0..i.
EVIL_INLINE Ints running_sum(Ints a) {
#if EVIL_WIDTH == 8
    const native::U zero{};
    native::U v = (native::U)a.part[0];
    v += __builtin_shufflevector(zero, v, 0, 8, 9, 10, 11, 12, 13, 14);
    v += __builtin_shufflevector(zero, v, 0, 1, 8, 9, 10, 11, 12, 13);
    v += __builtin_shufflevector(zero, v, 0, 1, 2, 3, 8, 9, 10, 11);
    a.part[0] = (native::I)v;
#elif EVIL_WIDTH == 4
    const native::U zero{};
    native::U sums[2];
    for (int p = 0; p < 2; ++p) {
        native::U v = (native::U)a.part[p];
        v += __builtin_shufflevector(zero, v, 0, 4, 5, 6);
        v += __builtin_shufflevector(zero, v, 0, 1, 4, 5);
        sums[p] = v;
    }
    a.part[0] = (native::I)sums[0];
    a.part[1] = (native::I)(sums[1] + __builtin_shufflevector(sums[0], sums[0], 3, 3, 3, 3));
#else
    native::U sum = 0;
    for (native::I& p : a.part) p = (native::I)(sum += (native::U)p);
#endif
    return a;
}
EVIL_INLINE std::int32_t last_lane(Ints a) {
#if EVIL_WIDTH == 1
    return a.part[kLanes - 1];
#else
    return a.part[native::kParts - 1][EVIL_WIDTH - 1];
#endif
}

struct
    Held { // along one axis: the first of two texels side by side, and where between them, 0..256: at 256 it is the second
    Ints first, between;
};

EVIL_INLINE Held hold(Ints position, int size) { // what lies beyond the first and the last texel is like those
    Ints at = position >> 16, last(size - 1);
    Ints between = select(last > at, shift_right_unsigned(position, 8) & 255, Ints(256));
    return {min(max(at, Ints(0)), last - 1), select(Ints(0) > at, Ints(0), between)};
}

// texels[index] and texels[index + 1] in each lane: half as many loads as two gathers.
EVIL_INLINE void gather_pairs(const Pixel* texels, Ints index, Ints& first, Ints& second) {
    std::int32_t at[kLanes];
    store(at, index);
#if EVIL_WIDTH == 8
    const auto two = [&](int lane) {
        const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(texels + at[lane]));
        const __m128i high = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(texels + at[lane + 1]));
        return _mm_unpacklo_epi64(low, high);
    };
    const auto four = [&](int lane) { // of lanes lane, lane + 1, lane + 4, lane + 5
        return _mm256_castsi256_ps(_mm256_set_m128i(two(lane + 4), two(lane)));
    };
    const __m256 a = four(0), b = four(2);
    first.part[0] = __builtin_bit_cast(native::I, _mm256_shuffle_ps(a, b, 0x88));
    second.part[0] = __builtin_bit_cast(native::I, _mm256_shuffle_ps(a, b, 0xdd));
#else
    std::uint32_t low[kLanes], high[kLanes];
    for (int i = 0; i < kLanes; ++i) low[i] = texels[at[i]], high[i] = texels[at[i] + 1];
    first = load(low), second = load(high);
#endif
}

EVIL_INLINE Ints sample_held(const raster::Walk& walk, Ints u, Ints v) {
    Held x = hold(u, walk.width), y = hold(v, walk.height);
    Ints at = y.first * walk.width + x.first, a, b, c, d;
    gather_pairs(walk.texels, at, a, b);
    gather_pairs(walk.texels + walk.width, at, c, d);
    return bilinear(a, b, c, d, x.between, y.between);
}

EVIL_INLINE Ints sample_any(const raster::Walk& walk, Ints u, Ints v) {
    const Ints width(walk.width), height(walk.height);
    Taps x = taps(u, width, walk.repeat), y = taps(v, height, walk.repeat);
    Ints above = y.first * width, below = y.second * width;
    return bilinear(gather(walk.texels, above + x.first), gather(walk.texels, above + x.second),
                    gather(walk.texels, below + x.first), gather(walk.texels, below + x.second), x.between, y.between);
}

// A picture at its own size and not turned: neighbours lie side by side, and only at its ends need texels be looked up.
void sample_straight(Pixel* to, int count, const raster::Walk& walk, int y) {
    const int first = static_cast<std::int32_t>(walk.u) >> 16;
    const std::int32_t fx = (walk.u >> 8) & 255, fy = (walk.v >> 8) & 255;
    const Pixel* above = walk.texels + static_cast<std::int64_t>(y) * walk.width;
    const Pixel* below = y + 1 < walk.height ? above + walk.width : above;
    for (int i = 0; i < count; i += 8) {
        const int x = first + i;
        Ints pixels;
        if (x < 0 || x + 8 >= walk.width)
            pixels = sample_held(walk, lanes_from(walk.u + (static_cast<std::uint32_t>(i) << 16), 65536u),
                                 Ints(static_cast<std::int32_t>(walk.v)));
        else if (fx == 0 && fy == 0)
            pixels = load(above + x);
        else
            pixels = bilinear(load(above + x), load(above + x + 1), load(below + x), load(below + x + 1), fx, fy);
        store(to + i, pixels);
    }
}

EVIL_INLINE Ints product(Ints pixels, int shift, Ints factor) { // of one channel, in its place
    Ints t = (shift_right_unsigned(pixels, shift) & 255) * factor + 128;
    return shift_right_unsigned(t + shift_right_unsigned(t, 8), 8) << shift;
}

// Ends of runs: `count` of eight lanes.
EVIL_INLINE void store_some(Pixel* to, int count, Ints pixels) {
    if (count >= 8)
        store(to, pixels);
    else
        store_first(to, count, pixels);
}
EVIL_INLINE Ints load_some(const Pixel* from, int count) { return count >= 8 ? load(from) : load_first(from, count); }

} // namespace

void fill_wide(Pixel* to, int count, Pixel colour) noexcept {
    Ints all(static_cast<std::int32_t>(colour));
    for (int i = 0; i < count; i += 8) store_some(to + i, count - i, all);
}

void blend_flat_wide(Pixel* to, int count, Pixel colour) noexcept {
    Channels source = split(Ints(static_cast<std::int32_t>(colour)));
    for (int i = 0; i < count; i += 8) store_some(to + i, count - i, over(source, load_some(to + i, count - i)));
}

void blend_flat_masked_wide(Pixel* to, const std::int32_t* mask, int count, Pixel colour) noexcept {
    Channels source = split(Ints(static_cast<std::int32_t>(colour)));
    for (int i = 0; i < count; i += 8) {
        Ints under = load_some(to + i, count - i);
        store_some(to + i, count - i, over(multiply_255(source, load(mask + i)), under));
    }
}

void blend_row_wide(Pixel* to, const Pixel* from, int count, int cover) noexcept {
    Ints factor(cover);
    for (int i = 0; i < count; i += 8) {
        Channels source = split(load_some(from + i, count - i));
        if (cover != 255) source = multiply_255(source, factor);
        store_some(to + i, count - i, over(source, load_some(to + i, count - i)));
    }
}

void blend_row_masked_wide(Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    for (int i = 0; i < count; i += 8) {
        Channels source = multiply_255(split(load_some(from + i, count - i)), load(mask + i));
        store_some(to + i, count - i, over(source, load_some(to + i, count - i)));
    }
}

// Sums may pass 255: they stop there. The alpha of what is under stays.
static EVIL_INLINE Ints added(Channels source, Ints destination) {
    const Channels under = split(destination);
    Ints sums[2] = {source.rb + under.rb, (source.ga & 0xff) + under.ga};
    for (Ints& sum : sums) {
        const Ints past = shift_right_unsigned(sum, 8) & 0x00010001;
        sum = (sum | ((past << 8) - past)) & kPair;
    }
    return join({sums[0], sums[1]});
}

static EVIL_INLINE Ints multiplied(Channels source, Ints under) {
    const Ints by = join(source), left = Ints(255) - shift_right_unsigned(by, 24);
    Ints result(0);
    for (int shift = 0; shift < 32; shift += 8)
        result = result | (product(under, shift, shift_right_unsigned(by, shift) & 255) + product(under, shift, left));
    return result;
}

static EVIL_INLINE Ints screened(Channels source, Ints under) {
    const Ints by = join(source);
    Ints result(0);
    for (int shift = 0; shift < 32; shift += 8) {
        const Ints channel = shift_right_unsigned(by, shift) & 255;
        result = result | ((channel << shift) + product(under, shift, Ints(255) - channel));
    }
    return result;
}

template <class Meet>
static EVIL_INLINE void meet_row(Pixel* to, const Pixel* from, const std::int32_t* mask, int count, Meet meet) {
    for (int i = 0; i < count; i += 8) {
        const Channels source = multiply_255(split(load_some(from + i, count - i)), load(mask + i));
        store_some(to + i, count - i, meet(source, load_some(to + i, count - i)));
    }
}

void add_row_wide(Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    meet_row(to, from, mask, count, [](Channels source, Ints under) { return added(source, under); });
}

void multiply_row_wide(Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    meet_row(to, from, mask, count, [](Channels source, Ints under) { return multiplied(source, under); });
}

void screen_row_wide(Pixel* to, const Pixel* from, const std::int32_t* mask, int count) noexcept {
    meet_row(to, from, mask, count, [](Channels source, Ints under) { return screened(source, under); });
}

std::int32_t integrate_wide(std::int32_t* cells, int count, std::int32_t sum, std::int32_t* mask) noexcept {
    constexpr std::int32_t kFull = 1 << 17; // raster::kFullCell
    for (int i = 0; i < count; i += 8) {
        Ints sums = running_sum(load(cells + i)) + sum;
        sum = last_lane(sums);
        Ints cover = min(max(sums, Ints(0) - sums), Ints(kFull)); // either winding covers, and more than once is once
        store(mask + i, shift_right_unsigned((cover << 8) - cover + kFull / 2, 17));
        store(cells + i, Ints(0));
    }
    return sum;
}

void ramp_wide(Pixel* to, int count, const raster::Ramp& colours) noexcept {
    Ints channel[4], step[4];
    for (int c = 0; c < 4; ++c) {
        channel[c] =
            lanes_from(static_cast<std::uint32_t>(colours.start[c]), static_cast<std::uint32_t>(colours.step[c]));
        step[c] = Ints(colours.step[c]) << 3;
    }
    for (int i = 0; i < count; i += 8) {
        Ints pixels(0);
        for (int c = 0; c < 4; ++c) {
            Ints value = min(max(channel[c], Ints(colours.least[c])), Ints(colours.most[c]));
            pixels = pixels | (((value + 32768) >> 16) << (8 * c));
            channel[c] = channel[c] + step[c];
        }
        store(to + i, pixels);
    }
}

void sample_wide(Pixel* to, int count, const raster::Walk& walk) noexcept {
    const int row = static_cast<std::int32_t>(walk.v) >> 16;
    const bool held = !walk.repeat && walk.width > 1 && walk.height > 1;
    if (held && walk.du == 65536u && walk.dv == 0u && row >= 0 && row < walk.height) {
        sample_straight(to, count, walk, row);
        return;
    }
    Ints u = lanes_from(walk.u, walk.du), v = lanes_from(walk.v, walk.dv);
    const Ints du(static_cast<std::int32_t>(walk.du << 3)), dv(static_cast<std::int32_t>(walk.dv << 3));
    for (int i = 0; i < count; i += 8, u = u + du, v = v + dv)
        store(to + i, held ? sample_held(walk, u, v) : sample_any(walk, u, v));
}

void modulate_wide(Pixel* row, const Pixel* by, int count) noexcept {
    for (int i = 0; i < count; i += 8) {
        Ints pixels = load(row + i), factors = load(by + i), result(0);
        for (int shift = 0; shift < 32; shift += 8)
            result = result | product(pixels, shift, shift_right_unsigned(factors, shift) & 255);
        store(row + i, result);
    }
}

void modulate_flat_wide(Pixel* row, int count, Pixel by) noexcept {
    const Ints red(static_cast<std::int32_t>(by & 255)), green(static_cast<std::int32_t>(by >> 8 & 255));
    const Ints blue(static_cast<std::int32_t>(by >> 16 & 255)), alpha(static_cast<std::int32_t>(by >> 24));
    for (int i = 0; i < count; i += 8) {
        Ints pixels = load(row + i);
        store(row + i, product(pixels, 0, red) | product(pixels, 8, green) | product(pixels, 16, blue) |
                           product(pixels, 24, alpha));
    }
}

// What a pixel gets of a speck, 0..255, at (u, v), where the rim is at a distance of 1. A disc's edge fades over a pixel:
// how far the rim is, to first order, is 1 - distance over the slope of the distance.
static EVIL_INLINE Ints cover_of_speck(Floats u, Floats v, const raster::SpeckPaint& paint) {
    const Floats squared = u * u + v * v;
    if (!paint.disc) {
        const Floats inside = max(Floats(1.0f) - squared, 0.0f);
        return round_to_int(inside * inside * 255.0f);
    }
    const Floats distance = sqrt(squared), across = u * paint.along, down = v * paint.across;
    const Floats slope = sqrt(across * across + down * down) / max(distance, 1e-6f);
    const Floats depth = (Floats(1.0f) - distance) / max(slope, 1e-6f);
    return round_to_int(clamp(depth + 0.5f, 0.0f, 1.0f) * 255.0f);
}

template <class Meet>
static EVIL_INLINE void draw_speck(const raster::Target& target, const raster::SpeckPaint& paint, Meet meet) {
    const Channels source = split(Ints(static_cast<std::int32_t>(paint.colour)));
    const Floats lanes = to_float(lane_numbers());
    const int count = paint.box.right - paint.box.left;
    for (int y = paint.rows.first; y < paint.rows.last; ++y) {
        const float down = static_cast<float>(y - paint.box.top);
        Pixel* row = row_of(target, y) + paint.box.left;
        for (int i = 0; i < count; i += 8) {
            const Floats across = lanes + static_cast<float>(i);
            const Ints cover = cover_of_speck(across * paint.u_x + (paint.u + down * paint.u_y),
                                              across * paint.v_x + (paint.v + down * paint.v_y), paint);
            const Ints under = load_some(row + i, count - i);
            const Channels share = multiply_255(source, cover);
            store_some(row + i, count - i, meet(share, under));
        }
    }
}

void speck_wide(const raster::Target& target, const raster::SpeckPaint& paint) noexcept {
    switch (paint.blend) {
    case draw::Blend::over:
        return draw_speck(target, paint, [](Channels source, Ints under) { return over(source, under); });
    case draw::Blend::add:
        return draw_speck(target, paint, [](Channels source, Ints under) { return added(source, under); });
    case draw::Blend::multiply:
        return draw_speck(target, paint, [](Channels source, Ints under) { return multiplied(source, under); });
    case draw::Blend::screen:
        return draw_speck(target, paint, [](Channels source, Ints under) { return screened(source, under); });
    }
}

void light_up_wide(Pixel* row, const std::uint32_t* factors, int count, const std::int32_t* dither) noexcept {
    const Ints rounding = load(dither);
    for (int i = 0; i < count; i += 8) {
        Ints pixels = load(row + i), by = load(factors + i), alpha = shift_right_unsigned(pixels, 24);
        Ints result = alpha << 24;
        for (int channel = 0; channel < 3; ++channel) {
            Ints factor = shift_right_unsigned(by, 10 * channel) & 1023;
            Ints value = ((shift_right_unsigned(pixels, 8 * channel) & 255) * factor + rounding) >> 9;
            result = result | (min(value, alpha) << (8 * channel));
        }
        store(row + i, result);
    }
}

} // namespace evil::EVIL_ISA
