#pragma once
// Where every piece is in this step and may go: one pass over the bodies, read by the broad and the narrow phase.
#include "bodies.hpp"
#include "math/cpu.hpp"
#include "shapes/shapes.hpp"
#include "threads.hpp"

namespace evil {

inline constexpr float kSlop =
    0.005f; // metres that count as nothing: a gap so small still touches, or contacts flicker
inline constexpr float kMargin =
    4 * kSlop; // metres: pairs nearer than this get a manifold before they touch (speculative)

// A piece's form in the world: a line of the cache. The middle is kept as origin and arm, so that differences of two
// pieces do not lose what a large coordinate would swallow.
struct alignas(64) PlacedForm {
    Vec2 origin;    // of its body
    Vec2 arm;       // from there to the middle of the form, world axes
    Rot turn;       // of the form, world
    Vec2 half;      // of the form
    Vec2 path;      // of the body's centre within the step
    float swing;    // the farthest a point moves within the step by the body's turning
    float reach;    // of the form
    float radius;   // of the form
    float grow;     // what each side of its bounds has grown by
    Vec2 to_centre; // from the origin to the body's centre of mass, world axes
};
static_assert(sizeof(PlacedForm) == 64);

struct Placements { // Scratch, by piece slot; rounded up to whole lanes
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint8_t> kinds; // FormKind, and what there is to know of the body
    std::vector<PlacedForm> forms;
    std::vector<float> low_x, low_y, high_x, high_y; // bounds, grown by half the margin and by what it may move
    std::vector<std::int32_t> octaves; // floor(log2) of the bounds' longer side; kNoOctave for slots without a piece
};
inline constexpr std::int32_t kNoOctave = -1000;
inline constexpr std::uint8_t kResting = 0x80;     // nothing moves the body; what does so by hand wakes what it touches
inline constexpr std::uint8_t kSeeks = 0x40;       // of a dynamic body, or a sensor, which sees whatever comes
inline constexpr std::uint8_t kNeighboured = 0x20; // Shapes::neighboured
inline constexpr std::uint8_t kFormKind = 0x0f;

// A long wall aslant has bounds that hold half the world: of pieces of very different size, does one side of the larger one's
// form keep the bounds of the other away, on its way through the step?
bool much_larger(const Placements& placed, std::uint32_t a, std::uint32_t b);
bool kept_apart(const Placements& placed, std::uint32_t a, std::uint32_t b);

void place_pieces(Placements& placed, const Shapes& shapes, const Bodies& bodies, float dt, InstructionSet set,
                  Threads& threads);

} // namespace evil
