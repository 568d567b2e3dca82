"""What games look like, compared to the bit with `soft`, and within three levels of 255 with `gl`.

`python tests/test_looks_golden.py` writes the pictures anew; look at them before you commit them.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import PIL.Image
import pytest
from drawing import Pixels
from golden_looks import LOOKS, played

GOLDEN = Path(__file__).parent / "golden"


def drawn(name: str, renderer: str, folder: Path) -> Pixels:
    return np.array(played(name, renderer, folder).capture().pixels)


@pytest.mark.parametrize("name", LOOKS)
@pytest.mark.parametrize(("renderer", "apart"), [("soft", 0), ("gl", 3)])
def test_games_look_as_they_did(name: str, renderer: str, apart: int, tmp_path: Path) -> None:
    with PIL.Image.open(GOLDEN / f"{name}.png") as file:
        expected = np.asarray(file.convert("RGBA")).astype(int)
    found = drawn(name, renderer, tmp_path).astype(int)
    assert found.shape == expected.shape
    worst = np.abs(found - expected).max(axis=2)
    assert worst.max() <= apart, f"{(worst > apart).sum()} pixels differ, first at {np.argwhere(worst > apart)[0]}"


if __name__ == "__main__":
    for each in LOOKS:
        with tempfile.TemporaryDirectory() as pictures:
            played(each, "soft", Path(pictures)).capture().save(GOLDEN / f"{each}.png")
            print(GOLDEN / f"{each}.png", file=sys.stderr)
