"""What games look like, compared to the bit with `soft`, and within three levels of 255 with `gl`.

`python tests/test_looks_golden.py` writes the pictures anew; look at them before you commit them.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest
from drawing import Pixels
from golden_looks import LOOKS, played
from golden_pictures import GOLDEN, assert_golden


def drawn(name: str, renderer: str, folder: Path) -> Pixels:
    return np.array(played(name, renderer, folder).capture().pixels)


@pytest.mark.parametrize("name", LOOKS)
@pytest.mark.parametrize(("renderer", "apart"), [("soft", 0), ("gl", 3)])
def test_games_look_as_they_did(name: str, renderer: str, apart: int, tmp_path: Path) -> None:
    assert_golden(name, drawn(name, renderer, tmp_path), apart)


if __name__ == "__main__":
    for each in LOOKS:
        with tempfile.TemporaryDirectory() as pictures:
            played(each, "soft", Path(pictures)).capture().save(GOLDEN / f"{each}.png")
            print(GOLDEN / f"{each}.png", file=sys.stderr)
