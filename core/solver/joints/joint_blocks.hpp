#pragma once
// Joints as the solver works on them: eight at a time, none of the eight sharing a body that can move.
//
// Two sorts of blocks hold all joints but gears and pulleys. A PointBlock holds a point of a on a point of b (hinge, weld,
// motor). An AxisBlock measures along a direction, between the anchors (distance, rope) or fixed to a (slider, wheel).
// What moves along one coordinate is driven by a DriveBlock beside it, which plain joints do not have.
#include <cstddef>
#include <cstdint>

namespace evil {

inline constexpr std::uint32_t kNoDrive = 0xffffffffu;
inline constexpr std::uint32_t kFixedAxis = 0xffffffffu; // as a mask of lanes

// How hard an error is answered: impulse = -mass (keep * speed + pull * error) - leak * impulse so far.
struct Softness {
    float keep = 1.0f, pull = 0.0f, leak = 0.0f;
};

struct alignas(32) SoftLanes { // of eight joints, in the pass that moves them and in the one that calms them
    float keep[8], pull[8], leak[8];
    float calm_keep[8], calm_pull[8], calm_leak[8];
    float most[8]; // newton seconds: the greatest impulse
};

// One coordinate of eight joints: spring (or a stiff hold), motor, limits.
struct alignas(32) DriveBlock {
    SoftLanes soft;
    float value[8]; // of the coordinate when the substep began
    float held[8];  // 1: kept at rest, along a way that may bend
    float base[8];  // turning alone: when the step began
    float mass[8];  // inverse of what a unit impulse changes of its speed
    float rest[8], lower[8], upper[8], speed[8], motor_most[8];
    float spring[8], motor[8], to_lower[8], to_upper[8]; // impulses
    float total[8];                                      // of all of them, summed over the substeps
};

struct alignas(32) PointBlock {
    std::uint32_t a[8], b[8];                                 // rows of bodies; 0 in lanes without a joint
    float start_ax[8], start_ay[8], start_bx[8], start_by[8]; // arms from the centres of mass when the step began
    float gap_x[8], gap_y[8];                                 // from centre to centre when the step began
    float ax[8], ay[8], bx[8], by[8];                         // arms in this substep
    float spin_a[8], spin_b[8];                               // when the arms were found
    float error_x[8], error_y[8];                             // from anchor to anchor when the substep began
    float mass_xx[8], mass_xy[8], mass_yy[8];                 // inverse of what unit impulses change
    float impulse_x[8], impulse_y[8], total_x[8], total_y[8];
    std::uint32_t turn = kNoDrive; // of DriveBlocks
    std::uint32_t soft = kNoDrive; // of SoftLanes; without: all eight are stiff
};

struct alignas(32) AxisBlock {
    std::uint32_t a[8], b[8];
    float start_ax[8], start_ay[8], start_bx[8], start_by[8];
    float gap_x[8], gap_y[8];
    float axis_x[8], axis_y[8]; // when the step began
    std::uint32_t fixed[8];     // kFixedAxis: the axis turns with a; 0: it runs from anchor to anchor
    std::uint32_t locked[8];    // kFixedAxis: b may not turn against a either (slider)
    float nx[8], ny[8];         // in this substep
    float arm_a[8], arm_b[8];   // what turning does along the axis: arm x n
    float side_a[8], side_b[8]; // and across it
    float error[8], error_turn[8], base_turn[8];
    float mass_ss[8], mass_st[8], mass_tt[8];
    float impulse_side[8], impulse_turn[8], total_side[8], total_turn[8];
    std::uint32_t along = kNoDrive; // of DriveBlocks: always there
    std::uint32_t turn = kNoDrive;
    std::uint32_t guided = 0; // are there lanes with a fixed axis?
};

// A gear or a pulley: one equation, solved alone.
struct LoneJoint {
    std::uint32_t joint, a, b;
    bool pulley;
    float ratio;
    float start_ax, start_ay, start_bx, start_by; // pulley: arms when the step began
    float rope_ax, rope_ay, rope_bx, rope_by;     // from where the ropes run over to the centres when the step began
    float wanted;                                 // pulley: sum of lengths
    float base;                                   // gear: error when the step began
    float ax, ay, bx, by;                         // what a unit impulse does: direction for each body
    float turn_a, turn_b;
    float length_a, length_b; // of a pulley's ropes
    float mass, error, impulse, total;
};

struct JointPass { // what all joints of a step have in common
    float h, inv_h;
    Softness stiff; // of what is held, in the pass that moves it
    Softness chain; // of joints in a row
};

} // namespace evil
