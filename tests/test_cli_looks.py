"""How `evil render` and its kin are told to look at a game."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image, ImageChops

from evilengine.cli import main

LEVEL = """
view 16 9;
ambient 0.2;
draw rectangle 16 9 at 0 0 colour "#998877" lit layer -1;
new rectangle 2 1 at 0 0;
new light at 1 2 softness 0.5;
"""


def picture(folder: Path, name: str, *words: str) -> Image.Image:
    (folder / "lamp.evil").write_text(LEVEL)
    target = folder / f"{name}.png"
    arguments = ["render", str(folder / "lamp.evil"), "-o", str(target), "--at", "0", "--size", "320x180", *words]
    assert main(arguments) == 0
    with Image.open(target) as image:
        return image.convert("RGB")


def differ(one: Image.Image, other: Image.Image) -> bool:
    return ImageChops.difference(one, other).getbbox() is not None


def test_the_quality_of_light_can_be_chosen(tmp_path: Path) -> None:
    pictures = {q: picture(tmp_path, q, "--quality", q) for q in ("auto", "low", "medium", "high")}
    assert not differ(pictures["auto"], pictures["medium"]), "what nobody watches is always drawn the same"
    assert differ(pictures["low"], pictures["medium"])
    assert differ(pictures["high"], pictures["medium"])


def test_parts_of_the_debug_view_can_be_chosen(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plain, all_of_it = picture(tmp_path, "plain"), picture(tmp_path, "all", "--debug-view")
    some = picture(tmp_path, "some", "--debug-parts", "shapes,lights")
    assert differ(plain, some)
    assert differ(all_of_it, some)
    arguments = ["render", str(tmp_path / "lamp.evil"), "-o", str(tmp_path / "x.png"), "--debug-parts", "shape"]
    assert main(arguments) == 2
    assert "'shape' is no part of the debug view; did you mean 'shapes'?" in capsys.readouterr().err
