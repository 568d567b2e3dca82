#include "draw/liquid_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {

void mean_of_five_wide(const float* from, int apart, float* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const float* at = from + i;
        const Floats ends = load(at) + load(at + 4 * apart), sides = load(at + apart) + load(at + 3 * apart);
        store(to + i, (ends + sides * 4.0f + load(at + 2 * apart) * 6.0f) * 0.0625f);
    }
}

void mean_of_rows_wide(const float* const rows[5], float* to, int count) noexcept {
    for (int i = 0; i < count; i += kLanes) {
        const Floats ends = load(rows[0] + i) + load(rows[4] + i), sides = load(rows[1] + i) + load(rows[3] + i);
        store(to + i, (ends + sides * 4.0f + load(rows[2] + i) * 6.0f) * 0.0625f);
    }
}

// With a bell of 1.5 texels, the mean of a half plane lies 1.197 texels behind its edge: there the surface is.
void sharp_wide(const float* weight, const float* x, const float* y, float row, float one, float* sharp, float* whole,
                int count) noexcept {
    constexpr float kReach = 1.197f, kFew = 0.14f, kSlope = 8.0f, kOutside = -4.0f;
    for (int i = 0; i < count; i += kLanes) {
        const Floats sum = load(weight + i), per = Floats(1.0f) / max(sum, 1e-6f);
        const Floats column = to_float(lane_numbers()) + (static_cast<float>(i) + 0.5f);
        const Floats dx = load(x + i) * per - column, dy = load(y + i) * per - row;
        const Floats near = Floats(kReach) - sqrt(dx * dx + dy * dy);
        const Floats inside = max(min(near, (sum * one - kFew) * kSlope), kOutside);
        store(sharp + i, inside);
        store(whole + i, clamp(inside * 0.5f + 0.5f, 0.0f, 1.0f));
    }
}

// What is blurred with a bell of s goes through 1/2 with a slope of 1 / (s sqrt(2 pi)). The smooth surface gives way to one
// that is smoother still where the two hardly differ: there it only wavers as particles happen to lie.
void join_wide(const float* sharp, const float* smooth, const float* bulk, float* to, int count) noexcept {
    constexpr float kRoot = 2.5066f, kBell = 3.2f, kWide = 5.1f; // texels
    constexpr float kThin = 0.28f, kThick = 0.44f, kKept = 0.7f, kCalm = 0.6f, kWave = 1.4f;
    const auto ease = [](Floats t) { return t * t * (Floats(3.0f) - t * 2.0f); };
    for (int i = 0; i < count; i += kLanes) {
        const Floats own = load(sharp + i), all = load(bulk + i);
        const Floats even = (load(smooth + i) - 0.5f) * (kRoot * kBell), calm = (all - 0.5f) * (kRoot * kWide);
        const Floats rough = clamp((abs(even - calm) - kCalm) * (1.0f / (kWave - kCalm)), 0.0f, 1.0f);
        const Floats line = calm + (even - calm) * ease(rough);
        const Floats much = ease(clamp((all - kThin) * (1.0f / (kThick - kThin)), 0.0f, 1.0f));
        store(to + i, max(own + (line - own) * much, own - kKept));
    }
}

static EVIL_INLINE Floats darkness_of(const draw::LiquidShade& row, Floats column) {
    const Floats x = clamp(column * row.cell_x_step + row.cell_x, 0.0f, static_cast<float>(row.cells_across - 1));
    const Floats y = clamp(column * row.cell_y_step + row.cell_y, 0.0f, static_cast<float>(row.cells_down - 1));
    const Ints left = to_int(x), top = to_int(y), right = min(left + 1, Ints(row.cells_across - 1));
    const Ints above = top * row.cells_across, below = min(top + 1, Ints(row.cells_down - 1)) * row.cells_across;
    const Floats across = x - to_float(left), down = y - to_float(top);
    const auto between = [&](Ints line) {
        const Floats a = gather(row.darkness, line + left);
        return a + (gather(row.darkness, line + right) - a) * across;
    };
    const Floats high = between(above);
    return high + (between(below) - high) * down;
}

// Where liquids meet, the one that there is more of takes nearly all: their border is as sharp as a surface.
static EVIL_INLINE void put_colours(const draw::LiquidShade& row, int i, Floats darkness) {
    const Ints tone = round_to_int(darkness * static_cast<float>(draw::kTones - 1));
    const Floats per = Floats(1.0f) / max(load(row.weight + i), 1e-4f);
    const auto weighty = [](Floats share) { return share * share * share * share; };
    Floats sums[6], first(1.0f), all(0.0f);
    for (Floats& sum : sums) sum = 0.0f;
    const auto add = [&](int kind, Floats weight) {
        all += weight;
        for (int c = 0; c < 6; ++c) sums[c] += gather(row.tables + (6 * kind + c) * draw::kTones, tone) * weight;
    };
    for (int kind = 1; kind < row.kinds; ++kind) {
        const Floats share = clamp(load(row.shares[kind] + i) * per, 0.0f, 1.0f);
        if (!any(share > 0.0f)) continue;
        first -= share;
        add(kind, weighty(share));
    }
    add(0, weighty(max(first, 0.0f)));
    const Floats whole = Floats(1.0f) / all;
    for (int c = 0; c < 6; ++c) store(row.to[4 + c] + i, sums[c] * whole);
}

void shade_liquid_wide(const draw::LiquidShade& row, int first_texel, int count) noexcept {
    for (int i = first_texel; i < first_texel + count; i += kLanes) {
        const Floats inside = load(row.depth + i), wall = load(row.wall + i);
        store(row.to[0] + i, min(inside * row.step, wall * row.step + row.under));
        if (!any(inside > -3.0f)) continue; // nobody asks for its colours

        const Floats slope_x = (load(row.depth + i + 1) - load(row.depth + i - 1)) * 0.5f;
        const Floats slope_y = (load(row.below + i) - load(row.above + i)) * 0.5f;
        const Floats near = Floats(1.0f) - clamp(inside * row.bulge, 0.0f, 1.0f);
        Floats wave_x(0.0f), wave_y(0.0f);
        for (const auto& wave : row.waves) {
            const Floats sine = load(wave.sines + i), cosine = load(wave.cosines + i);
            wave_x += (sine * wave.cosine + cosine * wave.sine) * wave.size;
            wave_y += (cosine * wave.cosine - sine * wave.sine) * wave.size;
        }
        const Floats bend = near * near * row.lens, waver = (Floats(1.0f) - near) * row.waver;
        store(row.to[1] + i, slope_x * bend + wave_x * waver);
        store(row.to[2] + i, slope_y * bend + wave_y * waver);

        // The line: brightest where it looks up. Drops are no mere dots of light, walls have none, and where the liquid goes
        // on behind a solid it is uncertain.
        const Floats squared = slope_x * slope_x + slope_y * slope_y, steep = max(sqrt(squared), 0.2f);
        const Floats towards = max((slope_x * row.up_x + slope_y * row.up_y) / steep * -1.0f, -0.6f);
        const Floats free = clamp(wall - inside + 0.5f, 0.0f, 1.0f);
        const Floats large = min(load(row.bulk + i) * 4.0f, 1.0f) * 0.5f + 0.5f;
        store(row.to[3] + i, (towards * 0.55f + 0.45f) * free * large * min(squared, 1.0f) * row.rim);
        put_colours(row, i, darkness_of(row, to_float(lane_numbers()) + static_cast<float>(i)));
    }
}

} // namespace evil::EVIL_ISA
