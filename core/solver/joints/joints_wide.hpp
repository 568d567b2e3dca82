#pragma once
#include "math/cpu.hpp"
#include "solver/contact_blocks.hpp"
#include "solver/joints/joint_blocks.hpp"

namespace evil {

struct JointTables { // what the kernels work on
    SolverBody* bodies;
    PointBlock* points;
    std::size_t point_count;
    AxisBlock* axes;
    std::size_t axis_count;
    DriveBlock* drives;
    SoftLanes* softs;
    JointPass pass;
};

// `begin_joints` finds arms, errors and masses when a step begins; `warm_joints` starts from the impulses of the last
// substep; `move_joints` solves with a push that mends errors; `calm_joints`, once the bodies have moved, finds arms and
// all that anew, solves without the push, and adds up what was needed.
EVIL_WIDE(void begin_joints(const JointTables& tables) noexcept; void warm_joints(const JointTables& tables) noexcept;
          void move_joints(const JointTables& tables) noexcept; void calm_joints(const JointTables& tables) noexcept;)
} // namespace evil
