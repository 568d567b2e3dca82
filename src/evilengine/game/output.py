"""Where a game is heard."""

from __future__ import annotations

from pathlib import Path, PurePath

from evilengine.audio import Card, Output, WavFile
from evilengine.platform import Device, HeadlessDevice, Speaker
from evilengine.values.checks import one_of

SHIPPED = Path(__file__).parent.parent / "examples"
"""Where sounds are looked for last: beside the shipped examples."""


def open_output(sound: str | Path) -> Output:
    """What `Game(sound=...)` asks for: "auto", "none", or a .wav file. A sound card is opened at the first sound."""
    if isinstance(sound, (str, Path)) and PurePath(sound).suffix == ".wav":
        return WavFile(sound)
    return Card(Speaker) if one_of(sound, "Game", "sound", ("auto", "none", "FILE.wav")) == "auto" else Output()


def for_device(output: Output, device: Device) -> Output:
    """The output itself, or none instead of the card where nobody looks on."""
    return Output() if isinstance(output, Card) and isinstance(device, HeadlessDevice) else output
