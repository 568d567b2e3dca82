"""A real window drawn on by OpenGL, on a screen in memory: it shows what the card drew, and pictures after that."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from test_window import MemoryScreen, chessboard, on_screen, screen, shows, wait_for

import evilengine as evil
from evilengine.platform import DesktopDevice, sdl_gl
from evilengine.platform import sdl as library
from evilengine.renderer import open_renderer
from evilengine.values.errors import DeviceError

__all__ = ["screen"]

SIZE = (320, 240)


@pytest.fixture(params=["glx", "egl"])
def display(screen: MemoryScreen, monkeypatch: Any, request: Any) -> MemoryScreen:
    """Both ways of X11 to a context; Wayland has the second alone."""
    monkeypatch.setenv("DISPLAY", screen.display)
    monkeypatch.setenv("SDL_VIDEO_X11_FORCE_EGL", "1" if request.param == "egl" else "0")
    for name in ("SDL_VIDEODRIVER", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    return screen


@pytest.fixture
def window(display: MemoryScreen) -> Iterator[DesktopDevice]:
    device = DesktopDevice("A test", SIZE, gl=True)
    if device.surface is None:
        device.close()
        pytest.skip("no driver draws on the X server in memory: apt-get install libgl1-mesa-dri")
    yield device
    device.close()


def game_in(window: DesktopDevice, renderer: str = "gl") -> evil.Game:
    game = evil.Game("A test", renderer=renderer, device=window)
    game.scene.background = "#203040"
    game.add(evil.Rectangle(2, 1), at=(0.3, 0.2), angle=0.3, kind="static", colour="tomato")
    game.add(evil.Circle(0.7), at=(-1.5, 1), kind="static", colour="gold")
    return game


def shows_the_game(screen: MemoryScreen, game: evil.Game) -> bool:
    def same() -> bool:
        game.frame(0.0)
        return np.array_equal(on_screen(screen, game.device), np.array(game.renderer.pixels)[..., :3])

    return wait_for(same)


def test_the_window_shows_every_pixel_that_the_card_drew(display: MemoryScreen, window: DesktopDevice) -> None:
    game = game_in(window)
    assert shows_the_game(display, game)
    assert game.renderer.name == "gl"
    assert len(np.unique(on_screen(display, window).reshape(-1, 3), axis=0)) > 3, "something was drawn"
    assert (window.size, window.pixel_size, window.scale) == (SIZE, SIZE, 1.0)


def test_a_resized_window_is_drawn_in_its_new_size(display: MemoryScreen, window: DesktopDevice) -> None:
    game = game_in(window)
    assert shows_the_game(display, game)
    sdl = library.load()
    sdl.SDL_SetWindowSize(window._window, 400, 180)
    assert wait_for(lambda: game.frame(0.0) or window.pixel_size == (400, 180))
    assert shows_the_game(display, game)
    assert game.renderer.pixels.shape == (180, 400, 4)


def test_auto_shows_pictures_where_the_card_is_a_program(display: MemoryScreen, window: DesktopDevice) -> None:
    game = game_in(window, "auto")
    assert shows_the_game(display, game)
    assert game.renderer.name == "soft"
    assert window.surface is None


def test_a_picture_ends_drawing_and_is_shown_pixel_for_pixel(display: MemoryScreen, window: DesktopDevice) -> None:
    surface = window.surface
    assert surface is not None
    assert shows(display, window, chessboard(*SIZE))
    assert (window.surface, surface.is_open) == (None, False)
    with pytest.raises(DeviceError, match="closed"):
        surface.make_current()
    surface.close()


def test_a_context_that_goes_while_the_game_plays_is_no_end_of_it(
    display: MemoryScreen, window: DesktopDevice, capfd: Any
) -> None:
    game = game_in(window)
    assert shows_the_game(display, game)
    assert window.surface is not None
    window.surface.close()
    assert shows_the_game(display, game)
    assert game.renderer.name == "soft"
    (line,) = capfd.readouterr().err.splitlines()
    assert "software" in line


def test_games_follow_each_other_in_one_window(display: MemoryScreen, window: DesktopDevice) -> None:
    first = game_in(window)
    assert shows_the_game(display, first)
    second = game_in(window)
    second.scene.background = "#402030"
    assert shows_the_game(display, second)
    assert shows_the_game(display, first), "the one that plays on while another could not be loaded"
    device = first.renderer._backend.device  # type: ignore[attr-defined]
    assert second.renderer._backend.device is device  # type: ignore[attr-defined]
    del first
    gc.collect()
    assert shows_the_game(display, second)
    assert device.counts() == {"buffers": 1, "targets": 1, "textures": 3}, "the first one's are given back"


def test_a_game_that_was_closed_can_still_be_captured(display: MemoryScreen, window: DesktopDevice) -> None:
    game = game_in(window)
    assert shows_the_game(display, game)
    before = np.array(game.capture().pixels)
    game.close()
    after = np.array(game.capture().pixels)
    assert np.abs(before.astype(int) - after).max() <= 3


def test_a_window_without_gl_is_a_window_all_the_same(display: MemoryScreen, monkeypatch: Any) -> None:
    monkeypatch.setattr(sdl_gl, "VERSIONS", ((9, 9, "SDL_GL_CONTEXT_PROFILE_CORE"),))
    window = DesktopDevice("A test", SIZE, gl=True)
    try:
        assert window.surface is None
        assert shows(display, window, chessboard(*SIZE))
        renderer = open_renderer("soft")
        renderer.attach(window.surface)
    finally:
        window.close()
