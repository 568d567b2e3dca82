"""The scenes of the golden pictures: what every renderer draws, and what it should look like."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from drawing import BLUE, GREEN, RED, WHITE, place, star

from evilengine import _core
from evilengine.values.drawlist import DrawList
from evilengine.values.image import Image

Upload = Callable[[Image], int]


def shapes(upload: Upload) -> DrawList:
    content = _core.DrawList()
    concave = content.polygon([(0, 0), (30, 0), (30, 30), (15, 9), (0, 30)])
    square = content.polygon([(-12, -12), (12, -12), (12, 12), (-12, 12)], colours=[RED, GREEN, BLUE, WHITE])
    content.instance(concave, place(6, 8, angle=0.1), tint=0xFF4488FF)
    content.instance(content.circle(15.0), place(60.5, 22), tint=0xFFCC8844)
    content.instance(content.circle(1.0), (18, 6, -3, 8, 98, 24), tint=0xA000FF00)
    content.instance(square, place(24, 64, angle=0.35))
    content.instance(concave, place(48, 48, 1.0, 0.2), tint=0x80FFFFFF)
    for i in range(12):
        content.instance(0 if i % 4 == 0 else 2, place(90 + 6 * (i % 6), 52 + 12 * (i // 6), 0.02 + 0.015 * i))
    return DrawList((128, 88), 0xFF302018, content)


def strokes(upload: Upload) -> DrawList:
    content = _core.DrawList()
    sharp = content.polygon(star(5, 18, 7))
    needle = content.polygon([(0, 0), (40, 3), (40, 6)], colours=[RED, GREEN, BLUE])
    content.instance(sharp, place(24, 24, angle=0.2), outline=4.0)
    content.instance(sharp, place(64, 24, angle=0.2), outline=1.0, tint=0xFF66CCFF)
    content.instance(needle, place(84, 14), outline=5.0)
    content.instance(content.circle(14.0), place(24, 64), outline=2.0)
    content.instance(content.circle(1.0), (20, 8, -4, 9, 66, 64), outline=3.0, tint=0x90FFFFFF)
    content.instance(content.circle(2.5), place(98, 56), outline=1.0)
    content.instance(content.circle(5.0), place(112, 68), outline=12.0, tint=0xFF8844FF)
    return DrawList((128, 88), 0xFF203020, content)


def textures(upload: Upload) -> DrawList:
    content = _core.DrawList()
    y, x = np.indices((16, 16))
    on = (x // 4 + y // 4) % 2 * 255
    tiles = np.dstack([on, 80 + 0 * on, 255 - on, 255 - 12 * x]).astype(np.uint8)
    texture = upload(Image.of(16, 16, tiles.tobytes()))
    unit = [(0, 0), (1, 0), (1, 1), (0, 1)]
    square = content.polygon(unit, uvs=unit)
    ramp = content.polygon(unit, uvs=unit, colours=[RED, GREEN, BLUE, WHITE])
    content.instance(square, (30, 8, -8, 30, 12, 4), texture=texture)
    content.instance(square, (16, 0, 0, 16, 50, 6), texture=texture)
    content.instance(square, (5, 0, 0, 5, 70.3, 6.6), texture=texture)
    content.instance(square, (40, 0, 0, 34, 84, 4), texture=texture, to_texture=(3, 1, -1, 3, 0, 0))
    content.instance(content.circle(1.0), (18, 0, 0, -18, 24, 64), texture=texture, tint=0xFF80C0FF)
    content.instance(ramp, (30, 4, 6, 34, 50, 44), texture=texture)
    content.instance(square, (30, 0, 0, 34, 94, 46), texture=texture, outline=5.0)
    return DrawList((128, 88), 0xFF283038, content)


SCENES = {"raster_shapes": shapes, "raster_strokes": strokes, "raster_textures": textures}
