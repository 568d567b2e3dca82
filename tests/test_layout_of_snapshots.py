"""The number of the snapshots' layout: bytes of one version are read by that version alone, and refused by all others.

golden/snapshot.bin was written by the engine as it is. When the layout of snapshots changes, raise kSnapshotVersion in
core/snapshot.hpp and write the file anew by `python tests/test_layout_of_snapshots.py`: a program of before and one of
now must not take each other's bytes for their own.
"""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

import evilengine as evil

GOLDEN = Path(__file__).with_name("golden") / "snapshot.bin"
VERSION_AT = 8  # after "EVILWRLD"


def world_with_one_of_each() -> evil.World:
    """A few bodies, each kind of shape and joint, forces, water, a character; after some steps, with contacts."""
    world = evil.World(gravity=(0, -10))
    floor = world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static", surface_speed=0.5, tag="floor")
    world.add(evil.Chain([(-9, 4), (-9, 0), (-7, 0)]), kind="static")
    world.add(evil.Segment((6, 0), (8, 1)), kind="static", one_way=(0, 1))
    world.add(evil.Polygon([(0, 0), (2, 0), (2, 2), (1, 0.5), (0, 2)]), at=(3, 0), friction=0.2)
    bodies = [world.add(evil.Capsule((-0.3, 0), (0.3, 0), 0.2), at=(i - 4, 3), group=-1) for i in range(8)]
    bodies[0].add_shape(evil.Circle(0.2), offset=(0, 0.3), sensor=True)
    j, (a, b, c, d, e, f, g, h) = evil.joints, bodies
    for joint in (
        j.Hinge(floor, a, at=a.position, motor_speed=1), j.Weld(a, b, frequency=4), j.Distance(b, c, frequency=2),
        j.Rope(c, d), j.Slider(floor, d), j.Wheel(d, e), j.Motor(floor, f), j.Gear(a, g),
        j.Pulley(g, h, (2, 6), (3, 6)),
    ):  # fmt: skip
        world.add_joint(joint)
    world.add_force(evil.Spring(to=(0, 5), stiffness=20), [e])
    world.add_force(evil.Drag(quadratic=0.1))
    world.add_force(evil.Medium((4, 0, 8, 1), density=1.2, linear=1))
    world.add_character(at=(-6, 1)).add_ladder((-6, 0, -5, 3))
    for _ in range(30):
        world.step()
    return world


def test_a_snapshot_of_this_version_is_read_and_written_as_ever() -> None:
    data = GOLDEN.read_bytes()
    now = world_with_one_of_each().snapshot()
    assert data[: VERSION_AT + 4] == now[: VERSION_AT + 4], "a new version: write golden/snapshot.bin anew"
    world = evil.World.of(data)
    assert world.snapshot() == data
    assert [type(joint) for joint in world.joints] == [type(joint) for joint in world_with_one_of_each().joints]
    world.step()


@pytest.mark.parametrize("other", [-1, 1, 1000])
def test_a_snapshot_of_another_version_is_refused_and_says_so(other: int) -> None:
    data = bytearray(world_with_one_of_each().snapshot())
    (version,) = struct.unpack_from("<I", data, VERSION_AT)
    struct.pack_into("<I", data, VERSION_AT, version + other)
    world = evil.World()
    before = world.snapshot()
    with pytest.raises(evil.SnapshotError, match="another version of the engine"):
        world.restore(bytes(data))
    assert world.snapshot() == before


if __name__ == "__main__":
    GOLDEN.write_bytes(world_with_one_of_each().snapshot())
