"""The pictures in tests/golden, and how what is drawn now is held against them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import PIL.Image

GOLDEN = Path(__file__).parent / "golden"


def assert_golden(name: str, pixels: Any, apart: int = 0) -> None:
    """`pixels` (height, width, RGBA) are the picture of that name, each level at most `apart` from it."""
    with PIL.Image.open(GOLDEN / f"{name}.png") as file:
        expected: npt.NDArray[np.int64] = np.asarray(file.convert("RGBA")).astype(np.int64)
    found = np.asarray(pixels).astype(np.int64)
    assert found.shape == expected.shape
    different = np.abs(found - expected).max(axis=2) > apart
    assert not different.any(), f"{different.sum()} pixels differ, first at {np.argwhere(different)[0]}"
