#include "collider/placed.hpp"
#include "collider/placed_wide.hpp"
#include <cstddef>

namespace evil {
namespace {

// The wide kernel reads a body's first 64 bytes as two rows of eight floats.
static_assert(sizeof(Body) % 32 == 0 && offsetof(Body, kind) == 0 && offsetof(Body, spin) == 4);
static_assert(offsetof(Body, pose) == 8 && offsetof(Body, centre) == 24 && offsetof(Body, velocity) == 32);
static_assert(offsetof(Body, local_centre) == 40);

constexpr std::size_t kGrain = 1024; // pieces

void grow(Placements& placed, std::size_t pieces) {
    std::size_t whole = (pieces + 7) / 8 * 8;
    placed.bodies.resize(whole);
    placed.forms.resize(whole);
    placed.octaves.resize(whole);
    placed.kinds.resize(whole);
    for (auto* side : {&placed.low_x, &placed.low_y, &placed.high_x, &placed.high_y}) side->resize(whole);
}

void note_body(Placements& placed, const Shapes& shapes, const Bodies& bodies, std::uint32_t p) {
    std::uint32_t body = shapes.piece_slots.taken(p) ? shapes.pieces[p].body : 0;
    const Body& b = bodies.rows[body];
    bool dynamic = b.kind == BodyKind::dynamic, resting = b.kind == BodyKind::fixed || (dynamic && !b.awake);
    placed.bodies[p] = body;
    bool seeks = dynamic || shapes.pieces[p].sensor;
    placed.kinds[p] =
        static_cast<std::uint8_t>(static_cast<unsigned>(shapes.form_kinds[p]) | (resting ? kResting : 0u) |
                                  (seeks ? kSeeks : 0u) | (shapes.neighboured[p] != 0 ? kNeighboured : 0u));
}

constexpr std::int32_t kMuchLarger = 2; // octaves

bool form_keeps_apart(const Placements& placed, std::uint32_t large, std::uint32_t small) {
    const PlacedForm& f = placed.forms[large];
    Vec2 middle = f.origin + f.arm + 0.5f * f.path;
    Vec2 low{placed.low_x[small], placed.low_y[small]}, high{placed.high_x[small], placed.high_y[small]};
    Vec2 apart = 0.5f * (low + high) - middle, size = 0.5f * (high - low);
    Vec2 away = unrotate(f.turn, apart), path = unrotate(f.turn, 0.5f * f.path);
    float c = std::abs(f.turn.c), s = std::abs(f.turn.s), thick = f.radius + f.grow;
    return std::abs(away.x) > f.half.x + thick + std::abs(path.x) + c * size.x + s * size.y ||
           std::abs(away.y) > f.half.y + thick + std::abs(path.y) + s * size.x + c * size.y;
}

} // namespace

bool much_larger(const Placements& placed, std::uint32_t a, std::uint32_t b) {
    return placed.octaves[a] - placed.octaves[b] >= kMuchLarger;
}

bool kept_apart(const Placements& placed, std::uint32_t a, std::uint32_t b) {
    return (much_larger(placed, a, b) && form_keeps_apart(placed, a, b)) ||
           (much_larger(placed, b, a) && form_keeps_apart(placed, b, a));
}

void place_pieces(Placements& placed, const Shapes& shapes, const Bodies& bodies, float dt, InstructionSet set,
                  Threads& threads) {
    std::size_t pieces = shapes.forms.size();
    grow(placed, pieces);
    if (pieces == 0) return;
    PlacingRows rows{reinterpret_cast<const float*>(bodies.rows.data()),
                     sizeof(Body) / 32,
                     reinterpret_cast<const float*>(shapes.forms.data()),
                     placed.bodies.data(),
                     reinterpret_cast<float*>(placed.forms.data()),
                     placed.low_x.data(),
                     placed.low_y.data(),
                     placed.high_x.data(),
                     placed.high_y.data(),
                     placed.octaves.data(),
                     static_cast<std::uint32_t>(pieces),
                     dt,
                     kMargin};
    auto place = EVIL_PICK(set, place_pieces);
    parallel_for(threads, pieces, kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) note_body(placed, shapes, bodies, static_cast<std::uint32_t>(p));
        place(rows, first, last);
    });
    std::fill(placed.octaves.begin() + static_cast<std::ptrdiff_t>(pieces), placed.octaves.end(), kNoOctave);
    if (shapes.piece_slots.count() == pieces) return;
    for (std::uint32_t p = 0; p < pieces; ++p)
        if (!shapes.piece_slots.taken(p)) placed.octaves[p] = kNoOctave;
}

} // namespace evil
