#include "fluid/looks_wide.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

// A row between rows of cells, number by number, as PaintRow wants it.
struct Mixed {
    std::vector<float> numbers;
    Planes planes{};

    void mix(const float* cells, const Grid& grid, int row, const float share[3], InstructionSet set) {
        constexpr int kBefore = 8, kAfter = 8;
        const int room = kBefore + grid.nx + kAfter, eights = grid.nx / 8 * 8;
        numbers.resize(4 * static_cast<std::size_t>(room));
        const float* rows[3];
        for (int k = 0; k < 3; ++k)
            rows[k] = cells + std::ptrdiff_t{std::clamp(row + k - 1, 0, grid.ny - 1)} * 4 * grid.nx;
        for (int k = 0; k < 4; ++k) planes[static_cast<std::size_t>(k)] = numbers.data() + k * room + kBefore;
        EVIL_PICK(set, mix_cells_wide)(rows, share, planes, eights);
        for (std::size_t k = 0; k < 4; ++k) {
            for (int i = eights; i < grid.nx; ++i) {
                const std::size_t at = 4 * static_cast<std::size_t>(i) + k;
                planes[k][i] = rows[0][at] * share[0] + rows[1][at] * share[1] + rows[2][at] * share[2];
            }
            planes[k][-1] = planes[k][0];
            std::fill_n(planes[k] + grid.nx, kAfter, planes[k][grid.nx - 1]);
        }
    }
};

} // namespace

void paint(const Smoke& smoke, Shown shown, const Ramp& ramp, std::span<std::uint32_t> pixels) {
    const Views& views = *smoke.views;
    const Grid& grid = smoke.grid;
    const InstructionSet set = best_instruction_set();
    Mixed cells, parts;
    PaintRow row{};
    row.count = grid.nx, row.ramp = &ramp;
    row.own[0] = smoke.colour.r, row.own[1] = smoke.colour.g, row.own[2] = smoke.colour.b;
    for (int y = 0; y < 2 * grid.ny; ++y) {
        const int j = grid.ny - 1 - y / 2;
        const float above[3] = {kFar, kHere, kNear}, below[3] = {kNear, kHere, kFar};
        const float* share = y % 2 == 0 ? above : below;
        cells.mix(&views.content.front().density, grid, j, share, set);
        row.shown = cells.planes[shown == Shown::density ? 0 : 1], row.open = cells.planes[3];
        if (shown == Shown::density && !views.colour.empty()) {
            parts.mix(views.colour.data(), grid, j, share, set);
            std::copy_n(parts.planes.data(), 3, row.parts);
        }
        row.to = pixels.data() + static_cast<std::size_t>(y) * 2 * static_cast<std::size_t>(grid.nx);
        EVIL_PICK(set, paint_row_wide)(row);
    }
}

void find_blazes(const Smoke& smoke, float above, std::span<const Vec2> places, std::vector<Blaze>& blazes) {
    struct Sums {
        double heat = 0.0, x = 0.0, y = 0.0, square = 0.0;
    };
    const Grid& g = smoke.grid;
    std::vector<Sums> sums(places.size());
    const Cell* cell = smoke.views->content.data();
    for (int j = 0; j < g.ny; ++j)
        for (int i = 0; i < g.nx; ++i, ++cell) {
            const double heat = double(cell->temperature) - double(above);
            if (!(heat > 0.0)) continue;
            const Vec2 at = g.low + g.h * Vec2{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
            const auto nearest = std::ranges::min_element(places, {}, [at](Vec2 p) { return length_squared(p - at); });
            Sums& s = sums[static_cast<std::size_t>(nearest - places.begin())];
            s.heat += heat, s.x += heat * i, s.y += heat * j, s.square += heat * (double(i) * i + double(j) * j);
        }
    blazes.assign(places.size(), {});
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const Sums& s = sums[k];
        if (s.heat == 0.0) continue;
        const double x = s.x / s.heat, y = s.y / s.heat;
        const double spread = std::sqrt(std::max(s.square / s.heat - x * x - y * y, 0.0));
        blazes[k] = {static_cast<float>(s.heat * double(g.h) * double(g.h)),
                     g.low + g.h * Vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
                     static_cast<float>(spread) * g.h};
    }
}

} // namespace evil::fluid
