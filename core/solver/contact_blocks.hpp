#pragma once
// Contacts as the solver works on them: eight at a time, none of the eight sharing a body that can move.
#include <cstddef>
#include <cstdint>

namespace evil {

inline constexpr std::uint32_t kBlockLanes = 8;

// A body while it is solved: one row of 32 bytes. Row 0 stands for all that never move.
struct alignas(32) SolverBody {
    float vx = 0, vy = 0, spin = 0, inv_mass = 0; // what contacts change, and what they change it by
    float moved_x = 0, moved_y = 0, turned = 0;   // of centre and angle since the step began
    float inv_inertia = 0;
};
static_assert(sizeof(SolverBody) == 32);
inline constexpr std::uint32_t kBodyFloats = 8;

// What a substep does to a row but for contacts: velocity * keep + gain; and what that made of it. Lanes as the first four
// of SolverBody.
struct ForceStep {
    float keep[4] = {1, 1, 1, 1}, gain[4] = {}, pushed[4] = {};
};

// Eight contacts. Arms lead from a centre of mass to the contact point at the start of the step, in the contact's own frame:
// along the normal n and along the tangent t = n turned right. Along n an arm's end moves by spin * (arm . t), along t by
// -spin * (arm . n).
//
// Both bodies are pushed at one and the same point, also when they slide within the step: so no pair of impulses turns what
// it does not turn in nature, and angular momentum is kept. The point goes along with the body whose corner or round side
// it is; `lag` is the share of the sliding that moves it along the other one's arm. Between discs the normal turns instead.
struct alignas(32) ContactBlock {
    std::uint32_t a[8], b[8]; // where the rows of bodies begin, in floats; 0 in lanes without a contact. What does not
                              // move is always a
    float nx[8], ny[8];       // normal from a to b
    float friction[8];
    float surface_speed[8]; // m/s along the tangent that friction works toward
    float lag[8];           // 0: the point stays with b, 1: with a; below 0: discs, less one over their radii's sum,
                            // or next to nothing for a disc on a flat wall
    float apart_n[8], apart_t[8];                // from the centre of b to that of a: what the arms differ by
    float arm_n[2][8], arm_t[2][8];              // from the centre of b, for each of the two points
    float gap[2][8];                             // metres; negative: overlap
    float normal_mass[2][8], tangent_mass[2][8]; // 0 where there is no point
    float normal_impulse[2][8], tangent_impulse[2][8];
    float total_impulse[2][8]; // normal, summed over the substeps
};

// Where the eight come from, and what is asked of them but once.
struct alignas(32) BlockSource {
    std::uint32_t contact[8];  // rows of contacts; kNone in lanes without one, which come last
    std::uint32_t turn[8];     // all ones: the contact's own a is the block's b
    std::uint32_t known[8];    // four bytes of the contact: count, fresh, touching, struck
    float closing_speed[2][8]; // before the step; negative: they part
};

// A spring and damper that stands in for a hard contact (solver/contact_constraints.cpp).
struct ContactSoftness {
    float bias_rate, mass_scale, impulse_scale;
};

} // namespace evil
