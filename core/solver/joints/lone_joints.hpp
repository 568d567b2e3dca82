#pragma once
// Gears and pulleys: few in any game, each one equation between two bodies, solved one after the other.
#include "solver/contact_blocks.hpp"
#include "solver/joints/joint.hpp"
#include "solver/joints/joint_blocks.hpp"
#include <span>

namespace evil {

LoneJoint lone_joint(const Joint& joint, std::uint32_t slot, std::uint32_t a, std::uint32_t b, const Bodies& bodies);
void begin_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies);
void warm_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies);
void move_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies, const JointPass& pass);
void calm_lone(std::span<LoneJoint> joints, std::span<SolverBody> bodies);

} // namespace evil
