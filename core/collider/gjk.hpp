#pragma once
// How far apart two convex things are, and when moving ones first touch (SPEC C8). For shape casts, overlap tests with a
// distance, and continuous collision; manifolds of resting things come from narrow_phase.hpp, which is faster.
//
// distance(): Gilbert, Johnson and Keerthi 1988: the point of the Minkowski difference a - b that is nearest to the origin,
// found by walking over simplices of its corners, at most three in the plane.
// cast(): van den Bergen 2004 ("Ray casting against general convex objects"): for things that do not turn, the ray of their
// relative motion against the Minkowski difference, clipped again and again by the plane that keeps them apart now. Turning
// adds the farthest that it can bring any point nearer (conservative advancement, Mirtich 1996). Time is never overrun.
//
//     Proxy box = proxy_of(shapes, shapes.pieces[p]);
//     Nearest n = distance(box, body.pose, Proxy{{&point, 1}, 0.5f}, Pose{});   // to a disc of radius 0.5
//     Impact hit = cast(box, {body.pose}, disc, {pose, path});                 // the disc moves by `path`
//     if (hit.state == Meeting::touch) ... hit.t in 0..1, hit.point, hit.normal (from a to b)
#include "math/vec2d.hpp"
#include "shapes/shapes.hpp"
#include <span>

namespace evil {

// The hull of some points (1, a segment, a polygon's corners in any order) in its own frame, and a skin round it.
struct Proxy {
    std::span<const Vec2> points;
    float radius = 0.0f;
};
Proxy proxy_of(const Shapes& shapes, const Piece& piece); // valid while the piece is

struct Nearest {
    double distance = 0.0;  // metres between the skins; negative when the skins overlap
    double core = 0.0;      // metres between what is under the skins; 0: they overlap, and there is no normal
    Vec2d a, b;             // the nearest points of the cores, from a's origin, in world axes
    Vec2d normal;           // unit, from a to b
    std::uint8_t count = 0; // corners of each that carry the nearest points: both 1 and 1, or an edge on either side
    std::uint32_t corner_a[3] = {}, corner_b[3] = {};
};
Nearest distance(const Proxy& a, const Pose& at_a, const Proxy& b, const Pose& at_b);

// A rigid motion while t goes from 0 to 1: a point of the body moves straight, and the body turns evenly round it.
struct Motion {
    Pose start;
    Vec2 path;         // of the turning point, metres
    double turn = 0.0; // radians
    Vec2 round;        // the turning point, body frame
};
Pose pose_at(const Motion& motion, double t);

enum class Meeting : std::uint8_t {
    none,    // they never come nearer than `gap`
    touch,   // they do, first at t
    overlap, // they were nearer when it began: t = 0
};
struct Impact {
    Meeting state = Meeting::none;
    double t = 1.0;
    Vec2 point, normal; // world: on the surface of b, and from a to b. Of an overlap: zero
};
// The first time at which a and b are no more than `gap` (metres; > 0 when both have a skin of 0) apart. The time is early
// by up to a quarter of the gap, never late; a motion that turns a thing many times beside another may stop it early.
Impact cast(const Proxy& a, const Motion& move_a, const Proxy& b, const Motion& move_b, double gap = 1e-4);

} // namespace evil
