#include "light/casters.hpp"
#include "draw/scene.hpp"
#include "hash.hpp"
#include <algorithm>
#include <bit>
#include <cmath>

namespace evil::light {
namespace {

// A skin's round corner becomes a polygon's, which bends by so much at most: 2% flatter, and an eighth of a texel where
// that is less, down to the finest bend.
constexpr double kBend = kPi / 8, kFinestBend = kPi / 64;

double bend_of(float texels) { return std::clamp(1.0 / std::sqrt(double{texels}), kFinestBend, kBend); }

// The arc round a corner from one edge's normal to the next one's, and both its ends; a metre is `scale` texels.
void add_arc(std::vector<Vec2>& to, Vec2 corner, float radius, Vec2 before, Vec2 after, const Affine& to_texel,
             float scale) {
    const double turn = atan2(cross(before, after), dot(before, after)), whole = turn < 0.0 ? turn + 2.0 * kPi : turn;
    const int steps = std::max(1, static_cast<int>(std::ceil(whole / bend_of(radius * scale) - 1e-6)));
    for (int i = 0; i <= steps; ++i)
        to.push_back(apply(to_texel, corner + radius * rotate(rotation(whole * i / steps), before)));
}

void add_corners(Casters& casters, const Shapes& shapes, const Piece& piece, const Affine& to_texel, float scale) {
    const std::span<const Vec2> points = points_of(shapes, piece), normals = normals_of(shapes, piece);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (piece.radius > 0.0f)
            add_arc(casters.corners, points[i], piece.radius, normals[i == 0 ? points.size() - 1 : i - 1], normals[i],
                    to_texel, scale);
        else
            casters.corners.push_back(apply(to_texel, points[i]));
    }
}

bool is_near(Vec2 p) { return std::fabs(p.x) < 1e6f && std::fabs(p.y) < 1e6f; } // false for what is not a number, too

void add_piece(Casters& casters, const Shapes& shapes, const Piece& piece, const Affine& to_texel, float scale) {
    Caster caster;
    caster.middle = apply(to_texel, piece.centre);
    caster.radius = (piece.count == 0 ? piece.radius : piece.reach) * scale;
    if (!is_near(caster.middle) || !(caster.radius < 1e6f)) return; // too far away for a shadow to fall here
    caster.body = piece.body;
    caster.category = shapes.rows[piece.shape].traits.category;
    caster.first = static_cast<std::uint32_t>(casters.corners.size());
    if (piece.count > 0) add_corners(casters, shapes, piece, to_texel, scale);
    caster.count = static_cast<std::uint32_t>(casters.corners.size()) - caster.first;
    casters.rows.push_back(caster);
}

std::span<const Vec2> corners_of(const Casters& casters, const Caster& caster) {
    return std::span(casters.corners).subspan(caster.first, caster.count);
}

struct Span { // of what the rows from y = low to high hold of a caster; nothing: left is right
    float left = 0.0f, right = 0.0f;
};

Span across_disc(const Caster& disc, float low, float high) {
    const float rise = std::max({low - disc.middle.y, disc.middle.y - high, 0.0f});
    const float half = std::sqrt(std::max(disc.radius * disc.radius - rise * rise, 0.0f));
    return {disc.middle.x - half, disc.middle.x + half};
}

Span across_corners(std::span<const Vec2> corners, float low, float high) {
    Span span{1e9f, -1e9f};
    Vec2 a = corners.back();
    for (const Vec2 b : corners) {
        const Vec2 lower = a.y < b.y ? a : b, upper = a.y < b.y ? b : a;
        a = b;
        if (upper.y <= low || lower.y >= high) continue;
        const float slope = (upper.x - lower.x) / std::max(upper.y - lower.y, 1e-6f);
        const float enters = lower.y < low ? lower.x + slope * (low - lower.y) : lower.x;
        const float leaves = upper.y > high ? upper.x - slope * (upper.y - high) : upper.x;
        span = {std::min({span.left, enters, leaves}), std::max({span.right, enters, leaves})};
    }
    return span;
}

} // namespace

void gather(Casters& casters, const World& world, const Affine& to_texel, float alpha) {
    casters.rows.clear();
    casters.corners.clear();
    const float scale = std::sqrt(std::fabs(determinant(to_texel)));
    for (std::uint32_t slot = 0; slot < world.bodies.slots.size(); ++slot) {
        if (!world.bodies.slots.taken(slot)) continue;
        const Pose pose = draw::between(world.previous[slot], world.present[slot], alpha);
        const Affine place = compose(to_texel, affine(pose));
        const std::size_t first = casters.rows.size();
        for (std::uint32_t s = world.bodies.rows[slot].first_shape; s != kNone; s = world.shapes.rows[s].next) {
            if (world.shapes.rows[s].traits.sensor) continue;
            for (std::uint32_t p = world.shapes.rows[s].first_piece; p != kNone; p = world.shapes.pieces[p].next)
                add_piece(casters, world.shapes, world.shapes.pieces[p], place, scale);
        }
        for (Caster& caster : std::span(casters.rows).subspan(first)) caster.still = !moves(world.bodies.rows[slot]);
    }
}

std::uint64_t sum_of_still(const World& world, std::vector<std::uint32_t>& words) {
    words.clear();
    const auto put = [&](auto... values) { (words.push_back(std::bit_cast<std::uint32_t>(values)), ...); };
    for (std::uint32_t slot = 0; slot < world.bodies.slots.size(); ++slot) {
        if (!world.bodies.slots.taken(slot) || moves(world.bodies.rows[slot])) continue;
        const Pose& pose = world.present[slot];
        put(slot, pose.p.x, pose.p.y, pose.q.c, pose.q.s);
        for (std::uint32_t s = world.bodies.rows[slot].first_shape; s != kNone; s = world.shapes.rows[s].next) {
            const Shape& shape = world.shapes.rows[s];
            if (shape.traits.sensor) continue;
            for (std::uint32_t p = shape.first_piece; p != kNone; p = world.shapes.pieces[p].next) {
                const Piece& piece = world.shapes.pieces[p];
                put(shape.traits.category, piece.centre.x, piece.centre.y, piece.radius);
                for (const Vec2 corner : points_of(world.shapes, piece)) put(corner.x, corner.y);
            }
        }
    }
    Hash hash;
    hash.add({reinterpret_cast<const std::uint8_t*>(words.data()), words.size() * sizeof(std::uint32_t)});
    return hash.sum();
}

bool holds(const Casters& casters, const Caster& caster, Vec2 point) {
    if (length_squared(point - caster.middle) >= caster.radius * caster.radius) return false;
    if (caster.count == 0) return true;
    const std::span<const Vec2> corners = corners_of(casters, caster);
    bool left = false, right = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 a = corners[i], b = corners[i + 1 < corners.size() ? i + 1 : 0];
        const float side = cross(b - a, point - a);
        left |= side >= 0.0f, right |= side <= 0.0f;
    }
    return left != right;
}

template <class Value>
void fill(const Casters& casters, const Caster& caster, int width, int height, int stride, std::span<Value> texels,
          Value value, Covers covers) {
    const float margin = covers == Covers::any ? 0.0f : 0.5f - 1e-3f; // of a texel that may stay uncovered on each side
    const auto texel = [](float at, int most) {
        return static_cast<int>(std::floor(std::clamp(at, -1.0f, static_cast<float>(most))));
    };
    const int top = std::max(texel(caster.middle.y - caster.radius, height), 0);
    const int bottom = std::min(texel(caster.middle.y + caster.radius, height) + 1, height);
    for (int row = top; row < bottom; ++row) {
        const float low = static_cast<float>(row) + margin, high = static_cast<float>(row + 1) - margin;
        const Span span =
            caster.count == 0 ? across_disc(caster, low, high) : across_corners(corners_of(casters, caster), low, high);
        if (!(span.left < span.right)) continue;
        const int from = std::max(texel(span.left + margin, width), 0);
        const int to = std::min(texel(span.right - margin, width) + 1, width);
        if (from < to) std::fill_n(texels.begin() + row * stride + from, to - from, value);
    }
}

template void fill(const Casters&, const Caster&, int, int, int, std::span<std::uint8_t>, std::uint8_t, Covers);
template void fill(const Casters&, const Caster&, int, int, int, std::span<std::uint32_t>, std::uint32_t, Covers);

} // namespace evil::light
