"""Read by mypy, never run: handles of different kinds cannot be mixed up.

Each line below is a mistake, and says which; mypy complains about a line that it finds nothing wrong with.
"""

import evilengine as evil


def mistakes(world: evil.World, body: evil.Body, shape: evil.Shape, force: evil.Spring) -> None:
    a: evil.Body = shape  # type: ignore[assignment]
    b: evil.Shape = body  # type: ignore[assignment]
    c: evil.Body = force  # type: ignore[assignment]
    world.add(body)  # type: ignore[arg-type]
    world.add(evil.Circle)  # type: ignore[arg-type]
    world.add(evil.Circle(1), at=1)  # type: ignore[arg-type]
    world.add(evil.Circle(1), color="red")  # type: ignore[call-arg]
    world.add_force(shape)  # type: ignore[type-var]
    world.add_force(force, [shape])  # type: ignore[list-item]
    body.add_shape(shape)  # type: ignore[arg-type]
    evil.Spring(to=shape)  # type: ignore[arg-type]
    body.position = 3  # type: ignore[assignment]
    body.angle = (0, 1)  # type: ignore[assignment]
    body.touchable = "yes"  # type: ignore[assignment]
    body.apply_force(5)  # type: ignore[call-overload]
    body.apply_force((0, 1), point=(0, 0))  # type: ignore[call-overload]
    print(a, b, c)
