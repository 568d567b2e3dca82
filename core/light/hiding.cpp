#include "light/hiding.hpp"
#include "light/shade_wide.hpp"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace evil::light {
namespace {

// Of half the line. What a caster hides is told from the rim of a square, and the line turns with the way to it: together
// casters must overlap by so much, and hide so much more than what is left out.
constexpr float kMargin = 0.03f;
constexpr int kLargest = 16;  // texels: in larger squares too little is surely hidden to pay for the search
constexpr float kTurn = 3.0f; // sides of a square: from nearer, a lamp's line turns too far across it for that

// Marks the fewest sure ones that together hide what all of them do, and leaves in `sure` what that is.
void join_sure(Hiding& hiding) {
    std::vector<Hiding::Sure>& sure = hiding.sure;
    std::ranges::sort(sure, {}, [](const Hiding::Sure& one) { return std::tuple(one.from, one.place); });
    std::size_t count = 0;
    for (std::size_t i = 0; i < sure.size();) {
        Hiding::Sure whole = sure[i], longest = sure[i];
        hiding.needed[whole.place] = true;
        for (++i;;) {
            for (; i < sure.size() && sure[i].from <= whole.to - kMargin; ++i)
                if (sure[i].to > longest.to) longest = sure[i];
            if (!(longest.to > whole.to)) break;
            whole.to = longest.to;
            hiding.needed[longest.place] = true;
        }
        sure[count++] = whole;
    }
    sure.resize(count);
}

bool surely_hidden(const std::vector<Hiding::Sure>& sure, float from, float to) {
    for (const Hiding::Sure& one : sure)
        if (one.from <= from && one.to >= to) return true;
    return false;
}

struct Way : Strip { // from a disc of texels to the lamp
    Way(const Lamp& lamp, Vec2 middle, float r) {
        from = middle, radius = r;
        const Vec2 to = lamp.parallel ? -kFar * lamp.way : lamp.at - middle;
        distance = std::max(length(to), 1e-6f);
        along = (1.0f / distance) * to;
        widening = std::max(lamp.size - r, 0.0f) / distance;
    }
    // In front of all of the disc, and before the lamp: then what it hides at most and at least is told from the rim.
    bool is_between(const Caster& caster) const {
        const float at = dot(caster.middle - from, along), room = caster.radius + radius;
        return at > room && at < distance - room;
    }
};

// What is left of `near`, whose outlines are known, once sure ones have hidden what they do.
void leave_out_hidden(std::vector<std::uint32_t>& near, Hiding& hiding) {
    std::size_t kept = 0;
    hiding.order.clear();
    for (std::uint32_t i = 0; i < near.size(); ++i) {
        const float from = std::max(hiding.outlines[i].from_least - kMargin, -1.0f);
        const float to = std::min(hiding.outlines[i].to_most + kMargin, 1.0f);
        if (!hiding.needed[i] && (from >= to || surely_hidden(hiding.sure, from, to))) continue;
        near[kept++] = near[i];
        hiding.order.push_back({hiding.outlines[i].from_least, near[i]});
    }
    near.resize(kept);
    std::ranges::sort(hiding.order);
    for (std::size_t i = 0; i < kept; ++i) near[i] = hiding.order[i].second;
}

} // namespace

void keep_near(std::vector<std::uint32_t>& which, const Lamp& lamp, std::span<const Caster> casters, Vec2 middle,
               float radius, InstructionSet set) {
    const Way way(lamp, middle, radius);
    const int count = static_cast<int>(which.size());
    which.resize(static_cast<std::size_t>(EVIL_PICK(set, keep_near_wide)(way, casters.data(), which.data(), count)));
}

bool find_what_matters(std::vector<std::uint32_t>& near, Hiding& hiding, std::span<const std::uint32_t> among,
                       const Lamp& lamp, std::span<const Caster> casters, std::span<const Vec2> corners,
                       const Square& square, InstructionSet set) {
    near.assign(among.begin(), among.end());
    keep_near(near, lamp, casters, square.middle(), square.radius(), set);
    if (near.empty() || square.side > kLargest) return true;
    hiding.outlines.resize(near.size());
    EVIL_PICK(set, outline_casters_wide)
    (lamp, casters.data(), near.data(), static_cast<int>(near.size()), corners.data(), square, hiding.outlines.data());
    const Way way(lamp, square.middle(), square.radius());
    const bool far = way.distance > kTurn * 2.0f * square.half();
    hiding.sure.clear();
    hiding.needed.assign(near.size(), true);
    for (std::uint32_t i = 0; i < near.size(); ++i) {
        const Outline& one = hiding.outlines[i];
        if (one.from_most <= -1.0f && one.to_least >= 1.0f) return false; // its umbra is convex: exact, however near
        if (!far || !way.is_between(casters[near[i]])) continue;
        hiding.needed[i] = false;
        if (one.from_most + kMargin < one.to_least) hiding.sure.push_back({one.from_most, one.to_least, i});
    }
    join_sure(hiding);
    if (surely_hidden(hiding.sure, -1.0f, 1.0f)) return false;
    leave_out_hidden(near, hiding);
    return true;
}

} // namespace evil::light
