#include "collider/broad_phase.hpp"
#include "collider/broad_phase_wide.hpp"
#include <bit>

namespace evil {

Bounds bounds_of(const Shapes& shapes, const Piece& piece, const Pose& pose) {
    Vec2 r{piece.radius, piece.radius};
    if (piece.count == 0) {
        Vec2 centre = transform(pose, piece.centre);
        return {centre - r, centre + r};
    }
    std::span<const Vec2> points = points_of(shapes, piece);
    Vec2 low = transform(pose, points[0]), high = low;
    for (Vec2 local : points.subspan(1)) {
        Vec2 p = transform(pose, local);
        low = min(low, p);
        high = max(high, p);
    }
    return {low - r, high + r};
}

namespace {

constexpr std::int32_t kLeastOctave = -16, kOctaves = 48; // 2^-16 to 2^32 metres; smaller and larger go with the last
constexpr std::size_t kLanes = 8;
constexpr std::size_t kGrain = 512;     // entries a chunk
constexpr double kCellSlack = 1.0 / 64; // of a cell: more than the middles' rounding
constexpr float kLeastCell = 1e-3f; // metres: at the edge of the world, floats are so far apart that bounds are points
constexpr std::uint32_t kDigitBits = 11; // of a pass of the sort: its counts stay in the nearest cache

std::size_t octave_of(std::int32_t octave) {
    return static_cast<std::size_t>(std::clamp(octave - kLeastOctave, 0, kOctaves - 1));
}

// Octaves of size in pairs of neighbours, the most populous first: what is alike lies in one grid.
void choose_grids(BroadPhase& broad, const Placements& placed, std::size_t (&grid_of)[kOctaves]) {
    std::size_t population[kOctaves] = {};
    for (std::int32_t octave : placed.octaves)
        if (octave != kNoOctave) ++population[octave_of(octave)];
    broad.used = 0;
    while (true) {
        std::size_t most = 0;
        for (std::size_t o = 1; o < kOctaves; ++o)
            if (population[o] > population[most]) most = o;
        if (population[most] == 0) return;
        std::size_t below = most > 0 ? population[most - 1] : 0, above = most + 1 < kOctaves ? population[most + 1] : 0;
        bool grows = above > below && 2 * above > population[most]; // a few larger ones would make wide cells for all
        std::size_t beside = grows ? most + 1 : most - 1;
        grid_of[most] = broad.used;
        population[most] = 0;
        if (grows || below > 0) {
            grid_of[beside] = broad.used;
            population[beside] = 0;
        }
        ++broad.used;
    }
}

void deal_out(BroadPhase& broad, const Placements& placed) {
    std::size_t grid_of[kOctaves];
    choose_grids(broad, placed, grid_of);
    if (broad.grids.size() < broad.used) broad.grids.resize(broad.used), broad.members.resize(broad.used);
    for (auto& members : broad.members) members.clear();
    for (std::uint32_t p = 0; p < placed.octaves.size(); ++p)
        if (placed.octaves[p] != kNoOctave) broad.members[grid_of[octave_of(placed.octaves[p])]].push_back(p);
}

// The plane that the middles of the bounds span, in cells.
void lay_out(Grid& grid, const Placements& placed, std::span<const std::uint32_t> members) {
    double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;
    grid.widest = 0.0f;
    for (std::uint32_t p : members) {
        double x = 0.5 * (double(placed.low_x[p]) + double(placed.high_x[p]));
        double y = 0.5 * (double(placed.low_y[p]) + double(placed.high_y[p]));
        low_x = std::min(low_x, x), high_x = std::max(high_x, x);
        low_y = std::min(low_y, y), high_y = std::max(high_y, y);
        float width = placed.high_x[p] - placed.low_x[p], height = placed.high_y[p] - placed.low_y[p];
        grid.widest = std::max(grid.widest, std::max(width, height));
    }
    grid.widest = std::max(grid.widest, kLeastCell);
    grid.origin_x = low_x;
    grid.origin_y = low_y;
    grid.cell = double(grid.widest) * (1.0 + kCellSlack);
    grid.per_metre = 1.0 / grid.cell;
    grid.columns = static_cast<std::int64_t>((high_x - low_x) * grid.per_metre) + 1;
    grid.rows = static_cast<std::int64_t>((high_y - low_y) * grid.per_metre) + 1;
    grid.column_bits = static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(grid.columns + 1)));
}

void number_cells(BroadPhase& broad, const Grid& grid, const Placements& placed,
                  std::span<const std::uint32_t> members) {
    broad.items.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
        std::uint32_t p = members[i];
        double x = 0.5 * (double(placed.low_x[p]) + double(placed.high_x[p])) - grid.origin_x;
        double y = 0.5 * (double(placed.low_y[p]) + double(placed.high_y[p])) - grid.origin_y;
        auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x * grid.per_metre) + 1);
        auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(y * grid.per_metre));
        broad.items[i] = {row << grid.column_bits | column, p};
    }
}

// Radix sort, lowest digit first, as many equal digits as the highest cell number takes.
void sort_items(BroadPhase& broad, std::uint64_t highest) {
    auto bits = static_cast<std::uint32_t>(std::bit_width(highest));
    std::uint32_t passes = (bits + kDigitBits - 1) / kDigitBits, digit = passes > 0 ? (bits + passes - 1) / passes : 0;
    broad.spare.resize(broad.items.size());
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
        std::uint32_t shift = pass * digit;
        std::uint64_t mask = (std::uint64_t{1} << digit) - 1;
        broad.counts.assign(mask + 2, 0);
        for (const auto& item : broad.items) ++broad.counts[(item.cell >> shift & mask) + 1];
        for (std::size_t i = 1; i < broad.counts.size(); ++i) broad.counts[i] += broad.counts[i - 1];
        for (const auto& item : broad.items) broad.spare[broad.counts[item.cell >> shift & mask]++] = item;
        std::swap(broad.items, broad.spare);
    }
}

void fill(Grid& grid, const Placements& placed, std::span<const BroadPhase::Item> items) {
    std::size_t n = items.size();
    grid.cells.resize(n);
    grid.pieces.resize(n);
    grid.owners.resize(n);
    for (auto* side : {&grid.low_x, &grid.low_y, &grid.high_x, &grid.high_y}) side->resize(n + kLanes);
    for (std::size_t i = 0; i < n; ++i) {
        std::uint32_t p = items[i].piece, body = placed.bodies[p];
        grid.cells[i] = items[i].cell;
        grid.pieces[i] = p;
        grid.owners[i] = body | (placed.kinds[p] & kSeeks ? kSeekingOwner : 0u);
        grid.low_x[i] = placed.low_x[p];
        grid.low_y[i] = placed.low_y[p];
        grid.high_x[i] = placed.high_x[p];
        grid.high_y[i] = placed.high_y[p];
    }
}

GridView view(const Grid& g) {
    return {g.cells.data(),  g.low_x.data(),  g.low_y.data(), g.high_x.data(), g.high_y.data(),
            g.pieces.data(), g.owners.data(), g.cells.size(), g.column_bits,   g.origin_x,
            g.origin_y,      g.per_metre,     g.columns,      g.rows};
}

// Calls find(first, last, found) until it is through, with a list that grows.
template <class Find>
void find_all(std::vector<std::uint64_t>& list, std::size_t& count, std::size_t first, std::size_t last, Find&& find) {
    FoundPairs found{list.data(), 0, list.size()};
    while (true) {
        first = find(first, last, found);
        if (first >= last) break;
        list.resize(std::max<std::size_t>(4096, 2 * list.size()));
        found.list = list.data();
        found.capacity = list.size();
    }
    count = found.count;
}

// In chunks of its own lists, from list `next` on; the next free one.
template <class Find>
std::size_t find_in_chunks(BroadPhase& broad, std::size_t next, std::size_t count, Threads& threads, Find&& find) {
    std::size_t chunks = (count + kGrain - 1) / kGrain;
    if (broad.found.size() < next + chunks) broad.found.resize(next + chunks);
    broad.found_counts.resize(next + chunks);
    parallel_for(threads, count, kGrain, [&](std::size_t first, std::size_t last) {
        std::size_t mine = next + first / kGrain;
        find_all(broad.found[mine], broad.found_counts[mine], first, last, find);
    });
    return next + chunks;
}

std::size_t find_within(BroadPhase& broad, InstructionSet set, Threads& threads) {
    auto within = EVIL_PICK(set, pair_within);
    std::size_t next = 0;
    for (std::size_t g = 0; g < broad.used; ++g) {
        GridView grid = view(broad.grids[g]);
        next = find_in_chunks(
            broad, next, grid.count, threads,
            [&](std::size_t first, std::size_t last, FoundPairs& found) { return within(grid, first, last, found); });
    }
    return next;
}

// Rows of cells that one grid's entries would look at in the other.
double work(const Grid& from, const Grid& in) {
    return static_cast<double>(from.cells.size()) * (double(from.widest) / in.cell + 2.0);
}

std::size_t find_across(BroadPhase& broad, std::size_t next, InstructionSet set, Threads& threads) {
    auto across = EVIL_PICK(set, pair_across);
    for (std::size_t g = 0; g < broad.used; ++g) {
        for (std::size_t h = g + 1; h < broad.used; ++h) {
            bool turned = work(broad.grids[h], broad.grids[g]) < work(broad.grids[g], broad.grids[h]);
            GridView from = view(broad.grids[turned ? h : g]), in = view(broad.grids[turned ? g : h]);
            next = find_in_chunks(broad, next, from.count, threads,
                                  [&](std::size_t first, std::size_t last, FoundPairs& found) {
                                      return across(from, in, first, last, found);
                                  });
        }
    }
    return next;
}

void drop_kept_apart(BroadPhase& broad, const Placements& placed, std::size_t first, std::size_t last) {
    for (std::size_t chunk = first; chunk < last; ++chunk) {
        auto begin = broad.found[chunk].begin(), end = begin + static_cast<std::ptrdiff_t>(broad.found_counts[chunk]);
        end = std::remove_if(begin, end, [&](std::uint64_t pair) {
            return kept_apart(placed, static_cast<std::uint32_t>(pair >> 32), static_cast<std::uint32_t>(pair));
        });
        broad.found_counts[chunk] = static_cast<std::size_t>(end - begin);
    }
}

// Counting sort by the second piece, then by the first.
void sort_pairs(BroadPhase& broad, std::size_t chunks, std::size_t pieces, std::vector<Pair>& pairs) {
    auto &by_first = broad.by_first, &by_second = broad.by_second;
    by_first.assign(pieces + 1, 0);
    by_second.assign(pieces + 1, 0);
    auto each = [&](auto&& visit) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
            for (std::uint64_t pair : std::span(broad.found[chunk]).first(broad.found_counts[chunk]))
                visit(static_cast<std::uint32_t>(pair >> 32), static_cast<std::uint32_t>(pair));
    };
    each([&](std::uint32_t a, std::uint32_t b) {
        ++by_first[a + 1];
        ++by_second[b + 1];
    });
    for (std::size_t i = 0; i < pieces; ++i) {
        by_first[i + 1] += by_first[i];
        by_second[i + 1] += by_second[i];
    }
    broad.sorted.resize(by_first[pieces]);
    pairs.resize(by_first[pieces]);
    each([&](std::uint32_t a, std::uint32_t b) { broad.sorted[by_second[b]++] = {a, b}; });
    for (Pair pair : broad.sorted) pairs[by_first[pair.a]++] = pair;
}

// How many chunks of pairs have been found, those within the grids first.
struct Chunks {
    std::size_t within, all;
};

Chunks find_overlaps(BroadPhase& broad, const Placements& placed, InstructionSet set, Threads& threads) {
    deal_out(broad, placed);
    for (std::size_t g = 0; g < broad.used; ++g) {
        Grid& grid = broad.grids[g];
        lay_out(grid, placed, broad.members[g]);
        number_cells(broad, grid, placed, broad.members[g]);
        sort_items(broad, static_cast<std::uint64_t>(grid.rows) << grid.column_bits);
        fill(grid, placed, broad.items);
    }
    std::size_t within = find_within(broad, set, threads);
    return {within, find_across(broad, within, set, threads)};
}

} // namespace

bool find_pairs(BroadPhase& broad, const Placements& placed, std::vector<Pair>& pairs, InstructionSet set,
                Threads& threads) {
    Candidates& near = broad.candidates;
    std::size_t pieces = placed.octaves.size();
    if (still_good(near, placed, set, threads)) return meeting_pairs(near, placed, pairs, set, threads);
    if (!worth_keeping(near)) {
        Chunks chunks = find_overlaps(broad, placed, set, threads);
        drop_kept_apart(broad, placed, chunks.within, chunks.all);
        sort_pairs(broad, chunks.all, pieces, pairs);
        return true;
    }
    Chunks chunks = find_overlaps(broad, grow(near, placed), set, threads);
    sort_pairs(broad, chunks.all, pieces, pairs);
    keep(near, pairs);
    (void)still_good(near, placed, set, threads);
    (void)meeting_pairs(near, placed, pairs, set, threads);
    return true;
}

} // namespace evil
