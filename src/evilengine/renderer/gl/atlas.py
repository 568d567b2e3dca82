"""Small pictures side by side in few large textures, so that one draw call can show many of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from evilengine._core import Batcher
from evilengine.renderer.gl.device import GraphicsDevice, Texture

Copy = tuple[int, int, bytes, tuple[int, int, int, int, bool]]
"""Width, height, texels, the part that is not clear, and whether its corners are: what `_core.mipmaps` gives."""

LARGEST = 512
"""Texels: a picture with a longer side has a texture of its own and no place in an atlas."""

FIRST_SIDE, MOST_SIDE = 512, 4096
"""Texels of a page's sides: it doubles when it is full; after that, there is another page."""

GUTTER = 2
"""Texels round each copy, like its edge: a pixel that a box covers in part has its middle up to 0.71 pixels outside,
that is 1.1 texels at most, and half a texel more is mixed in."""

WHITE: Copy = (1, 1, b"\xff\xff\xff\xff", (0, 0, 1, 1, False))
"""What is drawn with by things without a picture."""


class Skyline:
    """Finds room for rectangles in a page that is as high as wide, from the bottom up.

    It knows how high each column is filled, as steps from left to right; a rectangle goes where its top is lowest, as
    far left as can be (Jylanki 2010, "A Thousand Ways to Pack the Bin", 2.4).

    >>> page = Skyline(8)
    >>> page.take(5, 4), page.take(3, 2), page.take(3, 2), page.take(8, 5)
    ((0, 0), (5, 0), (5, 2), None)
    """

    def __init__(self, side: int) -> None:
        self.side = side
        self._steps = [(0, 0)]  # where each begins, and how high it is

    def take(self, width: int, height: int) -> tuple[int, int] | None:
        """Left and bottom of a free place, which is now taken; None if there is none."""
        best: tuple[int, int, int] | None = None
        for index, (left, _) in enumerate(self._steps):
            if left + width > self.side:
                break
            low = max(step for at, step in self._steps[index:] if at < left + width)
            if low + height <= self.side and (best is None or low < best[0]):
                best = low, left, index
        if best is None:
            return None
        low, left, index = best
        right, after = left + width, self._steps[index][1]
        later = index
        while later < len(self._steps) and self._steps[later][0] < right:
            after = self._steps[later][1]
            later += 1
        rest = [(right, after)] if right < self.side and (self._steps[later:] or [(self.side, 0)])[0][0] > right else []
        self._steps[index:later] = [(left, low + height), *rest]
        return left, low

    def grow(self) -> None:
        """Twice the side, with what was taken in a corner."""
        self._steps.append((self.side, 0))
        self.side *= 2


@dataclass(slots=True)
class _Kept:
    """A picture with a place: its copies, and where they are."""

    page: int
    copies: Sequence[Copy]
    corners: list[tuple[int, int]]


class Atlas:
    """Keeps small pictures in pages, and tells the batcher where they are."""

    def __init__(self, device: GraphicsDevice, batcher: Batcher) -> None:
        self._device = device
        self._batcher = batcher
        self._pages: list[Texture] = []
        self._room: list[Skyline] = []
        self._kept: dict[int, _Kept] = {}
        self._lost = 0  # texels that nobody uses any more
        self._most = min(MOST_SIDE, device.most_pixels)
        self.put(0, [WHITE])

    def page(self, number: int) -> Texture:
        """The texture of a page."""
        return self._pages[number]

    def put(self, texture: int, copies: Sequence[Copy]) -> None:
        """Give a picture a place, or a new one; large ones have none."""
        kept = self._kept.get(texture)
        if kept is not None and [copy[:2] for copy in kept.copies] == [copy[:2] for copy in copies]:
            kept.copies = copies
            self._write(texture, kept)
            return
        self.drop(texture)
        if max(copies[0][:2]) > min(LARGEST, self._most - 2 * GUTTER):
            return
        if self._lost > self._most * self._most // 2:
            self._pack()
        self._place(texture, copies)

    def drop(self, texture: int) -> None:
        """A picture's place is nobody's."""
        kept = self._kept.pop(texture, None)
        if kept is not None:
            self._lost += sum(_area(copy) for copy in kept.copies)
            self._batcher.place(texture, 0, [])

    def release(self) -> None:
        """Give the memory back."""
        for page in self._pages:
            page.release()
        self._pages, self._room, self._kept, self._lost = [], [], {}, 0

    # ---- room -----------------------------------------------------------------------------------------------------

    def _place(self, texture: int, copies: Sequence[Copy]) -> None:
        for number in range(len(self._pages)):
            if (corners := self._corners(number, copies)) is not None:
                break
        else:
            number = len(self._pages)
            self._pages.append(self._device.texture("picture", (FIRST_SIDE, FIRST_SIDE)))
            self._room.append(Skyline(FIRST_SIDE))
            corners = self._corners(number, copies)
            assert corners is not None, "the largest picture fits an empty page"
        self._kept[texture] = _Kept(number, copies, corners)
        self._write(texture, self._kept[texture])

    def _corners(self, number: int, copies: Sequence[Copy]) -> list[tuple[int, int]] | None:
        """Places for all copies on one page, which grows for them; None if it cannot grow enough."""
        corners, room, side = [], self._room[number], self._room[number].side
        for width, height, _, _ in copies:
            while (
                corner := room.take(width + 2 * GUTTER, height + 2 * GUTTER)
            ) is None and 2 * room.side <= self._most:
                room.grow()
            if corner is None:
                break
            corners.append((corner[0] + GUTTER, corner[1] + GUTTER))
        if room.side > side:
            self._enlarge(number)
        return corners if len(corners) == len(copies) else None

    def _enlarge(self, number: int) -> None:
        side = self._room[number].side
        self._pages[number].release()
        self._pages[number] = self._device.texture("picture", (side, side))
        for texture, kept in self._kept.items():
            if kept.page == number:
                self._write(texture, kept)

    def _pack(self) -> None:
        """Put everything where it would be without what was dropped."""
        all_kept = sorted(self._kept.items(), key=lambda item: (-item[1].copies[0][1], item[0]))
        self.release()
        for texture, kept in all_kept:
            self._place(texture, kept.copies)

    def _write(self, texture: int, kept: _Kept) -> None:
        page, places = self._pages[kept.page], []
        for (left, top), (width, height, texels, seen) in zip(kept.corners, kept.copies, strict=True):
            part = left - GUTTER, top - GUTTER, width + 2 * GUTTER, height + 2 * GUTTER
            page.write(framed(texels, width, height, GUTTER), part)
            places.append((left, top, width, height, *seen))
        self._batcher.place(texture, kept.page, places)


def framed(texels: bytes, width: int, height: int, border: int) -> bytes:
    """A picture of four bytes a texel with its edge repeated so many times all round.

    >>> framed(b"aaaabbbb", 2, 1, 1) == 3 * b"aaaaaaaabbbbbbbb"
    True
    """
    stride = 4 * width
    rows = [texels[start : start + stride] for start in range(0, stride * height, stride)]
    wide = [border * row[:4] + row + border * row[-4:] for row in rows]
    return b"".join([*(border * wide[:1]), *wide, *(border * wide[-1:])])


def _area(copy: Copy) -> int:
    return (copy[0] + 2 * GUTTER) * (copy[1] + 2 * GUTTER)
