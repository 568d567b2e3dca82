#include "collider/continuous.hpp"
#include "collider/queries.hpp"

namespace evil {
namespace {

// Radius of the largest circle round the centre of mass that one of the body's pieces covers; 0 if none does.
float inner_radius(const Body& body, const Shapes& shapes) {
    float best = 0.0f;
    for (std::uint32_t s = body.first_shape; s != kNone; s = shapes.rows[s].next) {
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

} // namespace

void stop_at_walls(std::span<const Path> paths, Bodies& bodies, const Shapes& shapes) {
    for (const Path& path : paths) {
        Body& b = bodies.rows[path.body];
        if (b.kind != BodyKind::dynamic || b.first_shape == kNone) continue;
        Vec2 moved = b.centre - path.start;
        float radius = inner_radius(b, shapes);
        if (length_squared(moved) <= radius * radius) continue;
        std::optional<RayHit> hit = ray_cast(shapes, bodies, path.start, b.centre, BodyKind::fixed);
        if (!hit) continue;
        float into = -dot(moved, hit->normal); // metres of the path that lead into the wall
        float back = into > 0.0f ? std::max(radius, kSlop) / into : 0.0f;
        b.centre = path.start + std::max(0.0f, hit->fraction - back) * moved;
        place_by_centre(b);
    }
}

} // namespace evil
