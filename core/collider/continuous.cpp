#include "collider/continuous.hpp"
#include "collider/filter.hpp"
#include "collider/queries.hpp"

namespace evil {
namespace {

// Radius of the largest circle round the centre of mass that one of the body's pieces covers; 0 if none does.
float inner_radius(const Body& body, const Shapes& shapes) {
    float best = 0.0f;
    for (std::uint32_t s = body.first_shape; s != kNone; s = shapes.rows[s].next) {
        if (shapes.rows[s].traits.sensor) continue;
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next) {
            const Piece& piece = shapes.pieces[p];
            float inside = piece.radius - length(body.local_centre - piece.centre);
            if (piece.count > 0) {
                std::span<const Vec2> points = points_of(shapes, piece), normals = normals_of(shapes, piece);
                inside = dot(normals[0], points[0] - body.local_centre);
                for (std::uint32_t i = 1; i < piece.count; ++i)
                    inside = std::min(inside, dot(normals[i], points[i] - body.local_centre));
            }
            best = std::max(best, inside);
        }
    }
    return best;
}

struct Wall {
    double fraction = 1.0;
    Vec2 normal;
};

bool in_the_way(const Shapes& shapes, const Traits& wall, Rot turn, const Body& mover, Vec2 path) {
    for (std::uint32_t s = mover.first_shape; s != kNone; s = shapes.rows[s].next)
        if (blocks(wall, turn, shapes.rows[s].traits, path)) return true;
    return false;
}

std::optional<Wall> first_wall(const Bodies& bodies, const Shapes& shapes, const Body& mover, Vec2 start, Vec2 end) {
    std::optional<Wall> first;
    for (std::uint32_t p = 0; p < shapes.piece_slots.size(); ++p) {
        const Piece& piece = shapes.pieces[p];
        if (!shapes.piece_slots.taken(p) || bodies.rows[piece.body].kind != BodyKind::fixed) continue;
        std::optional<Entry> hit = enter(shapes, piece, bodies.rows[piece.body].pose, start, end);
        if (!hit || (first && hit->fraction >= first->fraction)) continue;
        const Traits& wall = shapes.rows[piece.shape].traits;
        if (in_the_way(shapes, wall, bodies.rows[piece.body].pose.q, mover, end - start))
            first = {hit->fraction, hit->normal};
    }
    return first;
}

} // namespace

void stop_at_walls(std::span<const Path> paths, Bodies& bodies, const Shapes& shapes) {
    for (const Path& path : paths) {
        Body& b = bodies.rows[path.body];
        if (b.kind != BodyKind::dynamic || b.first_shape == kNone) continue;
        Vec2 moved = b.centre - path.start;
        float radius = inner_radius(b, shapes);
        if (length_squared(moved) <= radius * radius) continue;
        std::optional<Wall> hit = first_wall(bodies, shapes, b, path.start, b.centre);
        if (!hit) continue;
        float into = -dot(moved, hit->normal); // metres of the path that lead into the wall
        float back = into > 0.0f ? std::max(radius, kSlop) / into : 0.0f;
        b.centre = path.start + std::max(0.0f, static_cast<float>(hit->fraction) - back) * moved;
        place_by_centre(b);
    }
}

} // namespace evil
