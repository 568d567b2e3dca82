#include "solver/joints/chains.hpp"
#include "bodies.hpp"

namespace evil {
namespace {

struct Pair { // as Vec2, in doubles
    double x = 0, y = 0;
};

Pair times(const Matrix2& m, Pair v) { return {m.xx * v.x + m.xy * v.y, m.yx * v.x + m.yy * v.y}; }
Pair transposed_times(const Matrix2& m, Pair v) { return {m.xx * v.x + m.yx * v.y, m.xy * v.x + m.yy * v.y}; }
Matrix2 product(const Matrix2& m, const Matrix2& n) {
    return {m.xx * n.xx + m.xy * n.yx, m.xx * n.xy + m.xy * n.yy, m.yx * n.xx + m.yy * n.yx, m.yx * n.xy + m.yy * n.yy};
}

Matrix2 inverse(const Matrix2& m) {
    double determinant = m.xx * m.yy - m.xy * m.yx;
    if (!(determinant > 0.0)) return {};
    double d = 1.0 / determinant;
    return {d * m.yy, -d * m.xy, -d * m.yx, d * m.xx};
}

// What a unit push at one arm of a body changes of the speed at another: m 1 + i u v' with u and v the arms turned left.
Matrix2 response(float inv_mass, float turns, Vec2 at, Vec2 pushed) {
    double m = inv_mass, i = turns;
    return {m + i * at.y * pushed.y, -i * at.y * pushed.x, -i * at.x * pushed.y, m + i * at.x * pushed.x};
}

void add(Matrix2& m, const Matrix2& n, double sign) {
    m.xx += sign * n.xx;
    m.xy += sign * n.xy;
    m.yx += sign * n.yx;
    m.yy += sign * n.yy;
}

// The equations of all links, brought to the form that each can be solved from the one before. What a push leaves over of
// the speed, as a stiff spring does that is integrated implicitly, is more of each one's own part: the share `give`.
void eliminate(std::span<ChainLink> links, std::span<const SolverBody> bodies, double give) {
    for (std::size_t i = 0; i < links.size(); ++i) {
        ChainLink& k = links[i];
        Matrix2 own;
        add(own, response(bodies[k.a].inv_mass, k.turns_a, k.arm_a, k.arm_a), 1.0);
        add(own, response(bodies[k.b].inv_mass, k.turns_b, k.arm_b, k.arm_b), 1.0);
        k.give_x = give * own.xx;
        k.give_y = give * own.yy;
        own.xx += k.give_x;
        own.yy += k.give_y;
        if (!k.begins) {
            const ChainLink& last = links[i - 1];
            std::uint32_t shared = k.shares_a ? k.a : k.b;
            bool last_a = last.a == shared;
            k.before = {};
            add(k.before,
                response(bodies[shared].inv_mass, k.shares_a ? k.turns_a : k.turns_b, k.shares_a ? k.arm_a : k.arm_b,
                         last_a ? last.arm_a : last.arm_b),
                k.shares_a == last_a ? 1.0 : -1.0);
            Matrix2 across = product(k.before, last.inverse);
            Matrix2 turned{k.before.xx, k.before.yx, k.before.xy, k.before.yy};
            add(own, product(across, turned), -1.0);
        }
        k.inverse = inverse(own);
    }
}

// A link under tension swings like a string that is plucked, the faster the harder it is pulled: h^2 k / I is the square of
// the angle of that in a substep, k the sum of arm . force over its joints. Above kFastest it would swing itself to pieces, so
// then its inertia counts for more (geometric stiffness: Andrews, Teichmann and Kry 2017).
constexpr float kFastest = 1.0f;

float held(float inv_inertia, float pulled, float h) {
    float angle_squared = h * pulled * inv_inertia;
    return angle_squared > kFastest ? inv_inertia * (kFastest / angle_squared) : inv_inertia;
}

void hold_still(std::span<ChainLink> links, std::span<const SolverBody> bodies, float h) {
    for (ChainLink& k : links) { // first arm . impulse alone
        k.turns_a = -dot(k.arm_a, k.impulse);
        k.turns_b = dot(k.arm_b, k.impulse);
    }
    for (std::size_t i = 0; i < links.size(); ++i) {
        ChainLink& k = links[i];
        bool ends = i + 1 == links.size() || links[i + 1].begins;
        float& open = k.shares_a ? k.turns_b : k.turns_a; // of the body that the next link shares
        std::uint32_t body = k.shares_a ? k.b : k.a;
        if (ends) {
            open = held(bodies[body].inv_inertia, open, h);
        } else {
            ChainLink& next = links[i + 1];
            float& shared = next.shares_a ? next.turns_a : next.turns_b;
            open = shared = held(bodies[body].inv_inertia, open + shared, h);
        }
        if (!k.begins) continue;
        float& first = k.shares_a ? k.turns_a : k.turns_b;
        first = held(bodies[k.shares_a ? k.a : k.b].inv_inertia, first, h);
    }
}

void refresh(std::span<ChainLink> links, std::span<const SolverBody> bodies, const JointPass& pass) {
    for (ChainLink& k : links) {
        const SolverBody &a = bodies[k.a], &b = bodies[k.b];
        k.arm_a = rotate(rotation(double(a.turned)), k.start_a);
        k.arm_b = rotate(rotation(double(b.turned)), k.start_b);
        k.error = k.gap + Vec2{b.moved_x - a.moved_x, b.moved_y - a.moved_y} + (k.arm_b - k.arm_a);
    }
    hold_still(links, bodies, pass.h);
    eliminate(links, bodies, double(pass.chain.leak / pass.chain.keep));
}

void push(SolverBody& body, float turns, Vec2 arm, Vec2 impulse) {
    body.vx += body.inv_mass * impulse.x;
    body.vy += body.inv_mass * impulse.y;
    body.spin += turns * cross(arm, impulse);
}

void push_both(const ChainLink& k, std::span<SolverBody> bodies, Vec2 impulse) {
    push(bodies[k.a], k.turns_a, k.arm_a, -impulse);
    push(bodies[k.b], k.turns_b, k.arm_b, impulse);
}

Vec2 speed(const SolverBody& body, Vec2 arm) { return Vec2{body.vx, body.vy} + cross(body.spin, arm); }

// What going round, not along a line, adds to an arm's speed within the substep; see falling_behind in drive_lanes.hpp.
Vec2 bend(const SolverBody& body, Vec2 arm, const JointPass& pass) {
    float behind = std::min(0.5f * pass.h * body.spin * body.spin, 0.5f * pass.inv_h);
    return -behind * arm;
}

// Pushes that take away all the speeds that the links have been given as what is wrong.
void solve(std::span<ChainLink> links, std::span<SolverBody> bodies) {
    for (std::size_t i = 0; i < links.size(); ++i) {
        ChainLink& k = links[i];
        if (k.begins) continue;
        const ChainLink& last = links[i - 1];
        Pair passed = times(k.before, times(last.inverse, {last.x, last.y}));
        k.x -= passed.x;
        k.y -= passed.y;
    }
    for (std::size_t i = links.size(); i-- > 0;) {
        ChainLink& k = links[i];
        if (i + 1 < links.size() && !links[i + 1].begins) {
            Pair passed = transposed_times(links[i + 1].before, {links[i + 1].x, links[i + 1].y});
            k.x -= passed.x;
            k.y -= passed.y;
        }
        Pair push = times(k.inverse, {k.x, k.y});
        k.x = push.x;
        k.y = push.y;
    }
    for (ChainLink& k : links) {
        Vec2 after = clamped(k.impulse + Vec2{static_cast<float>(k.x), static_cast<float>(k.y)}, kMaxForce);
        push_both(k, bodies, after - k.impulse);
        k.impulse = after;
    }
}

void ask(ChainLink& k, Vec2 wrong) {
    k.x = -double(wrong.x);
    k.y = -double(wrong.y);
}

} // namespace

void begin_chains(std::span<ChainLink> links, std::span<const SolverBody> bodies, const JointPass& pass) {
    refresh(links, bodies, pass);
}

void warm_chains(std::span<const ChainLink> links, std::span<SolverBody> bodies) {
    for (const ChainLink& k : links) push_both(k, bodies, k.impulse);
}

void move_chains(std::span<ChainLink> links, std::span<SolverBody> bodies, const JointPass& pass) {
    float rate = pass.chain.pull / pass.chain.keep;
    for (ChainLink& k : links) {
        const SolverBody &a = bodies[k.a], &b = bodies[k.b];
        Vec2 now = speed(b, k.arm_b) + bend(b, k.arm_b, pass) - (speed(a, k.arm_a) + bend(a, k.arm_a, pass));
        ask(k, now + rate * k.error);
        k.x -= k.give_x * double(k.impulse.x);
        k.y -= k.give_y * double(k.impulse.y);
    }
    solve(links, bodies);
}

void calm_chains(std::span<ChainLink> links, std::span<SolverBody> bodies, const JointPass& pass) {
    refresh(links, bodies, pass);
    for (ChainLink& k : links) ask(k, speed(bodies[k.b], k.arm_b) - speed(bodies[k.a], k.arm_a));
    solve(links, bodies);
    for (ChainLink& k : links) k.total += k.impulse;
}

} // namespace evil
