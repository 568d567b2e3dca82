"""Bodies of many shapes: built one by one in a time that grows with their number, and weighed as if built at once."""

from __future__ import annotations

import random
import time

import pytest

import evilengine as evil


def weight(body: evil.Body) -> tuple[float, ...]:
    return body.mass, body.inertia, *body.centre


def some_shape(chance: random.Random) -> evil.Circle | evil.Rectangle:
    return evil.Circle(chance.uniform(0.1, 2)) if chance.random() < 0.5 else evil.Rectangle(1, chance.uniform(0.2, 3))


@pytest.mark.parametrize("seed", range(20))
def test_a_body_that_is_changed_at_random_weighs_as_one_built_anew(seed: int) -> None:
    chance = random.Random(seed)
    world = evil.World()
    bodies = [world.add(some_shape(chance)) for _ in range(2)]
    saved = world.snapshot()
    for _ in range(60):
        body = chance.choice(bodies)
        what = chance.choice(["add", "add", "add", "add", "density", "destroy", "scale", "refused", "new", "restore"])
        if what == "add":
            body.add_shape(some_shape(chance), offset=(chance.uniform(-5, 5), chance.uniform(-5, 5)))
        elif what == "density":
            chance.choice(body.shapes).density = chance.uniform(0.5, 3)
        elif what == "destroy" and len(body.shapes) > 1:
            chance.choice(body.shapes).destroy()
        elif what == "scale":
            body.apply_matrix(evil.Mat4.scale(chance.choice([0.5, 2.0])))
        elif what == "refused":
            with pytest.raises(evil.ShapeError):
                body.add_shape(evil.Circle(5e4), density=1e9)
        elif what == "new":
            bodies.remove(body)
            body.destroy()
            bodies.append(world.add(some_shape(chance)))
            for _ in range(chance.randrange(3)):
                bodies[-1].add_shape(some_shape(chance), offset=(1, chance.random()))
        elif what == "restore":
            if chance.random() < 0.5:
                saved = world.snapshot()
            world.restore(saved)
            bodies = list(world.bodies)
    for body in bodies:
        found = weight(body)
        body.shapes[0].density = body.shapes[0].density  # weighs all of them
        assert weight(body) == found


def test_the_time_to_add_shapes_one_by_one_grows_with_their_number() -> None:
    def seconds(count: int) -> float:
        body = evil.World().add(evil.Circle(0.1))
        ball = evil.Circle(0.1)
        start = time.process_time()
        for i in range(count):
            body.add_shape(ball, offset=(0.3 * i, 0))
        return time.process_time() - start

    few, many = (min(seconds(count) for _ in range(3)) for count in (500, 8000))
    assert many < 40 * few  # 16 times as many; were each to weigh all, it would be 80 times the time
