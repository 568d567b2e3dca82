#pragma once
// Pairs that may meet soon, kept over some steps: those whose bounds overlap when each is grown by a slack. While all bounds
// stay within their grown ones no other pair can meet, so only these are tested. What is found is the same to the pair.
#include "collider/contact.hpp"
#include "collider/placed.hpp"

namespace evil {

struct Candidates {                        // Scratch
    Placements grown;                      // without forms
    std::vector<std::uint32_t> a, b;       // sorted pairs, up to a whole eight
    std::size_t count = 0, listed = 0;     // of them, and of those that met last
    std::vector<std::uint32_t> uneven;     // those of very different size
    std::vector<std::uint8_t> meet, found; // bits, in bytes by eight: of the last step, and of this one
    std::vector<float> lows, highs;        // corners of the bounds by piece, x and y in turn
    bool kept = false;
    int lasted = 0;          // steps since they were found
    int pause = 0, wait = 0; // where all is on the move they do not last: steps without them, and how many are left
};

// Do those that were kept hold for this step?
bool still_good(Candidates& candidates, const Placements& placed, InstructionSet set, Threads& threads);
// If not: are they worth finding anew? Then: the bounds whose overlaps they are, which keep() is to be given.
bool worth_keeping(Candidates& candidates);
const Placements& grow(Candidates& candidates, const Placements& placed);
void keep(Candidates& candidates, const std::vector<Pair>& pairs);

// Those that meet, into `pairs`. False: they are as the last call left them there.
bool meeting_pairs(Candidates& candidates, const Placements& placed, std::vector<Pair>& pairs, InstructionSet set,
                   Threads& threads);

} // namespace evil
