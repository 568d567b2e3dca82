"""The camera by itself: it follows with a dead zone, glides, keeps to its bounds, shakes, and is saved in all that."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from stage import Stage

import evilengine as evil
from evilengine.scene import Camera

SIZE = (500, 250)  # 10 x 5 metres


@pytest.fixture
def game() -> evil.Game:
    return evil.Game(headless=True, renderer="soft", size=SIZE, gravity=(0, 0))


def test_what_is_in_the_dead_zone_moves_nothing_and_what_leaves_it_pulls(game: evil.Game) -> None:
    hero = game.add(evil.Circle(0.5))
    game.camera.follow(hero, dead_zone=(4, 2), smoothing=0)
    for at, camera in [((1.9, 0.9), (0, 0)), ((3, 0), (1, 0)), ((3, -2), (1, -1)), ((-3, -1.5), (-1, -1))]:
        hero.position = at
        game.step()
        assert game.camera.position == pytest.approx(camera)


def test_smoothing_comes_after_without_ever_passing(game: evil.Game) -> None:
    hero = game.add(evil.Circle(0.5), at=(6, 0))
    game.camera.follow(hero, smoothing=0.2)
    gone = []
    for _ in range(90):
        game.step()
        gone.append(game.camera.position.x)
    assert gone == sorted(gone)
    assert gone[-1] < 6
    assert gone[11] == pytest.approx(6 * (1 - math.exp(-1)), rel=0.05)  # most of the way in 0.2 s
    assert gone[-1] > 5.9


def test_a_turned_camera_has_its_dead_zone_along_the_screen(game: evil.Game) -> None:
    hero = game.add(evil.Circle(0.5), at=(0, 3))
    game.camera.angle = math.pi / 2  # the screen's right is the world's up
    game.camera.follow(hero, dead_zone=(8, 0), smoothing=0)
    game.step()
    assert game.camera.position == pytest.approx((0, 0))
    hero.position = (1, 5)
    game.step()
    assert game.camera.position == pytest.approx((1, 1), abs=1e-6)


def test_it_follows_a_character_with_an_offset_until_that_is_gone(game: evil.Game) -> None:
    hero = game.add_character(at=(2, 0))
    game.camera.follow(hero, offset=(1, 0.5), jump=True, smoothing=0)
    assert game.camera.position == pytest.approx((3, 0.5))
    assert game.camera.following is hero
    hero.body.destroy()
    game.step(3)
    assert game.camera.following is None
    assert game.camera.position == pytest.approx((3, 0.5), abs=0.01)


def test_nothing_beyond_the_bounds_is_seen(game: evil.Game) -> None:
    camera, hero = game.camera, game.add(evil.Circle(0.5))
    camera.bounds = (-8, -3, 8, 3)
    camera.follow(hero, smoothing=0)
    for at, expected in [((7, 0), (3, 0)), ((-20, 9), (-3, 0.5)), ((1, -9), (1, -0.5))]:
        hero.position = at
        game.step()
        assert camera.position == pytest.approx(expected)
    camera.zoom = 0.5  # 20 x 10 metres: more than there is
    game.step()
    assert camera.position == (0, 0)
    camera.angle, camera.zoom = math.pi / 2, 1.0  # 5 x 10 metres
    game.step()
    assert camera.position == pytest.approx((1, 0))


def test_a_glide_arrives_softly_and_exactly() -> None:
    camera = Camera(SIZE, position=(1, 1))
    camera.glide((5, -1), zoom=3, angle=1.0, seconds=0.5)
    moves = []
    for _ in range(30):
        before = camera.position
        camera.step()
        moves.append((camera.position - before).length)
    assert (camera.position, camera.zoom, camera.angle) == ((5, -1), 3, 1.0)
    assert moves[0] < 0.1 * max(moves) > moves[-1]
    camera.step()
    assert camera.position == (5, -1)


def test_between_two_steps_the_picture_lies_between_and_after_a_jump_it_does_not() -> None:
    camera = Camera(SIZE)
    camera.glide((6, 0), seconds=2 / 60)
    camera.step()
    assert camera.position == (3, 0)
    assert camera.matrix(alpha=0.5)[4] == pytest.approx(250 - 50 * 1.5)
    assert camera.matrix()[4] == pytest.approx(250 - 50 * 3)
    camera.position = (9, 0)
    assert camera.matrix(alpha=0.5)[4] == pytest.approx(250 - 50 * 9)


def test_a_shake_moves_the_picture_alone_and_dies_away() -> None:
    camera = Camera(SIZE)
    camera.shake(20, seconds=0.5)
    away = []
    for _ in range(30):
        x, y = camera.matrix()[4:]
        away.append(math.hypot(x - 250, y - 125))
        assert camera.to_pixel((0, 0)) == (250, 125)
        camera.step()
    assert max(away[:10]) > 10
    assert max(away) <= 20 * math.sqrt(2)
    assert max(away[25:]) < 1
    assert camera.matrix()[4:] == (250, 125)


def test_a_weaker_shake_does_not_end_a_stronger_one() -> None:
    camera = Camera(SIZE)
    camera.shake(20, seconds=1)
    camera.shake(2, seconds=0.1)
    for _ in range(7):
        camera.step()
    assert camera.matrix()[4:] != (250, 125)


def test_a_picture_is_shaken_and_then_as_it_was() -> None:
    stage = Stage()
    stage.scene.add(evil.Rectangle(1, 1), colour="red")
    still = bytes(stage.show())
    stage.camera.shake(10)
    assert bytes(stage.show()) != still
    for _ in range(60):
        stage.camera.step()
    assert bytes(stage.show()) == still


def test_saved_in_the_middle_it_goes_on_the_same(game: evil.Game, tmp_path: Path) -> None:
    def play() -> evil.Game:
        game = evil.Game("Cam", headless=True, renderer="soft", size=SIZE, gravity=(0, 0))
        hero = game.add(evil.Circle(0.5), velocity=(5, 1), damping=1.0, tag="hero")
        game.camera.bounds = (-20, -20, 20, 20)
        game.camera.follow(hero, dead_zone=(1, 1), smoothing=0.3, offset=(0.5, 0))
        game.camera.shake(15, seconds=2)
        return game

    first = play()
    first.step(20)
    first.save("mid", folder=tmp_path)
    views = []
    for _ in range(40):
        first.step()
        views.append(first.camera.matrix())
    second = evil.Game("Cam", headless=True, renderer="soft", size=SIZE, gravity=(0, 0))
    second.resume("mid", folder=tmp_path)
    for view in views:
        second.step()
        assert second.camera.matrix() == view
    assert second.camera.bounds == (-20, -20, 20, 20)
    assert second.camera.following == second.world.find("hero")


def test_a_glide_is_saved_too(game: evil.Game, tmp_path: Path) -> None:
    game.camera.glide((4, 0), seconds=1)
    game.step(30)
    game.save("glide", folder=tmp_path)
    game.step(30)
    game.resume("glide", folder=tmp_path)
    assert game.camera.position == (2, 0)
    game.step(30)
    assert game.camera.position == (4, 0)


def test_another_scene_begins_with_the_cameras_own_bounds(game: evil.Game) -> None:
    game.camera.bounds = (-9, -9, 9, 9)

    @game.scenes
    def play(wide: bool) -> None:
        if wide:
            game.camera.bounds = (0, 0, 40, 40)
            game.camera.follow(game.add(evil.Circle(1)))
            game.camera.shake()

    game.go("play", True)
    game.step(5)
    game.go("play", False)
    assert game.camera.bounds == (-9, -9, 9, 9)
    assert game.camera.following is None
    assert game.camera.matrix()[4:] == (250, 125)


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (lambda camera: camera.follow(3), "target=3 must be a body"),
        (lambda camera: camera.follow(dead_sone=2), "did you mean 'dead_zone'"),
        (lambda camera: setattr(camera, "bounds", (1, 0, 0, 1)), "left < right"),
        (lambda camera: setattr(camera, "bounds", 4), "bounds=4 must be left"),
        (lambda camera: camera.glide((0, 0), seconds=0), "seconds=0"),
        (lambda camera: camera.glide(zoom=math.nan), "zoom=nan"),
        (lambda camera: camera.shake(-1), "strength=-1"),
    ],
)
def test_bad_words_about_the_camera_are_named(bad: object, words: str) -> None:
    with pytest.raises(evil.Error, match=words):
        bad(Camera(SIZE))  # type: ignore[operator]


def test_following_what_is_gone_says_so(game: evil.Game) -> None:
    ball = game.add(evil.Circle(0.5))
    ball.destroy()
    with pytest.raises(evil.StaleReferenceError):
        game.camera.follow(ball)
    assert game.camera.following is None
