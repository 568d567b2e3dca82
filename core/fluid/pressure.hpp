#pragma once
// The pressure that keeps a flow from gathering anywhere: the equation  sum over faces of w * (p - p_neighbour) = b, where
// w is how open a face is. Multigrid (Brandt 1977) with red-black Gauss-Seidel; coarse faces are as open as the fine ones
// that they are made of, and coarse solid cells borrow the values of their neighbours (McAdams et al. 2010, simplified).
//
// Gas and water alike may use it: it knows no more than how open faces are.
#include "fluid/grid.hpp"
#include "fluid/pressure_wide.hpp"
#include "threads.hpp"
#include <array>
#include <span>
#include <vector>

namespace evil::fluid {

struct Patch { // of cells: from left and low up to, not including, right and high
    int left = 0, low = 0, right = 0, high = 0;
    bool empty() const { return left >= right || low >= high; }
};

// One grid of the pyramid, its sides rounded up to even; the cell more that an odd one gets is solid.
struct Level {
    int nx = 0, ny = 0, half = 0, tiles = 0;
    float right = 0.5f, top = 0.5f; // how far these edges, if open, are from the middle of the last cells, in cells
    std::ptrdiff_t stride = 0;
    std::vector<float> room; // all of the arrays below
    std::array<float*, 2> p{}, b{}, diagonal{}, inverse{};
    std::array<std::array<float*, 4>, 2> weight{};
    std::array<std::vector<std::uint8_t>, 2> plain;
    std::vector<float> across, up,
        drain; // open shares of left and lower faces; what leaves by open sides; rows of nx + 1

    struct Borrower { // a solid cell beside open ones: its value is theirs
        std::uint8_t colour;
        std::uint8_t count;
        std::int32_t at;
        std::array<std::uint8_t, 4> colours;
        std::array<std::int32_t, 4> lenders;
    };
    std::vector<Borrower> borrowers;

    void lay_out(int wide, int high);
    std::size_t face(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx + 1) + static_cast<std::size_t>(i);
    }
    LevelView view() const;
};

class Pressure {
public:
    void lay_out(const Grid& grid, const std::array<bool, 4>& open);

    // The faces of these patches are now as open as these fields say; call it for all of the grid first.
    void set_faces(const Grid& grid, const Field& across, const Field& up, std::span<const Patch> patches);

    // p of the equation for b, from the p that is there, by so many cycles.
    void solve(const Grid& grid, const Field& b, Field& p, int cycles, InstructionSet set, Threads& threads);

    const Level& finest() const { return levels_.front(); }

private:
    void set_patch(const Grid& grid, const Field& across, const Field& up, const Patch& patch);
    void cycle(std::size_t level, InstructionSet set, Threads& threads);
    void smooth_level(const Level& level, int sweeps, InstructionSet set, Threads& threads) const;
    std::vector<Level> levels_;
    std::array<float, 4> mirror_{}; // of a correction beyond each side
    std::size_t room_for_rows_ = 0; // floats that a part of the rows needs
    std::vector<float> room_;
};

} // namespace evil::fluid
