#include "fluid/water/press.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr int kCoarsest = 4;       // cells each way that sweeps alone solve well
constexpr int kCoarsestSweeps = 6; // there
constexpr float kSilent = 1e-6f;   // m/s: what may be left in each cell whatever is asked for
constexpr float kGives = 1.5f; // faces by which a pocket grows that a body moves: less is how cells see one that swims
constexpr float kGivesAll =
    0.25f; // of what it gives to each: less is how cells see one that moves from pocket to pocket
constexpr float kHopeless = 1e3f;    // times what was asked for: what is left on the way to a solution is not as much
constexpr float kCoarseDrain = 0.5f; // air is twice as far, on a level twice as coarse

void clear_tiles(PressLevel& level) {
    for (Field* field : {&level.left, &level.right, &level.below, &level.above, &level.drain, &level.total,
                         &level.inverse, &level.z, &level.b})
        for (const Tile& tile : level.tiles) std::fill_n(field->data() + tile.at, 8, 0.0f);
    level.tiles.clear();
}

void find_tiles(const PressLevel& fine, PressLevel& coarse) {
    const std::ptrdiff_t across = coarse.grid.stride / 8;
    for (const Tile& tile : fine.tiles)
        coarse.marked[static_cast<std::size_t>((tile.j >> 1) * across + (tile.i >> 4))] = 1;
    for (const Tile& tile : fine.tiles) { // rows come in order: those of two fine ones are merged by the marks
        const std::size_t mark = static_cast<std::size_t>((tile.j >> 1) * across + (tile.i >> 4));
        if (!coarse.marked[mark]) continue;
        coarse.marked[mark] = 0;
        const int i = (tile.i >> 4) * 8, j = tile.j >> 1;
        coarse.tiles.push_back({i, j, coarse.grid.at(i, j)});
    }
}

// A coarse face's weight is that of the two fine ones that it is made of, over twice the distance.
void coarsen(const PressLevel& fine, PressLevel& coarse) {
    for (const Tile& tile : coarse.tiles)
        for (int k = 0; k < 8; ++k) {
            const std::ptrdiff_t at = tile.at + k;
            const std::ptrdiff_t a = fine.grid.at(2 * (tile.i + k), 2 * tile.j), c = a + fine.grid.stride;
            coarse.left[at] = 0.5f * (fine.left[a] + fine.left[c]);
            coarse.right[at] = 0.5f * (fine.right[a + 1] + fine.right[c + 1]);
            coarse.below[at] = 0.5f * (fine.below[a] + fine.below[a + 1]);
            coarse.above[at] = 0.5f * (fine.above[c] + fine.above[c + 1]);
            coarse.drain[at] =
                kCoarseDrain * ((fine.drain[a] + fine.drain[a + 1]) + (fine.drain[c] + fine.drain[c + 1]));
            const float total =
                coarse.left[at] + coarse.right[at] + coarse.below[at] + coarse.above[at] + coarse.drain[at];
            coarse.total[at] = total;
            coarse.inverse[at] = total > 0.0f ? 1.0f / total : 0.0f;
        }
}

} // namespace

PushOf push_of(const Rider& rider, std::span<const Reach> reaches, const float* pressure) {
    PushOf sum;
    for (std::uint32_t k = rider.first; k < rider.last; ++k) {
        const double p = double(pressure[reaches[k].at]);
        sum.x += p * double(reaches[k].x), sum.y += p * double(reaches[k].y), sum.turn += p * double(reaches[k].turn);
    }
    return sum;
}

PressView PressLevel::view() {
    return {grid.stride,  tiles.data(), tiles.size(),   left.data(), right.data(), below.data(),
            above.data(), total.data(), inverse.data(), z.data(),    b.data()};
}

void Press::lay_out(const Grid& grid) {
    levels_.clear();
    Grid now = grid;
    while (true) {
        PressLevel& level = levels_.emplace_back();
        level.grid = now;
        for (Field* field : {&level.left, &level.right, &level.below, &level.above, &level.drain, &level.total,
                             &level.inverse, &level.z, &level.b})
            field->lay_out(now);
        level.marked.assign(static_cast<std::size_t>(now.stride / 8 * (now.ny + 2)), 0);
        if (std::max(now.nx, now.ny) <= kCoarsest) break;
        const int nx = (now.nx + 1) / 2, wide = std::max(now.stride / 2, nx + 2);
        now = {nx, (now.ny + 1) / 2, (wide + 15) / 16 * 16, grid.low,
               2.0f * now.h}; // a tile's sixteen cells are in one row
    }
    search_.lay_out(grid), image_.lay_out(grid);
    pocket_of_.assign(static_cast<std::size_t>(grid.stride * (grid.ny + 1)), 0);
}

void Press::begin() {
    for (const Tile& tile : levels_[0].tiles) std::fill_n(search_.data() + tile.at, 8, 0.0f);
    for (PressLevel& level : levels_) clear_tiles(level);
}

void Press::finish(InstructionSet) {
    find_pockets();
    for (std::size_t k = 1; k < levels_.size(); ++k) {
        find_tiles(levels_[k - 1], levels_[k]);
        coarsen(levels_[k - 1], levels_[k]);
    }
}

void Press::find_pockets() {
    const PressLevel& fine = levels_[0];
    joined_.clear();
    auto first_of = [&](std::int32_t pocket) {
        while (joined_[static_cast<std::size_t>(pocket)] != pocket) pocket = joined_[static_cast<std::size_t>(pocket)];
        return pocket;
    };
    auto join = [&](std::int32_t a, std::int32_t b) {
        a = first_of(a), b = first_of(b);
        joined_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        return std::min(a, b);
    };
    auto each_cell = [&](auto visit) {
        for (const Tile& tile : fine.tiles)
            for (std::ptrdiff_t at = tile.at; at < tile.at + 8; ++at)
                if (fine.inverse[at] > 0.0f) visit(at, pocket_of_[static_cast<std::size_t>(at)]);
    };
    each_cell([&](std::ptrdiff_t at, std::int32_t& mine) {
        const bool left = fine.left[at] > 0.0f, below = fine.below[at] > 0.0f;
        if (left) mine = pocket_of_[static_cast<std::size_t>(at - 1)];
        if (below) {
            const std::int32_t other = pocket_of_[static_cast<std::size_t>(at - fine.grid.stride)];
            mine = left && mine != other ? join(mine, other) : other;
        }
        if (left || below) return;
        mine = static_cast<std::int32_t>(joined_.size());
        joined_.push_back(mine);
    });
    for (std::size_t k = 0; k < joined_.size(); ++k) joined_[k] = joined_[static_cast<std::size_t>(joined_[k])];
    pockets_.assign(joined_.size(), {});
    each_cell([&](std::ptrdiff_t at, std::int32_t& mine) {
        mine = joined_[static_cast<std::size_t>(mine)];
        Pocket& pocket = pockets_[static_cast<std::size_t>(mine)];
        pocket.cells += 1.0f;
        pocket.drained = pocket.drained || fine.drain[at] > 0.0f;
    });
    any_closed_ = std::ranges::any_of(pockets_, [](const Pocket& p) { return p.cells > 0.0f && !p.drained; });
}

void Press::balance(const Field& b, const Riders& riders) {
    PressLevel& fine = levels_[0];
    for (const Tile& tile : fine.tiles)
        for (std::ptrdiff_t at = tile.at; at < tile.at + 8; ++at) fine.b[at] = fine.inverse[at] > 0.0f ? b[at] : 0.0f;
    if (!any_closed_) return;
    join_pockets(riders);
    auto each_stiff = [&](auto visit) {
        for (const Tile& tile : fine.tiles)
            for (std::ptrdiff_t at = tile.at; at < tile.at + 8; ++at) {
                if (fine.inverse[at] == 0.0f) continue;
                Pocket& all = pockets_[whole(pocket_of_[static_cast<std::size_t>(at)])];
                if (!all.gives_way) visit(fine.b[at], all);
            }
    };
    each_stiff([](const float& value, Pocket& all) { all.sum += value, all.cells_in_all += 1.0f; });
    each_stiff([](float& value, const Pocket& all) { value -= all.sum / all.cells_in_all; });
}

std::size_t Press::whole(std::int32_t pocket) const {
    while (pockets_[static_cast<std::size_t>(pocket)].part_of != pocket)
        pocket = pockets_[static_cast<std::size_t>(pocket)].part_of;
    return static_cast<std::size_t>(pocket);
}

// A body that closed pockets press on from several sides makes one of them: what it gives one it takes from another. They give
// way if it gives way to them all, as a piston does below air. One that swims leaves their room as it is, and so does one
// that is held.
void Press::join_pockets(const Riders& riders) {
    for (std::size_t k = 0; k < pockets_.size(); ++k) {
        Pocket& pocket = pockets_[k];
        pocket.part_of = static_cast<std::int32_t>(k);
        pocket.sum = pocket.cells_in_all = 0.0f, pocket.gives_way = pocket.drained;
    }
    for (const Rider& rider : riders.all) {
        if (!rider.free) continue;
        auto give = [&](Vec2 way) {
            const Vec2 free = way - dot(rider.stop, way) * rider.stop;
            return std::abs(free.x) + std::abs(free.y);
        };
        auto each_pocket = [&](auto visit) {
            for (const Reach& reach : riders.reaches.subspan(rider.first, rider.last - rider.first))
                if (levels_[0].inverse[reach.at] > 0.0f) { // it has a pocket
                    const std::int32_t number = pocket_of_[static_cast<std::size_t>(reach.at)];
                    visit(number, pockets_[static_cast<std::size_t>(number)], reach);
                }
        };
        each_pocket([](std::int32_t, Pocket& pocket, const Reach& reach) { pocket.way += {reach.x, reach.y}; });
        Vec2 total;
        float parts = 0.0f;
        std::int32_t first = -1;
        each_pocket([&](std::int32_t number, Pocket& pocket, const Reach&) {
            if (!pocket.drained && give(pocket.way) > kGives) {
                const auto other = static_cast<std::int32_t>(whole(number));
                if (first < 0) first = other;
                const std::int32_t one = std::min(first, other);
                pockets_[static_cast<std::size_t>(first)].part_of = pockets_[static_cast<std::size_t>(other)].part_of =
                    one;
                first = one;
                total += pocket.way, parts += give(pocket.way);
            }
            pocket.way = {};
        });
        if (first >= 0 && give(total) > std::max(kGives, kGivesAll * parts))
            pockets_[static_cast<std::size_t>(first)].gives_way = true;
    }
    for (std::size_t k = 0; k < pockets_.size(); ++k) // of a part, before it was one
        if (pockets_[k].gives_way) pockets_[whole(static_cast<std::int32_t>(k))].gives_way = true;
}

void Press::cycle(std::size_t number, InstructionSet set) {
    const PressView fine = levels_[number].view();
    EVIL_PICK(set, press_start)(fine);
    EVIL_PICK(set, press_relax)(fine, 1);
    if (number + 1 == levels_.size()) {
        for (int sweep = 0; sweep < kCoarsestSweeps; ++sweep)
            EVIL_PICK(set, press_relax)(fine, 0), EVIL_PICK(set, press_relax)(fine, 1);
        for (int sweep = 0; sweep < kCoarsestSweeps; ++sweep)
            EVIL_PICK(set, press_relax)(fine, 1), EVIL_PICK(set, press_relax)(fine, 0);
    } else {
        const PressView coarse = levels_[number + 1].view();
        EVIL_PICK(set, press_restrict)(fine, coarse);
        cycle(number + 1, set);
        EVIL_PICK(set, press_prolong)(coarse, fine);
    }
    EVIL_PICK(set, press_relax)(fine, 1); // the same way back, so that the whole is symmetric
    EVIL_PICK(set, press_relax)(fine, 0);
}

void Press::add_riders(const Riders& riders, const float* p, float* result, double* energy) const {
    for (const Rider& rider : riders.all) {
        if (!rider.free) continue;
        const PushOf sum = push_of(rider, riders.reaches, p);
        const double stopped = double(rider.stop.x) * sum.x + double(rider.stop.y) * sum.y;
        const double x = double(rider.per_mass) * (sum.x - stopped * double(rider.stop.x));
        const double y = double(rider.per_mass) * (sum.y - stopped * double(rider.stop.y));
        const double turn = sum.turn * double(rider.per_inertia);
        *energy += sum.x * x + sum.y * y + sum.turn * turn;
        for (std::uint32_t k = rider.first; k < rider.last; ++k) {
            const Reach& reach = riders.reaches[k];
            result[reach.at] +=
                static_cast<float>(double(reach.x) * x + double(reach.y) * y + double(reach.turn) * turn);
        }
    }
}

int Press::solve(const Field& b, Field& p, const Riders& riders, float tolerance, int most_rounds, InstructionSet set) {
    PressLevel& fine = levels_[0];
    const PressView view = fine.view();
    double energy = 0.0;
    balance(b, riders);
    const float asked = EVIL_PICK(set, press_dot)(view, fine.b.data(), fine.b.data());
    EVIL_PICK(set, press_apply)(view, p.data(), image_.data());
    add_riders(riders, p.data(), image_.data(), &energy);
    float cells = 0.0f;
    for (const Pocket& pocket : pockets_) cells += pocket.cells;
    for (const Tile& tile : fine.tiles)
        for (std::ptrdiff_t at = tile.at; at < tile.at + 8; ++at)
            if (fine.inverse[at] > 0.0f) fine.b[at] -= image_[at];
    const float enough = std::max(tolerance * tolerance * asked, kSilent * kSilent * cells);
    float left = EVIL_PICK(set, press_dot)(view, fine.b.data(), fine.b.data()), before = 1.0f;
    if (left > asked) { // what was is farther off than nothing at all
        for (const Tile& tile : fine.tiles) std::fill_n(p.data() + tile.at, 8, 0.0f);
        balance(b, riders);
        left = asked;
    }
    int round = 0;
    for (; round < most_rounds && left > enough; ++round) {
        cycle(0, set);
        const float now = EVIL_PICK(set, press_dot)(view, fine.b.data(), fine.z.data());
        if (!(now > 0.0f)) break;
        EVIL_PICK(set, press_turn)(view, round == 0 ? 0.0f : now / before, search_.data());
        before = now;
        energy = double(EVIL_PICK(set, press_apply)(view, search_.data(), image_.data()));
        add_riders(riders, search_.data(), image_.data(), &energy);
        if (!(energy > 0.0)) break;
        left = EVIL_PICK(set, press_advance)(view, static_cast<float>(double(now) / energy), search_.data(),
                                             image_.data(), p.data());
    }
    if (left > kHopeless * asked) // there is none that would do, as in liquid that is shut in and squeezed
        for (const Tile& tile : fine.tiles) std::fill_n(p.data() + tile.at, 8, 0.0f);
    return round;
}

} // namespace evil::fluid
