"""Tilt: which way gravity pulls on the screen, by an accelerometer or by what stands in for one (SPEC I4).

A recording of a game must play the same on every machine, so a step here uses time given in steps, and only sums,
products and square roots, which every machine computes alike.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from evilengine.values.checks import number
from evilengine.values.events import Reading
from evilengine.values.inputs import DOWN, NOWHERE, Tilt
from evilengine.values.vec2 import Vec2, to_vec2

FLAT = 0.05
"""g along the screen under which the device counts as lying flat; below, a sensor's noise would spin gravity about."""
TURN_RATE = 2.4
"""Radians a second that a held key turns the device: a quarter turn takes two thirds of a second."""
TURN_EASE = 0.12
"""Seconds until a held key turns at its full rate, and until a released one has come to rest."""
NOTCH = math.pi / 12
"""Radians that a notch of the mouse wheel turns the device."""
NOTCH_EASE = 0.08
"""Seconds over which most of a notch is carried out, so that gravity swings instead of jumping."""
STICK_RATE = 9.0
"""Radians a second at which gravity swings to where a pad's stick points."""
STICK_AT_REST = 0.35
"""A stick nearer to its middle than this points nowhere: worn sticks rest 0.2 off, and angles are coarse there."""

JOLT = 1.8
"""g above which a reading is a jolt; turning a device by hand stays near 1, walking under 1.6."""
CALM = 1.3
"""g under which a jolt is over."""
JOLTS = 3
"""Jolts within SHAKE_TIME that make a shake: there, back, there. One or two come from a knock on the table."""
SHAKE_TIME = 0.8
"""Seconds in which they must come."""
SHAKE_REST = 0.5
"""Seconds after a shake in which no other is noticed, so that one long shake is one event, or a few."""


@dataclass(frozen=True, slots=True)
class StandIns:
    """What turns the tilt on a machine without an accelerometer, in one step."""

    turn: float = 0.0
    """-1..1 from keys: positive turns the right edge down, as a driver steers to the right."""
    notches: float = 0.0
    """Turn of the mouse wheel; away from the player turns the right edge down."""
    stick: Vec2 = NOWHERE
    """A pad's stick; gravity swings to where it points."""


class Tilting:
    """The tilt as it goes from step to step. Whichever was used last decides: the sensor or a stand-in."""

    def __init__(self) -> None:
        self._direction = DOWN
        self._reading: Reading | None = None
        self._turning = 0.0  # radians a second, by keys
        self._owed = 0.0  # radians that the wheel asked for and that are not carried out yet
        self._shake = _Shake()

    def step(self, dt: float, readings: Sequence[Reading], stand_ins: StandIns) -> Tilt:
        """The tilt after a step of `dt` seconds in which these readings came in."""
        before = self._direction, self._reading
        shaken = self._shake.step(dt, readings)
        self._turn(dt, stand_ins)
        for reading in readings:
            self._read(reading)
        changed = (self._direction, self._reading) != before
        return Tilt(self._direction, self._reading, changed, shaken)

    def state(self) -> dict[str, Any]:
        """What a saved game keeps."""
        return {
            "direction": list(self._direction), "reading": self._reading, "turning": self._turning, "owed": self._owed,
            "jolt": self._shake.last, "ages": self._shake.ages, "rest": self._shake.rest,
        }  # fmt: skip

    @classmethod
    def of(cls, state: dict[str, Any]) -> Tilting:
        """The tilt that `state` was taken of. Raises ValueError, TypeError or KeyError for what is none."""
        tilting = cls()
        tilting._direction = to_vec2(state["direction"], "tilt", "direction")
        if not 0.999 < tilting._direction.length < 1.001:
            raise ValueError("a direction whose length is not 1")
        tilting._reading = _reading(state["reading"])
        tilting._turning, tilting._owed = (number(state[part], "tilt", part) for part in ("turning", "owed"))
        tilting._shake.last = _reading(state["jolt"])
        tilting._shake.ages = [number(age, "tilt", "ages") for age in state["ages"]]
        tilting._shake.rest = number(state["rest"], "tilt", "rest")
        return tilting

    def _read(self, reading: Reading) -> None:
        self._reading = reading
        x, y, _ = reading
        along_screen = math.sqrt(x * x + y * y)
        if along_screen >= FLAT:
            self._direction = Vec2(x / along_screen, y / along_screen)
            self._turning = self._owed = 0.0

    def _turn(self, dt: float, stand_ins: StandIns) -> None:
        wanted = stand_ins.turn * TURN_RATE
        change = TURN_RATE / TURN_EASE * dt
        self._turning = min(max(wanted, self._turning - change), self._turning + change)
        self._owed += stand_ins.notches * NOTCH
        part = self._owed * min(1.0, dt / NOTCH_EASE)
        if abs(self._owed) < 1.0e-4:
            part = self._owed
        self._owed -= part
        angle = self._turning * dt + part
        if angle != 0.0:
            self._direction = turned(self._direction, angle)
        if stand_ins.stick.dot(stand_ins.stick) > STICK_AT_REST * STICK_AT_REST:
            self._direction = turned_toward(self._direction, stand_ins.stick, STICK_RATE * dt)


class _Shake:
    """Finds shakes: several jolts in a short time, each followed by calm or by a jolt the other way."""

    def __init__(self) -> None:
        self.last: Reading | None = None  # of the jolt that goes on
        self.ages: list[float] = []  # seconds since each jolt began
        self.rest = 0.0

    def step(self, dt: float, readings: Sequence[Reading]) -> bool:
        self.ages = [age + dt for age in self.ages if age + dt <= SHAKE_TIME]
        self.rest = max(0.0, self.rest - dt)
        for reading in readings:
            strength = math.sqrt(_dot(reading, reading))
            if strength < CALM:
                self.last = None
            elif strength > JOLT and (self.last is None or _dot(self.last, reading) < 0.0):
                self.last = reading
                self.ages.append(0.0)
        if len(self.ages) < JOLTS or self.rest > 0.0:
            return False
        self.ages.clear()
        self.rest = SHAKE_REST
        return True


def _reading(values: Any) -> Reading | None:
    if values is None:
        return None
    x, y, z = (number(value, "tilt", "reading") for value in values)
    return x, y, z


def _dot(a: Reading, b: Reading) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def turned(direction: Vec2, angle: float) -> Vec2:
    """A direction of length 1 turned counter-clockwise by `angle`, using no trigonometry.

    With t = tan(angle/2), the cosine is (1 - t²)/(1 + t²) and the sine 2t/(1 + t²): whatever t is, that is a turn.
    t from two terms of its series makes the angle right within 0.001 up to half a radian, far more than a step's.
    """
    half = 0.5 * angle
    t = half * (1.0 + half * half / 3.0)
    c, s = (1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)
    return _normal(c * direction.x - s * direction.y, s * direction.x + c * direction.y)


def turned_toward(direction: Vec2, target: Vec2, most: float) -> Vec2:
    """A direction of length 1 turned by at most `most` radians, the short way round, to point as `target` does."""
    goal = _normal(target.x, target.y)
    sine = direction.cross(goal)
    if direction.dot(goal) > 0.0 and abs(sine) <= most:
        return goal
    return turned(direction, most if sine >= 0.0 else -most)


def _normal(x: float, y: float) -> Vec2:
    length = math.sqrt(x * x + y * y)
    return Vec2(x / length, y / length)
