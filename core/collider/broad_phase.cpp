#include "collider/broad_phase.hpp"

namespace evil {

Bounds bounds_of(const Shapes& shapes, const Piece& piece, const Pose& pose) {
    if (piece.count == 0) {
        Vec2 centre = transform(pose, piece.centre), r{piece.radius, piece.radius};
        return {centre - r, centre + r};
    }
    std::span<const Vec2> points = points_of(shapes, piece);
    Vec2 low = transform(pose, points[0]), high = low;
    for (Vec2 local : points.subspan(1)) {
        Vec2 p = transform(pose, local);
        low = min(low, p);
        high = max(high, p);
    }
    return {low, high};
}

namespace {

// Each side grows by half the margin and by the piece's own reach within the step, so that two grown bounds meet before
// the pieces can.
Bounds swept_bounds(const Shapes& shapes, const Piece& piece, const Body& body, float dt) {
    Bounds bounds = bounds_of(shapes, piece, body.pose);
    float grow = 0.5f * kMargin;
    if (moves(body)) {
        float arm = length(piece.centre - body.local_centre) + piece.reach;
        float turn = std::min(std::abs(body.spin) * dt, 2.0f);
        grow += turn * arm;
        Vec2 path = dt * body.velocity;
        bounds.low = bounds.low + min(path, Vec2{});
        bounds.high = bounds.high + max(path, Vec2{});
    }
    Vec2 g{grow, grow};
    return {bounds.low - g, bounds.high + g};
}

// 2^-6 metres: smaller, and cell numbers at the world's edge would leave 32 bits.
constexpr float kSmallestCell = 1.0f / 64.0f;

float cell_size(int level) { return std::ldexp(kSmallestCell, level); }

int level_of(const Bounds& b) {
    float extent = std::max(b.high.x - b.low.x, b.high.y - b.low.y);
    int level = 0;
    while (level + 1 < BroadPhase::kLevels && cell_size(level) < extent) ++level;
    return level;
}

struct Cell {
    std::int64_t x, y;
};

Cell cell_of(const Bounds& b, int level) {
    double size = double(cell_size(level));
    return {static_cast<std::int64_t>(std::floor(0.5 * (double(b.low.x) + double(b.high.x)) / size)),
            static_cast<std::int64_t>(std::floor(0.5 * (double(b.low.y) + double(b.high.y)) / size))};
}

constexpr std::int64_t kMiddle = std::int64_t{1} << 31; // cell numbers are stored from 0 up

std::uint64_t key_of(Cell c) {
    return static_cast<std::uint64_t>(c.y + kMiddle) << 32 | static_cast<std::uint64_t>(c.x + kMiddle);
}

void try_pair(BroadPhase& broad, const BroadPhase::Entry& e, const BroadPhase::Entry& f) {
    if (!overlap(e.bounds, f.bounds) || e.body == f.body || !(e.dynamic || f.dynamic)) return;
    broad.unsorted.push_back({std::min(e.piece, f.piece), std::max(e.piece, f.piece)});
}

// Each entry with those after it in its own cell and the next, and with the three cells of the row above. Rows are met in
// order, so a marker into the row above only moves on.
//
//      row above    [ c-1 ][  c  ][ c+1 ]
//      own row             [  c  ][ c+1 ]
void pair_within(BroadPhase& broad, const std::vector<BroadPhase::Entry>& level) {
    std::size_t above = 0;
    for (std::size_t i = 0; i < level.size(); ++i) {
        const auto& e = level[i];
        for (std::size_t j = i + 1; j < level.size() && level[j].cell <= e.cell + 1; ++j) try_pair(broad, e, level[j]);
        std::uint64_t first = e.cell + (std::uint64_t{1} << 32) - 1;
        while (above < level.size() && level[above].cell < first) ++above;
        for (std::size_t j = above; j < level.size() && level[j].cell <= first + 2; ++j) try_pair(broad, e, level[j]);
    }
}

// Each entry of a finer level with the nine cells round it of a coarser one, which holds few as a rule.
void pair_across(BroadPhase& broad, const std::vector<BroadPhase::Entry>& fine, int coarse_level) {
    const auto& coarse = broad.levels[coarse_level];
    for (const auto& e : fine) {
        Cell c = cell_of(e.bounds, coarse_level);
        for (std::int64_t row = -1; row <= 1; ++row) {
            std::uint64_t first = key_of({c.x - 1, c.y + row});
            auto f = std::ranges::lower_bound(coarse, first, {}, &BroadPhase::Entry::cell);
            for (; f != coarse.end() && f->cell <= first + 2; ++f) try_pair(broad, e, *f);
        }
    }
}

void sort_pairs(BroadPhase& broad, std::uint32_t pieces, std::vector<Pair>& pairs) {
    auto& starts = broad.starts; // counting sort by the first piece, then each piece's few by the second
    starts.assign(pieces + 1, 0);
    for (Pair p : broad.unsorted) ++starts[p.a + 1];
    for (std::uint32_t i = 0; i < pieces; ++i) starts[i + 1] += starts[i];
    pairs.resize(broad.unsorted.size());
    for (Pair p : broad.unsorted) pairs[starts[p.a]++] = p;
    std::uint32_t begin = 0;
    for (std::uint32_t i = 0; i < pieces; begin = starts[i++])
        std::sort(pairs.begin() + begin, pairs.begin() + starts[i]);
}

} // namespace

void find_pairs(BroadPhase& broad, const Shapes& shapes, const Bodies& bodies, float dt, std::vector<Pair>& pairs) {
    for (auto& level : broad.levels) level.clear();
    broad.unsorted.clear();
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p) {
        if (!shapes.piece_slots.taken(p)) continue;
        const Piece& piece = shapes.pieces[p];
        const Body& body = bodies.rows[piece.body];
        Bounds bounds = swept_bounds(shapes, piece, body, dt);
        int level = level_of(bounds);
        bool dynamic = body.kind == BodyKind::dynamic;
        broad.levels[level].push_back({key_of(cell_of(bounds, level)), bounds, p, piece.body, dynamic});
    }
    for (auto& level : broad.levels)
        std::ranges::sort(
            level, [](const auto& e, const auto& f) { return e.cell != f.cell ? e.cell < f.cell : e.piece < f.piece; });
    for (int fine = 0; fine < BroadPhase::kLevels; ++fine) {
        pair_within(broad, broad.levels[fine]);
        for (int coarse = fine + 1; coarse < BroadPhase::kLevels; ++coarse)
            if (!broad.levels[coarse].empty()) pair_across(broad, broad.levels[fine], coarse);
    }
    sort_pairs(broad, shapes.piece_slots.size(), pairs);
}

} // namespace evil
