"""The panel: what is said is shown, what is not said any more goes, and knobs turn."""

from __future__ import annotations

import numpy as np
import pytest

import evilengine as evil
from evilengine.scene.panel import FORGOTTEN, GAP, MARGIN, MOST_ROWS, REMEMBERED, WIDTH


@pytest.fixture
def game() -> evil.Game:
    game = evil.Game(headless=True, renderer="soft", size=(600, 300))
    game.add_background("black")
    return game


LEFT = 600 - MARGIN - WIDTH


def press(game: evil.Game, x: float, y: float, *, down: bool = True) -> None:
    game.device.pointer(at=(x, y))
    game.device.pointer(at=(x, y), button="left", down=down)


def lit(game: evil.Game) -> bool:
    return bool(np.asarray(game.capture().pixels)[:, int(LEFT) :, :3].any())


def test_rows_are_shown_while_they_are_said_and_go_soon_after(game: evil.Game) -> None:
    assert not lit(game)
    game.panel.show("speed", 3.5)
    assert lit(game)
    for _ in range(FORGOTTEN // 2):
        game.capture()
    game.panel.show("speed", 4)
    for _ in range(FORGOTTEN):
        game.capture()
    assert game.panel.rows == ["speed"]
    game.capture()
    assert game.panel.rows == []
    assert not lit(game)


def test_it_can_be_hidden_and_is_in_no_screenshot(game: evil.Game, tmp_path: object) -> None:
    game.panel.show("a", 1)
    assert not np.asarray(game._plain_picture().pixels)[..., :3].any()
    game.panel.visible = False
    assert not lit(game)
    game.panel.visible, game.panel.left = True, True
    assert not lit(game)


def test_a_slider_follows_the_mouse_that_holds_it_and_stays_in_its_range(game: evil.Game) -> None:
    value = 2.0
    seen = []

    @game.on_update
    def update(dt: float) -> None:
        nonlocal value
        value = game.panel.slider("speed", value, 0, 10)
        seen.append(value)

    game.step()
    game.capture()
    assert value == 2.0
    middle, row = LEFT + WIDTH / 2, MARGIN + GAP + 10
    press(game, middle, row)
    game.step()
    assert value == pytest.approx(5.0)
    game.device.pointer(at=(LEFT + WIDTH + 400, 250))
    game.step()
    assert value == 10.0
    press(game, 0, 0, down=False)
    game.step(2)
    assert value == 10.0
    press(game, 0, 0)
    game.step()
    assert value == 10.0


def test_a_button_and_a_toggle_answer_once_for_each_press(game: evil.Game) -> None:
    pressed, on = 0, False

    @game.on_update
    def update(dt: float) -> None:
        nonlocal pressed, on
        pressed += game.panel.button("go")
        on = game.panel.toggle("lights", on)

    game.step()
    game.capture()
    for row, expected in [(MARGIN + GAP + 5, (1, False)), (MARGIN + GAP + 25, (1, True)), (200, (1, True))]:
        press(game, LEFT + 50, row)
        game.step(3)
        press(game, LEFT + 50, row, down=False)
        game.step()
        assert (pressed, on) == expected


def test_a_graph_remembers_two_seconds(game: evil.Game) -> None:
    for value in range(REMEMBERED + 30):
        game.panel.graph("height", value)
    assert len(game.panel._rows["height"].past) == REMEMBERED
    assert lit(game)
    game.panel.graph("flat", 3)
    assert lit(game)


def test_another_scene_begins_with_an_empty_panel(game: evil.Game) -> None:
    game.scenes("next")(lambda: None)
    game.panel.show("a", 1)
    game.go("next")
    assert game.panel.rows == []


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (lambda panel: panel.show("", 1), "name='' must be a text"),
        (lambda panel: panel.slider("a", 1, 2, 2), "low=2.0 must be less than high=2.0"),
        (lambda panel: panel.graph("a", "b"), "value='b' must be a number"),
        (lambda panel: panel.shwo("a", 1), "shwo"),
        (lambda panel: [panel.show(str(n), n) for n in range(MOST_ROWS + 1)], "one row more than"),
    ],
)
def test_bad_words_about_the_panel_are_named(game: evil.Game, bad: object, words: str) -> None:
    with pytest.raises((evil.Error, AttributeError), match=words):
        bad(game.panel)  # type: ignore[operator]
