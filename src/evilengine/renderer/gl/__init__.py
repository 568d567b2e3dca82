"""The renderer on a graphics card: the same pictures as `soft`, by OpenGL 3.3 or OpenGL ES 3.0."""

from __future__ import annotations

import weakref

from evilengine import _core
from evilengine.renderer.gl.device import GraphicsDevice
from evilengine.renderer.gl.pipeline import Pipeline
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentError, DeviceError
from evilengine.values.image import Image
from evilengine.values.surface import Shows, Surface


def open_gl(surface: Surface | None = None, *, software: bool = True) -> GlRenderer | None:
    """The renderer for a window, or without one for pictures alone. Raises DeviceError where no driver can be had.

    With `software=False` a driver that plays a graphics card on the processor gives None, and a window's GL is closed.
    """
    try:
        from evilengine.renderer.gl import moderngl_device
    except ImportError as error:
        raise DeviceError(f"OpenGL: {error}; try pip install moderngl") from None
    device = moderngl_device.open_on(surface) if surface is not None else moderngl_device.open_headless()
    if not software and moderngl_device.is_software(device.renderer):
        if surface is not None:
            surface.close()
        return None
    return GlRenderer(device, surface)


class GlRenderer:
    """Draws by a `GraphicsDevice`, to a window's surface or only to be read. Behaves as `Renderer` says.

    Any method may raise ContextLost, after which nothing here works; `evilengine.renderer.steady` takes care of that.
    Devices are shared: whoever opens a second renderer for the same window, or a second one without a window, gets the
    same device, and what a forgotten renderer held there is given back.
    """

    name = "gl"

    def __init__(self, device: GraphicsDevice, surface: Surface | None = None) -> None:
        self.device = device
        self._surface = surface
        self._size = (1, 1)
        self._pixels: bytearray | None = bytearray(4)  # None: not read back yet
        self._held: set[int] = set()
        with device:
            self._pipeline = Pipeline(device)
            device.check()
        self._finalizer = weakref.finalize(self, device.later, self._pipeline.release)

    def attach(self, surface: Surface | None) -> None:
        """What is drawn is shown in another window, of the same GL; None: only read."""
        self._surface = surface

    @property
    def draw_calls(self) -> int:
        """How many the last frame took."""
        return self._pipeline.draw_calls

    def upload(self, image: Image) -> int:
        """Keep `image` for drawing and return its id, above 0."""
        with self.device:
            texture = self._pipeline.upload(image)
        self._held.add(texture)
        return texture

    def update(self, texture: int, image: Image) -> None:
        """Show another image wherever `texture` is drawn."""
        self._require(texture, "Renderer.update")
        with self.device:
            self._pipeline.update(texture, image)

    def release(self, texture: int) -> None:
        """Forget a texture."""
        self._require(texture, "Renderer.release")
        self._held.discard(texture)
        with self.device:
            self._pipeline.drop(texture)

    def _require(self, texture: int, owner: str) -> None:
        if texture not in self._held:
            raise ArgumentError(f"{owner}: texture={texture} is not one that upload() gave and that is still held")

    def reload_shaders(self) -> list[str]:
        """Draw with the shaders as their files are now; lines say which could not be used, where and why."""
        with self.device:
            return self._pipeline.programs.reload()

    def draw(self, frame: DrawList) -> None:
        """Draw a whole frame. Views of an earlier one keep their picture."""
        width, height = frame.size
        most = self.device.most_pixels
        if not (1 <= width <= most and 1 <= height <= most):
            raise ArgumentError(f"DrawList.size={(width, height)!r}: each side must be 1 to {most} pixels")
        with self.device:
            self._pipeline.draw(frame)
        self._size, self._pixels = frame.size, None

    @property
    def pixels(self) -> memoryview:
        """The last frame as (height, width, 4) bytes, colours multiplied with alpha; read back when first asked for."""
        width, height = self._size
        if self._pixels is None:
            pixels = bytearray(width * height * 4)
            with self.device:
                assert self._pipeline.target is not None
                self._pipeline.target.read(pixels)
                self.device.check()
            self._pixels = pixels
        return memoryview(self._pixels).toreadonly().cast("B", (height, width, 4))

    def capture(self) -> Image:
        """A copy of the last frame, with straight alpha."""
        pixels = bytearray(self.pixels)
        _core.unpremultiply(pixels)
        return Image.of(*self._size, pixels)

    def show(self, device: Shows) -> None:
        """Put the last frame on the screen: straight to the window, or as a picture where there is none."""
        if self._surface is None:
            device.show(self.pixels, self._size)
            return
        with self.device:
            self._pipeline.show(self._surface.pixel_size)
        self._surface.swap()

    def close(self) -> None:
        """Let go of everything on the card."""
        self._finalizer.detach()
        with self.device:
            self._pipeline.release()
