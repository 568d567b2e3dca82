#include "fluid/sources.hpp"
#include "fluid/flow.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kHeating = 10.0f; // share of the way to a source's temperature that gas goes in a second
constexpr float kBlowing = 20.0f; // and to its velocity

struct Span { // of cells, or of faces: both ends are inside
    int left, low, right, high;
};

int place(float at, int most) { return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most))); }

Span span_of(const Grid& g, Vec2 low, Vec2 high) {
    const Vec2 a = (1.0f / g.h) * (low - g.low), b = (1.0f / g.h) * (high - g.low);
    return {place(a.x - 1.0f, g.nx - 1), place(a.y - 1.0f, g.ny - 1), place(b.x + 1.0f, g.nx - 1),
            place(b.y + 1.0f, g.ny - 1)};
}

// A source where it is now: its area is asked about points of the world.
class Place {
public:
    Place(const Source& source, const World& world)
        : area_(source.area), pose_(source.body == kNone ? Pose{} : world.bodies.rows[source.body].pose) {
        low_ = high_ = transform(pose_, area_.radius > 0.0f ? area_.centre : area_.parts[0][0]);
        const Vec2 r{area_.radius, area_.radius};
        if (area_.radius > 0.0f) low_ = low_ - r, high_ = high_ + r;
        for (const auto& part : area_.parts)
            for (Vec2 corner : part) {
                const Vec2 p = transform(pose_, corner);
                low_ = min(low_, p), high_ = max(high_, p);
            }
    }
    Span span(const Grid& grid) const { return span_of(grid, low_, high_); }
    Vec2 middle() const { return 0.5f * (low_ + high_); }

    // How much of a square of side h round a point it covers, by four points in it.
    float covers(Vec2 at, float h) const {
        int inside = 0;
        for (float dx : {-0.25f, 0.25f})
            for (float dy : {-0.25f, 0.25f})
                inside += contains(area_, untransform(pose_, at + Vec2{dx * h, dy * h})) ? 1 : 0;
        return 0.25f * static_cast<float>(inside);
    }

private:
    const Area& area_;
    Pose pose_;
    Vec2 low_, high_;
};

Vec2 middle_of(const Grid& g, int i, int j) {
    return g.low + g.h * Vec2{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
}

// visit(i, j, share) for each cell that the source covers; one that is smaller than that gets a quarter of a cell.
template <class Visit> void each_covered(const Grid& grid, const Place& place, Visit visit) {
    const Span span = place.span(grid);
    bool any = false;
    for (int j = span.low; j <= span.high; ++j)
        for (int i = span.left; i <= span.right; ++i) {
            const float share = place.covers(middle_of(grid, i, j), grid.h);
            if (share > 0.0f) visit(i, j, share), any = true;
        }
    const Vec2 at = (1.0f / grid.h) * (place.middle() - grid.low);
    const bool inside =
        at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(grid.nx) && at.y < static_cast<float>(grid.ny);
    if (!any && inside) visit(static_cast<int>(at.x), static_cast<int>(at.y), 0.25f);
}

void pour(Smoke& smoke, const Source& s, const Place& place, float dt) {
    Views& views = *smoke.views;
    Field& heat = smoke.scratch->heat; // which lifts; Stam's method has none
    const bool coloured = !views.colour.empty();
    each_covered(smoke.grid, place, [&](int i, int j, float share) {
        const auto at = static_cast<std::size_t>(j * smoke.grid.nx + i);
        Cell& cell = views.content[at];
        if (cell.open == 0.0f) return;
        if (s.rate < 0.0f) {
            const float left = 1.0f / (1.0f - share * s.rate * dt);
            cell.density *= left, cell.fuel *= left;
            for (std::size_t k = 0; coloured && k < 3; ++k) views.colour[4 * at + k] *= left;
        }
        const float more = std::min(std::max(share * s.rate * dt, 0.0f), kMostDensity - cell.density);
        cell.density += more;
        cell.fuel = std::min(cell.fuel + share * s.fuel * dt, kMostDensity);
        if (s.temperature != 0.0f) {
            cell.temperature += share * std::min(kHeating * dt, 1.0f) * (s.temperature - cell.temperature);
            if (!heat.empty()) heat[smoke.grid.at(i, j)] = cell.temperature;
        }
        if (!coloured) return;
        views.colour[4 * at] += more * s.colour.r;
        views.colour[4 * at + 1] += more * s.colour.g;
        views.colour[4 * at + 2] += more * s.colour.b;
    });
}

// visit(velocity's number, its middle, axis) for each of those near: on faces, or in the middle of cells with Stam's method.
template <class Visit> void each_velocity(Smoke& smoke, Span span, Visit visit) {
    const Grid& g = smoke.grid;
    for (int j = span.low; j <= span.high; ++j)
        for (int i = span.left; i <= span.right; ++i) {
            const Vec2 middle = middle_of(g, i, j);
            if (smoke.method == Method::stam) {
                float* both = &smoke.views->velocity[static_cast<std::size_t>(2 * (j * g.nx + i))];
                visit(both[0], middle, 0);
                visit(both[1], middle, 1);
            } else {
                visit(smoke.u[g.at(i, j)], middle - Vec2{0.5f * g.h, 0.0f}, 0);
                visit(smoke.v[g.at(i, j)], middle - Vec2{0.0f, 0.5f * g.h}, 1);
            }
        }
}

void blow(Smoke& smoke, const Source& s, const Place& place, const World& world, float dt) {
    const float grip = std::min(kBlowing * dt, 1.0f);
    each_velocity(smoke, place.span(smoke.grid), [&](float& value, Vec2 at, int axis) {
        const float share = place.covers(at, smoke.grid.h);
        if (share == 0.0f) return;
        Vec2 wanted = s.velocity;
        if (s.body != kNone) {
            const Body& b = world.bodies.rows[s.body];
            wanted = rotate(b.pose.q, wanted) + velocity_at(b, at);
        }
        value += share * grip * ((axis == 0 ? wanted.x : wanted.y) - value);
    });
}

} // namespace

void apply_sources(Smoke& smoke, std::uint32_t slot, const World& world, float dt) {
    const Fluids& all = world.fluids;
    for (std::uint32_t i = 0; i < all.source_slots.size(); ++i) {
        if (!all.source_slots.taken(i) || all.sources[i].smoke != slot || !all.sources[i].running) continue;
        const Place place(all.sources[i], world);
        pour(smoke, all.sources[i], place, dt);
        if (all.sources[i].blows) blow(smoke, all.sources[i], place, world, dt);
    }
}

Vec2 middle_of(const Source& source, const World& world) { return Place(source, world).middle(); }

void stir(World& world, Smoke& smoke, Vec2 at, float radius, Vec2 velocity) {
    const Step step{smoke, *smoke.scratch, world, 0.0f};
    const bool shown = smoke.method != Method::stam; // there, what is shown is the velocity itself
    if (shown && smoke.views->lent) take_over(step);
    const Vec2 reach{radius, radius};
    each_velocity(smoke, span_of(smoke.grid, at - reach, at + reach), [&](float& value, Vec2 here, int axis) {
        const float far = length_squared(here - at) / (radius * radius), share = std::max(1.0f - far, 0.0f);
        value += share * share * ((axis == 0 ? velocity.x : velocity.y) - value);
    });
    if (shown) show(step); // or the next step would take what is seen for what was written
}

} // namespace evil::fluid
