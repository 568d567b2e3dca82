"""Every scene comes out to the same bits: on every instruction set, for any number of threads, in any process.

The sums are in golden/scenes.json. A change of the physics changes them: look at the scenes (`evil testbed`), then
write the new ones by `python tests/test_scene_bits.py` and say in the commit why they changed.
"""

from __future__ import annotations

import functools
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from evilengine import _core
from evilengine.bench.scene import SCENES, find, stage

GOLDEN = Path(__file__).with_name("golden") / "scenes.json"
STEPS = 90


def sum_of(name: str, *, threads: int = 1, instructions: str | None = None) -> str:
    """The checksum of a scene of the tests' size after so many steps."""
    scene = find(name)
    staged = stage(scene, scene.small, threads=threads, sleep=True)
    if instructions is not None:
        staged.world._core.instruction_set = instructions
    for _ in range(STEPS):
        staged.step()
    return f"{staged.world.checksum():016x}"


@functools.cache
def plain_sum_of(name: str) -> str:
    return sum_of(name)


def golden() -> dict[str, str]:
    sums: dict[str, str] = json.loads(GOLDEN.read_text())
    return sums


def test_there_is_a_golden_sum_for_each_scene_and_no_other() -> None:
    assert list(golden()) == list(SCENES)


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_comes_out_as_it_always_did(name: str) -> None:
    assert plain_sum_of(name) == golden()[name]


@pytest.mark.parametrize("instructions", _core.instruction_sets())
@pytest.mark.parametrize("name", SCENES)
def test_a_scene_comes_out_the_same_on_every_instruction_set(name: str, instructions: str) -> None:
    assert sum_of(name, instructions=instructions) == plain_sum_of(name)


@pytest.mark.parametrize("threads", [2, 5])
@pytest.mark.parametrize("name", SCENES)
def test_a_scene_comes_out_the_same_for_any_number_of_threads(name: str, threads: int) -> None:
    assert sum_of(name, threads=threads) == plain_sum_of(name)


@pytest.mark.parametrize("seed", ["0", "7", "4294967295"])
def test_scenes_come_out_the_same_in_another_process_with_other_hashes(seed: str) -> None:
    command = [sys.executable, __file__, "--print"]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=300, env=os.environ | {"PYTHONHASHSEED": seed}
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == {name: plain_sum_of(name) for name in SCENES}


def main() -> None:
    sums = json.dumps({name: sum_of(name) for name in SCENES}, indent=1)
    if sys.argv[1:] == ["--print"]:
        print(sums)
    else:
        GOLDEN.write_text(sums + "\n")


if __name__ == "__main__":
    main()
