"""Drawing with any renderer, for the tests of the one on the graphics card."""

from __future__ import annotations

import random

import numpy as np
import pytest
from drawing import Pixels, Points, place

from evilengine import _core
from evilengine.renderer import Renderer
from evilengine.renderer.gl.moderngl_device import ModernGlDevice, make_headless
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import DeviceError


def any_driver() -> ModernGlDevice:
    """A device of the test's own, on whatever driver there is; one that is a program on the processor will do."""
    try:
        return make_headless()
    except DeviceError as error:
        pytest.skip(f"no driver draws without a window: {error}")


def picture(renderer: Renderer, frame: DrawList) -> Pixels:
    renderer.draw(frame)
    return np.array(renderer.pixels)


def difference(a: Pixels, b: Pixels) -> int:
    """The largest, of 255."""
    return int(np.abs(a.astype(int) - b.astype(int)).max())


def unit_square(content: _core.DrawList) -> int:
    unit: Points = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return content.polygon(unit, uvs=unit)


def sprites(textures: list[int], count: int) -> _core.DrawList:
    """Small squares all over a picture of 64 x 48, their textures in turn."""
    rnd, content = random.Random(3), _core.DrawList()
    square = unit_square(content)
    for number in range(count):
        at = rnd.uniform(0, 64), rnd.uniform(0, 48)
        content.instance(square, place(*at, 4.0, rnd.uniform(0, 6)), texture=textures[number % len(textures)])
    return content
