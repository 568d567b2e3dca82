"""The pictures in tests/golden, and how what is drawn now is held against them."""

from __future__ import annotations

import tempfile
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
    if different.any():
        shown = side_by_side(name, found, expected, different)
        first = np.argwhere(different)[0]
        raise AssertionError(f"{different.sum()} pixels differ, first at {first}; found, expected, where: {shown}")


def side_by_side(name: str, found: Any, expected: Any, different: Any) -> Path:
    """A file with what is, what should be, and white where they differ, for people to look at."""
    where = np.zeros_like(expected)
    where[..., 3] = 255
    where[different] = 255
    gap = np.full((found.shape[0], 4, 4), 128)
    folder = Path(tempfile.gettempdir()) / "evilengine-golden"
    folder.mkdir(exist_ok=True)
    row = np.concatenate([found, gap, expected, gap, where], axis=1).astype(np.uint8)
    PIL.Image.fromarray(row, "RGBA").save(folder / f"{name}.png")
    return folder / f"{name}.png"
