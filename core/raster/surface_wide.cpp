// Eight pixels at a time. In floats: products, sums and square roots are the same on every set.
#include "raster/surface_wide.hpp"
#include "light/light_map.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

EVIL_INLINE Floats channel(Ints pixels, int shift) { return to_float(shift_right_unsigned(pixels, shift) & 255); }

EVIL_INLINE Floats part_of_normal(Ints pixels, int shift) {
    return (channel(pixels, shift) - 128.0f) * (1.0f / 127.0f);
}

// The lanes of a table that eight indices of 0..7 name.
EVIL_INLINE Ints pick(Ints table, Ints index) {
#if EVIL_WIDTH == 8
    Ints r;
    r.part[0] = __builtin_bit_cast(native::I, _mm256_permutevar8x32_epi32(__builtin_bit_cast(__m256i, table.part[0]),
                                                                          __builtin_bit_cast(__m256i, index.part[0])));
    return r;
#else
    std::int32_t lanes[kLanes], at[kLanes];
    store(lanes, table), store(at, index);
    for (std::int32_t& lane : at) lane = lanes[lane];
    return load(at);
#endif
}

} // namespace

// As colour is light to the power of 1 / 2.2, a share of the light is about its square root of the factor.
void bend_wide(std::uint32_t* to, const std::uint32_t* factors, const raster::Ways& ways, const raster::Pixel* normals,
               int count, const raster::Turn& turn) noexcept {
    constexpr float kSlant = light::kSlant / 256.0f;
    for (int i = 0; i < count; i += 8) {
        Ints normal = load(normals + i), factor = load(factors + i), across = load(ways.across + i);
        Ints down = load(ways.down + i), result(0);
        Floats u = part_of_normal(normal, 0), v = part_of_normal(normal, 8), z = part_of_normal(normal, 16);
        Floats x = (u * turn.xx + v * turn.yx) * kSlant, y = (u * turn.xy + v * turn.yy) * kSlant;
        for (int shift = 0; shift < 30; shift += 10) {
            Floats right = to_float((shift_right_unsigned(across, shift) & 1023) - 256);
            Floats low = to_float((shift_right_unsigned(down, shift) & 1023) - 256);
            Floats share = sqrt(max(z + (x * right + y * low), 0.0f));
            Ints bent = round_to_int(to_float(shift_right_unsigned(factor, shift) & 1023) * share);
            result = result | (min(bent, Ints(1023)) << shift);
        }
        store(to + i, result);
    }
}

void spread_light_wide(std::uint32_t* to, int count, const std::int32_t* const channels[3],
                       const raster::Columns& columns) noexcept {
    constexpr int kToTenBits = 8 + light::kFactorBits - 10;
    for (int i = 0; i < count; i += 8) {
        const std::int32_t first = columns.texel[i];
        Ints texel = load(columns.texel + i), next = load(columns.next + i), weight = load(columns.weight + i);
        Ints result(0);
        for (int c = 0; c < 3; ++c) {
            Ints a, b;
            if (columns.near) {
                const Ints eight = load(channels[c] + first);
                a = pick(eight, texel - first), b = pick(eight, next - first);
            } else {
                const auto* all = reinterpret_cast<const std::uint32_t*>(channels[c]);
                a = gather(all, texel), b = gather(all, next);
            }
            result = result | (((a << 8) + (b - a) * weight) >> kToTenBits) << (10 * c);
        }
        store(to + i, result);
    }
}

void shine_wide(raster::Pixel* row, const raster::Pixel* glow, int count, float strength) noexcept {
    for (int i = 0; i < count; i += 8) {
        Ints pixels = load(row + i), added = load(glow + i), alpha = shift_right_unsigned(pixels, 24);
        Ints result = alpha << 24;
        for (int shift = 0; shift < 24; shift += 8) {
            Floats lit = channel(pixels, shift), own = channel(added, shift) * strength;
            result = result | (min(round_to_int(sqrt(lit * lit + own * own)), alpha) << shift);
        }
        store(row + i, result);
    }
}

} // namespace evil::EVIL_ISA
