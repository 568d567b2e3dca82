// Films of liquid between bodies that are less than a cell apart. The grid sees no way in there, and without them a crate on
// the floor of a pool would be held down by what lies above it. What they press on follows from the rest: a body's outline
// is closed.
//
//            | | | |              The sum of all directions round a body is none, so what films cover is the negative of the
//          +---------+            sum of what open cells see. They have the pressure of the liquid at their ends: a film
//       -> |         | <-         with water at one end and air at the other has half of it.
//          +=========+ film
//       ---^---------^--- floor
#include "fluid/water/finder.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kLeast = 0.2f; // faces: less than that is how cells round
constexpr std::int32_t kAir = -1, kShut = -2;
constexpr int kReach = 2; // cells that the end of a film may be away

bool is_air(const WaterScratch& s, std::ptrdiff_t at) {
    return s.wet[at] == 0.0f && s.per_room[at] > 0.0f && s.rho[at] < kFullOfSolid;
}

// The wet cell nearest to a shut one, but not across the body; kAir if open air is nearer, or kShut if there is neither.
std::int32_t cell_near(const Water& water, int i, int j, Vec2 into) {
    const Grid& g = water.grid;
    std::int32_t nearest = kShut;
    int least = 0;
    for (int y = std::max(j - kReach, 0); y <= std::min(j + kReach, g.ny - 1); ++y)
        for (int x = std::max(i - kReach, 0); x <= std::min(i + kReach, g.nx - 1); ++x) {
            const bool wet = water.scratch->wet[g.at(x, y)] > 0.0f;
            const int far = (x - i) * (x - i) + (y - j) * (y - j);
            if ((!wet && !is_air(*water.scratch, g.at(x, y))) || (nearest != kShut && far >= least)) continue;
            const Vec2 way{static_cast<float>(x - i), static_cast<float>(y - j)};
            if (dot(way, into) >= std::abs(cross(way, into))) continue;
            nearest = wet ? static_cast<std::int32_t>(g.at(x, y)) : kAir, least = far;
        }
    return nearest;
}

// The way into a body from what else stands in a shut cell: another body, or a side of the box. None: only the body does.
Vec2 way_into(const Water& water, std::uint32_t body, int i, int j) {
    const WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    Vec2 way;
    bool mine = false, others = false;
    for (int k = 0; k < 4; ++k) {
        const std::ptrdiff_t corner = g.at(i + k % 2, j + k / 2);
        const float deep = -s.solids.distance()[corner]; // whose a corner is that lies on both is chance
        if (deep < 0.0f) continue;
        const bool own = s.solids.owner()[corner] == static_cast<float>(body + 1);
        mine = mine || own, others = others || !own;
        way += (own ? 1.0f : -1.0f) * std::min(deep, 1.0f) * Vec2{k % 2 ? 1.0f : -1.0f, k / 2 ? 1.0f : -1.0f};
    }
    if (!mine) return {};
    if (others) return normalised(way);
    const bool left = i == 0 && !water.open[kLeft], right = i == g.nx - 1 && !water.open[kRight];
    const bool bottom = j == 0 && !water.open[kBottom], top = j == g.ny - 1 && !water.open[kTop];
    return normalised({(left ? 1.0f : 0.0f) - (right ? 1.0f : 0.0f), (bottom ? 1.0f : 0.0f) - (top ? 1.0f : 0.0f)});
}

// Where a body's surface is in a shut cell, by how deep the corners lie in the body.
Vec2 surface_in(const Water& water, std::uint32_t body, int i, int j, Vec2 into) {
    const Solids& solids = water.scratch->solids;
    const Grid& g = water.grid;
    Vec2 sum;
    float count = 0.0f;
    for (int k = 0; k < 4; ++k) {
        const std::ptrdiff_t corner = g.at(i + k % 2, j + k / 2);
        if (solids.owner()[corner] != static_cast<float>(body + 1)) continue;
        const float deep = std::clamp(-solids.distance()[corner], 0.0f, 1.0f);
        sum += Vec2{static_cast<float>(i + k % 2), static_cast<float>(j + k / 2)} - deep * into;
        count += 1.0f;
    }
    return g.low + g.h / count * sum;
}

class Looker { // round one body
public:
    Looker(const World& world, Water& water)
        : water_(water), s_(*water.scratch), bodies_(world.bodies.rows), finder_(world, water) {}

    void look(std::uint32_t body) {
        const Grid& g = water_.grid;
        const Patch& p = s_.loops[body].patch;
        for (int j = std::max(p.low - 1, 0); j < std::min(p.high, g.ny); ++j)
            for (int i = std::max(p.left - 1, 0); i < std::min(p.right, g.nx); ++i) look_at(body, i, j);
    }

private:
    void look_at(std::uint32_t body, int i, int j) {
        const std::ptrdiff_t at = water_.grid.at(i, j);
        Loop& loop = s_.loops[body];
        if (is_air(s_, at)) {
            for (const Reach& reach : finder_.look_at(i, j))
                if (reach.body == body) loop.seen += {reach.x, reach.y};
        } else if (s_.per_room[at] == 0.0f) {
            const Vec2 into = way_into(water_, body, i, j);
            const std::int32_t end = into == Vec2{} ? kShut : cell_near(water_, i, j, into);
            if (end == kShut) return;
            loop.right_up += max(into, Vec2{}), loop.left_down += max(-into, Vec2{});
            const Vec2 place = surface_in(water_, body, i, j, into);
            s_.touches.push_back({body, end, place - bodies_[body].centre, into});
        }
    }

    Water& water_;
    WaterScratch& s_;
    const std::vector<Body>& bodies_;
    Finder finder_;
};

// Each body in the water: what cells see of it, and where it shuts them.
void look_round(const World& world, Water& water) {
    WaterScratch& s = *water.scratch;
    s.touches.clear();
    const auto see = [&](const Reach& reach) {
        s.loops[reach.body].seen += {reach.x, reach.y};
        s.loops[reach.body].in_water = world.bodies.rows[reach.body].kind == BodyKind::dynamic;
    };
    for (const Reach& reach : s.unsorted_reaches) see(reach);
    for (const Film& film : s.films) see(film.reach);
    s.solids.each_piece([&](std::uint32_t body, const Patch& patch) {
        Patch& all = s.loops[body].patch;
        all = all.empty() ? patch
                          : Patch{std::min(all.left, patch.left), std::min(all.low, patch.low),
                                  std::max(all.right, patch.right), std::max(all.high, patch.high)};
    });
    Looker looker(world, water);
    for (std::uint32_t body = 0; body < s.loops.size(); ++body)
        if (s.loops[body].in_water) looker.look(body);
}

// A touch's part of what films of a body cover along one axis: as far as it is turned that way.
float share_of(float film, float into, float all_one_way, float all_other_way) {
    const float mine = film > 0.0f ? std::max(into, 0.0f) : std::max(-into, 0.0f);
    const float all = film > 0.0f ? all_one_way : all_other_way;
    return std::abs(film) > kLeast && mine > 0.0f ? film * mine / all : 0.0f;
}

// What flows into a film comes from all the liquid round its end: a single cell could not let it through. The film lies
// deeper or higher than each of those cells, which tells in its pressure.
void spread(const World& world, Water& water, const Film& film, float dt) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    const int i = film.reach.at % g.stride, j = film.reach.at / g.stride;
    std::array<Vec2, 9> places;
    std::array<std::int32_t, 9> cells{};
    std::size_t count = 0;
    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, g.ny - 1); ++y)
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, g.nx - 1); ++x)
            if (s.wet[g.at(x, y)] > 0.0f) {
                places[count] = g.low + g.h * Vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
                cells[count++] = static_cast<std::int32_t>(g.at(x, y));
            }
    const float share = 1.0f / static_cast<float>(count), heavy = heaviest(water);
    Loop& loop = s.loops[film.reach.body];
    for (std::size_t k = 0; k < count; ++k) {
        const Reach part{cells[k], share * film.reach.x, share * film.reach.y, share * film.reach.turn,
                         film.reach.body};
        const float above = -water.pressure[cells[k]] * g.h / dt; // no film pulls: it would tear
        const float head = heavy * g.h * std::max(s.mass[cells[k]] * dot(world.gravity, film.place - places[k]), above);
        loop.lift += head * Vec2{part.x, part.y};
        loop.turn += head * part.turn;
        s.unsorted_reaches.push_back(part);
    }
}

} // namespace

void add_films(const World& world, Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    if (s.unsorted_reaches.empty() && s.films.empty()) return;
    look_round(world, water);
    for (const Touch& touch : s.touches) {
        const Loop& loop = s.loops[touch.body];
        const Vec2 film{share_of(-loop.seen.x, touch.into.x, loop.right_up.x, loop.left_down.x),
                        share_of(-loop.seen.y, touch.into.y, loop.right_up.y, loop.left_down.y)};
        if (touch.at < 0 || film == Vec2{}) continue;
        const Vec2 place = world.bodies.rows[touch.body].centre + touch.arm;
        s.films.push_back({{touch.at, film.x, film.y, cross(touch.arm, film), touch.body}, place});
    }
    for (const Film& film : s.films) spread(world, water, film, dt);
}

} // namespace evil::fluid
