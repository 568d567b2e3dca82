"""Other engines that the same scenes run in, for a ratio: `pip install 'evilengine[bench]'` brings them.

A peer is a mirror: it looks at a world of ours, which is never stepped, and makes the same bodies, shapes and materials
in its own engine, so that a scene is written once.
"""

from __future__ import annotations

import importlib
from abc import ABC, abstractmethod
from collections.abc import Iterable
from typing import Any

from evilengine.bench.scene import STEP, Scene, stage
from evilengine.values.vec2 import Vec2
from evilengine.world.body import Body, Shape
from evilengine.world.joints import Joint
from evilengine.world.shapes import Circle, PolygonLike, Rectangle

Placed = tuple[float, float, float]
"""Where a body is: x, y, angle."""


class Peer(ABC):
    """A scene in another engine. What each engine has to say is below the line."""

    name: str

    def __init__(self, scene: Scene, size: int, substeps: int = 4) -> None:
        self.shadow = stage(scene, size)
        self._substeps = substeps
        self._steps = 0
        self._bodies: dict[Body, Any] = {}
        self._joints: set[Joint] = set()
        self._kinematic: list[Body] = []
        self.open(self.shadow.world.gravity)
        self._mirror()

    def prepare(self) -> None:
        """Let the scene act on the shadow, and follow it."""
        if self.shadow.act is not None:
            self.shadow.act(self.shadow.world, self._steps)
            self._mirror()
            for body in self._kinematic:
                self.steer(self._bodies[body], body.velocity, body.angular_velocity)

    def step(self) -> None:
        self._steps += 1
        self.advance(STEP, self._substeps)

    def _mirror(self) -> None:
        there = set(self.shadow.world.bodies)
        for body in [body for body in self._bodies if body not in there]:
            self.remove(self._bodies.pop(body))
        for body in self.shadow.world.bodies:
            if body not in self._bodies:
                self._bodies[body] = self.add(body)
                if body.kind == "kinematic":
                    self._kinematic.append(body)
        self._joints = {joint for joint in self._joints if joint.alive}
        for joint in self.shadow.world.joints:
            if joint not in self._joints:
                self._joints.add(joint)
                self.join(joint, self._bodies[joint.a], self._bodies[joint.b])

    def placed(self) -> list[Placed]:
        """Where all bodies are, in the order in which the scene made them."""
        return [self.where(one) for one in self._bodies.values()]

    # -- what each engine says --

    @abstractmethod
    def open(self, gravity: Vec2) -> None:
        """Make an empty world."""

    @abstractmethod
    def add(self, body: Body) -> Any:
        """Make the same body."""

    @abstractmethod
    def remove(self, one: Any) -> None:
        """Take it away, with its joints."""

    @abstractmethod
    def join(self, joint: Joint, a: Any, b: Any) -> None:
        """Make the same joint between the two."""

    @abstractmethod
    def steer(self, one: Any, velocity: Vec2, spin: float) -> None:
        """Set the velocity of a kinematic body."""

    @abstractmethod
    def advance(self, dt: float, substeps: int) -> None:
        """Make a step."""

    @abstractmethod
    def where(self, one: Any) -> Placed:
        """Where the body is."""

    @abstractmethod
    def ray(self, start: Vec2, end: Vec2) -> bool:
        """Does the segment hit anything?"""

    def close(self) -> None:  # noqa: B027  (what holds nothing has nothing to let go of)
        """Let go of what the engine holds."""

    @staticmethod
    @abstractmethod
    def boxes(count: int) -> tuple[object, list[Any]]:
        """So many unit boxes, made the quickest way its users are shown: what holds them, and the bodies."""

    @staticmethod
    @abstractmethod
    def position(one: Any) -> object:
        """The way to a body's position."""


def corners_of(shape: Shape) -> list[tuple[float, float]]:
    """The corners of a polygon, in the body's frame."""
    assert isinstance(shape.definition, PolygonLike)
    return [shape.matrix @ corner for corner in shape.definition.corners]


def points_of(shape: Shape, points: Iterable[Vec2]) -> list[tuple[float, float]]:
    """Points of a shape, in the body's frame."""
    return [shape.matrix @ point for point in points]


def core_of(box: Rectangle) -> tuple[float, float]:
    """Half the sides of what is left of a rectangle when its rounding is taken off all round."""
    return 0.5 * box.width - box.rounding, 0.5 * box.height - box.rounding


def disc_of(shape: Shape) -> tuple[tuple[float, float], float]:
    """The centre in the body's frame and the radius."""
    assert isinstance(shape.definition, Circle)
    return shape.matrix @ Vec2(0, 0), shape.definition.radius


class CannotMakeError(Exception):
    """A scene has something that the bench has no way to make with this peer: the scene is timed without it."""

    def __init__(self, what: object, peer: str) -> None:
        super().__init__(f"{peer}: the bench has no way to make a {type(what).__name__} there")


PEERS = {"pyb2d3": "box2d", "pymunk": "chipmunk"}
"""The package of each, and our module that knows it."""


def found(names: Iterable[str] = tuple(PEERS)) -> tuple[list[type[Peer]], list[str]]:
    """The peers that are installed, and the names of those that are not."""
    here: list[type[Peer]] = []
    missing: list[str] = []
    for name in names:
        try:
            here.append(importlib.import_module(f"evilengine.bench.{PEERS[name]}").TheirWorld)
        except ImportError:
            missing.append(name)
    return here, missing
