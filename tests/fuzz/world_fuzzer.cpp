// A libFuzzer target over the core's World: the bytes are read as a life of it, or as a snapshot.
//
// The first byte decides. A life is a sequence of orders (make, move, destroy, tie, fill, pour, ask, save, step);
// everything that a caller must keep to is kept to here, as the bindings keep to it. A snapshot is read as a stranger's:
// whatever the bytes are, it is refused, or the world that comes of it can be stepped. AddressSanitizer and
// UndefinedBehaviorSanitizer watch, and no step may leave a number that is none.
//
// python tools/dev.py fuzz [seconds]
#include "bytes.hpp"
#include "collider/search.hpp"
#include "fluid_orders.hpp"
#include "hash.hpp"
#include "shapes/polygon.hpp"
#include "snapshot.hpp"
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace {

using namespace evil;
using fuzz::Bytes;

std::optional<NewShape> shape_of(Bytes& in) {
    NewShape made;
    Shape& s = made.shape;
    s.material.friction = static_cast<float>(in.byte()) / 100.0f;
    s.material.restitution = static_cast<float>(in.byte()) / 255.0f;
    switch (in.byte() % 4) {
    case 0:
        s.kind = ShapeKind::circle;
        s.radius = in.size();
        return made;
    case 1: {
        const Vec2 half{in.size(), in.size()};
        made.rings.corners = {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
        break;
    }
    case 2:
        s.kind = ShapeKind::line;
        s.radius = in.byte() % 2 ? in.size() : 0.0f;
        made.rings.corners = {{-in.size(), 0.0f}, {in.size(), 0.0f}};
        return made;
    default:
        for (int count = 3 + in.byte() % 6; count > 0; --count) made.rings.corners.push_back(in.point(1e4f));
    }
    s.kind = ShapeKind::polygon;
    if (check_polygon(made.rings).fault != PolygonFault::none) return {};
    make_counter_clockwise(made.rings.corners);
    made.parts = split_convex(made.rings);
    return made;
}

class Life {
public:
    explicit Life(Bytes in) : in_(in) {}

    void live() {
        for (int orders = 0; !in_.empty() && orders < 200; ++orders) order();
        step();
    }

private:
    World world_;
    Bytes in_;
    std::vector<std::uint8_t> saved_;

    std::optional<std::uint32_t> one_of(const auto& rows) { return fuzz::one_of(rows.slots, in_); }

    void order() {
        switch (in_.byte() % 22) {
        case 0:
        case 1:
        case 2:
            return add();
        case 3:
            if (auto body = one_of(world_.bodies)) destroy_body(world_, *body);
            return;
        case 4: {
            auto body = one_of(world_.bodies);
            auto shape = shape_of(in_);
            if (body && shape) add_shape(world_, *body, *shape);
            return;
        }
        case 5:
            if (auto shape = one_of(world_.shapes)) destroy_shape(world_, *shape);
            return;
        case 6:
            return tie();
        case 7:
            if (auto joint = one_of(world_.joints)) destroy_joint(world_, *joint);
            return;
        case 8:
            return push();
        case 9:
            if (auto force = one_of(world_.forces)) destroy_force(world_, *force);
            return;
        case 10:
            if (auto body = one_of(world_.bodies)) move_body(world_, *body, in_.point(1e7f), in_.number(1e6f));
            return;
        case 11:
            if (auto body = one_of(world_.bodies)) set_kind(world_, *body, static_cast<BodyKind>(in_.byte() % 3));
            return;
        case 12:
            if (auto body = one_of(world_.bodies)) {
                world_.bodies.rows[*body].velocity = in_.point(kMaxSpeed);
                world_.bodies.rows[*body].spin = in_.number(kMaxSpin);
                wake(world_, *body);
            }
            return;
        case 13:
            if (auto body = one_of(world_.bodies)) {
                const float c = in_.number(3.0f), s = in_.number(3.0f);
                (void)apply_to_body(world_, *body, {c, s, -s, c, in_.number(10.0f), in_.number(10.0f)});
            }
            return;
        case 14:
            return set_gravity(world_, in_.point(1e6f));
        case 15:
            return ask();
        case 16:
            return save();
        case 17:
            return load();
        case 18:
        case 19:
            return fuzz::order_fluids(world_, in_);
        default:
            return step();
        }
    }

    void add() {
        Body b;
        b.kind = static_cast<BodyKind>(std::min(in_.byte() % 6, 2));
        b.pose.p = in_.point(1e7f);
        b.angle = in_.number(1e6f);
        b.velocity = in_.point(kMaxSpeed);
        b.spin = in_.number(kMaxSpin);
        b.bullet = in_.byte() % 8 == 0;
        std::vector<NewShape> shapes;
        for (int count = 1 + in_.byte() % 3; count > 0; --count)
            if (auto shape = shape_of(in_)) shapes.push_back(*shape);
        if (world_.bodies.slots.count() < 64) add_body(world_, b, "", shapes);
    }

    void tie() {
        auto a = one_of(world_.bodies), b = one_of(world_.bodies);
        if (!a || !b || *a == *b || world_.joints.slots.count() > 64) return;
        Joint joint;
        joint.kind = in_.byte() % 2 ? JointKind::distance : JointKind::hinge;
        joint.body_a = *a, joint.body_b = *b;
        joint.anchor_a = in_.point(10.0f), joint.anchor_b = in_.point(10.0f);
        joint.collide = in_.byte() % 2;
        joint.along.held = true;
        joint.along.rest = in_.size();
        if (in_.byte() % 2) joint.breaking_force = 1.0f + static_cast<float>(in_.byte());
        add_joint(world_, joint);
    }

    void push() {
        auto body = one_of(world_.bodies), other = one_of(world_.bodies);
        if (!body || world_.forces.slots.count() > 32) return;
        Force force;
        force.kind = static_cast<ForceKind>(in_.byte() % 4);
        force.vector = in_.point(1e6f);
        force.anchor = in_.point(10.0f);
        force.stiffness = std::abs(in_.number(1e6f));
        force.rest_length = in_.size();
        force.damping = std::abs(in_.number(1e6f));
        force.linear = std::abs(in_.number(1e6f));
        force.quadratic = std::abs(in_.number(1e6f));
        if (force.kind == ForceKind::spring && *other != *body) force.target = *other;
        attach(world_, add_force(world_, force, {}).slot, *body);
    }

    void ask() {
        Scene scene = world_.scene();
        std::vector<RayHit> hits;
        std::vector<std::uint32_t> found;
        const Vec2 start = in_.point(1e7f), end = in_.point(1e7f);
        ray_cast(scene, start, end, {});
        ray_cast_all(scene, start, end, {}, hits);
        nearest(scene, start, std::abs(in_.number(1e7f)), {});
        bodies_at(scene, end, {}, found);
    }

    void save() {
        saved_.resize(snapshot_size(world_));
        write_snapshot(world_, saved_);
    }

    void load() { // what was saved is taken back whole, and is the same
        if (saved_.empty()) return;
        ReadSnapshot read = read_snapshot(saved_);
        if (!read.state) std::abort();
        restore(world_, *read.state);
        std::vector<std::uint8_t> again(snapshot_size(world_));
        write_snapshot(world_, again);
        if (again != saved_) std::abort();
    }

    void step() {
        static constexpr float kSteps[] = {1.0f / 60.0f, 1.0f / 60.0f, 1e-4f, 1.0f};
        world_.step(kSteps[in_.byte() % 4], 1 + in_.byte() % 8);
        check(world_);
    }

public:
    static void check(const World& world) {
        for (std::uint32_t slot = 0; slot < world.bodies.slots.size(); ++slot) {
            if (!world.bodies.slots.taken(slot)) continue;
            const Body& b = world.bodies.rows[slot];
            if (!is_finite(b.pose.p) || !is_finite(b.velocity) || !std::isfinite(b.spin) || !std::isfinite(b.angle))
                std::abort();
        }
        fuzz::check_fluids(world);
    }
};

// A payload under a head and a checksum that fit it, so that the bytes themselves are looked at.
std::vector<std::uint8_t> sealed(const std::uint8_t* data, std::size_t size) {
    std::vector<std::uint8_t> bytes{'E', 'V', 'I', 'L', 'W', 'R', 'L', 'D'};
    auto put = [&](std::uint64_t value, int count) {
        for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    put(kSnapshotVersion, 4);
    put(size, 8);
    bytes.insert(bytes.end(), data, data + size);
    put(hash({data, size}), 8);
    return bytes;
}

void load_a_strangers(std::span<const std::uint8_t> bytes) {
    ReadSnapshot read = read_snapshot(bytes);
    if (!read.state) return;
    World world;
    restore(world, *read.state);
    for (int n = 0; n < 3; ++n) world.step(1.0f / 60.0f, 4);
    Life::check(world);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    switch (data[0] % 4) {
    case 0:
        load_a_strangers({data + 1, size - 1});
        break;
    case 1:
        load_a_strangers(sealed(data + 1, size - 1));
        break;
    default:
        Life(Bytes(data + 1, size - 1)).live();
    }
    return 0;
}
