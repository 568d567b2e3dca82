#include "particles/particles.hpp"
#include "archive.hpp"
#include "draw/layers.hpp"
#include "draw/scene.hpp"
#include "particles/obstacles.hpp"
#include "particles/particles_wide.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>

namespace evil::particles {
namespace {

constexpr float kSkin = 0.001f;    // metres off what was touched: at zero, the next step would begin inside it
constexpr float kGentle = 0.2f;    // m/s: what touches slower than this stays down, or it would hop for ever
constexpr float kFarthest = 1e12f; // metres, and whatever else: farther than any life leads from the edge of the world
constexpr std::uint32_t kLanes = 8;

// SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators").
std::uint64_t next(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}
float chance(std::uint64_t& state) { return static_cast<float>(next(state) >> 40) * 0x1p-24f; } // 0 to 1, 1 left out
float within(std::uint64_t& state, Range range) { return range.least + (range.most - range.least) * chance(state); }

int knot(float part) { return static_cast<int>(std::clamp(part, 0.0f, 1.0f) * (kKnots - 1) + 0.5f); }

bool is_paced(const Curves& curves) {
    return std::ranges::any_of(curves.pace, [](float pace) { return pace != 1.0f; });
}

void make_room(State& state, std::uint32_t count) {
    const std::size_t room = (count + kLanes - 1) / kLanes * kLanes;
    for (std::vector<float>& column : state.columns)
        if (column.size() < room) column.resize(std::max(room, 2 * column.size()), 0.0f);
}

struct Place { // of an emitter's body, or the world's origin
    Pose pose;
    double angle = 0.0;
};

Vec2 birthplace(const Definition& d, std::uint64_t& random) {
    if (d.half.x > 0.0f || d.half.y > 0.0f)
        return d.at + Vec2{within(random, {-d.half.x, d.half.x}), within(random, {-d.half.y, d.half.y})};
    if (d.radius <= 0.0f) return d.at;
    const SinCos way = sincos(2.0 * kPi * chance(random)); // the root spreads them evenly over the disc
    return d.at + d.radius * std::sqrt(chance(random)) * Vec2{way.cos, way.sin};
}

// One more, which has been there for `since` seconds already.
void bear(Emitter& emitter, const Place& place, float since) {
    const Definition& d = emitter.definition;
    State& s = emitter.state;
    const std::uint32_t i = s.count++;
    const Vec2 at = transform(place.pose, birthplace(d, s.random));
    const SinCos way = sincos(place.angle + d.direction + d.cone * (chance(s.random) - 0.5f));
    const Vec2 velocity = within(s.random, d.speed) * Vec2{way.cos, way.sin};
    const float ageing = 1.0f / within(s.random, d.life), pace = emitter.curves.pace[0];
    const float row[kColumns] = {at.x + velocity.x * pace * since,
                                 at.y + velocity.y * pace * since,
                                 velocity.x,
                                 velocity.y,
                                 ageing * since,
                                 ageing,
                                 1.0f - d.varies * chance(s.random),
                                 0.0f,
                                 within(s.random, d.spin)};
    for (int column = 0; column < kColumns; ++column) s.columns[column][i] = row[column];
    if (d.spin.least != 0.0f || d.spin.most != 0.0f)
        s.columns[kTurn][i] = static_cast<float>(2.0 * kPi) * chance(s.random);
}

bool is_there(const Emitter& emitter, const World& world) {
    return emitter.definition.body.slot == kNone || world.bodies.slots.alive(emitter.definition.body);
}

// Where the emitter is `part` of the way through the last step.
Place place_at(const Emitter& emitter, const World& world, float part) {
    const std::uint32_t body = emitter.definition.body.slot;
    if (body == kNone) return {};
    const Pose pose = draw::between(world.previous[body], world.bodies.rows[body].pose, part);
    return {pose, double{atan2(pose.q.s, pose.q.c)}};
}

std::uint32_t room_of(const Emitter& emitter) {
    const std::uint32_t most = std::min(emitter.definition.most, kMost);
    return most - std::min(most, emitter.state.count);
}

void bear_what_is_due(Emitter& emitter, const World& world, float dt) {
    if (!emitter.running || !is_there(emitter, world)) return;
    State& s = emitter.state;
    s.owed += emitter.definition.rate * dt;
    const float due = std::floor(s.owed);
    s.owed -= due;
    const auto births = static_cast<std::uint32_t>(std::min(due, static_cast<float>(room_of(emitter))));
    make_room(s, s.count + births);
    for (std::uint32_t k = 0; k < births; ++k) { // spread over the step, or a fast stream would come in clots
        const float part = (static_cast<float>(k) + chance(s.random)) / static_cast<float>(births);
        bear(emitter, place_at(emitter, world, part), (1.0f - part) * dt);
    }
}

void move(Emitter& emitter, const World& world, float dt) {
    const Definition& d = emitter.definition;
    auto& c = emitter.state.columns;
    Motion motion{dt,
                  static_cast<float>(exponential(-double{d.drag} * dt)),
                  d.wind.x,
                  d.wind.y,
                  world.gravity.x * d.gravity_scale * dt,
                  world.gravity.y * d.gravity_scale * dt,
                  nullptr,
                  kKnots};
    if (is_paced(emitter.curves)) motion.pace = emitter.curves.pace.data();
    const Columns columns{c[kX].data(),    c[kY].data(),    c[kVx].data(),     c[kVy].data(),
                          c[kPart].data(), c[kTurn].data(), c[kAgeing].data(), c[kSpin].data()};
    EVIL_PICK(world.instruction_set, move_particles)(motion, columns, static_cast<int>(emitter.state.count));
}

//      \  ^ n        what comes in keeps `bounce` of its speed across,
//       \ | _        and loses along it what friction takes (Coulomb's law)
//   _____\|/___
Vec2 thrown_back(Vec2 velocity, const Touch& touch, const Definition& d) {
    const Vec2 relative = velocity - touch.velocity, along = left_of(touch.normal);
    const float into = dot(relative, touch.normal);
    if (into >= 0.0f) return velocity;
    const float bounce = into < -kGentle ? d.bounce : 0.0f;
    const float slide = dot(relative, along), held = d.friction * (1.0f + bounce) * -into;
    const float left = slide > held ? slide - held : slide < -held ? slide + held : 0.0f;
    return touch.velocity - bounce * into * touch.normal + left * along;
}

void touch_all(Emitter& emitter, const World& world, std::span<const float> from_x, std::span<const float> from_y) {
    State& s = emitter.state;
    auto& c = s.columns;
    Bounds bounds{{c[kX][0], c[kY][0]}, {c[kX][0], c[kY][0]}};
    for (std::uint32_t i = 0; i < s.count; ++i) {
        const Vec2 from{from_x[i], from_y[i]}, to{c[kX][i], c[kY][i]};
        bounds = {min(bounds.low, min(from, to)), max(bounds.high, max(from, to))};
    }
    gather(*emitter.obstacles, world, bounds, emitter.definition.mask);
    if (emitter.obstacles->rows.empty()) return;
    for (std::uint32_t i = 0; i < s.count; ++i) {
        const auto touch = first_touch(*emitter.obstacles, world, {from_x[i], from_y[i]}, {c[kX][i], c[kY][i]});
        if (!touch) continue;
        const Vec2 at = touch->point + kSkin * touch->normal;
        const Vec2 velocity = thrown_back({c[kVx][i], c[kVy][i]}, *touch, emitter.definition);
        c[kX][i] = at.x, c[kY][i] = at.y, c[kVx][i] = velocity.x, c[kVy][i] = velocity.y;
        if (emitter.definition.dies) c[kPart][i] = 1.0f;
    }
}

void bury(State& s) { // those whose life is over; the others close up
    auto& c = s.columns;
    std::uint32_t kept = 0;
    while (kept < s.count && c[kPart][kept] < 1.0f) ++kept;
    for (std::uint32_t i = kept; i < s.count; ++i) {
        if (!(c[kPart][i] < 1.0f)) continue;
        for (std::vector<float>& column : c) column[kept] = column[i];
        ++kept;
    }
    s.count = kept;
}

// ---- drawing -------------------------------------------------------------------------------------------------------

constexpr float kFinest = 0.6f; // pixels: what is smaller is drawn as large, and fainter, so that it does not flicker

draw::Rgba8 fainter(draw::Rgba8 colour, float share) {
    const auto alpha = static_cast<draw::Rgba8>(static_cast<float>(colour >> 24) * share + 0.5f);
    return (colour & 0x00ffffffu) | alpha << 24;
}

draw::Speck speck_of(Vec2 at, Vec2 along, float radius, draw::Rgba8 colour) {
    draw::Speck speck{at, {radius, 0.0f}, radius, colour};
    if (radius < kFinest) {
        speck.colour = fainter(colour, radius * radius / (kFinest * kFinest));
        speck.along.x = speck.across = kFinest;
    }
    const float half = length(along);
    if (!(half > speck.across)) return speck;
    if (radius < kFinest) speck.colour = fainter(colour, radius / kFinest);
    speck.along = along;
    return speck;
}

draw::Instance picture_of(Vec2 at, Rot turn, const Affine& view, float half, draw::Rgba8 colour, const Look& look,
                          std::uint32_t square) {
    const Vec2 x = half * apply_linear(view, {turn.c, turn.s}), y = half * apply_linear(view, {turn.s, -turn.c});
    const Vec2 corner = at - x - y;
    return {{2 * x.x, 2 * x.y, 2 * y.x, 2 * y.y, corner.x, corner.y},
            {},
            square,
            look.texture,
            colour,
            0.0f,
            look.blend,
            look.lit};
}

struct Seen { // a particle on the screen
    Vec2 at;
    float half; // metres
    draw::Rgba8 colour;
    Vec2 velocity;
    float turn;
};

// Calls back for each particle that may be seen, from the oldest to the youngest.
template <class Visit>
void each_seen(const Emitter& emitter, const Affine& view, float back, float scale, Vec2 screen, draw::Rgba8 tint,
               Visit visit) {
    const State& s = emitter.state;
    const auto& c = s.columns;
    const float stretch = emitter.look.stretch;
    for (std::uint32_t i = 0; i < s.count; ++i) {
        const int k = knot(c[kPart][i]);
        const draw::Rgba8 colour = draw::multiplied(emitter.curves.colour[k], tint);
        const Vec2 velocity = emitter.curves.pace[k] * Vec2{c[kVx][i], c[kVy][i]};
        const Vec2 at = apply(view, Vec2{c[kX][i], c[kY][i]} - back * velocity);
        const float half = 0.5f * emitter.curves.size[k] * c[kSize][i];
        float reach = 1.5f * scale * half + 1.0f;
        if (stretch > 0.0f) reach += scale * stretch * length(velocity);
        const bool seen = at.x > -reach && at.y > -reach && at.x < screen.x + reach && at.y < screen.y + reach;
        if (seen && half > 0.0f && colour >> 24) visit(Seen{at, half, colour, velocity, c[kTurn][i]});
    }
}

void insert_pictures(const Emitter& emitter, const Affine& view, float back, float scale, Vec2 screen,
                     std::uint32_t square, draw::Rgba8 tint, draw::DrawList& out) {
    const auto first = static_cast<std::uint32_t>(out.instances.size());
    each_seen(emitter, view, back, scale, screen, tint, [&](const Seen& p) {
        const Rot turn = p.turn == 0.0f ? Rot{} : rotation(p.turn);
        out.instances.push_back(picture_of(p.at, turn, view, p.half, p.colour, emitter.look, square));
    });
    draw::move_to_layer(out, first, emitter.look.layer);
}

} // namespace

Emitter::Emitter() : obstacles(std::make_unique<Obstacles>()) {}
Emitter::~Emitter() = default;

void step(Emitter& emitter, World& world, float dt) {
    State& s = emitter.state;
    if (s.count > 0) {
        const bool touches = emitter.definition.collides;
        std::vector<float>&from_x = emitter.obstacles->from_x, &from_y = emitter.obstacles->from_y;
        if (touches) from_x = s.columns[kX], from_y = s.columns[kY];
        move(emitter, world, dt);
        if (touches) touch_all(emitter, world, from_x, from_y);
        bury(s);
    }
    bear_what_is_due(emitter, world, dt);
}

void burst(Emitter& emitter, const World& world, std::uint32_t count) {
    if (!is_there(emitter, world)) return;
    const std::uint32_t births = std::min(count, room_of(emitter));
    make_room(emitter.state, emitter.state.count + births);
    const Place place = place_at(emitter, world, 1.0f);
    for (std::uint32_t k = 0; k < births; ++k) bear(emitter, place, 0.0f);
}

void collect(const Emitter& emitter, const Affine& view, float alpha, float dt, Vec2 screen, std::uint32_t square,
             draw::Rgba8 tint, draw::DrawList& out) {
    const float back = (1.0f - alpha) * dt, scale = std::sqrt(std::fabs(determinant(view)));
    const float stretch = 0.5f * emitter.look.stretch;
    if (emitter.look.texture != draw::kNoTexture)
        return insert_pictures(emitter, view, back, scale, screen, square, tint, out);
    std::vector<draw::Speck>& specks = out.interludes.specks;
    draw::Interlude run;
    run.before = draw::end_of_layer(out, emitter.look.layer);
    run.first = static_cast<std::uint32_t>(specks.size());
    run.form = emitter.look.form, run.blend = emitter.look.blend, run.lit = emitter.look.lit;
    each_seen(emitter, view, back, scale, screen, tint, [&](const Seen& p) {
        const Vec2 along = stretch > 0.0f ? stretch * apply_linear(view, p.velocity) : Vec2{};
        specks.push_back(speck_of(p.at, along, scale * p.half, p.colour));
    });
    run.count = static_cast<std::uint32_t>(specks.size()) - run.first;
    if (run.count > 0) out.interludes.rows.push_back(run);
}

// ---- saving --------------------------------------------------------------------------------------------------------

std::vector<std::uint8_t> snapshot(const State& state) {
    BytesWriter ar;
    visit(ar, state.random, state.owed);
    ar.count(state.count);
    for (const std::vector<float>& column : state.columns)
        for (std::uint32_t i = 0; i < state.count; ++i) ar.value(column[i]);
    return ar.take();
}

bool restore(State& state, std::span<const std::uint8_t> bytes, std::uint32_t most) {
    Reader ar(bytes);
    State read;
    visit(ar, read.random, read.owed);
    const std::size_t count = ar.count(0, kColumns * sizeof(float));
    if (!ar.ok || count > std::min(most, kMost)) return false;
    read.count = static_cast<std::uint32_t>(count);
    make_room(read, read.count);
    for (std::vector<float>& column : read.columns)
        for (std::uint32_t i = 0; i < read.count; ++i) {
            ar.value(column[i]);
            ar.ok &= std::fabs(column[i]) <= kFarthest;
        }
    const bool sound = ar.ok && ar.at_end() && read.owed >= 0.0f && read.owed < 1.0f;
    if (sound) state = std::move(read);
    return sound;
}

} // namespace evil::particles
