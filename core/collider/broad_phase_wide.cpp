#include "collider/broad_phase_wide.hpp"
#include "math/wide.hpp"

namespace evil::EVIL_ISA {
namespace {

// The first entry from `from` on whose cell is not below `cell`: steps that double, then halves.
EVIL_INLINE std::size_t seek(const GridView& g, std::size_t from, std::uint64_t cell) {
    std::size_t step = 1, low = from;
    while (low + step < g.count && g.cells[low + step] < cell) {
        low += step;
        step *= 2;
    }
    std::size_t high = low + step < g.count ? low + step : g.count;
    while (low < high) {
        std::size_t middle = (low + high) / 2;
        if (g.cells[middle] < cell)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

struct Seeker { // an entry whose partners are looked for
    Floats low_x, low_y, high_x, high_y;
    std::uint32_t piece, owner;
};

EVIL_INLINE Seeker seeker(const GridView& g, std::size_t i) {
    return {g.low_x[i], g.low_y[i], g.high_x[i], g.high_y[i], g.pieces[i], g.owners[i]};
}

EVIL_INLINE void add(FoundPairs& found, const Seeker& e, std::uint32_t piece, std::uint32_t owner) {
    if (((e.owner ^ owner) & ~kSeekingOwner) == 0 || ((e.owner | owner) & kSeekingOwner) == 0) return;
    std::uint64_t a = e.piece < piece ? e.piece : piece, b = e.piece < piece ? piece : e.piece;
    found.list[found.count++] = a << 32 | b;
}

EVIL_INLINE void test_run(const GridView& g, const Seeker& e, std::size_t first, std::size_t last, FoundPairs& found) {
    for (std::size_t j = first; j < last; j += kLanes) {
        Mask meet = (load(g.low_x + j) <= e.high_x) & (load(g.high_x + j) >= e.low_x) &
                    (load(g.low_y + j) <= e.high_y) & (load(g.high_y + j) >= e.low_y);
        unsigned hits = bits(meet);
        if (last - j < kLanes) hits &= (1u << (last - j)) - 1u;
        for (std::size_t k = j; hits != 0; hits >>= 1, ++k)
            if (hits & 1u) add(found, e, g.pieces[k], g.owners[k]);
    }
}

// Cells of the grid that may hold what touches [low, high]: by their middles, entries lie within half a cell of it.
EVIL_INLINE bool cell_range(double low, double high, double origin, double per_metre, std::int64_t cells,
                            std::int64_t& first, std::int64_t& last) {
    double most = static_cast<double>(cells - 1);
    double from = (low - origin) * per_metre - 0.5, to = (high - origin) * per_metre + 0.5;
    if (!(to >= 0.0) || !(from <= most + 1.0)) return false;
    first = from > 0.0 ? static_cast<std::int64_t>(from) : 0;
    last = to < most ? static_cast<std::int64_t>(to) : cells - 1;
    return first <= last;
}

} // namespace

std::size_t pair_within(const GridView& g, std::size_t first, std::size_t last, FoundPairs& found) noexcept {
    if (first >= last) return first;
    const std::uint64_t up = std::uint64_t{1} << g.column_bits;
    std::size_t right = first, above = seek(g, first, g.cells[first] + up - 1), above_end = above;
    std::uint64_t cell = ~g.cells[first];
    for (std::size_t i = first; i < last; ++i) {
        if (g.cells[i] != cell) { // rows are met in order, so markers into this and the next only move on
            cell = g.cells[i];
            while (right < g.count && g.cells[right] <= cell + 1) ++right;
            while (above < g.count && g.cells[above] < cell + up - 1) ++above;
            if (above_end < above) above_end = above;
            while (above_end < g.count && g.cells[above_end] <= cell + up + 1) ++above_end;
        }
        if (found.count + (right - i) + (above_end - above) > found.capacity) return i;
        Seeker e = seeker(g, i);
        test_run(g, e, i + 1, right, found);
        test_run(g, e, above, above_end, found);
    }
    return last;
}

std::size_t pair_across(const GridView& from, const GridView& g, std::size_t first, std::size_t last,
                        FoundPairs& found) noexcept {
    const std::uint64_t columns = (std::uint64_t{1} << g.column_bits) - 1;
    for (std::size_t i = first; i < last; ++i) {
        std::int64_t c0, c1, r0, r1;
        if (!cell_range(from.low_x[i], from.high_x[i], g.origin_x, g.per_metre, g.columns, c0, c1) ||
            !cell_range(from.low_y[i], from.high_y[i], g.origin_y, g.per_metre, g.rows, r0, r1))
            continue;
        auto left = static_cast<std::uint64_t>(c0 + 1), right = static_cast<std::uint64_t>(c1 + 1);
        auto row = static_cast<std::uint64_t>(r0);
        const std::size_t before = found.count;
        Seeker e = seeker(from, i);
        for (std::size_t at = seek(g, 0, row << g.column_bits | left); at < g.count;) {
            row = g.cells[at] >> g.column_bits;
            if (row > static_cast<std::uint64_t>(r1)) break;
            if ((g.cells[at] & columns) < left) {
                at = seek(g, at, row << g.column_bits | left);
                continue;
            }
            std::size_t end = seek(g, at, (row << g.column_bits | right) + 1);
            if (found.count + (end - at) > found.capacity) {
                found.count = before;
                return i;
            }
            test_run(g, e, at, end, found);
            at = seek(g, end, (row + 1) << g.column_bits | left);
        }
    }
    return last;
}

} // namespace evil::EVIL_ISA
