#!/usr/bin/env python3
"""What mixing costs: microseconds for a block of 480 frames (10 ms), on each instruction set.

python tools/bench_mixer.py
"""

from __future__ import annotations

import math
import time
from array import array

from evilengine import _core

FRAMES = 480
KINDS = {"as it is": 1.0, "44.1 kHz": 0.91875, "an octave up": 2.0}


def microseconds(instructions: str, voices: int, speed: float) -> float:
    mixer = _core.Mixer(instructions=instructions)
    sound = _core.Sample(array("f", (math.sin(i / 20) for i in range(48000))), channels=1, rate=48000)
    for _ in range(voices):
        mixer.start(sample=sound, speed=speed, gains=(0.01, 0.01, 0.0, 0.0), loop=(0, sound.frames))
    best = math.inf
    for _ in range(60):
        start = time.perf_counter()
        mixer.render(FRAMES)
        best = min(best, time.perf_counter() - start)
    return best * 1e6


def main() -> None:
    for instructions in _core.instruction_sets():
        for voices in (32, 128):
            costs = ", ".join(
                f"{kind} {microseconds(instructions, voices, speed):.0f}" for kind, speed in KINDS.items()
            )
            print(f"{instructions:6} {voices:4} voices: {costs} µs a block of 10 ms")


if __name__ == "__main__":
    main()
