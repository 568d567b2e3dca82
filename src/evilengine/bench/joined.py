"""The scenes with joints, and those whose bodies know whom they meet and where they carry it."""

from __future__ import annotations

import math
import random

from evilengine.bench.figure import figure
from evilengine.bench.scene import Act, scene
from evilengine.bench.scenes import block, rounded
from evilengine.world.body import Body
from evilengine.world.joints import Hinge
from evilengine.world.shapes import Capsule, Chain, Circle, Polygon, Rectangle
from evilengine.world.world import World

NET, ALL_BUT_NET = 0b10, 0xFFFFFFFD


@scene(size=100, show=30, small=10, centre=(15, -14), height=36)
def joint_grid(world: World, size: int) -> Act | None:
    """A net of circles on hinges hangs from seven of them, 10,000 circles at size 100."""
    ball = Circle(0.4)
    bodies: list[Body] = []
    for column in range(size):
        for row in range(size):
            fixed = row == 0 and abs(column - size // 2) <= 3
            body = world.add(
                ball, at=(column, -row), kind="static" if fixed else "dynamic", category=NET, mask=ALL_BUT_NET
            )
            if row > 0:
                world.add_joint(Hinge(bodies[-1], body, at=(column, 0.5 - row)))
            if column > 0:
                world.add_joint(Hinge(bodies[-size], body, at=(column - 0.5, -row)))
            bodies.append(body)
    return None


@scene(size=160, show=60, small=12, centre=(0, -2), height=44)
def bridge(world: World, size: int) -> Act | None:
    """A bridge of planks on hinges, with circles and triangles on it."""
    half = 0.5 * size
    ground = world.add([block(-half - 2, -0.5, 4, 1), block(half + 2, -0.5, 4, 1)], kind="static")
    plank, before = Rectangle(1, 0.25), ground
    for i in range(size):
        body = world.add(plank, at=(i - half + 0.5, -0.125), density=20)
        world.add_joint(Hinge(before, body, at=(i - half, -0.125), motor_speed=0, max_torque=200))
        before = body
    world.add_joint(Hinge(before, ground, at=(half, -0.125), motor_speed=0, max_torque=200))
    ball, wedge = Circle(0.5), Polygon([(-0.5, 0), (0.5, 0), (0, 1.5)])
    for i in range(max(2, size // 6)):
        world.add(ball if i % 2 else wedge, at=(3 * (i - size // 12), 2 + i % 3))
    return None


def toothed(teeth: int) -> tuple[list[Circle | Polygon], float]:
    """A wheel with so many teeth a metre apart, and its radius where teeth meet."""
    radius = teeth / math.tau
    corners = ((-0.22, -0.4), (0.22, -0.4), (0.1, 0.38), (-0.1, 0.38))  # of a tooth that points up, on the rim
    shapes: list[Circle | Polygon] = [Circle(round(radius - 0.3, 4))]
    for tooth in range(teeth):
        angle = tooth * math.tau / teeth
        c, s = math.cos(angle), math.sin(angle)
        points = [rounded(c * (radius + y) - s * x, s * (radius + y) + c * x) for x, y in corners]
        shapes.append(Polygon(points))
    return shapes, radius


@scene(size=16, show=8, small=3, centre=(9, 1), height=26)
def gears(world: World, size: int) -> Act | None:
    """Toothed wheels turn each other, the first by a motor, and stones dance on them."""
    frame = world.add(block(0, -8, 400, 1), kind="static")
    x, turn, radius, luck = 0.0, 0.0, 0.0, random.Random(3)
    for number in range(size):
        wheel, next_radius = toothed((12, 20, 16)[number % 3])
        if number:
            x += radius + next_radius
            turn = math.pi - (radius * turn + 0.5) / next_radius  # its teeth between those of the wheel before
        radius = next_radius
        body = world.add(wheel, at=(round(x, 4), 0), angle=round(turn, 6), density=0.5, friction=0.1)
        driven = number == 0
        hinge = Hinge(
            frame, body, at=body.position, motor_speed=1 if driven else None, max_torque=20000 if driven else None
        )
        world.add_joint(hinge)
    for number in range(6 * size):
        stone = Circle(0.3) if number % 2 else Rectangle(0.6, 0.5)
        world.add(stone, at=rounded(luck.uniform(-2, x + 2), 5 + 0.3 * number % 12), friction=0.3)
    return None


@scene(size=60, show=18, small=3, centre=(0, 4.4), height=11)
def ragdoll(world: World, size: int) -> Act | None:
    """Figures of eleven limbs fall on each other."""
    world.add([block(0, -0.5, 8, 1), block(-4, 15, 1, 32), block(4, 15, 1, 32)], kind="static")
    for number in range(size):
        row, column = divmod(number, 3)
        figure(world, (2.0 * (column - 1) + 0.3 * (row % 2), 1 + 2.0 * row), number + 1)
    return None


ROWS, CROWD, EVERY = 5, 5, 8


@scene(size=40, show=6, small=1, centre=(0, 18), height=50, warm=160)
def rain(world: World, size: int) -> Act | None:
    """Figures rain on floors of tiles, five at a time in five rows; 1000 of them, 11,000 limbs, at size 40."""
    rows = ROWS if size > 10 else 1
    tiles = round(12.5 * size)
    step_apart = 0.5
    for row in range(rows):
        floor = [block(step_apart * (i - 0.5 * tiles), 0, 0.5, 0.5) for i in range(tiles + 1)]
        world.add(floor, at=(0, 45 * row), kind="static")
    columns: list[list[Body]] = [[] for _ in range(size)]
    span = tiles * step_apart
    every = EVERY * max(1, 40 // size)  # few columns are filled again as seldom as many

    def pour(world: World, step: int) -> None:
        if step % every:
            return
        column = step // every % size
        for limb in columns[column]:
            limb.destroy()
        columns[column] = []
        left = -0.5 * span + span / size * (column + 0.5)
        for row in range(rows):
            for i in range(CROWD):
                columns[column] += figure(world, (left + 0.5 * i, (40 if rows > 1 else 20) + 45 * row), i + 1)

    return pour


@scene(size=3038, show=900, small=120, centre=(0, 32), height=84, warm=100)
def spinner(world: World, size: int) -> Act | None:
    """A bar on a motor stirs capsules, circles and squares in a ring of 360 segments, 3038 of them."""
    angles = [-math.tau * i / 360 for i in range(360)]
    points = [rounded(40 * math.cos(angle), 40 * math.sin(angle) + 32) for angle in angles]
    drum = world.add(Chain(points, loop=True), kind="static", friction=0.1)
    bar = world.add(Rectangle(1.2, 40.4, rounding=0.2), at=(0, 12), friction=0)
    world.add_joint(Hinge(drum, bar, at=(0, 12), motor_speed=5, max_torque=40000))
    forms = (Capsule((-0.25, 0), (0.25, 0), 0.25), Circle(0.35), Rectangle(0.7, 0.7))
    for i in range(size):
        row, column = divmod(i, 49)
        world.add(forms[i % 3], at=(column - 24, row + 2), friction=0.1, restitution=0.1, density=0.25)
    return None


@scene(size=12, show=6, small=2, centre=(0, 14), height=32)
def conveyor(world: World, size: int) -> Act | None:
    """Belts carry parcels to and fro, and down."""
    for belt in range(size):
        side = 1 if belt % 2 else -1
        world.add(Rectangle(16, 0.4), at=(2.0 * side, 4 * belt + 2), kind="static", surface_speed=-3.0 * side)
    luck = random.Random(4)
    parcels: list[Body] = []

    def drop(world: World, step: int) -> None:
        if step % 20:
            return
        if len(parcels) == 14 * size:
            parcels.pop(0).destroy()
        side = 1 if size % 2 == 0 else -1
        across, width, height = (round(luck.uniform(0.5, 1), 3) for _ in range(3))
        parcel = Circle(0.4) if step % 60 == 0 else Rectangle(width, height)
        parcels.append(world.add(parcel, at=(2 * side + across, 4 * size + 2), friction=0.8))

    return drop
