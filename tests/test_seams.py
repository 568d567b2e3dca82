"""No ghost hits: what slides over tiles, over the parts of a polygon or along a chain does not feel where they meet."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import evilengine as evil
from evilengine.world.shapes import ShapeDefinition

TILES = range(-2, 101)


def boxes(world: evil.World, kind: str = "static") -> None:
    for i in TILES:
        world.add(evil.Rectangle(1, 1), at=(i + 0.5, -0.5), kind=kind)


def boxes_of_odd_sizes(world: evil.World) -> None:
    left = -2.0
    for i in range(300):
        width = (1 / 3, 0.7, 0.1)[i % 3]
        world.add(
            evil.Rectangle(width, 0.4 + 0.1 * (i % 5)), at=(left + width / 2, -0.2 - 0.05 * (i % 5)), kind="static"
        )
        left += width


def boxes_of_one_body(world: evil.World) -> None:
    body = world.add(evil.Rectangle(1, 1), at=(-1.5, -0.5), kind="kinematic")
    for i in range(1, len(TILES)):
        body.add_shape(evil.Rectangle(1, 1), offset=(i, 0))


def segments(world: evil.World) -> None:
    for i in TILES:
        world.add(evil.Segment((0, 0), (1, 0)), at=(i, 0), kind="static")


def chain(world: evil.World) -> None:
    world.add(evil.Chain([(i, 0) for i in TILES]), kind="static")


def comb(world: evil.World) -> None:
    """A concave polygon: a flat top over many teeth, cut into parts that meet under it."""
    corners = [(100.0, 0.0), (-2.0, 0.0)]
    for i in range(-2, 99, 3):
        corners += [(i + 0.2, -1.0), (i + 1.5, -0.3)]
    world.add(evil.Polygon(corners), kind="static")


FLOORS = [boxes, boxes_of_odd_sizes, boxes_of_one_body, segments, chain, comb]
SLIDERS: list[tuple[ShapeDefinition, float]] = [
    (evil.Circle(0.5), 0.5),
    (evil.Circle(0.1), 0.1),
    (evil.Rectangle(1, 1), 0.5),
    (evil.Rectangle(0.2, 0.2), 0.1),
    (evil.Capsule((-0.5, 0), (0.5, 0), 0.3), 0.3),
    (evil.Rectangle(0.8, 0.8, rounding=0.15), 0.4),
    (evil.Polygon([(-0.5, -0.3), (0.5, -0.3), (0.6, 0.3), (0, 0.6), (-0.6, 0.3)]), 0.3),
]


ROUND = [(slider, height) for slider, height in SLIDERS if isinstance(slider, evil.Circle | evil.Capsule)]


@pytest.mark.parametrize("speed", [2, 9, 40])
@pytest.mark.parametrize(("slider", "height"), SLIDERS, ids=lambda value: repr(value))
@pytest.mark.parametrize("floor", FLOORS)
def test_nothing_bumps_where_tiles_meet(
    floor: Callable[[evil.World], None], slider: ShapeDefinition, height: float, speed: float
) -> None:
    world = evil.World()
    floor(world)
    body = world.add(slider, at=(0, height), velocity=(speed, 0), friction=0)
    for _ in range(round(min(400, 95 / speed * 60))):
        world.step(1 / 60)
        assert -0.006 < body.position.y - height < 0.001
        assert body.velocity.x == pytest.approx(speed, rel=2e-3)
        assert abs(body.velocity.y) < 0.05
        assert abs(body.angle) < 0.01 or isinstance(slider, evil.Circle)


@pytest.mark.parametrize("upward", [True, False])
def test_a_chain_is_smooth_from_either_side(upward: bool) -> None:
    world = evil.World(gravity=(0, -10 if upward else 10))
    hills = [(x, 0.3 * math.cos(x)) for x in (i / 4 for i in range(400))]
    world.add(evil.Chain(hills), kind="static", friction=0)
    side = 1 if upward else -1
    ball = world.add(evil.Circle(0.2), at=(1.0, 0.3 * math.cos(1.0) + 0.21 * side), velocity=(4, 0), friction=0)
    energy: Callable[[], float] = lambda: 0.5 * ball.velocity.length**2 + side * 10 * ball.position.y  # noqa: E731
    start = energy()
    for _ in range(900):
        world.step(1 / 60, substeps=8)
        assert energy() > 0.6 * start
    assert ball.position.x > 25


def test_a_ball_rolls_on_tiles_as_on_one_plank() -> None:
    ends = []
    for whole in (True, False):
        world = evil.World()
        if whole:
            world.add(evil.Rectangle(103, 1), at=(49.5, -0.5), kind="static")
        else:
            boxes(world)
        ball = world.add(evil.Circle(0.3), at=(0, 0.3), velocity=(6, 0))
        for _ in range(600):
            world.step(1 / 60)
        ends.append((ball.position.x, ball.velocity.x, ball.angular_velocity))
    assert ends[0] == pytest.approx(ends[1], rel=1e-3)


def test_a_box_goes_over_the_edge_of_tiles_as_over_the_edge_of_a_plank() -> None:
    paths = []
    for whole in (True, False):
        world = evil.World()
        if whole:
            world.add(evil.Rectangle(4, 1), at=(2, -0.5), kind="static")
        else:
            for i in range(8):
                world.add(evil.Rectangle(0.5, 1), at=(0.5 * i + 0.25, -0.5), kind="static")
        box = world.add(evil.Rectangle(1, 1), at=(1, 0.5), velocity=(1.5, 0), friction=0)
        path = []
        for _ in range(160):
            world.step(1 / 60)
            path.append((box.position.x, box.position.y, box.angle))
        paths.append(path)
    assert paths[0][-1][1] < -0.2  # it fell, turning
    assert abs(paths[0][-1][2]) > 0.2
    for one, other in zip(*paths, strict=True):
        assert one == pytest.approx(other, abs=0.05)


@pytest.mark.parametrize("bend", [0.02, 0.1, 0.3, 0.6])
@pytest.mark.parametrize(("slider", "height"), ROUND, ids=lambda value: repr(value))
def test_round_things_go_over_tiles_that_bend_uphill_as_over_a_chain(
    slider: ShapeDefinition, height: float, bend: float
) -> None:
    def speed_after(tiles: bool) -> float:
        world = evil.World()
        uphill = (math.cos(bend), math.sin(bend))
        if tiles:
            tops = [((float(x), 0.0), (x + 1.0, 0.0)) for x in range(-4, 0)]
            tops += [((x * uphill[0], x * uphill[1]), ((x + 1) * uphill[0], (x + 1) * uphill[1])) for x in range(6)]
            for (ax, ay), (bx, by) in tops:
                world.add(evil.Polygon([(ax, ay), (ax, ay - 1), (bx, by - 1), (bx, by)]), kind="static")
        else:
            world.add(evil.Chain([(-4, 0), (0, 0), (6 * uphill[0], 6 * uphill[1])]), kind="static")
        body = world.add(slider, at=(-2, height), velocity=(6, 0), friction=0)
        for _ in range(40):
            world.step(1 / 60)
        return body.velocity.length

    assert speed_after(True) == pytest.approx(speed_after(False), rel=0.02)


@pytest.mark.parametrize("degrees", [46, 60, 80, 89, 90, 100])
@pytest.mark.parametrize(("slider", "height"), [*SLIDERS, (evil.Polygon([(-0.6, 0), (0.6, 0), (-0.6, 0.5)]), 0.0)])
def test_a_wall_that_goes_on_under_the_floor_still_stops(slider: ShapeDefinition, height: float, degrees: int) -> None:
    world = evil.World()
    top = (6 * math.cos(math.radians(degrees)), 6 * math.sin(math.radians(degrees)))
    world.add(evil.Polygon([(-9, 0), (-9, -1), (0, -1), (0, 0)]), kind="static")
    world.add(evil.Polygon([(0, 0), (0, -1), (7, -1), (7, top[1]), top]), kind="static")
    body = world.add(slider, at=(-2, height), velocity=(5, 0), friction=0.3)
    for _ in range(120):
        body.apply_force((20 * body.mass, 0))
        world.step(1 / 60)
        assert max((contact.depth for contact in world.contacts.active), default=0.0) < 0.02


@pytest.mark.parametrize("corner", ["floor and wall", "valley", "chain valley"])
def test_a_real_corner_holds_what_is_pushed_into_it(corner: str) -> None:
    world = evil.World()
    if corner == "floor and wall":
        world.add(evil.Rectangle(10, 1), at=(-5, -0.5), kind="static")
        world.add(evil.Rectangle(1, 5), at=(0.5, 2.5), kind="static")
    elif corner == "valley":
        for side in (1, -1):
            world.add(evil.Rectangle(4, 1), at=(side * 1.4142, 1), angle=side * math.pi / 4, kind="static")
    else:
        world.add(evil.Chain([(-3, 3), (0, 0), (3, 3)]), kind="static")
    angle = 0.0 if corner == "floor and wall" else math.pi / 4
    at = (-0.6, 0.5) if corner == "floor and wall" else (0.0, 2.2)
    box = world.add(evil.Rectangle(1, 1), at=at, angle=angle, velocity=(1, -1))
    for _ in range(240):
        box.apply_force((5, 0) if corner == "floor and wall" else (0, 0))
        world.step(1 / 60)
    assert box.velocity.length < 0.01
    assert box.angle == pytest.approx(angle, abs=0.01)
    if corner == "floor and wall":
        assert tuple(box.position) == pytest.approx((-0.5, 0.5), abs=0.01)


def test_a_step_higher_than_the_slop_still_stops() -> None:
    world = evil.World()
    for i in range(10):
        world.add(evil.Rectangle(1, 1), at=(i + 0.5, -0.5 if i < 5 else -0.4), kind="static")
    box = world.add(evil.Rectangle(1, 1), at=(1, 0.5), velocity=(3, 0), friction=0)
    for _ in range(120):
        world.step(1 / 60)
    assert box.position.x < 4.6


def test_tiles_that_go_leave_a_hole_to_fall_into() -> None:
    world = evil.World()
    tiles = [world.add(evil.Rectangle(1, 1), at=(i + 0.5, -0.5), kind="static") for i in range(5)]
    box = world.add(evil.Rectangle(0.6, 0.6), at=(3.0, 0.3))  # over the seam of two
    for _ in range(120):
        world.step(1 / 60)
    assert not box.awake
    tiles[2].destroy()
    tiles[3].destroy()
    for _ in range(60):
        world.step(1 / 60)
    assert box.position.y < -1
