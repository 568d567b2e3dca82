"""Elementary functions, Mat4 and batches of transformed points."""

from __future__ import annotations

import copy
import math
import pickle
import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from evilengine import _core
from evilengine.math import Mat4, multiply, transform
from evilengine.values.errors import ArgumentError, ArgumentTypeError, Error
from evilengine.values.vec2 import Vec2

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


# Matrices


def as_numpy(matrix: Mat4) -> np.ndarray:
    """As rows and columns, in double."""
    return np.array(matrix, dtype=np.float64).reshape(4, 4).T


def random_matrix(chance: random.Random) -> Mat4:
    return Mat4([chance.uniform(-2, 2) for _ in range(16)])


numbers = st.floats(-1000, 1000, width=32)
matrices = st.lists(numbers, min_size=16, max_size=16).map(Mat4)
points = st.tuples(numbers, numbers)


@given(matrices, matrices)
def test_a_product_is_that_of_mathematics(a: Mat4, b: Mat4) -> None:
    scale = np.abs(as_numpy(a)) @ np.abs(as_numpy(b)) + 1e-30
    assert np.all(np.abs(as_numpy(a @ b) - as_numpy(a) @ as_numpy(b)) <= 4e-7 * scale)


@given(matrices, matrices, points)
def test_b_is_applied_first(a: Mat4, b: Mat4, point: tuple[float, float]) -> None:
    affine = [Mat4((*m[:2], 0, 0, *m[4:6], 0, 0, 0, 0, 1, 0, *m[12:14], 0, 1)) for m in (a, b)]
    both, first = affine[0] @ affine[1] @ point, affine[0] @ (affine[1] @ point)
    assert both == pytest.approx(first, rel=1e-4, abs=2000.0)  # of up to 4e9
    quarter, shift = Mat4.rotation(math.pi / 2), Mat4.translation(1, 0)
    assert quarter @ shift @ (0, 0) == pytest.approx((0, 1))
    assert shift @ quarter @ (0, 0) == pytest.approx((1, 0))


@given(matrices, st.tuples(numbers, numbers, numbers, numbers))
def test_a_vector_of_four_is_a_column(m: Mat4, v: tuple[float, float, float, float]) -> None:
    scale = np.abs(as_numpy(m)) @ np.abs(np.array(v)) + 1e-30
    assert np.all(np.abs(np.array(m @ v) - as_numpy(m) @ np.array(v)) <= 4e-7 * scale)


@given(matrices)
def test_transposing_twice_changes_nothing(m: Mat4) -> None:
    assert m.transposed.transposed == m
    assert np.array_equal(as_numpy(m.transposed), as_numpy(m).T)


def test_an_inverse_undoes_its_matrix() -> None:
    chance = random.Random(6)
    for _ in range(300):
        m = random_matrix(chance)
        if np.linalg.cond(as_numpy(m)) < 100:
            assert m @ m.inverse == pytest.approx(Mat4.identity(), abs=2e-4)
            assert m.inverse @ m == pytest.approx(Mat4.identity(), abs=2e-4)
    turn = Mat4.translation(3, -2) @ Mat4.rotation(1.0) @ Mat4.scale(0.5, 4)
    assert turn.inverse @ (turn @ (5, 6)) == pytest.approx((5, 6), rel=1e-6)
    assert Mat4.identity().inverse == Mat4.identity()


@pytest.mark.parametrize("flat", [Mat4.scale(1, 0), Mat4([1.0] * 16), Mat4([0.0] * 16), Mat4.scale(1e-40, 1e-40)])
def test_a_matrix_that_flattens_has_no_inverse(flat: Mat4) -> None:
    with pytest.raises(ArgumentError, match="has none"):
        _ = flat.inverse


def test_a_rotation_turns_counter_clockwise() -> None:
    assert Mat4.rotation(math.pi / 2) @ (1, 0) == pytest.approx((0, 1), abs=1e-7)
    assert Mat4.rotation(0) == Mat4.identity()
    assert Mat4.rotation(0.3)[:2] == tuple(reversed(_core.sincos(0.3)))


def test_a_matrix_is_an_unchangeable_value() -> None:
    m = Mat4.translation(1, 2)
    assert m == Mat4(list(m)) == Mat4(m.tobytes())
    assert hash(m) == hash(Mat4(m))
    assert pickle.loads(pickle.dumps(m)) == m == copy.deepcopy(m)
    assert type(pickle.loads(pickle.dumps(m))) is Mat4
    assert eval(repr(m)) == m
    assert np.frombuffer(m.tobytes(), np.float32)[12:14].tolist() == [1.0, 2.0]
    assert Mat4([0.1] * 16)[0] == float(np.float32(0.1))
    with pytest.raises(TypeError):
        m[0] = 3.0  # type: ignore[index]
    with pytest.raises(AttributeError):
        m.extra = 3.0  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("values", "error", "words"),
    [
        ([1] * 15, ArgumentError, "got 15"),
        ([1] * 17, ArgumentError, "got 17"),
        ([], ArgumentError, "got 0"),
        (b"abcd", ArgumentError, "got 1"),
        ([NAN] + [0] * 15, ArgumentError, "values=nan must be finite"),
        ([INF] * 16, ArgumentError, "must be finite"),
        ([1e39] * 16, ArgumentError, "must be finite"),
        ([10**400] * 16, ArgumentError, "must be finite"),
        (b"\xff" * 64, ArgumentError, "must be finite"),
        (["a"] * 16, ArgumentTypeError, "must be a number"),
        (None, ArgumentTypeError, "16 numbers"),
        ("0123456789abcdef", ArgumentTypeError, "16 numbers"),
        ({1: 2}, ArgumentTypeError, "16 numbers"),
    ],
)
def test_what_is_no_matrix_is_refused(values: object, error: type[Error], words: str) -> None:
    with pytest.raises(error, match=words):
        Mat4(values)  # type: ignore[arg-type]


def test_operators_that_matrices_lack_say_what_to_use() -> None:
    m = Mat4.identity()
    for wrong in (lambda: m * m, lambda: m * 2, lambda: 2 * m, lambda: m + m):
        with pytest.raises(ArgumentTypeError, match="with @"):
            wrong()
    with pytest.raises(ArgumentTypeError, match="point"):
        m @ 3  # type: ignore[operator]
    with pytest.raises(ArgumentTypeError, match="point"):
        m @ (1, 2, 3)  # type: ignore[operator]
    with pytest.raises(ArgumentError, match="finite"):
        m @ (NAN, 0)
    with pytest.raises(ArgumentError, match="finite"):
        Mat4.rotation(NAN)
    with pytest.raises(ArgumentError, match="finite"):
        Mat4.scale(1, INF)
    with pytest.raises(ArgumentTypeError, match="did you mean 'angle'"):
        Mat4.rotation(angel=3)  # type: ignore[call-arg]


def test_a_product_beyond_the_range_of_floats_is_an_error() -> None:
    with pytest.raises(ArgumentError, match="beyond the range"):
        Mat4.scale(1e30) @ Mat4.scale(1e30)


# Batches


@pytest.mark.parametrize("count", [*range(20), 1000, 5000])
def test_a_batch_of_points_gives_what_one_by_one_gives(count: int) -> None:
    chance = random.Random(count)
    m = random_matrix(chance)
    listed = [Vec2(*(float(np.float32(chance.uniform(-9, 9))) for _ in range(2))) for _ in range(count)]
    for given_as in (listed, np.array(listed, np.float32).reshape(-1, 2)):
        result = transform(m, given_as)
        assert result.shape == (count, 2)
        assert result.format == "f"
        assert [tuple(row) for row in np.asarray(result).tolist()] == [m @ p for p in listed]


@pytest.mark.parametrize("count", [0, 1, 2, 3, 8, 1001])
def test_every_instruction_set_gives_the_same_bits(count: int) -> None:
    chance = np.random.default_rng(count)
    m = random_matrix(random.Random(count))
    one_by_one = _core.instruction_sets()[0]
    many = chance.normal(size=(count, 16)).astype(np.float32)
    for width in (2, 4):
        vectors = (chance.normal(size=(count, width)) * 10.0 ** chance.integers(-6, 6, (count, width))).astype(
            np.float32
        )
        expected = _core.transform(m, vectors, one_by_one).tobytes()
        for instruction_set in _core.instruction_sets():
            assert _core.transform(m, vectors, instruction_set).tobytes() == expected
        assert transform(many, vectors).tobytes() == b"".join(
            transform(Mat4(a), v[None]).tobytes() for a, v in zip(many, vectors, strict=True)
        )
    expected = b"".join((Mat4(a) @ m).tobytes() for a in many)
    for instruction_set in _core.instruction_sets():
        assert _core.multiply(many, m, instruction_set).tobytes() == (expected if count else m.tobytes()[:0])
        assert _core.multiply(m, many, instruction_set).tobytes() == b"".join((m @ Mat4(a)).tobytes() for a in many)
        assert _core.multiply(many, many, instruction_set).tobytes() == b"".join(
            (Mat4(a) @ Mat4(a)).tobytes() for a in many
        )


def test_a_matrix_for_each_point() -> None:
    moves = multiply(np.array([Mat4.translation(i, 0) for i in range(5)], np.float32), Mat4.scale(2))
    assert transform(moves, [(1, 1)] * 5).tolist() == [[2.0 + i, 2.0] for i in range(5)]


def test_the_input_of_a_batch_stays_as_it_was_and_the_result_is_ones_own() -> None:
    there = np.ones((3, 2), np.float32)
    result = transform(Mat4.scale(2), there)
    result[0, 0] = 7.0
    assert there.tolist() == [[1, 1]] * 3
    assert result.tolist() == [[7, 2], [2, 2], [2, 2]]


@pytest.mark.parametrize(
    ("matrix", "points", "error", "words"),
    [
        (Mat4.identity(), np.zeros((3, 3), np.float32), ArgumentError, r"\(n, 2\) or \(n, 4\); its shape is \(3, 3\)"),
        (Mat4.identity(), np.zeros(4, np.float32), ArgumentError, r"its shape is \(4\)"),
        (Mat4.identity(), np.zeros((3, 2)), ArgumentTypeError, r"its format is 'd'; NumPy's astype"),
        (Mat4.identity(), np.zeros((3, 2), np.int32), ArgumentTypeError, "its format is 'i'"),
        (Mat4.identity(), np.zeros((3, 4), np.float32)[:, :2], ArgumentTypeError, "row after row"),
        (Mat4.identity(), np.array([(0, 0), (0, NAN)], np.float32), ArgumentError, "points must be finite; .* row 1"),
        (Mat4.identity(), [(0, 0), (INF, 0)], ArgumentError, "points must be finite; .* row 1"),
        (Mat4.identity(), [(0, 0), (1,)], ArgumentTypeError, r"points\[1\] must be a point"),
        (Mat4.identity(), 3, ArgumentTypeError, "points must be a sequence of points"),
        (Mat4.identity(), None, ArgumentTypeError, "points must be a sequence of points"),
        (Mat4.identity(), b"12345678", ArgumentTypeError, "points must be a sequence of points"),
        (None, [(0, 0)], ArgumentTypeError, "matrix must be a Mat4"),
        ([1] * 9, [(0, 0)], ArgumentError, "matrix must have 16 numbers"),
        (np.zeros((2, 9), np.float32), [(0, 0)] * 2, ArgumentError, r"shape \(n, 16\); its shape is \(2, 9\)"),
        (np.zeros((2, 16), np.float32), [(0, 0)] * 3, ArgumentError, "2 matrices for 3 points"),
        (np.full((2, 16), NAN, np.float32), [(0, 0)] * 2, ArgumentError, "matrix must be finite; .* row 0"),
    ],
)
def test_a_batch_that_does_not_fit_says_why(matrix: object, points: object, error: type[Error], words: str) -> None:
    with pytest.raises(error, match=words):
        transform(matrix, points)


def test_products_that_do_not_pair_say_why() -> None:
    with pytest.raises(ArgumentError, match="a holds 2 matrices and b 3"):
        multiply(np.zeros((2, 16), np.float32), np.zeros((3, 16), np.float32))
    with pytest.raises(ArgumentTypeError, match="b must be a Mat4"):
        multiply(Mat4.identity(), 3)
    with pytest.raises(ArgumentError, match="is not one of"):
        _core.multiply(Mat4.identity(), Mat4.identity(), "mmx")
