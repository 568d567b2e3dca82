#pragma once
// Bodies that lie inside each other, as where many are made in one place: they come apart, they are not shot apart.
#include "bodies.hpp"
#include "collider/contact.hpp"
#include <compare>

namespace evil {

struct Buried { // Scratch
    struct Row {
        std::uint32_t slot;
        float speed, spin; // before the step was solved
    };
    struct Deep {
        std::uint32_t slot, in; // bodies
        auto operator<=>(const Deep&) const = default;
    };
    std::vector<Deep> deep; // each deep contact
    std::vector<Row> rows;  // bodies deep in several
};

// Before a step is solved: note the bodies that lie deep in several others.
void find_buried(Buried& buried, const Contacts& contacts, const Bodies& bodies);

// After it: overlap gave them no more speed than one contact's push does. Each of many adds one of its own, so a body
// under a thousand others would leave like a shot.
void calm_buried(const Buried& buried, Bodies& bodies);

} // namespace evil
