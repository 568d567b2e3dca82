"""Water is kept: snapshots, checksums, restores, saved games, damaged bytes; and it flows the same everywhere."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import evilengine as evil
from evilengine.game import saving
from evilengine.world.water import Water

DT = 1 / 60


def rich_world(threads: int = 1) -> tuple[evil.World, Water]:
    """Two liquids, a stream on a body, a drain, floating and moving bodies, an open side."""
    world = evil.World(gravity=(0, -10), threads=threads)
    water = world.add_water((0, 0, 3, 2), particle_size=0.1, open_sides="top")
    oil = water.add_liquid(density=0.8, viscosity=0.01, colour="gold")
    water.fill((0, 0, 3, 0.7))
    water.fill((0, 0.7, 1, 1), liquid=oil)
    world.add(evil.Rectangle(0.4, 0.3), at=(1.5, 1.2), density=0.4)
    world.add(evil.Circle(0.2), at=(2.5, 1.5), density=0.7)
    paddle = world.add(evil.Rectangle(0.6, 0.1), at=(0.6, 0.5), kind="kinematic", angular_velocity=4)
    water.pour((0.5, 0), 0.8, (1, 0), body=paddle, liquid=oil)
    water.pour((2.5, 1.8), 0.6, (0, -1), shape=evil.Rectangle(0.3, 0.2), angle=0.3)
    water.drain((2, 0, 3, 0.2), rate=0.5)
    return world, water


def run(world: evil.World, steps: int) -> None:
    for _ in range(steps):
        world.step(DT)


def test_a_restored_world_flows_on_as_if_never_stopped() -> None:
    world, _ = rich_world()
    run(world, 40)
    data = world.snapshot()
    twin = evil.World.of(data)
    assert twin.snapshot() == data
    assert twin.checksum() == world.checksum()
    for _ in range(3):
        run(world, 20)
        run(twin, 20)
        assert twin.checksum() == world.checksum()
    assert twin.snapshot() == world.snapshot()


def test_going_back_in_time_plays_the_same_again() -> None:
    world, water = rich_world()
    run(world, 20)
    data = world.snapshot()
    run(world, 30)
    after = world.checksum()
    world.restore(data)
    assert world.snapshot() == data
    assert water.alive
    run(world, 30)
    assert world.checksum() == after


def test_asking_and_looking_changes_nothing() -> None:
    (one, seen), (other, _) = rich_world(), rich_world()
    for _ in range(20):
        run(one, 1)
        run(other, 1)
        np.asarray(seen.positions), np.asarray(seen.velocities)
        seen.is_in((1, 1)), seen.velocity_at((1, 1)), seen.depth_at((1, 0.1)), one.snapshot()
    assert one.checksum() == other.checksum()


def test_the_checksum_knows_of_particles_liquids_and_streams() -> None:
    world, water = rich_world()
    sums = {world.checksum()}
    water.velocities[0] = (1, 1)
    sums.add(world.checksum())
    water.liquids[0].viscosity = 0.5
    sums.add(world.checksum())
    water.streams[0].rate = 0.9
    sums.add(world.checksum())
    water.streams[0].running = False
    sums.add(world.checksum())
    water.clear()
    sums.add(world.checksum())
    assert len(sums) == 6


def test_handles_know_after_a_restore_whether_they_are_still_there() -> None:
    world, water = rich_world()
    before = world.snapshot()
    late, third = water.pour((1, 1), 1), water.add_liquid()
    other = world.add_water((5, 0, 6, 1))
    world.restore(before)
    assert (water.alive, late.alive, third.alive, other.alive) == (True, False, False, False)
    assert [each.alive for each in water.liquids] == [True, True]
    with pytest.raises(evil.StaleReferenceError, match="this Liquid is gone"):
        water.fill((0, 0, 1, 1), liquid=third)
    again = water.add_liquid()
    assert again != third or again.alive
    with pytest.raises(evil.StaleReferenceError, match="restored to a snapshot without it"):
        other.fill((5, 0, 6, 1))


def test_views_show_what_was_restored() -> None:
    world, water = rich_world()
    run(world, 5)
    view, data = np.asarray(water.positions), world.snapshot()
    kept = view.copy()
    run(world, 1)
    assert not (view == kept).all()
    world.restore(data)
    assert (view == kept).all()


def test_a_view_of_a_water_that_grew_after_it_does_no_harm_in_a_restore() -> None:
    world, water = rich_world()
    data, view = world.snapshot(), np.asarray(water.positions)
    water.fill((0, 0, 3, 2))
    water.fill((0, 0, 3, 2))
    world.restore(data)
    view[:] = math.nan
    run(world, 2)
    assert np.isfinite(np.asarray(water.positions)).all()


def test_all_instruction_sets_and_any_threads_give_the_same_water() -> None:
    sums = set()
    for set_name, threads in (("plain", 1), ("sse2", 1), ("avx2", 1), ("avx2", 2), ("avx2", 4), ("avx512", 1)):
        world, _ = rich_world(threads)
        try:
            world._core.instruction_set = set_name
        except evil.ArgumentError:
            continue  # this machine has no such set
        run(world, 50)
        sums.add(world.checksum())
    assert len(sums) == 1


def test_a_snapshot_flipped_at_any_byte_is_refused() -> None:
    world = evil.World()
    water = world.add_water((0, 0, 0.4, 0.4), particle_size=0.1)
    water.fill((0, 0, 0.4, 0.2))
    water.pour((0.2, 0.3), 0.1)
    data = world.snapshot()
    for at in range(len(data)):
        for bit in range(8) if at % 16 == 0 else (at % 8,):
            changed = bytearray(data)
            changed[at] ^= 1 << bit
            with pytest.raises(evil.SnapshotError):
                world.restore(bytes(changed))
        with pytest.raises(evil.SnapshotError):
            world.restore(data[:at])
    assert world.snapshot() == data


def test_a_saved_game_keeps_its_water(tmp_path: Path) -> None:
    game = evil.Game("Water", headless=True, size=(160, 120), folder=tmp_path)
    water = game.add_water((-2, -2, 2, 2), particle_size=0.1)
    water.fill((-2, -2, 2, -1))
    tap = water.pour((0, 1.5), 1, (0, -2))
    game.timer.after(0.5, tap.destroy)
    game.timer.after(1.0, water.destroy)
    game.step(20)
    data = saving.to_bytes(game)
    other = evil.Game("Water", headless=True, size=(160, 120), folder=tmp_path)
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    for each in (game, other):
        each.step(20)
    assert other.world.checksum() == game.world.checksum()
    assert not other.world.waters[0].streams
    other.step(30)
    assert other.world.waters == ()
