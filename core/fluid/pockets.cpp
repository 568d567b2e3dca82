#include "fluid/pockets.hpp"
#include "fluid/flow_wide.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

constexpr int kTile = 16;         // cells of a tile of the pressure's
constexpr std::size_t kRows = 16; // that a thread takes at a time

} // namespace

void Pockets::find(const Openness& all, const Level& finest) {
    const auto ny = static_cast<std::size_t>(all.grid.ny);
    runs_.clear();
    rows_.resize(ny + 1);
    for (int j = 0; j < all.grid.ny; ++j) {
        rows_[static_cast<std::size_t>(j)] = runs_.size();
        find_runs(all, finest, j);
        rows_[static_cast<std::size_t>(j) + 1] = runs_.size();
        if (j > 0) join_rows(all, j);
    }
    pockets_.clear();
    for (std::uint32_t k = 0; k < runs_.size(); ++k) { // a root comes before the others
        Run& run = runs_[k];
        if (run.pocket == k) {
            run.pocket = static_cast<std::uint32_t>(pockets_.size());
            pockets_.emplace_back();
        } else {
            run.pocket = runs_[run.pocket].pocket;
        }
    }
    any_sealed_ = false;
    for (int j = 0; j < all.grid.ny; ++j)
        for (std::size_t k = rows_[static_cast<std::size_t>(j)]; k < rows_[static_cast<std::size_t>(j) + 1]; ++k) {
            Pocket& pocket = pockets_[runs_[k].pocket];
            pocket.cells += double(runs_[k].last - runs_[k].first);
            pocket.sealed = pocket.sealed && !leads_out(all, runs_[k], j);
        }
    for (const Pocket& pocket : pockets_) any_sealed_ = any_sealed_ || pocket.sealed;
    sums_.resize(runs_.size());
}

void Pockets::find_runs(const Openness& all, const Level& finest, int j) {
    const int nx = all.grid.nx;
    bool running = false;
    auto extend = [&](int first, int last, bool joined) {
        if (!joined) runs_.push_back({first, last, static_cast<std::uint32_t>(runs_.size())});
        runs_.back().last = last;
        running = true;
    };
    for (int t = 0; t < finest.tiles; ++t) {
        const auto tile = static_cast<std::size_t>(j * finest.tiles + t);
        const int first = kTile * t, last = std::min(first + kTile, nx);
        if (finest.plain[0][tile] && finest.plain[1][tile]) {
            extend(first, last, running);
            continue;
        }
        for (int i = first; i < last; ++i) {
            const std::ptrdiff_t at = all.grid.at(i, j);
            if (all.gas[at] > 0.0f)
                extend(i, i + 1, running && all.across[at] > 0.0f);
            else
                running = false;
        }
    }
}

// Runs of a row and of the one below it that an open face lies between.
void Pockets::join_rows(const Openness& all, int j) {
    const auto row = static_cast<std::size_t>(j);
    std::size_t below = rows_[row - 1], here = rows_[row];
    while (below < rows_[row] && here < rows_[row + 1]) {
        const Run &a = runs_[below], &b = runs_[here];
        const int first = std::max(a.first, b.first), last = std::min(a.last, b.last);
        for (int i = first; i < last; ++i) {
            if (!(all.up[all.grid.at(i, j)] > 0.0f)) continue;
            const std::uint32_t one = root(static_cast<std::uint32_t>(below)),
                                other = root(static_cast<std::uint32_t>(here));
            runs_[std::max(one, other)].pocket = std::min(one, other);
            break;
        }
        if (a.last <= b.last)
            ++below;
        else
            ++here;
    }
}

std::uint32_t Pockets::root(std::uint32_t run) {
    while (runs_[run].pocket != run) run = runs_[run].pocket = runs_[runs_[run].pocket].pocket;
    return run;
}

bool Pockets::leads_out(const Openness& all, const Run& run, int j) const {
    const Grid& g = all.grid;
    if (run.first == 0 && all.open[0] && all.across[g.at(0, j)] > 0.0f) return true;
    if (run.last == g.nx && all.open[1] && all.across[g.at(g.nx, j)] > 0.0f) return true;
    const bool bottom = j == 0 && all.open[2], top = j == g.ny - 1 && all.open[3];
    for (int i = run.first; i < run.last && (bottom || top); ++i) {
        if (bottom && all.up[g.at(i, 0)] > 0.0f) return true;
        if (top && all.up[g.at(i, g.ny)] > 0.0f) return true;
    }
    return false;
}

void Pockets::level(const Grid& grid, Field& field, InstructionSet set, Threads& threads) {
    if (!any_sealed_) return;
    auto each_run = [&](auto visit) {
        parallel_for(threads, rows_.size() - 1, kRows, [&](std::size_t first, std::size_t last) {
            for (std::size_t j = first; j < last; ++j)
                for (std::size_t k = rows_[j]; k < rows_[j + 1]; ++k)
                    if (pockets_[runs_[k].pocket].sealed)
                        visit(k, field.data() + grid.at(runs_[k].first, static_cast<int>(j)),
                              runs_[k].last - runs_[k].first);
        });
    };
    each_run([&](std::size_t k, const float* values, int count) { sums_[k] = EVIL_PICK(set, sum_of)(values, count); });
    for (Pocket& pocket : pockets_) pocket.sum = 0.0;
    for (std::size_t k = 0; k < runs_.size(); ++k) pockets_[runs_[k].pocket].sum += double(sums_[k]);
    each_run([&](std::size_t k, float* values, int count) {
        const Pocket& pocket = pockets_[runs_[k].pocket];
        EVIL_PICK(set, add_to_each)(values, count, static_cast<float>(-pocket.sum / pocket.cells));
    });
}

} // namespace evil::fluid
