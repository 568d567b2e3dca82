"""`evil play` as a person runs it: a process of its own, a real window on a screen in memory."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from test_window import MemoryScreen, wait_for


def colours(screen: MemoryScreen) -> int:
    """How many colours the screen shows, looked at in every eighth place."""
    red, green, blue = np.moveaxis(screen.pixels()[::8, ::8].astype(int), 2, 0)
    return len(np.unique(red << 16 | green << 8 | blue))


def test_evil_play_shows_a_level_that_moves_and_ends(tmp_path: Path) -> None:
    if shutil.which("Xvfb") is None:
        pytest.skip("the window is tested on an X server in memory: apt-get install xvfb")
    screen = MemoryScreen(tmp_path)
    environment = {name: value for name, value in os.environ.items() if name not in ("SDL_VIDEODRIVER", "LD_PRELOAD")}
    command = [sys.executable, "-m", "evilengine", "play", "prototype1", "--seconds", "3"]
    play = subprocess.Popen(
        command, cwd=tmp_path, env=environment | {"DISPLAY": screen.display}, stderr=subprocess.PIPE, text=True
    )
    try:
        assert wait_for(lambda: colours(screen) > 10), "nothing was drawn"
        before = screen.pixels().copy()
        assert wait_for(lambda: bool((screen.pixels() != before).mean() > 0.005)), "nothing moved"
        assert play.wait(30) == 0
        assert play.stderr is not None
        assert play.stderr.read() == ""
    finally:
        play.kill()
        play.wait()
        assert play.stderr is not None
        play.stderr.close()
        screen.close()
    assert not list(tmp_path.glob("*.webp")), "a window was there; nobody asked for a film"
