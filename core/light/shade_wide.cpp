// Eight texels of a row at a time.
#include "light/shade_wide.hpp"
#include "light/light_map.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

using light::Caster;
using light::Hidden;
using light::Lamp;

constexpr float kNowhere = 1e30f;

struct Points { // eight of them
    Floats x, y;
};

struct View { // from a point to the lamp: along (ex, ey), `distance` away
    Floats ex, ey, distance;
};

struct Interval { // of the lamp's line, whose ends are -1 and 1; nothing where `from` > `to`
    Floats from, to;
};

EVIL_INLINE View look(const Lamp& lamp, Points p) {
    if (lamp.parallel) return {-lamp.way.x, -lamp.way.y, light::kFar};
    Floats x = Floats(lamp.at.x) - p.x, y = Floats(lamp.at.y) - p.y;
    Floats distance = max(sqrt(x * x + y * y), 1e-6f);
    return {x / distance, y / distance, distance};
}

// Where a ray past (along, side), seen from the point, meets the lamp's line. The half shadow is at least a texel wide,
// which keeps hard edges from having steps: `along * size` is half its width there, (distance - along) / 2 half a texel's.
EVIL_INLINE Floats place(Floats along, Floats side, Floats distance, float size) {
    return side * distance / max(along * size, (distance - along) * 0.5f);
}

EVIL_INLINE void widen(Interval& hidden, Mask when, Floats where) {
    hidden.from = select(when, min(hidden.from, where), hidden.from);
    hidden.to = select(when, max(hidden.to, where), hidden.to);
}

// Only what lies between the point and the lamp hides it: corners there, and where edges enter and leave.
EVIL_INLINE Interval behind_corners(const Vec2* corners, std::uint32_t count, Points p, const View& v, float size) {
    Interval hidden{kNowhere, -kNowhere};
    Floats x = Floats(corners[count - 1].x) - p.x, y = Floats(corners[count - 1].y) - p.y;
    Floats along = x * v.ex + y * v.ey, side = v.ex * y - v.ey * x;
    Mask before = along<0.0f, beyond = along> v.distance;
    for (std::uint32_t i = 0; i < count; ++i) {
        Floats next_x = Floats(corners[i].x) - p.x, next_y = Floats(corners[i].y) - p.y;
        Floats next = next_x * v.ex + next_y * v.ey, next_side = v.ex * next_y - v.ey * next_x;
        Mask next_before = next<0.0f, next_beyond = next> v.distance;
        widen(hidden, ~(next_before | next_beyond), place(next, next_side, v.distance, size));
        Mask enters = (before & ~next_before) | (~before & next_before);
        Mask leaves = (beyond & ~next_beyond) | (~beyond & next_beyond);
        Floats slope = (next_side - side) / select(enters | leaves, next - along, 1.0f);
        if (any(enters)) widen(hidden, enters, (side - along * slope) * 2.0f);
        if (any(leaves)) widen(hidden, leaves, (side + (v.distance - along) * slope) / size);
        along = next, side = next_side, before = next_before, beyond = next_beyond;
    }
    return hidden;
}

// The same for a disc: its tangents' points, or where it enters and leaves.
EVIL_INLINE Interval behind_disc(Vec2 middle, float radius, Points p, const View& v, float size) {
    Floats x = Floats(middle.x) - p.x, y = Floats(middle.y) - p.y;
    Floats along = x * v.ex + y * v.ey, side = v.ex * y - v.ey * x;
    Floats away2 = x * x + y * y, tangent2 = away2 - radius * radius;
    Mask inside = tangent2 <= 0.0f;
    Floats tangent = sqrt(max(tangent2, 0.0f)), scale = tangent / max(away2, 1e-12f);
    Floats left = scale * (along * tangent - side * radius), left_side = scale * (along * radius + side * tangent);
    Floats right = scale * (along * tangent + side * radius), right_side = scale * (side * tangent - along * radius);
    Floats r2(radius * radius), rest = v.distance - along;
    Floats entry = sqrt(max(r2 - along * along, 0.0f)), exit = sqrt(max(r2 - rest * rest, 0.0f));
    Floats to = select(left < 0.0f, (side + entry) * 2.0f, place(left, left_side, v.distance, size));
    Floats from = select(right < 0.0f, (side - entry) * 2.0f, place(right, right_side, v.distance, size));
    to = select(left > v.distance, (side + exit) / size, to);
    from = select(right > v.distance, (side - exit) / size, from);
    Mask between = (along + radius > 0.0f) & (along - radius < v.distance);
    from = select(between, from, kNowhere), to = select(between, to, -kNowhere);
    return {select(inside, -kNowhere, from), select(inside, kNowhere, to)};
}

EVIL_INLINE Interval hidden_by(const Caster& caster, const Vec2* corners, Points p, const View& v, float size) {
    return caster.count == 0 ? behind_disc(caster.middle, caster.radius, p, v, size)
                             : behind_corners(corners + caster.first, caster.count, p, v, size);
}

EVIL_INLINE bool hides_all(const Interval& hidden) { return all((hidden.from <= -1.0f) & (hidden.to >= 1.0f)); }

// Lane by lane in the order of where they begin; they mostly are already, as neighbours see much the same.
void sort(Hidden* hidden, int count) {
    for (int end = count; end > 1;) {
        int last = 0;
        for (int i = 1; i < end; ++i) {
            Floats a = load(hidden[i - 1].from), b = load(hidden[i].from);
            Mask swapped = b < a;
            if (!any(swapped)) continue;
            Floats a_to = load(hidden[i - 1].to), b_to = load(hidden[i].to);
            store(hidden[i - 1].from, select(swapped, b, a)), store(hidden[i].from, select(swapped, a, b));
            store(hidden[i - 1].to, select(swapped, b_to, a_to)), store(hidden[i].to, select(swapped, a_to, b_to));
            last = i;
        }
        end = last;
    }
}

// The share of the line that no interval covers.
EVIL_INLINE Floats seen(Hidden* hidden, int count) {
    sort(hidden, count);
    Floats end(-1.0f), covered(0.0f);
    for (int i = 0; i < count; ++i) {
        Floats from = load(hidden[i].from), to = load(hidden[i].to);
        covered += max(to - max(from, end), 0.0f);
        end = max(end, to);
    }
    return max(Floats(1.0f) - covered * 0.5f, 0.0f);
}

EVIL_INLINE Floats power_in_quarters(Floats base, int quarters) {
    Floats result(1.0f), root = sqrt(base);
    if (quarters & 2) result *= root;
    if (quarters & 1) result *= sqrt(root);
    for (int n = quarters >> 2; n > 0; n >>= 1) {
        if (n & 1) result *= base;
        base *= base;
    }
    return result;
}

// How strong the lamp would be if nothing stood before it.
EVIL_INLINE Floats strength(const Lamp& lamp, const View& v) {
    if (lamp.parallel) return 1.0f;
    Floats rest = max(Floats(1.0f) - v.distance / lamp.reach, 0.0f);
    Floats result = select(rest > 0.0f, power_in_quarters(rest, lamp.quarters), 0.0f);
    if (!lamp.spot) return result;
    Floats cosine = -(v.ex * lamp.way.x + v.ey * lamp.way.y);
    Floats t = clamp((cosine - lamp.cone_middle) * lamp.cone_slope, 0.0f, 1.0f);
    return result * t * t * (Floats(3.0f) - t * 2.0f);
}

// Adds the intervals that casters first..last - 1 hide to the `intervals` that there are. True if one of them hides all.
EVIL_INLINE bool find_hidden(const Lamp& lamp, const light::Near& near, int first, int last, Points p, const View& v,
                             int& intervals) {
    for (int i = first; i < last; ++i) {
        Interval one = hidden_by(near.casters[near.which[i]], near.corners, p, v, lamp.size);
        one.from = max(one.from, -1.0f), one.to = min(one.to, 1.0f);
        if (!any(one.from < one.to)) continue;
        if (hides_all(one)) return true;
        store(near.hidden[intervals].from, one.from), store(near.hidden[intervals].to, one.to);
        ++intervals;
    }
    return false;
}

EVIL_INLINE void add(float* to, Floats amount) { store(to, load(to) + amount); }

EVIL_INLINE Floats to_screen(Floats linear) { // to the power of 1/4 + 1/8 + 1/16 + 1/64
    Floats fourth = sqrt(sqrt(linear)), eighth = sqrt(fourth), sixteenth = sqrt(eighth);
    return fourth * eighth * (sixteenth * sqrt(sqrt(sixteenth)));
}

EVIL_INLINE Ints to_factor(Floats linear) {
    constexpr float kMost = static_cast<float>(light::kFactorMask);
    return round_to_int(clamp(to_screen(max(linear, 0.0f)) * static_cast<float>(light::kFactorOne), 0.0f, kMost));
}

EVIL_INLINE Ints to_way(Floats sum, Floats light) { // nowhere where there is no light
    constexpr float kHalf = static_cast<float>(light::kFactorOne / 2);
    Floats mean = select(light > 1e-9f, sum / max(light, 1e-9f), 0.0f);
    return round_to_int(clamp(mean, -1.0f, 1.0f) * kHalf + kHalf);
}

EVIL_INLINE void pack(std::uint64_t* to, int count, Ints red, Ints green, Ints blue) {
#if EVIL_WIDTH == 8
    if (count >= kLanes) {
        const Ints low = blue | green << light::kFactorApart;
        const Ints high = shift_right_unsigned(green, 32 - light::kFactorApart) | red << (2 * light::kFactorApart - 32);
        const auto a = __builtin_bit_cast(__m256i, low.part[0]), b = __builtin_bit_cast(__m256i, high.part[0]);
        const __m256i even = _mm256_unpacklo_epi32(a, b), odd = _mm256_unpackhi_epi32(a, b); // 0 1 4 5, 2 3 6 7
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permute2x128_si256(even, odd, 0x20));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to + 4), _mm256_permute2x128_si256(even, odd, 0x31));
        return;
    }
#endif
    std::int32_t r[8], g[8], b[8];
    store(r, red), store(g, green), store(b, blue);
    for (int lane = 0; lane < 8 && lane < count; ++lane)
        to[lane] = static_cast<std::uint64_t>(r[lane]) << 2 * light::kFactorApart |
                   static_cast<std::uint64_t>(g[lane]) << light::kFactorApart | static_cast<std::uint64_t>(b[lane]);
}

// The way that light comes from, as long as it lies in the picture's plane, for a lamp before it.
EVIL_INLINE void add_ways(const light::Planes& planes, int at, const Lamp& lamp, const View& v, const Floats light[3]) {
    Floats lean = v.distance / sqrt(v.distance * v.distance + lamp.height * lamp.height);
    Floats across = v.ex * lean, down = v.ey * lean;
    for (int c = 0; c < 3; ++c) {
        add(planes.across[c] + at, across * light[c]);
        add(planes.down[c] + at, down * light[c]);
    }
}

EVIL_INLINE void extent(Floats of, float& least, float& most) {
    float low[kLanes], high[kLanes];
    store(low, min(of, swap_fours(of))), store(high, max(of, swap_fours(of)));
    least = low[0], most = high[0];
    for (int i = 1; i < kLanes / 2; ++i) {
        least = low[i] < least ? low[i] : least;
        most = high[i] > most ? high[i] : most;
    }
}

EVIL_INLINE Points points_of(const light::Patch& patch, int row) {
    return {Floats(static_cast<float>(patch.x) + 0.5f) + to_float(lane_numbers()),
            static_cast<float>(patch.y + row) + 0.5f};
}

struct Taps { // along one side of a slide: two texels and where between them
    Ints first, second;
    Floats between;
};

EVIL_INLINE Taps taps(Floats at, int size, bool repeat) {
    const Floats count(static_cast<float>(size));
    if (repeat) at -= count * floor(at / count);
    Floats low = floor(at);
    Ints first = to_int(low), last(size - 1), second = first + 1;
    if (repeat) second = select(second > last, Ints(0), second);
    return {max(min(first, last), Ints(0)), max(min(second, last), Ints(0)), at - low};
}

// Light times what the lamp's slide lets through.
EVIL_INLINE void shine_through(const Lamp& lamp, Points p, Floats light[3]) {
    Floats u = p.x * lamp.to_slide.a + p.y * lamp.to_slide.c + lamp.to_slide.tx;
    Floats v = p.x * lamp.to_slide.b + p.y * lamp.to_slide.d + lamp.to_slide.ty;
    Taps x = taps(u, lamp.slide_width, lamp.parallel), y = taps(v, lamp.slide_height, lamp.parallel);
    Ints above = y.first * lamp.slide_width, below = y.second * lamp.slide_width;
    for (int c = 0; c < 3; ++c) {
        Floats a = gather(lamp.slide[c], above + x.first), b = gather(lamp.slide[c], above + x.second);
        Floats d = gather(lamp.slide[c], below + x.first), e = gather(lamp.slide[c], below + x.second);
        Floats upper = a + (b - a) * x.between, lower = d + (e - d) * x.between;
        light[c] *= upper + (lower - upper) * y.between;
    }
    if (lamp.parallel) return;
    Mask inside = (u >= -0.5f) & (v >= -0.5f) & (u <= static_cast<float>(lamp.slide_width) - 0.5f) &
                  (v <= static_cast<float>(lamp.slide_height) - 0.5f);
    for (int c = 0; c < 3; ++c) light[c] = select(inside, light[c], 0.0f);
}

} // namespace

int keep_near_wide(const light::Strip& strip, const Caster* casters, std::uint32_t* which, int count) noexcept {
    const auto* middles = reinterpret_cast<const float*>(casters);
    const Floats distance(strip.distance);
    int kept = 0;
    for (int i = 0; i < count; i += kLanes) {
        const int some = count - i < kLanes ? count - i : kLanes;
        const Ints at = (some == kLanes ? load(which + i) : load_first(which + i, some)) << 3;
        const Floats x = gather(middles, at) - strip.from.x, y = gather(middles + 1, at) - strip.from.y;
        const Floats along = clamp(x * strip.along.x + y * strip.along.y, 0.0f, distance);
        const Floats reach = gather(middles + 2, at) + strip.radius + along * strip.widening;
        const Floats aside = x - along * strip.along.x, ahead = y - along * strip.along.y;
        std::int32_t is_near[kLanes];
        store(is_near, select(aside * aside + ahead * ahead <= reach * reach, Ints(1), Ints(0)));
        for (int lane = 0; lane < some; ++lane) which[kept] = which[i + lane], kept += is_near[lane];
    }
    return kept;
}

void outline_casters_wide(const Lamp& lamp, const Caster* casters, const std::uint32_t* which, int count,
                          const Vec2* corners, const light::Square& square, light::Outline* outlines) noexcept {
    const float end = static_cast<float>(square.side) - 0.5f, half = 0.5f * static_cast<float>(square.side);
    const float x[8] = {0.5f, half, end, 0.5f, end, 0.5f, half, end},
                y[8] = {0.5f, 0.5f, 0.5f, half, half, end, end, end};
    Points p{Floats(static_cast<float>(square.x)) + load(x), Floats(static_cast<float>(square.y)) + load(y)};
    View v = look(lamp, p);
    for (int i = 0; i < count; ++i) {
        Interval hidden = hidden_by(casters[which[i]], corners, p, v, lamp.size);
        extent(hidden.from, outlines[i].from_least, outlines[i].from_most);
        extent(hidden.to, outlines[i].to_least, outlines[i].to_most);
    }
}

void shade_patch_wide(const Lamp& lamp, const light::Near& near, const light::Patch& patch,
                      const light::Shares& shares) noexcept {
    for (int row = 0; row < patch.rows; ++row) {
        float* const to = shares.at + row * shares.stride;
        store(to, 0.0f);
        Points p = points_of(patch, row);
        View v = look(lamp, p);
        Floats light = strength(lamp, v);
        int intervals = 0;
        if (!any(light > 0.0f) || find_hidden(lamp, near, 0, near.count, p, v, intervals)) continue;
        if (intervals > 0) light *= seen(near.hidden, intervals);
        store(to, light);
    }
}

void shade_kept_wide(const Lamp& lamp, const light::Near& near, int moving, const light::Patch& patch,
                     const light::Shares& kept, const light::Shares& shares) noexcept {
    for (int row = 0; row < patch.rows; ++row) {
        float* const to = shares.at + row * shares.stride;
        Floats known = load(kept.at + row * kept.stride);
        store(to, known);
        if (!any(known > 0.0f)) continue;
        Points p = points_of(patch, row);
        View v = look(lamp, p);
        int intervals = 0;
        bool dark = find_hidden(lamp, near, 0, moving, p, v, intervals);
        if (!dark && intervals == 0) continue;
        dark = dark || find_hidden(lamp, near, moving, near.count, p, v, intervals);
        store(to, dark ? Floats(0.0f) : strength(lamp, v) * seen(near.hidden, intervals));
    }
}

bool knows_patch_wide(const light::Patch& patch, const light::Shares& shares) noexcept {
    Floats least(0.0f);
    for (int row = 0; row < patch.rows; ++row) least = min(least, load(shares.at + row * shares.stride));
    return !any(least < 0.0f);
}

void light_patch_wide(const Lamp& lamp, const light::Patch& patch, const light::Shares& shares,
                      const light::Planes& planes) noexcept {
    for (int row = 0; row < patch.rows; ++row) {
        Floats share = load(shares.at + row * shares.stride);
        if (!any(share > 0.0f)) continue;
        Floats light[3] = {share * lamp.glow[0], share * lamp.glow[1], share * lamp.glow[2]};
        Points p = points_of(patch, row);
        if (lamp.slide[0]) shine_through(lamp, p, light);
        const int at = (patch.y + row) * patch.stride + patch.x;
        for (int c = 0; c < 3; ++c) add(planes.light[c] + at, light[c]);
        if (planes.across[0]) add_ways(planes, at, lamp, look(lamp, p), light);
    }
}

void pack_factors_wide(const float* const light[3], int at, int count, std::uint64_t* to) noexcept {
    for (int i = 0; i < count; i += 8)
        pack(to + i, count - i, to_factor(load(light[0] + at + i)), to_factor(load(light[1] + at + i)),
             to_factor(load(light[2] + at + i)));
}

void pack_ways_wide(const float* const light[3], const float* const ways[3], int at, int count,
                    std::uint64_t* to) noexcept {
    for (int i = 0; i < count; i += 8)
        pack(to + i, count - i, to_way(load(ways[0] + at + i), load(light[0] + at + i)),
             to_way(load(ways[1] + at + i), load(light[1] + at + i)),
             to_way(load(ways[2] + at + i), load(light[2] + at + i)));
}

} // namespace evil::EVIL_ISA
