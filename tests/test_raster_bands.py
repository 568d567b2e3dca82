"""A picture shared out over threads in bands of rows: the same bits however it is cut and whoever draws."""

from __future__ import annotations

import os
import random
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import test_depth
import test_layers
import test_light_slides
import test_particles
import test_post
import test_shafts
import test_surfaces
import test_views
import test_water_looks
from drawing import Pixels, picture, place, star
from golden_looks import LOOKS, played
from golden_pictures import assert_golden
from golden_scenes import SCENES
from lighting import lamps_and_shadows
from test_renderer import zoo

import evilengine as evil
from evilengine import _core
from evilengine.renderer import MOST_THREADS, open_renderer
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError

CUTS = ((1, 0), (2, 0), (3, 0), (4, 0), (1, 1), (2, 3), (4, 7), (3, 16), (2, 50), (4, 1000))
"""Threads, and rows of a band; 0 for as many as the renderer takes by itself."""


def water(name: str, folder: Path) -> evil.Game:
    return test_water_looks.scene_of(name, "soft")


def look(name: str, folder: Path) -> evil.Game:
    return played(name, "soft", folder)


GAMES: dict[str, Callable[[Path], evil.Game]] = {
    "layers": lambda folder: test_layers.wood("soft"),
    "post": lambda folder: test_post.lantern("soft"),
    "shafts": lambda folder: test_shafts.scenery("soft"),
    "depth": lambda folder: test_depth.scenery("soft"),
    "views": lambda folder: test_views.scenery("soft"),
    "surfaces": lambda folder: test_surfaces.surfaces(folder),
    "light_slides": lambda folder: test_light_slides.slides(folder),
    "particles": lambda folder: test_particles.fire_and_rain("soft"),
    "light_medium": lambda folder: lamps_and_shadows(),
    **{f"water_{name}": partial(water, name) for name in test_water_looks.SCENES},
    **{name: partial(look, name) for name in LOOKS},
}
"""The games of the golden pictures, by the names of these."""


def draw(renderer: SoftRenderer, frame: DrawList, threads: int, rows: int) -> Pixels:
    """A frame that was cut so, as SoftRenderer draws it."""
    raster, (width, height) = renderer._raster, frame.size
    raster.threads = threads
    pixels = bytearray(width * height * 4)
    background: int | None = frame.background
    if frame.insets:
        raster.draw(_core.DrawList(), pixels, width, height, background, rows=rows)
        for inset in frame.insets:
            part, content = (inset.left, inset.top, *inset.frame.size), inset.frame.content
            raster.draw(content, pixels, width, height, inset.frame.background, part=part, rows=rows)
        background = None
    raster.draw(frame.content, pixels, width, height, background, rows=rows)
    return np.frombuffer(pixels, np.uint8).reshape(height, width, 4)


@pytest.mark.parametrize("name", SCENES)
def test_a_golden_scene_comes_out_to_the_bit_however_it_is_cut(name: str) -> None:
    renderer = SoftRenderer()
    frame = SCENES[name](renderer.upload)
    for threads, rows in CUTS:
        assert_golden(name, draw(renderer, frame, threads, rows))


@pytest.mark.parametrize("name", GAMES)
def test_a_golden_game_comes_out_to_the_bit_however_it_is_cut(name: str, tmp_path: Path) -> None:
    game = GAMES[name](tmp_path)
    frame = game._collect()
    assert isinstance(game.renderer, SoftRenderer)
    for threads, rows in CUTS:
        assert_golden(name, draw(game.renderer, frame, threads, rows))


def test_what_is_drawn_at_random_is_the_same_however_it_is_cut() -> None:
    for seed in range(12):
        content, raster = zoo(seed)
        expected = picture(content, (123, 91), raster)
        for threads, rows in CUTS:
            raster.threads = threads
            assert (picture(content, (123, 91), raster, rows=rows) == expected).all(), (seed, threads, rows)


def test_a_blur_of_any_radius_is_the_same_however_it_is_cut() -> None:
    game = test_layers.wood("soft")
    assert isinstance(game.renderer, SoftRenderer)
    for radius in (0.3, 1, 2.5, 7, 40, 500):
        game.layers[-1].blur = radius
        frame = game._collect()
        expected = draw(game.renderer, frame, 1, 0)
        for threads, rows in CUTS[4:]:
            assert (draw(game.renderer, frame, threads, rows) == expected).all(), (radius, threads, rows)


def big_crowd() -> _core.DrawList:
    """Enough that it is worth sharing out."""
    dice, content = random.Random(4), _core.DrawList()
    meshes = [content.circle(9.0), content.polygon(star(7, 12, 5)), content.polygon(star(3, 30, 9))]
    for _ in range(3000):
        where = place(dice.uniform(-20, 660), dice.uniform(-20, 380), dice.choice([0.3, 1, 3]), dice.uniform(0, 6))
        content.instance(dice.choice(meshes), where, tint=dice.randrange(1 << 32), outline=dice.choice([0.0, 0.0, 1.5]))
    return content


def test_threads_of_their_own_choice_of_bands_give_the_same_bits() -> None:
    content = big_crowd()
    expected = picture(content, (640, 360))
    for threads in (2, 3, 4, 256):
        raster = _core.Raster(threads)
        for _ in range(3):
            assert (picture(content, (640, 360), raster) == expected).all()


def threads_of_this_process() -> int:
    return len(os.listdir("/proc/self/task"))


@pytest.mark.skipif(not os.path.isdir("/proc/self/task"), reason="this system does not list threads so")
def test_a_small_picture_wakes_no_thread_and_a_large_one_does() -> None:
    before, raster, small = threads_of_this_process(), _core.Raster(3), _core.DrawList()
    small.instance(small.circle(20.0), place(60, 40))
    picture(small, (320, 180), raster)
    assert threads_of_this_process() == before
    picture(big_crowd(), (640, 360), raster)
    assert threads_of_this_process() == before + 2
    del raster
    assert threads_of_this_process() == before


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes do not split here")
@pytest.mark.skipif(os.environ.get("EVIL_SANITIZED") == "thread", reason="ThreadSanitizer's processes do not split")
def test_a_process_that_forks_goes_on_drawing_on_both_sides() -> None:
    content, raster = big_crowd(), _core.Raster(3)
    expected = picture(content, (640, 360), raster)
    child = os.fork()
    if child == 0:
        try:
            code = 0 if (picture(content, (640, 360), raster) == expected).all() else 1
        except BaseException:
            code = 2
        os._exit(code)
    assert (picture(content, (640, 360), raster) == expected).all()
    assert os.waitpid(child, 0)[1] == 0


def test_a_game_says_how_many_threads_draw_and_by_itself_takes_those_of_the_machine() -> None:
    for threads in (1, 3):
        game = evil.Game(headless=True, renderer="soft", threads=threads)
        assert isinstance(game.renderer, SoftRenderer)
        assert (game.renderer.threads, game.world.threads) == (threads, threads)
    game = evil.Game(headless=True, renderer="soft")
    assert isinstance(game.renderer, SoftRenderer)
    assert 1 <= game.renderer.threads <= MOST_THREADS
    assert game.world.threads == 1
    game.renderer.close()
    assert 1 <= game.renderer.threads <= MOST_THREADS


@pytest.mark.parametrize("threads", [0, -1, 257, 1.5, True, "two"])
def test_a_number_of_threads_that_is_none_is_refused(threads: object) -> None:
    with pytest.raises(ArgumentError, match=r"Game: threads=.* must be a whole number from 1 to 256"):
        evil.Game(headless=True, threads=threads)  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match=r"open_renderer: threads=.* must be a whole number from 1 to 256"):
        open_renderer("soft", threads=threads)  # type: ignore[arg-type]


def test_bands_of_fewer_than_no_rows_are_refused() -> None:
    with pytest.raises(ArgumentError, match=r"rows=-1 must not be negative"):
        picture(_core.DrawList(), (8, 8), rows=-1)
    with pytest.raises(ArgumentError, match=r"threads=0 must be 1 to 256"):
        _core.Raster(0)
