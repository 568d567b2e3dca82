"""What a frame may cost beside its pixels: no Python object for a thing drawn, no format that a card may lack."""

from __future__ import annotations

import gc
import tracemalloc
from pathlib import Path
from typing import Any

import moderngl
import pytest
from drawing_gl import any_driver
from golden_looks import paint_pictures

import evilengine as evil
from evilengine.renderer.gl import moderngl_device

FEW, MANY = 40, 2000


def crowd(renderer: str, count: int, folder: Path) -> evil.Game:
    game = evil.Game(headless=True, renderer=renderer, size=(160, 120), gravity=(0, 0), folder=folder)
    for number in range(count):
        body = game.world.add(evil.Circle(0.05), at=(0.003 * number - 3, 0), kind="kinematic", angular_velocity=1.0)
        body.draw(evil.Rectangle(0.2, 0.2), texture="coin.png", lit=number % 2 == 0)
    game.step(2)
    return game


def most_allocated(game: evil.Game) -> int:
    """Bytes of Python's that are held at once, at the most, while a frame is collected and drawn."""
    game.renderer.draw(game._collect())
    gc.collect()
    gc.disable()
    tracemalloc.start()
    try:
        game.renderer.draw(game._collect())
        start = tracemalloc.get_traced_memory()[0]
        tracemalloc.reset_peak()
        game.renderer.draw(game._collect())
        return tracemalloc.get_traced_memory()[1] - start
    finally:
        tracemalloc.stop()
        gc.enable()


@pytest.mark.parametrize("renderer", ["soft", "gl"])
def test_a_frame_allocates_no_python_object_for_each_thing_drawn(renderer: str, tmp_path: Path) -> None:
    paint_pictures(tmp_path)
    name = sorted(tmp_path.glob("*.png"))[0].name
    (tmp_path / "coin.png").write_bytes((tmp_path / name).read_bytes())
    few, many = (most_allocated(crowd(renderer, count, tmp_path)) for count in (FEW, MANY))
    assert many - few < (MANY - FEW), f"{many} bytes against {few}: an object has 16 at the least"


EVERYWHERE = {"f1", "u2"}
"""Targets that OpenGL ES 3.0 and WebGL2 draw on without an extension: 8 bits, and whole numbers of 16 (its table of
sized internal formats has RGBA8 and RGBA16UI among those that can be rendered to)."""


def test_a_frame_with_everything_draws_on_targets_that_every_device_has(monkeypatch: Any) -> None:
    """Nothing asks for EXT_color_buffer_float, so nothing is missing where that is."""
    device = any_driver()
    made: list[str] = []
    real = type(device.context).framebuffer

    def framebuffer(self: Any, attachments: Any, *rest: Any) -> moderngl.Framebuffer:
        made.extend(one.dtype for one in attachments)
        if any(one.dtype not in EVERYWHERE for one in attachments):
            raise moderngl.Error("the framebuffer is not complete")
        return real(self, attachments, *rest)

    monkeypatch.setattr(type(device.context), "framebuffer", framebuffer)
    monkeypatch.setattr(moderngl_device, "open_headless", lambda: device)
    game = evil.Game(headless=True, renderer="gl", size=(160, 90))
    game.add_light(at=(0, 1), radius=5)
    game.ambient = 0.2
    game.world.add(evil.Circle(0.4), at=(0, 0))
    game.post.bloom = 0.6
    game.post.grain = 0.1
    game.layers[0].blur = 3
    game.layers[1].shafts.at = (0, 1)
    game.step()
    assert game.capture().pixels[45, 80, 3] == 255
    assert game.renderer.name == "gl"
    assert set(made) == EVERYWHERE
    assert len(made) > 4, "the blur's and the bloom's smaller pictures too"
