#pragma once
// What happened in a step, told after it (SPEC C10): contacts that began, ended or hit, sensors
// entered or left, bodies that fell asleep or woke.
// The order is a promise: that of creation, of the older body of a contact, then of the younger, then of their shapes.
#include "collider/contact.hpp"
#include <array>

namespace evil {

// Two shapes that touch, however many of their pieces do; or a sensor and what it sees.
struct Touch {
    BodyRef a, b; // a was created first, or has the sensor
    ShapeRef shape_a, shape_b;
    std::array<std::uint64_t, 4> order{}; // serials of the bodies, then of the shapes
    bool sensor = false;
    Vec2 point, normal; // normal from a to b
    float depth = 0.0f, impulse = 0.0f, speed = 0.0f;
};

struct Events {
    // State
    float hit_speed = 1.0f; // m/s: contacts that close faster are told as hits
    std::vector<Touch>
        lost; // touched when one of the two was destroyed, since the last step: their end is still to be told

    // Results of the last step
    std::vector<Touch> begun, ended, hit;
    std::vector<Touch> entered, left; // of sensors
    std::vector<BodyRef> slept, woke;

    struct Change { // a contact, or a piece's part in one, that may be told
        Touch touch;
        std::uint32_t number = 0; // in which order they were gathered
        bool was = false, is = false, struck = false;
    };
    struct { // Scratch
        std::vector<Change> changes;
    } scratch;
};

// After the solver: what is told of this step. Only what has changed is worked out in full.
// Bodies are asked whether they sleep if `sleep_changed`.
void find_events(Events& events, Contacts& contacts, const Shapes& shapes, Bodies& bodies, bool sleep_changed);

// All that touch now, or all that sensors see, in order.
std::vector<Touch> active_touches(const Contacts& contacts, const Shapes& shapes, const Bodies& bodies, bool sensors);

// Before shapes go or change: remember to tell that this contact has ended.
void lose(Events& events, const Contact& contact, const Shapes& shapes, const Bodies& bodies);

// Drop the contacts that `which` says. If they meet still, the next step finds them anew, and nothing is told.
inline void forget_contacts(Events& events, Contacts& contacts, const Shapes& shapes, const Bodies& bodies,
                            auto&& which) {
    std::erase_if(contacts.rows, [&](const Contact& c) {
        bool goes = which(c);
        if (goes && c.touching) lose(events, c, shapes, bodies);
        return goes;
    });
}

} // namespace evil
