// What liquids do by themselves: viscosity, implicit, so that honey costs no smaller steps, and the tension of the surface.
#include "fluid/water/scratch.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>
#include <span>

namespace evil::fluid {
namespace {

constexpr int kMostRounds = 60;
constexpr float kTolerance = 1e-3f;
constexpr float kCalm = 50.0f; // tension that a step can follow: dt^2 < rho h^3 / (4 pi tension), with room to spare

// The mean of what the particles of each cell are told by their liquid; where there are none, what the first one is.
void mean_of_liquids(const Water& water, float Liquid::* quality, Field& mean) {
    const WaterScratch& s = *water.scratch;
    const float usual = water.liquids[0].*quality;
    for (const Tile& tile : s.active) std::fill_n(mean.data() + tile.at, 8, usual);
    if (water.liquids.size() == 1) return;
    std::uint32_t begin = 0;
    for (const Tile& tile : s.occupied)
        for (std::ptrdiff_t at = tile.at; at < tile.at + 8; ++at) {
            const std::uint32_t end = s.first[static_cast<std::size_t>(at)];
            float sum = 0.0f;
            for (std::uint32_t k = begin; k < end; ++k) sum += water.liquids[s.swarm.liquid[k]].*quality;
            if (end > begin) mean[at] = sum / static_cast<float>(end - begin);
            begin = end;
        }
}

bool any_has(const Water& water, float Liquid::* quality) {
    return std::ranges::any_of(water.liquids, [&](const Liquid& l) { return l.*quality > 0.0f; });
}

// ---- viscosity: (1 + sum of k) u - sum of k * u_neighbour = u before, on the faces of one direction ------------------

class Thickening {
public:
    Thickening(World& world, Water& water, bool sideways, float dt)
        : world_(world), water_(water), s_(*water.scratch), t_(s_.thick), g_(water.grid), sideways_(sideways),
          flow_(sideways ? s_.u : s_.v), open_(sideways ? s_.solids.across() : s_.solids.up()),
          beside_(sideways ? 1 : g_.stride), dt_(dt), per_viscosity_(dt / (g_.h * g_.h)) {}

    void run() {
        number_faces();
        if (t_.faces.empty()) return;
        t_.rubs.clear();
        for (std::size_t k = 0; k < t_.faces.size(); ++k) link(k);
        rub();
        solve();
        for (std::size_t k = 0; k < t_.faces.size(); ++k) flow_[t_.faces[k].at] = t_.x[k];
        for (const ThickFace& face : t_.faces) t_.numbers[static_cast<std::size_t>(face.at)] = -1;
    }

private:
    int wide() const { return sideways_ ? g_.nx + 1 : g_.nx; }
    int high() const { return sideways_ ? g_.ny : g_.ny + 1; }
    bool is_wet(std::ptrdiff_t at) const { return open_[at] > 0.0f && s_.wet[at] + s_.wet[at - beside_] > 0.0f; }

    float viscosity(std::ptrdiff_t at) const { return s_.viscosity[s_.wet[at] > 0.0f ? at : at - beside_]; }

    void number_faces() {
        t_.faces.clear();
        for (const Tile& tile : s_.active)
            for (int i = tile.i; tile.j >= 0 && tile.j < high() && i < std::min(tile.i + 8, wide()); ++i) {
                const std::ptrdiff_t at = g_.at(i, tile.j);
                if (!is_wet(at)) continue;
                t_.numbers[static_cast<std::size_t>(at)] = static_cast<std::int32_t>(t_.faces.size());
                t_.faces.push_back({static_cast<std::int32_t>(at), i, tile.j, {-1, -1, -1, -1}, {}, 1.0f, flow_[at]});
            }
        t_.x.resize(t_.faces.size());
    }

    void link(std::size_t number) {
        ThickFace& face = t_.faces[number];
        const std::ptrdiff_t at = face.at;
        t_.x[number] = flow_[at];
        const int steps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
        for (std::size_t d = 0; d < 4; ++d) {
            const int i = face.i + steps[d][0], j = face.j + steps[d][1];
            const bool ahead = sideways_ ? d < 2 : d >= 2; // else the wall is half a cell away
            const bool outside = i < 0 || j < 0 || i >= wide() || j >= high();
            const std::ptrdiff_t other = g_.at(i, j);
            const bool linked = !outside && is_wet(other);
            const float k = per_viscosity_ * (linked ? 0.5f * (viscosity(at) + viscosity(other)) : viscosity(at));
            if (linked) {
                face.next[d] = t_.numbers[static_cast<std::size_t>(other)];
                face.k[d] = k;
                face.total += k;
            } else if (outside || open_[other] == 0.0f) {
                const float firm = ahead ? k : 2.0f * k;
                face.total += firm;
                if (!outside) touch(number, i, j, firm);
            }
        }
    }

    // A face rubs on what stands at a place: on nothing that moves unless that is a body.
    void touch(std::size_t number, int i, int j, float firm) {
        if (sideways_ ? i == 0 || i == g_.nx : j == 0 || j == g_.ny) return;
        const float x = static_cast<float>(i) + (sideways_ ? 0.0f : 0.5f),
                    y = static_cast<float>(j) + (sideways_ ? 0.5f : 0.0f);
        const Bank bank = bank_at(water_, x, y);
        if (bank.body == kNone || !moves(world_.bodies.rows[bank.body])) return;
        const Vec2 arm = g_.low + g_.h * Vec2{x, y} - world_.bodies.rows[bank.body].centre;
        t_.rubs.push_back({bank.body, number, sideways_ ? -arm.y : arm.x, firm});
    }

    // Liquid drags bodies along, at most to its own speed, and then follows what they have: were it to follow what they
    // had, the two would swap their speeds in each step.
    void rub() {
        std::ranges::stable_sort(t_.rubs, {}, &Rub::body);
        for (std::size_t first = 0, last = 0; first < t_.rubs.size(); first = last) {
            while (last < t_.rubs.size() && t_.rubs[last].body == t_.rubs[first].body) ++last;
            const std::span<const Rub> rubs(&t_.rubs[first], last - first);
            Body& b = world_.bodies.rows[rubs[0].body];
            if (b.kind == BodyKind::dynamic && b.awake) drag(b, t_.drags[rubs[0].body], rubs);
            for (const Rub& rub : rubs) t_.faces[rub.face].wanted += rub.firm * speed_at(b, rub);
        }
    }

    float speed_at(const Body& b, const Rub& rub) const { // of the body, as it will be
        const Drag& drag = t_.drags[rub.body];
        return (sideways_ ? b.velocity.x : b.velocity.y) + (sideways_ ? drag.x : drag.y) +
               rub.arm * (b.spin + drag.spin);
    }

    void drag(Body& b, Drag& drag, std::span<const Rub> rubs) const {
        const float mass_of_face = heaviest(water_) * g_.h * g_.h;
        float push = 0.0f, mass = 0.0f, turn = 0.0f, inertia = 0.0f;
        for (const Rub& rub : rubs) {
            // no more of it is dragged along than rubbing reaches within the step
            const float weight = mass_of_face * rub.firm / (1.0f + std::sqrt(rub.firm));
            const float against = flow_[t_.faces[rub.face].at] - speed_at(b, rub);
            push += weight * against, mass += weight;
            turn += weight * against * rub.arm, inertia += weight * rub.arm * rub.arm;
        }
        const float force = push / (1.0f + mass * b.inv_mass), torque = turn / (1.0f + inertia * b.inv_inertia);
        (sideways_ ? drag.x : drag.y) += b.inv_mass * force;
        drag.spin += b.inv_inertia * torque;
        b.force = clamped(b.force + force / dt_ * (sideways_ ? Vec2{1, 0} : Vec2{0, 1}), kMaxForce);
        b.torque = clamped(b.torque + torque / dt_, kMaxForce);
    }

    void solve() { // conjugate gradients, led by the diagonal
        const std::size_t n = t_.faces.size();
        for (auto* list : {&t_.r, &t_.s, &t_.q}) list->assign(n, 0.0f);
        apply(t_.x, t_.q);
        double size = 0.0, before = 0.0;
        for (std::size_t k = 0; k < n; ++k) {
            t_.r[k] = t_.faces[k].wanted - t_.q[k];
            size += double(t_.faces[k].wanted) * double(t_.faces[k].wanted);
            t_.s[k] = t_.r[k] / t_.faces[k].total;
            before += double(t_.r[k]) * double(t_.s[k]);
        }
        const double enough = double(kTolerance) * double(kTolerance) * size;
        for (int round = 0; round < kMostRounds && before > enough; ++round) {
            apply(t_.s, t_.q);
            double energy = 0.0, now = 0.0;
            for (std::size_t k = 0; k < n; ++k) energy += double(t_.s[k]) * double(t_.q[k]);
            if (!(energy > 0.0)) return;
            const float step = static_cast<float>(before / energy);
            for (std::size_t k = 0; k < n; ++k) {
                t_.x[k] += step * t_.s[k];
                t_.r[k] -= step * t_.q[k];
                now += double(t_.r[k]) * double(t_.r[k] / t_.faces[k].total);
            }
            const float keep = static_cast<float>(now / before);
            before = now;
            for (std::size_t k = 0; k < n; ++k) t_.s[k] = t_.r[k] / t_.faces[k].total + keep * t_.s[k];
        }
    }

    void apply(const std::vector<float>& in, std::vector<float>& out) const {
        for (std::size_t k = 0; k < in.size(); ++k) {
            const ThickFace& face = t_.faces[k];
            float sum = face.total * in[k];
            for (std::size_t d = 0; d < 4; ++d)
                if (face.next[d] >= 0) sum -= face.k[d] * in[static_cast<std::size_t>(face.next[d])];
            out[k] = sum;
        }
    }

    World& world_;
    const Water& water_;
    WaterScratch& s_;
    ThickScratch& t_;
    const Grid& g_;
    bool sideways_;
    Field& flow_;
    const Field& open_;
    std::ptrdiff_t beside_;
    float dt_, per_viscosity_;
};

// ---- the surface's tension ---------------------------------------------------------------------------------------------

// How much the surface bends in a cell, 1/cells: positive where the liquid bulges. Fullness is smoothed first; a solid is as
// full as the cell asked about.
float bend_at(const WaterScratch& s, std::ptrdiff_t at, int stride) {
    float full[5][5], smooth[4][4];
    const float own = s.rho[at];
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i) {
            const float rho = s.rho[at + (j - 2) * stride + (i - 2)];
            full[j][i] = rho < 2.0f ? std::min(rho, 1.0f) : std::min(own, 1.0f);
        }
    for (int j = 0; j < 4; ++j) // at the corners of cells
        for (int i = 0; i < 4; ++i)
            smooth[j][i] = 0.25f * (full[j][i] + full[j][i + 1] + full[j + 1][i] + full[j + 1][i + 1]);
    Vec2 out[3][3]; // of the liquid, in the middle of cells
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const float a = smooth[j][i], b = smooth[j][i + 1], c = smooth[j + 1][i], d = smooth[j + 1][i + 1];
            out[j][i] = normalised(Vec2{(a + c) - (b + d), (a + b) - (c + d)});
        }
    float bend = 0.0f;
    for (int k = 0; k < 3; ++k) {
        const float weight = k == 1 ? 0.25f : 0.125f;
        bend += weight * ((out[k][2].x - out[k][0].x) + (out[2][k].y - out[0][k].y));
    }
    return std::clamp(bend, -1.0f, 1.0f);
}

} // namespace

void thicken(World& world, Water& water, float dt) {
    if (!any_has(water, &Liquid::viscosity)) return;
    WaterScratch& s = *water.scratch;
    if (s.thick.numbers.empty()) {
        s.viscosity.lay_out(water.grid);
        s.thick.numbers.assign(static_cast<std::size_t>(water.grid.stride * (water.grid.ny + 2)), -1);
    }
    mean_of_liquids(water, &Liquid::viscosity, s.viscosity);
    s.thick.drags.assign(world.bodies.rows.size(), {});
    for (bool sideways : {true, false}) Thickening(world, water, sideways, dt).run();
}

void stretch_skin(Water& water, float dt) {
    WaterScratch& s = *water.scratch;
    const Grid& g = water.grid;
    if (!any_has(water, &Liquid::surface_tension)) return;
    s.has_skin = true;
    if (s.tension.empty()) s.tension.lay_out(g);
    mean_of_liquids(water, &Liquid::surface_tension, s.tension);
    const float heavy = heaviest(water);
    const PressLevel& level = s.press.finest();
    for (const Tile& tile : s.wet_tiles)
        for (int i = std::max(tile.i, 2); i < std::min(tile.i + 8, g.nx - 2); ++i) {
            const std::ptrdiff_t at = g.at(i, tile.j);
            if (tile.j < 2 || tile.j >= g.ny - 2 || level.drain[at] == 0.0f) continue;
            const float most = heavy * s.mass[at] * g.h * g.h * g.h / (kCalm * dt * dt);
            const float tension = std::min(s.tension[at], most);
            s.skin[at] = tension * bend_at(s, at, g.stride) / g.h * dt / (heavy * g.h);
        }
}

void drop_skin(Water& water) {
    WaterScratch& s = *water.scratch;
    if (s.has_skin)
        for (const Tile& tile : s.wet_tiles) std::fill_n(s.skin.data() + tile.at, 8, 0.0f);
    s.has_skin = false;
}

} // namespace evil::fluid
