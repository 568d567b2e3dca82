"""The nine kinds of joints: bodies first, points in world coordinates as the bodies now stand (SPEC P8).

Springs are given by `frequency` (hertz of the two bodies on it) and `damping_ratio` (0 swings for ever, 1 just does not
swing), or by `stiffness` and `damping` (N/m and N s/m; N m/rad and N m s/rad where it turns). A motor keeps
`motor_speed` with at most `max_force` or `max_torque`; at speed 0 it is friction. Limits are (least, greatest).
"""

from evilengine.world.joints.joint import BrokenJoint, Joint, Joints
from evilengine.world.joints.pins import Gear, Hinge, Motor, Weld
from evilengine.world.joints.rails import Slider, Wheel
from evilengine.world.joints.rods import Distance, Pulley, Rope

__all__ = [
    "BrokenJoint",
    "Distance",
    "Gear",
    "Hinge",
    "Joint",
    "Joints",
    "Motor",
    "Pulley",
    "Rope",
    "Slider",
    "Weld",
    "Wheel",
]

KINDS: dict[int, type[Joint]] = {
    kind._kind: kind for kind in (Distance, Hinge, Slider, Weld, Wheel, Motor, Rope, Gear, Pulley)
}
"""By JointKind in core/solver/joints/joint.hpp."""
