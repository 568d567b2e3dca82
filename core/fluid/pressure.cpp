#include "fluid/pressure.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

constexpr int kLane = 8;
constexpr int kCoarsest = 4;         // cells each way that sweeps alone solve well
constexpr int kSweeps = 2;           // before and after each visit to a coarser level
constexpr int kCoarsestSweeps = 16;  // leave nothing of 4 x 4 cells
constexpr int kRows = 16;            // that a thread takes at a time
static_assert(kRows >= 4 * kSweeps); // bands that get wider must not meet
constexpr int kWorthThreads = 96;    // rows from which on several threads are faster than one
constexpr float kNearest = 0.125f;   // cells: an edge that is nearer to a coarse cell's middle, or before it, counts so

void weigh(Level& level, int i, int j) { // one cell, from its faces
    const int colour = (i + j) & 1;
    const std::ptrdiff_t at = j * level.stride + i / 2;
    const std::array<float, 4> w = {level.across[level.face(i, j)], level.across[level.face(i + 1, j)],
                                    level.up[level.face(i, j)], level.up[level.face(i, j + 1)]};
    float sum = level.drain[level.face(i, j)];
    for (std::size_t d = 0; d < 4; ++d) sum += level.weight[colour][d][at] = w[d];
    level.diagonal[colour][at] = sum;
    level.inverse[colour][at] = sum > 0.0f ? 1.0f / sum : 0.0f;
}

void find_plain(Level& level, int j, int first, int last) { // tiles
    for (std::size_t colour = 0; colour < 2; ++colour)
        for (int t = first; t < last; ++t) {
            bool plain = (t + 1) * kLane <= level.half;
            for (int k = t * kLane; plain && k < (t + 1) * kLane; ++k) {
                const std::ptrdiff_t at = j * level.stride + k;
                for (const float* w : level.weight[colour]) plain = plain && w[at] == 1.0f;
                plain = plain && level.diagonal[colour][at] == 4.0f;
            }
            level.plain[colour][static_cast<std::size_t>(j * level.tiles + t)] = plain;
        }
}

bool is_solid(const Level& level, int i, int j) { return level.inverse[(i + j) & 1][j * level.stride + i / 2] == 0.0f; }

// The four beside it, or else the four at its corners.
void find_lenders(Level& level, int i, int j) {
    if (!is_solid(level, i, j)) return;
    Level::Borrower one{
        static_cast<std::uint8_t>((i + j) & 1), 0, static_cast<std::int32_t>(j * level.stride + i / 2), {}, {}};
    for (bool diagonal : {false, true}) {
        for (int k = 0; k < 4 && (one.count == 0 || !diagonal || k > 0); ++k) {
            const int dx = diagonal ? (k & 1 ? 1 : -1) : (k < 2 ? 2 * k - 1 : 0);
            const int dy = diagonal ? (k & 2 ? 1 : -1) : (k < 2 ? 0 : 2 * k - 5);
            const int x = i + dx, y = j + dy;
            if (x < 0 || y < 0 || x >= level.nx || y >= level.ny || is_solid(level, x, y)) continue;
            one.colours[one.count] = static_cast<std::uint8_t>((x + y) & 1);
            one.lenders[one.count++] = static_cast<std::int32_t>(y * level.stride + x / 2);
        }
        if (one.count > 0) break;
    }
    if (one.count > 0) level.borrowers.push_back(one);
}

void lend(Level& level) {
    for (const Level::Borrower& one : level.borrowers) {
        float sum = 0.0f;
        for (std::size_t k = 0; k < one.count; ++k) sum += level.p[one.colours[k]][one.lenders[k]];
        level.p[one.colour][one.at] = sum / static_cast<float>(one.count);
    }
}

// Cells whose faces changed, with those beside them.
void weigh_patch(Level& level, const Patch& patch) {
    const int left = std::max(patch.left - 1, 0), low = std::max(patch.low - 1, 0);
    const int right = std::min(patch.right + 1, level.nx), high = std::min(patch.high + 1, level.ny);
    for (int j = low; j < high; ++j) {
        for (int i = left; i < right; ++i) weigh(level, i, j);
        find_plain(level, j, left / (2 * kLane), (right + 2 * kLane - 1) / (2 * kLane));
    }
}

void find_borrowers(Level& level) {
    level.borrowers.clear();
    for (int j = 0; j < level.ny; ++j)
        for (int t = 0; t < level.tiles; ++t) {
            const std::size_t tile = static_cast<std::size_t>(j * level.tiles + t);
            if (level.plain[0][tile] && level.plain[1][tile]) continue;
            for (int i = 2 * t * kLane; i < std::min(2 * (t + 1) * kLane, level.nx); ++i) find_lenders(level, i, j);
        }
}

// A coarse face is as open as the two that it is made of, on average; what drains from four cells drains at twice the
// distance, so half of it counts. Where an odd grid ends inside the last coarse cells, an open edge is nearer than that,
// or even before their middle, and then so is what lies before them: else corrections would overshoot, more on each
// level, and the cycles would diverge.
void coarsen(const Level& fine, Level& coarse, const Patch& patch) {
    auto across = [&](int i, int j) { return i <= fine.nx && j < fine.ny ? fine.across[fine.face(i, j)] : 0.0f; };
    auto up = [&](int i, int j) { return i < fine.nx && j <= fine.ny ? fine.up[fine.face(i, j)] : 0.0f; };
    auto drain = [&](int i, int j) { return i < fine.nx && j < fine.ny ? fine.drain[fine.face(i, j)] : 0.0f; };
    auto nearer = [](float before, float now) { return std::max(before, kNearest) / std::max(now, kNearest); };
    auto shorter = [](float before, float now) {
        return now < 0.0f ? (1.0f + std::min(before, 0.0f)) / (1.0f + now) : 1.0f;
    };
    const float link_up = shorter(fine.top, coarse.top), link_across = shorter(fine.right, coarse.right);
    const int last_row = fine.ny / 2 - 1, last_column = fine.nx / 2 - 1;
    for (int j = patch.low; j <= std::min(patch.high, coarse.ny); ++j)
        for (int i = patch.left; i <= std::min(patch.right, coarse.nx); ++i) {
            const std::size_t at = coarse.face(i, j);
            const bool at_right = i == last_column, at_top = j == last_row;
            coarse.across[at] = j < coarse.ny ? 0.5f * (across(2 * i, 2 * j) + across(2 * i, 2 * j + 1)) : 0.0f;
            coarse.up[at] = i < coarse.nx ? 0.5f * (up(2 * i, 2 * j) + up(2 * i + 1, 2 * j)) : 0.0f;
            if (at_right) coarse.across[at] *= link_across;
            if (at_top) coarse.up[at] *= link_up;
            const float near =
                (at_top ? nearer(fine.top, coarse.top) : 1.0f) * (at_right ? nearer(fine.right, coarse.right) : 1.0f);
            coarse.drain[at] = 0.5f * near *
                               (drain(2 * i, 2 * j) + drain(2 * i + 1, 2 * j) +
                                (drain(2 * i, 2 * j + 1) + drain(2 * i + 1, 2 * j + 1)));
        }
}

} // namespace

void Level::lay_out(int wide, int high) {
    nx = (wide + 1) / 2 * 2, ny = (high + 1) / 2 * 2;
    half = nx / 2, tiles = (half + kLane - 1) / kLane;
    stride = tiles * kLane + 2 * kLane; // the rim of a row's end is that of the next one's beginning, too
    const std::size_t size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(ny + 2) + 2 * kLane;
    room.assign(16 * size, 0.0f);
    float* next = room.data() + stride + kLane;
    auto take = [&] {
        float* mine = next;
        next += size;
        return mine;
    };
    for (std::size_t colour = 0; colour < 2; ++colour) {
        p[colour] = take(), b[colour] = take(), diagonal[colour] = take(), inverse[colour] = take();
        for (float*& w : weight[colour]) w = take();
        plain[colour].assign(static_cast<std::size_t>(tiles * ny), 0);
    }
    const std::size_t faces = static_cast<std::size_t>(nx + 1) * static_cast<std::size_t>(ny + 1);
    across.assign(faces, 0.0f), up.assign(faces, 0.0f), drain.assign(faces, 0.0f);
}

LevelView Level::view() const {
    LevelView v{half,
                ny,
                tiles,
                stride,
                {p[0], p[1]},
                {b[0], b[1]},
                {},
                {diagonal[0], diagonal[1]},
                {inverse[0], inverse[1]},
                {plain[0].data(), plain[1].data()}};
    for (std::size_t colour = 0; colour < 2; ++colour)
        for (std::size_t d = 0; d < 4; ++d) v.weight[colour][d] = weight[colour][d];
    return v;
}

void Pressure::lay_out(const Grid& grid, const std::array<bool, 4>& open) {
    levels_.clear();
    int nx = grid.nx, ny = grid.ny;
    float right = 0.5f, top = 0.5f;
    while (true) {
        Level& level = levels_.emplace_back();
        level.lay_out(nx, ny);
        level.right = right, level.top = top;
        if (std::max(nx, ny) <= kCoarsest) break;
        if (open[1]) right = 0.5f * (right + (nx % 2 == 0 ? 0.5f : -0.5f));
        if (open[3]) top = 0.5f * (top + (ny % 2 == 0 ? 0.5f : -0.5f));
        nx = level.nx / 2, ny = level.ny / 2;
    }
    for (std::size_t side = 0; side < 4; ++side) mirror_[side] = open[side] ? -1.0f : 1.0f;
    room_for_rows_ = 8 * static_cast<std::size_t>(levels_[0].stride + 4 * kLane);
    room_.assign(static_cast<std::size_t>(levels_[0].ny / 2 / kRows + 1) * room_for_rows_, 0.0f);
}

void Pressure::set_faces(const Grid& grid, const Field& across, const Field& up, std::span<const Patch> patches) {
    for (const Patch& patch : patches) set_patch(grid, across, up, patch);
    for (std::size_t level = 1; level < levels_.size(); ++level) find_borrowers(levels_[level]);
}

void Pressure::set_patch(const Grid& grid, const Field& across, const Field& up, const Patch& whole) {
    Patch patch = whole;
    Level& fine = levels_[0];
    auto side = [&](int i, int j, bool sideways) { // a face on an open side has no cell beyond: it drains
        const float share = sideways ? across[grid.at(i, j)] : up[grid.at(i, j)];
        return 2.0f * share; // the edge is half a cell away
    };
    for (int j = patch.low; j <= std::min(patch.high, grid.ny); ++j)
        for (int i = patch.left; i <= std::min(patch.right, grid.nx); ++i) {
            const std::size_t at = fine.face(i, j);
            fine.across[at] = j < grid.ny && i > 0 && i < grid.nx ? across[grid.at(i, j)] : 0.0f;
            fine.up[at] = i < grid.nx && j > 0 && j < grid.ny ? up[grid.at(i, j)] : 0.0f;
            float drain = 0.0f;
            if (i < grid.nx && j < grid.ny) {
                if (i == 0) drain += side(0, j, true);
                if (i == grid.nx - 1) drain += side(grid.nx, j, true);
                if (j == 0) drain += side(i, 0, false);
                if (j == grid.ny - 1) drain += side(i, grid.ny, false);
            }
            fine.drain[at] = drain;
        }
    weigh_patch(fine, patch);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        patch = {patch.left / 2, patch.low / 2, patch.right / 2 + 1, patch.high / 2 + 1};
        coarsen(levels_[level - 1], levels_[level], patch);
        weigh_patch(levels_[level], patch);
    }
}

void Pressure::smooth_level(const Level& level, int sweeps, InstructionSet set, Threads& threads) const {
    const LevelView view = level.view();
    const int passes = 2 * sweeps;
    if (!threads.has_crew() || level.ny < kWorthThreads)
        return EVIL_PICK(set, smooth)(view, passes, {0, level.ny, 0, 0});
    const int bands = level.ny / kRows;
    auto edge = [&](int band) { return band < bands ? band * kRows : level.ny; };
    auto each = [&](int first, auto visit) {
        parallel_for(threads, static_cast<std::size_t>(bands - first), 1,
                     [&](std::size_t at, std::size_t) { visit(first + static_cast<int>(at)); });
    };
    each(0, [&](int band) {
        const Band narrower{edge(band), edge(band + 1), band > 0 ? 1 : 0, band + 1 < bands ? -1 : 0};
        EVIL_PICK(set, smooth)(view, passes, narrower);
    });
    each(1, [&](int band) { EVIL_PICK(set, smooth)(view, passes, {edge(band), edge(band), -1, 1}); });
}

void Pressure::cycle(std::size_t number, InstructionSet set, Threads& threads) {
    const Level& level = levels_[number];
    if (number + 1 == levels_.size()) return smooth_level(level, kCoarsestSweeps, set, threads);
    const LevelView fine = level.view(), coarse = levels_[number + 1].view();
    // a coarse level may have a row more than the fine one fills: solid, and its b is 0
    auto each_row = [&](auto visit) {
        auto work = [&](std::size_t first, std::size_t last) {
            visit(static_cast<int>(first), static_cast<int>(last), room_.data() + first / kRows * room_for_rows_);
        };
        const auto rows = static_cast<std::size_t>(level.ny / 2);
        if (level.ny < kWorthThreads) return work(0, rows);
        parallel_for(threads, rows, kRows, work);
    };
    smooth_level(level, kSweeps, set, threads);
    each_row([&](int first, int last, float* room) { EVIL_PICK(set, restrict_rows)(fine, coarse, first, last, room); });
    cycle(number + 1, set, threads);
    lend(levels_[number + 1]);
    each_row([&](int first, int last, float* room) {
        EVIL_PICK(set, prolong_rows)(fine, coarse, mirror_.data(), first, last, room);
    });
    smooth_level(level, kSweeps, set, threads);
}

void Pressure::solve(const Grid& grid, const Field& b, Field& p, int cycles, InstructionSet set, Threads& threads) {
    Level& fine = levels_[0];
    auto each_row = [&](auto visit) {
        parallel_for(threads, static_cast<std::size_t>(grid.ny), kRows, [&](std::size_t first, std::size_t last) {
            for (int j = static_cast<int>(first); j < static_cast<int>(last); ++j)
                visit(grid.at(0, j), j * fine.stride, static_cast<std::size_t>(j & 1));
        });
    };
    each_row([&](std::ptrdiff_t row, std::ptrdiff_t at, std::size_t even) {
        EVIL_PICK(set, split_row)(b.data() + row, fine.half, fine.b[even] + at, fine.b[even ^ 1] + at);
        EVIL_PICK(set, split_row)(p.data() + row, fine.half, fine.p[even] + at, fine.p[even ^ 1] + at);
    });
    for (int k = 0; k < cycles; ++k) cycle(0, set, threads);
    each_row([&](std::ptrdiff_t row, std::ptrdiff_t at, std::size_t even) {
        EVIL_PICK(set, join_row)(fine.p[even] + at, fine.p[even ^ 1] + at, fine.half, p.data() + row);
    });
}

} // namespace evil::fluid
