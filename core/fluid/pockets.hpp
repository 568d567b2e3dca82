#pragma once
// Parts of a fluid's area that nothing flows between: bodies and walls seal them off from each other. In one that has no
// opening as much must flow in as out, and its pressure is only known up to a constant.
#include "fluid/pressure.hpp"
#include <cstdint>

namespace evil::fluid {

struct Openness { // of the faces and cells of a grid
    const Grid& grid;
    const std::array<bool, 4>& open; // sides
    const Field &across, &up, &gas;
};

class Pockets {
public:
    void find(const Openness& all, const Level& finest);
    bool any_sealed() const { return any_sealed_; }

    // The mean over each sealed pocket off a field.
    void level(const Grid& grid, Field& field, InstructionSet set, Threads& threads);

private:
    struct Run { // cells side by side in a row that lie in one pocket
        int first, last;
        std::uint32_t pocket; // first the number of a run, then that of the pocket
    };
    struct Pocket {
        bool sealed = true;
        double sum = 0.0, cells = 0.0;
    };
    void find_runs(const Openness& all, const Level& finest, int j);
    void join_rows(const Openness& all, int j);
    bool leads_out(const Openness& all, const Run& run, int j) const;
    std::uint32_t root(std::uint32_t run);

    std::vector<Run> runs_;
    std::vector<std::size_t> rows_; // where each begins, and the end
    std::vector<Pocket> pockets_;
    std::vector<float> sums_; // of runs
    bool any_sealed_ = false;
};

} // namespace evil::fluid
