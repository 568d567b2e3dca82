"""What the pipeline asks of a graphics driver: buffers, textures, programs, targets, draws. One class a driver."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Literal, Protocol

Data = bytes | bytearray | memoryview
"""What is uploaded; any object that shows contiguous memory will do."""

TextureKind = Literal["picture", "data", "light"]
TargetKind = Literal["picture", "deep"]
"""A picture: four bytes a texel, repeated and filtered, with smaller copies. Data: four floats, fetched one by one.
Light: four floats of 16 bits, filtered."""

Blend = Literal["over", "multiply", "screen"]
"""How colours s, multiplied with alpha, meet d behind them: s + d (1 - alpha), s d + d (1 - alpha), s + d (1 - s)."""


class ContextLost(Exception):  # noqa: N818  (what WebGL calls it)
    """The driver has lost everything, or cannot go on. The pipeline's owner draws by other means from here on."""


@dataclass(frozen=True, slots=True)
class Attribute:
    """A field of an instance, at the location that is its place in the layout."""

    kind: Literal["float", "uint"]
    count: int
    offset: int
    """Bytes from the instance's start."""


@dataclass(frozen=True, slots=True)
class Layout:
    """How instances lie in a buffer."""

    stride: int
    attributes: tuple[Attribute, ...]


@dataclass(frozen=True, slots=True)
class Source:
    """A shader as its file has it, GLSL ES 3.00, with what it includes in its place."""

    file: str
    text: str
    included: tuple[str, ...] = ()
    """Files, in that order."""


class Buffer(Protocol):
    """Instances on the graphics card."""

    def write(self, data: object, size: int) -> None:
        """Hold `size` bytes of `data` in place of what was there; what is being drawn meanwhile stays as it was."""

    def release(self) -> None:
        """Give the memory back."""


class Texture(Protocol):
    """A picture or data."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in texels."""

    def write(self, data: object, part: tuple[int, int, int, int], *, level: int = 0) -> None:
        """Fill a part of the copy `level`: left, top, width, height in texels."""

    def release(self) -> None:
        """Give the memory back."""


class Program(Protocol):
    """A vertex and a fragment shader that work together."""


class Target(Protocol):
    """A picture that can be drawn on. Its first row is the top."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""

    @property
    def texture(self) -> Texture:
        """What was drawn, to draw with. Belongs to the target."""

    def clear(self, colour: tuple[float, float, float, float]) -> None:
        """One colour everywhere."""

    def read(self, into: bytearray) -> None:
        """The pixels, four bytes each; waits until all of them are drawn."""

    def release(self) -> None:
        """Give the memory back."""


class GraphicsDevice(Protocol):
    """A driver. Everything but the first three is used inside `with device:`, and may raise ContextLost there."""

    @property
    def renderer(self) -> str:
        """The graphics card or program that draws, as the driver calls it."""

    @property
    def driver(self) -> str:
        """The driver's name and version."""

    @property
    def most_pixels(self) -> int:
        """The longest side that a texture or target can have."""

    def __enter__(self) -> None:
        """Make this device the one that draws; others of the process may have drawn since."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Let the device go that was in use before. What the driver's own errors mean is that the context is lost."""

    def check(self) -> None:
        """Raise ContextLost if anything failed since the last call."""

    def buffer(self) -> Buffer:
        """An empty buffer."""

    def texture(self, kind: TextureKind, size: tuple[int, int], *, levels: int = 1) -> Texture:
        """A texture whose texels are not yet anything."""

    def program(self, vertex: Source, fragment: Source, defines: Mapping[str, int]) -> Program:
        """Compiled and linked, once: it belongs to the device. Raises ShaderError with place and the driver's words."""

    def target(self, size: tuple[int, int], kind: TargetKind = "picture") -> Target:
        """A target; a "deep" one has whole numbers of 16 bits, which every device draws, and is not read back."""

    def draw(
        self,
        target: Target,
        program: Program,
        *,
        instances: tuple[Buffer, Layout, int, int],
        textures: Sequence[tuple[str, Texture]],
        uniforms: Mapping[str, tuple[float, ...]],
        blend: Blend = "over",
    ) -> None:
        """Draw six corners for each instance: buffer, layout, the first one and how many. Colours are multiplied with
        alpha."""

    def fill(
        self,
        target: Target,
        program: Program,
        *,
        textures: Sequence[tuple[str, Texture]],
        uniforms: Mapping[str, tuple[float, ...]],
        part: tuple[int, int, int, int] | None = None,
    ) -> None:
        """Put something in the place of all that is on the target, or on a part of it (left, top, width, height)."""

    def show(self, program: Program, textures: Sequence[tuple[str, Texture]], size: tuple[int, int]) -> None:
        """Fill the window, `size` pixels, with one triangle over all of it."""

    def later(self, work: Callable[[], None]) -> None:
        """Do something when this device is used next; may be called by any thread."""

    def counts(self) -> dict[str, int]:
        """How many buffers, textures and targets are held."""
