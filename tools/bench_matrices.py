#!/usr/bin/env python3
"""What batches of matrices cost on this machine, one float at a time and with each instruction set.

python tools/bench_matrices.py [points]
"""

from __future__ import annotations

import sys
import time
from array import array
from collections.abc import Callable
from functools import partial
from typing import Any

from evilengine import _core
from evilengine.math import Mat4

SECONDS = 0.2  # per measurement; the least of many rounds is taken, as others use the machine too


def least(work: Callable[[], object]) -> float:
    """Seconds of the quickest round of `work`."""
    best, until = float("inf"), time.perf_counter() + SECONDS
    while time.perf_counter() < until:
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return best


def rows(count: int, width: int) -> Any:
    numbers = array("f", (0.25 * (i % 97) for i in range(count * width)))
    return memoryview(numbers).cast("B").cast("f", (count, width))


def one_by_one(matrix: Mat4, points: list[tuple[float, float]]) -> None:
    for point in points:
        matrix @ point


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    matrix = Mat4.translation(1, 2) @ Mat4.rotation(0.5)
    listed = [(0.25 * i, 1.0) for i in range(count)]
    points, vectors, many = rows(count, 2), rows(count, 4), rows(count, 16)
    print(f"{count} rows, ns each{'':14}" + "".join(f"{name:>9}" for name in _core.instruction_sets()) + "    ratio")
    for title, kernel, a, b in (
        ("matrix x points (n, 2)", _core.transform, matrix, points),
        ("matrix x vectors (n, 4)", _core.transform, matrix, vectors),
        ("matrix x matrices (n, 16)", _core.multiply, matrix, many),
        ("matrices x matrices", _core.multiply, many, many),
    ):
        costs = [least(partial(kernel, a, b, name)) / count * 1e9 for name in _core.instruction_sets()]
        print(f"{title:32}" + "".join(f"{cost:9.2f}" for cost in costs) + f"{costs[0] / costs[-1]:9.1f}")
    one = least(partial(one_by_one, matrix, listed)) / count * 1e9
    print(f"{'matrix @ point, one by one':32}{one:9.0f}")


if __name__ == "__main__":
    main()
