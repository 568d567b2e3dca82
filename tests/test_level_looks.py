"""Level words for pictures, text and the camera: frames, fps, tile, width, follow, quake."""

from __future__ import annotations

from pathlib import Path

import PIL.Image
import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.scene import Drawing, DrawnBody, Text
from evilengine.script.translate import translate

LEVEL = """
new circle coin 0.5 at 1 2 texture "coin.png" frames 4 1 fps 30;
new rectangle 6 1 at 0 -3 texture "coin.png" tile 0.5;
draw circle star 0.5 at 3 3 texture "coin.png" frames 2 2;
new circle ball 0.5 at 4 0 physicsOn velocity 2 0;
text story "A long line of words that breaks" at 20 20 width 120;
follow ball;
on key "q" { quake 15; }
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    PIL.Image.new("RGBA", (40, 40), "gold").save(tmp_path / "coin.png")
    (tmp_path / "level.evil").write_text(LEVEL)
    return tmp_path


def played(folder: Path, text: str = LEVEL) -> tuple[evil.Game, level.Level]:
    game = evil.Game(headless=True, renderer="soft", folder=folder, gravity=(0, 0))
    return game, level.build(script.read(text), game)


def test_a_picture_with_frames_shows_them_in_turn(folder: Path) -> None:
    game, made = played(folder)
    coin, star = made["coin"], made["star"]
    assert isinstance(coin, DrawnBody)
    assert isinstance(star, Drawing)
    shown = []
    for _ in range(8):
        shown.append(coin.drawings[0].frame)
        game.step()
    assert shown == [0, 0, 1, 1, 2, 2, 3, 3]
    assert star.playing


def test_the_camera_follows_and_shakes(folder: Path) -> None:
    game, made = played(folder)
    game.step(120)
    assert game.camera.position.x > 3
    assert game.camera.following is made["ball"]
    still = game.camera.matrix()
    game.device.tap("q")
    game.step(2)
    assert abs(game.camera.matrix()[5] - still[5]) > 0.5
    story = made["story"]
    assert isinstance(story, Text)
    assert story.width == 120


def test_it_is_saved_and_goes_on_the_same(folder: Path) -> None:
    game, _ = played(folder)
    game.step(10)
    game.save("s", folder=folder)
    picture = game.capture().tobytes()
    game.step(10)
    game.resume("s", folder=folder)
    assert game.capture().tobytes() == picture


def test_the_level_in_python_looks_the_same(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = translate(script.read(LEVEL))
    made: list[evil.Game] = []

    class Shown(evil.Game):
        def __init__(self, *args: object, **options: object) -> None:
            given = {**options, "headless": True, "renderer": "soft", "folder": folder, "gravity": (0, 0)}
            super().__init__(*args, **given)  # type: ignore[arg-type]
            made.append(self)

        def run(self, seconds: float | None = None) -> None:
            self.step(30)

    monkeypatch.setattr(evil, "Game", Shown)
    exec(compile(program, "level.py", "exec"), {"__name__": "__main__"})
    game, _ = played(folder)
    game.step(30)
    assert made[0].capture().tobytes() == game.capture().tobytes()
    assert "evil.Sheet(" in program


def test_a_world_alone_has_no_use_for_looks() -> None:
    world = evil.World()
    level.build(script.read('new circle 1 at 0 0 texture "coin.png" frames 4 1 tile 1;'), world)
    assert len(world.bodies) == 1


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("new circle 1 at 0 0 tile 1;", "tile needs texture"),
        ("new circle 1 at 0 0 frames 2 2;", "frames needs texture"),
        ('new circle 1 at 0 0 texture "coin.png" fps 3;', "fps needs frames"),
        ('new circle 1 at 0 0 texture "coin.png" frames 2.5 1;', "a whole number"),
        ('new circle 1 at 0 0 texture "coin.png" frames 0 1;', "the columns of frames cannot be 0"),
        ('new circle 1 at 0 0 texture "coin.png" sheet 4 1;', "did you mean 'frames'"),
        ("follow;", "follow needs the name of a thing"),
        ("follow bal; ", "no thing called 'bal'"),
        ("quake -1;", "quake cannot be -1"),
        ("track ball;", "did you mean 'follow'"),
        ('text "a" at 0 0 width 0;', "width cannot be 0"),
    ],
)
def test_bad_words_are_named(text: str, words: str) -> None:
    _, errors = script.check(text)
    assert errors
    assert any(words in f"{each.headline} {each.suggestion}" for each in errors)
