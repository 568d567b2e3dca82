#include "character/character.hpp"
#include "character/obstacles.hpp"
#include "world.hpp"

namespace evil {
namespace {

constexpr int kSlides = 5;            // how often a way is bent within a step
constexpr float kPlaneMargin = 0.02f; // metres: what is so near bends the way; farther things are found by casts
constexpr float kStill = 1e-3f;       // metres: what is no more than this off the ground is not moved onto it
constexpr float kCrush = 0.05f;       // metres that it overlaps what it cannot get out of
constexpr float kRiseSpeed = 0.1f;    // m/s upwards, off the ground by its own will

// One character in one step: the parts of its rules share what they know here.
struct Turn {
    World& world;
    Character& c;
    Body& body;
    Mover mover;
    Vec2 up, right;
    float gravity, dt, steepest;
    Pose at;                    // where it has got to
    std::vector<Plane>& planes; // near it
    Vec2 arriving{};            // its velocity before anything stopped it
    struct {
        std::uint32_t body = kNone;
        Vec2 velocity; // before
        float spin = 0.0f;
    } pushed[4]{}; // what it has pushed

    bool walkable(Vec2 normal) const { return dot(normal, up) >= steepest; }
};

float toward(float value, float goal, float most) { return value + clamped(goal - value, most); }

// The direction along the ground to the right.
Vec2 along_ground(const Turn& t) { return t.c.grounded ? right_of(t.c.ground_normal) : t.right; }

void leave_ground(Turn& t, bool carry_down) {
    if (!t.c.grounded) return;
    Vec2 carried = t.c.ground_velocity;
    float rise = dot(carried, t.up);
    if (rise < 0.0f && !carry_down) carried -= rise * t.up; // a lift that sinks takes nothing from a jump
    t.c.velocity += carried;
    t.c.grounded = false;
    t.c.ground = kNone;
    t.c.ground_velocity = {};
}

// ---- what the player wants ------------------------------------------------------------------------------------------

// Speed along the ground, or through the air, towards what is wished for.
void drive(Turn& t) {
    const Abilities& a = t.c.abilities;
    Vec2 way = along_ground(t);
    float speed = dot(t.c.velocity, way), goal = t.c.wish.move * a.speed;
    if (t.c.wall != Vec2{} && goal * dot(t.c.wall, t.right) < 0.0f && !t.c.grounded)
        goal = 0.0f; // no walking up a wall
    bool faster = goal * speed >= 0.0f && std::abs(goal) >= std::abs(speed);
    float rate = t.c.grounded ? (faster ? a.acceleration : a.deceleration)
                              : (goal != 0.0f ? a.air_acceleration : a.air_deceleration);
    float change = toward(speed, goal, rate * t.dt) - speed;
    if (t.c.grounded)
        t.c.velocity = (speed + change) * way;
    else
        t.c.velocity += change * way;
}

// The wish is kept for a while before the ground, and the ground for a while after it.
void jump(Turn& t) {
    const Abilities& a = t.c.abilities;
    bool from_ground = t.c.grounded || t.c.climbing || t.c.since_ground <= a.coyote_time;
    if (t.c.jump_wanted > 0.0f && a.jump_height > 0.0f && (from_ground || t.c.jumps_left > 0)) {
        if (!from_ground) --t.c.jumps_left;
        leave_ground(t, false);
        float rise = std::max(dot(t.c.velocity, t.up), 0.0f);
        if (t.c.climbing || !from_ground || t.c.since_ground > 0.0f) rise = 0.0f; // it fell, or hung
        t.c.velocity += (std::sqrt(2.0f * t.gravity * a.jump_height) + rise - dot(t.c.velocity, t.up)) * t.up;
        t.c.climbing = false;
        t.c.rising = t.c.jumped = true;
        t.c.since_ground = 1e9f;
        t.c.jump_wanted = 0.0f;
    }
    t.c.jump_wanted = std::max(t.c.jump_wanted - t.dt, 0.0f);
    float rise = dot(t.c.velocity, t.up);
    if (rise <= 0.0f) t.c.rising = false;
    if (t.c.rising && !t.c.wish.jump) {
        t.c.velocity -= (1.0f - a.jump_cut) * rise * t.up;
        t.c.rising = false;
    }
}

const Ladder* ladder_at(const Turn& t) {
    Vec2 centre = t.body.centre, extent = t.mover.extent(t.at);
    Vec2 feet = t.at.p + extent.x * t.up;
    for (const Ladder& l : t.c.ladders)
        for (Vec2 p : {centre, feet})
            if (l.low.x <= p.x && p.x <= l.high.x && l.low.y <= p.y && p.y <= l.high.y + kPlaneMargin) return &l;
    return nullptr;
}

// Holds on when the player wants up or down, lets go by a jump, off its side, or at its foot.
void climb(Turn& t) {
    const Ladder* ladder = ladder_at(t);
    float wanted = t.c.wish.climb;
    if (!ladder || (t.c.climbing && t.c.grounded && wanted <= 0.0f)) t.c.climbing = false;
    if (!ladder) return;
    float foot = dot(t.at.p, t.up) + t.mover.extent(t.at).x;
    Vec2 top{t.up.x > 0.5f ? ladder->high.x : ladder->low.x, t.up.y > -0.5f ? ladder->high.y : ladder->low.y};
    float left_to_climb = dot(top, t.up) - foot;
    if (!t.c.climbing && wanted > 0.0f && left_to_climb > kPlaneMargin && !t.c.rising) t.c.climbing = true;
    if (!t.c.climbing && wanted < 0.0f && !t.c.grounded) t.c.climbing = true;
    if (!t.c.climbing && wanted < 0.0f && left_to_climb < kPlaneMargin + kSkin)
        t.c.climbing = true; // down from its top
    if (!t.c.climbing) return;
    leave_ground(t, true);
    float speed = std::min(wanted * t.c.abilities.climb_speed, std::max(left_to_climb, 0.0f) / t.dt);
    t.c.velocity = speed * t.up + 0.5f * t.c.wish.move * t.c.abilities.speed * t.right;
    t.c.rising = false;
}

// ---- the way --------------------------------------------------------------------------------------------------------

// What it touches gives way as far as its force goes, and what it stands on bears its weight; what comes at it takes it
// along as two masses that meet would.
void push(Turn& t, Plane& plane, Vec2 velocity) {
    if (plane.kind != BodyKind::dynamic) return;
    auto known = std::ranges::find_if(t.pushed, [&](const auto& p) { return p.body == plane.body || p.body == kNone; });
    if (known == std::end(t.pushed) || known->body == plane.body) return;
    Body& b = t.world.bodies.rows[plane.body];
    *known = {plane.body, b.velocity, b.spin};
    Vec2 arm = plane.point - b.centre;
    float turn = cross(arm, plane.normal), inverse = b.inv_mass + b.inv_inertia * turn * turn;
    if (!(inverse > 0.0f)) return;
    const Abilities& a = t.c.abilities;
    float closing = dot(plane.velocity - velocity, plane.normal); // m/s at which they come together
    float impulse = 0.0f;
    if (dot(plane.normal, t.up) > 0.7f)
        impulse = a.mass * t.gravity * t.dt;
    else if (closing > 0.0f)
        impulse = std::min(closing / inverse,
                           std::max(a.push_force * t.dt,
                                    std::max(dot(plane.velocity, plane.normal), 0.0f) / (inverse + 1.0f / a.mass)));
    if (!(impulse > 0.0f)) return;
    b.velocity = clamped(b.velocity - impulse * b.inv_mass * plane.normal, kMaxSpeed); // a ton stands on a grain
    b.spin = clamped(b.spin - impulse * b.inv_inertia * turn, kMaxSpin);
    wake(t.world, plane.body);
    plane.velocity = velocity_at(b, plane.point);
}

// A body that others move is met where it is, or will be if it comes nearer. It is followed as fast as it went before it was
// pushed: what does not give way to the push is not run into. Nothing that lies below is followed down: it might stop.
void reckon(const Turn& t, Plane& plane) {
    if (plane.kind != BodyKind::dynamic) return;
    Vec2 velocity = plane.velocity;
    for (const auto& p : t.pushed) {
        if (p.body != plane.body) continue;
        velocity = p.velocity + cross(p.spin, plane.point - t.world.bodies.rows[p.body].centre);
    }
    float coming = dot(velocity, plane.normal);
    if (coming < 0.0f && dot(plane.normal, t.up) > 0.7f) return;
    plane.gap -= t.dt * coming;
}

// On foot, a slope too steep to walk on is a wall.
void stand_upright(const Turn& t, Vec2& normal) {
    float rise = dot(normal, t.up);
    if (!t.c.grounded || rise <= 0.05f || t.walkable(normal)) return;
    normal = normalised(normal - rise * t.up);
}

// Takes from the velocity what leads into the planes.
Vec2 clipped(const Turn& t, Vec2 velocity) {
    for (const Plane& plane : t.planes) {
        if (plane.push <= 0.0f || (t.c.grounded && t.walkable(plane.normal))) continue;
        float into = dot(velocity - plane.velocity, plane.normal);
        if (into < 0.0f) velocity -= into * plane.normal;
    }
    return velocity;
}

// To the nearest point that planes and casts allow, round at most kSlides bends (the slide of Quake's movement, with all
// planes solved together as in Catto's mover). Returns the velocity that is left.
Vec2 slide(Turn& t, Vec2 path, Vec2 velocity) {
    Vec2 goal = t.at.p + path;
    for (int i = 0; i < kSlides; ++i) {
        t.mover.planes(t.at, kPlaneMargin, t.planes);
        for (Plane& plane : t.planes) {
            push(t, plane, velocity);
            reckon(t, plane);
            stand_upright(t, plane.normal);
        }
        Vec2 way = solve_planes(t.planes, goal - t.at.p);
        velocity = clipped(t, velocity);
        Cast hit = t.mover.cast(t.at, way);
        t.at.p += hit.fraction * way;
        if (hit.kind == BodyKind::dynamic) { // from here on its plane tells how far
            Plane met{hit.normal, 0.0f, hit.point, hit.velocity, hit.body, hit.kind, 0.0f};
            push(t, met, velocity);
            t.mover.leave_to_planes(hit.body);
        }
        if (hit.fraction >= 1.0f || length_squared(way) < 1e-12f) break;
    }
    return velocity;
}

// Up, on and down again: where a way along the ground ends at something low enough to step onto.
bool step_up(Turn& t, const Pose& from, Vec2 path) {
    float wanted = dot(path, t.right), got = dot(t.at.p - from.p, t.right);
    if (std::abs(wanted) < 1e-5f || wanted * got >= 0.9f * wanted * wanted) return false;
    float height = t.c.abilities.step_height;
    if (!(height > 0.0f)) return false;
    Pose p = from;
    p.p += (height * t.mover.cast(p, height * t.up).fraction) * t.up;
    Vec2 forward = wanted * t.right;
    Cast ahead = t.mover.cast(p, forward);
    p.p += ahead.fraction * forward;
    float down = dot(p.p - from.p, t.up);
    Cast floor = t.mover.cast(p, -down * t.up);
    float foot = dot(from.p, t.up) + t.mover.extent(from).x;
    if (dot(floor.point, t.up) - foot > height + kSkin) return false; // a corner that it merely leans on
    if (floor.normal == Vec2{} || floor.kind == BodyKind::dynamic || !t.walkable(t.mover.floor_normal(floor)))
        return false;
    p.p -= std::max(floor.fraction * down - kSkin, 0.0f) * t.up;
    float gained = dot(p.p - from.p, t.right);
    if (wanted * gained <= wanted * got + 1e-6f) return false;
    t.at = p;
    return true;
}

// ---- the ground -----------------------------------------------------------------------------------------------------

constexpr float kRestless = 2e-3f; // m/s that the solver may leave to a body at rest: it moves nowhere by it

// What carries whoever stands on it: of a body that others move, nothing down, for it might stop.
Vec2 carrying(Vec2 velocity, BodyKind kind, Vec2 normal) {
    if (kind == BodyKind::dynamic && length_squared(velocity) < kRestless * kRestless) return {};
    return kind == BodyKind::dynamic ? velocity - std::min(dot(velocity, normal), 0.0f) * normal : velocity;
}

void stand(Turn& t, Cast floor, Vec2 normal) {
    floor.velocity = carrying(floor.velocity, floor.kind, normal);
    Vec2 way = right_of(normal);
    if (!t.c.grounded) {
        Vec2 fall = t.arriving - floor.velocity;
        t.c.landing = std::max(-dot(fall, normal), 0.0f);
        t.c.velocity = dot(t.c.velocity - floor.velocity, way) * way;
    } else {
        t.c.velocity = dot(t.c.velocity, along_ground(t)) * way; // the same speed along the next slope
    }
    t.c.grounded = true;
    t.c.ground = floor.body;
    t.c.belt = floor.belt;
    t.c.ground_normal = normal;
    t.c.ground_velocity = floor.velocity;
    t.c.since_ground = 0.0f;
    t.c.jumps_left = t.c.abilities.air_jumps;
    t.c.rising = t.c.climbing = false;
}

// Beside what is too steep, is there something flat that it stands on as well?
bool stand_beside(Turn& t) {
    t.mover.planes(t.at, kPlaneMargin, t.planes);
    for (const Plane& plane : t.planes) {
        if (!t.walkable(plane.normal)) continue;
        stand(t, {0.0f, plane.normal, plane.point, plane.velocity, plane.body, plane.kind, 0.0f}, plane.normal);
        return true;
    }
    return false;
}

// Does it stand, and on what? Who walks stays on the ground where that falls away; who falls lands when he touches it.
void find_ground(Turn& t) {
    constexpr float kLook = 0.1f; // metres: what rises
    bool walked = t.c.grounded;
    t.c.wall = {};
    float allowed = kPlaneMargin + (walked ? t.c.abilities.step_height : 0.0f), reach = allowed + kLook;
    Cast floor = t.mover.cast(t.at, -reach * t.up);
    Vec2 velocity = t.c.velocity + t.c.ground_velocity;
    float gap = floor.fraction * reach;
    if (floor.kind == BodyKind::dynamic) gap -= t.dt * std::max(dot(floor.velocity, t.up), 0.0f);
    bool leaves = !walked && dot(velocity - floor.velocity, t.up) > kRiseSpeed;
    bool hangs = t.c.climbing && t.c.wish.climb >= 0.0f;
    if (floor.normal != Vec2{} && gap <= allowed && !leaves && !hangs) {
        Vec2 normal = t.mover.floor_normal(floor);
        if (t.walkable(normal)) {
            if (std::abs(gap - kSkin) > kStill) t.at.p -= (gap - kSkin) * t.up;
            return stand(t, floor, normal);
        }
        if (gap <= kPlaneMargin) {
            if (stand_beside(t)) return;
            t.c.wall = floor.normal;
        }
    }
    leave_ground(t, true);
    t.c.since_ground += t.dt;
}

// Where the ground has begun to move otherwise since the last step, it carries from now on as it now moves.
void feel_ground(Turn& t) {
    if (!t.c.grounded || t.c.ground == kNone) return;
    Vec2 foot = t.at.p + t.mover.extent(t.at).x * t.up;
    const Body& ground = t.world.bodies.rows[t.c.ground];
    t.c.ground_velocity =
        carrying(velocity_at(ground, foot), ground.kind, t.c.ground_normal) + t.c.belt * right_of(t.c.ground_normal);
}

void feel_pressure(Turn& t) {
    bool crushed = false;
    for (const Plane& plane : t.planes) {
        bool yields =
            plane.kind == BodyKind::dynamic && t.world.bodies.rows[plane.body].mass < 5.0f * t.c.abilities.mass;
        if (!yields && plane.gap < -kCrush) crushed = true;
    }
    t.c.begins_crush = crushed && !t.c.crushed;
    t.c.crushed = crushed;
}

void take_turn(World& world, Character& c, std::vector<Plane>& planes, float dt) {
    Body& body = world.bodies.rows[c.body];
    float strength = length(world.gravity);
    Vec2 up = strength > 0.0f ? (-1.0f / strength) * world.gravity : Vec2{0, 1};
    if (up != Vec2{-body.pose.q.s, body.pose.q.c}) { // gravity has turned, and it with it
        body.angle = double(atan2(up.y, up.x)) - 0.5 * kPi;
        place_by_origin(body);
        world.search.edited.push_back(c.body);
    }
    Turn t{world,
           c,
           body,
           Mover(world, c, up, dt),
           up,
           right_of(up),
           strength * c.abilities.gravity_scale,
           dt,
           sincos(double(c.abilities.max_slope)).cos,
           body.pose,
           planes};
    c.jumped = c.begins_crush = false;
    c.landing = 0.0f;
    feel_ground(t);
    Vec2 before = c.velocity;
    float slowest = -std::max(c.abilities.fall_speed, 0.0f); // upwards
    drive(t);
    climb(t);
    jump(t);
    bool falls = !c.grounded && !c.climbing;
    if (c.jumped) before = c.velocity;
    if (falls) {
        float rise = std::clamp(dot(c.velocity, up) - t.gravity * dt, slowest, 1e9f);
        c.velocity = dot(c.velocity, t.right) * t.right + rise * up;
    }
    // In the air the mean of both velocities: the jump's curve is then the exact one, and as high as it should be.
    float rise = dot(c.velocity, up), mean = falls ? 0.5f * (std::max(dot(before, up), slowest) + rise) : rise;
    Vec2 velocity = dot(c.velocity, t.right) * t.right + mean * up + c.ground_velocity;
    Pose from = t.at;
    t.arriving = velocity;
    Vec2 left = slide(t, dt * velocity, velocity);
    bool stepped = c.grounded && step_up(t, from, dt * velocity);
    if (!stepped) c.velocity += left - velocity;
    find_ground(t);
    t.mover.planes(t.at, kPlaneMargin, planes);
    feel_pressure(t);
    body.velocity = clamped((1.0f / dt) * (t.at.p - body.pose.p), kMaxSpeed);
    body.spin = 0.0f;
}

} // namespace

Character* character_of(Characters& characters, std::uint32_t body) {
    auto found = std::ranges::find(characters.rows, body, &Character::body);
    return found == characters.rows.end() ? nullptr : &*found;
}

Character& add_character(World& world, std::uint32_t body, const Abilities& abilities) {
    Character c;
    c.body = body;
    c.abilities = abilities;
    world.characters.rows.push_back(std::move(c));
    return world.characters.rows.back();
}

void launch(Character& c, Vec2 velocity) {
    c.velocity = velocity - c.ground_velocity;
    c.rising = c.climbing = false;
    if (!c.grounded || dot(c.velocity, c.ground_normal) <= kRiseSpeed) return;
    c.velocity = velocity;
    c.ground_velocity = {};
    c.grounded = false;
    c.ground = kNone;
    c.since_ground = 1e9f;
}

void forget_character(Characters& characters, std::uint32_t body) {
    std::erase_if(characters.rows, [&](const Character& c) { return c.body == body; });
    for (Character& c : characters.rows)
        if (c.ground == body) c.ground = kNone;
}

bool hold_together(const Characters& characters, const std::vector<bool>& body_taken) {
    auto taken = [&](std::uint32_t slot) { return slot < body_taken.size() && body_taken[slot]; };
    for (const Character& c : characters.rows)
        if (!taken(c.body) || (c.ground != kNone && !taken(c.ground))) return false;
    return true;
}

void move_characters(World& world, float dt) {
    std::vector<Plane>& planes = world.characters.planes;
    for (Character& c : world.characters.rows) {
        if (world.bodies.rows[c.body].kind == BodyKind::kinematic) take_turn(world, c, planes, dt);
        c.dropping = std::max(c.dropping - dt, 0.0f);
    }
}

} // namespace evil
