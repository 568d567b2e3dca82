"""Views: several cameras on one window, in both renderers; what is under a finger; scenes, saved games, levels."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from golden_pictures import assert_golden

import evilengine as evil
from evilengine import level, script
from evilengine.audio.hearing import from_place
from evilengine.game import saving
from evilengine.script.translate import translate
from evilengine.values.errors import StaleReferenceError
from evilengine.values.vec2 import Vec2

RENDERERS = ("soft", "gl")


def quiet(renderer: str = "soft", **options: Any) -> evil.Game:
    game = evil.Game("Views", size=(240, 160), headless=True, renderer=renderer, gravity=(0, 0), **options)
    game.add_background("black")
    return game


def picture(game: evil.Game) -> npt.NDArray[np.int64]:
    return np.array(game.capture().pixels).astype(np.int64)


def two_players(renderer: str = "soft") -> tuple[evil.Game, evil.Body, evil.Body]:
    """One is red and ten metres to the left of the other, which is lime."""
    game = quiet(renderer)
    one = game.add(evil.Circle(0.5), at=(-5, 0), colour="red")
    two = game.add(evil.Circle(0.5), at=(5, 0), colour="lime")
    game.split(one, two)
    return game, one, two


def scenery(renderer: str) -> evil.Game:
    """Lights, layers, fog, blur, particles, post and text in three views, one on top."""
    game = quiet(renderer)
    game.draw(evil.Rectangle(30, 9), layer=-3, colour="#667788", lit=True)
    game.draw(evil.Circle(2), at=(1, -1), layer=-2, colour="#223344")
    game.layers[-2].parallax, game.layers[-2].fog, game.layers[-2].blur = 0.5, "#ffd0a040", 3
    one = game.add(evil.Rectangle(1, 1), at=(-3, 0), angle=0.3, kind="static", colour="orange", lit=True)
    two = game.add(evil.Circle(0.6), at=(3, 0.5), kind="static", colour="tomato", lit=True)
    game.add_light(at=(-1, 1.5), radius=6)
    game.add_particles(at=(3, -1), size=0.3, speed=1, colour="gold", life=3).burst(12)
    game.ambient, game.post.vignette, game.post.bloom = 0.3, 0.7, 0.4
    game.split(one, two)
    game.views[1].camera.angle = 0.2
    game.add_view((0.3, 0.6, 0.7, 0.95), position=(0, 0), zoom=0.4)
    game.text("over all", at=(8, 4), size=14)
    game.step(20)
    return game


@pytest.mark.parametrize("renderer", RENDERERS)
def test_each_player_is_in_the_middle_of_a_view(renderer: str) -> None:
    game, _, _ = two_players(renderer)
    pixels = picture(game)
    assert tuple(pixels[80, 60, :3]) == (255, 0, 0)
    assert tuple(pixels[80, 180, :3]) == (0, 255, 0)
    red, green = (np.argwhere(pixels[..., channel] > 128) for channel in (0, 1))
    assert red.mean(axis=0) == pytest.approx((79.5, 59.5), abs=0.5)
    assert green.mean(axis=0) == pytest.approx((79.5, 179.5), abs=0.5)


@pytest.mark.parametrize("renderer", RENDERERS)
def test_a_view_shows_exactly_what_a_whole_game_of_its_size_would(renderer: str) -> None:
    game = scenery(renderer)
    game.views[2].visible = False
    game.scene.clear()
    game.draw(evil.Circle(1), at=(-3, 0), colour="orange")
    split = picture(game)
    alone = evil.Game("Alone", size=(120, 160), headless=True, renderer=renderer)
    alone.add_background(game.scene.background.hex)
    alone.camera.position = (-3, 0)
    alone.draw(evil.Circle(1), at=(-3, 0), colour="orange")
    assert np.array_equal(split[:, :120], picture(alone))


def test_views_look_as_they_always_did() -> None:
    assert_golden("views", scenery("soft").capture().pixels)


def test_both_renderers_draw_the_same_views() -> None:
    soft, gl = (picture(scenery(renderer)) for renderer in RENDERERS)
    assert np.abs(soft - gl).max() <= 4


@pytest.mark.parametrize("renderer", RENDERERS)
def test_what_no_view_covers_is_black_and_text_lies_over_all(renderer: str) -> None:
    game = quiet(renderer)
    game.add_background("white")
    game.views[0].area = (0.0, 0.5, 0.5, 1.0)
    pixels = picture(game)
    assert (pixels[:80, :120, :3] == 255).all()
    assert (pixels[80:, :, :3] == 0).all()
    assert (pixels[:, 120:, :3] == 0).all()
    game.text("HHHHHHHHHHHHHH", at=(60, 100), size=24, colour="red")
    written = np.argwhere(picture(game)[..., 0] != pixels[..., 0])
    assert written[:, 1].min() < 120 < written[:, 1].max()


def test_the_later_view_is_on_top_and_may_be_hidden() -> None:
    game = quiet()
    game.draw(evil.Rectangle(2, 2), at=(9, 0), colour="lime")
    inset = game.add_view((0.4, 0.4, 0.6, 0.6), position=(9, 0))
    assert tuple(picture(game)[80, 120, :3]) == (0, 255, 0)
    inset.visible = False
    assert not picture(game)[..., :3].any()
    assert game.views.at((120, 80)) is game.views[0]


def test_a_finger_is_in_the_world_of_the_view_under_it() -> None:
    game, one, two = two_players()
    told = []

    @one.on_touch
    def _(touch: Any) -> None:
        told.append(("one", touch.at))

    @two.on_touch
    def _(touch: Any) -> None:
        told.append(("two", touch.at))

    game.device.touch(1, "began", at=(60, 80))
    game.device.touch(2, "began", at=(180, 80))
    game.step()
    assert told == [("one", Vec2(-5, 0)), ("two", Vec2(5, 0))]


def test_a_finger_stays_in_the_view_in_which_it_came_down() -> None:
    game, _, _ = two_players()
    game.device.touch(1, "began", at=(100, 80))
    game.step()
    game.device.touch(1, "moved", at=(140, 80))
    game.step()
    assert game.touches[0].at == pytest.approx((-5 + 80 / 50, 0))
    game.device.pointer((140, 80))
    game.step()
    assert game.pointer.at == pytest.approx((5 - 40 / 50, 0))


def test_cameras_tell_pixels_of_the_window() -> None:
    game, _, two = two_players()
    second = game.views[1].camera
    assert second.to_pixel(two.position) == (180, 80)
    assert second.to_world((180, 80)) == two.position
    assert second.sees(two.position)
    assert not second.sees((-5, 0))


def test_views_follow_the_windows_size() -> None:
    game, _, _ = two_players()
    game.device.resize((480, 200))
    game.step()
    assert [view.camera.size for view in game.views] == [(240, 200), (240, 200)]
    assert game.views[1].camera.corner == (240, 0)
    assert game.capture().size == (480, 200)


@pytest.mark.parametrize(("count", "stacked", "areas"), [
    (1, False, ["all"]), (2, False, ["left", "right"]), (2, True, ["top", "bottom"]),
    (3, False, ["top left", "top right", "bottom"]),
    (4, False, ["top left", "top right", "bottom left", "bottom right"]),
])  # fmt: skip
def test_a_window_is_shared_out(count: int, stacked: bool, areas: list[str]) -> None:
    game = quiet()
    balls = [game.add(evil.Circle(0.5), at=(3 * n, 0)) for n in range(4)]
    game.split(*balls)
    views = game.split(*balls[:count], stacked=stacked)
    assert [repr(view) for view in game.views] == [f"<View {area}>" for area in areas]
    assert tuple(game.views) == views
    assert [view.camera.position.x for view in views] == [3 * n for n in range(count)]


def test_each_camera_follows_and_keeps_to_its_bounds() -> None:
    game, one, two = two_players()
    game.views[1].camera.bounds = (2, -9, 5.2, 9)
    one.velocity = (-3, 0)
    two.velocity = (3, 0)
    game.step(60)
    assert game.camera.position.x == pytest.approx(one.position.x, abs=0.6)
    assert game.views[1].camera.position.x == pytest.approx(5.2 - 1.2)


def test_a_view_that_is_gone_says_so() -> None:
    game, _, _ = two_players()
    second = game.views[1]
    second.destroy()
    assert (len(game.views), second.alive, game.views[0].alive) == (1, False, True)
    with pytest.raises(StaleReferenceError, match="destroyed"):
        second.destroy()
    with pytest.raises(evil.ArgumentError, match="visible=False"):
        game.views[0].destroy()


@pytest.mark.parametrize(
    ("area", "words"),
    [
        ("lef", "did you mean 'left'"),
        ((0, 0, 1), "left, bottom, right, top"),
        ((0, 0, 0, 1), "left < right"),
        ((0, 0.5, 1, 0.2), "y is up"),
        ((0, 0, 2, 1), "at most 1"),
        ((0, 0, float("nan"), 1), "finite"),
        (7, "left, bottom, right, top"),
    ],
)
def test_a_bad_area_is_refused_and_changes_nothing(area: Any, words: str) -> None:
    game = quiet()
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=words):
        game.add_view(area)
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=words):
        game.views[0].area = area
    assert len(game.views) == 1
    assert game.views[0].area == (0, 0, 1, 1)


def test_bad_views_are_refused() -> None:
    game, one, two = two_players()
    nobody: Any = "hero"
    with pytest.raises(evil.ArgumentTypeError, match="must be a body or a character"):
        game.split(two, nobody)
    with pytest.raises(evil.ArgumentError, match="one to four"):
        game.split()
    with pytest.raises(evil.ArgumentTypeError, match="must be a body or a character"):
        game.add_view("left", follow=nobody)
    with pytest.raises(evil.ArgumentTypeError, match="did you mean 'follow'"):
        game.add_view("left", folow=one)  # type: ignore[call-arg]
    with pytest.raises(evil.ArgumentError, match="zoom"):
        game.add_view("left", zoom=0)
    assert [view.camera.following for view in game.views] == [one, two]
    for _ in range(30):
        game.add_view("left")
    with pytest.raises(evil.ArgumentError, match="32 views"):
        game.add_view("left")


def test_each_sound_is_heard_from_the_nearest_player(tmp_path: Path) -> None:
    game = evil.Game(headless=True, renderer="soft", sound="none", gravity=(0, 0))
    one, two = (game.add(evil.Circle(0.5), at=(x, 0)) for x in (-40, 40))
    game.add_view((0.8, 0.8, 1, 1), follow=two)
    game.step()
    near_two = evil.Vec2(43.0, 0.0)
    assert from_place(near_two, game.audio.listener)[0] < 0.2, "a map hears nothing"
    game.split(one, two)
    game.step()
    assert from_place(near_two, game.audio.listener) == (1.0, pytest.approx(3 / 8))
    assert from_place(evil.Vec2(-43.0, 0.0), game.audio.listener) == (1.0, pytest.approx(-3 / 8))
    data = saving.to_bytes(game)
    game.split(one)
    game.step()
    assert from_place(near_two, game.audio.listener)[0] < 0.1
    saving.from_bytes(game, data, "saved")
    assert [view.hears for view in game.views] == [True, True]


def test_a_saved_game_has_its_views(tmp_path: Path) -> None:
    game, _, two = two_players()
    game.views[1].camera.zoom = 2.0
    game.step(3)
    inset = game.add_view((0.4, 0.7, 0.6, 0.9), position=(1, 2))
    inset.visible = False
    game.device.touch(1, "began", at=(100, 80))
    game.step()
    game.save("s", folder=tmp_path)
    before = game.capture().tobytes()
    game.split(two)
    game.resume("s", folder=tmp_path)
    assert [view.alive for view in game.views] == [True] * 3
    assert game.capture().tobytes() == before
    assert game.views[1].camera.following == two
    other = quiet()
    other.resume("s", folder=tmp_path)
    assert other.capture().tobytes() == before
    assert [view.visible for view in other.views] == [True, True, False]
    other.step(60)
    game.step(60)
    assert other.capture().tobytes() == game.capture().tobytes()


def test_a_scene_begins_with_the_views_that_the_game_was_made_with() -> None:
    game = quiet()
    map_of_all = game.add_view((0.7, 0.7, 1, 1), view_height=30)

    @game.scenes
    def play() -> None:
        balls = [game.add(evil.Circle(0.5), at=(x, 0)) for x in (-5, 5)]
        game.split(*balls)

    @game.scenes
    def menu() -> None:
        game.text("menu")

    game.go("play")
    assert (len(game.views), map_of_all.alive) == (2, False)
    game.go("menu")
    assert (list(game.views), map_of_all.alive) == ([game.views[0], map_of_all], True)
    assert game.views[0].area == (0, 0, 1, 1)
    assert game.camera.following is None


def test_a_recording_of_a_split_screen_plays_the_same(tmp_path: Path) -> None:
    def begun() -> evil.Game:
        game, _, _ = two_players()
        game.views[1].camera.bounds = (0, -9, 9, 9)
        for ball in game.world.bodies:
            ball.touchable = True
        return game

    game = begun()
    recording = game.record(tmp_path / "r.evr")
    game.device.touch(1, "began", at=(180, 80))
    game.step(5)
    game.device.touch(1, "moved", at=(100, 60))
    game.step(30)
    recording.close()
    again = begun()
    playback = again.replay(tmp_path / "r.evr")
    again.step(35)
    assert playback.over
    assert playback.difference is None
    assert again.capture().tobytes() == game.capture().tobytes()


def test_views_that_go_leave_nothing_on_the_card() -> None:
    game, one, two = two_players("gl")
    game.split(one)
    game.capture()
    device = game.renderer._opened().device  # type: ignore[attr-defined]
    before = device.counts()
    game.split(one, two)
    game.capture()
    assert device.counts() != before
    game.split(one)
    game.capture()
    assert device.counts() == before


LEVEL = """
new circle one 0.5 at -5 0 physicsOn velocity -1 0;
new circle two 0.5 at 5 0 physicsOn velocity 1 0;
split one two;
on key "s" { split one; }
"""


def test_a_level_splits_the_screen_and_gives_it_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    game = quiet()
    made = level.build(script.read(LEVEL), game)
    assert [view.camera.following for view in game.views] == [made["one"], made["two"]]
    program = translate(script.read(LEVEL))
    assert "game.split(one, two)" in program
    game.save("s", folder=tmp_path)
    game.device.tap("s")
    game.step()
    assert len(game.views) == 1
    game.resume("s", folder=tmp_path)
    assert len(game.views) == 2


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("split;", "split needs the names of one to four things"),
        ("new circle one 1 at 0 0; split one tow;", "no thing called 'tow'"),
        ("new circle one 1 at 0 0; split one 3;", "split takes names of things"),
        ("splitScreen one;", "did you mean 'split'"),
    ],
)
def test_bad_words_of_a_split_are_named(text: str, words: str) -> None:
    _, errors = script.check(text)
    assert any(words in f"{each.headline} {each.suggestion}" for each in errors)


@pytest.mark.parametrize("width", [37, 61, 100])
def test_no_view_draws_beyond_its_side(width: int) -> None:
    """With all that goes over whole rows, eight pixels at a time, beside a view that is as it would be alone."""

    def dressed(game: evil.Game) -> evil.Game:
        game.draw(evil.Rectangle(30, 20), layer=-2, colour="#8899aa", lit=True)
        game.draw(evil.Circle(1), at=(0.5, 0), layer=-1, colour="#ffe0a080", lit=True)
        game.layers[-2].blur, game.layers[-2].shafts.at, game.layers[-1].fog = 2, (1, 1), "#ffd0a040"
        game.add_light(at=(0, 1), radius=3)
        game.post.bloom, game.post.grain, game.post.vignette = 0.5, 0.2, 0.5
        return game

    game = dressed(quiet())
    game.views[0].area = (0, 0, width / 240, 1)
    game.add_view((width / 240, 0, 1, 1), position=(2, 0))
    split = picture(game)
    for left, right, at in ((0, width, (0, 0)), (width, 240, (2, 0))):
        alone = evil.Game(size=(right - left, 160), headless=True, renderer="soft")
        alone.add_background("black")
        alone.camera.position = at
        assert np.array_equal(split[:, left:right], picture(dressed(alone)))
