"""The same bits from other builds: without optimisation, by another compiler, on another processor.

Every scene of the benchmarks is stepped from a snapshot by the module in use and by a small program (tests/exact) built
each other way; all sums must be equal. What the machine has no compiler for is named and left out.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WARM, STEPS = 20, 40  # before the snapshot, so that it holds impulses to start from; and after it
ARM = "aarch64-linux-gnu"


@dataclass(frozen=True)
class Build:
    """A way to build the program, and how to run it; `needs` are programs, `package` is where Debian has them."""

    name: str
    options: tuple[str, ...]
    needs: tuple[str, ...] = ()
    package: str = ""
    runner: tuple[str, ...] = ()


BUILDS = (
    Build("-O0", ("-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O0")),
    Build(
        "ARM64",
        (
            *("-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_SYSTEM_NAME=Linux", "-DCMAKE_SYSTEM_PROCESSOR=aarch64"),
            *(f"-DCMAKE_CXX_COMPILER={ARM}-g++", "-DCMAKE_EXE_LINKER_FLAGS=-static"),
        ),
        (f"{ARM}-g++", "qemu-aarch64"),
        "g++-aarch64-linux-gnu qemu-user",
        ("qemu-aarch64",),
    ),
    Build("Clang", ("-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=clang++"), ("clang++",), "clang"),
)


def write_scenes(folder: Path) -> dict[str, str]:
    """A snapshot of each scene as a file, and what it comes to here."""
    from evilengine import World
    from evilengine.bench.scene import SCENES, stage

    sums = {}
    for name, scene in SCENES.items():
        staged = stage(scene, scene.small, sleep=True)
        for _ in range(WARM):
            staged.step()
        data = staged.world.snapshot()
        Path(folder, name).write_bytes(data)
        alone = World.of(data)  # without what the scene does by itself, which the program does not know
        for _ in range(STEPS):
            alone.step()
        sums[name] = f"{alone.checksum():016x}"
    return sums


def compare(build: Build, program: Path, folder: Path, sums: dict[str, str]) -> int:
    """Print what comes out otherwise; how many that are."""
    command = [*build.runner, str(program), str(STEPS), *sums]
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, text=True, check=True)
    rows = [line.split() for line in done.stdout.splitlines()]
    wrong = [(scene, kind) for scene, kind, found in rows if found != sums[scene]]
    sets = sorted({kind for _, kind, _ in rows})
    for scene, kind in wrong:
        print(f"exact: {build.name}: {scene} comes out otherwise with {kind}")
    same = f"{len(rows) - len(wrong)} of {len(rows)} sums are the same bits"
    print(f"exact: {build.name}: {same} ({len(sums)} scenes on {', '.join(sets)})")
    return len(wrong) + (len(rows) != len(sums) * len(sets) or not rows)


def main(make: Callable[..., None], names: tuple[str, ...]) -> None:
    """Build and compare all, or those named; `make` configures and compiles a target in a folder."""
    chosen = [build for build in BUILDS if not names or build.name in names]
    if len(chosen) < len(names):
        sys.exit(f"exact: builds are {', '.join(build.name for build in BUILDS)}; got {', '.join(names)}")
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        sums = write_scenes(Path(folder))
        for build in chosen:
            if not all(map(shutil.which, build.needs)):
                print(f"exact: {build.name}: left out; apt-get install {build.package}")
                continue
            there = ROOT / "build" / f"exact{build.name}"
            make(there, "steps", "-DEVIL_BINDINGS=OFF", "-DEVIL_EXACT=ON", *build.options)
            wrong += compare(build, there / "steps", Path(folder), sums)
    if wrong:
        sys.exit(f"exact: {wrong} sums differ")
