"""`evil bench draw`: what a frame of moving sprites costs, here and in others, all headless and in one process."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, Protocol

from evilengine import _core
from evilengine.bench import lit
from evilengine.bench.crowd import METRE, SIDE, SIZE, Sprite, crowd, picture
from evilengine.bench.drawing_peers import PEERS
from evilengine.bench.lit import show
from evilengine.bench.timing import Times, take_turns
from evilengine.scene.drawn_body import DrawnBody
from evilengine.values.errors import DeviceError
from evilengine.values.tick import STEP
from evilengine.world.shapes import Particle, Rectangle

Tell = Callable[[str], None]
Numbers = dict[str, Any]

COUNTS = (5_000, 20_000)


FIRST_FRAME = """
import sys, time
from pathlib import Path
import evilengine, evilengine.examples
game = evilengine.Game(headless=True, renderer=sys.argv[1])
game.load(Path(evilengine.examples.__file__).parent / "prototype1.evil")
game.step()
game.capture()
print(time.time())
"""


class Painter(Protocol):
    """Who draws the crowd: `step` is a whole frame, with the sprites moved."""

    name: str

    def prepare(self) -> None: ...

    def step(self) -> None: ...


class Ours:
    """Bodies that the world moves, and drawings on them."""

    def __init__(self, renderer: str, sprites: Sequence[Sprite], file: Path, threads: int = 1) -> None:
        from evilengine.game import Game

        self.name = lit.name_of(renderer, threads)
        kept: dict[str, Any] = {"size": SIZE, "gravity": (0, 0), "folder": file.parent}
        self.game = Game(headless=True, renderer=renderer, threads=threads, **kept)
        square = Rectangle(SIDE / METRE, SIDE / METRE)
        for each in sprites:
            body = self.game.world.add(
                Particle(),
                kind="kinematic",
                at=((each.x - SIZE[0] / 2) / METRE, (each.y - SIZE[1] / 2) / METRE),
                velocity=(each.vx / METRE, each.vy / METRE),
                angular_velocity=each.spin,
            )
            assert isinstance(body, DrawnBody)
            body.draw(square, texture=file.name)
        if self.game.renderer.name != renderer:
            raise DeviceError(f"{renderer}: there is no driver for it here")
        self._batcher = _core.Batcher()
        picture = self._batcher.hold()
        self._batcher.place(picture, 0, [(0.0, 0.0, SIDE, SIDE, 1.0, 1.0, SIDE - 1.0, SIDE - 1.0, 1.0)])

    def prepare(self) -> None: ...

    def step(self) -> None:
        self.game.world.step(STEP)
        show(self.game)

    def before_the_driver(self, frames: int) -> float:
        """Milliseconds to collect a frame and make the buffers that a graphics card takes, at the least."""
        least = 1e9
        for _ in range(frames):
            self.game.world.step(STEP)
            start = time.perf_counter()
            self._batcher.collect(self.game._collect().content, *SIZE)
            least = min(least, time.perf_counter() - start)
        return 1e3 * least


SCENES = {"turning": True, "straight": False}
"""Sprites that turn, and such as do not, which alone blitters can be compared with."""


def measure(
    counts: Sequence[int], frames: int, peers: Iterable[str], patience: float, tell: Tell
) -> tuple[list[Numbers], list[str]]:
    """A row for each scene and count, and what is not installed or has no driver here."""
    rows: list[Numbers] = []
    missing: dict[str, None] = {}
    with tempfile.TemporaryDirectory() as folder:
        file = picture().save(Path(folder) / "disc.png")
        for scene, turning in SCENES.items():
            for count in counts:
                tell(f"{count} {scene} sprites")
                sprites = crowd(count, turning=turning)
                painters, without = _painters(sprites, file, [one for one in peers if PEERS[one].turns == turning])
                missing |= dict.fromkeys(without)
                before = painters[0].before_the_driver(frames)
                times = take_turns(painters, frames, 2, turn=2, patience=patience)
                rows.append(
                    {
                        "scene": scene,
                        "sprites": count,
                        "before_the_driver": before,
                        "engines": _figures(times),
                        "ratios": _ratios(times),
                    }
                )
    rows += lit.measure(min(counts), frames, patience, tell)
    return rows, list(missing)


def _painters(sprites: Sequence[Sprite], file: Path, peers: Iterable[str]) -> tuple[list[Any], list[str]]:
    painters: list[Any] = [Ours("soft", sprites, file)]
    missing = []
    painters += [Ours("soft", sprites, file, threads) for threads in lit.more_threads()]
    makers: list[tuple[str, Callable[[], Any]]] = [("gl", lambda: Ours("gl", sprites, file))]
    makers += [(name, lambda kind=PEERS[name]: kind(sprites, file)) for name in peers]  # type: ignore[misc]
    for name, make in makers:
        try:
            painters.append(make())
        except (ImportError, DeviceError) as problem:
            missing.append(f"{name} ({problem})")
    return painters, missing


def _figures(times: dict[str, Times]) -> Numbers:
    return {name: {"min": one.least, "median": one.median} for name, one in times.items()}


def _ratios(times: dict[str, Times]) -> Numbers:
    """Our times as parts of the others', by rounds that ran side by side."""
    ours = [name for name in times if name not in PEERS]
    return {f"{name} / {peer}": times[name].ratio(times[peer]) for name in ours for peer in times if peer in PEERS}


def first_frame(renderer: str) -> float:
    """Seconds from the start of a process until it has drawn the first frame of a level.

    The least of three, once the engine's modules are compiled, as they are where it was installed.
    """
    with tempfile.TemporaryDirectory() as compiled:
        known = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        place = {**known, "PYTHONPYCACHEPREFIX": compiled}
        return min([_first_frame(renderer, place) for _ in range(4)][1:])


def _first_frame(renderer: str, environment: dict[str, str]) -> float:
    start = time.time()
    command = [sys.executable, "-c", FIRST_FRAME, renderer]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise DeviceError(f"{renderer}: {done.stderr.strip().splitlines()[-1]}")
    return float(done.stdout) - start


def table_of(rows: Sequence[Numbers]) -> str:
    """Milliseconds a frame, at the least."""
    from evilengine.bench.report import table

    names = list(dict.fromkeys(name for row in rows for name in row["engines"]))
    lines = [("sprites", "", "before the driver", *names)]
    for row in rows:
        figures = [f"{row['engines'][name]['min']:.2f}" if name in row["engines"] else "-" for name in names]
        lines.append((str(row["sprites"]), row["scene"], f"{row['before_the_driver']:.2f}", *figures))
    return table(lines)
