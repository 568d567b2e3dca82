// How joints look in the debug view: a pin is a ring with the arc that it may turn through, a rail a line with stops, a
// spring a coil, a slack rope sags. A joint that can break turns to the colour of contacts as its load nears that.
#include "draw/debug.hpp"
#include <algorithm>

namespace evil::draw {
namespace {

// All in logical points.
constexpr float kLine = 1.5f;
constexpr float kDot = 2.5f;      // an anchor
constexpr float kPin = 5.0f;      // radius of a ring
constexpr float kArc = 20.0f;     // of the arc of a hinge's limits
constexpr float kDrive = 11.0f;   // of a motor's arrow round a pin, and half the length of one along a rail
constexpr float kStop = 5.0f;     // half the length of the end of a rail
constexpr float kRail = 24.0f;    // how far a rail without an end is drawn
constexpr float kHead = 6.0f;     // length of the head of an arrow round something
constexpr float kCoil = 5.0f;     // half the width of a spring
constexpr float kCrowded = 14.0f; // bodies nearer than this get a line alone: the signs would hide each other

constexpr double kTurnArc = 2.0;          // radians of an arrow round something that turns
constexpr double kTurn = 2.0 * kPi;       // a limit further than this is none to be seen
constexpr std::uint32_t kArmAlpha = 0x60; // lines from anchors to bodies are fainter than joints

struct Tie { // a joint on the picture
    const DebugFrame& f;
    const Joint& joint;
    JointState state;
    Pose pose_a, pose_b;
    Vec2 a, b; // anchors, pixels
    Rgba8 colour;
    float width;
};

Vec2 scaled(const Body& body, Vec2 anchor) { return {body.scale.x * anchor.x, body.scale.y * anchor.y}; }

// 0: no load, or it never breaks. 1: it is about to.
float load_of(const Joint& j) {
    const float by_force = j.breaking_force < kNoLimit ? length(j.force) / j.breaking_force : 0.0f;
    const float by_torque = j.breaking_torque < kNoLimit ? std::abs(j.torque) / j.breaking_torque : 0.0f;
    return std::clamp(std::max(by_force, by_torque), 0.0f, 1.0f);
}

Rgba8 mixed(Rgba8 from, Rgba8 to, float part) {
    Rgba8 result = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const float low = static_cast<float>((from >> shift) & 255u), high = static_cast<float>((to >> shift) & 255u);
        result |= static_cast<Rgba8>(low + part * (high - low) + 0.5f) << shift;
    }
    return result;
}

Rgba8 faint(Rgba8 colour) { return (colour & 0x00ffffffu) | (kArmAlpha << 24); }

bool sprung(const JointDrive& d) { return d.frequency > 0.0f || d.stiffness > 0.0f; }

Tie tie_of(const DebugFrame& f, const Joint& joint) {
    const Body &a = f.world.bodies.rows[joint.body_a], &b = f.world.bodies.rows[joint.body_b];
    const Pose pose_a = f.pose(joint.body_a), pose_b = f.pose(joint.body_b);
    return {f,
            joint,
            state_of(joint, f.world.bodies),
            pose_a,
            pose_b,
            f.pixel(transform(pose_a, scaled(a, joint.anchor_a))),
            f.pixel(transform(pose_b, scaled(b, joint.anchor_b))),
            mixed(f.ink(Ink::joint), f.ink(Ink::contact), load_of(joint)),
            f.points(kLine)};
}

Vec2 middle(const Tie& t, std::uint32_t body, const Pose& pose) {
    return t.f.pixel(transform(pose, t.f.world.bodies.rows[body].local_centre));
}

// Whom it holds: a faint line to what can move. A floor's middle is far off, and says nothing.
void draw_arm(const Tie& t, std::uint32_t body, const Pose& pose, Vec2 anchor) {
    if (t.f.world.bodies.rows[body].kind != BodyKind::fixed)
        line(t.f.overlay, middle(t, body, pose), anchor, t.width, faint(t.colour));
}

void draw_anchor(const Tie& t, Vec2 at) { disc(t.f.overlay, at, t.f.points(kDot), t.colour); }

void draw_stop(const Tie& t, Vec2 at, Vec2 along) {
    const Vec2 half = t.f.points(kStop) * left_of(along);
    line(t.f.overlay, at - half, at + half, t.width, t.colour);
}

// ---- turning ----

// An arc round `at` from one angle to another, counted from a direction of the world.
void draw_arc(const Tie& t, Vec2 at, Vec2 zero, double from, double to, float radius) {
    const double span = std::clamp(to - from, -kTurn, kTurn);
    const int pieces = 2 + static_cast<int>(std::abs(span) * 6.0);
    auto point = [&](int i) { return at + radius * t.f.seen(rotate(rotation(from + span * i / pieces), zero)); };
    for (int i = 0; i < pieces; ++i) line(t.f.overlay, point(i), point(i + 1), t.width, t.colour);
}

// The way that something turns: an arc, and a head that follows it.
void draw_turn(const Tie& t, Vec2 at, Vec2 zero, bool left, float radius) {
    const double way = left ? 1.0 : -1.0;
    draw_arc(t, at, zero, 0.0, way * kTurnArc, radius);
    auto point = [&](double angle) { return at + radius * t.f.seen(rotate(rotation(way * angle), zero)); };
    const Vec2 neck = point(kTurnArc), ahead = normalised(point(kTurnArc + 0.3) - neck);
    arrow(t.f.overlay, neck, neck + t.f.points(kHead) * ahead, t.width, t.colour);
}

void draw_motor(const Tie& t, Vec2 at, Vec2 zero) {
    const JointDrive& turn = t.joint.turn;
    if (!turn.motor || turn.speed == 0.0f) return;
    draw_turn(t, at, zero, turn.speed > 0.0f, t.f.points(kDrive));
}

// Which way b points from the pin, and which way it would without having turned, as directions of the world.
Vec2 needle_of(const Tie& t) {
    const Body& b = t.f.world.bodies.rows[t.joint.body_b];
    const Vec2 arm = b.local_centre - scaled(b, t.joint.anchor_b);
    return rotate(t.pose_b.q, length_squared(arm) > 1e-6f ? arm : Vec2{1, 0}); // a wheel on its axle: its own right
}

void draw_limits(const Tie& t, Vec2 needle) {
    const JointDrive& turn = t.joint.turn;
    if (!turn.limited) return;
    const Vec2 zero = rotate(rotation(-static_cast<double>(t.state.angle)), needle);
    draw_arc(t, t.a, zero, turn.lower, turn.upper, t.f.points(kArc));
    for (const float end : {turn.lower, turn.upper}) {
        const Vec2 out = t.f.seen(rotate(rotation(end), zero));
        line(t.f.overlay, t.a + t.f.points(kPin) * out, t.a + t.f.points(kArc) * out, t.width, faint(t.colour));
    }
    line(t.f.overlay, t.a, t.a + t.f.points(kArc) * t.f.seen(needle), t.width, t.colour);
}

void draw_hinge(const Tie& t) {
    const Vec2 needle = needle_of(t);
    draw_limits(t, needle);
    draw_motor(t, t.a, needle);
    ring(t.f.overlay, t.a, t.f.points(kPin), t.width, t.colour);
}

void draw_weld(const Tie& t) {
    const float half = t.f.points(kPin);
    const Vec2 corners[] = {{half, 0}, {0, half}, {-half, 0}, {0, -half}};
    for (std::size_t i = 0; i < 4; ++i)
        line(t.f.overlay, t.a + corners[i], t.a + corners[(i + 1) % 4], t.width, t.colour);
    if (!t.joint.turn.held) ring(t.f.overlay, t.a, 1.6f * half, t.width, t.colour); // it gives
}

void draw_gear(const Tie& t) {
    const Vec2 a = middle(t, t.joint.body_a, t.pose_a), b = middle(t, t.joint.body_b, t.pose_b);
    line(t.f.overlay, a, b, t.width, faint(t.colour));
    draw_turn(t, a, {1, 0}, true, t.f.points(kArc));
    draw_turn(t, b, {1, 0}, t.joint.ratio > 0.0f, t.f.points(kArc));
}

// ---- along a line ----

void draw_span(const Tie& t) { // a rod or a spring
    if (sprung(t.joint.along))
        coil(t.f.overlay, t.a, t.b, t.f.points(kCoil), t.width, t.colour);
    else
        line(t.f.overlay, t.a, t.b, t.width, t.colour);
    if (t.joint.along.limited && t.state.length > 0.0f)
        for (const float end : {t.joint.along.lower, t.joint.along.upper})
            if (end > 0.0f && end < kWorldEdge)
                draw_stop(t, t.a + (end / t.state.length) * (t.b - t.a), normalised(t.b - t.a));
}

void draw_rail(const Tie& t) {
    const Vec2 axis = rotate(t.pose_a.q, t.joint.axis), seen = t.f.seen(axis);
    const Vec2 to_pixel = apply_linear(t.f.view, axis); // of a metre
    const JointDrive& along = t.joint.along;
    auto end = [&](float at, float open) {
        const bool ends = along.limited && std::abs(at) < kWorldEdge;
        if (ends) draw_stop(t, t.a + at * to_pixel, seen);
        return ends ? t.a + at * to_pixel : t.b + t.f.points(open) * seen;
    };
    const Vec2 low = end(along.lower, -kRail), high = end(along.upper, kRail);
    line(t.f.overlay, low, high, t.width, faint(t.colour));
    if (sprung(along)) coil(t.f.overlay, t.a + along.rest * to_pixel, t.b, t.f.points(kCoil), t.width, t.colour);
    if (along.motor && along.speed != 0.0f) {
        const Vec2 half = (along.speed > 0.0f ? 1.0f : -1.0f) * t.f.points(kDrive) * seen;
        arrow(t.f.overlay, t.b, t.b + 2.0f * half, t.width, t.colour);
    }
}

void draw_wheel(const Tie& t) {
    draw_rail(t);
    draw_motor(t, t.b, {1, 0});
    ring(t.f.overlay, t.b, t.f.points(kPin), t.width, t.colour);
}

// A slack rope hangs as a parabola of its length, nearly: that of a flat one, and of one with both ends together.
void draw_rope(const Tie& t) {
    const float length = t.joint.along.upper, slack = length * length - t.state.length * t.state.length;
    const Vec2 gravity = t.f.world.gravity, down = length_squared(gravity) > 0.0f ? gravity : Vec2{0, -1};
    const float sag = slack > 0.0f ? std::sqrt(0.1875f * slack) : 0.0f; // 3/16
    const Vec2 deepest = sag * apply_linear(t.f.view, normalised(down));
    constexpr int kPieces = 12;
    Vec2 from = t.a;
    for (int i = 1; i <= kPieces; ++i) {
        const float part = static_cast<float>(i) / kPieces;
        const Vec2 to = t.a + part * (t.b - t.a) + (4.0f * part * (1.0f - part)) * deepest;
        line(t.f.overlay, from, to, t.width, t.colour);
        from = to;
    }
}

void draw_pulley(const Tie& t) {
    const Vec2 over_a = t.f.pixel(t.joint.over_a), over_b = t.f.pixel(t.joint.over_b);
    line(t.f.overlay, t.a, over_a, t.width, t.colour);
    line(t.f.overlay, over_a, over_b, t.width, faint(t.colour));
    line(t.f.overlay, over_b, t.b, t.width, t.colour);
    for (const Vec2 at : {over_a, over_b}) ring(t.f.overlay, at, t.f.points(kPin), t.width, t.colour);
}

void draw_signs(const Tie& t) {
    switch (t.joint.kind) {
    case JointKind::distance:
        draw_span(t);
        break;
    case JointKind::hinge:
        draw_hinge(t);
        break;
    case JointKind::slider:
        draw_rail(t);
        break;
    case JointKind::weld:
        draw_weld(t);
        break;
    case JointKind::wheel:
        draw_wheel(t);
        break;
    case JointKind::motor:
        coil(t.f.overlay, t.a, t.b, t.f.points(kCoil), t.width, t.colour);
        break;
    case JointKind::rope:
        draw_rope(t);
        break;
    case JointKind::gear:
        draw_gear(t);
        return; // holds no points
    case JointKind::pulley:
        draw_pulley(t);
        break;
    }
    draw_anchor(t, t.a);
    draw_anchor(t, t.b);
}

} // namespace

void draw_joint(const DebugFrame& frame, const Joint& joint) {
    const Tie t = tie_of(frame, joint);
    const Vec2 a = middle(t, joint.body_a, t.pose_a), b = middle(t, joint.body_b, t.pose_b);
    if (length(b - a) < frame.points(kCrowded)) {
        line(frame.overlay, a, b, t.width, t.colour);
        return;
    }
    if (joint.kind != JointKind::gear) {
        draw_arm(t, joint.body_a, t.pose_a, t.a);
        draw_arm(t, joint.body_b, t.pose_b, t.b);
    }
    draw_signs(t);
}

} // namespace evil::draw
