"""All bodies of a world, one by one and as arrays."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias, overload

from evilengine import _core
from evilengine.values.checks import known_keywords
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point
from evilengine.world.body import Body

if TYPE_CHECKING:
    from evilengine.world.world import World


Buffer: TypeAlias = Any
"""What Python's buffer protocol can look into: NumPy's arrays, `array.array`, a memoryview, the world's own views."""

Points: TypeAlias = Buffer | Sequence[Point]
Numbers: TypeAlias = Buffer | Sequence[float]
Slots: TypeAlias = "BodyList | Buffer | Sequence[int] | Sequence[Body]"


class BodyList(Sequence[Body]):
    """Bodies that were added together. Handles are made when they are asked for, so that thousands cost nothing.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> balls = world.add_many(evil.Circle(0.5), [(0, 0), (2, 0), (4, 0)])
    >>> balls[-1].position, [ball.slot for ball in balls[:2]]
    (Vec2(4.0, 0.0), [0, 1])
    """

    __slots__ = ("_refs", "_world")

    def __init__(self, world: World, refs: _core.BodyRefs) -> None:
        self._world = world
        self._refs = refs

    @property
    def slots(self) -> memoryview:
        """(n,) uint32: the row of each body in the world's arrays, without a copy."""
        return memoryview(self._refs)  # type: ignore[arg-type]

    def __len__(self) -> int:
        return len(self._refs)

    @overload
    def __getitem__(self, index: int) -> Body: ...
    @overload
    def __getitem__(self, index: slice) -> list[Body]: ...
    def __getitem__(self, index: int | slice) -> Body | list[Body]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        if isinstance(index, bool) or not isinstance(index, int):
            raise ArgumentTypeError(f"BodyList: [{index!r}] must be a whole number or a slice")
        return self._world._body(*self._refs[index])

    def __repr__(self) -> str:
        return f"<BodyList, {len(self)}>"


class Bodies:
    """A world's bodies in creation order, and their values as arrays with a row for each slot (`body.slot`).

    The arrays are views without a copy, refreshed after each step; `numpy.asarray(world.bodies.positions)` works. A row
    whose slot is free holds zeros.
    """

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        self._world = world

    def __len__(self) -> int:
        return self._world._core.body_count

    def __iter__(self) -> Iterator[Body]:
        return iter([self._world._body(slot) for slot in self._world._core.body_slots()])

    def __contains__(self, body: object) -> bool:
        return isinstance(body, Body) and body._world is self._world and body.alive

    @property
    def positions(self) -> _core.View:
        """(n, 2) float32: where each body's origin is."""
        return self._world._core.positions

    @property
    def angles(self) -> _core.View:
        """(n,) float32: radians."""
        return self._world._core.angles

    @property
    def velocities(self) -> _core.View:
        """(n, 2) float32: metres a second."""
        return self._world._core.velocities

    @property
    def matrices(self) -> _core.View:
        """(n, 16) float32: body to world, column by column."""
        return self._world._core.matrices

    # -- writing many at once --
    #
    # `values` are as many as `indices`, or, without them, a row for each slot, as the arrays above have. A value that
    # is what it was changes nothing and wakes nobody. All are written or, after an error, none.

    @known_keywords
    def set_positions(self, values: Points, indices: Slots | None = None) -> None:
        """Move bodies at once. `indices` are bodies, or their slots; all bodies without.

        Values may be a NumPy array, any other buffer of floats, or a list. What moves wakes, and what it touches.

        >>> import evilengine as evil
        >>> world = evil.World()
        >>> balls = world.add_many(evil.Circle(0.5), [(0, 0), (2, 0), (4, 0)])
        >>> world.bodies.set_positions([(1, 1), (5, 5)], [balls[0], balls[2]])
        >>> [tuple(ball.position) for ball in balls]
        [(1.0, 1.0), (2.0, 0.0), (5.0, 5.0)]
        """
        self._world._core.set_positions(values, self._slots(indices, "set_positions"))

    @known_keywords
    def set_angles(self, values: Numbers, indices: Slots | None = None) -> None:
        """Turn bodies at once (radians)."""
        self._world._core.set_angles(values, self._slots(indices, "set_angles"))

    @known_keywords
    def set_velocities(self, values: Points, indices: Slots | None = None) -> None:
        """Set velocities of the centres of mass, m/s. Without indices, rows of static bodies are passed over."""
        self._world._core.set_velocities(values, self._slots(indices, "set_velocities"))

    @known_keywords
    def set_angular_velocities(self, values: Numbers, indices: Slots | None = None) -> None:
        """Set angular velocities, radians a second. Without indices, rows of static bodies are passed over."""
        self._world._core.set_spins(values, self._slots(indices, "set_angular_velocities"))

    @known_keywords
    def apply_forces(self, values: Points, indices: Slots | None = None, points: Points | None = None) -> None:
        """Push with forces (newtons) during the next step, at `points` of the world or at the centres of mass.

        A body named twice is pushed twice.

        >>> import evilengine as evil
        >>> world = evil.World(gravity=(0, 0))
        >>> balls = world.add_many(evil.Circle(1), [(0, 0), (5, 0)], mass=2)
        >>> world.bodies.apply_forces([(4, 0), (0, 8)], balls); world.step(0.5)
        >>> balls[0].velocity, balls[1].velocity
        (Vec2(1.0, 0.0), Vec2(0.0, 2.0))
        """
        self._world._core.apply_forces(values, self._slots(indices, "apply_forces"), points)

    @known_keywords
    def apply_impulses(self, values: Points, indices: Slots | None = None, points: Points | None = None) -> None:
        """Change velocities at once by impulses (newton seconds), at `points` of the world or the centres of mass."""
        self._world._core.apply_impulses(values, self._slots(indices, "apply_impulses"), points)

    def _slots(self, indices: object, method: str) -> object:
        """What the core takes for `indices`: nothing, references, a buffer, or a list of slots."""
        if isinstance(indices, BodyList):
            if indices._world is not self._world:
                raise ArgumentError(f"Bodies.{method}: indices={indices!r} are bodies of another world")
            return indices._refs
        if isinstance(indices, (list, tuple)) and any(isinstance(one, Body) for one in indices):
            me = f"Bodies.{method}"
            return [
                self._world._own_body(one, me, f"indices[{i}]").slot if isinstance(one, Body) else one
                for i, one in enumerate(indices)
            ]
        return indices

    def __repr__(self) -> str:
        return f"<Bodies, {len(self)}>"
