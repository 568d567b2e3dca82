#include "particles/obstacles.hpp"
#include "collider/queries.hpp"
#include "world.hpp"
#include <algorithm>

namespace evil::particles {
namespace {

constexpr float kCell = 0.25f; // metres: particles seldom fly farther in a step, and few things are smaller
constexpr int kMostCells = 64; // each way; cells grow beyond

struct Cells {
    int left, low, right, high; // all inside
};

int cell_of(float at, float low, float per_metre, int count) {
    return static_cast<int>(std::clamp((at - low) * per_metre, 0.0f, static_cast<float>(count - 1)));
}

Cells cells_of(const Obstacles& o, const Bounds& b) {
    return {cell_of(b.low.x, o.low.x, o.per_metre, o.columns), cell_of(b.low.y, o.low.y, o.per_metre, o.lines),
            cell_of(b.high.x, o.low.x, o.per_metre, o.columns), cell_of(b.high.y, o.low.y, o.per_metre, o.lines)};
}

template <class Visit> void each_cell(const Obstacles& o, const Cells& cells, Visit visit) {
    for (int y = cells.low; y <= cells.high; ++y)
        for (int x = cells.left; x <= cells.right; ++x) visit(static_cast<std::size_t>(y) * o.columns + x);
}

void lay_grid(Obstacles& o, const Bounds& bounds) {
    const Vec2 size = bounds.high - bounds.low;
    const float cell = std::max(kCell, std::max(size.x, size.y) / static_cast<float>(kMostCells));
    o.low = bounds.low;
    o.per_metre = 1.0f / cell;
    o.columns = std::clamp(static_cast<int>(size.x * o.per_metre) + 1, 1, kMostCells);
    o.lines = std::clamp(static_cast<int>(size.y * o.per_metre) + 1, 1, kMostCells);
}

} // namespace

void gather(Obstacles& o, const World& world, const Bounds& bounds, std::uint32_t mask) {
    o.rows.clear();
    const Shapes& shapes = world.shapes;
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p) {
        if (!shapes.piece_slots.taken(p)) continue;
        const Piece& piece = shapes.pieces[p];
        if (piece.sensor || !(shapes.rows[piece.shape].traits.category & mask)) continue;
        const Body& body = world.bodies.rows[piece.body];
        const Pose &now = body.pose, &before = world.previous[piece.body];
        const bool moved = !(now == before);
        Bounds b = bounds_of(shapes, piece, now);
        if (moved) {
            const Bounds was = bounds_of(shapes, piece, before);
            b = {min(b.low, was.low), max(b.high, was.high)};
        }
        if (overlap(b, bounds)) o.rows.push_back({piece, before, now, b, moved, body.velocity, body.centre, body.spin});
    }
    if (o.rows.empty()) return;
    lay_grid(o, bounds);
    o.first.assign(static_cast<std::size_t>(o.columns) * o.lines + 1, 0);
    for (const Obstacle& row : o.rows)
        each_cell(o, cells_of(o, row.bounds), [&](std::size_t cell) { ++o.first[cell + 1]; });
    for (std::size_t cell = 1; cell < o.first.size(); ++cell) o.first[cell] += o.first[cell - 1];
    o.items.resize(o.first.back());
    o.places = o.first;
    for (std::uint32_t i = 0; i < o.rows.size(); ++i)
        each_cell(o, cells_of(o, o.rows[i].bounds), [&](std::size_t cell) { o.items[o.places[cell]++] = i; });
}

std::optional<Touch> first_touch(const Obstacles& o, const World& world, Vec2 start, Vec2 end) {
    if (o.rows.empty()) return std::nullopt;
    const Bounds way{min(start, end), max(start, end)};
    double best = 2.0;
    Touch touch;
    each_cell(o, cells_of(o, way), [&](std::size_t cell) {
        for (std::uint32_t i = o.first[cell]; i < o.first[cell + 1]; ++i) {
            const Obstacle& row = o.rows[o.items[i]];
            if (!overlap(row.bounds, way)) continue;
            const Vec2 from = row.moved ? transform(row.now, untransform(row.before, start)) : start;
            const std::optional<Entry> hit = enter(world.shapes, row.piece, row.now, from, end);
            if (!hit || !(hit->fraction < best)) continue;
            best = hit->fraction;
            touch.point = lerp(from, end, static_cast<float>(best));
            touch.normal = hit->normal;
            touch.velocity = row.moved ? row.velocity + cross(row.spin, touch.point - row.centre) : Vec2{};
        }
    });
    if (best > 1.0) return std::nullopt;
    return touch;
}

} // namespace evil::particles
