#pragma once
// What a character's shape meets: planes that keep it out where it is, and how far it can go.
#include "character/character.hpp"
#include "collider/search.hpp"

namespace evil {

inline constexpr float kSkin =
    kSlop; // metres kept between a character and what it touches: nothing sticks, nothing shows

struct Cast {
    float fraction = 1.0f;
    Vec2 normal, point; // towards the character; zero when nothing was met
    Vec2 velocity;
    std::uint32_t body = kNone;
    BodyKind kind = BodyKind::fixed;
    float belt = 0.0f;
};

// A character's shape, wherever it is asked about. Other characters are air to it.
class Mover {
public:
    Mover(World& world, const Character& character, Vec2 up, float dt);

    Mover(const Mover&) = delete; // its filters look at its own lists

    // The sides of what is nearer than `margin`, or may come so near within the step. What is kinematic is met where it
    // will be at the step's end, everything else where it is.
    void planes(const Pose& at, float margin, std::vector<Plane>& found) const;
    // How far it may go along `path`.
    Cast cast(const Pose& from, Vec2 path) const;
    // Casts meet this body no longer.
    void leave_to_planes(std::uint32_t body);
    // The way up from the surface that was met: at a corner, that of the face beside it.
    Vec2 floor_normal(const Cast& hit) const;
    // How far its shape reaches below and above the body's origin.
    Vec2 extent(const Pose& at) const;

private:
    Pose pose_of(const Target& target) const;
    bool solid(const Target& target, Vec2 normal, float gap) const;
    Vec2 velocity_of(const Target& target, Vec2 point, Vec2 normal) const;
    template <class Each> void each_piece(Each&& each) const;

    const Bodies& bodies_;
    const Shapes& shapes_;
    Scene scene_;
    std::vector<std::uint32_t> ignored_; // characters
    Filter filter_;
    std::vector<std::uint32_t> left_; // and what casts leave to planes
    Filter cast_filter_;
    std::uint32_t body_;
    Vec2 up_;
    float dt_;
    bool drop_;
};

// Where the shape may go that would like to move by `path`: the nearest point that no plane forbids.
Vec2 solve_planes(std::vector<Plane>& planes, Vec2 path);

} // namespace evil
