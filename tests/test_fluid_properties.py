"""Plays at random with smoke, fire and water between bodies, as test_world_properties does with those alone."""

from __future__ import annotations

import contextlib
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import invariant, precondition, rule, run_state_machine_as_test
from test_world_properties import ROUNDS, WorldMachine, length, number, odd, point, shape

import evilengine as evil

nearby = st.floats(-4, 4, width=32)
area = st.one_of(
    st.tuples(nearby, nearby, nearby, nearby), st.just((-3, -2, 3, 2)), st.tuples(nearby, number, nearby, nearby)
)
sides = st.sampled_from([(), "top", "left right", "all", "front"])
some = st.integers(0, 99)
MOST = 3  # fluids of a kind


class FluidMachine(WorldMachine):
    """Beside bodies and forces, which it makes as that does."""

    def fluid(self, choice: int) -> Any:
        return self.one_of([*self.world.smokes, *self.world.waters], choice)

    def flow(self, choice: int) -> Any:
        sources = [source for smoke in self.world.smokes for source in smoke.sources]
        flows = [*sources, *(stream for water in self.world.waters for stream in water.streams)]
        return self.one_of(flows, choice) if flows else None

    def carrier(self, choice: int) -> evil.Body | None:
        return self.one_of(self.order, choice) if self.order and choice % 2 else None

    @precondition(lambda self: len(self.world.smokes) < MOST)
    @rule(area=area, cells=st.sampled_from([2, 5, 8, 12, (6, 4), 0, 10**9]), sides=sides, value=number,
          method=st.sampled_from(["staggered", "stam"]), quality=st.sampled_from(["fast", "high"]))  # fmt: skip
    def add_smoke(self, area: Any, cells: Any, sides: Any, value: float, method: str, quality: str) -> None:
        self.attempt(
            lambda: self.world.add_smoke(
                area, cells=cells, open_sides=sides, buoyancy=value, method=method, quality=quality
            )
        )

    @precondition(lambda self: len(self.world.waters) < MOST)
    @rule(area=area, sides=sides, size=st.sampled_from([0.3, 0.5, 1.0, 0.0, math.nan, 1e-9]), thick=number)
    def add_water(self, area: Any, sides: Any, size: float, thick: float) -> None:
        self.attempt(lambda: self.world.add_water(area, particle_size=size, open_sides=sides, viscosity=thick))

    @precondition(lambda self: self.world.smokes)
    @rule(choice=some, radius=length, at=point, value=number, fuel=number, velocity=point)
    def add_source(self, choice: int, radius: float, at: Any, value: float, fuel: float, velocity: Any) -> None:
        smoke, body = self.one_of(list(self.world.smokes), choice), self.carrier(choice)
        self.attempt(
            lambda: smoke.add_source(
                at=at, radius=radius, rate=value, temperature=value, fuel=fuel, velocity=velocity, body=body
            )
        )

    @precondition(lambda self: self.world.waters)
    @rule(choice=some, area=area, velocity=point, which=st.integers(0, 20))
    def fill(self, choice: int, area: Any, velocity: Any, which: int) -> None:
        water = self.one_of(list(self.world.waters), choice)
        liquid = self.one_of(list(water.liquids), which)
        before, come = water.count, self.attempt(lambda: water.fill(area, velocity=velocity, liquid=liquid))
        assert water.count == before + (come or 0)

    @precondition(lambda self: self.world.waters)
    @rule(choice=some, at=point, rate=number, velocity=point, make=shape, drains=st.booleans())
    def add_stream(self, choice: int, at: Any, rate: float, velocity: Any, make: Any, drains: bool) -> None:
        water, body = self.one_of(list(self.world.waters), choice), self.carrier(choice)
        if drains:
            self.attempt(lambda: water.drain(make(), at=at, rate=rate, body=body))
        else:
            self.attempt(lambda: water.pour(at, rate, velocity, shape=make(), body=body))

    @precondition(lambda self: self.world.waters)
    @rule(choice=some, area=area, density=number, thick=number)
    def clear_or_add_liquid(self, choice: int, area: Any, density: float, thick: float) -> None:
        water = self.one_of(list(self.world.waters), choice)
        if choice % 3 == 0:
            self.attempt(lambda: water.clear(area))
        else:
            self.attempt(lambda: water.add_liquid(density=density, viscosity=thick, surface_tension=thick))

    @precondition(lambda self: self.world.smokes or self.world.waters)
    @rule(choice=some, at=point, radius=length, velocity=point)
    def stir(self, choice: int, at: Any, radius: float, velocity: Any) -> None:
        self.attempt(lambda: self.fluid(choice).stir(at, radius=radius, velocity=velocity))

    @precondition(lambda self: self.world.smokes or self.world.waters)
    @rule(choice=some, value=odd, every=st.integers(1, 5))
    def write(self, choice: int, value: float, every: int) -> None:
        fluid = self.fluid(choice)
        with np.errstate(all="ignore"):
            if isinstance(fluid, evil.Water):
                np.asarray(fluid.positions if choice % 2 else fluid.velocities)[::every] = value
            else:
                np.asarray(fluid.velocity if choice % 2 else fluid.density)[::every] = value
        self.world.step(1 / 60)

    @precondition(lambda self: self.world.smokes or self.world.waters)
    @rule(choice=some, at=point)
    def ask(self, choice: int, at: Any) -> None:
        fluid = self.fluid(choice)
        found = self.attempt(lambda: fluid.velocity_at([at, (0, 0)]))
        assert found is None or all(math.isfinite(each.x) and math.isfinite(each.y) for each in found)
        if isinstance(fluid, evil.Water):
            self.attempt(lambda: fluid.depth_at([at, (0, 0)]))

    @rule(choice=some, name=st.sampled_from(["rate", "running", "velocity", "fuel", "temperature"]), value=number)
    def change_flow(self, choice: int, name: str, value: float) -> None:
        flow = self.flow(choice)
        if flow is None:
            return
        given = {"running": choice % 2 == 0, "velocity": (value, 1.0)}.get(name, value)
        if hasattr(type(flow), name):
            self.attempt(lambda: setattr(flow, name, given))

    @rule(choice=some)
    def end_a_flow(self, choice: int) -> None:
        flow = self.flow(choice)
        if flow is not None:
            flow.destroy()
            with pytest.raises(evil.StaleReferenceError):
                _ = flow.rate

    @precondition(lambda self: len(self.world.smokes) + len(self.world.waters) > 1)
    @rule(choice=some)
    def destroy_fluid(self, choice: int) -> None:
        fluid = self.fluid(choice)
        fluid.destroy()
        with pytest.raises(evil.StaleReferenceError):
            _ = fluid.velocity if isinstance(fluid, evil.Smoke) else fluid.velocities

    @invariant()
    def fluids_are_numbers_where_they_belong(self) -> None:
        for water in self.world.waters:
            assert water.count <= 100_000
            assert np.isfinite(np.asarray(water.velocities)).all()
            if water.count:
                kinds = np.asarray(water.kinds)
                assert kinds.max() < len(water.liquids)
        for smoke in self.world.smokes:
            with contextlib.suppress(evil.StaleReferenceError):
                assert np.isfinite(np.asarray(smoke.velocity)).all()
                assert np.isfinite(np.asarray(smoke.density)).all()


def test_fluids_keep_the_promises_of_the_world_whatever_is_asked_of_them() -> None:
    run_state_machine_as_test(
        FluidMachine,
        settings=settings(
            max_examples=ROUNDS or 12,
            stateful_step_count=30,
            derandomize=not ROUNDS,
            deadline=None,
            database=None,
            suppress_health_check=list(HealthCheck),
        ),
    )
