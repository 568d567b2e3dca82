#include "character/obstacles.hpp"
#include "collider/filter.hpp"
#include "collider/shape_casts.hpp"
#include "collider/walks.hpp"
#include "world.hpp"

namespace evil {
namespace {

constexpr float kCastGap = 0.5f * kSkin; // less than the skin, so that what is touched does not stop a way along it
constexpr float kOneWayDepth = 0.02f;    // metres: deeper in, a platform that is solid from above is passed through

constexpr float kFarthestComing = 0.5f; // metres that something may come nearer within a step and be reckoned with

} // namespace

Mover::Mover(World& world, const Character& character, Vec2 up, float dt)
    : bodies_(world.bodies), shapes_(world.shapes), scene_(world.scene()), body_(character.body), up_(up), dt_(dt),
      drop_(character.dropping > 0.0f) {
    for (const Character& other : world.characters.rows) ignored_.push_back(other.body);
    filter_.ignored = ignored_;
    left_ = ignored_;
    cast_filter_.ignored = left_;
}

void Mover::leave_to_planes(std::uint32_t body) {
    left_.push_back(body);
    cast_filter_.ignored = left_;
}

template <class Each> void Mover::each_piece(Each&& each) const {
    for (std::uint32_t s = bodies_.rows[body_].first_shape; s != kNone; s = shapes_.rows[s].next)
        for (std::uint32_t p = shapes_.rows[s].first_piece; p != kNone; p = shapes_.pieces[p].next)
            each(shapes_.pieces[p]);
}

Pose Mover::pose_of(const Target& target) const {
    if (target.kind != BodyKind::kinematic) return target.pose;
    Body there = bodies_.rows[target.piece.body];
    there.centre += dt_ * there.velocity;
    there.angle += double(dt_) * double(there.spin);
    place_by_centre(there);
    return there.pose;
}

// Is the target in the way, when it is met with this normal, `gap` metres apart? A platform that is solid from one side is
// when it is met from there, and not yet passed.
bool Mover::solid(const Target& target, Vec2 normal, float gap) const {
    const Traits& wall = shapes_.rows[target.piece.shape].traits;
    std::uint32_t first = bodies_.rows[body_].first_shape;
    if (first == kNone || !may_meet(wall, shapes_.rows[first].traits)) return false;
    if (wall.one_way == Vec2{}) return true;
    constexpr float kFromThere = 0.7f; // cosine
    return !drop_ && gap > -kOneWayDepth && dot(normal, rotate(target.pose.q, wall.one_way)) > kFromThere;
}

// How fast what was met goes along there, with its belt if it has one.
Vec2 Mover::velocity_of(const Target& target, Vec2 point, Vec2 normal) const {
    Vec2 velocity = velocity_at(bodies_.rows[target.piece.body], point);
    return velocity + shapes_.rows[target.piece.shape].traits.surface_speed * right_of(normal);
}

void Mover::planes(const Pose& at, float margin, std::vector<Plane>& found) const {
    found.clear();
    each_piece([&](const Piece& mine) {
        Bounds box = safe_bounds(shapes_, mine, at);
        float farthest = margin + kFarthestComing;
        box.low = box.low - Vec2{farthest, farthest};
        box.high = box.high + Vec2{farthest, farthest};
        auto meet = [&](std::uint32_t, const Target& target) {
            Axis none;
            float coming = length(velocity_at(bodies_.rows[target.piece.body], at.p)) * dt_;
            ManifoldSketch m = collide(place(shapes_, mine, at), place(shapes_, target.piece, pose_of(target)),
                                       margin + std::min(coming, kFarthestComing), none);
            if (m.count == 0) return;
            int nearest = m.count > 1 && m.points[1].separation < m.points[0].separation;
            Plane plane{-m.normal, m.points[nearest].separation, m.points[nearest].at, {}};
            if (!solid(target, plane.normal, plane.gap)) return;
            plane.body = target.piece.body;
            plane.kind = target.kind;
            plane.velocity = velocity_of(target, plane.point, plane.normal);
            found.push_back(plane);
        };
        struct {
            decltype(meet)& call;
            static float limit() { return 1.0f; }
            void operator()(std::uint32_t p, const Target& target) { call(p, target); }
        } attempt{meet};
        inside(scene_, filter_, box, attempt);
    });
    // The tree's order is not part of the State: the planes' order must not depend on it.
    std::ranges::sort(found, [&](const Plane& a, const Plane& b) {
        return std::tuple(bodies_.rows[a.body].serial, a.gap, a.normal.x, a.normal.y, a.point.x, a.point.y) <
               std::tuple(bodies_.rows[b.body].serial, b.gap, b.normal.x, b.normal.y, b.point.x, b.point.y);
    });
}

Cast Mover::cast(const Pose& from, Vec2 path) const {
    struct First {
        const Mover& mover;
        const Pose& from;
        Vec2 path;
        const Piece* mine = nullptr;
        double fraction = 1.0;
        std::uint32_t piece = kNone;
        Cast best{};

        float limit() const { return static_cast<float>(fraction); }
        void operator()(std::uint32_t p, const Target& target) {
            const Shapes& shapes = mover.shapes_;
            std::optional<Touching> t =
                touch(shapes, *mine, from, path, shapes, target.piece, mover.pose_of(target), kCastGap);
            if (!t || t->fraction > fraction || !mover.solid(target, t->normal, t->gap)) return;
            if (t->fraction == fraction && !created_before(mover.scene_, p, piece)) return;
            fraction = t->fraction;
            piece = p;
            best = {static_cast<float>(fraction),
                    t->normal,
                    t->point,
                    mover.velocity_of(target, t->point, t->normal),
                    target.piece.body,
                    target.kind};
        }
    };
    First first{*this, from, path};
    each_piece([&](const Piece& mine) {
        first.mine = &mine;
        along(scene_, cast_filter_, sweep_of(safe_bounds(shapes_, mine, from), path, kFarthestComing), first);
    });
    return first.best;
}

//      ( )        a round foot on a corner: where they touch, the normal leans;
//     (   )       just beside, on the side that leads into what it stands on, the face tells which way is up
//   ___\_/
//     x |
Vec2 Mover::floor_normal(const Cast& hit) const {
    constexpr float kBeside = 0.02f, kAbove = 0.05f; // metres
    constexpr float kLean = 0.35f;                   // a normal that leans more is that of a side
    Vec2 right = right_of(up_);
    float lean = dot(hit.normal, right);
    if (std::abs(lean) < 0.01f || dot(hit.normal, up_) < kLean) return hit.normal;
    Vec2 shift = hit.kind == BodyKind::kinematic ? dt_ * hit.velocity : Vec2{}; // rays meet it where it still is
    Vec2 start = hit.point - shift + kAbove * up_ - (lean > 0.0f ? kBeside : -kBeside) * right;
    std::optional<RayHit> face = ray_cast(scene_, start, start - 2.0f * kAbove * up_, filter_);
    return face && face->body == hit.body && dot(face->normal, up_) > dot(hit.normal, up_) ? face->normal : hit.normal;
}

Vec2 Mover::extent(const Pose& at) const {
    Vec2 reach{1e30f, -1e30f};
    each_piece([&](const Piece& mine) {
        if (mine.count == 0) {
            float middle = dot(transform(at, mine.centre) - at.p, up_);
            reach = {std::min(reach.x, middle - mine.radius), std::max(reach.y, middle + mine.radius)};
        }
        for (Vec2 corner : points_of(shapes_, mine)) {
            float height = dot(transform(at, corner) - at.p, up_);
            reach = {std::min(reach.x, height - mine.radius), std::max(reach.y, height + mine.radius)};
        }
    });
    return reach.x > reach.y ? Vec2{} : reach;
}

// Each plane in turn pushes the point out of itself, and takes back what it pushed too much (as in the mover of Catto's
// Box2D 3.1); with the few planes round a character this settles at the point nearest to where it wanted to go.
Vec2 solve_planes(std::vector<Plane>& planes, Vec2 path) {
    constexpr int kRounds = 20;
    constexpr float kSettled = 1e-6f; // metres
    for (int round = 0; round < kRounds; ++round) {
        float changed = 0.0f;
        for (Plane& p : planes) {
            float short_of = kSkin - (p.gap + dot(p.normal, path));
            float push = std::max(p.push + short_of, 0.0f);
            path += (push - p.push) * p.normal;
            changed += std::abs(push - p.push);
            p.push = push;
        }
        if (changed < kSettled) break;
    }
    return path;
}

} // namespace evil
