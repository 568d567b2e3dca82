#include "collider/shape_casts.hpp"
#include "collider/gjk.hpp"
#include "collider/walks.hpp"

namespace evil {
namespace {

struct Met {
    double fraction = 1.0;
    std::uint32_t piece = kNone;
    Vec2 point, normal;
};

RayHit hit_of(const Scene& scene, const Met& met) {
    const Piece& piece = scene.shapes.pieces[met.piece];
    return {piece.shape, piece.body, met.point, met.normal, static_cast<float>(met.fraction)};
}

bool sooner(const Scene& scene, const Met& a, const Met& b) {
    return a.fraction != b.fraction ? a.fraction < b.fraction : created_before(scene, a.piece, b.piece);
}

struct FirstTouch {
    const Scene& scene;
    const Shapes& probe;
    Vec2 path;
    const Piece* mine = nullptr;
    Met best{};

    float limit() const { return static_cast<float>(best.fraction); }
    void operator()(std::uint32_t p, const Target& target) {
        std::optional<Touching> t =
            touch(probe, *mine, Pose{}, path, scene.shapes, target.piece, target.pose, kTouchGap);
        if (!t) return;
        Met met{t->fraction, p, t->point, t->normal};
        if (met.fraction <= 1.0 && sooner(scene, met, best)) best = met;
    }
};

struct EveryTouch {
    const Scene& scene;
    const Shapes& probe;
    Vec2 path;
    const Piece* mine = nullptr;
    std::vector<Met> all{};

    static float limit() { return 1.0f; }
    void operator()(std::uint32_t p, const Target& target) {
        std::optional<Touching> t =
            touch(probe, *mine, Pose{}, path, scene.shapes, target.piece, target.pose, kTouchGap);
        if (t) all.push_back({t->fraction, p, t->point, t->normal});
    }
};

// Each piece of the probe along the way: its box is a point, and what it may meet grows by its half sides.
template <class Try>
void each_piece(const Scene& scene, const Shapes& probe, Vec2 path, const Filter& filter, Try& attempt) {
    for (std::uint32_t q = 0; q < probe.piece_slots.size(); ++q) {
        attempt.mine = &probe.pieces[q];
        along(scene, filter, sweep_of(safe_bounds(probe, probe.pieces[q], Pose{}), path, kTouchGap), attempt);
    }
}

} // namespace

std::optional<Touching> touch(const Shapes& probe, const Piece& mine, const Pose& from, Vec2 path, const Shapes& shapes,
                              const Piece& piece, const Pose& at, float gap) {
    float into = 1e-5f * length(path); // less leads along rather than in
    Axis none;
    ManifoldSketch now = collide(place(probe, mine, from), place(shapes, piece, at), gap, none);
    if (now.count > 0) {
        if (dot(path, now.normal) <= into) return {};
        int second = now.count > 1 && now.points[1].separation < now.points[0].separation;
        return Touching{0.0, now.points[second].at, -now.normal, now.points[second].separation};
    }
    Motion moving{from, path, 0.0, {}}, still{at, {}, 0.0, {}};
    Impact impact = cast(proxy_of(probe, mine), moving, proxy_of(shapes, piece), still, double(gap));
    if (impact.state != Meeting::touch || dot(path, impact.normal) <= into) return {};
    return Touching{impact.t, impact.point, -impact.normal};
}

std::optional<RayHit> shape_cast(const Scene& scene, const Shapes& probe, Vec2 path, const Filter& filter) {
    FirstTouch first{scene, probe, path};
    each_piece(scene, probe, path, filter, first);
    if (first.best.piece == kNone) return {};
    return hit_of(scene, first.best);
}

void shape_cast_all(const Scene& scene, const Shapes& probe, Vec2 path, const Filter& filter,
                    std::vector<RayHit>& hits) {
    EveryTouch every{scene, probe, path};
    each_piece(scene, probe, path, filter, every);
    std::ranges::sort(every.all, [&](const Met& a, const Met& b) { return sooner(scene, a, b); });
    hits.clear();
    for (const Met& met : every.all) {
        RayHit hit = hit_of(scene, met);
        if (std::ranges::find(hits, hit.shape, &RayHit::shape) == hits.end()) hits.push_back(hit);
    }
}

} // namespace evil
