"""Joint: what all joints have in common, and the joints of a world (SPEC P8).

A joint is made, then added: `world.add_joint(joint)`. From then on it is the handle of what it added: its values can be
read and changed, and `destroy()` ends it. The nine kinds are in `evil.joints`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, TypeVar

from evilengine import _core
from evilengine.values.callbacks import Callbacks
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Vec2
from evilengine.world.arguments import flag
from evilengine.world.body import Body
from evilengine.world.joints.fields import greatest, or_none

if TYPE_CHECKING:
    from evilengine.world.world import World


class Joint(ABC):
    """Base of the joints in `evil.joints`: ties body `b` to body `a`.

    The two do not touch each other unless `collide=True`. A joint that has to hold more than `breaking_force` newtons
    or `breaking_torque` newton metres, on average over a step, breaks: it is destroyed, `on_break` is called, and it is
    one of `world.joints.broken`.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> wall = world.add(evil.Rectangle(1, 1), kind="static")
    >>> sign = world.add(evil.Rectangle(1, 2), at=(0, -2), mass=2)
    >>> hinge = world.add_joint(evil.joints.Hinge(wall, sign, at=(0, -1)))
    >>> for _ in range(60):
    ...     world.step()
    >>> round(hinge.force.y, 1)
    19.6
    >>> hinge.destroy(); hinge.alive
    False
    """

    _kind: ClassVar[int]

    def __init__(
        self, a: Body, b: Body, *, collide: bool, breaking_force: float | None, breaking_torque: float | None
    ) -> None:
        owner = type(self).__name__
        for name, body in (("a", a), ("b", b)):
            if not isinstance(body, Body):
                raise ArgumentTypeError(f"{owner}: {name} must be a Body, as world.add returns; got {body!r}")
            body._require()
        if a._world is not b._world:
            raise ArgumentError(f"{owner}: a={a!r} and b={b!r} are in two worlds; a joint ties bodies of one")
        if a == b:
            raise ArgumentError(f"{owner}: a and b are both {a!r}; a joint ties two different bodies")
        self._a, self._b = a, b
        self._world: World | None = None
        self._broken: Callbacks[[BrokenJoint]] = Callbacks(f"{owner}.on_break", "broken")
        self._fields: _core.JointSpec | _core.Joint = _core.JointSpec(self._kind, flag(collide, owner, "collide"))
        self.breaking_force, self.breaking_torque = breaking_force, breaking_torque

    # -- what it ties --

    @property
    def a(self) -> Body:
        """The first of its bodies."""
        return self._a

    @property
    def b(self) -> Body:
        """The second: forces and speeds are b's against a."""
        return self._b

    @property
    def at_a(self) -> Vec2:
        """Where it holds a, in the world."""
        return self._handle().at_a

    @property
    def at_b(self) -> Vec2:
        """Where it holds b, in the world."""
        return self._handle().at_b

    @property
    def collide(self) -> bool:
        """May its two bodies touch each other?"""
        return self._handle().collide

    # -- what it does --

    @property
    def force(self) -> Vec2:
        """Newtons that it put on b in the last step, on average; a got as much the other way."""
        return self._handle().force

    @property
    def torque(self) -> float:
        """Newton metres that it put on b in the last step, beside what its force does."""
        return self._handle().torque

    @property
    def breaking_force(self) -> float | None:
        """Newtons at which it breaks; None: never."""
        return or_none(self._fields.breaking_force)

    @breaking_force.setter
    def breaking_force(self, value: float | None) -> None:
        self._fields.breaking_force = greatest(value, type(self).__name__, "breaking_force", above=0.0)

    @property
    def breaking_torque(self) -> float | None:
        """Newton metres at which it breaks; None: never."""
        return or_none(self._fields.breaking_torque)

    @breaking_torque.setter
    def breaking_torque(self, value: float | None) -> None:
        self._fields.breaking_torque = greatest(value, type(self).__name__, "breaking_torque", above=0.0)

    @property
    def on_break(self) -> Callbacks[[BrokenJoint]]:
        """Decorator: call a function with the BrokenJoint after the step in which it broke."""
        if self._world is not None:
            self._handle()
        return self._broken

    # -- its life as a handle --

    @property
    def alive(self) -> bool:
        """Is it at work in a world? False before it was added and after it broke or was destroyed."""
        return isinstance(self._fields, _core.Joint) and self._fields.alive

    @property
    def world(self) -> World:
        """The world that it works in."""
        self._handle()
        assert self._world is not None
        return self._world

    def destroy(self) -> None:
        """Untie the bodies. Any later use raises StaleReferenceError."""
        handle = self._handle()
        self.world._joints.pop(handle.slot, None)
        handle._bury(self.world.steps)
        handle.destroy()

    def _handle(self) -> _core.Joint:
        if not isinstance(self._fields, _core.Joint):
            raise ArgumentError(f"{self!r} is not in a world yet; add it with world.add_joint")
        return self._fields

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return isinstance(other, Joint) and self.__ref() is not None and self.__ref() == other.__ref()

    def __hash__(self) -> int:
        return id(self)

    def __ref(self) -> _core.Joint | None:
        return self._fields if isinstance(self._fields, _core.Joint) else None

    def __repr__(self) -> str:
        if not isinstance(self._fields, _core.Joint):
            return f"<{type(self).__name__}, not in a world>"
        return f"<{type(self).__name__} {self._fields.slot}{'' if self.alive else ', destroyed'}>"

    # -- how the world builds and finds it again --

    @abstractmethod
    def _place(self, spec: _core.JointSpec) -> None:
        """Fill in what depends on where the bodies now are."""

    def _bind(self, world: World, handle: _core.Joint) -> None:
        self._world, self._fields = world, handle

    @classmethod
    def _adopt(cls, world: World, handle: _core.Joint) -> Joint:
        """The object for a joint that a restore brought into being."""
        joint = cls.__new__(cls)
        joint._a, joint._b = world._body(handle.body_a), world._body(handle.body_b)
        joint._broken = Callbacks(f"{cls.__name__}.on_break", "broken")
        joint._bind(world, handle)
        return joint


AnyJoint = TypeVar("AnyJoint", bound=Joint)


@dataclass(frozen=True, slots=True)
class BrokenJoint:
    """A joint that broke in the last step."""

    joint: Joint
    """The handle, stale from now on."""
    a: Body
    b: Body
    force: Vec2
    """Newtons on b in that step."""
    torque: float
    """Newton metres on b in that step."""


def enter(world: World, joint: AnyJoint) -> AnyJoint:
    """Put a joint into its world."""
    me = "World.add_joint"
    if not isinstance(joint, Joint):
        raise ArgumentTypeError(f"{me}: joint={joint!r} must be one of evil.joints, such as joints.Rope(a, b)")
    if not isinstance(joint._fields, _core.JointSpec):
        raise ArgumentError(f"{me}: {joint!r} was added before; make another")
    for name, body in (("a", joint._a), ("b", joint._b)):
        world._own_body(body, me, f"joint's {name}")
    joint._place(joint._fields)
    slot = _core.add_joint(world._core, joint._fields, joint._a, joint._b)
    joint._bind(world, _core.Joint(world._core, slot, _core.joint_generation(world._core, slot)))
    world._joints[slot] = joint
    return joint


def bury_joints(world: World) -> list[Joint]:
    """Those that have gone with a body, or broke: forget them, and let their handles know when."""
    gone = [joint for joint in tuple(world._joints.values()) if not joint.alive]
    for joint in gone:
        handle = joint._handle()
        handle._bury(world.steps)
        world._joints.pop(handle.slot, None)
    return gone


def joints_that_broke(world: World) -> tuple[BrokenJoint, ...]:
    """What broke in the step that has just been made."""
    rows = _core.broken_joints(world._core)
    if not rows and not world._broken_joints:
        return ()
    world._broken_joints = tuple(
        BrokenJoint(joint, world._body(a, ga), world._body(b, gb), force, torque)
        for slot, _, a, ga, b, gb, force, torque in rows
        if (joint := world._joints.get(slot)) is not None  # another thread may have been here since
    )
    bury_joints(world)
    return world._broken_joints


class Joints:
    """A world's joints in creation order, and those that broke in the last step."""

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def __len__(self) -> int:
        return _core.joint_count(self._world._core)

    def __iter__(self) -> Iterator[Joint]:
        slots, joints = _core.joint_slots(self._world._core), self._world._joints
        return iter([joints[slot] for slot in slots if slot in joints])

    def __contains__(self, joint: object) -> bool:
        return isinstance(joint, Joint) and joint._world is self._world and joint.alive

    @property
    def broken(self) -> tuple[BrokenJoint, ...]:
        """Those that broke in the last step, in the order in which they were added."""
        return self._world._broken_joints

    def __repr__(self) -> str:
        return f"<Joints, {len(self)}>"
