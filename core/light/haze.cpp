#include "light/haze.hpp"
#include "fluid/smoke.hpp"
#include <algorithm>
#include <cmath>

namespace evil::light {
namespace {

constexpr float kToHaze = 1.0f / kHazeStep;
constexpr float kOwn = 1.5f; // sizes of a lamp round it within which smoke takes nothing: a fire shines out of its own

struct Part { // of the map, in its texels
    int left, top, right, bottom;
};

// The part of the map that a smoke's area may lie in.
Part part_of(const fluid::Grid& grid, const Affine& to_haze, int width, int height) {
    const Vec2 size = grid.h * Vec2{static_cast<float>(grid.nx), static_cast<float>(grid.ny)};
    Vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (int corner = 0; corner < 4; ++corner) {
        const Vec2 at = apply(to_haze, grid.low + Vec2{corner & 1 ? size.x : 0.0f, corner & 2 ? size.y : 0.0f});
        low = min(low, at), high = max(high, at);
    }
    const auto texel = [](float at, int most) {
        return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most)));
    };
    return {texel(low.x, width), texel(low.y, height), texel(high.x + 1.0f, width), texel(high.y + 1.0f, height)};
}

// How dense it is at a place, told in cells from the middle of the first.
float density_at(const fluid::Smoke& smoke, Vec2 at) {
    const int nx = smoke.grid.nx, ny = smoke.grid.ny;
    if (!(at.x > -0.5f && at.y > -0.5f && at.x < static_cast<float>(nx) - 0.5f && at.y < static_cast<float>(ny) - 0.5f))
        return 0.0f;
    const float x = std::clamp(at.x, 0.0f, static_cast<float>(nx - 1)),
                y = std::clamp(at.y, 0.0f, static_cast<float>(ny - 1));
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    const auto row = [&](int line) {
        const fluid::Cell* cells = smoke.views->content.data() + static_cast<std::size_t>(line) * nx;
        const float first = cells[i].density;
        return first + fx * (cells[std::min(i + 1, nx - 1)].density - first);
    };
    const float below = row(j);
    return below + fy * (row(std::min(j + 1, ny - 1)) - below);
}

void add_smoke(Haze& haze, const fluid::Smoke& smoke, float shadow, const Affine& to_haze) {
    const Part part = part_of(smoke.grid, to_haze, haze.width, haze.height);
    const float area = determinant(to_haze), a_texel = 1.0f / std::sqrt(std::fabs(area)); // metres
    const float per = 1.0f / (area * smoke.grid.h);
    for (int y = part.top; y < part.bottom; ++y)
        for (int x = part.left; x < part.right; ++x) {
            const Vec2 to{static_cast<float>(x) + 0.5f - to_haze.tx, static_cast<float>(y) + 0.5f - to_haze.ty};
            const Vec2 place{per * (to_haze.d * to.x - to_haze.c * to.y), per * (to_haze.a * to.y - to_haze.b * to.x)};
            const Vec2 cell = place - (1.0f / smoke.grid.h) * smoke.grid.low - Vec2{0.5f, 0.5f};
            const float density = density_at(smoke, cell);
            if (!(density > 0.0f)) continue;
            haze.thickness[static_cast<std::size_t>(y) * haze.width + x] +=
                std::min(shadow * density * a_texel, 100.0f);
            haze.left = std::min(haze.left, x), haze.right = std::max(haze.right, x + 1);
            haze.top = std::min(haze.top, y), haze.bottom = std::max(haze.bottom, y + 1);
        }
}

// What was lost before a texel whose light came through a line of texels, `apart` from each other, at `at`.
float before(const std::vector<float>& lost, std::ptrdiff_t line, std::ptrdiff_t apart, float at, int count) {
    const float low = std::floor(at), part = at - low;
    const int i = static_cast<int>(low);
    const auto value = [&](int k) {
        return k >= 0 && k < count ? lost[static_cast<std::size_t>(line + k * apart)] : 0.0f;
    };
    return value(i) + part * (value(i + 1) - value(i));
}

struct Ring { // of texels that are as far from a lamp's, along one axis or the other
    Haze& haze;
    int x, y;  // the lamp's texel
    float own; // texels round it

    void meet(int at_x, int at_y, int far, bool lies) { // does it lie above or below the lamp, rather than beside?
        const int dx = at_x - x, dy = at_y - y;
        const float across = static_cast<float>(lies ? dx : dy) / static_cast<float>(far);
        const float steps = std::sqrt(1.0f + across * across);
        const std::ptrdiff_t width = haze.width;
        const int line = lies ? at_y - (dy > 0 ? 1 : -1) : at_x - (dx > 0 ? 1 : -1);
        float sum = 0.0f;
        if (lies ? line >= 0 && line < haze.height : line >= 0 && line < haze.width)
            sum = lies ? before(haze.lost, line * width, 1, static_cast<float>(at_x) - across, haze.width)
                       : before(haze.lost, line, width, static_cast<float>(at_y) - across, haze.height);
        const std::size_t at = static_cast<std::size_t>(at_y * width + at_x);
        const float shown = std::clamp(steps * static_cast<float>(far) - own, 0.0f, 1.0f);
        haze.lost[at] = std::min(sum + shown * steps * haze.thickness[at], 100.0f);
    }
    void go_round(int far) {
        const int left = std::max(x - far, 0), right = std::min(x + far, haze.width - 1);
        for (const int line : {y - far, y + far})
            if (line >= 0 && line < haze.height)
                for (int i = left; i <= right; ++i) meet(i, line, far, true);
        const int top = std::max(y - far + 1, 0), bottom = std::min(y + far - 1, haze.height - 1);
        for (const int line : {x - far, x + far})
            if (line >= 0 && line < haze.width)
                for (int j = top; j <= bottom; ++j) meet(line, j, far, false);
    }
};

int outside(int at, int low, int high) { return std::max({low - at, at - high, 0}); } // how far

void follow_lamp(Haze& haze, const Lamp& lamp) {
    const auto texel = [](float at) { return static_cast<int>(std::floor(std::clamp(kToHaze * at, -1e6f, 1e6f))); };
    Ring ring{haze, texel(lamp.at.x), texel(lamp.at.y), kToHaze * kOwn * lamp.size};
    const int nearest =
        std::max(outside(ring.x, haze.left, haze.right - 1), outside(ring.y, haze.top, haze.bottom - 1));
    const int farthest = std::max({ring.x, haze.width - 1 - ring.x, ring.y, haze.height - 1 - ring.y});
    const int reach = static_cast<int>(std::min(kToHaze * lamp.reach, 1e6f)) + 1;
    for (int far = std::max(nearest, 1); far <= std::min(farthest, reach); ++far) ring.go_round(far);
}

// A sun's light goes from line to line.
void follow_sun(Haze& haze, Vec2 way) {
    const bool lies = std::fabs(way.y) >= std::fabs(way.x);
    const float main = lies ? way.y : way.x, across = (lies ? way.x : way.y) / std::fabs(main);
    const float steps = std::sqrt(1.0f + across * across);
    const std::ptrdiff_t line_apart = lies ? haze.width : 1, apart = lies ? 1 : haze.width;
    const int lines = lies ? haze.height : haze.width, count = lies ? haze.width : haze.height;
    for (int k = 0; k < lines; ++k) {
        const int line = main > 0.0f ? k : lines - 1 - k, last = main > 0.0f ? line - 1 : line + 1;
        for (int i = 0; i < count; ++i) {
            const float sum =
                k == 0 ? 0.0f : before(haze.lost, last * line_apart, apart, static_cast<float>(i) - across, count);
            const std::size_t at = static_cast<std::size_t>(line * line_apart + i * apart);
            haze.lost[at] = std::min(sum + steps * haze.thickness[at], 100.0f);
        }
    }
}

} // namespace

bool find_haze(Haze& haze, std::span<const Smoky> smokes, const World& world, const Affine& to_texel, int width,
               int height) {
    if (smokes.empty()) return false;
    haze.width = (width + kHazeStep - 1) / kHazeStep, haze.height = (height + kHazeStep - 1) / kHazeStep;
    haze.left = haze.width, haze.top = haze.height, haze.right = haze.bottom = 0;
    haze.thickness.assign(static_cast<std::size_t>(haze.width) * haze.height, 0.0f);
    const Affine to_haze = compose({kToHaze, 0, 0, kToHaze, 0, 0}, to_texel);
    for (const Smoky& one : smokes)
        if (world.fluids.smoke_slots.taken(one.smoke))
            add_smoke(haze, *world.fluids.smokes[one.smoke], one.shadow, to_haze);
    return haze.left < haze.right;
}

void find_veil(Veil& veil, Haze& haze, const Lamp& lamp) {
    haze.lost.assign(haze.thickness.size(), 0.0f);
    if (lamp.parallel)
        follow_sun(haze, lamp.way);
    else
        follow_lamp(haze, lamp);
    veil.width = haze.width, veil.height = haze.height;
    veil.shares.resize(haze.lost.size());
    for (std::size_t i = 0; i < haze.lost.size(); ++i) { // exp(-x), to the cubic term
        const float x = haze.lost[i];
        veil.shares[i] = 1.0f / (1.0f + x * (1.0f + x * (0.5f + x * (1.0f / 6.0f))));
    }
}

// A patch is as wide as two of the veil's texels: each of its texels lies between two of those and their neighbours.
bool put_veil(const Veil& veil, const Patch& patch, const Shares& from, float* to) {
    static_assert(kPatch == 2 * kHazeStep);
    constexpr float kFirst[kHazeStep] = {0.625f, 0.875f, 0.875f, 0.625f}; // what is nearer, and the rest its neighbour
    const int left = patch.x / kHazeStep, top = patch.y / kHazeStep;
    float near[4][4]; // of the veil, from one before the patch to one after it
    bool all = true;
    for (int j = 0; j < 4; ++j) {
        const int line = std::clamp(top + j - 1, 0, veil.height - 1);
        const float* row = veil.shares.data() + static_cast<std::size_t>(line) * veil.width;
        for (int i = 0; i < 4; ++i) {
            near[j][i] = row[std::clamp(left + i - 1, 0, veil.width - 1)];
            all &= near[j][i] == 1.0f;
        }
    }
    if (all) return false;
    for (int y = 0; y < patch.rows; ++y) {
        const int own = 1 + y / kHazeStep, other = y % kHazeStep < kHazeStep / 2 ? own - 1 : own + 1;
        const float part = kFirst[y % kHazeStep];
        float row[4];
        for (int i = 0; i < 4; ++i) row[i] = part * near[own][i] + (1.0f - part) * near[other][i];
        const float* shares = from.at + y * from.stride;
        for (int x = 0; x < kPatch; ++x) {
            const int first = 1 + x / kHazeStep, second = x % kHazeStep < kHazeStep / 2 ? first - 1 : first + 1;
            const float along = kFirst[x % kHazeStep];
            to[y * kPatch + x] = shares[x] * (along * row[first] + (1.0f - along) * row[second]);
        }
    }
    return true;
}

} // namespace evil::light
