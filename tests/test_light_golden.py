"""A picture of light and shadow, compared to the bit.

`python tests/test_light_golden.py` writes it anew; look at it before you commit it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from lighting import lamps_and_shadows

GOLDEN = Path(__file__).parent / "golden"


@pytest.mark.parametrize("quality", ["low", "medium", "high"])
def test_the_golden_picture_of_light_comes_out_to_the_bit(quality: str) -> None:
    import PIL.Image

    game = lamps_and_shadows()
    game.lights.quality = quality
    with PIL.Image.open(GOLDEN / f"light_{quality}.png") as file:
        expected = np.asarray(file.convert("RGBA"))
    different = (np.array(game.capture().pixels) != expected).any(axis=2)
    assert not different.any(), f"{different.sum()} pixels differ, first at {np.argwhere(different)[0]}"


if __name__ == "__main__":
    for each in ("low", "medium", "high"):
        scene = lamps_and_shadows()
        scene.lights.quality = each
        scene.capture().save(GOLDEN / f"light_{each}.png")
        print(GOLDEN / f"light_{each}.png", file=sys.stderr)
