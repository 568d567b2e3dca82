"""The testbed, driven on a device without a screen."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image as Pictures

from evilengine.bench import testbed
from evilengine.bench.menu import ROW, TOP, WIDTH
from evilengine.bench.scene import SCENES
from evilengine.bench.testbed import Testbed
from evilengine.cli import main
from evilengine.platform import HeadlessDevice

SIZE = (900, 560)


class Hand:
    """A testbed, and somebody who presses keys."""

    def __init__(self, first: str = "card_house") -> None:
        self.device = HeadlessDevice(SIZE)
        self.bed = Testbed(first, size=SIZE, renderer="soft", device=self.device)
        self.game = self.bed.game
        self.now = 0.0
        self.wait(2)

    def wait(self, frames: int) -> None:
        for _ in range(frames):
            self.bed.frame(self.now)
            self.now += 1 / 60

    def press(self, key: str) -> None:
        self.device.tap(key)
        self.wait(1)

    @property
    def present(self) -> str | None:
        assert self.bed.menu.chosen == self.game.scenes.present
        return self.game.scenes.present


@pytest.fixture
def hand() -> Hand:
    return Hand()


def test_the_menu_names_every_scene_and_a_click_begins_it(hand: Hand) -> None:
    for row in (5, 0):
        name = list(SCENES)[row]
        at = (30, TOP + (row + 0.5) * ROW)
        hand.device.pointer(at=at, button="left", down=True)
        hand.device.pointer(at=at, button="left", down=False)
        hand.wait(2)
        assert hand.present == name
    hand.device.pointer(at=(WIDTH + 5, TOP + 3.5 * ROW), button="left", down=True)
    hand.wait(1)
    assert hand.present == next(iter(SCENES)), "beside the menu"


def test_the_arrow_keys_go_round_all_scenes(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hand.bed, "go", lambda name: hand.bed._go(name, SCENES[name].small))
    seen = []
    for _ in SCENES:
        hand.press("down")
        hand.wait(2)
        assert len(hand.game.world.bodies) > 2
        seen.append(hand.present)
    assert sorted(seen) == sorted(SCENES)
    hand.press("up")
    assert hand.present == seen[-2]


def test_number_keys_turn_parts_of_the_debug_view_on_and_off_and_a_list_says_which(hand: Hand) -> None:
    assert hand.bed.menu.parts == ()
    hand.press("5")
    hand.wait(1)
    assert hand.game.debug
    assert "bounds" in hand.game.debug_view.shown
    assert ("bounds", True) in hand.bed.menu.parts
    assert ("islands", False) in hand.bed.menu.parts
    with_bounds = hand.game.capture()
    hand.press("p")
    hand.press("5")
    hand.press("1")
    hand.wait(1)
    assert ("bounds", False) in hand.bed.menu.parts
    assert hand.game.debug_view.shown == ("contacts", "joints", "centres", "flow", "particles")
    assert with_bounds != hand.game.capture()
    hand.press("d")
    hand.wait(1)
    assert hand.bed.menu.parts == ()


def test_it_pauses_goes_one_step_and_starts_again(hand: Hand) -> None:
    hand.wait(5)
    hand.press("p")
    world, steps = hand.game.world, hand.game.world.steps
    hand.wait(5)
    assert world.steps == steps
    for _ in range(3):
        hand.press("period")
    assert world.steps == steps + 3
    hand.press("space")
    hand.wait(5)
    assert world.steps > steps + 5
    hand.press("r")
    assert world.steps <= 1
    assert not hand.game.paused


def test_a_scene_grows_and_shrinks(hand: Hand) -> None:
    bodies = len(hand.game.world.bodies)
    hand.press("equals")
    assert len(hand.game.world.bodies) > bodies
    hand.press("minus")
    hand.press("minus")
    assert len(hand.game.world.bodies) < bodies
    for _ in range(20):
        hand.press("minus")
    assert hand.bed.size == 1


def test_a_body_can_be_dragged_with_the_mouse(hand: Hand) -> None:
    hand.bed.go("pyramid")
    hand.wait(1)
    top = max(hand.game.world.bodies, key=lambda body: body.position.y)
    at = hand.game.camera.to_pixel(top.position)
    before = top.position
    hand.device.pointer(at=at)
    hand.device.pointer(button="left", down=True)
    hand.wait(3)
    hand.device.pointer(at=at + (0, -60))
    hand.wait(60)
    assert top.position.y > before.y + 1


def test_debug_view_graph_sleep_zoom_and_the_end(hand: Hand) -> None:
    game = hand.game
    plain = np.array(game.capture().pixels)
    hand.press("d")
    assert game.debug
    assert (np.array(game.capture().pixels) != plain).mean() > 0.1
    graph = game.frame_graph
    hand.press("g")
    assert game.frame_graph is not graph
    assert game.world.sleep
    hand.press("s")
    hand.press("r")
    assert not game.world.sleep, "and it stays so in the next scene"
    hand.device.wheel(1)
    hand.wait(1)
    assert game.camera.zoom > 1
    hand.press("escape")
    assert not game.running


def test_what_a_scene_adds_while_it_plays_is_drawn_too() -> None:
    hand = Hand("bullets")
    hand.wait(30)
    assert all(body.drawings for body in hand.game.world.bodies)


def test_the_menu_is_on_the_picture_and_not_on_a_screenshot(hand: Hand, tmp_path: Path) -> None:
    panel = np.array(hand.game.capture().pixels)[:, : int(WIDTH), :3]
    assert (panel.min(axis=2) > 200).sum() > 200, "bright letters"
    with Pictures.open(hand.game.screenshot(tmp_path / "shot.png")) as picture:
        plain = np.asarray(picture.convert("RGB"))[:, : int(WIDTH)]
    assert (plain.min(axis=2) > 200).sum() == 0


def test_the_command_films_lists_and_refuses(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    film = tmp_path / "bed.gif"
    assert main(["testbed", "card_house", "--film", str(film), "--seconds", "0.2", "--size", "400x300"]) == 0
    with Pictures.open(film) as picture:
        assert (picture.size, picture.n_frames) == ((400, 300), 6)
    capsys.readouterr()
    assert main(["testbed", "--list"]) == 0
    assert (
        [line.split()[0] for line in capsys.readouterr().out.splitlines()]
        == list(SCENES)
        == [line.split()[0] for line in testbed.names()]
    )
    assert main(["testbed", "card-house"]) == 1
    assert "did you mean 'card_house'" in capsys.readouterr().err
    assert main(["testbed", "--film", str(tmp_path / "bed.mp4")]) == 1
    assert "to be a film" in capsys.readouterr().err
