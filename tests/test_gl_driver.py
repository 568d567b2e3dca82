"""Who draws: on which driver, and what happens when it is refused, lost, or given a shader that it does not take."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing import RED, sprite
from drawing_gl import any_driver, picture, sprites

from evilengine import _core
from evilengine.renderer import open_renderer
from evilengine.renderer.gl import GlRenderer, moderngl_device, shaders
from evilengine.renderer.gl.device import ContextLost, Source
from evilengine.renderer.gl.moderngl_device import ModernGlDevice, is_software
from evilengine.renderer.report import graphics
from evilengine.renderer.soft import SoftRenderer
from evilengine.renderer.steady import SteadyRenderer
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import DeviceError, ShaderError
from evilengine.values.image import Image


@pytest.fixture(scope="module")
def device() -> ModernGlDevice:
    return any_driver()


# ---- who draws, and what happens when he cannot any more ----


@pytest.mark.parametrize(("renderer", "software"), [
    ("llvmpipe (LLVM 15.0.6, 256 bits)", True),
    ("softpipe", True),
    ("Software Rasterizer", True),
    ("Google SwiftShader", True),
    ("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)", True),
    ("Mesa DRI Intel(R) HD Graphics 620 (KBL GT2)", False),
    ("NVIDIA GeForce RTX 4070/PCIe/SSE2", False),
    ("AMD Radeon RX 6600 (radeonsi, navi23, LLVM 15.0.7)", False),
    ("Apple M2", False),
])  # fmt: skip
def test_auto_draws_on_a_real_card_and_gl_on_anything(
    device: ModernGlDevice, monkeypatch: Any, capsys: Any, renderer: str, software: bool
) -> None:
    assert is_software(renderer) == software
    monkeypatch.setattr(device, "renderer", renderer)
    monkeypatch.setattr(moderngl_device, "open_headless", lambda: device)
    assert [open_renderer(name).name for name in ("auto", "gl", "soft")] == ["soft" if software else "gl", "gl", "soft"]
    assert capsys.readouterr().err == "", "that is nothing to worry about"


class Window:
    """A window's GL context that is not there."""

    pixel_size = (64, 48)
    closed = False

    def make_current(self) -> None:
        raise DeviceError("the window's GL context cannot be used: lost by the driver")

    def address(self, name: str) -> int:
        return 0

    def swap(self) -> None: ...

    def close(self) -> None:
        self.closed = True


def test_a_window_is_shown_pictures_where_its_gl_is_a_program_on_the_processor(
    device: ModernGlDevice, monkeypatch: Any
) -> None:
    window, renderer = Window(), open_renderer("auto")
    monkeypatch.setattr(moderngl_device, "open_on", lambda surface: device)
    monkeypatch.setattr(device, "renderer", "llvmpipe")
    renderer.attach(window)
    assert renderer.name == "soft"
    assert window.closed


@pytest.mark.parametrize(("name", "lines"), [("auto", 0), ("gl", 1)])
def test_a_refused_context_is_replaced_by_software_with_a_line_if_it_was_asked_for(
    monkeypatch: Any, capsys: Any, name: str, lines: int
) -> None:
    def refuse() -> ModernGlDevice:
        raise DeviceError("OpenGL without a window: no driver")

    monkeypatch.setattr(moderngl_device, "open_headless", refuse)
    renderer = open_renderer(name)
    assert renderer.name == "soft"
    assert picture(renderer, DrawList((4, 4), RED, _core.DrawList()))[0, 0, 0] == 255
    told = capsys.readouterr().err.splitlines()
    assert len(told) == lines
    assert all("no driver; it is drawn in software" in line for line in told)


def test_a_machine_without_moderngl_draws_in_software_and_says_what_to_install(monkeypatch: Any, capsys: Any) -> None:
    monkeypatch.delattr("evilengine.renderer.gl.moderngl_device")
    monkeypatch.setitem(sys.modules, "evilengine.renderer.gl.moderngl_device", None)
    assert open_renderer("gl").name == "soft"
    assert "pip install moderngl; it is drawn in software" in capsys.readouterr().err
    assert open_renderer("auto").name == "soft"
    assert capsys.readouterr().err == ""
    assert "pip install moderngl" in graphics().problem


def test_a_window_whose_context_is_gone_before_the_first_frame_is_drawn_in_software(capsys: Any) -> None:
    renderer = open_renderer("gl")
    renderer.attach(Window())
    assert renderer.name == "soft"
    (line,) = capsys.readouterr().err.splitlines()
    assert "lost by the driver" in line


@pytest.fixture
def losing(device: ModernGlDevice, monkeypatch: Any) -> tuple[SteadyRenderer, list[str], Any]:
    """A renderer, what it says, and a function that loses its context."""
    said: list[str] = []
    monkeypatch.setattr(moderngl_device, "open_headless", lambda: device)
    monkeypatch.setattr(device, "lost", False)
    renderer = SteadyRenderer(notice=said.append)

    def lose() -> None:
        def gone(self: ModernGlDevice) -> None:
            raise ContextLost("GL_CONTEXT_LOST")

        monkeypatch.setattr(ModernGlDevice, "check", gone)

    return renderer, said, lose


class Eye:
    """A device that remembers what it was shown."""

    seen: bytes = b""

    def show(self, pixels: object, size: tuple[int, int]) -> None:
        self.seen = bytes(pixels)  # type: ignore[call-overload]


@pytest.mark.parametrize("when", ["upload", "draw", "pixels", "capture", "show"])
def test_a_lost_context_goes_on_in_software_with_everything_it_had(losing: Any, when: str) -> None:
    renderer, said, lose = losing
    images = [Image.of(7, 5, sprite(number, 7, 5).tobytes()) for number in range(4)]
    kept = [renderer.upload(image) for image in images[:3]]
    renderer.release(kept[1])
    renderer.update(kept[2], images[3])
    frame = DrawList((64, 48), 0xFF203040, sprites(kept, 60))
    renderer.draw(frame)
    assert (renderer.name, said) == ("gl", [])

    lose()
    if when == "upload":
        assert renderer.upload(images[1]) == kept[-1] + 1
    elif when == "draw":
        renderer.draw(frame)
    eye = Eye()
    if when == "show":
        renderer.show(eye)
    elif when == "capture":
        renderer.capture()
    found = np.array(renderer.pixels)

    soft = SoftRenderer()
    for image in (images[0], images[1], images[3]):
        soft.upload(image)
    soft.release(kept[1])
    expected = picture(soft, frame)
    assert renderer.name == "soft"
    assert (found == expected).all()
    assert not eye.seen or eye.seen == expected.tobytes()
    assert len(said) == 1, "one line, once"
    assert "GL_CONTEXT_LOST" in said[0]
    assert "software" in said[0]


def test_a_context_lost_while_the_next_renderer_is_opened_is_no_crash_either(losing: Any) -> None:
    renderer, said, lose = losing
    lose()
    assert picture(renderer, DrawList((4, 4), RED, _core.DrawList()))[0, 0, 0] == 255
    assert (renderer.name, len(said)) == ("soft", 1)


# ---- shaders ----


def broken(tmp_path: Path, monkeypatch: Any, name: str, old: str, new: str) -> None:
    """Shaders of which one has a mistake."""
    for file in shaders.FOLDER.iterdir():
        text = file.read_text(encoding="utf-8")
        if file.name == name:
            assert old in text
            text = text.replace(old, new)
        (tmp_path / file.name).write_text(text, encoding="utf-8")
    monkeypatch.setattr(shaders, "FOLDER", tmp_path)


@pytest.mark.parametrize(("name", "old", "new"), [
    ("shape.frag", "float area = 0.0;", "float area = vec3(0.0);"),
    ("shape.vert", "places = offsets;", "places = offsetz;"),
    ("sprite.frag", "float area = 0.0;", "float area = vec3(0.0);"),  # below what is included
    ("area.glsl", "float run = x1 - x0;", "float run = x1 - x2;"),  # included
])  # fmt: skip
def test_a_shader_that_does_not_compile_says_where_and_why(
    device: ModernGlDevice, tmp_path: Path, monkeypatch: Any, name: str, old: str, new: str
) -> None:
    text = (shaders.FOLDER / name).read_text(encoding="utf-8")
    line = text[: text.index(old)].count("\n") + 1
    broken(tmp_path, monkeypatch, name, old, new)
    with pytest.raises(ShaderError) as caught:
        GlRenderer(device)
    assert (caught.value.file, caught.value.line) == (str(tmp_path / name), line)
    assert str(caught.value).startswith(f"{tmp_path / name}:{line}: ")
    assert len(str(caught.value)) > len(f"{tmp_path / name}:{line}: ") + 10, "the driver's words"


def test_shaders_that_do_not_fit_together_are_both_named(
    device: ModernGlDevice, tmp_path: Path, monkeypatch: Any
) -> None:
    broken(tmp_path, monkeypatch, "shape.frag", "in vec2 at;", "in vec3 at;\n#define at at.xy")
    with pytest.raises(ShaderError, match=r"shape\.vert and .*shape\.frag do not fit together: .+"):
        GlRenderer(device)


def test_a_broken_shader_is_an_error_for_who_asked_for_gl_and_a_line_for_who_did_not(
    device: ModernGlDevice, tmp_path: Path, monkeypatch: Any
) -> None:
    said: list[str] = []
    broken(tmp_path, monkeypatch, "shape.frag", "float area = 0.0;", "float area = vec3(0.0);")
    monkeypatch.setattr(moderngl_device, "open_headless", lambda: device)
    monkeypatch.setattr(device, "renderer", "A real card")
    with pytest.raises(ShaderError):
        _ = SteadyRenderer(software=True).name
    assert SteadyRenderer(software=False, notice=said.append).name == "soft"
    assert len(said) == 1
    assert "shape.frag" in said[0]


@pytest.mark.parametrize(("words", "line", "told"), [
    ("fragment_shader\n====\n0:3(2): error: value of type vec3\n", 3, "value of type vec3"),
    ('fragment_shader\n0(17) : error C1008: undefined variable "x"\n', 17, "C1008"),
    ("fragment_shader\nERROR: 0:29: 'x' : undeclared identifier\n", 29, "undeclared"),
    ("fragment_shader\n0:100007(2): error: no such word\n", 7, "no such word"),
    ("Program\n=======\nerror: something does not fit\n", 0, "something does not fit"),
    ("", 0, "no reason"),
])  # fmt: skip
def test_the_words_of_every_driver_are_understood(words: str, line: int, told: str) -> None:
    fragment = Source("b.frag", "", ("c.glsl",))
    error = shaders.complaint(f"GLSL Compiler failed\n\n{words}", Source("a.vert", ""), fragment)
    assert (error.file, error.line) == ("c.glsl" if "100007" in words else "b.frag", line)
    assert told in str(error)


def test_a_shader_keeps_its_line_numbers_and_gets_the_header_that_a_driver_wants() -> None:
    source = Source("x.frag", "#version 300 es\nprecision highp float;\n")
    assert (
        shaders.prepare(source, {"A": 2}, es=True) == "#version 300 es\n#define A 2\n#line 2\nprecision highp float;\n"
    )
    assert shaders.prepare(source, {}, es=False).startswith("#version 330\n#line 2\nprecision")
    with pytest.raises(ShaderError, match=r"x\.frag:1: a shader begins with '#version 300 es'"):
        shaders.prepare(Source("x.frag", "void main() {}"), {}, es=False)


def test_every_shader_that_ships_is_of_the_version_that_browsers_have_too() -> None:
    files = sorted(shaders.FOLDER.iterdir())
    assert {file.suffix for file in files} == {".vert", ".frag", ".glsl"}
    for file in files:
        if file.suffix == ".glsl":  # a part of others
            assert file.read_text(encoding="utf-8").startswith("// "), "what it is for"
            continue
        assert shaders.load(file.name).text.startswith(f"{shaders.ES_HEADER}\n//"), "the version, then what it is for"
