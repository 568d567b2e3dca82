#include "draw/debug_marks.hpp"
#include "fluid/water/scratch.hpp"

namespace evil::draw {
namespace {

using fluid::Particles;
using fluid::Water;

constexpr float kLeastDot = 1.5f; // logical points across
constexpr float kDot = 0.7f;      // of a particle's size
constexpr float kRound = 4.0f;    // points from which on a dot is round, not square

// A liquid's colour, a little lighter, so that it stands out from the veil, and arrows from it.
Rgba8 ink_of(const fluid::Colour& c) {
    Rgba8 ink = 0xb0000000u;
    const float parts[] = {c.r, c.g, c.b};
    for (std::uint32_t k = 0; k < 3; ++k)
        ink |= static_cast<Rgba8>(std::lround(40.0f + 215.0f * std::clamp(parts[k], 0.0f, 1.0f))) << (8 * k);
    return ink;
}

struct Sum { // of the particles in a square
    float x = 0.0f, y = 0.0f;
    int count = 0;
};

// What `give(particle)` gives, a Vec2, summed over the particles of each square that is seen, rows from below.
template <class Give> std::vector<Sum> sums_of(const Water& water, const Squares& s, Give give) {
    const fluid::Grid& g = water.grid;
    const int columns = (s.last_i - s.first_i + s.side - 1) / s.side,
              rows = (s.last_j - s.first_j + s.side - 1) / s.side;
    std::vector<Sum> sums(static_cast<std::size_t>(std::max(columns, 0)) * static_cast<std::size_t>(std::max(rows, 0)));
    const Particles& p = *water.particles;
    for (std::size_t k = 0; k < water.count; ++k) {
        const int i = static_cast<int>((p.positions[2 * k] - g.low.x) / g.h) - s.first_i;
        const int j = static_cast<int>((p.positions[2 * k + 1] - g.low.y) / g.h) - s.first_j;
        if (i < 0 || j < 0 || i >= s.last_i - s.first_i || j >= s.last_j - s.first_j) continue;
        Sum& sum = sums[static_cast<std::size_t>(j / s.side * columns + i / s.side)];
        const Vec2 given = give(k);
        sum.x += given.x, sum.y += given.y, ++sum.count;
    }
    return sums;
}

void find_arrows(const FluidFrame& f, const Water& water, std::vector<Arrow>& arrows) {
    const fluid::Grid& g = water.grid;
    const Particles& p = *water.particles;
    const Squares squares = seen(f, g, kArrowEvery);
    const float room = static_cast<float>(squares.side) * g.h * pixels_a_metre(f);
    const std::vector<Sum> sums =
        sums_of(water, squares, [&](std::size_t k) { return Vec2{p.velocities[2 * k], p.velocities[2 * k + 1]}; });
    auto sum = sums.begin();
    each_square(g, squares, [&](int i0, int j0, int i1, int j1) {
        const Sum& here = *sum++;
        if (here.count == 0) return;
        const Vec2 middle = 0.5f * (corner_of(g, i0, j0) + corner_of(g, i1, j1));
        arrows.push_back({middle, (1.0f / static_cast<float>(here.count)) * Vec2{here.x, here.y}, room});
    });
}

// By how the velocity changes round each particle.
void find_tiles(const FluidFrame& f, const Water& water, std::vector<Tile>& tiles) {
    const fluid::Grid& g = water.grid;
    const Particles& p = *water.particles;
    const Squares squares = seen(f, g, kTile);
    const std::vector<Sum> sums =
        sums_of(water, squares, [&](std::size_t k) { return Vec2{p.affine[4 * k], p.affine[4 * k + 3]}; });
    auto sum = sums.begin();
    each_square(g, squares, [&](int i0, int j0, int i1, int j1) {
        const Sum& here = *sum++;
        if (here.count == 0) return;
        tiles.push_back(
            {corner_of(g, i0, j0), corner_of(g, i1, j1), (here.x + here.y) / static_cast<float>(here.count)});
    });
}

} // namespace

void mark(const FluidFrame& f, const Water& water, Marks& marks) {
    if (f.shows(FluidPart::divergence)) find_tiles(f, water, marks.tiles);
    if (f.shows(FluidPart::flow)) find_arrows(f, water, marks.arrows);
}

void draw_cells(const FluidFrame& f, const Water& water) {
    const fluid::Grid& g = water.grid;
    Squares all = seen(f, g, 0.0f);
    const std::vector<Sum> sums = sums_of(water, all, [](std::size_t) { return Vec2{}; });
    const int columns = all.last_i - all.first_i;
    fill_cells(f, g, f.ink(FluidInk::liquid), [&](int i, int j) {
        return sums[static_cast<std::size_t>((j - all.first_j) * columns + i - all.first_i)].count > 0;
    });
    const fluid::WaterScratch& scratch = *water.scratch;
    if (scratch.laid_out && scratch.solids.any())
        fill_cells(f, g, f.ink(FluidInk::solid), [&](int i, int j) { return !(scratch.volume[g.at(i, j)] > 0.0f); });
    draw_grid(f, g, water.open);
}

void draw_particles(const FluidFrame& f, const Water& water) {
    const Particles& p = *water.particles;
    const float wide = std::max(kDot * water.particle_size * pixels_a_metre(f), kLeastDot * f.points),
                half = 0.5f * wide;
    for (std::size_t k = 0; k < water.count; ++k) {
        const Vec2 at = apply(f.view, {p.positions[2 * k], p.positions[2 * k + 1]});
        if (!(at.x > -half && at.y > -half && at.x < f.screen.x + half && at.y < f.screen.y + half)) continue;
        const Rgba8 colour = ink_of(water.liquids[p.liquid[k]].colour);
        if (wide >= kRound * f.points)
            disc(f.overlay, at, half, colour);
        else
            box(f.overlay, at - Vec2{half, half}, at + Vec2{half, half}, colour);
    }
}

} // namespace evil::draw
