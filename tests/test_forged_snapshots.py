"""Snapshots whose payload is forged and whose sum fits: refused, or a world that steps; and never all memory."""

from __future__ import annotations

import math
import random
import struct

import numpy as np
import pytest
from fuzz.seeds import with_fluids
from test_layout_of_snapshots import world_with_one_of_each

import evilengine as evil

HEAD, TAIL = 20, 8  # bytes round the payload; its length is the head's last eight
WORD = (1 << 64) - 1
SEED, ONE, TWO = 0x9E3779B97F4A7C15, 0xFF51AFD7ED558CCD, 0xC4CEB9FE1A85EC53


def mixed(h: int, word: int) -> int:
    h ^= word * ONE & WORD
    return (h << 29 | h >> 35) * TWO & WORD


def checksum(data: bytes) -> int:
    """As core/hash.hpp has it."""
    lanes = [SEED + lane for lane in range(4)]
    for at in range(0, len(data), 8):
        lanes[at // 8 % 4] = mixed(lanes[at // 8 % 4], int.from_bytes(data[at : at + 8], "little"))
    h = SEED ^ len(data)
    for lane in lanes:
        h = mixed(h, lane)
    h = (h ^ h >> 33) * ONE & WORD
    return h ^ h >> 33


def payload_of(data: bytes) -> bytes:
    return data[HEAD:-TAIL]


def sealed(payload: bytes, like: bytes) -> bytes:
    return like[: HEAD - 8] + struct.pack("<Q", len(payload)) + payload + struct.pack("<Q", checksum(payload))


WORLDS = {"bodies": world_with_one_of_each, "fluids": with_fluids}


def refused_or_sound(data: bytes) -> bool:
    """Is it refused? Else the world that it makes takes steps, and no number of it is none."""
    try:
        world = evil.World.of(data)
    except evil.SnapshotError:
        return True
    for _ in range(2):
        world.step()
    for body in world.bodies:
        assert all(map(math.isfinite, (*body.position, body.angle, *body.velocity, body.angular_velocity)))
    views = [view for water in world.waters for view in (water.positions, water.velocities)]
    for smoke in world.smokes:
        views += [smoke.density, smoke.temperature, smoke.fuel, smoke.velocity]
    assert all(np.isfinite(np.asarray(view)).all() for view in views)
    return False


@pytest.mark.parametrize("kind", WORLDS)
def test_the_sum_here_is_the_sum_of_the_core(kind: str) -> None:
    data = WORLDS[kind]().snapshot()
    assert sealed(payload_of(data), data) == data


@pytest.mark.parametrize("kind", WORLDS)
def test_a_forged_snapshot_is_refused_or_makes_a_world_that_steps(kind: str) -> None:
    data = WORLDS[kind]().snapshot()
    payload, dice, refused = payload_of(data), random.Random(kind), 0
    forgeries = 300
    for _ in range(forgeries):
        forged = bytearray(payload)
        for _ in range(dice.choice([1, 1, 1, 4])):
            at = dice.randrange(len(forged))
            new = dice.choice(
                [b"\0", b"\xff", b"\0\0\0\1", b"\xff\xff\xff\xff", bytes([forged[at] ^ 1 << dice.randrange(8)])]
            )
            forged[at : at + len(new)] = new
        refused += refused_or_sound(sealed(bytes(forged[: len(payload)]), data))
    assert 0 < refused < forgeries


@pytest.mark.parametrize("number", [-3.4e38, 1e-45])
def test_forged_numbers_may_be_as_large_and_as_small_as_there_are(number: float) -> None:
    data = with_fluids().snapshot()
    payload = payload_of(data)
    forgeries = [payload[:at] + struct.pack("<f", number) + payload[at + 4 :] for at in range(0, len(payload) - 3, 13)]
    refused = sum(refused_or_sound(sealed(forged, data)) for forged in forgeries)
    assert 0 < refused < len(forgeries)


@pytest.mark.parametrize("kind", WORLDS)
def test_a_forged_snapshot_cut_anywhere_is_refused(kind: str) -> None:
    data = WORLDS[kind]().snapshot()
    payload = payload_of(data)
    for at in range(0, len(payload), 7):
        assert refused_or_sound(sealed(payload[:at], data)), at


BODIES_AT = 57  # in the payload: after gravity, sleep, steps, time and four serials, how many slots there are of bodies


@pytest.mark.parametrize("slots", [1 << 10, 1 << 20, 1 << 24, 1 << 40, (1 << 64) - 1])
def test_a_short_file_cannot_ask_for_many_rows(slots: int) -> None:
    """The memory that a file asks for grows with its length: a bit a slot must be there."""
    empty = evil.World().snapshot()
    payload = payload_of(empty)
    assert payload[BODIES_AT : BODIES_AT + 8] == bytes(8)
    forged = payload[:BODIES_AT] + struct.pack("<Q", slots) + payload[BODIES_AT + 8 :]
    assert len(forged) < 200
    assert refused_or_sound(sealed(forged, empty))


@pytest.mark.parametrize("bits", [b"\0\1", b"\1\0", b"\1\5", b"\1\2"])
def test_the_last_slot_is_taken_and_none_beyond_it(bits: bytes) -> None:
    """One world has one snapshot: nine slots of bodies, of which the last is taken, end in just one way."""
    world = evil.World()
    data = world.snapshot()
    payload = payload_of(data)
    forged = payload[:BODIES_AT] + struct.pack("<Q", 9) + bits + payload[BODIES_AT + 8 :]
    assert refused_or_sound(sealed(forged, data))


def test_a_lone_body_in_a_high_slot_is_kept() -> None:
    world = evil.World()
    bodies = [world.add(evil.Circle(0.1), at=(n, 0)) for n in range(3000)]
    for body in bodies[:-1]:
        body.destroy()
    data = world.snapshot()
    assert len(data) < 3000
    assert evil.World.of(data).snapshot() == data


def test_a_medium_of_a_forged_radius_comes_back_without_a_shape_and_the_world_whole() -> None:
    world = evil.World()
    world.add_force(evil.Medium(evil.Circle(0.71875), density=1))
    data = world.snapshot()
    payload, radius = payload_of(data), struct.pack("<f", 0.71875)
    assert payload.count(radius) == 1
    again = evil.World.of(sealed(payload.replace(radius, struct.pack("<f", 1e-41)), data))
    (medium,) = again.forces
    assert isinstance(medium, evil.Medium)
    assert medium.area is None
    again.step()
