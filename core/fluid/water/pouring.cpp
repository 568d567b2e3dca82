#include "fluid/water/pouring.hpp"
#include "fluid/rows.hpp"
#include "fluid/water/box.hpp"
#include "fluid/water/scratch.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kApart = 0.75f; // of a particle: new ones keep so far from others, or the pressure would throw them off
constexpr float kInJet = 0.6f;  // and in a jet, which lies as it should
constexpr float kBank = 0.125f; // cells: and so far from bodies
constexpr float kWholly = 1.001f;   // times what an area lets through: as much as that, as numbers are rounded
constexpr int kTries = 3;           // spots that are looked at for each particle that is due
constexpr float kMostDue = 4096.0f; // particles of one stream in a step: a torrent may not hold up the frame

// The n-th of a row of points that fill a unit cube evenly wherever the row is cut: multiples of the powers of the root
// of x^4 = x + 1 (the recurrence that Kronecker's theorem makes dense), in whole numbers, so exact.
struct Spot {
    float x, y, late; // late: which part of the step it has been under way
};
Spot spot(std::uint64_t n) {
    auto part = [n](std::uint64_t step) { return static_cast<float>((n * step) >> 40) * 0x1p-24f; };
    return {part(0xd1b54a32d192ed03u), part(0xabc98388fb8fac02u), part(0x8cb92ba72f3d8dd7u)};
}

Pose pose_of(const Stream& stream, const World& world) {
    return stream.body == kNone ? Pose{} : world.bodies.rows[stream.body].pose;
}

Box turned(const Box& box, const Pose& pose) {
    const Vec2 first = transform(pose, box.low);
    Box round{first, first};
    for (Vec2 corner : {Vec2{box.high.x, box.low.y}, Vec2{box.low.x, box.high.y}, box.high}) {
        const Vec2 p = transform(pose, corner);
        round.low = min(round.low, p), round.high = max(round.high, p);
    }
    return round;
}

Vec2 place_of(const Particles& p, std::size_t k) { return {p.positions[2 * k], p.positions[2 * k + 1]}; }

// Which particles are near, by squares as large as one.
class Neighbours {
public:
    Neighbours(PouringRoom& room, const Water& water, const Box& box) : room_(room), size_(water.particle_size) {
        const Grid& g = water.grid;
        const Vec2 end = g.low + g.h * Vec2{static_cast<float>(g.nx), static_cast<float>(g.ny)}, rim{size_, size_};
        box_ = {max(box.low - rim, g.low), min(box.high + rim, end)};
        if (!(box_.low.x < box_.high.x && box_.low.y < box_.high.y)) return;
        wide_ = 1 + static_cast<int>((box_.high.x - box_.low.x) / size_);
        high_ = 1 + static_cast<int>((box_.high.y - box_.low.y) / size_);
        room_.first.assign(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_), -1);
        room_.places.clear(), room_.next.clear();
        for (std::size_t k = 0; k < water.count; ++k)
            if (const Vec2 at = place_of(*water.particles, k); box_.holds(at)) note(at);
    }

    bool reaches(Vec2 at) const { return wide_ > 0 && box_.holds(at); }
    void note(Vec2 at) {
        std::int32_t& first = room_.first[square(column(at.x), row(at.y))];
        room_.next.push_back(first);
        first = static_cast<std::int32_t>(room_.places.size());
        room_.places.push_back(at);
    }
    bool any_within(Vec2 at, float distance) const {
        const int i = column(at.x), j = row(at.y);
        for (int y = std::max(j - 1, 0); y <= std::min(j + 1, high_ - 1); ++y)
            for (int x = std::max(i - 1, 0); x <= std::min(i + 1, wide_ - 1); ++x)
                for (std::int32_t k = room_.first[square(x, y)]; k >= 0; k = room_.next[static_cast<std::size_t>(k)])
                    if (length_squared(room_.places[static_cast<std::size_t>(k)] - at) < distance * distance)
                        return true;
        return false;
    }

private:
    int column(float x) const { return std::clamp(static_cast<int>((x - box_.low.x) / size_), 0, wide_ - 1); }
    int row(float y) const { return std::clamp(static_cast<int>((y - box_.low.y) / size_), 0, high_ - 1); }
    std::size_t square(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(x);
    }
    PouringRoom& room_;
    float size_;
    Box box_{};
    int wide_ = 0, high_ = 0;
};

bool in_the_way(const Water& water, Vec2 at) {
    const Vec2 place = (1.0f / water.grid.h) * (at - water.grid.low);
    return bank_at(water, place.x, place.y).distance < kBank;
}

void put(Water& water, Vec2 at, Vec2 velocity, std::uint32_t liquid) {
    Particles& p = *water.particles;
    const std::size_t k = water.count++;
    p.positions[2 * k] = at.x, p.positions[2 * k + 1] = at.y;
    p.velocities[2 * k] = velocity.x, p.velocities[2 * k + 1] = velocity.y;
    std::fill_n(p.affine.begin() + static_cast<std::ptrdiff_t>(4 * k), 4, 0.0f);
    p.liquid[k] = static_cast<std::uint8_t>(liquid);
}

struct Pouring { // a stream as it pours within a step
    const World& world;
    Water& water;
    Stream& stream;
    Box box; // of its area, as far as it is in the water
    float dt;
};

// Puts a particle there, moving on for `late` seconds, if there is room for it.
bool put_if_free(const Pouring& p, Neighbours& near, Vec2 inside, float late, float apart) {
    const Stream& s = p.stream;
    const Pose pose = pose_of(s, p.world);
    if (!contains(s.area, inside)) return false;
    const Vec2 at = transform(pose, inside + late * s.velocity);
    if (!near.reaches(at) || in_the_way(p.water, at) || near.any_within(at, apart * p.water.particle_size))
        return false;
    if (!make_room(p.water, p.water.count + 1)) return false;
    Vec2 velocity = s.velocity;
    if (s.body != kNone) {
        const Body& b = p.world.bodies.rows[s.body];
        velocity = rotate(b.pose.q, velocity) + velocity_at(b, at);
    }
    put(p.water, at, {clamped(velocity.x, kMostSwim), clamped(velocity.y, kMostSwim)}, s.liquid);
    near.note(at);
    return true;
}

// A jet: one after the other from a line across the middle of the area, which is so long that the jet is as full as what
// is at rest. Multiples of the golden section lie evenly on it, and with their times in the jet.
void pour_jet(const Pouring& p, Neighbours& near, float wide) {
    Stream& s = p.stream;
    const float size = p.water.particle_size, each = s.rate / (size * size);
    const Vec2 across = wide * left_of(normalised(s.velocity)), middle = 0.5f * (p.box.low + p.box.high);
    for (int tries = kTries * static_cast<int>(s.due); tries > 0 && s.due >= 1.0f; --tries) {
        const float part = static_cast<float>((s.poured++ * 0x9e3779b97f4a7c15u) >> 40) * 0x1p-24f;
        const float late = std::min((s.due - 1.0f) / each, p.dt);
        if (put_if_free(p, near, middle + (part - 0.5f) * across, late, kInJet)) s.due -= 1.0f;
    }
}

// What is too slow to leave its area as it comes, or to stay together as it falls: wherever there is room in it.
void pour_anywhere(const Pouring& p, Neighbours& near) {
    Stream& s = p.stream;
    const Vec2 extent = p.box.high - p.box.low;
    for (int tries = kTries * static_cast<int>(s.due); tries > 0 && s.due >= 1.0f; --tries) {
        const Spot where = spot(s.poured++);
        const Vec2 inside = p.box.low + Vec2{where.x * extent.x, where.y * extent.y};
        if (put_if_free(p, near, inside, where.late * p.dt, kApart)) s.due -= 1.0f;
    }
}

void pour(const World& world, Water& water, Stream& s, float dt) {
    const float size = water.particle_size;
    Box box = box_of(s.area);
    if (s.body == kNone) {
        const Grid& g = water.grid;
        box = {max(box.low, g.low),
               min(box.high, g.low + g.h * Vec2{static_cast<float>(g.nx), static_cast<float>(g.ny)})};
    }
    const Vec2 extent = box.high - box.low;
    if (!(extent.x > 0.0f && extent.y > 0.0f)) return;
    const float most = std::min(1.0f + extent.x * extent.y / (size * size), kMostDue);
    s.due = std::min(s.due + s.rate * dt / (size * size), most);
    if (s.due < 1.0f) return;
    Box round = turned(box, pose_of(s, world));
    const float speed = length(s.velocity), drift = dt * speed; // those that are under way already are so far out of it
    round.low = round.low - Vec2{drift, drift}, round.high = round.high + Vec2{drift, drift};
    Neighbours near(water.scratch->pouring, water, round);
    const Pouring pouring{world, water, s, box, dt};
    const Vec2 across = left_of(normalised(s.velocity));
    const float room = std::fabs(across.x) * extent.x + std::fabs(across.y) * extent.y;
    const float wide = s.rate / std::max(speed, 1e-6f);
    if (wide <= kWholly * room && speed * speed >= wide * length(world.gravity))
        pour_jet(pouring, near, std::min(wide, room));
    else
        pour_anywhere(pouring, near);
}

// Takes out those of a rising row; the others keep their order.
void take_out(Water& water, const std::vector<std::uint32_t>& gone) {
    if (gone.empty()) return;
    Particles& p = *water.particles;
    std::size_t to = gone[0], next = 0;
    for (std::size_t from = to; from < water.count; ++from) {
        if (next < gone.size() && gone[next] == from) {
            ++next;
            continue;
        }
        std::copy_n(p.positions.begin() + static_cast<std::ptrdiff_t>(2 * from), 2,
                    p.positions.begin() + static_cast<std::ptrdiff_t>(2 * to));
        std::copy_n(p.velocities.begin() + static_cast<std::ptrdiff_t>(2 * from), 2,
                    p.velocities.begin() + static_cast<std::ptrdiff_t>(2 * to));
        std::copy_n(p.affine.begin() + static_cast<std::ptrdiff_t>(4 * from), 4,
                    p.affine.begin() + static_cast<std::ptrdiff_t>(4 * to));
        p.liquid[to++] = p.liquid[from];
    }
    water.count = to;
}

void find_inside(const Water& water, const Area& area, const Pose& pose, std::vector<std::uint32_t>& found) {
    const Box round = turned(box_of(area), pose);
    found.clear();
    for (std::size_t k = 0; k < water.count; ++k) {
        const Vec2 at = place_of(*water.particles, k);
        if (round.holds(at) && contains(area, untransform(pose, at))) found.push_back(static_cast<std::uint32_t>(k));
    }
}

void drain(const World& world, Water& water, Stream& s, float dt) {
    std::vector<std::uint32_t>& inside = water.scratch->pouring.gone;
    find_inside(water, s.area, pose_of(s, world), inside);
    if (-s.rate < kMostPouring) { // so many, evenly out of all
        const float size = water.particle_size, there = static_cast<float>(inside.size());
        s.due = std::min(s.due - s.rate * dt / (size * size), there + 1.0f);
        const auto many = std::min(static_cast<std::size_t>(s.due), inside.size());
        for (std::size_t k = 0; k < many; ++k) inside[k] = inside[(2 * k + 1) * inside.size() / (2 * many)];
        inside.resize(many);
        s.due -= static_cast<float>(many);
    }
    take_out(water, inside);
}

} // namespace

StreamRef add_stream(World& world, Stream stream) {
    Fluids& all = world.fluids;
    const std::uint32_t slot = add_row(world, all.stream_slots, all.streams, std::move(stream));
    return {slot, all.stream_slots.generation(slot)};
}

void destroy_stream(World& world, std::uint32_t stream) {
    world.fluids.streams[stream] = {};
    world.fluids.stream_slots.release(stream);
}

void apply_streams(World& world, Water& water, std::uint32_t slot, float dt) {
    Fluids& all = world.fluids;
    for (std::uint32_t i = 0; i < all.stream_slots.size(); ++i) {
        Stream& s = all.streams[i];
        if (!all.stream_slots.taken(i) || s.water != slot || !s.running) continue;
        if (s.rate > 0.0f) pour(world, water, s, dt);
        if (s.rate < 0.0f) drain(world, water, s, dt);
    }
}

std::size_t clear(Water& water, const Area& area) {
    std::vector<std::uint32_t>& inside = water.scratch->pouring.gone;
    find_inside(water, area, {}, inside);
    take_out(water, inside);
    return inside.size();
}

void stir(Water& water, Vec2 at, float radius, Vec2 velocity) {
    Particles& p = *water.particles;
    for (std::size_t k = 0; k < water.count; ++k) {
        const float far = length_squared(place_of(p, k) - at) / (radius * radius);
        if (!(far < 1.0f)) continue;
        const float share = (1.0f - far) * (1.0f - far);
        p.velocities[2 * k] += share * (velocity.x - p.velocities[2 * k]);
        p.velocities[2 * k + 1] += share * (velocity.y - p.velocities[2 * k + 1]);
    }
}

void settle(Water& water) {
    auto sound = [](float value, float low, float high) { return value >= low ? std::min(value, high) : low; };
    const Grid& g = water.grid;
    const float rim = 1e-3f * g.h, turn = kMostSwim / g.h;
    const Vec2 low = g.low + Vec2{rim, rim};
    const Vec2 high = g.low + g.h * Vec2{static_cast<float>(g.nx), static_cast<float>(g.ny)} - Vec2{rim, rim};
    Particles& p = *water.particles;
    for (std::size_t k = 0; k < water.count; ++k) {
        p.positions[2 * k] = sound(p.positions[2 * k], low.x, high.x);
        p.positions[2 * k + 1] = sound(p.positions[2 * k + 1], low.y, high.y);
        for (std::size_t d = 0; d < 2; ++d) p.velocities[2 * k + d] = clamped(p.velocities[2 * k + d], kMostSwim);
        for (std::size_t d = 0; d < 4; ++d) p.affine[4 * k + d] = clamped(p.affine[4 * k + d], turn);
    }
}

} // namespace evil::fluid
