#pragma once
// Contacts as the solver works on them: eight at a time, none of the eight sharing a body that can move.
#include <cstddef>
#include <cstdint>

namespace evil {

inline constexpr int kBlockLanes = 8;

// A body while it is solved: one row of 32 bytes. Row 0 stands for all that never move.
struct alignas(32) SolverBody {
    float vx = 0, vy = 0, spin = 0, inv_mass = 0; // what contacts change, and what they change it by
    float moved_x = 0, moved_y = 0;               // of the centre since the step began
    float turned_sine = 0;                        // of the angle since the step began, held within a quarter turn
    float inv_inertia = 0;
};
static_assert(sizeof(SolverBody) == 32);

// One manifold point of eight contacts. Arms are from the centres of mass at the start of the step, in the contact's own
// frame: along the normal n and along the tangent t = n turned right. Along n an arm's end moves by spin * (arm . t), along
// t by -spin * (arm . n).
struct alignas(32) BlockPoint {
    float arm_an[8], arm_at[8], arm_bn[8], arm_bt[8];
    float base[8]; // separation less what the arms account for
    float normal_mass[8], tangent_mass[8];
    float normal_impulse[8], tangent_impulse[8];
    float total_impulse[8]; // normal, summed over the substeps
};

struct alignas(32) ContactBlock {
    std::uint32_t a[8], b[8]; // rows of bodies; 0 in lanes without a contact
    float nx[8], ny[8];       // normal from a to b
    float friction[8];
    float surface_speed[8];                     // m/s along the tangent that friction works toward
    BlockPoint points[2];                       // the second has no mass in lanes with one point
    float bias_rate, mass_scale, impulse_scale; // softness, alike in all lanes: a block is all walls, or all bodies
};

} // namespace evil
