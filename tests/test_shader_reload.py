"""Shaders are files: what changes in them is seen while the game plays, and what is wrong in them is told."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from drawing import BLACK, place
from drawing_gl import any_driver, picture, unit_square

from evilengine import _core
from evilengine.renderer.gl import GlRenderer, shaders
from evilengine.renderer.gl.moderngl_device import ModernGlDevice
from evilengine.renderer.gl.pipeline import COVERS, MIXES
from evilengine.renderer.soft import SoftRenderer
from evilengine.renderer.steady import SteadyRenderer
from evilengine.values.drawlist import DrawList


@pytest.fixture
def device() -> ModernGlDevice:
    return any_driver()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: Any) -> Path:
    """A copy of the shaders, which the engine takes for its own."""
    for file in shaders.FOLDER.iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    monkeypatch.setattr(shaders, "FOLDER", tmp_path)
    return tmp_path


ticks = 0


def change(file: Path, old: str, new: str) -> None:
    """Also for file systems whose clocks are coarse."""
    global ticks
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")
    ticks += 1
    os.utime(file, ns=(10**18 + ticks * 10**9,) * 2)


def red_and_green(renderer: GlRenderer | SteadyRenderer) -> tuple[int, int]:
    """Of a white box that the sprite shader draws."""
    content = _core.DrawList()
    square = unit_square(content)
    for _ in range(20):
        content.instance(square, place(0, 0, 16))
    red, green, *_ = picture(renderer, DrawList((16, 16), BLACK, content))[8, 8].tolist()
    return red, green


SPRITE = "result = colour * texture(page, spot.zw);"


def test_a_changed_shader_is_drawn_with_and_an_unchanged_one_is_left_alone(
    device: ModernGlDevice, folder: Path
) -> None:
    gl = GlRenderer(device)
    assert red_and_green(gl) == (255, 255)
    assert gl.reload_shaders() == []
    change(folder / "sprite.frag", SPRITE, f"{SPRITE} result.r = 0.0;")
    assert red_and_green(gl) == (255, 255), "nobody asked yet"
    made = len(device._programs)
    assert gl.reload_shaders() == []
    assert red_and_green(gl) == (0, 255)
    assert len(device._programs) == made + len(COVERS), "the sprites' programs alone were made anew"
    assert gl.reload_shaders() == []
    assert len(device._programs) == made + len(COVERS)


def test_a_broken_shader_is_told_once_and_the_last_good_one_stays_in_use(device: ModernGlDevice, folder: Path) -> None:
    gl = GlRenderer(device)
    change(folder / "sprite.frag", SPRITE, f"{SPRITE}\n    result.r = nowhere;")
    line = (folder / "sprite.frag").read_text(encoding="utf-8")[: -len("x")].split("nowhere")[0].count("\n") + 1
    told = gl.reload_shaders()
    assert told
    for each in told:
        assert each.startswith(f"{folder / 'sprite.frag'}:{line}: ")
        assert "nowhere" in each
        assert each.endswith("it is drawn as before")
    assert red_and_green(gl) == (255, 255)
    assert gl.reload_shaders() == [], "said already"
    change(folder / "sprite.frag", "result.r = nowhere;", "result.g = 0.0;")
    assert gl.reload_shaders() == []
    assert red_and_green(gl) == (255, 0)


def test_what_is_wrong_in_an_included_file_is_told_with_its_name_and_line(device: ModernGlDevice, folder: Path) -> None:
    gl = GlRenderer(device)
    change(folder / "area.glsl", "float run = x1 - x0;", "float run = x1 - x2;")
    line = (folder / "area.glsl").read_text(encoding="utf-8").split("x1 - x2")[0].count("\n") + 1
    told = gl.reload_shaders()
    assert told
    assert all(each.startswith(f"{folder / 'area.glsl'}:{line}: ") for each in told)
    change(folder / "area.glsl", "float run = x1 - x2;", "float run = x1 - x0;")
    assert gl.reload_shaders() == []


def test_a_file_that_is_gone_for_a_moment_is_told_and_found_again(device: ModernGlDevice, folder: Path) -> None:
    gl = GlRenderer(device)
    text = (folder / "sprite.vert").read_bytes()
    (folder / "sprite.vert").unlink()
    (told,) = gl.reload_shaders()
    assert "sprite.vert" in told
    assert red_and_green(gl) == (255, 255)
    assert gl.reload_shaders() == []
    (folder / "sprite.vert").write_bytes(text)
    assert gl.reload_shaders() == []


def test_every_renderer_can_be_asked(device: ModernGlDevice, folder: Path) -> None:
    assert SoftRenderer().reload_shaders() == []
    steady = SteadyRenderer()
    red_and_green(steady)
    change(folder / "sprite.frag", SPRITE, f"{SPRITE} result.r = 0.0;")
    assert steady.reload_shaders() == []
    assert red_and_green(steady) == ((0, 255) if steady.name == "gl" else (255, 255))


def test_all_shaders_compile_as_browsers_and_phones_would_have_them(device: ModernGlDevice) -> None:
    """GLSL ES 3.00 to the letter, which desktop drivers can be asked for, and without any extension."""
    device.es = True
    with device:
        if "GL_ARB_ES3_compatibility" not in device.context.extensions:
            pytest.skip("the driver knows no GLSL ES")
        pairs = [("screen.vert", "screen.frag", {}), ("screen.vert", "place.frag", {})]
        pairs += [("screen.vert", "halve.frag", {"FIRST": a, "BRIGHT": b}) for a in (0, 1) for b in (0, 1)]
        pairs += [("screen.vert", "double.frag", {"HOW": how}) for how in range(4)]
        pairs += [("screen.vert", "shaft.frag", {"STAGE": stage, "TAPS": 5}) for stage in (0, 1, 2)]
        pairs += [("screen.vert", "liquid.frag", {"LIGHT": on}) for on in (0, 1)]
        pairs += [("screen.vert", "post.frag", {"BLOOM": a, "GRAIN": b}) for a in (0, 1) for b in (0, 1)]
        pairs += [("speck.vert", "speck.frag", {"DISC": a, "ADDS": b}) for a in (0, 1) for b in (0, 1)]
        pairs += [("sprite.vert", "sprite.frag", {"COVER": a, "LIGHT": b}) for a in COVERS for b in (0, 1)]
        pairs += [
            ("shape.vert", "shape.frag", {"PICTURES": mix, "FACETS": facets, "SURFACES": surfaces, "LIGHT": light})
            for mix in MIXES
            for facets in (0, 1)
            for surfaces, light in ((0, 0), (1, 1), (1, 3))
        ]
        for vertex, fragment, defines in pairs:
            sources = shaders.load(vertex), shaders.load(fragment)
            assert all("#extension" not in source.text for source in sources)
            device.program(*sources, defines)
    shown = {name for pair in pairs for name in pair[:2]}
    assert shown == {file.name for file in shaders.FOLDER.iterdir() if file.suffix != ".glsl"}, "all of them"
