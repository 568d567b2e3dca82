#pragma once
// The velocity's kernels, a few rows each: from `first` up to, not including, `last`.
#include "math/cpu.hpp"
#include <cstddef>

namespace evil::fluid {

struct Plan { // how the fields lie
    int nx, ny;
    std::ptrdiff_t stride;
};

// One component on its faces and what is needed to move it: `columns` and `rows` of them; each goes with the mean of the
// displacements of two cells, `beside` apart: 1 for left faces, the stride for lower ones.
struct Faces {
    int columns, rows;
    std::ptrdiff_t beside;
    const float* value; // as it is
    float* carried;     // one step of plain advection on
    float *low, *high;  // what it was made of lay between these
    float* result;
};

} // namespace evil::fluid

namespace evil {

// The velocity in the middle of each cell.
EVIL_WIDE(void centre_flow(const fluid::Plan& plan, const float* u, const float* v, float* x, float* y, int first,
                           int last) noexcept;)
// How many cells each cell's gas came along within the step, by the midpoint rule; `cells`: dt / h.
EVIL_WIDE(void trace_back(const fluid::Plan& plan, const float* x, const float* y, float cells, float* dx, float* dy,
                          int first, int last) noexcept;)
// Semi-Lagrangian, and then MacCormack's correction (Selle et al. 2008) by half of what going back would miss.
EVIL_WIDE(void carry_faces(const fluid::Plan& plan, const fluid::Faces& faces, const float* dx, const float* dy,
                           int first, int last) noexcept;)
EVIL_WIDE(void correct_faces(const fluid::Plan& plan, const fluid::Faces& faces, const float* dx, const float* dy,
                             int first, int last) noexcept;)
// b = what flows into each cell by its faces, as open as they are.
EVIL_WIDE(void find_inflow(const fluid::Plan& plan, const float* u, const float* v, const float* across,
                           const float* up, float* b, int first, int last) noexcept;)
EVIL_WIDE(float sum_of(const float* values, int count) noexcept;)
EVIL_WIDE(void add_to_each(float* values, int count, float more) noexcept;)
// The pressure's gradient off the velocity; what lies in solids stands still.
EVIL_WIDE(void push_by_pressure(const fluid::Plan& plan, const float* p, const float* across, const float* up, float* u,
                                float* v, int first, int last) noexcept;)
// 2 * after - before, into before: the reflection (Zehnder, Narain and Thomaszewski 2018).
EVIL_WIDE(void reflect(const float* after, float* before, std::ptrdiff_t count) noexcept;)
// Heat rises, wind pulls: the same to each face of a row. No face is faster than `most` then.
EVIL_WIDE(void lift_faces(const float* here, const float* beside, float lift, float wind, float pull, float most,
                          int count, float* value) noexcept;)
EVIL_WIDE(void find_curl(const fluid::Plan& plan, const float* x, const float* y, float* curl, int first,
                         int last) noexcept;)
// Whirls are pushed to go on round: a force square to the way to their middle (Fedkiw, Stam and Jensen 2001).
EVIL_WIDE(void keep_whirls(const fluid::Plan& plan, const float* curl, float strength, float* x, float* y, int first,
                           int last) noexcept;)
// to += the mean of the two beside each face.
EVIL_WIDE(void add_means(const float* here, const float* beside, int count, float* to) noexcept;)

// One sweep of Jacobi's, drawn out by Chebyshev's factor: before := factor * (sweep(now) - before) + before, for the faces
// (first_column..last_column of each row) that are open at all; `a`: viscosity * dt / h^2.
EVIL_WIDE(void thicken(const fluid::Plan& plan, const float* wanted, const float* now, const float* share, float a,
                       float factor, int first_column, int last_column, int first, int last, float* before) noexcept;)
// The velocity in the middle of each cell, x and y side by side, rows without gaps.
EVIL_WIDE(void publish_flow(const fluid::Plan& plan, const float* u, const float* v, float* out, int first,
                            int last) noexcept;)

} // namespace evil
