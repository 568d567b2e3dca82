"""Elementary functions, Mat4 and batches of transformed points."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from evilengine import _core

INF, NAN = math.inf, math.nan


def units_in_last_place(got: float, exact: float) -> float:
    """How far `got` is from `exact`, in steps of a 32-bit float of that size (at least the smallest normal one)."""
    return abs(got - exact) / float(np.spacing(np.float32(max(abs(exact), 2.0**-126))))


def angles(limit: float) -> list[float]:
    """Random angles, every multiple of a quarter turn that fits, and their neighbours."""
    chance = random.Random(1)
    quarters = [k * math.pi / 2 for k in range(-2000, 2000)]
    far = [round(chance.uniform(-limit, limit) / (math.pi / 2)) * math.pi / 2 for _ in range(2000)]
    spread = [chance.uniform(-limit, limit) for _ in range(10000)]
    small = [chance.choice((-1, 1)) * 10 ** chance.uniform(-40, 1) for _ in range(4000)]
    return [a for a in (*quarters, *far, *spread, *small, *(math.nextafter(q, 9) for q in quarters)) if abs(a) <= limit]


def test_sine_and_cosine_are_correct_to_half_a_unit_up_to_a_million_and_a_half_radians() -> None:
    worst = 0.0
    for angle in angles(1.6e6):
        sine, cosine = _core.sincos(angle)
        worst = max(worst, units_in_last_place(sine, math.sin(angle)), units_in_last_place(cosine, math.cos(angle)))
    assert worst <= 0.501


def test_sine_and_cosine_of_huge_angles_are_near_and_on_the_unit_circle() -> None:
    chance = random.Random(2)
    for _ in range(5000):
        angle = chance.uniform(-1e9, 1e9)
        sine, cosine = _core.sincos(angle)
        assert abs(sine - math.sin(angle)) < 1e-7
        assert abs(cosine - math.cos(angle)) < 1e-7
    for angle in (1e15, -1e30, 1.7e308, 5e-324):
        assert math.hypot(*_core.sincos(angle)) == pytest.approx(1.0, abs=2e-7)


def test_sine_and_cosine_are_exact_where_they_should_be() -> None:
    assert _core.sincos(0.0) == (0.0, 1.0)
    sine, cosine = _core.sincos(math.pi / 2)
    assert sine == 1.0
    assert abs(cosine) < 1e-16
    assert [_core.sincos(x) for x in (INF, -INF, NAN)] == [(0.0, 1.0)] * 3


@given(st.floats(-1e9, 1e9))
def test_sine_is_odd_and_cosine_even(angle: float) -> None:
    sine, cosine = _core.sincos(angle)
    assert _core.sincos(-angle) == (-sine, cosine)


def test_directions_are_correct_to_half_a_unit() -> None:
    chance = random.Random(3)
    worst = 0.0
    for _ in range(20000):
        x, y = (float(np.float32(chance.choice((-1, 1)) * 10 ** chance.uniform(-6, 6))) for _ in range(2))
        worst = max(worst, units_in_last_place(_core.atan2(y, x), math.atan2(y, x)))
    assert worst <= 0.501


def test_directions_along_the_axes_and_without_length() -> None:
    float_pi = float(np.float32(math.pi))
    assert [_core.atan2(y, x) for y, x in ((0, 1), (1, 0), (0, -1), (-1, 0))] == [
        0.0,
        float_pi / 2,
        float_pi,
        -float_pi / 2,
    ]
    assert _core.atan2(0.0, 0.0) == 0.0
    assert _core.atan2(-0.0, -0.0) == 0.0
    assert _core.atan2(-0.0, -1.0) == float_pi  # no jump by a turn for a zero that lost its sign
    assert _core.atan2(INF, INF) == float_pi / 4
    assert _core.atan2(NAN, 1.0) == 0.0
    assert _core.atan2(1.0, NAN) == 0.0


def test_exponentials_and_logarithms_are_correct_in_double() -> None:
    chance = random.Random(4)
    for _ in range(10000):
        x = chance.uniform(-708, 709)
        assert _core.exponential(x) == pytest.approx(math.exp(x), rel=1e-15, abs=0)
        y = 10 ** chance.uniform(-300, 300)
        assert _core.logarithm(y) == pytest.approx(math.log(y), rel=4e-16, abs=0)
        z = chance.uniform(0.5, 2.0)
        assert _core.logarithm(z) == pytest.approx(math.log(z), rel=4e-16, abs=0)


def test_exponentials_and_logarithms_at_the_ends_of_their_range() -> None:
    assert [_core.exponential(x) for x in (0.0, -INF, INF, 710.0, -746.0)] == [1.0, 0.0, INF, INF, 0.0]
    assert _core.exponential(-744.0) == pytest.approx(math.exp(-744.0), abs=5e-324)
    assert [_core.logarithm(x) for x in (1.0, 0.0, INF)] == [0.0, -INF, INF]
    assert _core.logarithm(5e-324) == pytest.approx(math.log(5e-324))
    assert math.isnan(_core.exponential(NAN))
    assert math.isnan(_core.logarithm(-1.0))


def test_powers_are_correct_in_double() -> None:
    chance = random.Random(5)
    for _ in range(10000):
        base, exponent = 10 ** chance.uniform(-10, 10), chance.uniform(-30, 30)
        assert _core.power(base, exponent) == pytest.approx(base**exponent, rel=3e-13, abs=0)
    assert _core.power(0.5, 1 / 60) ** 60 == pytest.approx(0.5, rel=1e-13)  # damping over a second of steps


def test_powers_at_the_ends_of_their_range() -> None:
    assert _core.power(0.0, 0.0) == 1.0
    assert _core.power(0.0, 2.0) == 0.0
    assert _core.power(0.0, -1.0) == INF
    assert _core.power(1.0, 1e300) == 1.0
    assert _core.power(0.3, 1.0) == 0.3
    assert math.isnan(_core.power(-1.0, 2.0))


@given(st.floats(), st.floats())
def test_no_function_leaves_its_range_for_any_number(a: float, b: float) -> None:
    assert all(-1.0 <= value <= 1.0 for value in _core.sincos(a))
    assert -3.1415929 <= _core.atan2(max(-3e38, min(3e38, a)), max(-3e38, min(3e38, b))) <= 3.1415929
    assert _core.exponential(a) >= 0.0 or math.isnan(a)
    assert _core.power(abs(a), b) >= 0.0 or math.isnan(a) or math.isnan(b)
