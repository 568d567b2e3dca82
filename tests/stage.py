"""A small stage for tests of what is drawn: a world, a scene that shows it on black, and pictures of it."""

from __future__ import annotations

import evilengine as evil
from evilengine.renderer.soft import SoftRenderer
from evilengine.scene import Camera, DrawnBody, Scene
from evilengine.values.font import Font, Glyph
from evilengine.values.image import Image

SIZE = (200, 100)  # 4 x 2 metres
RED, GREEN, BLUE, BLACK = (255, 0, 0), (0, 255, 0), (0, 0, 255), (0, 0, 0)
SQUARE = evil.Rectangle(1, 1)


class Stage:
    """A world, a scene that shows it on black, and pictures of it."""

    def __init__(self) -> None:
        self.renderer = SoftRenderer()
        self.world = evil.World(gravity=(0, 0))
        self.world._body_type = DrawnBody
        self.scene = Scene(self.world, background="black", textures=self.texture, fonts=self.font)
        self.camera = Camera(SIZE)
        self.images = {
            "halves.png": Image.of(2, 1, bytes((255, 0, 0, 255, 0, 0, 255, 255))),
            "rows.png": Image.of(1, 2, bytes((255, 0, 0, 255, 0, 0, 255, 255))),
        }
        self.ids: dict[str, int] = {}

    def texture(self, name: str) -> int:
        if name not in self.images:
            raise evil.AssetError(f"no image {name!r}")
        return self.ids.setdefault(name, self.renderer.upload(self.images[name]))

    def font(self, size: int) -> tuple[int, Font]:
        """Every letter but the space a full square, half as wide as the font is high."""
        white = Image.of(1, 1, b"\xff" * 4)
        box = Glyph(size / 2, (0, -size + 2, size / 2, 2), (0, 0, 1, 1))
        glyphs = dict.fromkeys("abc?", box) | {" ": Glyph(size / 2, (0, 0, 0, 0), (0, 0, 0, 0))}
        font = Font(size, size - 2, size, white, glyphs)
        if "font" not in self.ids:
            self.ids["font"] = self.renderer.upload(white)
        return self.ids["font"], font

    def add(self, shape: object = SQUARE, **options: object) -> DrawnBody:
        body = self.world.add(shape, **options)  # type: ignore[arg-type]
        assert isinstance(body, DrawnBody)
        return body

    def show(self, alpha: float = 1.0, size: tuple[int, int] | None = None) -> memoryview:
        self.renderer.draw(self.scene.collect(self.camera, alpha, size))
        return self.renderer.pixels

    def at(self, x: float, y: float, alpha: float = 1.0) -> tuple[int, ...]:
        """The colour that is seen at a point of the world."""
        column, row = self.camera.to_pixel((x, y))
        return tuple(self.show(alpha)[int(row), int(column), part] for part in range(3))
