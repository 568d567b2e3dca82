#include "draw/debug_marks.hpp"
#include "fluid/scratch.hpp"

namespace evil::draw {
namespace {

using fluid::Smoke;

const fluid::Cell& cell_of(const Smoke& smoke, int i, int j) {
    return smoke.views->content[static_cast<std::size_t>(j * smoke.grid.nx + i)];
}

// What the last step left in a cell: 1/s, more than 0 where the flow spreads.
float divergence_of(const Smoke& smoke, int i, int j) {
    const fluid::Scratch& s = *smoke.scratch;
    if (smoke.method == fluid::Method::stam)
        return -s.stam.divergence[static_cast<std::size_t>((j + 1) * (smoke.grid.nx + 2) + i + 1)] / smoke.grid.h;
    return -s.inflow[smoke.grid.at(i, j)] / smoke.grid.h;
}

void find_arrows(const FluidFrame& f, const Smoke& smoke, std::vector<Arrow>& arrows) {
    const fluid::Grid& g = smoke.grid;
    const Squares squares = seen(f, g, kArrowEvery);
    const float room = static_cast<float>(squares.side) * g.h * pixels_a_metre(f);
    each_square(g, squares, [&](int i0, int j0, int i1, int j1) {
        Vec2 sum;
        int open = 0;
        for (int j = j0; j < j1; ++j)
            for (int i = i0; i < i1; ++i) {
                if (!(cell_of(smoke, i, j).open > 0.0f)) continue;
                const float* velocity = &smoke.views->velocity[static_cast<std::size_t>(2 * (j * g.nx + i))];
                sum = sum + Vec2{velocity[0], velocity[1]};
                ++open;
            }
        if (2 * open < (i1 - i0) * (j1 - j0)) return; // most of it is solid
        const Vec2 middle = 0.5f * (corner_of(g, i0, j0) + corner_of(g, i1, j1));
        arrows.push_back({middle, (1.0f / static_cast<float>(open)) * sum, room});
    });
}

void find_tiles(const FluidFrame& f, const Smoke& smoke, std::vector<Tile>& tiles) {
    fluid::Scratch& scratch = *smoke.scratch;
    const bool known = scratch.watched && scratch.gathering.before > 0.0f;
    scratch.watched = true;
    if (!known) return;
    const fluid::Grid& g = smoke.grid;
    each_square(g, seen(f, g, kTile), [&](int i0, int j0, int i1, int j1) {
        float sum = 0.0f;
        for (int j = j0; j < j1; ++j)
            for (int i = i0; i < i1; ++i)
                if (cell_of(smoke, i, j).open > 0.0f) sum += divergence_of(smoke, i, j);
        const auto cells = static_cast<float>((i1 - i0) * (j1 - j0));
        if (sum != 0.0f) tiles.push_back({corner_of(g, i0, j0), corner_of(g, i1, j1), sum / cells});
    });
}

} // namespace

void mark(const FluidFrame& f, const Smoke& smoke, Marks& marks) {
    if (f.shows(FluidPart::divergence)) find_tiles(f, smoke, marks.tiles);
    if (f.shows(FluidPart::flow)) find_arrows(f, smoke, marks.arrows);
}

void draw_cells(const FluidFrame& f, const Smoke& smoke) {
    fill_cells(f, smoke.grid, f.ink(FluidInk::solid),
               [&](int i, int j) { return !(cell_of(smoke, i, j).open > 0.0f); });
    draw_grid(f, smoke.grid, smoke.open);
}

} // namespace evil::draw
