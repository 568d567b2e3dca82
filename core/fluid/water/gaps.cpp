// Gaps along bodies that no particle fits into. Liquid has long since seeped in there, so they are no air, and it has no
// mass to speak of: films, with the pressure of the nearest liquid, see films.cpp.
//
//      |   |_body_|   |        n: narrow cells, w: cells with liquid. Beside open air, narrow cells stay what they are.
//      | w | n  n | w |
//      +---+------+---+
#include "fluid/water/finder.hpp"
#include <algorithm>

namespace evil::fluid {
namespace {

constexpr float kNarrow = 0.5f; // share of a cell outside of bodies
constexpr float kSlot = 0.8f;   // cells: half of the width of a slot
constexpr int kMostRoomy = 4;   // cells that are neither narrow nor in a slot: more of them are air

class Gaps {
public:
    Gaps(const World& world, Water& water)
        : bodies_(world.bodies.rows), water_(water), s_(*water.scratch), g_(water.grid), finder_(world, water) {}

    // All dry cells that hang together with this one.
    void look_at(std::ptrdiff_t at) {
        if (!is_dry(at) || met(at) != 0) return;
        ++turn_, roomy_ = 0, airy_ = between_ = several_ = false, side_ = swims_ = 0.0f;
        s_.gap.clear();
        meet(at);
        for (std::size_t k = 0; k < s_.gap.size() && !airy_; ++k)
            each_way(s_.gap[k].at, [&](std::ptrdiff_t to, bool inside) { look(to, inside); });
        if (between_ && !airy_) fill();
    }

private:
    bool is_dry(std::ptrdiff_t at) const { return s_.wet[at] == 0.0f && s_.per_room[at] > 0.0f; }
    std::uint32_t& met(std::ptrdiff_t at) { return s_.met[static_cast<std::size_t>(at)]; }
    int row_of(std::ptrdiff_t at) const { return static_cast<int>(at / g_.stride); }
    int column_of(std::ptrdiff_t at) const { return static_cast<int>(at % g_.stride); }

    template <class Visit> void each_way(std::ptrdiff_t at, Visit visit) const { // visit(next cell, is it in the box?)
        const int i = column_of(at), j = row_of(at);
        const Field &across = s_.solids.across(), &up = s_.solids.up();
        if (across[at] > 0.0f) visit(at - 1, i > 0);
        if (across[at + 1] > 0.0f) visit(at + 1, i + 1 < g_.nx);
        if (up[at] > 0.0f) visit(at - g_.stride, j > 0);
        if (up[at + g_.stride] > 0.0f) visit(at + g_.stride, j + 1 < g_.ny);
    }

    bool is_slot(std::ptrdiff_t at) const { // a body is near, wherever one is in it
        const Field& d = s_.solids.distance();
        return std::max(std::max(d[at], d[at + 1]), std::max(d[at + g_.stride], d[at + g_.stride + 1])) < kSlot;
    }

    void meet(std::ptrdiff_t at) {
        met(at) = turn_;
        s_.met_cells.push_back(static_cast<std::int32_t>(at));
        s_.gap.push_back({static_cast<std::int32_t>(at), -1});
        if (s_.volume[at] > kNarrow && !is_slot(at) && ++roomy_ > kMostRoomy) airy_ = true;
        for (std::ptrdiff_t corner : {at, at + 1, at + g_.stride, at + g_.stride + 1}) {
            const float owner = s_.solids.distance()[corner] < 1.0f ? s_.solids.owner()[corner] : 0.0f;
            if (owner == 0.0f) continue;
            between_ = between_ || (side_ != 0.0f && side_ != owner);
            side_ = owner;
            if (bodies_[static_cast<std::size_t>(owner) - 1].kind != BodyKind::dynamic) continue;
            several_ = several_ || (swims_ != 0.0f && swims_ != owner);
            swims_ = owner;
        }
        const int i = column_of(at), j = row_of(at); // the sides of the box are no body's, but stand there too
        between_ = between_ || i == 0 || j == 0 || i == g_.nx - 1 || j == g_.ny - 1;
    }

    void look(std::ptrdiff_t to, bool inside) {
        if (!inside || s_.live[static_cast<std::size_t>(to / 8)] == 0)
            airy_ = true; // an open side, or far from all particles
        else if (is_dry(to) && met(to) == 0)
            meet(to);
        else if (is_dry(to) && met(to) != turn_)
            airy_ = true; // that was met before, and is air
    }

    // The liquid nearest to each cell of the gap bears what bodies close of its faces.
    void fill() {
        s_.found.clear();
        for (GapCell& cell : s_.gap) {
            each_way(cell.at, [&](std::ptrdiff_t to, bool) {
                if (cell.end < 0 && s_.wet[to] > 0.0f) cell.end = static_cast<std::int32_t>(to);
            });
            if (cell.end >= 0) s_.found.push_back(cell), met(cell.at) = 0;
        }
        for (std::size_t k = 0; k < s_.found.size(); ++k) {
            const GapCell cell = s_.found[k];
            each_way(cell.at, [&](std::ptrdiff_t to, bool) {
                if (!is_dry(to) || met(to) != turn_) return;
                met(to) = 0;
                s_.found.push_back({static_cast<std::int32_t>(to), cell.end});
            });
        }
        for (const GapCell& cell : s_.gap) met(cell.at) = turn_;
        for (const GapCell& cell : s_.found)
            for (Reach reach : finder_.look_at(column_of(cell.at), row_of(cell.at))) {
                reach.at = cell.end;
                const int i = column_of(cell.at), j = row_of(cell.at);
                const Vec2 middle{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
                s_.films.push_back({reach, g_.low + g_.h * (middle + surface_near(water_, i, j, reach.body))});
            }
        for (const GapCell& cell : s_.gap) {
            s_.rho[cell.at] = kFullOfFilm;
            if (!several_) s_.film_cells.push_back(cell.at);
        }
    }

    const std::vector<Body>& bodies_;
    const Water& water_;
    WaterScratch& s_;
    const Grid& g_;
    Finder finder_;
    std::uint32_t turn_ = 0;
    int roomy_ = 0;
    bool airy_ = false;    // does it open to air?
    bool between_ = false; // do two stand round it?
    float side_ = 0.0f;    // the owner of one
    float swims_ = 0.0f;   // of one that liquid moves
    bool several_ = false; // are there two of these?
};

template <class Visit> void each_cell(const Water& water, const std::vector<Tile>& tiles, Visit visit) { // near bodies
    for (const Tile& tile : tiles)
        if (tile.j >= 0 && tile.j < water.grid.ny && water.scratch->near[static_cast<std::size_t>(tile.at / 8)])
            for (int i = tile.i; i < std::min(tile.i + 8, water.grid.nx); ++i) visit(water.grid.at(i, tile.j));
}

// Narrow cells that only feel particles of others are dry until it is known what they belong to.
void dry_narrow_cells(Water& water) {
    WaterScratch& s = *water.scratch;
    std::uint32_t before = 0;
    for (const Tile& tile : s.occupied)
        for (std::ptrdiff_t at = tile.at; at < tile.at + 8; ++at) {
            const std::uint32_t end = s.first[static_cast<std::size_t>(at)];
            s.met[static_cast<std::size_t>(at)] = end > before ? 1 : 0;
            before = end;
        }
    each_cell(water, s.active, [&](std::ptrdiff_t at) {
        if (s.wet[at] == 0.0f || s.volume[at] > kNarrow || s.met[static_cast<std::size_t>(at)]) return;
        s.wet[at] = 0.0f;
        s.dried.push_back(static_cast<std::int32_t>(at));
    });
    for (const Tile& tile : s.occupied) std::fill_n(&s.met[static_cast<std::size_t>(tile.at)], 8, 0u);
}

} // namespace

void find_gaps(const World& world, Water& water) {
    WaterScratch& s = *water.scratch;
    s.films.clear(), s.film_cells.clear(), s.dried.clear();
    if (!s.solids.any()) return;
    const auto set_live = [&](std::uint8_t live) {
        for (const Tile& tile : s.active)
            if (tile.j >= 0 && tile.j < water.grid.ny) s.live[static_cast<std::size_t>(tile.at / 8)] = live;
    };
    dry_narrow_cells(water);
    set_live(1);
    Gaps gaps(world, water);
    each_cell(water, s.active, [&](std::ptrdiff_t at) { gaps.look_at(at); });
    set_live(0);
    for (std::int32_t at : s.met_cells) s.met[static_cast<std::size_t>(at)] = 0;
    s.met_cells.clear();
    for (std::int32_t at : s.dried)
        if (s.rho[at] != kFullOfFilm) s.wet[at] = 1.0f;
}

// Between two that swim it is they that give way.
void still_films(Water& water) {
    WaterScratch& s = *water.scratch;
    for (std::ptrdiff_t at : s.film_cells) s.u[at] = s.u[at + 1] = s.v[at] = s.v[at + water.grid.stride] = 0.0f;
}

} // namespace evil::fluid
