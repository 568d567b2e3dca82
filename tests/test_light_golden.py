"""A picture of light and shadow, compared to the bit.

`python tests/test_light_golden.py` writes it anew; look at it before you commit it.
"""

from __future__ import annotations

import sys

import pytest
from golden_pictures import GOLDEN, assert_golden
from lighting import lamps_and_shadows


@pytest.mark.parametrize("quality", ["low", "medium", "high"])
def test_the_golden_picture_of_light_comes_out_to_the_bit(quality: str) -> None:
    game = lamps_and_shadows()
    game.lights.quality = quality
    assert_golden(f"light_{quality}", game.capture().pixels)


if __name__ == "__main__":
    for each in ("low", "medium", "high"):
        scene = lamps_and_shadows()
        scene.lights.quality = each
        scene.capture().save(GOLDEN / f"light_{each}.png")
        print(GOLDEN / f"light_{each}.png", file=sys.stderr)
