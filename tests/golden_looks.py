"""The games of the golden pictures: what an author sees of sheets, borders, tiles and blending."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path

import PIL.Image
import PIL.ImageDraw
import PIL.ImageFont

import evilengine as evil

Draw = Callable[[evil.Game], None]


def paint_pictures(folder: Path) -> None:
    """The pictures that the games show, drawn here."""
    strip = PIL.Image.new("RGBA", (128, 32))
    draw = PIL.ImageDraw.Draw(strip)
    for frame, narrow in enumerate((0, 5, 11, 5)):  # a coin that turns
        left = frame * 32
        draw.ellipse((left + 2 + narrow, 2, left + 29 - narrow, 29), fill="#f2b705", outline="#8a5a00", width=2)
        draw.ellipse((left + 8 + narrow // 2, 8, left + 23 - narrow // 2, 23), fill="#ffd94a")
    strip.save(folder / "coin.png")
    panel = PIL.Image.new("RGBA", (48, 48))
    PIL.ImageDraw.Draw(panel).rounded_rectangle((0, 0, 47, 47), 12, fill="#2c3a63f0", outline="#d9b65a", width=4)
    panel.save(folder / "panel.png")
    face = PIL.ImageFont.load_default(20)
    assert isinstance(face, PIL.ImageFont.FreeTypeFont)
    assert isinstance(face.path, io.BytesIO)
    (folder / "title.ttf").write_bytes(face.path.getvalue())
    brick = PIL.Image.new("RGBA", (32, 32), "#8a4b3a")
    draw = PIL.ImageDraw.Draw(brick)
    for line in ((0, 0, 31, 0), (0, 16, 31, 16), (8, 0, 8, 16), (24, 16, 24, 31)):
        draw.line(line, fill="#5e2f25", width=2)
    brick.save(folder / "brick.png")


def sheets(game: evil.Game) -> None:
    coin = evil.Sheet("coin.png", 4, fps=8, animations={"turn": evil.Animation(range(4), course="back")})
    for place in range(6):
        game.sprite(coin, at=(-1.75 + 0.7 * place, 0.9)).play("turn", start=place / 8)
    game.sprite(coin, at=(-1.6, 0.1), height=0.7, angle=0.4)
    game.sprite("panel.png", at=(0.4, 0.15), size=(2.6, 0.7), slice=14)
    game.sprite("panel.png", at=(1.2, -0.75), size=(1.0, 0.6), slice=14, angle=0.15)
    game.draw(evil.Rectangle(2.1, 0.64), at=(-0.8, -0.8), texture="brick.png", tile=0.32)
    game.sprite("coin.png", at=(0.4, 0.15), height=0.2, flip_x=True, colour="#80ffd0")
    game.step(5)


def blends(game: evil.Game) -> None:
    game.draw(evil.Rectangle(4, 0.8), at=(0, 0.5), texture="brick.png", tile=0.32)
    for place, blend in enumerate(("normal", "add", "multiply", "screen")):
        x = -1.5 + place
        game.draw(evil.Circle(0.45), at=(x, 0.4), colour="#ffa040c0", blend=blend)
        game.draw(evil.Triangle((-0.4, 0), (0.4, 0), (0, 0.7)), at=(x, -0.9), colours=["#f00", "#0f0", "#00f"])
        game.draw(evil.Rectangle(0.3, 0.8), at=(x, -0.6), angle=0.5, texture="coin.png", blend=blend)


def letters(game: evil.Game) -> None:
    game.text("AVATAR To Wave", at=(8, 4), size=22, font="title.ttf", colour="#ffe9b0")
    story = ["The ", ("lamp", "gold"), " swings in the ", ("wind", "#6cc4ff"), ", and the long shadows swing along."]
    game.text(story, at=(8, 36), size=11, width=110, align="left")
    game.text("Words that end\ntogether", at=(8, 8), size=12, anchor="bottom right", font="title.ttf")
    game.text("in the middle\nof its block", at=(8, 40), size=11, anchor="top right", align="centre", colour="#9fe8a8")


LOOKS: dict[str, Draw] = {"looks_sheets": sheets, "looks_blends": blends, "looks_letters": letters}


def played(name: str, renderer: str, folder: Path) -> evil.Game:
    """The game called so, ready to be captured."""
    paint_pictures(folder)
    game = evil.Game(headless=True, renderer=renderer, size=(200, 120), gravity=(0, 0), folder=folder)
    LOOKS[name](game)
    return game
