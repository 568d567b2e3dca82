"""Stam's method as the thesis describes it (4.5.3 to 4.5.5): a reference, slow and lossy, true to its description."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import evilengine as evil

N = 24


def a_box_of_air(world: evil.World) -> evil.Smoke:
    return world.add_smoke((0, 0, 1, 1), cells=N, method="stam", buoyancy=1, cooling=0)


def a_source(smoke: evil.Smoke, **given: Any) -> evil.Source:
    words: dict[str, Any] = {"at": (0.5, 0.2), "radius": 0.1, "rate": 1.0}
    return smoke.add_source(**(words | given))


def divergence(velocity: Any) -> float:
    """Root mean square of what flows out of each inner cell."""
    u, v = velocity[..., 0], velocity[..., 1]
    across, up = u[1:-1, 2:] - u[1:-1, :-2], v[2:, 1:-1] - v[:-2, 1:-1]
    return float(np.sqrt(np.mean((across + up) ** 2)))


def test_projection_takes_half_of_the_divergence_of_noise_out() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = a_box_of_air(world)
    velocity = np.asarray(smoke.velocity)
    velocity[...] = np.random.default_rng(1).uniform(-1, 1, velocity.shape)
    before = divergence(velocity)
    world.step(1e-6)
    assert divergence(velocity) < 0.55 * before


def test_a_still_gas_keeps_what_is_in_it_where_it_is() -> None:
    world = evil.World()
    smoke = a_box_of_air(world)
    density = np.asarray(smoke.density)
    density[5:9, 5:9] = 0.7
    before = density.copy()
    for _ in range(10):
        world.step()
    assert np.array_equal(density, before)


def test_diffusion_spreads_and_keeps_the_sum() -> None:
    world = evil.World()
    smoke = a_box_of_air(world)
    smoke.diffusion = 0.01
    density = np.asarray(smoke.density)
    density[N // 2, N // 2] = 1.0
    for _ in range(10):
        world.step()
    assert density[N // 2, N // 2] < 0.5
    assert density.sum() == pytest.approx(1.0, rel=0.01)
    assert np.allclose(density, density[:, ::-1][:, np.arange(N) - 1], atol=1e-3)


def test_heat_rises_and_the_walls_hold_it() -> None:
    world = evil.World(gravity=(0, -10))
    smoke = a_box_of_air(world)
    a_source(smoke, temperature=1.0)
    for _ in range(120):
        world.step()
    density, velocity = np.asarray(smoke.density), np.asarray(smoke.velocity)
    assert density[N * 3 // 4].sum() > 0.1
    assert velocity[N // 2, N // 2, 1] > 0.1
    assert np.isfinite(velocity).all()
    assert density.min() >= 0


def test_a_source_goes_with_its_body_and_with_its_smoke() -> None:
    world = evil.World(gravity=(0, 0))
    smoke = a_box_of_air(world)
    torch = world.add(evil.Circle(0.05), at=(0.8, 0.8))
    carried, fixed = a_source(smoke, body=torch, at=(0.0, 0.0)), a_source(smoke, rate=0.0)
    world.step()
    assert np.unravel_index(np.argmax(smoke.density), (N, N))[0] > N // 2
    torch.destroy()
    assert not carried.alive
    assert fixed.alive
    smoke.destroy()
    assert not fixed.alive
    with pytest.raises(evil.StaleReferenceError, match=r"this Smoke .* was destroyed at step 1"):
        _ = smoke.mass


def test_a_world_with_smoke_goes_on_from_its_snapshot_to_the_same_bits() -> None:
    world = evil.World()
    smoke = a_box_of_air(world)
    source = a_source(smoke, temperature=1.0, colour=(1.0, 0.5, 0.0))
    for _ in range(20):
        world.step()
    density = np.asarray(smoke.density)
    data, then = world.snapshot(), world.checksum()
    for _ in range(5):
        world.step()
    later = world.checksum()
    world.restore(data)
    assert world.checksum() == then
    assert world.snapshot() == data
    assert smoke.alive
    assert source.alive
    other = evil.World.of(data)
    for _ in range(5):
        world.step()
        other.step()
    assert world.checksum() == other.checksum() == later
    assert np.array_equal(density, np.asarray(smoke.density)), "the view shows what was restored"


def test_a_damaged_snapshot_of_smoke_is_refused() -> None:
    world = evil.World()
    smoke = a_box_of_air(world)
    a_source(smoke)
    world.step()
    data = world.snapshot()
    before = world.checksum()
    for cut in range(len(data) - 400, len(data), 7):
        broken = bytearray(data)
        broken[cut] ^= 16
        with pytest.raises(evil.SnapshotError):
            world.restore(bytes(broken))
    assert world.checksum() == before


def test_what_gathers_is_what_flows_out_of_the_cells() -> None:
    world = evil.World()
    smoke = a_box_of_air(world)
    smoke.add_source(at=(0.5, 0.2), radius=0.1, velocity=(0, 2))
    smoke._gathering()
    for _ in range(5):
        world.step()
    before, after = smoke._gathering()
    u, v = (np.pad(np.asarray(smoke.velocity)[..., way], 1, mode="edge") for way in (0, 1))
    u[:, [0, -1]] *= -1  # walls throw back what goes through them
    v[[0, -1]] *= -1
    flow = (u[1:-1, 2:] - u[1:-1, :-2] + v[2:, 1:-1] - v[:-2, 1:-1]) * 0.5 * N
    assert after == pytest.approx(float(np.sqrt(np.mean(flow**2))), rel=1e-4)
    assert before > 1.2 * after


def test_heat_that_comes_later_is_carried_as_well() -> None:
    world = evil.World()
    smoke = a_box_of_air(world)
    a_source(smoke, velocity=(0, 2))
    for _ in range(3):
        world.step()
    np.asarray(smoke.fuel)[4, 12] = 1.0
    world.step()
    fuel = np.asarray(smoke.fuel)
    assert fuel[5, 12] > 0.01
    assert np.asarray(smoke.temperature)[4:6, 11:14].max() > 0
