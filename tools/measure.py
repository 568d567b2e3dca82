#!/usr/bin/env python3
"""The engine's numbers on this machine: what a call, a frame and an import cost, and how still a stack stands.

python tools/measure.py        prints one number a line
"""

from __future__ import annotations

import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
import timeit
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path

import bench_mixer

import evilengine as evil
from evilengine import _core
from evilengine.platform.speaker import Speaker, clock_address
from evilengine.renderer.report import graphics
from evilengine.values.drawlist import DrawList
from evilengine.values.image import Image

SECONDS_A_STEP = 1 / 60


def import_ms() -> float:
    """Milliseconds of `import evilengine` in a fresh process, beyond bare Python's own start."""

    def best(code: str) -> float:
        times = []
        for _ in range(7):
            start = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            times.append(time.perf_counter() - start)
        return min(times)

    return (best("import evilengine") - best("pass")) * 1e3


def nanoseconds(call: Callable[[], object]) -> float:
    """Nanoseconds of one call, the loop's own share taken out."""
    rounds = 200_000

    def best(function: Callable[[], object]) -> float:
        return min(timeit.repeat(function, number=rounds, repeat=5))

    return (best(call) - best(lambda: None)) / rounds * 1e9


def stack_drift() -> float:
    """Metres that the top of ten stacked boxes wanders from where it settled, over a minute."""
    world = evil.World()
    world.add(evil.Rectangle(20, 1), at=(0, -0.5), kind="static")
    boxes = [world.add(evil.Rectangle(1, 1), at=(0, 0.5 + level)) for level in range(10)]
    for _ in range(120):
        world.step(SECONDS_A_STEP)
    settled = boxes[-1].position
    furthest = 0.0
    for _ in range(60 * 60):
        world.step(SECONDS_A_STEP)
        furthest = max(furthest, (boxes[-1].position - settled).length)
    return furthest


def frame_ms(renderer: str) -> float:
    """Milliseconds of one step and picture of Prototype 1 at 960 x 540; median of 120."""
    game = evil.Game("Prototype 1", size=(960, 540), headless=True, renderer=renderer)
    game.load(str(files("evilengine.examples") / "prototype1.evil"))
    times = []
    for _ in range(120):
        start = time.perf_counter()
        game.step()
        game.capture()
        times.append(time.perf_counter() - start)
    return sorted(times)[len(times) // 2] * 1e3


def sprites_ms(renderer: str, count: int = 5000) -> tuple[float, int]:
    """Milliseconds of a picture of 1280 x 720 with so many turned crates of 24 pixels, and its draw calls."""
    game = evil.Game("Sprites", size=(1280, 720), headless=True, renderer=renderer)
    texture = game.renderer.upload(Image.of(32, 32, bytes(range(256)) * 16))
    content = _core.DrawList()
    crate = content.polygon([(-12, -12), (12, -12), (12, 12), (-12, 12)])
    for number in range(count):
        x, y = number * 0.618034 % 1 * 1280, number * 0.754878 % 1 * 720  # all over, and never in rows
        sine, cosine = _core.sincos(number)
        content.instance(crate, (cosine, sine, -sine, cosine, x, y), texture=texture)
    frame = DrawList((1280, 720), 0xFF000000, content)

    def draw() -> None:
        game.renderer.draw(frame)
        _ = game.renderer.pixels

    return min(timeit.repeat(draw, number=1, repeat=5)) * 1e3, game.renderer.draw_calls


def graphics_lines() -> None:
    """What pictures cost on the graphics card, or on the driver that plays one, beside the software renderer."""
    found = graphics()
    for renderer in ("soft", "gl") if found.renderer else ("soft",):
        milliseconds, calls = sprites_ms(renderer)
        note = f" ({found.renderer}, {calls} draw call)" if renderer == "gl" else ""
        print(f"5,000 sprites, 1280x720, {renderer:<4}    {milliseconds:8.2f} ms{note}")
    if found.renderer:
        print(f"Prototype 1 by gl                {frame_ms('gl'):8.2f} ms")


def game_of(level: str) -> evil.Game:
    """The game that a shipped level makes, without a screen."""
    game = evil.Game("Measured", size=(960, 540), headless=True, renderer="soft")
    game.load(str(files("evilengine.examples") / level))
    return game


def crowded(count: int = 5000) -> evil.Game:
    """A game of so many bodies that lie on each other in a box."""
    game = evil.Game("Crowded", size=(960, 540), headless=True, renderer="soft")
    across = math.isqrt(count)
    game.add(evil.Rectangle(across * 1.2, 1), at=(0, -0.5), kind="static")
    for number in range(count):
        row, column = divmod(number, across)
        game.add(evil.Circle(0.5) if number % 2 else evil.Rectangle(0.9, 0.9), at=(column - across / 2, 0.5 + row))
    return game


def save_and_resume_ms(game: evil.Game) -> tuple[float, float, int]:
    """Milliseconds of game.save to a file, of game.resume from it, and the bytes of the file; after two seconds."""
    game.step(120)
    with tempfile.TemporaryDirectory() as folder:
        path = game.save("measured", folder=folder)
        save = min(timeit.repeat(lambda: game.save("measured", folder=folder), number=1, repeat=5))
        resume = min(timeit.repeat(lambda: game.resume("measured", folder=folder), number=1, repeat=5))
        return save * 1e3, resume * 1e3, path.stat().st_size


def recording_us(game: evil.Game, steps: int = 120) -> tuple[float, float]:
    """Microseconds of a step of a game that is recorded, and how many of them the recording takes; medians."""
    spent: list[float] = []
    times: list[float] = []

    def timed(function: Callable[..., object]) -> Callable[..., None]:
        def measured(*args: object) -> None:
            start = time.perf_counter()
            function(*args)
            spent[-1] += time.perf_counter() - start

        return measured

    with tempfile.TemporaryDirectory() as folder:
        recorder = game.record(Path(folder) / "measured.evr")
        for owner, name in ((recorder, "begin_step"), (game, "_note_step")):
            setattr(owner, name, timed(getattr(owner, name)))
        for _ in range(steps):
            spent.append(0.0)
            start = time.perf_counter()
            game.step()
            times.append(time.perf_counter() - start)
        game.close()
    return statistics.median(times) * 1e6, statistics.mean(sorted(spent)[: steps * 9 // 10]) * 1e6


def saving_lines() -> None:
    """What it costs to keep a game, and to record one."""
    makers: dict[str, Callable[[], evil.Game]] = {
        "Prototype 1": lambda: game_of("prototype1.evil"),
        "5,000 bodies": crowded,
    }
    for name, make in makers.items():
        save, resume, size = save_and_resume_ms(make())
        print(f"{name + ', saved':<33}{save:8.2f} ms ({size / 1e3:.0f} kB), resumed {resume:.2f} ms")
        step, share = recording_us(make())
        print(f"{name + ', recorded':<33}{share:8.1f} us a step of {step:.0f} us")


def sound_lines() -> None:
    """What the mixer costs, and how long the card may have to wait for it while Python is busy."""
    for voices in (32, 128):
        cost = bench_mixer.microseconds(_core.instruction_sets()[-1], voices, 0.91875)
        print(f"mixing {voices:3} voices of 44.1 kHz     {cost:8.0f} us a block of 10 ms")
    os.environ.setdefault("SDL_AUDIODRIVER", "dummy")
    mixer = _core.Mixer()
    address, frequency = clock_address()
    try:
        card = Speaker(mixer.callback, mixer.address, mixer, 48000)
    except evil.DeviceError as problem:
        print(f"worst gap of the sound card      {problem}")
        return
    mixer.watch(address)
    end = time.perf_counter() + 2.0
    while time.perf_counter() < end:
        sum(range(10_000))
    blocks, gap, _ = mixer.punctuality
    card.close()
    print(
        f"worst gap of the sound card      {gap / frequency * 1e3:8.1f} ms between blocks of 10.7 ms ({blocks} blocks)"
    )


def main() -> None:
    body = evil.World().add(evil.Circle(1))
    print(f"import evilengine                {import_ms():8.1f} ms")
    print(f"body.position                    {nanoseconds(lambda: body.position):8.0f} ns")
    print(f"body.apply_force((0, 1))         {nanoseconds(lambda: body.apply_force((0, 1))):8.0f} ns")
    print(f"a frame of Prototype 1, 960x540  {frame_ms('soft'):8.2f} ms")
    graphics_lines()
    saving_lines()
    sound_lines()
    print(f"drift of ten boxes in a minute   {stack_drift() * 1e3:8.3f} mm")


if __name__ == "__main__":
    main()
