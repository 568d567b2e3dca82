#pragma once
// What gas carries along: cells of four floats, two at a time. The fourth says whether there is gas, 1 or 0; interpolated
// along, it tells how much of a value is real, so that solids, which hold nothing, take nothing from their neighbours.
#include "fluid/flow_wide.hpp"

namespace evil::fluid {

// What becomes of a cell's four numbers within a step. They are multiplied by `first` and `then`; of the third, `burns` is
// the share that turns into the first and the second, as much as `soot` and `heat` say.
struct Fate {
    float first[4], then[4];
    float burns, soot, heat;
    float most; // of the second, either way
};

} // namespace evil::fluid

namespace evil {

// Semi-Lagrangian: `carried` gets what lay where each cell's gas came from; its fourth is 1 where all of that was gas.
EVIL_WIDE(void carry_cells(const fluid::Plan& plan, const float* cells, const float* dx, const float* dy,
                           float* carried, int first, int last) noexcept;)
// MacCormack's correction, into `result`, where gas lies in all that it is made of; `open`: where there is gas now. `sums`:
// the first number of each row's cells, before and after.
EVIL_WIDE(void correct_cells(const fluid::Plan& plan, const float* cells, const float* carried, const float* dx,
                             const float* dy, const float* open, float* result, float* sums, int first,
                             int last) noexcept;)
// The cells as they are to be; the second number of each goes into a field, too, if there is one.
EVIL_WIDE(void settle_cells(const fluid::Plan& plan, const fluid::Fate& fate, const float* cells, float* result,
                            float* seconds, int first, int last) noexcept;)

} // namespace evil
