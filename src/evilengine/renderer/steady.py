"""SteadyRenderer: draws on the graphics card while that works, and in software from the moment it does not."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from evilengine.renderer.gl.device import ContextLost
from evilengine.renderer.soft import SoftRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import DeviceError, ShaderError
from evilengine.values.image import Image
from evilengine.values.surface import Shows, Surface

if TYPE_CHECKING:
    from evilengine.renderer import Renderer
    from evilengine.renderer.gl import GlRenderer

T = TypeVar("T")

_NOTHING = Image.of(1, 1, bytes(4))  # takes the place of a texture that was released, so that the others keep their ids


class SteadyRenderer:
    """Behaves as `Renderer` says. Nothing is opened before something is drawn or kept for drawing.

    With `software=False` a driver that is itself a program on the processor counts as none: `soft` is faster. That
    draws on `threads`.
    """

    def __init__(self, *, software: bool = True, threads: int = 1, notice: Callable[[str], None] | None = None) -> None:
        self._software = software
        self._threads = threads
        self._notice = notice or _print
        self._surface: Surface | None = None
        self._backend: Renderer | None = None
        self._failed = False  # once is enough: no second context is tried
        self._images: list[Image] = []  # by id, from 1 on
        self._released: set[int] = set()
        self._frame: DrawList | None = None

    @property
    def name(self) -> str:
        """Who draws: "gl" or "soft"."""
        return self._opened().name

    @property
    def draw_calls(self) -> int:
        """How many the last frame took; 0 in software."""
        return self._opened().draw_calls

    def attach(self, surface: Surface | None) -> None:
        """Draw to a window's GL context, or with None no longer."""
        if surface is not self._surface:
            self._surface = surface
            self._leave()

    def upload(self, image: Image) -> int:
        """Keep `image` for drawing and return its id, above 0."""
        texture = self._try(lambda backend: backend.upload(image))
        self._images.append(image)
        return texture

    def update(self, texture: int, image: Image) -> None:
        """Show another image wherever `texture` is drawn."""
        self._try(lambda backend: backend.update(texture, image))
        self._images[texture - 1] = image

    def release(self, texture: int) -> None:
        """Forget a texture."""
        self._try(lambda backend: backend.release(texture))
        self._images[texture - 1] = _NOTHING
        self._released.add(texture)

    def reload_shaders(self) -> list[str]:
        """Draw with the shaders as their files are now."""
        return self._try(lambda backend: backend.reload_shaders())

    def draw(self, frame: DrawList) -> None:
        """Draw a whole frame."""
        self._frame = None
        self._try(lambda backend: backend.draw(frame))
        self._frame = frame

    @property
    def pixels(self) -> memoryview:
        """The last frame as (height, width, 4) bytes, colours multiplied with alpha."""
        return self._try(lambda backend: backend.pixels)

    def capture(self) -> Image:
        """A copy of the last frame, with straight alpha."""
        return self._try(lambda backend: backend.capture())

    def show(self, device: Shows) -> None:
        """Put the last frame on the screen."""
        self._try(lambda backend: backend.show(device))

    def close(self) -> None:
        """Let go of textures and target."""
        self._frame = None
        self._leave()

    # ---- who draws ------------------------------------------------------------------------------------------------

    def _try(self, work: Callable[[Renderer], T]) -> T:
        try:
            return work(self._opened())
        except ContextLost as error:
            self._notice(f"the graphics driver gave up ({error}); it goes on in software")
            self._failed = True
            self._leave()
            return work(self._opened())

    def _opened(self) -> Renderer:
        if self._backend is None:
            backend: Renderer | None = None
            try:
                backend = self._open_gl()
                if backend is not None:
                    self._hand_over(backend)
            except ContextLost as error:
                self._notice(f"the graphics driver gave up ({error}); it goes on in software")
                self._failed, backend = True, None
            if backend is None:
                backend = SoftRenderer(self._threads)
                self._hand_over(backend)
            self._backend = backend
        return self._backend

    def _open_gl(self) -> GlRenderer | None:
        """The graphics card's renderer, or None where there is no card, or none that works."""
        if self._failed:
            return None
        try:
            from evilengine.renderer.gl import open_gl

            return open_gl(self._surface, software=self._software)
        except ShaderError as error:
            if self._software:
                raise
            self._notice(f"{error}; it is drawn in software")
        except DeviceError as error:
            if self._software:  # somebody asked for it by name
                self._notice(f"{error}; it is drawn in software")
        self._failed = True
        return None

    def _hand_over(self, backend: Renderer) -> None:
        """Everything that was kept for drawing, under the ids that it has, and the last frame."""
        for texture, image in enumerate(self._images, 1):
            backend.upload(image)
            if texture in self._released:
                backend.release(texture)
        if self._frame is not None:
            backend.draw(self._frame)

    def _leave(self) -> None:
        backend, self._backend = self._backend, None
        if backend is not None:
            with contextlib.suppress(ContextLost):  # then there is nothing to give back
                backend.close()


def _print(line: str) -> None:
    print(line, file=sys.stderr)
