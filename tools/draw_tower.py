#!/usr/bin/env python3
"""Draw the pictures of the example game "tower", 100 pixels a metre: python tools/draw_tower.py

They are drawn three times as large and made smaller, so edges are smooth. Change a colour, run it, and a game that is
playing shows the new picture.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from pathlib import Path

from PIL import Image, ImageDraw, ImageFilter

FOLDER = Path(__file__).resolve().parent.parent / "src" / "evilengine" / "examples" / "tower"
FINE = 3
Box = tuple[float, float, float, float]
Rgb = tuple[int, int, int]

INK: Rgb = (43, 32, 48)


class Sheet:
    """A picture that is drawn in pixels of its final size."""

    def __init__(self, width: int, height: int) -> None:
        self.size = width, height
        self.image = Image.new("RGBA", (width * FINE, height * FINE))
        self.pen = ImageDraw.Draw(self.image, "RGBA")

    def box(self, box: Box, colour: Rgb, *, round: float = 0, ink: float = 0) -> None:
        corners = [each * FINE for each in box]
        self.pen.rounded_rectangle(corners, round * FINE, fill=colour, outline=INK, width=int(ink * FINE))

    def disc(self, x: float, y: float, r: float, colour: tuple[int, ...]) -> None:
        self.pen.ellipse([each * FINE for each in (x - r, y - r, x + r, y + r)], fill=colour)

    def shape(self, points: list[tuple[float, float]], colour: tuple[int, ...]) -> None:
        self.pen.polygon([(x * FINE, y * FINE) for x, y in points], fill=colour)

    def line(self, points: list[tuple[float, float]], colour: tuple[int, ...], width: float) -> None:
        self.pen.line([(x * FINE, y * FINE) for x, y in points], fill=colour, width=int(width * FINE), joint="curve")

    def soft(self, radius: float) -> None:
        """Blur the edge of what is there; its colour is that of the middle."""
        self.image.putalpha(self.image.getchannel("A").filter(ImageFilter.GaussianBlur(radius * FINE)))

    def save(self, name: str) -> None:
        small = self.image.resize(self.size, Image.Resampling.LANCZOS)
        small.quantize(128, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(
            FOLDER / name, optimize=True
        )


def shade(colour: Rgb, by: float) -> Rgb:
    r, g, b = (max(0, min(255, round(part * by))) for part in colour)
    return r, g, b


def crate(sheet: Sheet) -> None:
    w, h = sheet.size
    wood: Rgb = (196, 138, 84)
    sheet.box((1, 1, w - 2, h - 2), shade(wood, 0.62), round=7, ink=4)
    for row in range(4):
        top = 14 + row * (h - 28) / 4
        sheet.box((14, top, w - 15, top + (h - 28) / 4 - 2), shade(wood, (0.92, 1.04, 0.86, 0.98)[row]))
        sheet.line([(20, top + 8), (w - 24 - row * 13, top + 8 + row % 2)], (120, 76, 44, 90), 1.5)
    sheet.line([(18, h - 18), (w - 18, 18)], shade(wood, 0.55), 17)
    sheet.line([(18, h - 18), (w - 18, 18)], shade(wood, 1.12), 12)
    for box in ((4, 4, w - 5, 16), (4, h - 17, w - 5, h - 5), (4, 4, 16, h - 5), (w - 17, 4, w - 5, h - 5)):
        sheet.box(box, shade(wood, 1.18), round=3)
    sheet.box((4, 4, w - 5, 7), shade(wood, 1.35), round=2)
    for x in (10, w - 11):
        for y in (10, h - 11):
            sheet.disc(x, y, 2.6, INK)


def trunk(sheet: Sheet) -> None:
    w, h = sheet.size
    teal: Rgb = (52, 122, 128)
    sheet.box((1, 1, w - 2, h - 2), teal, round=12, ink=4)
    sheet.box((5, 5, w - 6, h * 0.36), shade(teal, 1.25), round=9)
    sheet.box((5, 5, w - 6, 11), shade(teal, 1.55), round=5)
    sheet.box((4, h * 0.37, w - 5, h * 0.42), shade(teal, 0.6))
    brass: Rgb = (226, 178, 90)
    for x in (24, w - 40):
        sheet.box((x, 3, x + 15, h - 4), brass)
        sheet.box((x, 3, x + 4, h - 4), shade(brass, 1.15))
        for y in (12, h - 13):
            sheet.disc(x + 7.5, y, 2.4, INK)
    sheet.box((w / 2 - 13, h * 0.3, w / 2 + 13, h * 0.62), brass, round=5, ink=2.5)
    sheet.disc(w / 2, h * 0.43, 3.6, INK)
    sheet.box((w / 2 - 1.5, h * 0.43, w / 2 + 1.5, h * 0.54), INK)


def parcel(sheet: Sheet) -> None:
    w, h = sheet.size
    paper: Rgb = (236, 214, 178)
    ribbon: Rgb = (206, 62, 72)
    sheet.box((1, 1, w - 2, h - 2), paper, round=6, ink=4)
    sheet.box((5, h - 22, w - 6, h - 5), shade(paper, 0.87), round=4)
    sheet.box((w / 2 - 9, 4, w / 2 + 9, h - 5), ribbon)
    sheet.box((4, h / 2 - 9, w - 5, h / 2 + 9), ribbon)
    sheet.box((w / 2 - 9, 4, w / 2 - 4, h - 5), shade(ribbon, 1.25))
    sheet.box((4, h / 2 - 9, w - 5, h / 2 - 4), shade(ribbon, 1.25))
    for side in (-1, 1):
        x = w / 2 + side * 15
        sheet.disc(x, h / 2 - 7, 13, shade(ribbon, 0.75))
        sheet.disc(x, h / 2 - 7, 8, shade(ribbon, 1.15))
    sheet.disc(w / 2, h / 2, 9, shade(ribbon, 0.9))


def island(sheet: Sheet) -> None:
    """Its flat top is the picture's line 24, from 30 to 370."""
    dice = random.Random(4)
    rock: Rgb = (84, 68, 88)
    under = [(24.0, 34.0), (60, 92), (104, 104), (136, 158), (176, 178), (206, 214), (238, 170), (280, 150), (306, 98),
             (348, 84), (376, 34)]  # fmt: skip
    sheet.shape(under, rock)
    sheet.shape(
        [(24, 34), (60, 92), (104, 104), (136, 158), (176, 178), (206, 214), (176, 110), (120, 60)], (66, 53, 74)
    )
    for _ in range(26):
        x, y = dice.uniform(60, 340), dice.uniform(44, 120)
        if abs(x - 200) < 185 - y:
            sheet.line([(x, y), (x + dice.uniform(8, 26), y + dice.uniform(-5, 5))], (108, 90, 108), 3)
    sheet.box((16, 22, 384, 44), (92, 138, 84), round=11)
    sheet.box((18, 22, 382, 29), (142, 188, 104), round=5)
    for x in range(22, 378, 9):
        sheet.line([(x, 40), (x + dice.uniform(-3, 3), 46 + dice.uniform(0, 9))], (92, 138, 84), 5)
    for x in (26, 34, 362, 371, 378):
        sheet.line([(x, 24), (x + dice.uniform(-6, 6), 8 + dice.uniform(0, 7))], (142, 188, 104), 3)


def moon(sheet: Sheet) -> None:
    for r in range(98, 60, -2):
        sheet.disc(100, 100, r, (255, 240, 205, 5 + (98 - r) // 6))
    glow = sheet.image
    sheet.image = Image.new("RGBA", glow.size)
    sheet.pen = ImageDraw.Draw(sheet.image, "RGBA")
    sheet.disc(100, 100, 58, (252, 238, 206, 255))
    for x, y, r in ((82, 84, 13), (118, 78, 8), (112, 118, 16), (78, 124, 7), (134, 106, 6), (96, 60, 6)):
        sheet.disc(x, y, r, (232, 212, 176, 255))
        sheet.disc(x + 1.5, y + 1.5, r * 0.8, (240, 223, 190, 255))
    sheet.image = Image.alpha_composite(glow.filter(ImageFilter.GaussianBlur(4 * FINE)), sheet.image)


def cloud(sheet: Sheet) -> None:
    sheet.image.paste((255, 255, 255, 0), (0, 0, *sheet.image.size))
    for x, y, r in ((60, 66, 26), (96, 50, 34), (140, 44, 38), (182, 54, 30), (212, 68, 22)):
        sheet.disc(x, y, r, (255, 255, 255, 255))
    sheet.box((40, 64, 230, 92), (255, 255, 255), round=14)
    sheet.soft(1.5)


def hills(sheet: Sheet) -> None:
    """White, so that the game can tint it: near hills dark, far ones pale."""
    w, h = sheet.size
    dice = random.Random(11)
    waves = [(dice.randint(1, 5), dice.uniform(0, 6), dice.uniform(5, 14)) for _ in range(5)]

    def top(x: float) -> float:
        return 72 + sum(high * math.sin(x / w * often * math.tau + start) for often, start, high in waves)

    sheet.shape([(0, h), *((x, top(x)) for x in range(0, w + 1, 4)), (w, h)], (255, 255, 255, 255))
    for x in range(3, w, 5):  # firs
        tall = dice.uniform(6, 17)
        sheet.shape([(x - 4, top(x) + 4), (x + 4, top(x) + 4), (x, top(x) - tall)], (255, 255, 255, 255))


def hook(sheet: Sheet) -> None:
    steel: Rgb = (120, 126, 148)
    sheet.box((8, 30, 72, 44), steel, round=6, ink=3)
    sheet.box((12, 33, 68, 37), shade(steel, 1.3), round=2)
    for x in (14, 66):
        sheet.line([(x, 42), (x + (4 if x < 40 else -4), 60)], INK, 7)
        sheet.line([(x, 42), (x + (4 if x < 40 else -4), 58)], steel, 3.5)
    sheet.disc(40, 22, 16, INK)
    sheet.disc(40, 22, 13, (232, 180, 80))
    sheet.disc(40, 22, 5, INK)


def heart(sheet: Sheet) -> None:
    for grow, colour in ((0, INK), (-3.5, (226, 66, 84))):
        for x in (17, 35):
            sheet.disc(x, 18, 13 + grow, (*colour, 255))
        sheet.shape([(5 - grow, 23), (47 + grow, 23), (26, 47 + grow * 1.4)], (*colour, 255))
    sheet.box((15, 15, 37, 24), (226, 66, 84))
    sheet.disc(14, 15, 4, (255, 170, 170, 255))


PICTURES: dict[str, tuple[int, int, Callable[[Sheet], None]]] = {
    "crate.png": (150, 100, crate),
    "trunk.png": (190, 90, trunk),
    "parcel.png": (120, 110, parcel),
    "island.png": (400, 220, island),
    "moon.png": (200, 200, moon),
    "cloud.png": (270, 110, cloud),
    "hills.png": (960, 220, hills),
    "hook.png": (80, 64, hook),
    "heart.png": (52, 48, heart),
}


def main() -> None:
    for name, (width, height, draw) in PICTURES.items():
        sheet = Sheet(width, height)
        draw(sheet)
        sheet.save(name)
        print(f"{name}: {(FOLDER / name).stat().st_size / 1000:.1f} kB")


if __name__ == "__main__":
    main()
