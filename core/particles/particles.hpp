#pragma once
// Particle effects (SPEC G8): sparks, dust, rain. One emitter and what it has let go of, in arrays.
//
// Particles touch bodies and are not felt by them, so nothing of the physics depends on what is only seen. They move by
// fixed steps all the same: the same seed and the same world give the same particles on every machine.
#include "draw/draw_list.hpp"
#include "refs.hpp"
#include <array>
#include <memory>
#include <span>
#include <vector>

namespace evil {
struct World;
}

namespace evil::particles {

struct Range {
    float least = 0.0f, most = 0.0f;
};

inline constexpr int kKnots = 64;                // entries of a curve over a life: finer than an eye can follow
inline constexpr std::uint32_t kMost = 1u << 20; // alive in one emitter

struct Curves {                               // over a life, from its beginning to its end
    std::array<float, kKnots> size{}, pace{}; // metres across; factor of the speed
    std::array<draw::Rgba8, kKnots> colour{};
};

struct Definition {
    BodyRef body;                        // slot kNone: it stands by itself
    Vec2 at;                             // in the body's frame, or the world's
    float direction = 0.0f, cone = 0.0f; // radians: the middle of where they fly, and the whole width of that
    float rate = 0.0f;                   // births a second
    Vec2 half;                           // of the rectangle that they are born in
    float radius = 0.0f;                 // of the disc, if the rectangle is empty
    Range life{1, 1}, speed, spin;       // seconds, m/s, rad/s
    float varies = 0.0f;                 // by how much of their size they differ, 0..1
    float gravity_scale = 1.0f,
          drag = 0.0f; // drag: share of the speed against the wind that goes each second, small shares
    Vec2 wind;         // m/s
    bool collides = false, dies = false; // dies: where it touches something
    float bounce = 0.0f, friction = 0.0f;
    std::uint32_t mask = 0xffffffffu; // categories of shapes that it touches
    std::uint32_t most = 0;           // alive at once; who would be born beyond that is not
};

struct Look {
    draw::SpeckForm form = draw::SpeckForm::soft;
    draw::Blend blend = draw::Blend::over;
    bool lit = false;     // they take the light of where they are
    float stretch = 0.0f; // seconds of its way that a particle is long; 0: as long as wide
    std::uint32_t texture = draw::kNoTexture;
    std::int32_t layer = 0;
};

enum Column {
    kX,
    kY,
    kVx,
    kVy,
    kPart,
    kAgeing,
    kSize,
    kTurn,
    kSpin,
    kColumns
}; // part of its life, and how much a second

struct State { // saved; rows are in the order of birth
    std::uint64_t random = 0;
    float owed = 0.0f; // part of a birth that the rate has not yet brought about
    std::uint32_t count = 0;
    std::array<std::vector<float>, kColumns> columns; // room for whole lanes beyond `count`
};

struct Obstacles;

struct Emitter {
    Emitter();
    ~Emitter();
    Definition definition;
    Curves curves;
    Look look;
    bool running = true;
    State state;
    std::unique_ptr<Obstacles> obstacles; // scratch
};

// One step of `dt` seconds: what there is moves, touches, ages and dies; then what is due is born, as long as the emitter
// runs and its body is there.
void step(Emitter& emitter, World& world, float dt);

// Lets go of that many at once; as many as there is room for.
void burst(Emitter& emitter, const World& world, std::uint32_t count);

// Appends them to a frame, above the drawings of their layer. Emitters come in the order of their layers. `alpha` and
// `dt`: which part of the last step has passed. `square`: a mesh of corners (0,0) to (1,1). `tint`: of
// their layer.
void collect(const Emitter& emitter, const Affine& view, float alpha, float dt, Vec2 screen, std::uint32_t square,
             draw::Rgba8 tint, draw::DrawList& out);

std::vector<std::uint8_t> snapshot(const State& state);
bool restore(State& state, std::span<const std::uint8_t> bytes, std::uint32_t most); // false: they are none

} // namespace evil::particles
