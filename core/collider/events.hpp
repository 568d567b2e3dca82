#pragma once
// What happened in a step, told after it (SPEC C10): contacts that began, ended or hit, bodies that fell asleep or woke.
// The order is a promise: that of creation, of the older body of a contact, then of the younger, then of their shapes.
#include "collider/contact.hpp"

namespace evil {

// Two shapes that touch, however many of their pieces do.
struct Touch {
    BodyRef a, b; // a was created first
    ShapeRef shape_a, shape_b;
    std::uint64_t order[4] = {}; // serials of the bodies, then of the shapes
    Vec2 point, normal;          // normal from a to b
    float depth = 0.0f, impulse = 0.0f, speed = 0.0f;
};

struct Events {
    // State
    float hit_speed = 1.0f; // m/s: contacts that close faster are told as hits
    std::vector<Touch>
        lost; // touched when one of the two was destroyed, since the last step: their end is still to be told

    // Results of the last step
    std::vector<Touch> begun, ended, hit;
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
void find_events(Events& events, Contacts& contacts, const Shapes& shapes, Bodies& bodies);

// All that touch now, in order.
std::vector<Touch> active_touches(const Contacts& contacts, const Shapes& shapes, const Bodies& bodies);

// Before a shape goes: drop its contacts, and remember to tell their end.
void forget_shape(Events& events, Contacts& contacts, const Shapes& shapes, const Bodies& bodies, std::uint32_t shape);

} // namespace evil
