"""Renderers: one protocol, with a backend in each folder beside it."""

from __future__ import annotations

import os
from typing import Protocol

from evilengine.values.checks import one_of, parts
from evilengine.values.drawlist import DrawList
from evilengine.values.image import Image
from evilengine.values.surface import Shows, Surface

RENDERERS = ("auto", "gl", "soft")

MOST_THREADS = 4
"""How many threads a picture takes by itself: more are kept for what else the machine does."""


class Renderer(Protocol):
    """Turns draw lists into pictures. Textures are known by whole numbers, so that the core can name them."""

    @property
    def name(self) -> str:
        """Who draws: "gl" or "soft"."""

    @property
    def draw_calls(self) -> int:
        """How many the last frame took; 0 in software."""

    def attach(self, surface: Surface | None) -> None:
        """Draw to a window's GL context from now on, or with None no longer: the window closes."""

    def upload(self, image: Image) -> int:
        """Keep `image` for drawing and return its id, a number above 0 that is never given out again."""

    def update(self, texture: int, image: Image) -> None:
        """Show another image, of any size, wherever `texture` is drawn. Raises ArgumentError for an unknown id."""

    def release(self, texture: int) -> None:
        """Forget a texture; what still names it is drawn without one. Raises ArgumentError for an unknown id."""

    def reload_shaders(self) -> list[str]:
        """Draw with the shaders as their files are now. One that cannot be used stays as it was; the lines say why."""

    def draw(self, frame: DrawList) -> None:
        """Draw a whole frame; the target takes the frame's size."""

    def show(self, device: Shows) -> None:
        """Put the last frame on the screen: straight from the graphics card where it can, else as a picture."""

    @property
    def pixels(self) -> memoryview:
        """The last frame as (height, width, 4) bytes r, g, b, a, colours multiplied with alpha; good until the next."""

    def capture(self) -> Image:
        """A copy of the last frame, with straight alpha."""

    def close(self) -> None:
        """Let go of textures and target. Nothing may be drawn after."""


def threads_for_pictures(threads: int | None, owner: str) -> int:
    """How many threads share in what is seen: `threads`, or where that is None what the machine has, four at most."""
    if threads is not None:
        return parts(threads, owner, "threads")
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(cores, MOST_THREADS)


def open_renderer(name: str = "auto", *, threads: int | None = None) -> Renderer:
    """The renderer called `name`. Raises ArgumentError for an unknown name.

    "auto" draws on the graphics card where there is one, and in software where there is none or only a driver that
    plays one on the processor. "gl" takes any driver. Where it can have none, or loses it, a game goes on in software,
    with a line on the terminal that says so. "soft" gives the same bits on every machine and with any number of
    `threads`, 1 to 256; None stands for as many as the machine has, four at most.

    >>> open_renderer("soft").name
    'soft'
    """
    if one_of(name, "open_renderer", "name", RENDERERS) == "soft":
        from evilengine.renderer.soft import SoftRenderer

        return SoftRenderer(threads_for_pictures(threads, "open_renderer"))
    from evilengine.renderer.steady import SteadyRenderer

    return SteadyRenderer(software=name == "gl", threads=threads_for_pictures(threads, "open_renderer"))
