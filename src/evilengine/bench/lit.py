"""Frames of `evil bench draw` that nobody else draws: a crowd that casts soft shadows in many lights, and particles."""

from __future__ import annotations

import contextlib
import random
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from evilengine.bench.timing import take_turns
from evilengine.values.errors import DeviceError
from evilengine.values.governor import QUALITIES
from evilengine.values.tick import STEP
from evilengine.world.shapes import Circle, Rectangle

if TYPE_CHECKING:
    from evilengine.game import Game

SIZE = (640, 360)
METRE = 50.0  # pixels
LIGHTS = 8
CROWD = 1_000
SIDE = 12 / METRE  # metres: that many cover two thirds of the picture
SPECKS = 50_000
LIFE = 2.0  # seconds of a particle


class Frames:
    """A game that `evil bench` steps and draws."""

    def __init__(self, renderer: str, size: tuple[int, int], threads: int) -> None:
        from evilengine.game import Game

        self.name = name_of(renderer, threads)
        self.game = Game(headless=True, renderer=renderer, size=size, gravity=(0, 0), threads=threads)
        if self.game.renderer.name != renderer:
            raise DeviceError(f"{renderer}: there is no driver for it here")

    def prepare(self) -> None: ...

    def step(self) -> None:
        """A whole frame."""
        self.game.step()
        show(self.game)

    def before_the_driver(self, frames: int) -> float:
        """Milliseconds to step and to collect a frame, at the least."""
        least = 1e9
        for _ in range(frames):
            start = time.perf_counter()
            self.game.step()
            self.game._collect()
            least = min(least, time.perf_counter() - start)
        return 1e3 * least


class Lit(Frames):
    """Boxes and balls that turn and drift between lamps, all lit and all casting shadows."""

    def __init__(self, renderer: str, count: int, quality: str, threads: int = 1) -> None:
        super().__init__(renderer, SIZE, threads)
        game, dice = self.game, random.Random(count)
        half = (SIZE[0] / 2 / METRE, SIZE[1] / 2 / METRE)

        def somewhere(part: float) -> tuple[float, float]:
            return dice.uniform(-part, part) * half[0], dice.uniform(-part, part) * half[1]

        game.draw(Rectangle(40, 40), colour="#8a7f74", lit=True, layer=-1, outline=False)
        for number in range(count):
            game.add(
                Rectangle(SIDE, SIDE) if number % 2 else Circle(SIDE / 2),
                kind="kinematic",
                at=somewhere(1.0),
                velocity=somewhere(0.1),
                angular_velocity=dice.uniform(-2, 2),
                colour="#b98b5a",
                lit=True,
                outline=False,
            )
        for _ in range(LIGHTS):
            game.add_light(at=somewhere(0.9), radius=4.4, colour=tuple(dice.uniform(0.5, 1) for _ in range(3)))
        game.lights.ambient, game.lights.quality = 0.1, quality


class Specks(Frames):
    """A fountain of particles that shine."""

    def __init__(self, renderer: str, count: int, threads: int = 1) -> None:
        super().__init__(renderer, (1280, 720), threads)
        self.game.add_particles(
            at=(0, -2), rate=count / LIFE, life=LIFE, speed=4, cone=1.5, size=[0.06, 0.02], blend="add", most=count
        )
        self.game.step(round(LIFE / STEP) + 2)


def name_of(renderer: str, threads: int) -> str:
    """What a table calls it."""
    return f"evil {renderer}" if threads == 1 else f"evil {renderer}, {threads} threads"


def more_threads() -> tuple[int, ...]:
    """How many a game would draw with by itself, unless that is one."""
    from evilengine.renderer import threads_for_pictures

    threads = threads_for_pictures(None, "bench")
    return (threads,) if threads > 1 else ()


def show(game: Game) -> None:
    """Draw the frame, and wait for the card."""
    game.renderer.draw(game._collect())
    backend = getattr(game.renderer, "_backend", None)
    if backend is not None:
        with backend.device:
            backend.device.context.finish()


def measure(most: int, frames: int, patience: float, tell: Callable[[str], None]) -> list[dict[str, Any]]:
    """A row for each quality of light and one of particles; at most `most` bodies and fifty times as many specks."""
    crowd, specks = min(CROWD, most), min(SPECKS, 50 * most)
    made: list[tuple[str, int, Callable[[str, int], Frames]]] = [
        (f"{LIGHTS} lights, {quality}", crowd, lambda renderer, n, q=quality: Lit(renderer, crowd, q, n))  # type: ignore[misc]
        for quality in QUALITIES
    ]
    made.append(("particles", specks, lambda renderer, n: Specks(renderer, specks, n)))
    rows = []
    for scene, count, make in made:
        tell(f"{count} {scene}")
        painters = _painters(make)
        before = painters[0].before_the_driver(frames)
        times = take_turns(painters, frames, 2, turn=2, patience=patience)
        figures = {name: {"min": one.least, "median": one.median} for name, one in times.items()}
        rows.append({"scene": scene, "sprites": count, "before_the_driver": before, "engines": figures, "ratios": {}})
    return rows


def _painters(make: Callable[[str, int], Frames]) -> Sequence[Frames]:
    painters = [make("soft", threads) for threads in (1, *more_threads())]
    with contextlib.suppress(DeviceError):  # said of the sprites already
        painters.append(make("gl", 1))
    return painters
