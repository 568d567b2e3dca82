#!/usr/bin/env python3
"""Try the engine that is installed, as someone who just installed it: no screen, no compiler, nothing but the wheel.

Wheels are tested with it where they are built (cibuildwheel), and `tools/dev.py release` runs it. It needs no tree.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import evilengine as evil

PACKAGE = Path(evil.__file__).parent
COMMAND = shutil.which("evil", path=str(Path(sys.executable).parent)) or "evil"


def falls() -> None:
    world = evil.World()
    world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    crate = world.add(evil.Rectangle(1, 1), at=(0, 3))
    for _ in range(180):
        world.step()
    assert abs(crate.position.y - 0.5) < 0.02, crate.position


def shows() -> None:
    game = evil.Game("Try", size=(320, 180), headless=True)
    game.add_background("black")
    game.add(evil.Circle(1), colour="white")
    image = game.capture()
    middle = (image.height // 2 * image.width + image.width // 2) * 4
    assert image.tobytes()[middle : middle + 3] == b"\xff\xff\xff"
    assert image.tobytes()[:3] == b"\0\0\0"


def plays(folder: Path) -> None:
    """`evil play`, once a level and once a game, and what it leaves behind without a screen."""
    for name in ("prototype1", "bodies"):
        film = folder / f"{name}.webp"
        command = [COMMAND, "play", name, "--headless", "--seconds", "1", "--size", "320x180", "--film", str(film)]
        subprocess.run(command, check=True, cwd=folder, timeout=120)
        assert film.read_bytes()[8:12] == b"WEBP", film


def main() -> None:
    assert (PACKAGE / "py.typed").exists(), "the wheel lacks py.typed: type checkers would not see the types"
    assert (PACKAGE / "_core.pyi").exists(), "the wheel lacks the core's stubs"
    falls()
    shows()
    with tempfile.TemporaryDirectory() as folder:
        plays(Path(folder))
    print(f"EvilEngine {evil.__version__} at {PACKAGE} plays, with Python {sys.version.split()[0]} on {sys.platform}")


if __name__ == "__main__":
    main()
