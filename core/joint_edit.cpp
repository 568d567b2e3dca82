// Adding and removing joints, and breaking those that were pulled too hard.
#include "identity.hpp"

namespace evil {
namespace {

void wake_ends(World& world, const Joint& joint) {
    wake(world, joint.body_a);
    wake(world, joint.body_b);
}

} // namespace

JointRef add_joint(World& world, Joint joint) {
    Joints& joints = world.joints;
    std::uint32_t slot = joints.slots.take();
    if (slot >= joints.rows.size()) joints.rows.resize(slot + 1);
    joint.serial = joints.next_serial++;
    joint.born = world.steps;
    joint.made = fingerprint(joint);
    joints.rows[slot] = joint;
    link(joints, slot);
    joints.unchecked = true;
    wake_ends(world, joint);
    return {slot, joints.slots.generation(slot)};
}

void destroy_joint(World& world, std::uint32_t slot) {
    Joints& joints = world.joints;
    wake_ends(world, joints.rows[slot]);
    unlink(joints, slot);
    joints.rows[slot] = {};
    joints.slots.release(slot);
}

void drop_joints_of(World& world, std::uint32_t body) {
    Joints& joints = world.joints;
    if (body >= joints.of_body.size()) return;
    while (joints.of_body[body].first != kNone) destroy_joint(world, joints.of_body[body].first);
}

void break_joints(World& world) {
    Joints& joints = world.joints;
    joints.broken.clear();
    if (!joints.unchecked) return;
    joints.unchecked = false;
    for (std::uint32_t slot = 0; slot < joints.slots.size(); ++slot) {
        if (!joints.slots.taken(slot)) continue;
        const Joint& j = joints.rows[slot];
        if (holds(j)) continue;
        auto ref = [&](std::uint32_t b) { return BodyRef{b, world.bodies.slots.generation(b)}; };
        joints.broken.push_back(
            {{slot, joints.slots.generation(slot)}, ref(j.body_a), ref(j.body_b), j.serial, j.force, j.torque});
    }
    std::ranges::sort(joints.broken, {}, &BrokenJoint::serial);
    for (const BrokenJoint& b : joints.broken) destroy_joint(world, b.ref.slot);
}

} // namespace evil
