"""TouchList: the touches of a step, for contacts and for what sensors see."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeVar, overload

from evilengine import _core

if TYPE_CHECKING:
    from evilengine.world.world import World

T = TypeVar("T")


class TouchList(Sequence[T]):
    """Pairs of shapes that touch, one by one or as columns: read-only buffers with a row for each."""

    __slots__ = ("_rows", "_world")

    def __init__(self, world: World, rows: _core.Touches) -> None:
        self._world = world
        self._rows = rows

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[T, ...]: ...
    def __getitem__(self, index: int | slice) -> T | tuple[T, ...]:
        numbers = range(len(self._rows))[index]
        if isinstance(numbers, range):
            return tuple(self._made(number) for number in numbers)
        return self._made(numbers)

    @abstractmethod
    def _made(self, number: int) -> T:
        """The touch of that row."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (type(self), tuple, list)) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment]

    @property
    def bodies(self) -> memoryview:
        """(n, 2) uint32: slots of a and b, as rows of the arrays in `world.bodies`."""
        return self._rows.bodies

    @property
    def shapes(self) -> memoryview:
        """(n, 2) uint32: slots of their shapes."""
        return self._rows.shapes

    def __repr__(self) -> str:
        return f"<{type(self).__name__}, {len(self)}>"
