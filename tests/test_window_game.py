"""A whole game in a real window: it fills the screen, saves pictures, goes from scene to scene, and quits."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from sdl_queue import push_key
from test_window import screen, wait_for  # noqa: F401  (the fixture)

import evilengine as evil

F11, F12, SPACE = (0x40000044, 68), (0x40000045, 69), (32, 44)
"""SDL's codes, and places on the keyboard."""


@pytest.fixture
def game(screen, monkeypatch, tmp_path):  # noqa: F811
    monkeypatch.setenv("DISPLAY", screen.display)
    for name in ("SDL_VIDEODRIVER", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.chdir(tmp_path)
    game = evil.Game("Window", size=(320, 240), renderer="soft", sound="none")
    game.camera.fit(6.4, 4.8)

    @game.scenes
    def red():
        game.add(evil.Rectangle(2, 2), kind="static", colour="red")
        game.on_key_press(lambda key: game.go("blue") if key == "space" else None)

    @game.scenes
    def blue():
        game.add(evil.Rectangle(2, 2), kind="static", colour="blue")

    game.go("red")
    yield game
    game.close()


def frames(game, until):
    """Play until something is true; frames follow the clock of the test, not that on the wall."""

    def one():
        game.now = getattr(game, "now", 0.0) + 1 / 60
        game.frame(game.now)
        return until()

    return wait_for(one)


def test_the_game_fills_the_screen_without_being_stretched(game):
    push_key(game.device, *F11, True)
    assert frames(game, lambda: game.device.size == (1280, 1024) == game.camera.size)
    assert game.fullscreen

    # What is drawn: an X server without a window manager leaves the window itself as it was.
    red = (np.asarray(game.capture().pixels)[..., :3] == (255, 0, 0)).all(axis=2)
    assert (red.any(axis=0).sum(), red.any(axis=1).sum()) == (400, 400), "two metres of 200 pixels, both ways"
    push_key(game.device, *F11, False)
    push_key(game.device, *F11, True)
    assert frames(game, lambda: game.camera.size == (320, 240))
    assert not game.fullscreen


def test_pictures_scenes_and_the_end(game, tmp_path):
    push_key(game.device, *F12, True)
    assert frames(game, lambda: (tmp_path / "Window-1.png").exists())
    with Image.open(tmp_path / "Window-1.png") as picture:
        assert picture.size == (320, 240)
        assert picture.convert("RGB").getpixel((160, 120)) == (255, 0, 0)
    push_key(game.device, *SPACE, True)
    assert frames(game, lambda: game.scenes.present == "blue")
    assert tuple(game.capture().pixels[120, 160, part] for part in range(3)) == (0, 0, 255)
    game.timer.after(0.05, game.quit)
    game.run(seconds=20)
    assert not game.running
    assert not game.device.is_open
