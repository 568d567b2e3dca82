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
    Floats result = power_in_quarters(rest, lamp.quarters);
    if (!lamp.spot) return result;
    Floats cosine = -(v.ex * lamp.way.x + v.ey * lamp.way.y);
    Floats t = clamp((cosine - lamp.cone_middle) * lamp.cone_slope, 0.0f, 1.0f);
    return result * t * t * (Floats(3.0f) - t * 2.0f);
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
    std::int32_t r[8], g[8], b[8];
    store(r, red), store(g, green), store(b, blue);
    for (int lane = 0; lane < 8 && lane < count; ++lane)
        to[lane] = static_cast<std::uint64_t>(r[lane]) << 2 * light::kFactorApart |
                   static_cast<std::uint64_t>(g[lane]) << light::kFactorApart | static_cast<std::uint64_t>(b[lane]);
}

// The way that light comes from, as long as it lies in the picture's plane, for a lamp before it.
EVIL_INLINE void add_ways(const light::Planes& planes, int at, const Lamp& lamp, const View& v, Floats light) {
    Floats lean = v.distance / sqrt(v.distance * v.distance + lamp.height * lamp.height), amount = light * lean;
    Floats across = v.ex * amount, down = v.ey * amount;
    for (int c = 0; c < 3; ++c) {
        add(planes.across[c] + at, across * lamp.glow[c]);
        add(planes.down[c] + at, down * lamp.glow[c]);
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

} // namespace

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

void shade_patch_wide(const Lamp& lamp, const Caster* casters, const std::uint32_t* which, int count,
                      const Vec2* corners, const light::Patch& patch, const light::Planes& planes,
                      Hidden* hidden) noexcept {
    const Floats x = Floats(static_cast<float>(patch.x) + 0.5f) + to_float(lane_numbers());
    for (int row = 0; row < patch.rows; ++row) {
        Points p{x, static_cast<float>(patch.y + row) + 0.5f};
        View v = look(lamp, p);
        Floats light = strength(lamp, v);
        if (!any(light > 0.0f)) continue;
        int intervals = 0;
        bool dark = false;
        for (int i = 0; i < count && !dark; ++i) {
            Interval one = hidden_by(casters[which[i]], corners, p, v, lamp.size);
            one.from = max(one.from, -1.0f), one.to = min(one.to, 1.0f);
            if (!any(one.from < one.to)) continue;
            dark = hides_all(one);
            store(hidden[intervals].from, one.from), store(hidden[intervals].to, one.to);
            ++intervals;
        }
        if (dark) continue;
        if (intervals > 0) light *= seen(hidden, intervals);
        const int at = (patch.y + row) * patch.stride + patch.x;
        for (int c = 0; c < 3; ++c) add(planes.light[c] + at, light * lamp.glow[c]);
        if (planes.across[0]) add_ways(planes, at, lamp, v, light);
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
