#include "collider/candidates.hpp"
#include "collider/candidates_wide.hpp"
#include <atomic>

namespace evil {
namespace {

constexpr float kSlack = 0.1f;                     // of the bounds' shorter side
constexpr float kEverywhere = 1e30f;               // metres: where there is no piece, anything will do
constexpr int kWorthWhile = 4, kLongestPause = 63; // steps
constexpr std::size_t kNotListed = ~std::size_t{0};
constexpr std::size_t kPiecesAtOnce = 1024, kPairsAtOnce = 4096; // chunks for threads

BoundsView view(const Placements& p) { return {p.low_x.data(), p.low_y.data(), p.high_x.data(), p.high_y.data()}; }

bool same_pieces(const Placements& p, const Placements& q) {
    return p.bodies == q.bodies && p.kinds == q.kinds && p.octaves == q.octaves;
}

bool is_set(const std::vector<std::uint8_t>& bits, std::size_t i) { return (bits[i / 8] >> i % 8 & 1) != 0; }

void list_meeting(Candidates& c, std::vector<Pair>& pairs) {
    pairs.resize(c.count);
    c.listed = 0;
    for (std::size_t i = 0; i < c.count; ++i) {
        pairs[c.listed] = {c.a[i], c.b[i]};
        c.listed += is_set(c.meet, i);
    }
    pairs.resize(c.listed);
}

} // namespace

bool still_good(Candidates& c, const Placements& placed, InstructionSet set, Threads& threads) {
    if (!c.kept) return false;
    std::size_t pieces = placed.octaves.size();
    c.lows.resize(2 * pieces);
    c.highs.resize(2 * pieces);
    std::atomic<bool> within = same_pieces(c.grown, placed);
    if (within)
        parallel_for(threads, pieces, kPiecesAtOnce, [&](std::size_t first, std::size_t last) {
            if (!EVIL_PICK(set, stay_within)(view(placed), view(c.grown), c.lows.data(), c.highs.data(), first, last))
                within.store(false, std::memory_order_relaxed);
        });
    if (within) {
        ++c.lasted;
        return true;
    }
    c.kept = false;
    c.wait = c.pause = c.lasted >= kWorthWhile ? 0 : std::min(2 * c.pause + 1, kLongestPause);
    return false;
}

bool worth_keeping(Candidates& c) {
    if (c.wait == 0) return true;
    --c.wait;
    return false;
}

const Placements& grow(Candidates& c, const Placements& placed) {
    Placements& g = c.grown;
    g.bodies = placed.bodies;
    g.kinds = placed.kinds;
    g.octaves = placed.octaves;
    std::size_t pieces = placed.octaves.size();
    for (auto* side : {&g.low_x, &g.low_y, &g.high_x, &g.high_y}) side->resize(pieces);
    for (std::size_t p = 0; p < pieces; ++p) {
        float width = placed.high_x[p] - placed.low_x[p], height = placed.high_y[p] - placed.low_y[p];
        float slack = placed.kinds[p] & kResting ? 0.0f : kSlack * std::min(width, height);
        if (placed.octaves[p] == kNoOctave) slack = kEverywhere;
        g.low_x[p] = placed.low_x[p] - slack;
        g.low_y[p] = placed.low_y[p] - slack;
        g.high_x[p] = placed.high_x[p] + slack;
        g.high_y[p] = placed.high_y[p] + slack;
    }
    return g;
}

void keep(Candidates& c, const std::vector<Pair>& pairs) {
    c.count = pairs.size();
    std::size_t eights = (c.count + 7) / 8;
    c.a.assign(8 * eights, 0);
    c.b.assign(8 * eights, 0);
    c.meet.assign(eights, 0);
    c.found.assign(eights, 0);
    c.uneven.clear();
    for (std::uint32_t i = 0; i < c.count; ++i) {
        auto [a, b] = pairs[i];
        c.a[i] = a;
        c.b[i] = b;
        if (much_larger(c.grown, a, b) || much_larger(c.grown, b, a)) c.uneven.push_back(i);
    }
    c.kept = true;
    c.lasted = 0;
    c.listed = kNotListed;
}

bool meeting_pairs(Candidates& c, const Placements& placed, std::vector<Pair>& pairs, InstructionSet set,
                   Threads& threads) {
    parallel_for(threads, c.count, kPairsAtOnce, [&](std::size_t first, std::size_t last) {
        EVIL_PICK(set, test_candidates)
        ({c.a.data(), c.b.data()}, c.lows.data(), c.highs.data(), c.found.data(), first, last);
    });
    for (std::uint32_t i : c.uneven)
        if (is_set(c.found, i) && kept_apart(placed, c.a[i], c.b[i]))
            c.found[i / 8] = static_cast<std::uint8_t>(c.found[i / 8] & ~(1u << i % 8));
    bool changed = c.listed != pairs.size() || c.found != c.meet;
    std::swap(c.found, c.meet);
    if (changed) list_meeting(c, pairs);
    return changed;
}

} // namespace evil
