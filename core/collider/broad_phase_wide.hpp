#pragma once
#include "math/cpu.hpp"
#include <cstddef>
#include <cstdint>

namespace evil {

inline constexpr std::uint32_t kSeekingOwner = 0x80000000u; // set in the owner of an entry that is dynamic or a sensor

// A grid's entries, sorted by cell: row << column_bits | column. Columns count from 1, and the last is not the last that
// would fit, so that the cells on either side of a column are in its row. Bounds may be read eight beyond the last.
struct GridView {
    const std::uint64_t* cells;
    const float *low_x, *low_y, *high_x, *high_y;
    const std::uint32_t *pieces, *owners;
    std::size_t count;
    std::uint32_t column_bits;
    double origin_x, origin_y; // metres
    double per_metre;          // cells; no entry's bounds are wider than one
    std::int64_t columns, rows;
};

struct FoundPairs { // lower piece << 32 | higher piece
    std::uint64_t* list;
    std::size_t count, capacity;
};

// Both go through entries first..last and stop early, at the entry that is returned, where the list might not hold what
// comes; called again with a longer list from there, they go on.
//
// Each entry with those after it in its own cell and the next, and with the three cells of the row above.
EVIL_WIDE(std::size_t pair_within(const GridView& grid, std::size_t first, std::size_t last,
                                  FoundPairs& found) noexcept;)
// Each entry of `from` with those of another grid.
EVIL_WIDE(std::size_t pair_across(const GridView& from, const GridView& grid, std::size_t first, std::size_t last,
                                  FoundPairs& found) noexcept;)

} // namespace evil
