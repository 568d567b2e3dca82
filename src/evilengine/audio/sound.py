"""Sound: the handle of one sound that plays."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Protocol

from evilengine.audio.groups import LOUDEST, RAMP, Group
from evilengine.audio.hearing import Gains, Listener, from_place, gains
from evilengine.audio.outputs import RATE
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import StaleReferenceError
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine.audio.audio import Audio

LONGEST_FADE = 120.0  # seconds
CLICK = 240  # frames, 5 ms: the shortest way from a sound to silence that is not heard as a click
LOWEST_PITCH, HIGHEST_PITCH = 1 / 16, 4.0


class Placed(Protocol):
    """Something that a sound can go along with: a Body, for example."""

    @property
    def position(self) -> Vec2: ...
    @property
    def alive(self) -> bool: ...


class Sound:
    """A sound that plays: what `audio.play` and `audio.music` give.

    When it has come to its end, or was stopped, it is gone: `alive` is False and any other use raises
    StaleReferenceError. Time is the game's, so that a game plays the same with and without a sound card.

    >>> import evilengine as evil
    >>> game = evil.Game(headless=True)
    >>> game.audio.add("hum", [0.1, 0.1, -0.1, -0.1] * 6000)
    >>> hum = game.audio.play("hum", volume=0.5)
    >>> game.step(29); hum.alive, round(hum.position, 3)
    (True, 0.483)
    >>> game.step(); hum.alive
    False
    """

    __slots__ = (
        "__weakref__", "_at", "_audio", "_began", "_channels", "_ended_by", "_group", "_length", "_loop", "_name",
        "_pan", "_pitch", "_rate", "_sent", "_start", "_voice", "_volume",
    )  # fmt: skip

    def __init__(
        self, audio: Audio, name: str, *, group: Group, length: float, rate: float, channels: int, loop: bool,
        volume: float, pitch: float, pan: float, at: Point | Placed | None, start: float,
    ) -> None:  # fmt: skip
        self._audio = audio
        self._name = name
        self._group = group
        self._length = length
        self._rate = rate
        self._channels = channels
        self._loop = loop
        self._ended_by = ""
        self._voice = 0  # 0: nobody plays it
        self._volume = number(volume, "Sound", "volume", least=0.0, most=LOUDEST)
        self._pitch = number(pitch, "Sound", "pitch", least=LOWEST_PITCH, most=self._highest_pitch())
        self._pan = number(pan, "Sound", "pan", least=-1.0, most=1.0)
        self._at: Vec2 | Placed | None = None if at is None else _place(at)
        self._start = number(start, "Sound", "start", least=0.0)
        self._began = group._seconds(audio._step())
        self._sent: Gains = (0.0, 0.0, 0.0, 0.0)

    def __repr__(self) -> str:
        return f"<Sound {self._name!r}, {f'at {self._now():.2f} s' if self.alive else 'ended'}>"

    @property
    def alive(self) -> bool:
        """Is it playing, or paused with its group?"""
        return not self._ended_by and (self._loop or self._now() < self._length)

    @property
    def name(self) -> str:
        """The file's name, as it was given to `play`."""
        return self._name

    @property
    def group(self) -> str:
        """The group's name, to be used as audio.groups[sound.group]."""
        return self._group.name

    @property
    def length(self) -> float:
        """Seconds that it lasts, once through at pitch 1."""
        return self._length

    @property
    def looping(self) -> bool:
        """Does it start again at its end?"""
        return self._loop

    @property
    def volume(self) -> float:
        """1 is as recorded, 0 silent, at most 8. A change is heard within a step, without a click."""
        self._require_alive()
        return self._volume

    @volume.setter
    def volume(self, value: float) -> None:
        self._require_alive()
        self._volume = number(value, "Sound", "volume", least=0.0, most=LOUDEST)
        self._aim(self._audio.listener)

    @property
    def pan(self) -> float:
        """-1 is left, 1 right; added to where its place is heard from."""
        self._require_alive()
        return self._pan

    @pan.setter
    def pan(self, value: float) -> None:
        self._require_alive()
        self._pan = number(value, "Sound", "pan", least=-1.0, most=1.0)
        self._aim(self._audio.listener)

    @property
    def pitch(self) -> float:
        """How fast it plays: 2 is an octave up and half as long. From 1/16 to 4, and to 2 for sounds of 192 kHz."""
        self._require_alive()
        return self._pitch

    @pitch.setter
    def pitch(self, value: float) -> None:
        self._require_alive()
        pitch = number(value, "Sound", "pitch", least=LOWEST_PITCH, most=self._highest_pitch())
        self._start, self._began = self._now(), self._group._seconds(self._audio._step())
        self._pitch = pitch
        self._send_speed()

    @property
    def at(self) -> Vec2 | None:
        """Where in the world it is, or None when it is everywhere."""
        self._require_alive()
        return self._place()

    @at.setter
    def at(self, value: Point | Placed | None) -> None:
        self._require_alive()
        self._at = None if value is None else _place(value)
        self._aim(self._audio.listener)

    @property
    def position(self) -> float:
        """How far it has played, in seconds of the recording. Setting it jumps there, without a click."""
        self._require_alive()
        now = self._now()
        return now % self._length if self._loop else now

    @position.setter
    def position(self, seconds: float) -> None:
        self._require_alive()
        seconds = number(seconds, "Sound", "position", least=0.0, most=self._length)
        self._audio._jump(self, seconds)
        self._start, self._began = seconds, self._group._seconds(self._audio._step())

    @known_keywords
    def stop(self, *, fade: float = 0.0) -> None:
        """End it; with `fade`, it dies away in so many seconds, and the handle is stale from now on all the same."""
        self._require_alive()
        frames = max(CLICK, round(number(fade, "Sound.stop", "fade", least=0.0, most=LONGEST_FADE) * RATE))
        self._end("was stopped", frames)

    # For Audio --------------------------------------------------------------------------------------------------------

    def _end(self, why: str, frames: int, *, squared: bool = True) -> None:
        self._ended_by = why
        mixer = self._audio._mixer
        if mixer is not None and self._voice:
            mixer.stop(self._voice, frames, squared, self._audio._when())

    def _now(self) -> float:
        return self._start + (self._group._seconds(self._audio._step()) - self._began) * self._pitch

    def _speed(self) -> float:
        """Source frames a frame of the mix."""
        tempo = self._audio._tempo if self._group.pauses else 1.0
        return min(self._rate * self._pitch * tempo / RATE, 8.0)

    def _send_speed(self) -> None:
        mixer = self._audio._mixer
        if mixer is not None and self._voice:
            mixer.speed(self._voice, self._speed(), RAMP, self._audio._when())

    def _highest_pitch(self) -> float:
        return min(HIGHEST_PITCH, 8.0 * RATE / self._rate)

    def _place(self) -> Vec2 | None:
        if self._at is None or isinstance(self._at, Vec2):
            return self._at
        if self._at.alive:
            return self._at.position
        return None

    def _gains(self, listener: Listener) -> Gains:
        place = self._place()
        if place is None and self._at is not None:
            return self._sent  # what it went along with is gone: it is heard from where that was last
        loudness, pan = (1.0, 0.0) if place is None else from_place(place, listener)
        return gains(self._volume * loudness, self._pan + pan, self._channels)

    def _aim(self, listener: Listener) -> None:
        """Tell the mixer how loud it is, if that has changed."""
        mixer, wanted = self._audio._mixer, self._gains(listener)
        if mixer is not None and self._voice and wanted != self._sent:
            mixer.gains(self._voice, wanted, RAMP, self._audio._when())
        self._sent = wanted

    def _require_alive(self) -> None:
        if not self.alive:
            how = self._ended_by or f"has come to its end after {self._length / self._pitch:.2f} s"
            raise StaleReferenceError(f"this Sound ({self._name!r}) {how}; ask sound.alive first")


def _place(value: object) -> Vec2 | Placed:
    if hasattr(value, "position") and hasattr(value, "alive"):
        place: Placed = value
        if not math.isfinite(place.position.x):  # raises for a body that is gone
            raise AssertionError("a body's position is finite")
        return place
    return to_vec2(value, "Sound", "at")
