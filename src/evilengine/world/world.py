"""World: simulation alone, without window, files or clock."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NoReturn, TypeVar

from evilengine import _core
from evilengine.values.checks import known_keywords, make_up, number, parts
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2, to_vec2
from evilengine.world import forces as force_kinds
from evilengine.world import saving, stepping
from evilengine.world.adding import MAX_SPIN, Recipes
from evilengine.world.arguments import listed, parts_of, place, speed
from evilengine.world.bodies import Bodies, BodyList, Numbers, Points
from evilengine.world.body import Body, Motion, Shape, to_tag
from evilengine.world.character import Cast
from evilengine.world.forces import Force
from evilengine.world.happenings import Happenings
from evilengine.world.joints import BrokenJoint, Joint, Joints
from evilengine.world.joints.joint import bury_joints, enter
from evilengine.world.queries import Queries
from evilengine.world.shapes import ShapeDefinition
from evilengine.world.stepping import StepInProgress
from evilengine.world.traits import Side
from evilengine.world.water import Fluids, Waters

MAX_STEP = 1.0
"""Seconds: the longest step. A longer one is a mistake in units."""

AnyForce = TypeVar("AnyForce", bound=Force)
AnyJoint = TypeVar("AnyJoint", bound=Joint)


class World(Queries, Happenings, Cast, Waters):
    """Bodies, forces and contacts, and the step that moves them.

    `gravity` in m/s2; `sleep` lets bodies that rest cost nothing; `threads` is how many threads a step may use (the
    result is the same for any number). Metres, seconds, kilograms, radians; y is up.

    >>> world = evil.World(gravity=(0, -10))
    >>> ball = world.add(evil.Circle(0.5), at=(0, 10))
    >>> for _ in range(60):
    ...     world.step(1 / 60)
    >>> 4.9 < ball.position.y < 5.1
    True
    """

    @known_keywords
    def __init__(self, gravity: Point = (0.0, -9.81), *, threads: int = 1, sleep: bool = True) -> None:
        self._core = _core.World()
        self._body_type: type[Body] = Body  # a Game's bodies know their drawings
        self._handles: dict[int, Body] = {}
        self._shape_handles: dict[int, Shape] = {}
        self._definitions: dict[int, ShapeDefinition] = {}  # by the slots of live shapes
        self._recipes = Recipes()
        self._forces: dict[int, Force] = {}
        self._joints: dict[int, Joint] = {}
        self._broken_joints: tuple[BrokenJoint, ...] = ()
        self._updated: list[Body] = []  # bodies with on_update
        self._motions: dict[int, tuple[Body, Motion]] = {}
        self._heard: set[str] = set()  # kinds of events that any body wants to be told
        self._step = StepInProgress()
        self.gravity = to_vec2(gravity, "World", "gravity")
        self.sleep = sleep
        self._core.threads = parts(threads, "World", "threads")

    # -- what it is --

    @property
    def gravity(self) -> Vec2:
        """Acceleration of all dynamic bodies, m/s2. Changing it wakes them."""
        return self._core.gravity

    @gravity.setter
    def gravity(self, value: Point) -> None:
        gravity = to_vec2(value, "World", "gravity")
        if gravity.length > 1e6:
            raise ArgumentError(f"World: gravity={value!r} must be at most 1e6 m/s2 strong")
        self._core.gravity = gravity

    @property
    def sleep(self) -> bool:
        """May bodies that rest fall asleep?"""
        return self._core.sleep

    @sleep.setter
    def sleep(self, value: bool) -> None:
        if not isinstance(value, bool):
            raise ArgumentTypeError(f"World: sleep={value!r} must be True or False")
        self._core.sleep = value

    @property
    def threads(self) -> int:
        """How many threads a step may use."""
        return self._core.threads

    @property
    def time(self) -> float:
        """Seconds simulated so far."""
        return self._core.time

    @property
    def steps(self) -> int:
        """Steps made so far."""
        return self._core.steps

    @property
    def bodies(self) -> Bodies:
        """All bodies, in creation order; and their positions, velocities, ... as arrays."""
        return Bodies(self)

    @property
    def forces(self) -> tuple[Force, ...]:
        """All forces, in the order of their slots."""
        return tuple(force for _, force in sorted(self._forces.items()))

    @property
    def joints(self) -> Joints:
        """All joints, in creation order; `.broken` are those that broke in the last step."""
        return Joints(self)

    # -- adding --

    @known_keywords
    def add(
        self,
        shape: ShapeDefinition | Iterable[ShapeDefinition],
        *,
        at: Point = (0.0, 0.0),
        angle: float = 0.0,
        kind: str = "dynamic",
        density: float = 1.0,
        mass: float | None = None,
        friction: float = 0.6,
        restitution: float = 0.0,
        velocity: Point = (0.0, 0.0),
        angular_velocity: float = 0.0,
        damping: float = 1.0,
        angular_damping: float = 1.0,
        drag: float = 1.0,
        gravity_scale: float = 1.0,
        bullet: bool = False,
        touchable: bool = False,
        category: int | None = None,
        mask: int | None = None,
        group: int | None = None,
        sensor: bool | None = None,
        one_way: Side = None,
        surface_speed: float | None = None,
        tag: str | None = None,
    ) -> Body:
        """Add a body made of `shape` (or of several shapes) with its origin `at`, and return its handle.

        `kind` is "dynamic", "kinematic" or "static". `density` is relative to water; `mass` (kg) overrides it.
        `damping` and `angular_damping` are the fractions of velocity kept per second, 1 for none lost. `restitution` is
        0 (no bounce) to 1. `touchable` bodies can be dragged by fingers and mouse. `category`, `mask` and `group` say
        whom it meets; a `sensor` sees and pushes nothing; `one_way` is the side from which a platform is solid (True:
        above); `surface_speed` (m/s) makes it a conveyor belt.

        Raises ArgumentError, ArgumentTypeError or ShapeError for what is not allowed; the world is then as before.

        >>> world = evil.World()
        >>> world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static").kind
        'static'
        """
        me = "World.add()"
        recipe = self._recipes.of(me, (
            kind, density, mass, friction, restitution, damping, angular_damping, drag, gravity_scale, bullet,
            touchable, category, mask, group, sensor, one_way, surface_speed,
        ))  # fmt: skip
        shapes, specs = parts_of(shape, me)
        made = self._core.add(recipe, specs, at, angle, velocity, angular_velocity, tag)
        if made is None:  # something is not plain: make it so, or say what it should have been
            turn = number(angle, me, "angle", least=-1e15, most=1e15)
            spin = number(angular_velocity, me, "angular_velocity", least=-MAX_SPIN, most=MAX_SPIN)
            made = self._core.add(recipe, specs, place(at, me), turn, speed(velocity, me), spin, to_tag(tag, me))
            assert made is not None
        slot, generation = made[0], made[1]
        self._definitions[made[2]] = shapes[0]
        for i in range(1, len(shapes)):
            self._definitions[made[i + 2]] = shapes[i]
        body = self._handles[slot] = self._body_type(self, slot, generation)
        return body

    @known_keywords
    def add_many(
        self,
        shape: ShapeDefinition | Iterable[ShapeDefinition],
        positions: Points,
        *,
        angles: Numbers | None = None,
        velocities: Points | None = None,
        angular_velocities: Numbers | None = None,
        kind: str = "dynamic",
        density: float = 1.0,
        mass: float | None = None,
        friction: float = 0.6,
        restitution: float = 0.0,
        damping: float = 1.0,
        angular_damping: float = 1.0,
        drag: float = 1.0,
        gravity_scale: float = 1.0,
        bullet: bool = False,
        touchable: bool = False,
        category: int | None = None,
        mask: int | None = None,
        group: int | None = None,
        sensor: bool | None = None,
        one_way: Side = None,
        surface_speed: float | None = None,
        tag: str | None = None,
    ) -> BodyList:
        """Add a body of the same shape at each of `positions`, and return them: as `add` one by one, and much faster.

        Arrays may be NumPy's, `array.array`, any other buffer of floats, or lists; `positions` and `velocities` have
        two columns. All bodies are added, or none: errors name the argument and the place in it.

        >>> world = evil.World()
        >>> boxes = world.add_many(evil.Rectangle(1, 1), [(2 * i, 0) for i in range(1000)], friction=0.3)
        >>> len(boxes), boxes[3].position
        (1000, Vec2(6.0, 0.0))
        """
        me = "World.add_many"
        recipe = self._recipes.of(me, (
            kind, density, mass, friction, restitution, damping, angular_damping, drag, gravity_scale, bullet,
            touchable, category, mask, group, sensor, one_way, surface_speed,
        ))  # fmt: skip
        shapes, specs = parts_of(shape, me)
        refs, slots = self._core.add_many(
            recipe, specs, positions, angles, velocities, angular_velocities, to_tag(tag, me)
        )
        for i, definition in enumerate(shapes):
            self._definitions.update(dict.fromkeys(slots[i :: len(shapes)], definition))
        return BodyList(self, refs)

    @known_keywords
    def add_force(self, force: AnyForce, bodies: Iterable[Body] | None = None) -> AnyForce:
        """Let one `force` act on `bodies`, or on every dynamic body when none are named; returns it (SPEC P2).

        A force that is already in this world is shared: the bodies are attached to it as well.

        >>> world = evil.World(gravity=(0, 0))
        >>> a, b = world.add(evil.Circle(1)), world.add(evil.Circle(1), at=(3, 0))
        >>> world.add_force(evil.Gravity((0, -2)), [a, b]).bodies == (a, b)
        True
        """
        if not isinstance(force, Force):
            raise ArgumentTypeError(
                f"World.add_force: force must be a Force such as Spring(...) or your own subclass; got {force!r}"
            )
        if type(force).apply is Force.apply and force._kind == force_kinds.PYTHON:
            raise ArgumentTypeError(
                f"World.add_force: {force!r} does nothing; write apply(self, bodies, dt) in its class"
            )
        me = "World.add_force"
        chosen = None if bodies is None else [self._own_body(body, me, "bodies") for body in listed(bodies)]
        if force._ref is None:
            self._enter(force, everywhere=chosen is None)
        elif force._world is not self:
            raise ArgumentError(f"World.add_force: {force!r} is in another world; make another for this one")
        for body in chosen or ():
            force._handle().attach(body)
        return force

    def _enter(self, force: Force, *, everywhere: bool) -> None:
        values: dict[str, Any] = {
            "vector": (0.0, 0.0), "anchor": (0.0, 0.0), "at_anchor": False, "target": _core.NO_SLOT, "stiffness": 0.0,
            "rest_length": 0.0, "damping": 0.0, "linear": 0.0, "quadratic": 0.0, "limit": 0.0, "density": 0.0,
            "area": None, "area_at": (0.0, 0.0), "area_angle": 0.0,
            "note": f"{type(force).__module__}.{type(force).__qualname__}",
        }  # fmt: skip
        values.update(force._parameters(self))
        slot = self._core.add_force(kind=force._kind, everywhere=everywhere, **values)
        force._bind(self, _core.Force(self._core, slot, self._core.force_generation(slot)))
        self._forces[slot] = force

    @known_keywords
    def add_joint(self, joint: AnyJoint) -> AnyJoint:
        """Tie two bodies by a joint of `evil.joints`, as they now stand; returns it (SPEC P8).

        >>> world = evil.World()
        >>> a, b = world.add(evil.Circle(1)), world.add(evil.Circle(1), at=(3, 0))
        >>> rod = world.add_joint(evil.joints.Distance(a, b))
        >>> list(world.joints) == [rod]
        True
        """
        return enter(self, joint)

    # -- stepping --

    @known_keywords
    def step(self, dt: float = 1.0 / 60.0, substeps: int = 4) -> None:
        """Move the world on by `dt` seconds (more than 0, at most 1), in `substeps` parts (1 to 256).

        More parts cost more time and hold more: heavy things on light ones, high towers, heavy balls on long chains.
        Behaviours and Python forces act first, then the core steps, then events are told, in creation order. An
        exception in a callback comes out of here with the world whole.

        Other threads run while the core steps a world of a hundred bodies or more; what they ask of this world waits
        until it is done, and a step from another thread raises ArgumentError.

        >>> world = evil.World(); world.step(); world.steps
        1
        """
        dt = number(dt, "World.step", "dt", above=0.0, most=MAX_STEP)
        substeps = parts(substeps, "World.step")
        with self._step:
            stepping.update(self, dt)
            stepping.move_followers(self, dt)
            stepping.ask_forces(self, dt)
            self._core.step(dt, substeps)
            stepping.tell_events(self)

    # -- asking --

    @known_keywords
    def find(self, tag: str) -> Body | None:
        """The first body, in creation order, with that tag, or None."""
        return next((body for body in self.bodies if body._tag == tag), None)

    # -- saving --

    def snapshot(self) -> bytes:
        """The whole state as bytes: exact, and the same on every machine.

        A world restored from it and continued equals one that never stopped, byte for byte. Functions (callbacks,
        motions) are not in it; forces written in Python are, with their plain attributes.

        >>> world = evil.World(); ball = world.add(evil.Circle(1))
        >>> data = world.snapshot(); world.step(); world.restore(data); world.snapshot() == data
        True
        """
        saving.note_python_forces(self)
        return self._core.snapshot()

    def checksum(self) -> int:
        """64 bits over the whole state; equal worlds have equal checksums, on every machine."""
        saving.note_python_forces(self)
        return self._core.checksum()

    @classmethod
    @known_keywords
    def of(cls, data: bytes) -> World:
        """A new world from a snapshot."""
        world = cls()
        world.restore(data)
        return world

    @known_keywords
    def restore(self, data: bytes) -> None:
        """Become what `snapshot` saw: all or nothing.

        Handles of objects that were there then and have not been destroyed since stay good. Those made after it, and
        those destroyed since, are stale, for ever: get fresh ones from `world.bodies` or `world.find(tag)`.
        Raises SnapshotError for bytes that are not a whole snapshot; the world is then as before.
        """
        if not isinstance(data, (bytes, bytearray, memoryview)):
            raise ArgumentTypeError(f"World.restore: data must be the bytes of a snapshot; got {type(data).__name__}")
        saved = _core.Saved(bytes(data))
        saving.check_notes(self, saved.notes)
        saving.become(self, saved)

    # -- handles --

    def _body(self, slot: int, generation: int | None = None) -> Body:
        """The one handle of the body in a slot; for a generation that is gone, a stale one."""
        handle = self._handles.get(slot)
        if handle is not None and handle.generation == (
            self._core.body_generation(slot) if generation is None else generation
        ):
            return handle
        current = self._core.body_generation(slot)
        handle = self._body_type(self, slot, current if generation is None else generation)
        if handle.alive:
            self._handles[slot] = handle
        return handle

    def _shape(self, slot: int, generation: int | None = None) -> Shape:
        handle = self._shape_handles.get(slot)
        current = self._core.shape_generation(slot)
        wanted = current if generation is None else generation
        if handle is not None and handle.generation == wanted:
            return handle
        if wanted != current:
            return Shape(self, slot, wanted)
        handle = self._shape_handles[slot] = Shape(self, slot, wanted, self._definitions.get(slot))
        return handle

    def _forget_shape(self, slot: int) -> Shape | None:
        """Before a shape goes: its handle, if it has one."""
        self._definitions.pop(slot, None)
        return self._shape_handles.pop(slot, None)

    def _own_body(self, body: object, owner: str, argument: str) -> Body:
        """`body` if it is a live body of this world, else an error."""
        if not isinstance(body, Body):
            raise ArgumentTypeError(f"{owner}: {argument} must be a Body, as world.add returns; got {body!r}")
        body._require()
        if body._world is not self:
            raise ArgumentError(f"{owner}: {argument}={body!r} is a body of another world")
        return body

    def _take_back(self, body: Body) -> None:
        """Undo the last add: the world is as if it had never been tried."""
        for slot in body._shape_slots():
            self._forget_shape(slot)
        self._handles.pop(body.slot, None)
        body._take_back()
        bury_joints(self)

    def _destroy_body(self, body: Body) -> None:
        for slot in body._shape_slots():
            shape = self._forget_shape(slot)
            if shape is not None:
                shape._bury(self.steps)
        (self._handles.get(body.slot) or body)._bury(self.steps)
        body._bury(self.steps)
        body._destroy()
        self._handles.pop(body.slot, None)
        self._motions.pop(body.slot, None)
        for slot, force in tuple(self._forces.items()):  # springs to it went with it
            if not force.alive:
                assert force._ref is not None
                force._ref._bury(self.steps)
                self._forces.pop(slot, None)
        bury_joints(self)

    def _destroy_shape(self, shape: Shape) -> None:
        _ = shape._body_slot  # raises StaleReferenceError
        self._forget_shape(shape.slot)
        shape._destroy()
        shape._bury(self.steps)

    def _forget_force(self, force: Force) -> None:
        self._forces.pop(force._handle().slot, None)

    def __reduce_ex__(self, protocol: object) -> NoReturn:
        raise ArgumentTypeError(
            "World: cannot be copied or pickled; World.of(world.snapshot()) is a second one like it"
        )

    def __repr__(self) -> str:
        return f"<World, {len(self.bodies)} bodies, step {self.steps}>"


make_up(World, Queries, Happenings, Cast, Fluids, Waters)
