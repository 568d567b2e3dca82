"""The graphics device on a desktop: OpenGL 3.3 or OpenGL ES 3.0, by moderngl."""

from __future__ import annotations

import contextlib
import sys
import threading
import weakref
from collections import Counter, deque
from collections.abc import Callable, Mapping, Sequence
from types import TracebackType
from typing import Any, cast

import moderngl

from evilengine.renderer.gl.device import (
    Blend,
    Buffer,
    ContextLost,
    Layout,
    Program,
    Source,
    Target,
    TargetKind,
    Texture,
    TextureKind,
)
from evilengine.renderer.gl.shaders import complaint, prepare
from evilengine.values.errors import DeviceError
from evilengine.values.surface import Surface

OLDEST = 330
SOFTWARE = ("llvmpipe", "softpipe", "swrast", "swiftshader", "software", "basic render")
"""Words in a driver's renderer string that mean: no graphics card, the processor plays one."""

MOST_DEVICES = 4
"""Graphics cards that are tried for one that draws without a window."""

LOST = (moderngl.Error, MemoryError)
"""What moderngl raises when the driver refuses what it is bound to give."""


def is_software(renderer: str) -> bool:
    """Whether a renderer string is that of a program on the processor.

    >>> is_software("llvmpipe (LLVM 15.0.6, 256 bits)"), is_software("NVIDIA H100 PCIe/PCIe/SSE2")
    (True, False)
    """
    return any(word in renderer.lower() for word in SOFTWARE)


def open_headless() -> ModernGlDevice:
    """The thread's device without a window, on a graphics card if there is one. Raises DeviceError without a driver."""
    device: ModernGlDevice | None = getattr(_of_thread, "headless", None)
    if device is None or device.lost:
        device = _of_thread.headless = make_headless()
    return device


def open_on(surface: Surface) -> ModernGlDevice:
    """The device that draws to a window. Raises DeviceError if the window's GL is too old or broken."""
    device = _of_surface.get(surface)
    if device is None or device.lost:
        surface.make_current()
        try:
            loader: Any = _Loader(surface)
            context = moderngl.create_context(require=OLDEST, context=loader)
            device = _of_surface[surface] = ModernGlDevice(context, owned=False)
        except Exception as error:
            raise DeviceError(f"OpenGL in a window: {_one_line(error)}") from None
    return device


def make_headless() -> ModernGlDevice:
    """A device without a window, shared with nobody."""
    software: ModernGlDevice | None = None
    reason = "no driver"
    for index in range(MOST_DEVICES if sys.platform.startswith("linux") else 1):
        try:
            device = ModernGlDevice(_standalone(index), owned=True)
        except Exception as error:  # the driver's own, of any kind
            reason = _one_line(error) or reason
            break
        if not is_software(device.renderer):
            return device
        software = software or device
    if software is not None:
        return software
    fix = "; on Debian and Ubuntu: apt install libegl1 libgl1 libgl1-mesa-dri" if sys.platform == "linux" else ""
    raise DeviceError(f"OpenGL without a window: {reason}{fix}")


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__


def _standalone(index: int) -> moderngl.Context:
    settings: Any = {}  # moderngl's stubs take each of them for a dict
    if sys.platform.startswith("linux"):
        settings = {"backend": "egl", "device_index": index, "libgl": "libGL.so.1", "libegl": "libEGL.so.1"}
    return moderngl.create_context(standalone=True, require=OLDEST, **settings)


class _Loader:
    """What moderngl asks of a context that it did not make."""

    def __init__(self, surface: Surface) -> None:
        self._surface = weakref.ref(surface)  # a device must not keep the window that it draws on

    def load_opengl_function(self, name: str) -> int:
        surface = self._surface()
        return surface.address(name) if surface is not None else 0

    def __enter__(self) -> None:
        surface = self._surface()
        if surface is None:
            raise DeviceError("the window was closed")
        surface.make_current()

    def __exit__(self, *args: object) -> None: ...

    def release(self) -> None: ...


class _Buffer:
    def __init__(self, device: ModernGlDevice) -> None:
        self._device = device
        self.native: moderngl.Buffer | None = None

    def write(self, data: object, size: int) -> None:
        if self.native is None or self.native.size < size:
            self.release()
            self.native = self._device.made("buffers", self._device.context.buffer(reserve=max(4096, 2 * size)))
        else:
            self.native.orphan()
        self.native.write(cast(bytes, data))

    def release(self) -> None:
        if self.native is not None:
            self._device.gave_back("buffers", self.native)
        self.native = None


class _Texture:
    def __init__(self, device: ModernGlDevice, native: moderngl.Texture) -> None:
        self._device = device
        self.native: moderngl.Texture | None = device.made("textures", native)

    @property
    def size(self) -> tuple[int, int]:
        return cast(tuple[int, int], self.native.size if self.native is not None else (0, 0))

    def write(self, data: object, part: tuple[int, int, int, int], *, level: int = 0) -> None:
        if self.native is not None:
            self.native.write(cast(bytes, data), viewport=part, level=level)

    def release(self) -> None:
        if self.native is not None:
            self._device.gave_back("textures", self.native)
        self.native = None


class _Program:
    def __init__(self, context: moderngl.Context, native: moderngl.Program) -> None:
        self.native = native
        self.vertices = context.vertex_array(native, [])
        self._set: dict[str, Any] = {}

    def set(self, name: str, value: Any) -> None:
        if self._set.get(name) != value:
            member = self.native.get(name, None)  # a driver leaves out what the shader does not use
            if isinstance(member, moderngl.Uniform):
                member.value = value[0] if isinstance(value, tuple) and len(value) == 1 else value
            self._set[name] = value

    def use(self, textures: Sequence[tuple[str, Texture]], uniforms: Mapping[str, tuple[float, ...]]) -> None:
        for unit, (name, texture) in enumerate(textures):
            native = cast(_Texture, texture).native
            if native is not None:
                native.use(unit)
            self.set(name, unit)
        for name, value in uniforms.items():
            self.set(name, value)


class _Target:
    def __init__(self, device: ModernGlDevice, size: tuple[int, int], kind: TargetKind) -> None:
        self._device = device
        native = device.context.texture(size, 4, dtype="u2" if kind == "deep" else "f1")
        nearest = moderngl.NEAREST, moderngl.NEAREST  # whole numbers have nothing between them
        native.filter = nearest if kind == "deep" else (moderngl.LINEAR, moderngl.LINEAR)
        self.texture = _Texture(device, native)
        self.native = device.made("targets", device.context.framebuffer([native]))
        self.size = size

    def clear(self, colour: tuple[float, float, float, float]) -> None:
        self.native.clear(*colour)

    def read(self, into: bytearray) -> None:
        self.native.read_into(into, components=4, alignment=1)

    def release(self) -> None:
        self._device.rest.use()
        self._device.gave_back("targets", self.native)
        self.texture.release()


class ModernGlDevice:
    """Draws by a moderngl context. Behaves as `GraphicsDevice` says."""

    def __init__(self, context: moderngl.Context, *, owned: bool) -> None:
        self.context = cast(Any, context)  # its stubs leave some of it without types
        self.lost = False
        self._later: deque[Callable[[], None]] = deque()
        self._counts: Counter[str] = Counter()
        self._programs: dict[tuple[str, str], _Program] = {}
        info = context.info
        self.renderer = str(info["GL_RENDERER"])
        self.driver = f"{info['GL_VENDOR']}, {info['GL_VERSION']}"
        self.es = str(info["GL_VERSION"]).startswith("OpenGL ES")
        self.most_pixels = int(info["GL_MAX_TEXTURE_SIZE"])
        self.rest = context.simple_framebuffer((1, 1))  # moderngl goes back to what was in use, so that must exist
        self.rest.use()
        context.enable_only(moderngl.BLEND)
        context.blend_func = _BLENDS["over"]
        self._blend: Blend = "over"
        if owned:  # a window's context goes with the window, this one with its device
            self.context.__exit__(None, None, None)
            weakref.finalize(self, self.context.release).atexit = False

    def __enter__(self) -> None:
        try:
            self.context.__enter__()
            while self._later:
                self._later.popleft()()
        except Exception as error:  # the driver's own, of any kind
            self.lost = True
            raise ContextLost(_one_line(error)) from error

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with contextlib.suppress(Exception):  # what was in use before may be gone
            self.context.__exit__(None, None, None)
        if isinstance(error, ContextLost):
            self.lost = True
        elif isinstance(error, LOST):
            self.lost = True
            raise ContextLost(_one_line(error)) from error

    def later(self, work: Callable[[], None]) -> None:
        self._later.append(work)

    def check(self) -> None:
        said = self.context.error
        if said != "GL_NO_ERROR":
            raise ContextLost(said)

    # ---- what is kept on the card ---------------------------------------------------------------------------------

    def made(self, kind: str, thing: Any) -> Any:
        self._counts[kind] += 1
        return thing

    def gave_back(self, kind: str, thing: Any) -> None:
        self._counts[kind] -= 1
        thing.release()

    def counts(self) -> dict[str, int]:
        return {kind: count for kind, count in sorted(self._counts.items()) if count}

    def buffer(self) -> Buffer:
        return _Buffer(self)

    def texture(self, kind: TextureKind, size: tuple[int, int], *, levels: int = 1) -> Texture:
        native = self.context.texture(size, 4, dtype=_NUMBERS[kind])
        if levels > 1:
            native.build_mipmaps(max_level=levels - 1)  # makes room for the copies, which are then written
        if kind == "data":
            native.filter = moderngl.NEAREST, moderngl.NEAREST
        else:
            native.filter = moderngl.LINEAR_MIPMAP_NEAREST if levels > 1 else moderngl.LINEAR, moderngl.LINEAR
        return _Texture(self, native)

    def program(self, vertex: Source, fragment: Source, defines: Mapping[str, int]) -> Program:
        texts = prepare(vertex, defines, es=self.es), prepare(fragment, defines, es=self.es)
        if texts not in self._programs:
            try:
                native = self.context.program(vertex_shader=texts[0], fragment_shader=texts[1])
            except moderngl.Error as error:
                raise complaint(str(error), vertex, fragment) from None
            self._programs[texts] = _Program(self.context, native)
        return self._programs[texts]

    def target(self, size: tuple[int, int], kind: TargetKind = "picture") -> Target:
        return _Target(self, size, kind)

    # ---- drawing --------------------------------------------------------------------------------------------------

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
        assert isinstance(target, _Target)
        assert isinstance(program, _Program)
        buffer, layout, first, count = instances
        native = cast(_Buffer, buffer).native
        assert native is not None, "a buffer is written before it is drawn from"
        target.native.use()
        program.use(textures, uniforms)
        bind, stride = program.vertices.bind, layout.stride
        for location, attribute in enumerate(layout.attributes):
            kind, form = _FORMATS[attribute.kind]
            bind(location, kind, native, f"{attribute.count}{form}", first * stride + attribute.offset, stride, 1)
        if blend != self._blend:
            self.context.blend_func = _BLENDS[blend]
            self._blend = blend
        program.vertices.render(moderngl.TRIANGLES, 6, 0, count)

    def fill(
        self,
        target: Target,
        program: Program,
        *,
        textures: Sequence[tuple[str, Texture]],
        uniforms: Mapping[str, tuple[float, ...]],
        part: tuple[int, int, int, int] | None = None,
    ) -> None:
        assert isinstance(target, _Target)
        assert isinstance(program, _Program)
        target.native.viewport = part or (0, 0, *target.size)
        target.native.use()
        program.use(textures, uniforms)
        self.context.disable(moderngl.BLEND)
        program.vertices.render(moderngl.TRIANGLES, 3)
        self.context.enable(moderngl.BLEND)
        if part is not None:
            target.native.viewport = (0, 0, *target.size)

    def show(self, program: Program, textures: Sequence[tuple[str, Texture]], size: tuple[int, int]) -> None:
        assert isinstance(program, _Program)
        screen = self.context.screen
        screen.viewport = (0, 0, *size)
        screen.use()
        program.use(textures, {})
        self.context.disable(moderngl.BLEND)
        program.vertices.render(moderngl.TRIANGLES, 3)
        self.context.enable(moderngl.BLEND)


_NUMBERS: dict[TextureKind, str] = {"picture": "f1", "data": "f4", "light": "f2"}
_FORMATS: dict[str, tuple[str, str]] = {"float": ("f", "f"), "uint": ("i", "u")}
_BLENDS: dict[Blend, tuple[int, int]] = {
    "over": (moderngl.ONE, moderngl.ONE_MINUS_SRC_ALPHA),
    "multiply": (moderngl.DST_COLOR, moderngl.ONE_MINUS_SRC_ALPHA),
    "screen": (moderngl.ONE, moderngl.ONE_MINUS_SRC_COLOR),
}
_of_thread = threading.local()
_of_surface: weakref.WeakKeyDictionary[Surface, ModernGlDevice] = weakref.WeakKeyDictionary()
