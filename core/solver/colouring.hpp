#pragma once
// Graph colouring: contacts of one colour share no body that can move, so eight of them can be solved at once.
//
// Colours are given greedily in the contacts' own order, the lowest that both bodies have free. So they do not depend on
// the number of lanes or threads. Contacts with a body that no contact moves (walls) come in colours of their own, solved
// last: what is pushed into the ground by its neighbours is pushed out again.
#include <cstdint>
#include <vector>

namespace evil {

inline constexpr std::uint32_t kColours = 64; // of each sort; contacts beyond go one to a block

struct Edge { // a contact by its solver bodies
    std::uint32_t a, b;
    std::uint32_t sort = 0;
    std::uint32_t contact = 0; // row that it comes from
    static constexpr std::uint32_t kWall = 1, kTurn = 2;
    bool wall() const { return (sort & kWall) != 0; } // only a moves
    bool turn() const { return (sort & kTurn) != 0; } // the contact's own a and b have changed places
    friend bool operator==(const Edge&, const Edge&) = default;
};

struct Place {
    std::uint32_t block, lane;
};

struct BlockRange { // blocks of one colour
    std::uint32_t first, count;
    bool wall;
    bool alone; // one contact to a block, and blocks may share bodies: one after the other
};

struct Colouring {                                       // Scratch
    std::vector<std::uint64_t> used_between, used_walls; // by solver body: colours that it has
    std::vector<std::uint8_t> colour;                    // by contact
    std::vector<std::uint32_t> counts;                   // by colour
    std::vector<std::uint32_t> next;                     // by colour: where its next contact goes
    std::vector<Place> places;                           // by contact
    std::vector<BlockRange> ranges;                      // of colours that have blocks, in order
    std::uint32_t blocks = 0;
};

// Where each contact goes: blocks in order of colour, those at walls last.
void colour(Colouring& colouring, const std::vector<Edge>& edges, std::uint32_t bodies, std::uint32_t lanes);

} // namespace evil
