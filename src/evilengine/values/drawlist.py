"""DrawList: one frame ready to draw, what the scene hands to a renderer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from evilengine import _core


@dataclass(frozen=True, slots=True)
class DrawList:
    """One frame, ready to draw: instances sorted back to front, in target pixels."""

    size: tuple[int, int]
    """Width and height of the target in real pixels."""
    background: int
    """Colour that the frame starts from, as 0xAABBGGRR."""
    content: _core.DrawList
    """Meshes and instances; see core/draw/draw_list.hpp."""
    insets: tuple[Inset, ...] = ()
    """Frames that each fill a part of this one, in their order, before the content goes over all of them."""


@dataclass(frozen=True, slots=True)
class Inset:
    """A frame that fills a part of another one, such as what one of several cameras sees. It has no insets itself."""

    left: int
    top: int
    """Where its top left corner is, in pixels of the whole; all of it must lie within that."""
    frame: DrawList
