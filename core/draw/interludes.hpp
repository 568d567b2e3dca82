#pragma once
// What happens between the instances of a frame: specks, and what is done to all that has been drawn so far.
#include "draw/post.hpp"
#include "draw/specks.hpp"
#include <vector>

namespace evil::draw {

enum class InterludeKind : std::uint8_t { specks, blur, post };

struct Interlude {
    std::uint32_t before = 0; // index of the instance that follows it
    InterludeKind kind = InterludeKind::specks;
    std::uint32_t first = 0, count = 0; // rows of specks
    SpeckForm form = SpeckForm::soft;
    bool adds = false;   // the specks add light to what is behind, rather than covering it
    float radius = 0.0f; // of a blur, in pixels
};

struct Interludes {
    std::vector<Interlude> rows; // in the order in which they are done: `before` never falls
    std::vector<Speck> specks;
    Post post; // of the one of that kind, if there is one

    void clear() { rows.clear(), specks.clear(); }
};

} // namespace evil::draw
