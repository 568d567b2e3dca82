"""Say what this machine has for games, and what to install for more.

It looks at Python, the engine and its core, the renderer, the screen, sound, input devices, pictures and fonts.
A line that begins with "!" is something that is missing; the line below it says what to do.
"""

from __future__ import annotations

import argparse
import importlib.util
import platform
import struct
import sys
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from evilengine.values.version import VERSION

AGAIN = "install it again: pip install --force-reinstall evilengine"


@dataclass(frozen=True, slots=True)
class Finding:
    """One line of the report."""

    subject: str
    found: str
    advice: str = ""
    """What to do about it; empty when all is well."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """It takes none."""


def run(args: argparse.Namespace) -> int:
    for finding in examine():
        print(f"{'!' if finding.advice else ' '} {finding.subject:<10} {finding.found}")
        if finding.advice:
            print(f"  {'':<10} -> {finding.advice}")
    return 0


def examine() -> list[Finding]:
    """Every finding. A check that fails is a finding too: this is what people run when something is broken."""
    findings: list[Finding] = []
    for subject, check in CHECKS.items():
        try:
            findings += (Finding(subject, *each) for each in check())
        except Exception as error:
            findings.append(Finding(subject, f"cannot be used: {type(error).__name__}: {error}", AGAIN))
    return findings


Lines = Iterable[tuple[str] | tuple[str, str]]
"""What was found, and what to do if it is not well."""


def _python() -> Lines:
    bits = 8 * struct.calcsize("P")
    yield (f"{platform.python_version()}, {platform.system()} {platform.machine()}, {bits} bit",)


def _engine() -> Lines:
    yield (f"{VERSION}, in {Path(__file__).parent.parent}",)


def _core() -> Lines:
    from evilengine import _core

    yield (f"compiled, with kernels for {_core.instruction_sets()[-1]}",)


def _renderer() -> Lines:
    from evilengine.game import Game
    from evilengine.renderer.report import graphics

    game = Game(headless=True, renderer="soft")
    best = min(_seconds(game.capture) for _ in range(5))
    yield (f"soft, which needs no graphics card; an empty picture of 960x540 takes {1000 * best:.1f} ms",)
    found = graphics()
    if found.renderer:
        use = "a program on the processor, so auto takes soft" if found.software else "auto takes it"
        yield (f"gl: {found.renderer}, {found.driver} ({use})",)
    else:
        yield ("gl: no driver, so auto takes soft", found.problem)


def _seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def _devices() -> Lines:
    from evilengine.platform.report import report

    found = report()
    yield (f"SDL {found.sdl}",)
    if found.no_screen:
        advice = "on Linux without a desktop: apt install xvfb, then xvfb-run evil play; films need no screen"
        yield (found.no_screen, advice if sys.platform.startswith("linux") else "run it in a session with a desktop")
    for screen in found.screens:
        yield (f"screen: {screen} (driver {found.video_driver})",)
    if found.no_sound:
        yield (f"no sound: {found.no_sound}", "connect or enable an output; games play silently until then")
    for output in found.outputs:
        yield (f"sound: {output} (driver {found.audio_driver})",)
    yield ("input: keyboard and mouse" if not found.no_screen else "input: none without a window, but scripted",)
    for kind, names in (("touch screen", found.touch_screens), ("pad", found.pads), ("sensor", found.sensors)):
        for name in names:
            yield (f"{kind}: {name}",)


def _pictures() -> Lines:
    import PIL
    from PIL import features

    missing = [name for name in ("webp", "jpg", "zlib") if not features.check(name)]
    advice = f"it cannot handle {', '.join(missing)}; pip install --upgrade Pillow brings one that can"
    yield (f"Pillow {PIL.__version__}", advice) if missing else (f"Pillow {PIL.__version__}: webp, jpg, png, gif",)


def _fonts() -> Lines:
    from PIL import features

    if features.check("freetype2"):
        yield ("built in, at any size",)
    else:
        yield ("this Pillow has no FreeType, so text is small", "pip install --upgrade Pillow brings one that has it")
    if importlib.util.find_spec("uharfbuzz") is None:
        yield (
            "all pairs of letters stand equally far apart",
            "pip install uharfbuzz reads what typefaces say of pairs",
        )


CHECKS: dict[str, Callable[[], Lines]] = {
    "Python": _python,
    "EvilEngine": _engine,
    "core": _core,
    "renderer": _renderer,
    "devices": _devices,
    "pictures": _pictures,
    "fonts": _fonts,
}
