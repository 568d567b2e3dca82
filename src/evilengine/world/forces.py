"""Forces: generators that act on bodies before each substep (SPEC P2).

A force is made, then added: to a body (`body.add_force`), to several (`world.add_force(force, bodies)`) or to all
(`world.add_force(force)`). From then on it is the handle of what it added: its values can be read and changed, bodies
attached and detached, and `destroy()` ends it. Adding it again to another body of the same world shares it.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError, SnapshotError
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.world import World

GRAVITY, CONSTANT, SPRING, DRAG, MEDIUM, PULL, PYTHON = range(7)  # ForceKind in core/forces/forces.hpp


class Force:
    """Base of all forces. Subclass it and write `apply` to make your own, in Python, asked once a step.

    `apply(bodies, dt)` gets the bodies that it was added to (alive ones, in the order they were attached) and the
    step in seconds, and pushes them with `apply_force` and `apply_torque`. What it keeps in plain attributes (numbers,
    strings, lists of them) is saved with the world.

    >>> import evilengine as evil
    >>> class Wind(evil.Force):
    ...     def apply(self, bodies, dt):
    ...         for body in bodies:
    ...             body.apply_force((2, 0))
    >>> world = evil.World(gravity=(0, 0))
    >>> leaf = world.add(evil.Circle(0.5), mass=1)
    >>> wind = leaf.add_force(Wind())
    >>> world.step(0.5); round(leaf.velocity.x, 3)
    1.0
    """

    _world: World | None = None
    _ref: _core.Force | None = None
    _kind: ClassVar[int] = PYTHON

    def apply(self, bodies: Sequence[Body], dt: float) -> None:
        """Push the bodies; called once a step, before it begins."""
        raise ArgumentTypeError(f"{type(self).__name__}: write apply(self, bodies, dt) to say what it does")

    # -- its life as a handle --

    @property
    def alive(self) -> bool:
        """Is it at work in a world? False before it was added and after it was destroyed."""
        return self._ref is not None and self._ref.alive

    @property
    def world(self) -> World:
        """The world that it works in."""
        self._handle()
        assert self._world is not None
        return self._world

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The bodies that it acts on, in the order they were attached; all dynamic bodies if it acts everywhere."""
        handle = self._handle()
        if handle.everywhere:
            return tuple(body for body in self.world.bodies if body.kind == "dynamic")
        return tuple(self.world._body(slot) for slot in handle.body_slots)

    @known_keywords
    def attach(self, body: Body) -> None:
        """Let it act on one more body."""
        handle = self._handle()
        handle.attach(self.world._own_body(body, "Force.attach", "body"))

    @known_keywords
    def detach(self, body: Body) -> None:
        """Let it act on `body` no longer."""
        handle = self._handle()
        handle.detach(self.world._own_body(body, "Force.detach", "body"))

    def destroy(self) -> None:
        """End it. Any later use raises StaleReferenceError."""
        handle = self._handle()
        self.world._forget_force(self)
        handle._bury(self.world.steps)
        handle.destroy()

    def _handle(self) -> _core.Force:
        if self._ref is None:
            raise ArgumentError(f"{self!r} is not in a world yet; add it with body.add_force or world.add_force")
        return self._ref

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return isinstance(other, Force) and self._ref is not None and self._ref == other._ref

    def __hash__(self) -> int:
        return id(self)

    def __repr__(self) -> str:
        if self._ref is None:
            return f"<{type(self).__name__}, not in a world>"
        return f"<{type(self).__name__} {self._ref.slot}{'' if self.alive else ', destroyed'}>"

    # -- how the world builds and saves it --

    def _parameters(self, world: World) -> dict[str, Any]:
        """What the core's generator of this kind needs."""
        return {}

    def _bind(self, world: World, handle: _core.Force) -> None:
        self._world, self._ref = world, handle

    @classmethod
    def _adopt(cls, world: World, handle: _core.Force) -> Force:
        """The object for a force that a restore brought into being."""
        force = cls.__new__(cls)
        force._bind(world, handle)
        force._read_back(world, handle)
        return force

    def _read_back(self, world: World, handle: _core.Force) -> None:
        """Values that are fixed when the force is added, from the core."""

    def _note(self) -> str:
        """What a snapshot keeps of a Python force: which class, and its plain attributes."""
        state = {name: value for name, value in vars(self).items() if name not in ("_world", "_ref")}
        try:
            json.dumps(state, allow_nan=False)
        except (TypeError, ValueError) as problem:
            raise SnapshotError(
                f"{self!r} cannot be saved: its attributes must be numbers, strings, lists or dicts ({problem})"
            ) from None
        return json.dumps([type(self).__module__, type(self).__qualname__, state], sort_keys=True)

    def _restore_note(self, state: dict[str, Any]) -> None:
        for name in [name for name in vars(self) if name not in ("_world", "_ref") and name not in state]:
            delattr(self, name)
        vars(self).update(state)


class Value:
    """A number or point of a built-in force: kept here until it is added, in the core from then on."""

    def __init__(self, field: str, *, point: bool = False, least: float | None = None) -> None:
        self.field, self.point, self.least = field, point, least

    def __set_name__(self, owner: type, name: str) -> None:
        self.name, self.key = name, f"_{name}"

    def __get__(self, force: Force | None, owner: type) -> Any:
        if force is None:
            return self
        return getattr(force, self.key) if force._ref is None else getattr(force._ref, self.field)

    def __set__(self, force: Force, value: Any) -> None:
        owner = type(force).__name__
        checked = (
            to_vec2(value, owner, self.name)
            if self.point
            else number(value, owner, self.name, least=self.least, most=1e18)
        )
        setattr(force, self.key, checked)
        if force._ref is not None:
            setattr(force._ref, self.field, checked)


class Gravity(Force):
    """An acceleration (m/s2) that does not depend on mass, beside the world's own gravity.

    >>> Gravity((0, -1.6)).acceleration
    Vec2(0.0, -1.6)
    """

    _kind = GRAVITY
    acceleration = Value("vector", point=True)

    @known_keywords
    def __init__(self, acceleration: Point) -> None:
        self.acceleration = acceleration

    def _parameters(self, world: World) -> dict[str, Any]:
        return {"vector": self.acceleration}


class ConstantForce(Force):
    """The same push (newtons, world axes) all the time, on the centre of mass or on the point `at` of the body.

    >>> ConstantForce((3, 0)).force
    Vec2(3.0, 0.0)
    """

    _kind = CONSTANT
    force = Value("vector", point=True)

    @known_keywords
    def __init__(self, force: Point, *, at: Point | None = None) -> None:
        self.force = force
        self._at = None if at is None else to_vec2(at, "ConstantForce", "at")

    def _read_back(self, world: World, handle: _core.Force) -> None:
        self._at = handle.anchor if handle.at_anchor else None

    @property
    def at(self) -> Vec2 | None:
        """The point of the body that it pushes, in the body's frame; None is the centre of mass."""
        return self._at

    def _parameters(self, world: World) -> dict[str, Any]:
        return {"vector": self.force, "anchor": self._at or (0.0, 0.0), "at_anchor": self._at is not None}


class Spring(Force):
    """Hooke's law: pulls a body toward a point, or toward another body, by `stiffness` newtons for each metre beyond
    `rest_length`; `damping` (newton seconds a metre) takes speed along it away.

    `to` is a point of the world or a Body; `at` is the point of the attached body it is tied to, `to_at` that of the
    other body, each in the body's own frame. A body at the other end is pushed back with the same force.

    Raises ArgumentError for negative values.

    >>> Spring(to=(0, 8), stiffness=20, rest_length=1).stiffness
    20.0
    """

    _kind = SPRING
    stiffness = Value("stiffness", least=0.0)
    rest_length = Value("rest_length", least=0.0)
    damping = Value("damping", least=0.0)

    @known_keywords
    def __init__(
        self,
        to: Point | Body,
        *,
        stiffness: float = 10.0,
        rest_length: float = 0.0,
        damping: float = 0.0,
        at: Point = (0.0, 0.0),
        to_at: Point = (0.0, 0.0),
    ) -> None:
        self.stiffness, self.rest_length, self.damping = stiffness, rest_length, damping
        self._to: Vec2 | _core.Body = to if isinstance(to, _core.Body) else to_vec2(to, "Spring", "to")
        self._at = to_vec2(at, "Spring", "at")
        self._to_at = to_vec2(to_at, "Spring", "to_at")

    def _read_back(self, world: World, handle: _core.Force) -> None:
        self._at = handle.anchor
        if handle.target == _core.NO_SLOT:
            self._to, self._to_at = handle.vector, Vec2(0.0, 0.0)
        else:
            self._to, self._to_at = world._body(handle.target), handle.vector

    @property
    def to(self) -> Vec2 | Body:
        """Where it pulls to: a point of the world, which may be changed, or a Body."""
        if isinstance(self._to, _core.Body):
            return self._to  # type: ignore[return-value]
        return self._to if self._ref is None else self._ref.vector

    @to.setter
    def to(self, value: Point) -> None:
        if isinstance(self._to, _core.Body) or isinstance(value, _core.Body):
            raise ArgumentTypeError("Spring: to can only change from point to point; make another spring to tie bodies")
        self._to = to_vec2(value, "Spring", "to")
        if self._ref is not None:
            self._ref.vector = self._to

    def _parameters(self, world: World) -> dict[str, Any]:
        tied = isinstance(self._to, _core.Body)
        return {
            "vector": self._to_at if tied else self._to,
            "anchor": self._at,
            "target": world._own_body(self._to, "Spring", "to").slot if tied else _core.NO_SLOT,
            "stiffness": self.stiffness,
            "rest_length": self.rest_length,
            "damping": self.damping,
        }


class Drag(Force):
    """Resistance of what a body moves through: `linear` N s/m plus `quadratic` N s2/m2 times speed, times body.drag.

    >>> Drag(linear=0.5).quadratic
    0.0
    """

    _kind = DRAG
    linear = Value("linear", least=0.0)
    quadratic = Value("quadratic", least=0.0)

    @known_keywords
    def __init__(self, linear: float = 0.0, quadratic: float = 0.0) -> None:
        self.linear, self.quadratic = linear, quadratic

    def _parameters(self, world: World) -> dict[str, Any]:
        return {"linear": self.linear, "quadratic": self.quadratic}


class Pull(Force):
    """A finger's pull (SPEC I3): a critically damped spring from the centre of mass toward `to`, as strong as the mass
    needs but never more than `limit` m/s2, so that walls hold against it. It carries the body's weight while it acts.

    >>> Pull((1, 2)).to
    Vec2(1.0, 2.0)
    """

    _kind = PULL
    to = Value("vector", point=True)
    frequency = Value("stiffness", least=0.0)
    limit = Value("limit", least=0.0)

    @known_keywords
    def __init__(self, to: Point, *, frequency: float = 3.0, limit: float = 400.0) -> None:
        self.to, self.frequency, self.limit = to, frequency, limit

    def _parameters(self, world: World) -> dict[str, Any]:
        return {"vector": self.to, "stiffness": self.frequency, "limit": self.limit}
