#!/usr/bin/env python3
"""Make the sounds of the example game "tower": python tools/sound_tower.py  (needs `pip install soundfile`)

All of it is sines that fade and noise that is filtered: a thud, a chime, a splash, and sixteen seconds of music that
end where they begin.
"""

from __future__ import annotations

import math
import random
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "src" / "evilengine" / "examples" / "tower"
RATE = 22050  # samples a second: as much as these sounds hold
LOOP = 16  # seconds


def tone(pitch: float, seconds: float, fade: float, overtones: tuple[float, ...] = (1.0,)) -> list[float]:
    """A note that fades to 1/e every `fade` seconds; overtones fade sooner."""
    out = []
    for count in range(int(seconds * RATE)):
        t = count / RATE
        start = min(1.0, t / 0.004)  # no click
        end = min(1.0, (seconds - t) / 0.02)
        out.append(start * end * sum(
            loud * math.exp(-t * n / fade) * math.sin(math.tau * pitch * n * t) for n, loud in enumerate(overtones, 1)
        ))  # fmt: skip
    return out


def noise(seconds: float, fade: float, smooth: float, dice: random.Random) -> list[float]:
    """Noise that fades; the nearer `smooth` is to 1, the darker it is."""
    out, value = [], 0.0
    for count in range(int(seconds * RATE)):
        value += (dice.uniform(-1, 1) - value) * (1 - smooth)
        out.append(value * math.exp(-count / RATE / fade) * min(1.0, count / 60))
    return out


def mix(into: list[float], sound: list[float], at: float, volume: float, *, around: bool = False) -> None:
    """Add `sound` at a time in seconds; `around` puts what goes over the end at the beginning."""
    begin = int(at * RATE)
    for count, value in enumerate(sound):
        place = begin + count
        if around:
            place %= len(into)
        if place < len(into):
            into[place] += value * volume


def silence(seconds: float) -> list[float]:
    return [0.0] * int(seconds * RATE)


def thud() -> list[float]:
    out = silence(0.4)
    mix(out, tone(82, 0.4, 0.08, (1.0, 0.3)), 0, 0.9)
    mix(out, tone(164, 0.2, 0.03, (1.0,)), 0, 0.5)
    mix(out, noise(0.12, 0.025, 0.8, random.Random(1)), 0, 1.6)
    return out


def chime() -> list[float]:
    out = silence(0.9)
    for count, pitch in enumerate((659.3, 987.8, 1318.5)):
        mix(out, tone(pitch, 0.9 - count * 0.07, 0.22, (1.0, 0.25, 0.12)), count * 0.07, 0.3)
    mix(out, noise(0.1, 0.02, 0.8, random.Random(1)), 0, 0.8)
    return out


def splash() -> list[float]:
    out = silence(0.8)
    dice = random.Random(2)
    mix(out, noise(0.8, 0.16, 0.55, dice), 0, 0.9)
    for _ in range(9):
        mix(out, tone(dice.uniform(400, 1300), 0.09, 0.03), dice.uniform(0.05, 0.5), 0.16)
    return out


def music() -> list[float]:
    """Four chords, a slow bass, a soft choir of sines, and plucked notes that wander over them."""
    out = silence(LOOP)
    dice = random.Random(8)
    chords = ((220.0, 261.6, 329.6), (174.6, 220.0, 261.6), (196.0, 261.6, 329.6), (196.0, 246.9, 293.7))  # Am F C G
    for bar, chord in enumerate(chords):
        for pitch in chord:
            for detune in (0.997, 1.003):
                mix(out, swell(pitch * detune, 5.0), bar * 4 - 0.5 + LOOP, 0.05, around=True)
        for beat in (0.0, 1.5, 2.0, 3.5):
            mix(out, tone(chord[0] / 2, 1.4, 0.5, (1.0, 0.4, 0.1)), bar * 4 + beat, 0.2, around=True)
        for eighth in range(8):
            if dice.random() < (0.95, 0.5, 0.75, 0.6)[eighth % 4]:
                pitch = dice.choice(chord) * dice.choice((2, 2, 4))
                mix(out, tone(pitch, 1.6, 0.35, (1.0, 0.2, 0.1)), bar * 4 + eighth / 2, 0.13, around=True)
    return out


def swell(pitch: float, seconds: float) -> list[float]:
    """A note that comes and goes."""
    length = int(seconds * RATE)
    return [math.sin(math.pi * n / length) ** 2 * math.sin(math.tau * pitch * n / RATE) for n in range(length)]


def save(name: str, sound: list[float]) -> None:
    import numpy
    import soundfile

    loudest = max(map(abs, sound)) / 0.7
    with soundfile.SoundFile(
        FOLDER / name, "w", RATE, 1, format="OGG", subtype="VORBIS", compression_level=0.9
    ) as file:
        for part in numpy.array_split(numpy.array(sound) / loudest, 64):  # all at once is more than its encoder takes
            file.write(part)


def main() -> None:
    for make in (thud, chime, splash, music):
        name = f"{make.__name__}.ogg"
        save(name, make())
        print(f"{name}: {(FOLDER / name).stat().st_size / 1000:.1f} kB")


if __name__ == "__main__":
    main()
