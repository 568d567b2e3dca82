"""Small pictures, compared to the bit.

`python tests/test_raster_golden.py` writes them anew; look at them before you commit them.
"""

from __future__ import annotations

import sys

import numpy as np
import pytest
from drawing import Pixels
from golden_pictures import GOLDEN, assert_golden
from golden_scenes import SCENES

from evilengine.renderer.soft import SoftRenderer
from evilengine.values.image import Image


def drawn(name: str) -> Pixels:
    renderer = SoftRenderer()
    renderer.draw(SCENES[name](renderer.upload))
    return np.array(renderer.pixels)


@pytest.mark.parametrize("name", SCENES)
def test_golden_pictures_come_out_to_the_bit(name: str) -> None:
    assert_golden(name, drawn(name))


if __name__ == "__main__":
    for name in SCENES:
        pixels = drawn(name)
        Image.of(pixels.shape[1], pixels.shape[0], pixels.tobytes()).save(GOLDEN / f"{name}.png")
        print(GOLDEN / f"{name}.png", file=sys.stderr)
