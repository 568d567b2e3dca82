"""The scenes of bodies and contacts. Their numbers are those of Box2D's benchmarks, where it has the same scene.

`size` is the one number that a scene grows by; each says what it counts. Corners are rounded to a tenth of a
millimetre, so that a scene is the same wherever the trigonometry that made it comes from.
"""

from __future__ import annotations

import math
import random

from evilengine.bench.scene import STEP, Act, scene
from evilengine.world.body import Body
from evilengine.world.shapes import Circle, Polygon, Rectangle, Segment
from evilengine.world.world import World

TURN = math.radians(25.0)  # radians a second of the drums, as in Box2D's


def rounded(x: float, y: float) -> tuple[float, float]:
    return round(x, 4), round(y, 4)


def block(x: float, y: float, width: float, height: float) -> Polygon:
    """A rectangle with its centre at (x, y) of the body's frame."""
    w, h = 0.5 * width, 0.5 * height
    return Polygon([rounded(x + i, y + j) for i, j in ((-w, -h), (w, -h), (w, h), (-w, h))])


def pyramid_of(world: World, base: int, left: float, bottom: float) -> None:
    """Unit boxes, `base` of them in the lowest row."""
    box = Rectangle(1, 1)
    for row in range(base):
        for place in range(base - row):
            world.add(box, at=(left + 0.5 * (row + 1) + place, bottom + row + 0.5))


@scene(size=100, show=40, small=10, centre=(0, 18), height=46, steps=600)
def pyramid(world: World, size: int) -> Act | None:
    """A pyramid of boxes, 5050 at base 100."""
    world.add(Rectangle(200, 2), at=(0, -1), kind="static")
    pyramid_of(world, size, -0.5 * size, 0.0)
    return None


@scene(size=20, show=5, small=2, centre=(0, 25), height=62)
def many_pyramids(world: World, size: int) -> Act | None:
    """Pyramids of base 10 in rows and columns, 22,000 boxes at size 20."""
    base = 10
    width = size * (base + 1.0)
    for row in range(size):
        bottom = row * (base + 1.0)
        world.add(Segment((-width, bottom), (width, bottom)), kind="static")
        for column in range(size):
            pyramid_of(world, base, -0.5 * width + column * (base + 1.0), bottom)
    return None


@scene(size=45, show=24, small=8, centre=(0, 10), height=26, warm=200)
def tumbler(world: World, size: int) -> Act | None:
    """Small boxes in a square drum that turns, 2025 at size 45."""
    walls = [block(10, 0, 1, 20), block(-10, 0, 1, 20), block(0, 10, 20, 1), block(0, -10, 20, 1)]
    world.add(walls, at=(0, 10), kind="kinematic", density=50, angular_velocity=TURN)
    box = Rectangle(0.25, 0.25)
    for row in range(size):
        for column in range(size):
            world.add(box, at=(0.4 * column - 0.2 * size, 0.4 * row - 0.2 * size + 10))
    return None


def ring(inner: float, outer: float, start: float, end: float) -> Polygon:
    """A piece of a ring, between two angles in degrees."""
    a, b = math.radians(start), math.radians(end)
    corners = ((inner, a), (outer, a), (outer, b), (inner, b))
    return Polygon([rounded(r * math.cos(angle), r * math.sin(angle)) for r, angle in corners])


@scene(size=90, show=36, small=10, centre=(0, 10), height=42, warm=150)
def washer(world: World, size: int) -> Act | None:
    """Small boxes in a round drum with four paddles, 8100 at size 90."""
    pieces = [ring(16, 18, 10 * i - 1, 10 * i + 11) for i in range(36)]
    pieces += [ring(14, 16, 90 * i, 90 * i + 10) for i in range(4)]
    world.add(pieces, at=(0, 10), kind="kinematic", velocity=(0.001, -0.002), angular_velocity=TURN)
    box, pitch = Rectangle(0.2, 0.2), 0.21
    for row in range(size):
        for column in range(size):
            world.add(box, at=(pitch * column - 0.11 * size, pitch * row - 0.11 * size + 10))
    return None


def convex(luck: random.Random, radius: float, corners: int) -> Polygon:
    """Corners on a circle, so that it is convex however they lie."""
    angles = [(corner + 0.6 * luck.random()) * math.tau / corners for corner in range(corners)]
    return Polygon([rounded(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles])


@scene(size=2000, show=600, small=100, centre=(0, 10), height=40, warm=300)
def pile(world: World, size: int) -> Act | None:
    """Circles and convex polygons of 3 to 8 corners heap up in a bin."""
    heap(world, size, max(4, round(38 * math.sqrt(size / 2000))))
    return None


def heap(world: World, size: int, columns: int) -> None:
    """Stones over a bin with room for so many beside each other."""
    luck = random.Random(1)
    width = 60 * columns / 38
    height = 2.5 * size / columns + 4
    walls = [block(0, -0.5, width + 2, 1)]
    walls += [block(side * (0.5 * width + 0.5), 0.5 * height, 1, height) for side in (-1, 1)]
    world.add(walls, kind="static", friction=0.5)
    for i in range(size):
        row, column = divmod(i, columns)
        at = rounded(1.5 * (column - 0.5 * (columns - 1)) + luck.uniform(-0.1, 0.1), 1 + 1.5 * row)
        if i % 2:
            stone = convex(luck, luck.uniform(0.4, 0.7), luck.randint(3, 8))
            world.add(stone, at=at, angle=round(luck.uniform(0, math.tau), 4), friction=0.5)
        else:
            world.add(Circle(round(luck.uniform(0.3, 0.6), 4)), at=at, friction=0.5)


@scene(size=8000, show=1000, small=60, centre=(45, 30), height=70, gravity=(0.0, 0.0))
def sparse(world: World, size: int) -> Act | None:
    """Circles and boxes that drift about and seldom meet."""
    luck = random.Random(2)
    columns = max(1, round(math.sqrt(1.5 * size)))
    ball, box = Circle(0.4), Rectangle(0.8, 0.6)
    for i in range(size):
        row, column = divmod(i, columns)
        velocity = rounded(luck.uniform(-1, 1), luck.uniform(-1, 1))
        world.add(box if i % 2 else ball, at=(2.5 * column, 2.5 * row), velocity=velocity, angular_velocity=1)
    return None


def bin_of_tiles(world: World, half: int, wall: int) -> None:
    """A floor and two walls of one body, tile by tile."""
    tiles = [block(x, 0, 1.1, 1) for x in range(-half, half + 1)]
    for side in (-half, half):
        tiles += [block(side, 1 + y, 1, 1.1) for y in range(wall)]
    world.add(tiles, kind="static")


@scene(size=20, show=12, small=4, centre=(0, 18), height=44, warm=150)
def compounds(world: World, size: int) -> Act | None:
    """Darts of two triangles each fall into a bin of tiles, 3000 at size 20."""
    bin_of_tiles(world, 40, 100)
    dart = [Polygon([(-1, 0), (0.5, 1), (0, 2)]), Polygon([(1, 0), (0, 2), (-0.5, 1)])]
    side = 0.25
    for column in range(size):
        for row in range(150 * size // 20):
            world.add(dart, at=(2 * column - size + 1 + side, 2.25 * row + 5.575), friction=0.5)
            side = -side
    return None


@scene(size=40, show=8, small=2, centre=(0, 14), height=60, warm=100)
def junkyard(world: World, size: int) -> Act | None:
    """A wall pushes through a heap of five-cornered junk, 8000 pieces at size 40."""
    bin_of_tiles(world, 80, 50)
    turn = math.pi * (math.sqrt(5.0) - 1.0)
    angles = sorted(i * turn % math.tau for i in range(5))
    junk = Polygon([rounded(0.25 * math.cos(angle), 0.25 * math.sin(angle)) for angle in angles])
    side = -0.1
    for column in range(200):
        for row in range(size):
            world.add(junk, at=(0.75 * (column - 100) + side, row + 15))
            side = -side
    pusher = world.add(block(0, 4, 4, 8), kind="kinematic")

    def push(world: World, step: int) -> None:
        here, there = (round(60.0 * math.sin(0.2 * STEP * count), 4) for count in (step, step + 1))
        pusher.velocity = ((there - here) / STEP, 0.0)

    return push


@scene(size=120, show=40, small=10, centre=(15, 0), height=50, gravity=(0.0, 0.0))
def smash(world: World, size: int) -> Act | None:
    """A heavy block flies into a wall of small boxes that nothing holds, 9600 at size 120."""
    world.add(Rectangle(8, 8), at=(-20, 0), velocity=(40, 0), density=8)
    box, rows = Rectangle(0.4, 0.4), 2 * size // 3
    for column in range(size):
        for row in range(rows):
            world.add(box, at=(0.4 * column + 30, 0.4 * (row - 0.5 * rows)))
    return None


@scene(size=12, show=6, small=4, centre=(0, 4), height=12)
def card_house(world: World, size: int) -> Act | None:
    """Houses of cards, thin and leaning on each other, with `size` storeys."""
    world.add(Rectangle(80, 2), at=(0, -1), kind="static", friction=0.7)
    length, thick, lean = 0.8, 0.04, math.radians(25.0)
    run, rise = length * math.sin(lean), length * math.cos(lean) + thick * math.sin(lean)
    half = run + thick * math.cos(lean)  # from where two cards meet to their outermost edge
    card, flat = Rectangle(thick, length), Rectangle(round(2 * half - 0.005, 4), thick)
    for storey in range(size):
        bottom, pairs = storey * (rise + thick), size - storey
        for pair in range(pairs):
            x = (2 * pair - pairs + 1) * (half + 0.0025)
            for side in (-1, 1):
                at = rounded(x + side * 0.5 * half, bottom + 0.5 * rise)
                world.add(card, at=at, angle=round(side * lean, 4), friction=0.7)
            if pair:
                world.add(flat, at=rounded(x - half - 0.0025, bottom + rise + 0.5 * thick), friction=0.7)
    return None


@scene(size=60, show=24, small=6, centre=(0, 8), height=30)
def bullets(world: World, size: int) -> Act | None:
    """Bullets at 400 m/s, one every other step, hit planks and a thin wall; `size` of them at a time."""
    world.add(Rectangle(120, 1), at=(0, -0.5), kind="static")
    world.add(Rectangle(0.1, 20), at=(24, 10), kind="static")
    world.add(Rectangle(0.1, 20), at=(-24, 10), kind="static")
    plank = Rectangle(0.1, 2)
    for column in range(6):
        for row in range(6):
            world.add(plank, at=(2.5 * column - 4, 1 + 2 * row), density=2)
    shot = Circle(0.05)
    flying: list[Body] = []

    def shoot(world: World, step: int) -> None:
        if step % 2:
            return
        if len(flying) == size:
            flying.pop(0).destroy()
        height = 0.5 + (step * 7 % 23) * 0.5
        flying.append(world.add(shot, at=(-20, height), velocity=(400, 0), density=20, bullet=True))

    return shoot
