"""EvilEngine's C++ core. Use evilengine, its public face."""

from collections.abc import Sequence
import enum
from typing import Any, Final, Never, overload

import evilengine.values.vec2
import evilengine.world.body


class View:
    """
    One of the world's arrays, a row for each slot: a read-only float32 buffer that is not copied, refreshed after each step. `numpy.asarray(view)` works; `view[slot]` gives one value.
    """

    def __len__(self) -> int: ...

    def __getitem__(self, arg: int, /) -> object: ...

class ShapeSpec:
    """
    A shape as the core takes it: checked, counter-clockwise, split into convex parts.
    """

    @staticmethod
    def circle(arg: float, /) -> ShapeSpec: ...

    @staticmethod
    def particle(arg: float, /) -> ShapeSpec: ...

    @staticmethod
    def polygon(corners: object, owner: str, rounding: float = 0.0, holes: object = ()) -> ShapeSpec: ...

    @staticmethod
    def line(a: object | None, b: object | None, radius: float, owner: str) -> ShapeSpec: ...

    @staticmethod
    def chain(arg0: object, arg1: bool, arg2: str, /) -> ShapeSpec: ...

    @property
    def corners(self) -> tuple[evilengine.values.vec2.Vec2, ...]: ...

    @property
    def holes(self) -> tuple[tuple[evilengine.values.vec2.Vec2, ...], ...]: ...

    @property
    def parts(self) -> tuple[tuple[evilengine.values.vec2.Vec2, ...], ...]: ...

    @property
    def drawn(self) -> tuple[tuple[evilengine.values.vec2.Vec2, ...], tuple[tuple[evilengine.values.vec2.Vec2, ...], ...]]: ...

    @property
    def area(self) -> float: ...

class Shape:
    """Reference to a shape on a body."""

    def __init__(self, world: World, slot: int, generation: int) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def category(self) -> int:
        """What it is, as bits of a number: 1 at first. See `mask`."""

    @category.setter
    def category(self, value: int, /) -> None: ...

    @property
    def mask(self) -> int:
        """
        What it meets, as bits: two meet if the category of each has a bit of the other's mask. evil.ALL at first.
        """

    @mask.setter
    def mask(self, value: int, /) -> None: ...

    @property
    def group(self) -> int:
        """
        Two in the same group, not 0, meet whatever the masks say if it is positive, and never if it is negative.
        """

    @group.setter
    def group(self, value: int, /) -> None: ...

    @property
    def sensor(self) -> bool:
        """
        A sensor sees what overlaps it (`world.sensors`, `body.on_enter`), and neither pushes nor is pushed.
        """

    @sensor.setter
    def sensor(self, value: bool, /) -> None: ...

    @property
    def one_way(self) -> evilengine.values.vec2.Vec2 | None:
        """
        The side from which it is solid, in the body's frame: what comes from there stands, what comes from elsewhere passes through. True means (0, 1), above; None, at first, solid from everywhere.
        """

    @one_way.setter
    def one_way(self, value: evilengine.values.vec2.Point | bool | None, /) -> None: ...

    @property
    def surface_speed(self) -> float:
        """
        Metres a second at which its surface runs round it, clockwise: on top to the right. Friction hands it on.
        """

    @surface_speed.setter
    def surface_speed(self, value: float, /) -> None: ...

    def _set_traits(self, arg: dict[str, Any], /) -> None: ...

    @property
    def friction(self) -> float:
        """Friction coefficient; a pair mixes its two as sqrt(a b)."""

    @friction.setter
    def friction(self, value: float, /) -> None: ...

    @property
    def restitution(self) -> float:
        """0: no bounce, 1: full; a pair takes the larger."""

    @restitution.setter
    def restitution(self, value: float, /) -> None: ...

    @property
    def density(self) -> float:
        """Relative to water, 1.0: kilograms a square metre."""

    @density.setter
    def density(self, value: float, /) -> None: ...

    @property
    def mass(self) -> float:
        """
        Kilograms that its density and area make; the body's mass unless that was set.
        """

    @property
    def _body_slot(self) -> int: ...

    @property
    def outline(self) -> tuple[Any, ...]:
        """
        In the body's frame: ('circle', centre, radius), ('polygon', corners, holes), ('rounded', corners of its core, radius, its holes), ('capsule', ends, radius), ('segment', ends), ('chain', points, loop) or ('particle', centre).
        """

    @property
    def _matrix(self) -> tuple[float, ...]: ...

    def _apply_matrix(self, matrix: object | None) -> None: ...

    def _destroy(self) -> None: ...

def check_traits(words: dict[str, Any], owner: str) -> None:
    """Raise what is wrong with any of them."""

def use(spec: ShapeSpec, offset: object, angle: float, density: float, friction: float, restitution: float) -> ShapeSpec:
    """A shape with the place and material of one use."""

class World:
    """The simulation's state and kernels."""

    def __init__(self) -> None: ...

    def step(self, dt: float, substeps: int) -> None: ...

    @property
    def gravity(self) -> evilengine.values.vec2.Vec2: ...

    @gravity.setter
    def gravity(self, arg: object, /) -> None: ...

    @property
    def sleep(self) -> bool: ...

    @sleep.setter
    def sleep(self, arg: bool, /) -> None: ...

    @property
    def instruction_set(self) -> str:
        """
        Which kernels it runs on. The bits are the same with any; tests compare them.
        """

    @instruction_set.setter
    def instruction_set(self, arg: str, /) -> None: ...

    @property
    def threads(self) -> int:
        """
        How many threads a step may use. The bits are the same with any number.
        """

    @threads.setter
    def threads(self, arg: int, /) -> None: ...

    @property
    def steps(self) -> int: ...

    @property
    def time(self) -> float: ...

    def add_shape(self, arg0: Body, arg1: ShapeSpec, /) -> int: ...

    def material(self, arg: int, /) -> tuple[float, ...]: ...

    def add_force(self, *, kind: int, everywhere: bool, vector: object, anchor: object, at_anchor: bool, target: int, stiffness: float, rest_length: float, damping: float, linear: float, quadratic: float, limit: float, density: float, area: ShapeSpec | None, area_at: object, area_angle: float, note: str) -> int: ...

    def body_slots(self) -> list[int]: ...

    def force_slots(self) -> list[int]: ...

    def body_generation(self, arg: int, /) -> int: ...

    def shape_generation(self, arg: int, /) -> int: ...

    def force_generation(self, arg: int, /) -> int: ...

    @property
    def body_count(self) -> int: ...

    def add(self, recipe: Recipe, shapes: Sequence[ShapeSpec], at: object | None, angle: object | None, velocity: object | None, spin: object | None, tag: object | None) -> list[int] | None:
        """
        The new body's slot and generation, and its shapes' slots; None where an argument is not plain.
        """

    def add_many(self, recipe: Recipe, shapes: Sequence[ShapeSpec], positions: object | None, angles: object | None, velocities: object | None, spins: object | None, tag: str) -> tuple[BodyRefs, list[int]]: ...

    def set_positions(self, values: object | None, indices: object | None) -> None: ...

    def set_angles(self, values: object | None, indices: object | None) -> None: ...

    def set_velocities(self, values: object | None, indices: object | None) -> None: ...

    def set_spins(self, values: object | None, indices: object | None) -> None: ...

    def apply_forces(self, values: object | None, indices: object | None, points: object | None) -> None: ...

    def apply_impulses(self, values: object | None, indices: object | None, points: object | None) -> None: ...

    @property
    def begun(self) -> Touches: ...

    @property
    def ended(self) -> Touches: ...

    @property
    def hit(self) -> Touches: ...

    @property
    def active(self) -> Touches: ...

    @property
    def entered(self) -> Touches: ...

    @property
    def left(self) -> Touches: ...

    @property
    def inside(self) -> Touches: ...

    @property
    def slept(self) -> list[tuple[int, int]]: ...

    @property
    def woke(self) -> list[tuple[int, int]]: ...

    @property
    def hit_speed(self) -> float: ...

    @hit_speed.setter
    def hit_speed(self, arg: float, /) -> None: ...

    @property
    def positions(self) -> View: ...

    @property
    def angles(self) -> View: ...

    @property
    def velocities(self) -> View: ...

    @property
    def matrices(self) -> View: ...

    def ray_cast(self, owner: object, start: object, end: object, kinds: int, mask: int, ignored: tuple[int, ...]) -> RayHit | None: ...

    def ray_cast_all(self, owner: object, start: object, end: object, kinds: int, mask: int, ignored: tuple[int, ...]) -> tuple[RayHit, ...]: ...

    def ray_casts(self, owner: object, starts: object | None, ends: object | None, kinds: int, mask: int, ignored: object) -> RayHits: ...

    def shape_cast(self, owner: object, shape: ShapeSpec, start: object, end: object, angle: float, kinds: int, mask: int, ignored: tuple[int, ...]) -> RayHit | None: ...

    def shape_cast_all(self, owner: object, shape: ShapeSpec, start: object, end: object, angle: float, kinds: int, mask: int, ignored: tuple[int, ...]) -> tuple[RayHit, ...]: ...

    def shape_casts(self, owner: object, shape: ShapeSpec, starts: object | None, ends: object | None, angle: object | None, kinds: int, mask: int, ignored: object) -> RayHits: ...

    def nearest(self, owner: object, point: object, within: float, kinds: int, mask: int, ignored: tuple[int, ...]) -> Nearest | None: ...

    def nearest_each(self, owner: object, points: object | None, within: float, kinds: int, mask: int, ignored: object) -> Nearests: ...

    def bodies_at(self, point: object | None, kinds: int, mask: int, ignored: object) -> list[int]: ...

    def bodies_at_each(self, owner: object, points: object | None, kinds: int, mask: int, ignored: object) -> BodyLists: ...

    def overlapping(self, shape: ShapeSpec, at: object | None, angle: float, kinds: int, mask: int, ignored: object) -> list[int]: ...

    def overlapping_each(self, owner: object, shape: ShapeSpec, at: object | None, angle: object | None, kinds: int, mask: int, ignored: object) -> BodyLists: ...

    def snapshot(self) -> bytes: ...

    def restore(self, arg: Saved, /) -> tuple[list[int], list[int]]: ...

    def checksum(self) -> int: ...

    def sums(self) -> tuple[int, int, int]: ...

class Recipe:
    """What new bodies shall be, wherever they are. The face has checked it."""

    def __init__(self, *, kind: int, density: float, mass: float, friction: float, restitution: float, damping: float, angular_damping: float, drag: float, gravity_scale: float, bullet: bool, touchable: bool, traits: dict[str, Any] | None = None, owner: str = 'World.add()') -> None: ...

def identical(a: tuple[Any, ...], b: tuple[Any, ...]) -> bool:
    """The same objects in the same order?"""

class BodyRefs:
    """References to many bodies; a buffer of slots."""

    def __len__(self) -> int: ...

    def __getitem__(self, arg: int, /) -> tuple[int, int]: ...

class Touches:
    """Touches of a step, in the order that is promised."""

    def __len__(self) -> int: ...

    def row(self, number: int) -> tuple[Any, ...]: ...

    @property
    def bodies(self) -> memoryview: ...

    @property
    def shapes(self) -> memoryview: ...

    @property
    def points(self) -> memoryview: ...

    @property
    def normals(self) -> memoryview: ...

    @property
    def depths(self) -> memoryview: ...

    @property
    def impulses(self) -> memoryview: ...

    @property
    def speeds(self) -> memoryview: ...

class RayHit:
    """Where a ray, or a shape that is moved, meets a shape."""

    @property
    def body(self) -> evilengine.world.body.Body:
        """Whose shape it is."""

    @property
    def shape(self) -> evilengine.world.body.Shape:
        """Which of its shapes."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    @property
    def point(self) -> evilengine.values.vec2.Vec2:
        """Where, in the world."""

    @property
    def normal(self) -> evilengine.values.vec2.Vec2:
        """Direction of length 1 out of the shape."""

    @property
    def fraction(self) -> float:
        """How far along the way, 0 at its start, 1 at its end."""

    def __repr__(self) -> str: ...

class Nearest:
    """The shape that is nearest to a point."""

    @property
    def body(self) -> evilengine.world.body.Body:
        """Whose shape it is."""

    @property
    def shape(self) -> evilengine.world.body.Shape:
        """Which of its shapes."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    @property
    def point(self) -> evilengine.values.vec2.Vec2:
        """The point of the shape that is nearest."""

    @property
    def distance(self) -> float:
        """Metres; 0 when the shape covers the point."""

    def __repr__(self) -> str: ...

class RayHits:
    """
    What many rays, or shapes that are moved, met: columns with a row for each. `hits[i]` is its RayHit or None; `numpy.asarray(hits.points)` needs no copy.
    """

    def __len__(self) -> int: ...

    def __getitem__(self, arg: int, /) -> object: ...

    @property
    def bodies(self) -> memoryview:
        """
        (n,) int32: slots of the bodies, as in the rows of world.bodies.positions; -1 where there is none.
        """

    @property
    def shapes(self) -> memoryview:
        """(n,) int32: slots of the shapes; -1 where there is none."""

    @property
    def points(self) -> memoryview:
        """(n, 2) float32: where in the world."""

    @property
    def normals(self) -> memoryview:
        """(n, 2) float32: out of the shape; zeros where nothing was met."""

    @property
    def fractions(self) -> memoryview:
        """(n,) float32: how far along the way; 1 where nothing was met."""

class Nearests:
    """
    What is nearest to many points: columns with a row for each. `found[i]` is its Nearest or None.
    """

    def __len__(self) -> int: ...

    def __getitem__(self, arg: int, /) -> object: ...

    @property
    def bodies(self) -> memoryview:
        """
        (n,) int32: slots of the bodies, as in the rows of world.bodies.positions; -1 where there is none.
        """

    @property
    def shapes(self) -> memoryview:
        """(n,) int32: slots of the shapes; -1 where there is none."""

    @property
    def points(self) -> memoryview:
        """(n, 2) float32: where in the world."""

    @property
    def distances(self) -> memoryview:
        """(n,) float32: metres; infinite where nothing is near enough."""

class BodyLists:
    """
    The bodies that many questions found: `found[i]` is the tuple of bodies of question i. As arrays: its bodies' slots are `bodies[starts[i]:starts[i + 1]]`.
    """

    def __len__(self) -> int: ...

    def __getitem__(self, index: int, /) -> tuple[evilengine.world.body.Body, ...]: ...

    @property
    def bodies(self) -> memoryview:
        """uint32: slots of all bodies found."""

    @property
    def starts(self) -> memoryview:
        """(n + 1,) uint32: where each question's begin."""

class Saved:
    """A snapshot that was read and found whole."""

    def __init__(self, arg: bytes, /) -> None: ...

    @property
    def notes(self) -> list[str]: ...

    @property
    def slots(self) -> tuple[list[int], list[int], list[int], list[int], list[int], list[int], list[int], list[int], list[int]]: ...

    @property
    def shape_bodies(self) -> list[int]:
        """Of each of the shapes in `slots`, the slot of the body that it is on."""

class Body:
    """Reference to a body of a world."""

    def __init__(self, world: World, slot: int, generation: int) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def position(self) -> evilengine.values.vec2.Vec2:
        """
        Where the body's origin is, the point that its shapes are placed by (metres). Writing it moves the body at once.
        """

    @position.setter
    def position(self, value: evilengine.values.vec2.Point, /) -> None: ...

    @property
    def angle(self) -> float:
        """Radians, counter-clockwise; it is not wrapped, so two turns are 4 pi."""

    @angle.setter
    def angle(self, value: float, /) -> None: ...

    @property
    def velocity(self) -> evilengine.values.vec2.Vec2:
        """Of the centre of mass, metres a second."""

    @velocity.setter
    def velocity(self, value: evilengine.values.vec2.Point, /) -> None: ...

    @property
    def angular_velocity(self) -> float:
        """Radians a second."""

    @angular_velocity.setter
    def angular_velocity(self, value: float, /) -> None: ...

    @property
    def centre(self) -> evilengine.values.vec2.Vec2:
        """The centre of mass, in the world."""

    @overload
    def velocity_at(self, point: evilengine.values.vec2.Point) -> evilengine.values.vec2.Vec2:
        """Velocity of the body's matter at a point of the world."""

    @overload
    def velocity_at(self, *args: Never, **words: Never) -> Never: ...

    @overload
    def to_world(self, point: evilengine.values.vec2.Point) -> evilengine.values.vec2.Vec2:
        """A point of the body's own frame, in the world."""

    @overload
    def to_world(self, *args: Never, **words: Never) -> Never: ...

    @overload
    def to_local(self, point: evilengine.values.vec2.Point) -> evilengine.values.vec2.Vec2:
        """A point of the world, in the body's own frame."""

    @overload
    def to_local(self, *args: Never, **words: Never) -> Never: ...

    @overload
    def apply_force(self, force: evilengine.values.vec2.Point, at: evilengine.values.vec2.Point | None = None) -> None:
        """
        Push with `force` (newtons) during the next step, at a point of the world; at the centre of mass without one.
        """

    @overload
    def apply_force(self, *args: Never, **words: Never) -> Never: ...

    @overload
    def apply_impulse(self, impulse: evilengine.values.vec2.Point, at: evilengine.values.vec2.Point | None = None) -> None:
        """
        Change the velocity at once by an impulse (newton seconds), at a point of the world or the centre of mass.
        """

    @overload
    def apply_impulse(self, *args: Never, **words: Never) -> Never: ...

    @overload
    def apply_torque(self, torque: float) -> None:
        """Turn with `torque` (newton metres) during the next step."""

    @overload
    def apply_torque(self, *args: Never, **words: Never) -> Never: ...

    @overload
    def apply_angular_impulse(self, impulse: float) -> None:
        """Change the spin at once (kg m2/s)."""

    @overload
    def apply_angular_impulse(self, *args: Never, **words: Never) -> Never: ...

    @property
    def force(self) -> evilengine.values.vec2.Vec2:
        """Gathered by apply_force since the last step."""

    @property
    def torque(self) -> float:
        """Gathered by apply_force and apply_torque since the last step."""

    @property
    def acceleration(self) -> evilengine.values.vec2.Vec2:
        """
        What gravity and forces gave it in the last step, contacts left out (m/s2).
        """

    @property
    def mass(self) -> float:
        """
        Kilograms; infinite for a static or kinematic body. Writing it scales the inertia along.
        """

    @mass.setter
    def mass(self, value: float, /) -> None: ...

    @property
    def inertia(self) -> float:
        """
        About the centre of mass, kg m2; infinite for a static or kinematic body.
        """

    @property
    def inverse_mass(self) -> float:
        """1 / mass; 0: nothing moves it."""

    @property
    def inverse_inertia(self) -> float:
        """1 / inertia; 0: nothing turns it."""

    @property
    def damping(self) -> float:
        """Fraction of velocity kept per second; 1: none is lost."""

    @damping.setter
    def damping(self, value: float, /) -> None: ...

    @property
    def angular_damping(self) -> float:
        """Fraction of spin kept per second; 1: none is lost."""

    @angular_damping.setter
    def angular_damping(self, value: float, /) -> None: ...

    @property
    def drag(self) -> float:
        """How strongly drag and media act on it; 1 as they are, 0 not at all."""

    @drag.setter
    def drag(self, value: float, /) -> None: ...

    @property
    def gravity_scale(self) -> float:
        """How strongly the world's gravity acts on it."""

    @gravity_scale.setter
    def gravity_scale(self, value: float, /) -> None: ...

    @property
    def friction(self) -> float:
        """Of all its shapes; pairs mix as sqrt(a b)."""

    @friction.setter
    def friction(self, value: float, /) -> None: ...

    @property
    def restitution(self) -> float:
        """Of all its shapes; pairs take the larger."""

    @restitution.setter
    def restitution(self, value: float, /) -> None: ...

    @property
    def _kind(self) -> int: ...

    @_kind.setter
    def _kind(self, arg: int, /) -> None: ...

    @property
    def bullet(self) -> bool:
        """Marked as fast and thin, for continuous collision."""

    @bullet.setter
    def bullet(self, value: bool, /) -> None: ...

    @property
    def touchable(self) -> bool:
        """Fingers and the mouse can hold it."""

    @touchable.setter
    def touchable(self, value: bool, /) -> None: ...

    @property
    def awake(self) -> bool:
        """
        False while it rests and costs nothing. A touch, a push or a change wakes it.
        """

    @awake.setter
    def awake(self, value: bool, /) -> None: ...

    @property
    def _tag(self) -> str: ...

    @_tag.setter
    def _tag(self, arg: str, /) -> None: ...

    @property
    def scale(self) -> evilengine.values.vec2.Vec2:
        """
        (x, y) that all its shapes are stretched by; mass follows unless it was set.
        """

    @scale.setter
    def scale(self, value: evilengine.values.vec2.Point, /) -> None: ...

    @property
    def _matrix(self) -> tuple[float, ...]: ...

    def _apply_matrix(self, matrix: object | None) -> None: ...

    def _shape_slots(self) -> list[int]: ...

    def _destroy(self) -> None: ...

    def _take_back(self) -> None: ...

    @property
    def category(self) -> int:
        """What it is, as bits of a number: 1 at first. See `mask`."""

    @category.setter
    def category(self, value: int, /) -> None: ...

    @property
    def mask(self) -> int:
        """
        What it meets, as bits: two meet if the category of each has a bit of the other's mask. evil.ALL at first.
        """

    @mask.setter
    def mask(self, value: int, /) -> None: ...

    @property
    def group(self) -> int:
        """
        Two in the same group, not 0, meet whatever the masks say if it is positive, and never if it is negative.
        """

    @group.setter
    def group(self, value: int, /) -> None: ...

    @property
    def sensor(self) -> bool:
        """
        A sensor sees what overlaps it (`world.sensors`, `body.on_enter`), and neither pushes nor is pushed.
        """

    @sensor.setter
    def sensor(self, value: bool, /) -> None: ...

    @property
    def one_way(self) -> evilengine.values.vec2.Vec2 | None:
        """
        The side from which it is solid, in the body's frame: what comes from there stands, what comes from elsewhere passes through. True means (0, 1), above; None, at first, solid from everywhere.
        """

    @one_way.setter
    def one_way(self, value: evilengine.values.vec2.Point | bool | None, /) -> None: ...

    @property
    def surface_speed(self) -> float:
        """
        Metres a second at which its surface runs round it, clockwise: on top to the right. Friction hands it on.
        """

    @surface_speed.setter
    def surface_speed(self, value: float, /) -> None: ...

NO_SLOT: int = 4294967295

class Force:
    """Reference to a force of a world."""

    def __init__(self, world: World, slot: int, generation: int) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def vector(self) -> evilengine.values.vec2.Vec2: ...

    @vector.setter
    def vector(self, arg: object, /) -> None: ...

    @property
    def anchor(self) -> evilengine.values.vec2.Vec2: ...

    @anchor.setter
    def anchor(self, arg: object, /) -> None: ...

    @property
    def stiffness(self) -> float: ...

    @stiffness.setter
    def stiffness(self, arg: float, /) -> None: ...

    @property
    def rest_length(self) -> float: ...

    @rest_length.setter
    def rest_length(self, arg: float, /) -> None: ...

    @property
    def damping(self) -> float: ...

    @damping.setter
    def damping(self, arg: float, /) -> None: ...

    @property
    def linear(self) -> float: ...

    @linear.setter
    def linear(self, arg: float, /) -> None: ...

    @property
    def quadratic(self) -> float: ...

    @quadratic.setter
    def quadratic(self, arg: float, /) -> None: ...

    @property
    def limit(self) -> float: ...

    @limit.setter
    def limit(self, arg: float, /) -> None: ...

    @property
    def density(self) -> float: ...

    @density.setter
    def density(self, arg: float, /) -> None: ...

    @property
    def area(self) -> tuple[Any, ...]: ...

    def set_area(self, arg0: ShapeSpec, arg1: object, arg2: float, /) -> None: ...

    @property
    def note(self) -> str: ...

    @note.setter
    def note(self, arg: str, /) -> None: ...

    @property
    def at_anchor(self) -> bool: ...

    @property
    def everywhere(self) -> bool: ...

    @property
    def kind(self) -> int: ...

    @property
    def target(self) -> int: ...

    @property
    def body_slots(self) -> list[int]: ...

    def attach(self, arg: Body, /) -> None: ...

    def detach(self, arg: Body, /) -> None: ...

    def destroy(self) -> None: ...

class JointSpec:
    """What a new joint shall be."""

    def __init__(self, kind: int, collide: bool) -> None: ...

    @property
    def anchor_a(self) -> evilengine.values.vec2.Vec2: ...

    @anchor_a.setter
    def anchor_a(self, arg: object, /) -> None: ...

    @property
    def anchor_b(self) -> evilengine.values.vec2.Vec2: ...

    @anchor_b.setter
    def anchor_b(self, arg: object, /) -> None: ...

    @property
    def axis(self) -> evilengine.values.vec2.Vec2: ...

    @axis.setter
    def axis(self, arg: object, /) -> None: ...

    @property
    def over_a(self) -> evilengine.values.vec2.Vec2: ...

    @over_a.setter
    def over_a(self, arg: object, /) -> None: ...

    @property
    def over_b(self) -> evilengine.values.vec2.Vec2: ...

    @over_b.setter
    def over_b(self, arg: object, /) -> None: ...

    @property
    def reference(self) -> float: ...

    @reference.setter
    def reference(self, arg: float, /) -> None: ...

    @property
    def ratio(self) -> float: ...

    @ratio.setter
    def ratio(self, arg: float, /) -> None: ...

    @property
    def breaking_force(self) -> float: ...

    @breaking_force.setter
    def breaking_force(self, arg: float, /) -> None: ...

    @property
    def breaking_torque(self) -> float: ...

    @breaking_torque.setter
    def breaking_torque(self, arg: float, /) -> None: ...

    @property
    def along_held(self) -> bool: ...

    @along_held.setter
    def along_held(self, arg: bool, /) -> None: ...

    @property
    def along_limited(self) -> bool: ...

    @along_limited.setter
    def along_limited(self, arg: bool, /) -> None: ...

    @property
    def along_motor(self) -> bool: ...

    @along_motor.setter
    def along_motor(self, arg: bool, /) -> None: ...

    @property
    def along_rest(self) -> float: ...

    @along_rest.setter
    def along_rest(self, arg: float, /) -> None: ...

    @property
    def along_lower(self) -> float: ...

    @along_lower.setter
    def along_lower(self, arg: float, /) -> None: ...

    @property
    def along_upper(self) -> float: ...

    @along_upper.setter
    def along_upper(self, arg: float, /) -> None: ...

    @property
    def along_speed(self) -> float: ...

    @along_speed.setter
    def along_speed(self, arg: float, /) -> None: ...

    @property
    def along_most(self) -> float: ...

    @along_most.setter
    def along_most(self, arg: float, /) -> None: ...

    @property
    def along_frequency(self) -> float: ...

    @along_frequency.setter
    def along_frequency(self, arg: float, /) -> None: ...

    @property
    def along_damping_ratio(self) -> float: ...

    @along_damping_ratio.setter
    def along_damping_ratio(self, arg: float, /) -> None: ...

    @property
    def along_stiffness(self) -> float: ...

    @along_stiffness.setter
    def along_stiffness(self, arg: float, /) -> None: ...

    @property
    def along_damping(self) -> float: ...

    @along_damping.setter
    def along_damping(self, arg: float, /) -> None: ...

    @property
    def along_spring_most(self) -> float: ...

    @along_spring_most.setter
    def along_spring_most(self, arg: float, /) -> None: ...

    @property
    def turn_held(self) -> bool: ...

    @turn_held.setter
    def turn_held(self, arg: bool, /) -> None: ...

    @property
    def turn_limited(self) -> bool: ...

    @turn_limited.setter
    def turn_limited(self, arg: bool, /) -> None: ...

    @property
    def turn_motor(self) -> bool: ...

    @turn_motor.setter
    def turn_motor(self, arg: bool, /) -> None: ...

    @property
    def turn_rest(self) -> float: ...

    @turn_rest.setter
    def turn_rest(self, arg: float, /) -> None: ...

    @property
    def turn_lower(self) -> float: ...

    @turn_lower.setter
    def turn_lower(self, arg: float, /) -> None: ...

    @property
    def turn_upper(self) -> float: ...

    @turn_upper.setter
    def turn_upper(self, arg: float, /) -> None: ...

    @property
    def turn_speed(self) -> float: ...

    @turn_speed.setter
    def turn_speed(self, arg: float, /) -> None: ...

    @property
    def turn_most(self) -> float: ...

    @turn_most.setter
    def turn_most(self, arg: float, /) -> None: ...

    @property
    def turn_frequency(self) -> float: ...

    @turn_frequency.setter
    def turn_frequency(self, arg: float, /) -> None: ...

    @property
    def turn_damping_ratio(self) -> float: ...

    @turn_damping_ratio.setter
    def turn_damping_ratio(self, arg: float, /) -> None: ...

    @property
    def turn_stiffness(self) -> float: ...

    @turn_stiffness.setter
    def turn_stiffness(self, arg: float, /) -> None: ...

    @property
    def turn_damping(self) -> float: ...

    @turn_damping.setter
    def turn_damping(self, arg: float, /) -> None: ...

    @property
    def turn_spring_most(self) -> float: ...

    @turn_spring_most.setter
    def turn_spring_most(self, arg: float, /) -> None: ...

class Joint:
    """Reference to a joint of a world."""

    def __init__(self, world: World, slot: int, generation: int) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def anchor_a(self) -> evilengine.values.vec2.Vec2: ...

    @anchor_a.setter
    def anchor_a(self, arg: object, /) -> None: ...

    @property
    def anchor_b(self) -> evilengine.values.vec2.Vec2: ...

    @anchor_b.setter
    def anchor_b(self, arg: object, /) -> None: ...

    @property
    def axis(self) -> evilengine.values.vec2.Vec2: ...

    @axis.setter
    def axis(self, arg: object, /) -> None: ...

    @property
    def over_a(self) -> evilengine.values.vec2.Vec2: ...

    @over_a.setter
    def over_a(self, arg: object, /) -> None: ...

    @property
    def over_b(self) -> evilengine.values.vec2.Vec2: ...

    @over_b.setter
    def over_b(self, arg: object, /) -> None: ...

    @property
    def reference(self) -> float: ...

    @reference.setter
    def reference(self, arg: float, /) -> None: ...

    @property
    def ratio(self) -> float: ...

    @ratio.setter
    def ratio(self, arg: float, /) -> None: ...

    @property
    def breaking_force(self) -> float: ...

    @breaking_force.setter
    def breaking_force(self, arg: float, /) -> None: ...

    @property
    def breaking_torque(self) -> float: ...

    @breaking_torque.setter
    def breaking_torque(self, arg: float, /) -> None: ...

    @property
    def along_held(self) -> bool: ...

    @along_held.setter
    def along_held(self, arg: bool, /) -> None: ...

    @property
    def along_limited(self) -> bool: ...

    @along_limited.setter
    def along_limited(self, arg: bool, /) -> None: ...

    @property
    def along_motor(self) -> bool: ...

    @along_motor.setter
    def along_motor(self, arg: bool, /) -> None: ...

    @property
    def along_rest(self) -> float: ...

    @along_rest.setter
    def along_rest(self, arg: float, /) -> None: ...

    @property
    def along_lower(self) -> float: ...

    @along_lower.setter
    def along_lower(self, arg: float, /) -> None: ...

    @property
    def along_upper(self) -> float: ...

    @along_upper.setter
    def along_upper(self, arg: float, /) -> None: ...

    @property
    def along_speed(self) -> float: ...

    @along_speed.setter
    def along_speed(self, arg: float, /) -> None: ...

    @property
    def along_most(self) -> float: ...

    @along_most.setter
    def along_most(self, arg: float, /) -> None: ...

    @property
    def along_frequency(self) -> float: ...

    @along_frequency.setter
    def along_frequency(self, arg: float, /) -> None: ...

    @property
    def along_damping_ratio(self) -> float: ...

    @along_damping_ratio.setter
    def along_damping_ratio(self, arg: float, /) -> None: ...

    @property
    def along_stiffness(self) -> float: ...

    @along_stiffness.setter
    def along_stiffness(self, arg: float, /) -> None: ...

    @property
    def along_damping(self) -> float: ...

    @along_damping.setter
    def along_damping(self, arg: float, /) -> None: ...

    @property
    def along_spring_most(self) -> float: ...

    @along_spring_most.setter
    def along_spring_most(self, arg: float, /) -> None: ...

    @property
    def turn_held(self) -> bool: ...

    @turn_held.setter
    def turn_held(self, arg: bool, /) -> None: ...

    @property
    def turn_limited(self) -> bool: ...

    @turn_limited.setter
    def turn_limited(self, arg: bool, /) -> None: ...

    @property
    def turn_motor(self) -> bool: ...

    @turn_motor.setter
    def turn_motor(self, arg: bool, /) -> None: ...

    @property
    def turn_rest(self) -> float: ...

    @turn_rest.setter
    def turn_rest(self, arg: float, /) -> None: ...

    @property
    def turn_lower(self) -> float: ...

    @turn_lower.setter
    def turn_lower(self, arg: float, /) -> None: ...

    @property
    def turn_upper(self) -> float: ...

    @turn_upper.setter
    def turn_upper(self, arg: float, /) -> None: ...

    @property
    def turn_speed(self) -> float: ...

    @turn_speed.setter
    def turn_speed(self, arg: float, /) -> None: ...

    @property
    def turn_most(self) -> float: ...

    @turn_most.setter
    def turn_most(self, arg: float, /) -> None: ...

    @property
    def turn_frequency(self) -> float: ...

    @turn_frequency.setter
    def turn_frequency(self, arg: float, /) -> None: ...

    @property
    def turn_damping_ratio(self) -> float: ...

    @turn_damping_ratio.setter
    def turn_damping_ratio(self, arg: float, /) -> None: ...

    @property
    def turn_stiffness(self) -> float: ...

    @turn_stiffness.setter
    def turn_stiffness(self, arg: float, /) -> None: ...

    @property
    def turn_damping(self) -> float: ...

    @turn_damping.setter
    def turn_damping(self, arg: float, /) -> None: ...

    @property
    def turn_spring_most(self) -> float: ...

    @turn_spring_most.setter
    def turn_spring_most(self, arg: float, /) -> None: ...

    @property
    def kind(self) -> int: ...

    @property
    def collide(self) -> bool: ...

    @property
    def body_a(self) -> int: ...

    @property
    def body_b(self) -> int: ...

    @property
    def force(self) -> evilengine.values.vec2.Vec2: ...

    @property
    def torque(self) -> float: ...

    @property
    def at_a(self) -> evilengine.values.vec2.Vec2: ...

    @property
    def at_b(self) -> evilengine.values.vec2.Vec2: ...

    @property
    def angle(self) -> float: ...

    @property
    def turning(self) -> float: ...

    @property
    def length(self) -> float: ...

    @property
    def lengthening(self) -> float: ...

    def destroy(self) -> None: ...

def add_joint(world: World, spec: JointSpec, a: Body, b: Body) -> int: ...

def joint_slots(world: World) -> list[int]: ...

def joint_generation(world: World, slot: int) -> int: ...

def joint_count(world: World) -> int: ...

def joint_slots_of(world: World, body: int) -> list[int]: ...

def broken_joints(world: World) -> list[tuple[Any, ...]]: ...

class Character:
    """A handle of a character: its body's slot and generation."""

    def __init__(self, arg0: World, arg1: int, arg2: int, /) -> None: ...

    @property
    def speed(self) -> float:
        """Metres a second that it walks."""

    @speed.setter
    def speed(self, value: float, /) -> None: ...

    @property
    def acceleration(self) -> float:
        """m/s2 on the ground, until it walks as fast as it can."""

    @acceleration.setter
    def acceleration(self, value: float, /) -> None: ...

    @property
    def deceleration(self) -> float:
        """m/s2 on the ground, when it stops or turns."""

    @deceleration.setter
    def deceleration(self, value: float, /) -> None: ...

    @property
    def air_acceleration(self) -> float:
        """m/s2 in the air, towards where it wants to go."""

    @air_acceleration.setter
    def air_acceleration(self, value: float, /) -> None: ...

    @property
    def air_deceleration(self) -> float:
        """m/s2 in the air, when it wants nothing."""

    @air_deceleration.setter
    def air_deceleration(self, value: float, /) -> None: ...

    @property
    def jump_height(self) -> float:
        """Metres that a jump goes up when it is held; 0: it cannot jump."""

    @jump_height.setter
    def jump_height(self, value: float, /) -> None: ...

    @property
    def jump_cut(self) -> float:
        """Share of the upward speed that is left when a jump is let go early."""

    @jump_cut.setter
    def jump_cut(self, value: float, /) -> None: ...

    @property
    def coyote_time(self) -> float:
        """Seconds after it walked off an edge in which it still can jump."""

    @coyote_time.setter
    def coyote_time(self, value: float, /) -> None: ...

    @property
    def jump_buffer(self) -> float:
        """Seconds before it lands in which a jump is remembered."""

    @jump_buffer.setter
    def jump_buffer(self, value: float, /) -> None: ...

    @property
    def gravity_scale(self) -> float:
        """Times the world's gravity."""

    @gravity_scale.setter
    def gravity_scale(self, value: float, /) -> None: ...

    @property
    def fall_speed(self) -> float:
        """Metres a second that it falls at most."""

    @fall_speed.setter
    def fall_speed(self, value: float, /) -> None: ...

    @property
    def max_slope(self) -> float:
        """Radians: the steepest slope that it walks on."""

    @max_slope.setter
    def max_slope(self, value: float, /) -> None: ...

    @property
    def step_height(self) -> float:
        """Metres: how high a step it walks onto, and down from."""

    @step_height.setter
    def step_height(self, value: float, /) -> None: ...

    @property
    def climb_speed(self) -> float:
        """Metres a second on ladders."""

    @climb_speed.setter
    def climb_speed(self, value: float, /) -> None: ...

    @property
    def push_force(self) -> float:
        """Newtons at most on what stands in its way."""

    @push_force.setter
    def push_force(self, value: float, /) -> None: ...

    @property
    def mass(self) -> float:
        """Kilograms, where it meets what is not fixed."""

    @mass.setter
    def mass(self, value: float, /) -> None: ...

    @property
    def air_jumps(self) -> int:
        """How often it can jump again in the air."""

    @air_jumps.setter
    def air_jumps(self, value: int, /) -> None: ...

    def _move(self, axis: object | None) -> None: ...

    def _climb(self, axis: object | None) -> None: ...

    def _jump(self) -> None: ...

    def _let_go(self) -> None: ...

    def _drop(self) -> None: ...

    @property
    def _wish(self) -> tuple[Any, ...]: ...

    def _add_ladder(self, arg0: float, arg1: float, arg2: float, arg3: float, /) -> None: ...

    def _clear_ladders(self) -> None: ...

    @property
    def _ladders(self) -> tuple[Any, ...]: ...

    @property
    def alive(self) -> bool:
        """False once its body was destroyed."""

    @property
    def grounded(self) -> bool:
        """Does it stand on something?"""

    @property
    def climbing(self) -> bool:
        """Does it hold on to a ladder?"""

    @property
    def crushed(self) -> bool:
        """Is it pressed into something that does not give way?"""

    @property
    def _ground(self) -> int: ...

    @property
    def ground_normal(self) -> evilengine.values.vec2.Vec2:
        """Direction of length 1 out of what it stands on; (0, 0) in the air."""

    @property
    def velocity(self) -> evilengine.values.vec2.Vec2:
        """
        Metres a second in the world. Set it to throw the character: what leads off the ground lifts it.
        """

    @velocity.setter
    def velocity(self, value: evilengine.values.vec2.Point, /) -> None: ...

    @property
    def _told(self) -> tuple[Any, ...]: ...

def add_character(arg0: World, arg1: int, /) -> None: ...

def characters(arg: World, /) -> list[int]:
    """The bodies of all characters, in the order in which they were made."""

def sincos(angle: float) -> tuple[float, float]:
    """
    (sin, cos) of an angle in radians, rounded to 32 bits; the same bits on every machine.
    """

def atan2(y: float, x: float) -> float:
    """Direction of (x, y) in radians, rounded to 32 bits."""

def exponential(x: float) -> float:
    """e to the power x, with the same bits on every machine."""

def logarithm(x: float) -> float:
    """Natural logarithm, with the same bits on every machine."""

def power(base: float, exponent: float) -> float:
    """base ** exponent for base >= 0, with the same bits on every machine."""

def instruction_sets() -> list[str]:
    """What wide kernels can run with on this machine; the last is used."""

def mat4(values: object) -> tuple[float, ...]:
    """16 numbers or 64 bytes as a matrix: finite, and rounded to 32 bits."""

def mat4_rotation(angle: float) -> tuple[float, ...]:
    """Rotation by radians."""

def mat4_product(a: object, b: object) -> tuple[float, ...]:
    """The matrix that applies b, then a."""

def mat4_times(matrix: object, vector: object) -> tuple[float, ...]:
    """Matrix times a point (a Vec2) or a vector of four (a tuple)."""

def mat4_transposed(a: object) -> tuple[float, ...]:
    """Rows as columns."""

def mat4_inverse(a: object) -> tuple[float, ...] | None:
    """The matrix that undoes a, or None."""

def transform(matrix: object, points: object, instruction_set: str = '') -> memoryview:
    """One matrix, or one for each, times points (n, 2) or vectors (n, 4)."""

def multiply(a: object, b: object, instruction_set: str = '') -> memoryview:
    """Products of matrices, (n, 16) by (n, 16), or one by many."""

def polygon_problem(points: object, holes: object = ()) -> str | None:
    """
    What is wrong with a polygon, in words, or None when it is simple and of a size that works.
    """

def triangulate(points: object, holes: object = ()) -> list[tuple[int, int, int]]:
    """
    Counter-clockwise triangles of corner numbers that fill a simple polygon, without new corners. Those of holes are counted on from the outline's.
    """

def split_convex(points: object, holes: object = ()) -> list[list[int]]:
    """
    Few convex, counter-clockwise parts of corner numbers that fill a simple polygon, without new corners.
    """

def convex_hull(points: object) -> list[int]:
    """
    Numbers of the points on the convex hull, counter-clockwise from the leftmost.
    """

def signed_area(points: object | None) -> float:
    """
    Area in square metres, positive when the corners run counter-clockwise.
    """

def is_convex(points: object | None) -> bool:
    """Does a simple polygon turn one way only? Straight corners are allowed."""

def polygon_mass(points: object, density: float = 1.0) -> tuple[float, float, tuple[float, float]]:
    """(mass, second moment about the centre, centre) of a simple polygon."""

def circle_mass(radius: float, density: float = 1.0) -> tuple[float, float, tuple[float, float]]:
    """(mass, second moment about the centre, centre) of a circle."""

class DrawList:
    """
    Meshes and instances to draw, back to front; see core/draw/draw_list.hpp.
    """

    def __init__(self) -> None: ...

    def clear(self) -> None:
        """Forget every mesh and instance; keeps the memory."""

    def polygon(self, points: object, *, uvs: object | None = None, colours: object | None = None, triangles: object | None = None) -> int:
        """
        Add a polygon and return its mesh's index. uvs default to the bounding box; colours are 0xAABBGGRR.
        """

    def circle(self, radius: object, *, at: object = (0.0, 0.0), colour: object = 4294967295) -> int:
        """Add a circle and return its mesh's index."""

    def instance(self, mesh: object, to_pixel: object | None = None, *, tint: object = 4294967295, texture: object = 0, outline: float = 0.0, to_texture: object | None = None, blend: int = 0) -> None:
        """
        Draw a mesh once more, on top: matrices as a b c d tx ty, tint as 0xAABBGGRR, outline in pixels.
        """

    @property
    def vertex_count(self) -> int: ...

    @property
    def index_count(self) -> int: ...

    @property
    def mesh_count(self) -> int: ...

    @property
    def instance_count(self) -> int: ...

class Raster:
    """The software renderer; evilengine.renderer.soft is its face."""

    def __init__(self, threads: int = 1) -> None: ...

    @property
    def threads(self) -> int:
        """How many threads may share in a picture."""

    @threads.setter
    def threads(self, arg: int, /) -> None: ...

    def upload(self, pixels: object, width: int, height: int) -> int:
        """
        Keep a picture of straight r, g, b, a bytes; its id is for DrawList.instance().
        """

    def update(self, texture: int, pixels: object, width: int, height: int) -> None:
        """Put another picture, of any size, under the same id."""

    def release(self, texture: int) -> None:
        """Forget a picture."""

    def draw(self, list: DrawList, pixels: object, width: int, height: int, background: int | None = 4278190080, instructions: str = '', part: tuple[int, int, int, int] | None = None, rows: int = 0) -> None:
        """
        Draw into `pixels`, rows of r, g, b, a multiplied with alpha, over what is there if background is None; `instructions` forces one instruction set, `part` is the left, top, width and height drawn into, and `rows` is how many of them a thread takes at a time, 0 for as many as suit the frame: it changes no pixel.
        """

def unpremultiply(pixels: object) -> None:
    """Turn pixels multiplied with alpha into straight ones, in place."""

class Memory:
    """Bytes of the core, read-only, without a copy."""

    def __len__(self) -> int: ...

class Batcher:
    """Draw lists as quads for a graphics card, in few draw calls."""

    def __init__(self) -> None: ...

    def another(self) -> Batcher:
        """One more of the same pictures, which keeps another list's meshes."""

    def hold(self) -> int:
        """The id of one more picture."""

    def drop(self, texture: int) -> None:
        """Draw what names this picture without one from now on."""

    def place(self, texture: int, page: int, copies: Sequence[tuple[float, float, float, float, float, float, float, float, float]]) -> None:
        """
        Where in the atlas a picture is: for each of its copies left and top there, width, height, and the part that is not clear: left, top, right, bottom; 1 if its corners are clear. No copies: nowhere. Texture 0: a white texel.
        """

    def collect(self, list: DrawList, width: int, height: int) -> list[tuple[Any, ...]]:
        """
        A frame as draw calls: the first quad, how many, their pictures by unit, and 1 if any has facets plus twice the number of their draw::Blend plus 8 if any has normals or glows. Or ('sprites', first, count, page of the atlas, COVER, is one lit, blend). Between them ('specks', first, count, are they discs, their blend), ('blur', levels, share), ('shafts', from, taps of each pass, colour, threshold), ('liquid', size, planes, place, texels used, one over the rim's width, is it lit), ('post',).
        """

    @property
    def post(self) -> dict[str, float]:
        """What the post pass of the frame is told."""

    @property
    def tones(self) -> bytes:
        """Its table: 1024 rows of four float32."""

    @property
    def specks(self) -> Memory:
        """The frame's specks; see core/draw/specks.hpp."""

    @property
    def sprites(self) -> Memory:
        """The frame's sprites; see core/gpu/quads.hpp."""

    @property
    def quads(self) -> Memory:
        """The frame's quads; see core/gpu/quads.hpp."""

    @property
    def edges(self) -> Memory:
        """
        Edges made for this frame, in pixels: texels that follow those of `shapes`.
        """

    @property
    def shapes(self) -> Memory:
        """Edges and facets of the meshes: rows of 1024 texels of 4 floats."""

    @property
    def revision(self) -> int:
        """Changes when `shapes` does."""

def mipmaps(pixels: object, width: int, height: int) -> list[tuple[int, int, bytes, tuple[int, int, int, int, bool]]]:
    """
    A picture of straight r, g, b, a and its smaller copies: width, height, bytes multiplied with alpha, and the part that is not clear: left, top, right, bottom; and whether the corners are, two texels each way.
    """

class SavedScene:
    """A scene that was read and found whole."""

    def __init__(self, arg: bytes, /) -> None: ...

    @property
    def textures(self) -> int: ...

    @property
    def clips(self) -> int: ...

    @property
    def places(self) -> list[tuple[int, int, int]]:
        """
        (slot, body's slot, shape's slot) of each drawing, in the order of creation.
        """

class Scene:
    """Drawings by slot and generation; evilengine.scene is the face."""

    def __init__(self) -> None: ...

    def glow(self, slot: int, generation: int) -> float:
        """How strongly it shines by itself; below 0: as its picture says."""

    def set_glow(self, slot: int, generation: int, value: float) -> None: ...

    def surface(self, slot: int, generation: int) -> tuple[int, int]:
        """
        Its pictures of normals and of what glows; 0: those of the picture that it shows.
        """

    def set_surface(self, slot: int, generation: int, normals: int, glows: int) -> None: ...

    def set_surface_of(self, texture: int, normals: int, glows: int) -> None:
        """What goes with a picture wherever it is shown."""

    def set_layers(self, layers: Sequence[tuple[int, tuple[float, float, float, float, float, float], int, bool]], perspective: tuple[float, float, float] | None = None) -> None:
        """
        How layers are seen that are not seen as the world is: (layer, matrix, tint, visible), by layer. In perspective, the picture's middle and one over the distance of the eye in metres.
        """

    def fog(self, layer: int, top: int, bottom: int, width: float, height: float, lit: bool) -> None: ...

    def shafts(self, layer: int, x: float, y: float, colour: int, strength: float, reach: float, threshold: float) -> None: ...

    def blur(self, layer: int, radius: float) -> None: ...

    def post(self, *, bloom: float, threshold: float, saturation: float, vignette: float, grain: float, seed: int, exposure: float, contrast: float, filmic: bool, tint: tuple[float, float, float]) -> None:
        """What is done to all that the frame has so far."""

    def collect(self, world: World, view: tuple[float, float, float, float, float, float], alpha: float, points: float) -> DrawList:
        """
        The frame at alpha (0..1) between the last two steps; good until the next one.
        """

    def aim(self, number: int) -> None:
        """What follows fills the list of that number, from 0 on."""

    def empty(self) -> DrawList:
        """A frame without drawings, for what lies over several views."""

    def debug(self, world: World, view: tuple[float, float, float, float, float, float], alpha: float, points: float, inks: Sequence[int], parts: Sequence[bool]) -> tuple[int, int, int, int, int]:
        """
        Put the debug view on top of the collected frame; the numbers of bodies, sleepers, contacts, joints, islands.
        """

    def debug_fluids(self, world: World, view: tuple[float, float, float, float, float, float], screen: tuple[float, float], points: float, inks: Sequence[int], parts: Sequence[bool]) -> tuple[int, int, float, float]:
        """
        Put the debug view of fluids on top; how many there are, and of water's particles, the m/s of the longest arrows, and the 1/s of full colours.
        """

    def arrow(self, x1: float, y1: float, x2: float, y2: float, width: float, colour: int) -> None: ...

    def disc(self, x: float, y: float, radius: float, colour: int) -> None: ...

    def box(self, left: float, top: float, right: float, bottom: float, colour: int) -> None: ...

    def glyphs(self, boxes: bytes, x: float, y: float, texture: int, colour: int) -> None:
        """
        A row of textured boxes on top: eight float32 each, left top right bottom in pixels and in the texture.
        """

    def __len__(self) -> int: ...

    def snapshot(self, world: World) -> tuple[bytes, list[int], list[int]]: ...

    def restore(self, saved: SavedScene, world: World, textures: Sequence[int], clips: Sequence[int]) -> None: ...

    def generation(self, slot: int) -> int: ...

    @property
    def mesh_count(self) -> int: ...

    def add_definition(self, spec: ShapeSpec, speck: float, body: tuple[int, int] | None = None, texture_points: object | None = None, colours: object | None = None) -> tuple[int, int]: ...

    def add_polygon(self, corners: object, body: tuple[int, int] | None = None, texture_points: object | None = None, colours: object | None = None) -> tuple[int, int]: ...

    def add_circle(self, radius: float, body: tuple[int, int] | None = None) -> tuple[int, int]: ...

    def add_shape(self, world: World, shape_slot: int, speck: float, texture_points: object | None = None, colours: object | None = None) -> tuple[int, int]: ...

    def remove(self, slot: int, generation: int) -> None: ...

    def alive(self, slot: int, generation: int) -> bool: ...

    def add_sliced(self, width: float, height: float, border: Sequence[float], part: Sequence[float], body: tuple[int, int] | None = None, shape: tuple[int, int] | None = None) -> tuple[int, int]:
        """
        A rectangle whose picture keeps its four borders: left, low, right, high, in metres and as parts of it.
        """

    def extent(self, slot: int, generation: int) -> tuple[float, float]:
        """Width and height of its shape, before its matrix."""

    def add_clip(self, textures: Sequence[int], steps: float, course: int) -> int:
        """
        Frames to be shown for so many steps each; course 0 again and again, 1 once, 2 there and back.
        """

    def clear_clips(self) -> None:
        """Forget the clips; there must be no drawing that shows one."""

    def playing(self, world: World, slot: int, generation: int) -> tuple[int, int, int, bool] | None: ...

    def play(self, slot: int, generation: int, clip: int | None, began: int) -> None: ...

    def flip_x(self, slot: int, generation: int) -> bool: ...

    def set_flip_x(self, slot: int, generation: int, value: bool) -> None: ...

    def flip_y(self, slot: int, generation: int) -> bool: ...

    def set_flip_y(self, slot: int, generation: int, value: bool) -> None: ...

    def blend(self, slot: int, generation: int) -> int: ...

    def set_blend(self, slot: int, generation: int, value: int) -> None: ...

    def tint(self, slot: int, generation: int) -> int: ...

    def set_tint(self, slot: int, generation: int, value: int) -> None: ...

    def edge(self, slot: int, generation: int) -> int: ...

    def set_edge(self, slot: int, generation: int, value: int) -> None: ...

    def edge_width(self, slot: int, generation: int) -> float: ...

    def set_edge_width(self, slot: int, generation: int, value: float) -> None: ...

    def texture(self, slot: int, generation: int) -> int: ...

    def set_texture(self, slot: int, generation: int, value: int) -> None: ...

    def layer(self, slot: int, generation: int) -> int: ...

    def set_layer(self, slot: int, generation: int, value: int) -> None: ...

    def visible(self, slot: int, generation: int) -> bool: ...

    def set_visible(self, slot: int, generation: int, value: bool) -> None: ...

    def lit(self, slot: int, generation: int) -> bool: ...

    def set_lit(self, slot: int, generation: int, value: bool) -> None: ...

    def behind(self, slot: int, generation: int) -> float: ...

    def set_behind(self, slot: int, generation: int, value: float) -> None: ...

    def depth(self, slot: int, generation: int) -> float: ...

    def set_depth(self, slot: int, generation: int, value: float) -> None: ...

    def matrix(self, slot: int, generation: int) -> tuple[float, float, float, float, float, float]: ...

    def set_matrix(self, slot: int, generation: int, value: tuple[float, float, float, float, float, float]) -> None: ...

    def texture_matrix(self, slot: int, generation: int) -> tuple[float, float, float, float, float, float]: ...

    def set_texture_matrix(self, slot: int, generation: int, value: tuple[float, float, float, float, float, float]) -> None: ...

class Emitter:
    """Particles; evilengine.scene.particles is the face."""

    def __init__(self) -> None: ...

    def seed(self, seed: int) -> None: ...

    def define(self, *, body: tuple[int, int] | None, at: tuple[float, float], direction: float, cone: float, rate: float, half: tuple[float, float], radius: float, life: tuple[float, float], speed: tuple[float, float], spin: tuple[float, float], varies: float, gravity_scale: float, drag: float, wind: tuple[float, float], collides: bool, dies: bool, bounce: float, friction: float, mask: int, most: int) -> None: ...

    def show(self, *, size: Sequence[float], pace: Sequence[float], colour: Sequence[int], soft: bool, blend: int, lit: bool, stretch: float, texture: int, layer: int) -> None: ...

    @property
    def running(self) -> bool: ...

    @running.setter
    def running(self, arg: bool, /) -> None: ...

    @property
    def count(self) -> int: ...

    def clear(self) -> None: ...

    def step(self, world: World, dt: float) -> None: ...

    def burst(self, world: World, count: int) -> None: ...

    def collect(self, scene: Scene, view: tuple[float, float, float, float, float, float], alpha: float, dt: float, screen: tuple[float, float]) -> None:
        """
        Put them into the frame that the scene collected; emitters in the order of layers.
        """

    def positions(self) -> list[tuple[float, float]]: ...

    def velocities(self) -> list[tuple[float, float]]: ...

    def snapshot(self) -> bytes: ...

    def restore(self, data: bytes) -> None: ...

KNOTS: int = 64

class Reach(enum.Enum):
    """Where a light shines to."""

    round = 0

    cone = 1

    parallel = 2

class Quality(enum.Enum):
    """How light is worked out."""

    low = 0

    medium = 1

    high = 2

class Lights:
    """Lights by slot and generation; evilengine.scene.lights is the face."""

    def __init__(self) -> None: ...

    @property
    def threads(self) -> int:
        """
        How many threads may work out a frame's light. The bits are the same with any number.
        """

    @threads.setter
    def threads(self, arg: int, /) -> None: ...

    def __len__(self) -> int: ...

    def add(self, body: tuple[int, int] | None = None) -> tuple[int, int]:
        """A new light, on a body's slot and generation or by itself."""

    def remove(self, slot: int, generation: int) -> None: ...

    def alive(self, slot: int, generation: int) -> bool: ...

    def slots(self) -> list[int]:
        """The slots that hold a light, rising."""

    def generation(self, slot: int) -> int: ...

    @property
    def next_serial(self) -> int: ...

    def serial(self, slot: int, generation: int) -> int: ...

    def body(self, slot: int, generation: int) -> tuple[int, int] | None: ...

    def at(self, slot: int, generation: int) -> tuple[float, float]: ...

    def set_at(self, slot: int, generation: int, value: tuple[float, float]) -> None: ...

    def reach(self, slot: int, generation: int) -> Reach: ...

    def set_reach(self, slot: int, generation: int, value: Reach) -> None: ...

    def angle(self, slot: int, generation: int) -> float: ...

    def set_angle(self, slot: int, generation: int, value: float) -> None: ...

    def cone(self, slot: int, generation: int) -> float: ...

    def set_cone(self, slot: int, generation: int, value: float) -> None: ...

    def edge(self, slot: int, generation: int) -> float: ...

    def set_edge(self, slot: int, generation: int, value: float) -> None: ...

    def radius(self, slot: int, generation: int) -> float: ...

    def set_radius(self, slot: int, generation: int, value: float) -> None: ...

    def size(self, slot: int, generation: int) -> float: ...

    def set_size(self, slot: int, generation: int, value: float) -> None: ...

    def falloff(self, slot: int, generation: int) -> float: ...

    def set_falloff(self, slot: int, generation: int, value: float) -> None: ...

    def intensity(self, slot: int, generation: int) -> float: ...

    def set_intensity(self, slot: int, generation: int, value: float) -> None: ...

    def colour(self, slot: int, generation: int) -> list[float]: ...

    def set_colour(self, slot: int, generation: int, value: Sequence[float]) -> None: ...

    def temperature(self, slot: int, generation: int) -> float: ...

    def set_temperature(self, slot: int, generation: int, value: float) -> None: ...

    def tint(self, slot: int, generation: int) -> list[float]: ...

    def set_tint(self, slot: int, generation: int, value: Sequence[float]) -> None: ...

    def mask(self, slot: int, generation: int) -> int: ...

    def set_mask(self, slot: int, generation: int, value: int) -> None: ...

    def on(self, slot: int, generation: int) -> bool: ...

    def set_on(self, slot: int, generation: int, value: bool) -> None: ...

    def shadows(self, slot: int, generation: int) -> bool: ...

    def set_shadows(self, slot: int, generation: int, value: bool) -> None: ...

    def slide(self, slot: int, generation: int) -> int: ...

    def set_slide(self, slot: int, generation: int, value: int) -> None: ...

    def still(self, slot: int, generation: int) -> bool: ...

    def set_still(self, slot: int, generation: int, value: bool) -> None: ...

    def add_slide(self, pixels: object, width: int, height: int) -> int:
        """
        A picture of straight r, g, b, a that lights may shine through; its number.
        """

    def change_slide(self, slide: int, pixels: object, width: int, height: int) -> None:
        """Another picture in its place."""

    def restore(self, world: World, slots: Sequence[int], serials: Sequence[int], bodies: Sequence[int], next_serial: int) -> list[tuple[int, int]]:
        """Become lights in these slots, as new ones are; their references."""

    def collect(self, scene: Scene, world: World, view: tuple[float, float, float, float, float, float], alpha: float, width: int, height: int, ambient: Sequence[float], strength: float, depth: float, step: int, quality: Quality, bounce: float, shadows: bool, smokes: Sequence[tuple[int, float]]) -> bool:
        """
        Put the frame's light into the list that the scene collected; whether anything in it is lit.
        """

    def debug(self, scene: Scene, world: World, view: tuple[float, float, float, float, float, float], alpha: float, points: float, inks: Sequence[int]) -> int:
        """
        Put lights and the edges of shadows on top of the collected frame; how many lights are on.
        """

def light_map(list: DrawList) -> tuple[int, int, float, float, float, list[bytes]] | None:
    """
    Width, height, pixels a texel, where in the picture the first one's middle lies, and planes of texels, r, g, b, 1 as floats of 16 bits: the light, and where something has normals its ways across and down; None where nothing is lit.
    """

class Foam:
    """Spray, foam and bubbles of one water."""

    def __init__(self, seed: int) -> None: ...

    @property
    def count(self) -> int:
        """How many flecks there are."""

    def step(self, world: World, slot: int, amount: float, dt: float) -> None:
        """One step, after the world's: `amount` times as much as by itself."""

    def collect(self, scene: Scene, view: tuple[float, float, float, float, float, float], back: float, width: int, height: int, spacing: float, points: float, lit: bool, tint: int, layer: int) -> None:
        """Put them into the frame that the scene collected."""

    def snapshot(self) -> bytes: ...

    def restore(self, bytes: bytes) -> None: ...

LIQUID_TABLE: int = 64

MOST_LIQUIDS: int = 16

def liquid_colours(world: World, slot: int) -> list[list[float]]:
    """Red, green and blue of each liquid of a water."""

class LiquidLook:
    """How one liquid is shown."""

    def __init__(self) -> None: ...

    def set_tables(self, tables: Sequence[Sequence[Sequence[float]]]) -> None:
        """
        Of each liquid LIQUID_TABLE rows from the surface to the deep: the shares of red, green and blue that come through, and those that it adds.
        """

    @property
    def clarity(self) -> float: ...

    @clarity.setter
    def clarity(self, arg: float, /) -> None: ...

    @property
    def refraction(self) -> float: ...

    @refraction.setter
    def refraction(self, arg: float, /) -> None: ...

    @property
    def rim(self) -> float: ...

    @rim.setter
    def rim(self, arg: float, /) -> None: ...

    @property
    def waves(self) -> float: ...

    @waves.setter
    def waves(self, arg: float, /) -> None: ...

    @property
    def lit(self) -> bool: ...

    @lit.setter
    def lit(self, arg: bool, /) -> None: ...

    def collect(self, scene: Scene, world: World, slot: int, view: tuple[float, float, float, float, float, float], alpha: float, back: float, time: float, width: int, height: int, points: float, layer: int) -> bool:
        """
        Put the liquid into the frame that the scene collected; whether any of it is to be seen.
        """

class Sample:
    """A sound in memory: 32-bit floats, one or two channels, any rate."""

    def __init__(self, data: object, *, channels: int, rate: float) -> None: ...

    @property
    def channels(self) -> int: ...

    @property
    def rate(self) -> float: ...

    @property
    def frames(self) -> int: ...

class Stream:
    """A sound that is written while it plays."""

    def __init__(self, *, channels: int, rate: float, capacity: int) -> None: ...

    @property
    def channels(self) -> int: ...

    @property
    def rate(self) -> float: ...

    @property
    def room(self) -> int:
        """Frames that can be written now."""

    @property
    def written(self) -> int:
        """Frames written so far."""

    def write(self, data: object) -> None:
        """Add whole frames of 32-bit floats, at most `room` of them."""

    def finish(self) -> None:
        """Say that no more will come."""

MIX_RATE: int = 48000

MIX_LATENCY: int = 127

class Mixer:
    """
    Voices into groups into one mix of 48 kHz stereo; see core/mixer/desk.hpp.
    """

    def __init__(self, *, instructions: str = '') -> None:
        """`instructions` forces one instruction set."""

    def start(self, *, sample: Sample | None = None, stream: Stream | None = None, speed: float = 1.0, gains: Sequence[float] = [1.0, 0.0, 0.0, 1.0], group: int = 1, position: int = 0, loop: tuple[int, int] | None = None, fade: int = 0, squared: bool = True, when: int = 0) -> int:
        """
        Play at frame `when` of the mix; the voice as a number, or 0 when all are busy.
        """

    def gains(self, voice: int, gains: Sequence[float], frames: int, when: int = 0) -> None:
        """
        Left to left, left to right, right to left, right to right; a source with one channel uses the first two.
        """

    def speed(self, voice: int, speed: float, frames: int, when: int = 0) -> None:
        """Source frames a mixed frame."""

    def stop(self, voice: int, frames: int, squared: bool = True, when: int = 0) -> None:
        """
        Fade out and end; along a quarter sine, which keeps the power of a cross-fade, or its square.
        """

    def group_gain(self, group: int, gain: float, frames: int, when: int = 0) -> None:
        """Group 0 is the master."""

    def group_pause(self, group: int, paused: bool, when: int = 0) -> None:
        """Voices of a paused group stand still."""

    def tidy(self) -> None:
        """Hear which voices have ended, and let go of what they played."""

    def playing(self, voice: int) -> bool:
        """False once tidy() has heard that it ended."""

    @property
    def voices_in_use(self) -> int: ...

    @property
    def clock(self) -> int:
        """Frames mixed so far."""

    def render(self, frames: int) -> bytes:
        """
        The next frames, left and right as 32-bit floats, MIX_LATENCY frames late.
        """

    def render_pcm(self, frames: int) -> bytes:
        """The next frames as 16-bit whole numbers, little end first."""

    @property
    def address(self) -> int:
        """What to hand to the callback; valid as long as this object lives."""

    callback: Final[int] = ...
    """
    Address of void (*)(void *mixer, uint8_t *stream, int bytes), for a sound card to call.
    """

    def watch(self, clock: int) -> None:
        """
        Measure the callback by the uint64_t (*)(void) at this address; 0 stops it.
        """

    @property
    def punctuality(self) -> tuple[int, int, int]:
        """
        Blocks mixed, longest time from one call to the next, longest time of a call: in ticks of that clock.
        """

def bounds_of_pieces(world: World, dt: float) -> list[tuple[int, float, float, float, float, int]]:
    """
    For tests: body, low x, low y, high x, high y and octave of size of each piece's bounds.
    """

def pairs_of_pieces(world: World, dt: float) -> list[tuple[int, int]]:
    """For tests: the pairs of pieces that the broad phase finds."""

def manifolds_of_pairs(world: World, dt: float, wide: bool) -> list[tuple[int, int, int, float, float, list[tuple[float, float, float, int]]]]:
    """
    For tests: pieces, axis, normal and points (anchor x and y, separation, id) of each contact, found eight at a time or one by one.
    """

RAMP: int = 64

class FieldView:
    """
    A number, or two, for each cell of a smoke, rows from below: a float32 buffer that is not copied and may be written. `numpy.asarray(view)` works; `view[j, i]` is one cell.
    """

    @property
    def shape(self) -> tuple[int, ...]: ...

    def __len__(self) -> int: ...

    def __getitem__(self, arg: tuple[int, int], /) -> object: ...

    def __setitem__(self, at: tuple[int, int], value: object | None) -> None: ...

class Smoke:
    """A handle of a smoke: its slot and generation."""

    def __init__(self, arg0: World, arg1: int, /) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def viscosity(self) -> float:
        """m2/s: how thick it is; 0 costs nothing."""

    @viscosity.setter
    def viscosity(self, value: float, /) -> None: ...

    @property
    def diffusion(self) -> float:
        """m2/s: how fast what it carries spreads by itself."""

    @diffusion.setter
    def diffusion(self, value: float, /) -> None: ...

    @property
    def buoyancy(self) -> float:
        """How many times the world's gravity a temperature of 1 rises with."""

    @buoyancy.setter
    def buoyancy(self, value: float, /) -> None: ...

    @property
    def vorticity(self) -> float:
        """How strongly small whirls are kept alive."""

    @vorticity.setter
    def vorticity(self, value: float, /) -> None: ...

    @property
    def cooling(self) -> float:
        """Share of the heat that is lost a second, small shares."""

    @cooling.setter
    def cooling(self, value: float, /) -> None: ...

    @property
    def fade(self) -> float:
        """Share of the density that is lost a second, small shares."""

    @fade.setter
    def fade(self, value: float, /) -> None: ...

    @property
    def burning(self) -> float:
        """Share of the fuel that burns in a second, small shares."""

    @burning.setter
    def burning(self, value: float, /) -> None: ...

    @property
    def heat(self) -> float:
        """Temperature that a unit of fuel gives."""

    @heat.setter
    def heat(self, value: float, /) -> None: ...

    @property
    def soot(self) -> float:
        """Density that a unit of fuel leaves."""

    @soot.setter
    def soot(self, value: float, /) -> None: ...

    @property
    def weight(self) -> float:
        """kg/m2: how hard it pushes bodies."""

    @weight.setter
    def weight(self, value: float, /) -> None: ...

    @property
    def wind_pull(self) -> float:
        """Share of the difference to the wind that goes in a second."""

    @wind_pull.setter
    def wind_pull(self, value: float, /) -> None: ...

    @property
    def wind(self) -> evilengine.values.vec2.Vec2:
        """m/s that it is drawn towards."""

    @wind.setter
    def wind(self, value: evilengine.values.vec2.Point, /) -> None: ...

    def _density_at(self, arg: object, /) -> list[Any]: ...

    def _temperature_at(self, arg: object, /) -> list[Any]: ...

    def _velocity_at(self, arg: object, /) -> list[Any]: ...

    @property
    def mass(self) -> float:
        """All the density in it, times its area in m2."""

    @property
    def density(self) -> FieldView:
        """Smoke in each cell, (ny, nx) numbers."""

    @property
    def temperature(self) -> FieldView:
        """Heat of each cell above what surrounds it, (ny, nx) numbers."""

    @property
    def fuel(self) -> FieldView:
        """Fuel in each cell, (ny, nx) numbers."""

    @property
    def velocity(self) -> FieldView:
        """m/s in the middle of each cell, (ny, nx, 2) numbers."""

    @property
    def cells(self) -> tuple[int, int]:
        """How many cells it has, across and up."""

    @property
    def cell(self) -> float:
        """Metres: the side of a cell."""

    @property
    def area(self) -> tuple[float, float, float, float]:
        """Where it is: (left, bottom, right, top), in whole cells."""

    @property
    def _open(self) -> list[bool]: ...

    @property
    def _colour(self) -> tuple[float, float, float]: ...

    @property
    def _kind(self) -> tuple[int, int]: ...

    def _gathering(self) -> tuple[float, float]:
        """
        Divergence before and after the last projection, root mean square, 1/s, from the step after the first call on.
        """

    def _paint(self, colours: Sequence[int], scale: float, heat: bool) -> bytes: ...

    def _blazes(self, above: float) -> list[tuple[int, float, float, float, float]]:
        """
        Of each source that there is fire near: its slot, how strong that is, where and how large; of all fire, if there are no sources.
        """

    def _stir(self, arg0: tuple[float, float], arg1: float, arg2: tuple[float, float], /) -> None: ...

    def _sources(self) -> list[int]: ...

    def _take_back(self) -> None: ...

    def _destroy(self) -> None: ...

def add_smoke(world: World, *, nx: int, ny: int, low: tuple[float, float], cell: float, method: int, quality: int, open: Sequence[bool], side_speeds: Sequence[float], stick: bool, colour: tuple[float, float, float]) -> int: ...

def smoke_slots(arg: World, /) -> list[int]: ...

class Source:
    """A handle of a source of smoke: its slot and generation."""

    def __init__(self, arg0: World, arg1: int, /) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def rate(self) -> float:
        """Density a second; negative: it takes away that share."""

    @rate.setter
    def rate(self, value: float, /) -> None: ...

    @property
    def fuel(self) -> float:
        """Fuel a second."""

    @fuel.setter
    def fuel(self, value: float, /) -> None: ...

    @property
    def temperature(self) -> float:
        """What it heats to; 0: it heats nothing."""

    @temperature.setter
    def temperature(self, value: float, /) -> None: ...

    @property
    def velocity(self) -> object:
        """
        m/s that gas in it is given, beside its body's own; None: it leaves the gas as it moves.
        """

    @velocity.setter
    def velocity(self, value: evilengine.values.vec2.Point | None, /) -> None: ...

    @property
    def running(self) -> bool:
        """Does it give anything now?"""

    @running.setter
    def running(self, value: bool, /) -> None: ...

    @property
    def _body(self) -> int: ...

    @property
    def _colour(self) -> tuple[float, float, float]: ...

    def _destroy(self) -> None: ...

def add_source(world: World, *, smoke: int, body: int, shape: ShapeSpec, at: object, angle: float, rate: float, fuel: float, temperature: float, velocity: object | None, colour: tuple[float, float, float]) -> int: ...

class ParticleView:
    """
    Numbers of each particle of a water: a buffer that is not copied; positions and velocities, two float32 each, may be written. `numpy.asarray(view)` works.
    """

    def __len__(self) -> int: ...

    @property
    def shape(self) -> tuple[int, ...]: ...

    def __getitem__(self, arg: int, /) -> object: ...

    def __setitem__(self, at: int, value: object | None) -> None: ...

class Water:
    """A handle of a water: its slot and generation."""

    def __init__(self, arg0: World, arg1: int, /) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    def _velocity_at(self, arg: object, /) -> list[Any]: ...

    def _density_at(self, arg: object, /) -> list[Any]: ...

    def _is_in(self, arg: object, /) -> list[Any]: ...

    def _depth_at(self, arg: object, /) -> list[Any]: ...

    def _add_liquid(self, arg0: float, arg1: float, arg2: float, arg3: tuple[float, float, float], /) -> int: ...

    def _liquid_serials(self) -> list[int]: ...

    def _liquid(self, arg0: int, arg1: int, /) -> tuple[float, float, float, tuple[float, float, float]]: ...

    def _set_liquid(self, arg0: int, arg1: int, arg2: float, arg3: float, arg4: float, arg5: tuple[float, float, float], /) -> None: ...

    def _count_of(self, arg0: int, arg1: int, /) -> int: ...

    @property
    def count(self) -> int:
        """How many particles it has."""

    @property
    def positions(self) -> ParticleView:
        """
        Where the particles are, (count, 2) metres; a step may change their order.
        """

    @property
    def velocities(self) -> ParticleView:
        """How they move, (count, 2) m/s, in the same order."""

    @property
    def kinds(self) -> ParticleView:
        """
        Which of `liquids` each of them is, (count,) bytes in the same order, to be read.
        """

    @property
    def particle_size(self) -> float:
        """Metres: a particle stands for a square of that side."""

    @property
    def cells(self) -> tuple[int, int]:
        """How many cells its pressure has, across and up."""

    @property
    def area(self) -> tuple[float, float, float, float]:
        """Where it may be: (left, bottom, right, top), in whole cells."""

    @property
    def _open(self) -> list[bool]: ...

    def _fill(self, arg0: ShapeSpec, arg1: object, arg2: float, arg3: int, arg4: tuple[float, float], /) -> int: ...

    def _clear(self, arg0: ShapeSpec, arg1: object, arg2: float, /) -> int: ...

    def _stir(self, arg0: tuple[float, float], arg1: float, arg2: tuple[float, float], /) -> None: ...

    def _streams(self) -> list[int]: ...

    def _destroy(self) -> None: ...

MOST_PARTICLES: int = 4194304

MOST_LIQUIDS_OF_WATER: int = 16

def add_water(world: World, *, nx: int, ny: int, low: tuple[float, float], particle_size: float, open: Sequence[bool], density: float, viscosity: float, surface_tension: float, colour: tuple[float, float, float]) -> int: ...

def water_slots(arg: World, /) -> list[int]: ...

class WaterStream:
    """A handle of a stream: its slot and generation."""

    def __init__(self, arg0: World, arg1: int, /) -> None: ...

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or restored away."""

    @property
    def slot(self) -> int:
        """Row of this object in the world's arrays."""

    @property
    def generation(self) -> int:
        """How often that row has been taken and freed."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def _bury(self, arg: int, /) -> None: ...

    @property
    def velocity(self) -> evilengine.values.vec2.Vec2:
        """
        m/s that liquid comes out with, beside its body's own; of one that drains it means nothing.
        """

    @velocity.setter
    def velocity(self, value: evilengine.values.vec2.Point, /) -> None: ...

    @property
    def running(self) -> bool:
        """Does it pour, or drain, now?"""

    @running.setter
    def running(self, value: bool, /) -> None: ...

    @property
    def _body(self) -> int: ...

    @property
    def _rate(self) -> float: ...

    def _set_rate(self, arg: float, /) -> None: ...

    @property
    def _water(self) -> int: ...

    @property
    def _liquid(self) -> int: ...

    def _destroy(self) -> None: ...

MOST_POURING: float = 1000000.0

def add_stream(world: World, *, water: int, body: int, shape: ShapeSpec, at: object, angle: float, rate: float, velocity: tuple[float, float], liquid: int) -> int: ...
