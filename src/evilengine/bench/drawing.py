"""`evil bench draw`: what a frame of moving sprites costs, here and in others, all headless and in one process."""

from __future__ import annotations

import importlib
import os
import random
import tempfile
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple, Protocol

from evilengine import _core
from evilengine.bench.timing import Times, take_turns
from evilengine.scene.drawn_body import DrawnBody
from evilengine.values.errors import DeviceError
from evilengine.values.image import Image
from evilengine.values.tick import STEP
from evilengine.world.shapes import Particle, Rectangle

Tell = Callable[[str], None]
Numbers = dict[str, Any]

SIZE = (1280, 720)
SIDE = 32  # pixels of a sprite
METRE = 50.0  # pixels
COUNTS = (5_000, 20_000)


class Sprite(NamedTuple):
    """Where it begins, in pixels from the lower left, and how it goes: pixels and radians a second."""

    x: float
    y: float
    vx: float
    vy: float
    spin: float


def crowd(count: int, *, turning: bool) -> list[Sprite]:
    """The same sprites for everybody."""
    dice = random.Random(count)
    return [
        Sprite(
            dice.uniform(0, SIZE[0]),
            dice.uniform(0, SIZE[1]),
            dice.uniform(-60, 60),
            dice.uniform(-60, 60),
            dice.uniform(-3, 3) if turning else 0.0,
        )
        for _ in range(count)
    ]


def picture() -> Image:
    """What all of them show: a disc with soft edges on nothing."""
    middle = (SIDE - 1) / 2
    pixels = bytearray()
    for y in range(SIDE):
        for x in range(SIDE):
            away = ((x - middle) ** 2 + (y - middle) ** 2) ** 0.5
            pixels += bytes((255 - 6 * y, 120 + 4 * x, 90, max(0, min(255, round(255 * (middle - away))))))
    return Image.of(SIDE, SIDE, pixels)


class Painter(Protocol):
    """Who draws the crowd: `step` is a whole frame, with the sprites moved."""

    name: str

    def prepare(self) -> None: ...

    def step(self) -> None: ...


class Ours:
    """Bodies that the world moves, and drawings on them."""

    def __init__(self, renderer: str, sprites: Sequence[Sprite], file: Path) -> None:
        from evilengine.game import Game

        self.name = f"evil {renderer}"
        self.game = Game(headless=True, renderer=renderer, size=SIZE, gravity=(0, 0), folder=file.parent)
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
        self.game.renderer.draw(self.game._collect())
        backend = getattr(self.game.renderer, "_backend", None)
        if backend is not None:
            with backend.device:
                backend.device.context.finish()

    def before_the_driver(self, frames: int) -> float:
        """Milliseconds to collect a frame and make the buffers that a graphics card takes, at the least."""
        least = 1e9
        for _ in range(frames):
            self.game.world.step(STEP)
            start = time.perf_counter()
            self._batcher.collect(self.game._collect().content, *SIZE)
            least = min(least, time.perf_counter() - start)
        return 1e3 * least


class Pygame:
    """pygame-ce: `Surface.fblits` on the processor. It turns nothing: turned pictures would be made one by one."""

    name = "pygame-ce"

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
        self._pygame: Any = importlib.import_module("pygame")
        self._target = self._pygame.Surface(SIZE)
        self._picture = self._pygame.image.load(str(file))
        self._places = [[each.x, each.y, each.vx, each.vy] for each in sprites]

    def prepare(self) -> None: ...

    def step(self) -> None:
        for place in self._places:
            place[0] += place[2] * STEP
            place[1] += place[3] * STEP
        self._target.fill((28, 33, 48))
        self._target.fblits([(self._picture, (place[0], place[1])) for place in self._places])


class Arcade:
    """arcade: a SpriteList, without a window."""

    name = "arcade"

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        os.environ["ARCADE_HEADLESS"] = "True"
        arcade: Any = importlib.import_module("arcade")
        self._window = arcade.open_window(*SIZE, "bench")
        self._list = arcade.SpriteList()
        texture = arcade.load_texture(str(file))
        for each in sprites:
            sprite = arcade.Sprite(texture, center_x=each.x, center_y=each.y)
            sprite.change_x, sprite.change_y, sprite.change_angle = each.vx * STEP, each.vy * STEP, each.spin
            self._list.append(sprite)

    def prepare(self) -> None:
        self._window.switch_to()
        self._window.ctx.screen.use(force=True)

    def step(self) -> None:
        self._list.update()
        self._window.clear()
        self._list.draw()
        self._window.ctx.finish()


class Pyglet:
    """pyglet: a Batch of sprites, without a window."""

    name = "pyglet"

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        pyglet: Any = importlib.import_module("pyglet")
        pyglet.options["headless"] = True
        self._gl: Any = importlib.import_module("pyglet.gl")
        self._window = importlib.import_module("pyglet.window").Window(*SIZE)
        image = importlib.import_module("pyglet.image").load(str(file))
        graphics = importlib.import_module("pyglet.graphics")
        sprite: Any = importlib.import_module("pyglet.sprite").Sprite
        self._batch = graphics.Batch()
        self._sprites = [(sprite(image, each.x, each.y, batch=self._batch), each) for each in sprites]

    def prepare(self) -> None:
        self._window.switch_to()

    def step(self) -> None:
        for sprite, each in self._sprites:
            turned = sprite.rotation + each.spin
            sprite.update(x=sprite.x + each.vx * STEP, y=sprite.y + each.vy * STEP, rotation=turned)
        self._window.clear()
        self._batch.draw()
        self._gl.glFinish()


PEERS: dict[str, Any] = {each.name: each for each in (Pygame, Arcade, Pyglet)}
"""Who draws the same beside us: `pip install 'evilengine[bench-draw]'` brings them."""

SCENES = {"turning": True, "straight": False}
"""Sprites that turn, and such as do not, which alone blitters can be compared with."""


def measure(
    counts: Iterable[int], frames: int, peers: Iterable[str], patience: float, tell: Tell
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
                painters, without = _painters(sprites, file, [one for one in peers if turning or one == "pygame-ce"])
                missing |= dict.fromkeys(without)
                before = painters[0].before_the_driver(frames)
                times = take_turns(painters, frames, 2, turn=2, patience=patience)
                rows.append({"scene": scene, "sprites": count, "before_the_driver": before, "engines": _figures(times)})
    return rows, list(missing)


def _painters(sprites: Sequence[Sprite], file: Path, peers: Iterable[str]) -> tuple[list[Any], list[str]]:
    painters: list[Any] = [Ours("soft", sprites, file)]
    missing = []
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


def table_of(rows: Sequence[Numbers]) -> str:
    """Milliseconds a frame, at the least."""
    from evilengine.bench.report import table

    names = list(dict.fromkeys(name for row in rows for name in row["engines"]))
    lines = [("sprites", "", "before the driver", *names)]
    for row in rows:
        figures = [f"{row['engines'][name]['min']:.2f}" if name in row["engines"] else "-" for name in names]
        lines.append((str(row["sprites"]), row["scene"], f"{row['before_the_driver']:.2f}", *figures))
    return table(lines)
