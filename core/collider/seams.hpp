#pragma once
// No ghost hits where solid things meet (SPEC C2, C10): tiles laid side by side, the convex parts of a polygon, the edges of a chain.
#include "collider/contact.hpp"

namespace evil {

struct Seams {             // Scratch
    struct Side {          // a contact seen from one of its pieces, the mover
        std::uint32_t row; // of the contact
        std::uint32_t next;
        std::uint32_t whole; // the body that the other piece belongs to; kNone: what stands still, all one
        bool from_a;         // the mover is the contact's piece a
    };
    std::vector<Side> sides, of_one;  // all; those of one mover, by whole
    std::vector<std::uint32_t> first; // by piece: its first side, kNone between steps
    std::vector<std::uint32_t> movers;
    std::vector<std::uint32_t> hidden; // rows of contacts that give way
};

// A contact gives way to another one of the same mover when it is one only because the pieces are looked at one by one:
//
//        |  mover  |        Its point p lies on the seam: in the piece of the other contact. The surface there is that of
//     ___|_______p_|____    both pieces, so a true normal n has both behind it. The left tile is in front of n <- p: the
//       tile  n<-|  tile    contact with the right one is a ghost. (In a real corner, of floor and wall, each piece rises
//                |          over the other's face as well, and both stay.)
//
// In its purpose after the "enhanced internal edge removal" of Jolt Physics (Rouwe 2023), which voids the corners of
// triangles that a face contact has met; here the rule is the normal cone of the union of convex sets.
void drop_ghosts(Seams& seams, Contacts& contacts, const Shapes& shapes, const Bodies& bodies);

// Which pieces have neighbours to share a seam with: those of bodies that stand still or have other pieces.
void note_neighbours(Shapes& shapes, const Body& body);                      // of a body as it now is
void note_neighbours(Shapes& shapes, const Body& body, std::uint32_t added); // after this shape was put on it

} // namespace evil
