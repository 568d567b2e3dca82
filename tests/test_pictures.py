"""Textures as a game's author meets them: found beside the script or level, loaded once, kept up to date, dense."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import PIL.Image
import pytest

import evilengine as evil
from evilengine.assets import Images, Pictures
from evilengine.cli.player import Player
from evilengine.platform import HeadlessDevice
from evilengine.values.events import ResizeEvent
from evilengine.values.image import Image

RED, BLUE, GREEN = (255, 0, 0, 255), (0, 0, 255, 255), (0, 255, 0, 255)


class Shelf:
    """A renderer as far as pictures know it: keeps what it was given."""

    def __init__(self) -> None:
        self.images: list[Image] = []
        self.updates = 0

    def upload(self, image: Image) -> int:
        self.images.append(image)
        return len(self.images)

    def update(self, texture: int, image: Image) -> None:
        self.images[texture - 1] = image
        self.updates += 1


def paint(file: Path, colour: tuple[int, ...], size: tuple[int, int] = (8, 8)) -> None:
    """Save a picture, with a time of change of its own however fast the test is."""
    PIL.Image.new("RGBA", size, colour).save(file)
    touch(file)


def touch(file: Path) -> None:
    touch.clock += 10**9  # type: ignore[attr-defined]
    os.utime(file, ns=(touch.clock, touch.clock))  # type: ignore[attr-defined]


touch.clock = 10**18  # type: ignore[attr-defined]


def first_pixel(image: Image) -> tuple[int, ...]:
    return tuple(image.tobytes()[:4])


def middle(game: evil.Game) -> tuple[int, ...]:
    image = game.capture()
    at = (image.height // 2 * image.width + image.width // 2) * 4
    return tuple(image.tobytes()[at : at + 4])


@pytest.fixture
def shelf() -> Shelf:
    return Shelf()


# Found and loaded once


def test_a_picture_is_uploaded_once_whatever_it_is_called(tmp_path, shelf):
    paint(tmp_path / "crate.png", RED)
    pictures = Pictures(shelf, Images(tmp_path))
    names = ["crate.png", "./crate.png", "crate.png", str(tmp_path / "crate.png")]
    assert {pictures.texture(name) for name in names} == {1}
    assert len(shelf.images) == 1


def test_pictures_of_any_size_keep_it(tmp_path, shelf):
    pictures = Pictures(shelf, Images(tmp_path))
    for width, height in ((1, 1), (3, 1000), (257, 129)):
        paint(tmp_path / f"{width}.png", RED, (width, height))
        assert pictures.size(f"{width}.png") == (width, height)


def test_a_missing_picture_adds_nothing(tmp_path):
    game = evil.Game(headless=True, folder=tmp_path)
    with pytest.raises(evil.AssetError, match=r"crate\.png"):
        game.add(evil.Rectangle(1, 1), texture="crate.png")
    assert len(game.world.bodies) == 0


def test_a_level_finds_its_pictures_beside_itself(tmp_path):
    levels = tmp_path / "levels"
    levels.mkdir()
    paint(levels / "crate.png", RED)
    paint(tmp_path / "crate.png", BLUE)  # the script's own crate stays its own
    (levels / "one.evil").write_text('new rectangle box 2 2 at 0 0 texture "crate.png";')
    game = evil.Game(headless=True, folder=tmp_path)
    level = game.load("levels/one.evil")
    assert middle(game) == RED
    assert level["box"].drawings[0].texture == "levels/crate.png"
    level["box"].drawings[0].texture = "crate.png"
    assert middle(game) == BLUE


def test_a_level_in_the_games_own_folder_names_its_pictures_as_they_are(tmp_path):
    paint(tmp_path / "crate.png", RED)
    (tmp_path / "one.evil").write_text('background "crate.png"; new rectangle box 2 2 at 0 0 texture "crate.png";')
    game = evil.Game(headless=True, folder=tmp_path)
    assert game.load("one.evil")["box"].drawings[0].texture == "crate.png"


# Dense screens


def test_a_dense_screen_gets_the_dense_picture_as_large_as_the_other(tmp_path, shelf):
    paint(tmp_path / "crate.png", RED, (10, 6))
    paint(tmp_path / "crate@2x.png", BLUE, (20, 12))
    for scale, colour in ((1.0, RED), (1.25, RED), (1.5, BLUE), (3.0, BLUE)):
        pictures = Pictures(shelf, Images(tmp_path), scale=scale)
        assert first_pixel(shelf.images[pictures.texture("crate.png") - 1]) == colour
        assert pictures.size("crate.png") == (10, 6)


def test_the_one_density_that_there_is_serves_every_screen(tmp_path, shelf):
    paint(tmp_path / "only@2x.png", BLUE, (20, 12))
    paint(tmp_path / "plain.png", RED, (10, 6))
    for scale in (1.0, 2.0):
        pictures = Pictures(shelf, Images(tmp_path), scale=scale)
        assert pictures.size("only.png") == (10, 6)
        assert pictures.size("plain.png") == (10, 6)


def test_a_window_that_moves_to_a_dense_screen_takes_the_dense_pictures(tmp_path):
    class Moving(HeadlessDevice):
        scale = 1.0

        def poll(self):
            return (ResizeEvent(self.size, self.pixel_size),)

    paint(tmp_path / "crate.png", RED)
    paint(tmp_path / "crate@2x.png", BLUE)
    device = Moving((200, 100))
    game = evil.Game(device=device, folder=tmp_path)
    game.draw(evil.Rectangle(2, 2), texture="crate.png")
    assert middle(game) == RED
    Moving.scale = 2.0
    game.step()
    assert middle(game) == BLUE
    (tmp_path / "crate.png").write_bytes(b"broken meanwhile")
    Moving.scale = 1.0
    game.step()
    assert middle(game) == BLUE
    assert [line.endswith("it is shown as it was") for line in game.reload_images()] == [True]
    paint(tmp_path / "crate.png", RED)
    assert game.reload_images() == []
    assert middle(game) == RED


def test_a_sprite_is_as_large_as_its_picture_on_every_screen(tmp_path):
    paint(tmp_path / "tree.png", RED, (40, 100))
    paint(tmp_path / "tree@2x.png", RED, (80, 200))
    for scale in (1.0, 2.0):
        game = evil.Game(device=HeadlessDevice((400, 300), scale=scale), folder=tmp_path)
        game.add_background("black")
        game.sprite("tree.png")
        pixels = game.capture().tobytes()
        red = sum(pixels[at] == 255 for at in range(0, len(pixels), 4))
        assert red == 40 * 100 * scale**2


def test_a_sprite_can_be_given_a_height_and_a_body(tmp_path):
    paint(tmp_path / "hat.png", RED, (30, 10))
    game = evil.Game(headless=True, folder=tmp_path)
    ball = game.add(evil.Circle(1), at=(3, 3))
    hat = game.sprite("hat.png", height=0.5, body=ball, layer=1)
    assert hat.body is ball
    assert ball.drawings[-1] == hat
    with pytest.raises(evil.ArgumentError, match="height=0"):
        game.sprite("hat.png", height=0)


# Files that change


def test_a_changed_picture_is_shown_as_it_is_now(tmp_path):
    paint(tmp_path / "crate.png", RED)
    game = evil.Game(headless=True, folder=tmp_path)
    game.draw(evil.Rectangle(2, 2), texture="crate.png")
    assert middle(game) == RED
    paint(tmp_path / "crate.png", BLUE, (17, 5))
    assert game.reload_images() == []
    assert middle(game) == BLUE


def test_pictures_that_did_not_change_are_not_decoded_again(tmp_path, shelf):
    paint(tmp_path / "crate.png", RED)
    pictures = Pictures(shelf, Images(tmp_path))
    pictures.texture("crate.png")
    for _ in range(3):
        assert pictures.reload() == []
    assert shelf.updates == 0


def test_a_broken_picture_stays_as_it_was_and_is_reported_once(tmp_path):
    paint(tmp_path / "crate.png", RED)
    game = evil.Game(headless=True, folder=tmp_path)
    game.draw(evil.Rectangle(2, 2), texture="crate.png")
    (tmp_path / "crate.png").write_bytes((tmp_path / "crate.png").read_bytes()[:40])
    touch(tmp_path / "crate.png")
    (line,) = game.reload_images()
    assert "crate.png" in line
    assert line.endswith("it is shown as it was")
    assert "\n" not in line
    assert game.reload_images() == []
    assert middle(game) == RED
    paint(tmp_path / "crate.png", GREEN)
    assert game.reload_images() == []
    assert middle(game) == GREEN


def test_a_picture_that_is_gone_for_a_moment_is_no_change(tmp_path):
    paint(tmp_path / "crate.png", RED)
    game = evil.Game(headless=True, folder=tmp_path)
    game.draw(evil.Rectangle(2, 2), texture="crate.png")
    (tmp_path / "crate.png").rename(tmp_path / "away.png")
    assert game.reload_images() == []
    assert middle(game) == RED
    paint(tmp_path / "crate.png", BLUE)
    assert game.reload_images() == []
    assert middle(game) == BLUE


@pytest.mark.parametrize("kind", ["level", "script"])
def test_evil_play_shows_pictures_as_they_change(tmp_path, capsys, kind):
    """While a level or a script plays: painted over, broken, and mended."""
    paint(tmp_path / "crate.png", RED)
    path = tmp_path / ("level.evil" if kind == "level" else "script.py")
    if kind == "level":
        path.write_text('new rectangle box 2 2 at 0 0 texture "crate.png";')
    else:
        path.write_text(
            "import evilengine as evil\n"
            f"game = evil.Game(folder={str(tmp_path)!r})\n"
            'game.draw(evil.Rectangle(2, 2), texture="crate.png")\n'
            "game.run()\n"
        )
    seen: list[tuple[int, ...]] = []

    class Watched(HeadlessDevice):
        def show(self, pixels, size):
            super().show(pixels, size)
            seen.append(middle_of(self.shown))
            if len(seen) == 10:
                paint(tmp_path / "crate.png", BLUE)
            elif len(seen) == 20:
                (tmp_path / "crate.png").write_bytes(b"no picture at all")
                touch(tmp_path / "crate.png")
            elif len(seen) == 30:
                paint(tmp_path / "crate.png", GREEN)
            elif len(seen) == 40:
                self.close_requested()

        def close_requested(self):
            player.game.quit()

    def middle_of(image):
        assert image is not None
        at = (image.height // 2 * image.width + image.width // 2) * 4
        return tuple(image.tobytes()[at : at + 4])

    now = iter(count / 10 for count in range(sys.maxsize))
    player = Player(path, device=Watched((200, 100)), clock=lambda: next(now))
    player.play()
    assert [seen[5], seen[17], seen[27], seen[38]] == [RED, BLUE, BLUE, GREEN]
    notices = [line for line in capsys.readouterr().err.splitlines() if "crate.png" in line]
    assert len(notices) == 1
