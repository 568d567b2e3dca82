"""How still the pyramid stands: figures from where its boxes are after many steps, the same for every engine."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from evilengine.bench.peers import Placed
from evilengine.bench.physics import Measured, Numbers

Corner = tuple[float, float]


def corners_of(box: Placed, half: float = 0.5) -> list[Corner]:
    """The four corners of a square."""
    x, y, angle = box
    c, s = half * math.cos(angle), half * math.sin(angle)
    return [(x - c + s, y - s - c), (x + c + s, y + s - c), (x + c - s, y + s + c), (x - c - s, y - s + c)]


def overlap(a: Sequence[Corner], b: Sequence[Corner]) -> float:
    """How deep two convex polygons are in each other: the least over all edges' normals, 0 when they are apart."""
    return max(0.0, min(_least_reach(a, b), _least_reach(b, a)))


def _least_reach(a: Sequence[Corner], b: Sequence[Corner]) -> float:
    least = math.inf
    for (px, py), (qx, qy) in zip(a, [*a[1:], a[0]], strict=True):
        nx, ny = qy - py, px - qx
        length = math.hypot(nx, ny)
        least = min(least, -min((x - px) * nx + (y - py) * ny for x, y in b) / length)
    return least


def near_pairs(boxes: Sequence[Placed]) -> Iterator[tuple[int, int]]:
    """Pairs of unit squares that may overlap, found on a grid of cells as wide as their diagonals."""
    cells: dict[tuple[int, int], list[int]] = {}
    size = 1.5
    for number, (x, y, _) in enumerate(boxes):
        cells.setdefault((math.floor(x / size), math.floor(y / size)), []).append(number)
    for (i, j), here in cells.items():
        for di, dj in ((0, 0), (1, 0), (-1, 1), (0, 1), (1, 1)):
            for a in here:
                yield from ((a, b) for b in cells.get((i + di, j + dj), ()) if di or dj or b > a)


def pyramid_quality(before: Sequence[Placed], after: Sequence[Placed]) -> Numbers:
    """Figures of a pyramid on a floor whose top is y = 0. The ground comes first and is left out.

    "top_drop", "overlap" and "sideways" in metres, "tilt" in radians.
    """
    boxes, made = after[1:], before[1:]
    corners = [corners_of(box) for box in boxes]
    deepest = max((overlap(corners[a], corners[b]) for a, b in near_pairs(boxes)), default=0.0)
    into_floor = max(-min(y for _, y in four) for four in corners)
    top = max(range(len(made)), key=lambda i: made[i][1])
    return {
        "top_drop": made[top][1] - boxes[top][1],
        "overlap": max(deepest, into_floor),
        "sideways": max(abs(now[0] - then[0]) for now, then in zip(boxes, made, strict=True)),
        "tilt": max(abs(angle) for _, _, angle in boxes),
    }


def qualities(measured: Measured) -> Numbers:
    """The figures of each engine that ran the pyramid."""
    from evilengine.bench.scene import stage

    start = [(*body.position, body.angle) for body in stage(measured.scene, measured.size).world.bodies]
    return {runner.name: pyramid_quality(start, runner.placed()) for runner in measured.runners}
