"""Pictures of the graphics card's renderer, held to those that it drew before: within one level on the software driver.

`python tests/test_gl_golden.py` writes the pictures anew; look at them before you commit them.
"""

from __future__ import annotations

import random
import sys
import tempfile
from pathlib import Path

import numpy as np
import PIL.Image
import pytest
from drawing import Pixels, place
from drawing_gl import any_driver, picture, unit_square
from golden_looks import LOOKS, played
from golden_pictures import GOLDEN, assert_golden, side_by_side
from golden_scenes import SCENES, Upload
from test_sprites_gl import disc

from evilengine import _core
from evilengine.renderer.gl import GlRenderer
from evilengine.renderer.gl.moderngl_device import is_software
from evilengine.values.drawlist import DrawList


def crowd(upload: Upload) -> DrawList:
    """Sprites of a picture with clear corners, and boxes of one colour, over each other."""
    content, dice = _core.DrawList(), random.Random(9)
    square, texture = unit_square(content), upload(disc(24, 1.0))
    for number in range(60):
        at = dice.uniform(-5, 150), dice.uniform(-5, 110)
        tint = dice.randrange(1 << 24) | (0xFF000000 if number % 3 else 0x90000000)
        kind = texture if number % 2 else 0
        content.instance(square, place(*at, dice.uniform(6, 40), dice.uniform(0, 6)), texture=kind, tint=tint)
    return DrawList((160, 120), 0xFF302018, content)


DRAWN = {**SCENES, "sprites": crowd}
NAMES = [*DRAWN, *LOOKS]


def drawn(name: str, folder: Path) -> Pixels:
    if name in LOOKS:
        return np.array(played(name, "gl", folder).capture().pixels)
    gl = GlRenderer(any_driver())
    return picture(gl, DRAWN[name](gl.upload))


@pytest.mark.parametrize("name", NAMES)
def test_the_card_draws_as_it_did(name: str, tmp_path: Path) -> None:
    assert_golden(f"gl_{name}", drawn(name, tmp_path), 1 if is_software(any_driver().renderer) else 3)


def test_a_picture_that_differs_is_shown_beside_what_it_should_be() -> None:
    with PIL.Image.open(GOLDEN / "gl_sprites.png") as file:
        pixels = np.array(file.convert("RGBA")).astype(int)
    other = pixels.copy()
    other[7, 9, 0] ^= 2
    with pytest.raises(AssertionError, match=r"1 pixels differ, first at \[7 9\].*evilengine-golden.*gl_sprites\.png"):
        assert_golden("gl_sprites", other, 1)
    shown = side_by_side("gl_sprites", other, pixels, np.abs(other - pixels).max(axis=2) > 0)
    with PIL.Image.open(shown) as file:
        beside = np.asarray(file)
    assert (beside[:, :160] == other).all()
    assert (beside[:, 164:324] == pixels).all()
    assert beside[:, 328:, 0].sum() == 255
    shown.unlink()


if __name__ == "__main__":
    for each in NAMES:
        with tempfile.TemporaryDirectory() as pictures:
            PIL.Image.fromarray(drawn(each, Path(pictures))).save(GOLDEN / f"gl_{each}.png")
            print(GOLDEN / f"gl_{each}.png", file=sys.stderr)
