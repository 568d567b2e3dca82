#pragma once
// Characters (SPEC P9): bodies that walk, jump and climb as a player wishes, rather than as masses do.
//
// A character's body is kinematic: the solver moves it by the velocity that move_characters gives it, so what stands on it
// or leans on it meets a moving body like any other. What it meets itself is found out beforehand by casts and planes.
#include "bodies.hpp"
#include <vector>

namespace evil {

struct World;

// What it can do. Metres, seconds; speeds along the ground.
struct Abilities {
    float speed = 5.0f, acceleration = 60.0f, deceleration = 60.0f;
    float air_acceleration = 30.0f, air_deceleration = 10.0f;
    float jump_height = 2.0f;     // of a jump that is held to the end
    float jump_cut = 0.4f;        // share of the upward speed that is kept when the jump is let go early
    float coyote_time = 0.1f;     // after it left the ground, a jump still counts as one from there
    float jump_buffer = 0.1f;     // a jump wished for so early still comes when it lands
    std::uint32_t air_jumps = 0;  // before it must land again
    float gravity_scale = 2.0f;   // times the world's gravity: characters jump higher and fall sooner than stones
    float fall_speed = 25.0f;     // most
    float max_slope = 0.8726646f; // radians: the steepest slope that it walks on (50 degrees)
    float step_height = 0.3f;     // what it steps onto, and down from, without a jump
    float climb_speed = 3.0f;     // on ladders
    float push_force = 40.0f;     // newtons on what stands in its way
    float mass = 1.0f;            // kilograms, where it meets what is not fixed
};

struct Wish {                        // what the player wants, until told otherwise
    float move = 0.0f, climb = 0.0f; // -1 to 1: to the left and right, down and up
    bool jump = false;               // is the jump held?
};

struct Ladder { // world coordinates
    Vec2 low, high;
};

struct Character { // State
    std::uint32_t body = kNone;
    Abilities abilities;
    Wish wish;
    std::vector<Ladder> ladders;

    Vec2 velocity; // its own: relative to the ground that it stands on, else to the world
    bool grounded = false, climbing = false, rising = false; // rising: in a jump that may be cut
    bool crushed = false;
    std::uint32_t ground = kNone; // the body that it stands on
    Vec2 ground_normal, ground_velocity;
    Vec2 wall;                                 // direction out of a slope too steep that it touched; 0: none
    float since_ground = 1e9f;                 // seconds
    float belt = 0.0f;                         // m/s to the right that the ground's surface runs on its body
    float dropping = 0.0f;                     // seconds for which platforms that are solid from above are air to it
    float jump_wanted = 0.0f;                  // seconds that a wish to jump still lasts
    std::uint32_t jumps_left = 0;              // in the air
    bool jumped = false, begins_crush = false; // results of the last step
    float landing = 0.0f;                      // m/s at which it landed in the last step, else 0
};

// The side of an obstacle. `gap` is how far the character is from it, negative inside.
struct Plane {
    Vec2 normal; // towards the character
    float gap = 0.0f;
    Vec2 point;
    Vec2 velocity; // of the obstacle there
    std::uint32_t body = kNone;
    BodyKind kind = BodyKind::fixed;
    float push = 0.0f; // metres by which it moved the character, while planes are solved
};

struct Characters {
    std::vector<Character> rows; // State, in the order in which they were made
    std::vector<Plane> planes;   // Scratch
};

Character* character_of(Characters& characters, std::uint32_t body);
void forget_character(Characters& characters, std::uint32_t body); // its body, or what it stood on, is gone
// A new one, on a kinematic body. Its velocity is its own.
Character& add_character(World& world, std::uint32_t body, const Abilities& abilities);
void launch(Character& character, Vec2 velocity); // in world coordinates: what leads off the ground lifts it
bool hold_together(const Characters& characters, const std::vector<bool>& body_taken); // of a snapshot that was read

// Gives each character's body the velocity for the step to come, and pushes what stands in its way.
void move_characters(World& world, float dt);

} // namespace evil
