"""Soft things: bodies joined by springs, made in one call (SPEC P7).

A rope, a blob and a block of jelly. Each is bodies and joints like any others: they collide, are touched, drawn and
saved as those are; `Soft` only knows which belong together.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import place
from evilengine.world.body import Body
from evilengine.world.joints import Distance, Hinge, Joint
from evilengine.world.joints.fields import MOST_HERTZ
from evilengine.world.shapes import Capsule, Circle
from evilengine.world.world import World

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import TracebackType

MOST_PIECES = 1000


@dataclass(frozen=True, slots=True)
class Soft:
    """What a soft thing is made of."""

    bodies: tuple[Body, ...]
    """In order: along a rope; round a blob, its middle last; row by row from below in a jelly."""
    joints: tuple[Joint, ...]
    outline: tuple[Body, ...]
    """The bodies round its edge, counter-clockwise; of a rope, all."""

    @property
    def centre(self) -> Vec2:
        """The centre of mass of the bodies that are left."""
        left = [body for body in self.bodies if body.alive]
        mass = sum(body.mass for body in left)
        return sum((body.mass / mass * body.centre for body in left), Vec2(0.0, 0.0))

    @property
    def first(self) -> Body:
        """The first body: of a rope, its start."""
        return self.bodies[0]

    @property
    def last(self) -> Body:
        """The last body: of a rope, its end."""
        return self.bodies[-1]

    @property
    def alive(self) -> bool:
        """Is any of its bodies left?"""
        return any(body.alive for body in self.bodies)

    def destroy(self) -> None:
        """Take all of it out of the world."""
        for body in self.bodies:
            if body.alive:
                body.destroy()


@known_keywords
def rope(
    world: World,
    start: Point,
    end: Point,
    *,
    pieces: int = 20,
    thickness: float = 0.1,
    breaking_force: float | None = None,
    add: Callable[..., Body] | None = None,
    **properties: Any,
) -> Soft:
    """A rope of `pieces` links from `start` to `end`, hinged end to end.

    Tie its ends by joints of your own, as `evil.joints.Hinge(hook, rope.first, at=start)`. What else a body may be told
    (`density`, `friction`, `damping`, `touchable`, ...) goes to every link. A game gives `add=game.add`, so that it
    can be seen.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> rope = evil.soft.rope(world, (0, 5), (4, 5), pieces=8)
    >>> len(rope.bodies), len(rope.joints)
    (8, 7)
    """
    me = "soft.rope"
    a, b = place(start, me, "start"), place(end, me, "end")
    count = _pieces(pieces, me, "pieces", 1)
    span = (b - a) / count
    radius = 0.5 * number(thickness, me, "thickness", above=0.0, most=1e4)
    if not span.length > 0.0:
        raise ArgumentError(f"{me}: start={start!r} and end={end!r} must be two different points")
    link = Capsule((-0.5 * span.length, 0.0), (0.5 * span.length, 0.0), radius)
    properties = {"angular_damping": 0.5, **properties}
    with _Maker(world, add, {"angle": span.angle, **properties}) as maker:
        links = [maker.add(link, a + (i + 0.5) * span) for i in range(count)]
        for i in range(1, count):
            maker.join(Hinge(links[i - 1], links[i], at=a + i * span, breaking_force=breaking_force))
    return Soft(tuple(links), tuple(maker.joints), tuple(links))


@known_keywords
def blob(
    world: World,
    at: Point,
    *,
    radius: float = 1.0,
    pieces: int = 16,
    frequency: float = 3.0,
    damping_ratio: float = 0.3,
    breaking_force: float | None = None,
    add: Callable[..., Body] | None = None,
    **properties: Any,
) -> Soft:
    """A round soft body: a ring of discs on springs about its middle, that gives where it lands and springs back.

    `frequency` (hertz) says how stiff it is.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> blob = evil.soft.blob(world, (0, 3), radius=1)
    >>> len(blob.outline), blob.centre.y
    (16, 3.0)
    """
    me = "soft.blob"
    middle = place(at, me)
    count = _pieces(pieces, me, "pieces", 5)
    radius = number(radius, me, "radius", above=0.0, most=1e4)
    frequency = number(frequency, me, "frequency", least=0.0, most=MOST_HERTZ / 4.0)
    bead = radius * math.sin(math.pi / count) / (1.0 + math.sin(math.pi / count))  # discs that just touch, inside it
    round_at = radius - bead
    around = [middle + Vec2(round_at, 0.0).turned(math.tau * i / count) for i in range(count)]
    with _Maker(world, add, properties) as maker:
        ring = [maker.add(Circle(bead), at) for at in around]
        hub = maker.add(Circle(0.5 * bead), middle)
        for i in range(count):
            after, across = ring[(i + 1) % count], ring[(i + 2) % count]
            maker.spring(ring[i], after, 4.0 * frequency, damping_ratio, breaking_force)
            maker.spring(ring[i], across, 2.0 * frequency, damping_ratio, breaking_force)
            maker.spring(hub, ring[i], frequency, damping_ratio, breaking_force)
    return Soft((*ring, hub), tuple(maker.joints), tuple(ring))


@known_keywords
def jelly(
    world: World,
    at: Point,
    *,
    width: float = 2.0,
    height: float = 2.0,
    columns: int = 5,
    rows: int = 5,
    frequency: float = 6.0,
    damping_ratio: float = 0.3,
    breaking_force: float | None = None,
    add: Callable[..., Body] | None = None,
    **properties: Any,
) -> Soft:
    """A soft rectangle, or with many columns and rows a cloth: discs in a grid, springs to neighbours and across.

    >>> import evilengine as evil
    >>> world = evil.World()
    >>> jelly = evil.soft.jelly(world, (0, 3), columns=3, rows=2)
    >>> len(jelly.bodies), len(jelly.joints), len(jelly.outline)
    (6, 11, 6)
    """
    me = "soft.jelly"
    middle = place(at, me)
    across, up = _pieces(columns, me, "columns", 2), _pieces(rows, me, "rows", 2)
    width = number(width, me, "width", above=0.0, most=1e4)
    height = number(height, me, "height", above=0.0, most=1e4)
    frequency = number(frequency, me, "frequency", least=0.0, most=MOST_HERTZ)
    if across * up > MOST_PIECES:
        raise ArgumentError(f"{me}: columns={columns} times rows={rows} must be at most {MOST_PIECES}")
    bead = 0.5 * min(width / across, height / up)
    step_x, step_y = (width - 2 * bead) / (across - 1), (height - 2 * bead) / (up - 1)
    corner = middle - Vec2(0.5 * width - bead, 0.5 * height - bead)
    places = [[corner + Vec2(i * step_x, j * step_y) for i in range(across)] for j in range(up)]
    with _Maker(world, add, properties) as maker:
        grid = [[maker.add(Circle(bead), at) for at in row] for row in places]
        for j in range(up):
            for i in range(across):
                for di, dj in ((1, 0), (0, 1), (1, 1), (-1, 1)):
                    if 0 <= i + di < across and j + dj < up:
                        maker.spring(grid[j][i], grid[j + dj][i + di], frequency, damping_ratio, breaking_force)
    edge = [*grid[0], *(row[-1] for row in grid[1:-1]), *reversed(grid[-1]), *(row[0] for row in grid[-2:0:-1])]
    return Soft(tuple(body for row in grid for body in row), tuple(maker.joints), tuple(edge))


class _Maker:
    """Adds bodies and joints, and takes them back when one of them cannot be."""

    def __init__(self, world: World, add: Callable[..., Body] | None, properties: dict[str, Any]) -> None:
        if not isinstance(world, World):
            raise ArgumentTypeError(
                f"soft: world={world!r} must be a World; that of a game is game.world, and add=game.add lets it be seen"
            )
        if "at" in properties or "kind" in properties:
            raise ArgumentTypeError("soft: at and kind are given by the soft thing itself; move its bodies afterwards")
        self.world, self.properties = world, properties
        self._add = world.add if add is None else add
        self.bodies: list[Body] = []
        self.joints: list[Joint] = []

    def __enter__(self) -> _Maker:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if error is not None:
            for body in reversed(self.bodies):
                self.world._take_back(body)

    def add(self, shape: Capsule | Circle, at: Vec2) -> Body:
        body = self._add(shape, at=at, **self.properties)
        self.bodies.append(body)
        return body

    def join(self, joint: Joint) -> None:
        self.joints.append(self.world.add_joint(joint))

    def spring(self, a: Body, b: Body, frequency: float, damping_ratio: float, breaking_force: float | None) -> None:
        self.join(Distance(a, b, frequency=frequency, damping_ratio=damping_ratio, breaking_force=breaking_force))


def _pieces(value: int, owner: str, argument: str, least: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= MOST_PIECES:
        raise ArgumentError(f"{owner}: {argument}={value!r} must be a whole number from {least} to {MOST_PIECES}")
    return value
