"""What several kinds of joints share: points on both bodies, springs."""

from __future__ import annotations

from evilengine import _core
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Vec2
from evilengine.world.joints.fields import MOST_HERTZ, Amount
from evilengine.world.joints.joint import Joint


class Anchored(Joint):
    """A joint with a point on each body: in the world until it is added, then on the bodies."""

    _at_a: Vec2 | None = None
    _at_b: Vec2 | None = None
    """None: the body's position."""

    def _place(self, spec: _core.JointSpec) -> None:
        at_a = self._a.position if self._at_a is None else self._at_a
        at_b = self._b.position if self._at_b is None else self._at_b
        spec.anchor_a, spec.anchor_b = self._a.to_local(at_a), self._b.to_local(at_b)
        spec.reference = self._b.angle - self._a.angle
        self._measure(spec, at_a, at_b)

    def _measure(self, spec: _core.JointSpec, at_a: Vec2, at_b: Vec2) -> None:
        """Fill in what follows from where the two points are."""


class _Sprung(Joint):
    frequency: Amount
    damping_ratio: Amount
    stiffness: Amount
    damping: Amount

    def _spring(self, frequency: float, damping_ratio: float, stiffness: float, damping: float) -> bool:
        """Set it up; is there one?"""
        self.frequency, self.damping_ratio, self.stiffness, self.damping = frequency, damping_ratio, stiffness, damping
        if self.frequency > 0 and (self.stiffness > 0 or self.damping > 0):
            raise ArgumentError(f"{type(self).__name__}: give frequency and damping_ratio, or stiffness and damping")
        return bool(self.frequency > 0 or self.stiffness > 0 or self.damping > 0)


class LinearSpring(_Sprung):
    """A joint with a spring along its length."""

    frequency = Amount("along_frequency", "Hertz of its spring; 0: none by frequency.", least=0.0, most=MOST_HERTZ)
    damping_ratio = Amount("along_damping_ratio", "Of a spring with a frequency: 1 just does not swing.", least=0.0)
    stiffness = Amount("along_stiffness", "N/m of its spring.", least=0.0)
    damping = Amount("along_damping", "N s/m of its spring.", least=0.0)


class TurningSpring(_Sprung):
    """A joint with a spring that turns."""

    frequency = Amount("turn_frequency", "Hertz of its spring; 0: none by frequency.", least=0.0, most=MOST_HERTZ)
    damping_ratio = Amount("turn_damping_ratio", "Of a spring with a frequency: 1 just does not swing.", least=0.0)
    stiffness = Amount("turn_stiffness", "N m/rad of its spring.", least=0.0)
    damping = Amount("turn_damping", "N m s/rad of its spring.", least=0.0)
