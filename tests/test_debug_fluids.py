"""The debug view of fluids: arrows along the flow, where it spreads and gathers, what is in the cells, particles."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from drawing_gl import any_driver
from stage import Stage

import evilengine as evil
from evilengine.renderer.gl import GlRenderer
from evilengine.scene.debug import FLUID_PARTS


@pytest.fixture
def stage() -> Stage:
    """8 x 4 metres, 25 pixels a metre: black, with nothing of the debug view but what a test asks for."""
    stage = Stage()
    stage.camera.zoom = 0.5
    stage.scene.debug = True
    view = stage.scene.debug_view
    view.show([])
    view.veil, view.legend, view.dial = "black", False, False
    view.arrow, view.grid, view.solid = "lime", "white", "red"
    view.spreading, view.gathering = "red", "blue"
    return stage


def air(stage: Stage, velocity: tuple[float, float] = (0.0, 0.0), **words: Any) -> evil.Smoke:
    """Cells of a quarter of a metre all over the picture, that flow as they are told."""
    given = {"cells": (32, 16), "open_sides": "all", "cooling": 0.0} | words
    smoke = stage.world.add_smoke((-4, -2, 4, 2), **given)
    np.asarray(smoke.velocity)[...] = velocity
    return smoke


def colours(stage: Stage) -> Any:
    return np.array(stage.show(), dtype=float)[..., :3] / 255


def test_nothing_of_fluids_is_drawn_of_what_is_off_and_each_part_shows_something(stage: Stage) -> None:
    smoke = air(stage, (1, 0))
    smoke.add_source(at=(0, -1), radius=0.5, velocity=(0, 5))
    stage.add(evil.Rectangle(1, 1), kind="static")
    stage.scene.debug_view.divergence = True
    stage.show()
    stage.world.step()
    stage.scene.debug_view.show([])
    assert colours(stage).max() == 0
    pictures = set()
    for part in ("flow", "divergence", "cells"):
        stage.scene.debug_view.show([part])
        pictures.add(stage.show().tobytes())
    assert len(pictures) == 3
    assert all(any(byte for at, byte in enumerate(each) if at % 4 != 3) for each in pictures)


@pytest.mark.parametrize("way", [(2.0, 0.0), (-2.0, 0.0), (0.0, 2.0), (0.0, -2.0)])
def test_an_arrow_lies_along_the_flow_and_points_where_it_goes(stage: Stage, way: tuple[float, float]) -> None:
    smoke = air(stage)
    np.asarray(smoke.velocity)[6:9, 12:15] = way  # one square of cells that an arrow stands for
    stage.scene.debug_view.show(["flow"])
    green = colours(stage)[..., 1]
    rows, columns = np.nonzero(green > 0.2)
    assert columns.mean() == pytest.approx(13.5 * 6.25, abs=1.5)
    assert rows.mean() == pytest.approx(100 - 7.5 * 6.25, abs=1.5)
    if way[0]:
        rows, columns = columns, rows
    assert np.ptp(rows) > 2 * np.ptp(columns)
    ahead = (rows > (rows.min() + rows.max()) / 2) == (way[0] > 0 or way[1] < 0)
    assert ahead.sum() > 0.6 * len(rows), "the head is in front"


def test_slow_flow_is_seen_beside_fast_and_still_air_is_not(stage: Stage) -> None:
    smoke = air(stage)
    velocity = np.asarray(smoke.velocity)
    velocity[:, :10] = (4, 0)
    velocity[:, 22:] = (1, 0)
    stage.scene.debug_view.show(["flow"])
    green = colours(stage)[..., 1]
    assert green[:, :60].max() > 0.9
    assert 0.3 < green[:, 145:].max() < 0.95
    assert green[:, 75:130].max() == 0


def test_no_arrows_stand_in_solids(stage: Stage) -> None:
    air(stage, (2, 0), cells=(64, 32))
    stage.add(evil.Rectangle(2, 2), kind="static")
    stage.world.step()
    stage.scene.debug_view.show(["flow"])
    green = colours(stage)[..., 1]
    assert green[30:70, 80:120].max() == 0
    assert green[:, :70].max() > 0.5


def test_solid_cells_are_filled_and_closed_sides_are_lines(stage: Stage) -> None:
    air(stage, open_sides="left right top")
    stage.add(evil.Rectangle(2, 2), kind="static")
    stage.world.step()
    stage.scene.debug_view.show(["cells"])
    seen = colours(stage)
    assert seen[35:65, 85:115, 0].min() > 0.9
    assert seen[20, 30, 0] < 0.4
    assert seen[-1, :, 1].min() > 0.7, "the floor"
    assert seen[0, 1::25, 1].max() < 0.5, "no ceiling"


def test_lines_between_cells_keep_their_distance(stage: Stage) -> None:
    """As many lines as have room: eight points apart or more, however small the cells."""
    air(stage, cells=(512, 256))
    stage.scene.debug_view.show(["cells"])
    row = colours(stage)[50, :, 1]
    assert 0.05 < (row > row.mean()).mean() < 0.35


def test_what_spreads_and_what_gathers_is_known_after_a_step(stage: Stage) -> None:
    smoke = air(stage, method="stam", open_sides=())
    stage.scene.debug_view.show(["divergence"])
    assert colours(stage).max() == 0
    y, x = np.mgrid[0:16, 0:32].astype(np.float32)
    out = np.stack([x - 8, y - 8], axis=-1) * np.exp(-((x - 8) ** 2 + (y - 8) ** 2) / 6)[..., None]
    into = np.stack([24 - x, 8 - y], axis=-1) * np.exp(-((x - 24) ** 2 + (y - 8) ** 2) / 6)[..., None]
    np.asarray(smoke.velocity)[...] = out + into
    stage.world.step(1e-4)
    seen = colours(stage)
    assert seen[40:60, 40:60, 0].mean() > 3 * seen[40:60, 40:60, 2].mean()
    assert seen[40:60, 140:160, 2].mean() > 3 * seen[40:60, 140:160, 0].mean()


def pond(stage: Stage) -> evil.Water:
    """The left half of the picture up to its middle is water that moves to the right."""
    water = stage.world.add_water((-4, -2, 4, 2), particle_size=0.125, open_sides="top", colour="#0000ff")
    water.fill((-4, -2, 0, 0), velocity=(2, 0))
    return water


def test_particles_are_dots_in_the_colour_of_their_liquid(stage: Stage) -> None:
    pond(stage)
    stage.scene.debug_view.show(["particles"])
    seen = colours(stage)
    assert seen[55:95, 5:95, 2].mean() > 0.25
    assert seen[55:95, 5:95, 2].mean() > 3 * seen[55:95, 5:95, 0].mean()
    assert seen[:48].max() == 0
    assert seen[:, 102:].max() == 0
    stage.camera.position, stage.camera.zoom = evil.Vec2(-2, -1), 8.0
    lines = colours(stage)[..., 2]
    assert (lines == 0).mean() > 0.3, "there is room between dots"


def test_cells_with_liquid_are_filled_and_solid_ones_too(stage: Stage) -> None:
    pond(stage)
    stage.add(evil.Rectangle(2, 2), at=(2, 0), kind="static")
    stage.world.step(1e-3)
    stage.scene.debug_view.liquid = "lime"
    stage.scene.debug_view.show(["cells"])
    seen = colours(stage)
    assert seen[55:95, 5:95, 1].min() > 0.9
    assert seen[55:95, 105:115, 1].max() < 0.5
    assert seen[40:60, 140:160, 0].min() > 0.9
    assert seen[-1, :, 1].min() > 0.7, "the floor"


def test_water_has_arrows_where_it_is(stage: Stage) -> None:
    pond(stage)
    stage.scene.debug_view.show(["flow"])
    green = colours(stage)[..., 1]
    rows = green[55:95, :95]
    assert (rows > 0.5).any(axis=0).mean() > 0.5
    assert green[:45].max() == 0


def test_the_legend_says_what_the_colours_stand_for(stage: Stage) -> None:
    view, core, camera = stage.scene.debug_view, stage.scene._core, stage.camera
    view.show(["flow", "divergence", "cells"])
    stage.show()
    arguments = core, stage.world, camera.matrix((200, 100), 1.0, 1.0), (200, 100), 1.0
    assert view._draw_fluids(*arguments) == [], "there is nothing that flows"
    air(stage, (3, 0))
    stage.show()
    words = [word for _, word in view._draw_fluids(*arguments)]
    assert words == ["flow to 5 m/s", "spreads", "gathers, to 0/s", "solid cells"]
    pond(stage)
    view.show(["cells", "particles"])
    words = [word for _, word in view._draw_fluids(*arguments)]
    assert words == ["solid cells", "liquid", "particles 512"]


def test_it_changes_nothing_and_draws_at_any_zoom(stage: Stage) -> None:
    smoke = air(stage, (1, 2), open_sides="top")
    smoke.add_source(at=(0, 0), radius=0.5, rate=1, temperature=1)
    checksum = stage.world.checksum()
    stage.scene.debug_view.show(FLUID_PARTS)
    for zoom in (1e-6, 0.3, 1.0, 40.0, 1e6):
        stage.camera.zoom = zoom
        stage.camera.angle = zoom
        stage.show()
    assert stage.world.checksum() == checksum
    smoke.destroy()
    stage.camera.zoom = 0.5
    assert colours(stage).max() == 0


def test_both_renderers_draw_it_alike(stage: Stage) -> None:
    gl = GlRenderer(any_driver())
    smoke = air(stage, (1, 0))
    smoke.add_source(at=(0, -1), radius=0.5, velocity=(0, 5))
    stage.add(evil.Circle(0.6), kind="static")
    stage.scene.debug_view.show(FLUID_PARTS)
    stage.show()
    stage.world.step()
    frame = stage.scene.collect(stage.camera, 1.0, None)
    stage.renderer.draw(frame)
    gl.draw(frame)
    soft, card = (np.array(each.pixels).astype(int) for each in (stage.renderer, gl))
    assert soft[..., :3].mean() > 20
    assert np.abs(soft - card).mean() < 1
