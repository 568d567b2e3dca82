#include "raster/liquid_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

using raster::LiquidRow;
using raster::Pixel;

EVIL_INLINE Floats channel_of(Ints pixels, int shift) { return to_float(shift_right_unsigned(pixels, shift) & 255); }

struct Behind { // eight places in the picture behind, each between four pixels
    Ints corner[4];
    Floats across, down;
    EVIL_INLINE Floats channel(int shift) const {
        const Floats a = channel_of(corner[0], shift), b = channel_of(corner[1], shift);
        const Floats c = channel_of(corner[2], shift), d = channel_of(corner[3], shift);
        const Floats above = a + (b - a) * across, below = c + (d - c) * across;
        return above + (below - above) * down;
    }
};

EVIL_INLINE Behind look_behind(const LiquidRow& row, Floats x, Floats y) {
    const Floats right = clamp(x, 0.0f, static_cast<float>(row.width - 1));
    const Floats low = clamp(y, static_cast<float>(row.top), static_cast<float>(row.bottom - 1));
    const Ints column = to_int(right), line = to_int(low), width(row.width);
    const Ints next = min(column + 1, Ints(row.width - 1));
    const Ints above = line * width, below = min(line + 1, Ints(row.bottom - 1)) * width;
    return {{gather(row.behind, above + column), gather(row.behind, above + next), gather(row.behind, below + column),
             gather(row.behind, below + next)},
            right - to_float(column),
            low - to_float(line)};
}

// Lane i becomes lane index[i], 0..7, of the eight.
EVIL_INLINE Floats pick(Floats eight, Ints index) {
#if EVIL_WIDTH == 8
    Floats r;
    r.part[0] = _mm256_permutevar8x32_ps(eight.part[0], __builtin_bit_cast(__m256i, index.part[0]));
    return r;
#else
    float from[kLanes], lanes[kLanes];
    std::int32_t at[kLanes];
    store(from, eight), store(at, index);
    for (int i = 0; i < kLanes; ++i) lanes[i] = from[at[i]];
    return load(lanes);
#endif
}

// Eight pixels lie between six texels at most, as a texel is two pixels or more: with those that cubics need that is eight.
struct Texels {
    std::ptrdiff_t first; // of the eight
    Ints index;           // of the texel before the pixel's left one
    Floats part;
    EVIL_INLINE Floats of(const float* plane) const {
        const Floats eight = load(plane + first), a = pick(eight, index + 1);
        return a + (pick(eight, index + 2) - a) * part;
    }
};

} // namespace

void mix_two_wide(const float* first, std::size_t stride, float part, float* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const Floats above = load(first + i);
        store(to + i, above + (load(first + stride + i) - above) * part);
    }
}

void mix_four_wide(const float* first, std::size_t stride, const float part[4], float* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        Floats sum = load(first + stride + i) * part[1] + load(first + 2 * stride + i) * part[2];
        sum += load(first + i) * part[0] + load(first + 3 * stride + i) * part[3];
        store(to + i, sum);
    }
}

void liquid_row_wide(Pixel* to, int x, int count, const LiquidRow& row) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const std::ptrdiff_t first = row.column[i] - 1;
        const Ints index = load(row.column + i) - row.column[i];
        const Floats depths = load(row.planes[draw::kDepth] + first);
        Floats depth(0.0f);
        for (int k = 0; k < 4; ++k) depth += pick(depths, index + k) * load(row.cubic[k] + i);
        const Floats inside = clamp(depth + 0.5f, 0.0f, 1.0f);
        if (!any(inside > 0.0f)) continue;

        const Texels texels{first, index, load(row.part + i)};
        const Floats line = clamp(Floats(1.0f) - depth * row.rim, 0.0f, 1.0f);
        const Floats rim = texels.of(row.planes[draw::kRim]) * line * line * 255.0f;
        const Behind behind =
            look_behind(row, to_float(lane_numbers()) + static_cast<float>(x + i) + texels.of(row.planes[draw::kAwayX]),
                        Floats(static_cast<float>(row.y)) + texels.of(row.planes[draw::kAwayY]));
        const int left = count - i < kLanes ? count - i : kLanes;
        const Ints here = load_first(to + i, left), light = row.light ? load(row.light + i) : Ints(0);
        Ints pixels = here & static_cast<std::int32_t>(0xff000000u);
        for (int c = 0; c < 3; ++c) {
            Floats own = texels.of(row.planes[draw::kOwnRed + c]) * 255.0f + rim;
            if (row.light) own *= to_float(shift_right_unsigned(light, 10 * c) & 1023) * (1.0f / 512.0f);
            const Floats seen = min(behind.channel(8 * c) * texels.of(row.planes[draw::kThroughRed + c]) + own, 255.0f);
            const Floats was = channel_of(here, 8 * c);
            const Ints now = round_to_int(clamp(was + (seen - was) * inside, 0.0f, 255.0f));
            pixels = pixels | (now << (8 * c));
        }
        store_first(to + i, left, pixels);
    }
}

} // namespace evil::EVIL_ISA
