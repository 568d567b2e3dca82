"""What Python pays: making bodies, reading them, casting rays, and the memory they take."""

from __future__ import annotations

import ctypes
import gc
import random
import timeit
from array import array
from collections.abc import Callable, Iterable, Sequence
from typing import Any, cast

from evilengine.bench.peers import Peer
from evilengine.bench.physics import Numbers, Ours, Tell
from evilengine.bench.scene import STEP, find
from evilengine.bench.timing import best
from evilengine.world.shapes import Rectangle
from evilengine.world.world import World

COUNT = 5050
REPEATS = 7
RAYS = 2000

Point = tuple[float, float]


def one_by_one(count: int = COUNT) -> World:
    """So many unit boxes, each by a call."""
    world, box = World((0.0, -10.0)), Rectangle(1, 1)
    add = world.add
    for i in range(count):
        add(box, at=(2.0 * i, 0.0))
    return world


def all_at_once(places: array[float]) -> World:
    """A unit box at each place, by one call."""
    world = World((0.0, -10.0))
    world.add_many(Rectangle(1, 1), places)
    return world


def reading(peers: Iterable[type[Peer]]) -> Numbers:
    """Milliseconds to make 5050 bodies, nanoseconds to read a position, microseconds to see all of them."""
    world = one_by_one()
    body = next(iter(world.bodies))
    places = array("f", (value for i in range(COUNT) for value in (2.0 * i, 0.0)))
    numbers: Numbers = {
        "evil": {
            "create_ms": 1e3 * best(one_by_one, REPEATS),
            "create_batch_ms": 1e3 * best(lambda: all_at_once(places), REPEATS),
            "position_ns": nanoseconds(lambda: body.position),
            "all_positions_us": 1e6 * best(lambda: memoryview(cast(bytes, world.bodies.positions)), 100),
        }
    }
    for peer in peers:
        made, bodies = peer.boxes(COUNT)
        one, position = bodies[0], peer.position
        numbers[peer.name] = {
            "create_ms": 1e3 * best(lambda make=peer.boxes: make(COUNT), REPEATS),  # type: ignore[misc]
            "position_ns": nanoseconds(lambda one=one, position=position: position(one))  # type: ignore[misc]
            - nanoseconds(lambda one=one: same(one)),  # type: ignore[misc]
        }
        del made
    return numbers


def same(one: Any) -> object:
    return one


def nanoseconds(call: Callable[[], object], rounds: int = 50_000) -> float:
    """Nanoseconds of a call, the loop's own share taken out."""

    def least(function: Callable[[], object]) -> float:
        return min(timeit.repeat(function, number=rounds, repeat=7))

    return (least(call) - least(lambda: None)) / rounds * 1e9


def some_rays(count: int = RAYS) -> tuple[list[Point], list[Point]]:
    """Segments from everywhere to everywhere over the settled pile."""
    luck = random.Random(7)
    starts = [(luck.uniform(-30, 30), luck.uniform(0, 60)) for _ in range(count)]
    return starts, [(luck.uniform(-30, 30), luck.uniform(0, 60)) for _ in range(count)]


def casting(peers: Iterable[type[Peer]], tell: Tell, warm: int = 300) -> Numbers:
    """Microseconds of a ray into the settled pile, and how many of all hit."""
    scene = find("pile")
    tell(f"rays: a pile of {scene.size} settles")
    ours = Ours(scene, scene.size, 4)
    starts, ends = some_rays()
    for _ in range(warm):
        ours.prepare()
        ours.step()
    world = ours.staged.world
    numbers: Numbers = {"evil": ray_numbers(lambda a, b: world.ray_cast(a, b) is not None, starts, ends)}
    tables = [table_of(points) for points in (starts, ends)]
    numbers["evil"]["ray_batch_us"] = 1e6 * best(lambda: world.ray_casts(*tables), 20) / len(starts)
    for kind in peers:
        peer = kind(scene, scene.size)
        for _ in range(warm):
            peer.step()
        numbers[kind.name] = ray_numbers(peer.ray, starts, ends)  # type: ignore[arg-type]
    return numbers


def table_of(points: Sequence[Point]) -> memoryview[float]:
    """Points as an array of float32 with two columns."""
    flat = array("f", (value for point in points for value in point))
    return memoryview(flat).cast("B").cast("f", (len(points), 2))


def ray_numbers(ray: Callable[[Point, Point], bool], starts: Sequence[Point], ends: Sequence[Point]) -> Numbers:
    def all_of_them() -> None:
        for start, end in zip(starts, ends, strict=True):
            ray(start, end)

    hits = sum(ray(start, end) for start, end in zip(starts, ends, strict=True))
    return {"ray_us": 1e6 * best(all_of_them, 5) / len(starts), "hits": hits}


def allocated() -> int | None:
    """Bytes that C and C++ hold, as glibc counts them; None elsewhere. Python's small objects are not among them."""
    fields = ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")

    class Mallinfo2(ctypes.Structure):
        _fields_ = [(field, ctypes.c_size_t) for field in fields]

    try:
        mallinfo2 = ctypes.CDLL(None).mallinfo2
    except (AttributeError, OSError, TypeError):
        return None
    mallinfo2.restype = Mallinfo2
    info = mallinfo2()
    return int(info.uordblks + info.hblkhd)


def memory() -> Numbers | None:
    """Bytes of the core for a body that touches nothing, and for a contact of the pyramid, as its bodies take them."""
    pyramid = find("pyramid")
    count = len(Ours(pyramid, pyramid.size, 4).staged.world.bodies)
    apart = held(lambda: one_by_one(count))
    together = held(lambda: Ours(pyramid, pyramid.size, 4).staged.world)
    if apart is None or together is None:
        return None
    return {"body_bytes": apart[0] / count, "contact_bytes": (together[0] - apart[0]) / together[1]}


def held(make: Callable[[], World]) -> tuple[int, int] | None:
    """Bytes that a world holds after a few steps, and how many contacts it has."""
    gc.collect()
    before = allocated()
    world = make()
    for _ in range(3):
        world.step(STEP)
    after = allocated()
    if before is None or after is None:
        return None
    return after - before, len(world.contacts.active)
