"""Colours: what is accepted, what they become, and what a wrong one is told."""

from __future__ import annotations

import copy
import itertools
import math
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import ImageColor

from evilengine.values import colour
from evilengine.values.colour import Colour, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError


def read(value: object) -> Colour:
    return to_colour(value, "Scene.add", "colour")


def test_the_named_colours_are_those_of_css() -> None:
    assert set(colour.NAMES) == set(ImageColor.colormap)
    for name in colour.NAMES:
        assert read(name).rgba8.to_bytes(4, "little")[:3] == bytes(ImageColor.getrgb(name))


@pytest.mark.parametrize(
    ("value", "hex_text"),
    [
        ("red", "#ff0000"),
        (" Tomato ", "#ff6347"),
        ("#fa3", "#ffaa33"),
        ("#fa38", "#ffaa3388"),
        ("#12AB9f", "#12ab9f"),
        ("#12ab9f40", "#12ab9f40"),
        ("transparent", "#00000000"),
        ((1, 0.5, 0), "#ff8000"),
        ([0, 0, 1, 0], "#0000ff00"),
        (Colour(0, 1, 0), "#00ff00"),
    ],
)
def test_names_hex_and_tuples_become_colours(value: object, hex_text: str) -> None:
    assert read(value).hex == hex_text


@given(st.integers(0, 0xFFFFFFFF))
def test_every_rgba8_survives_hex_and_back(packed: int) -> None:
    text = "#" + packed.to_bytes(4, "little").hex()
    assert read(text).rgba8 == packed
    assert Colour.of_rgba8(packed) == read(text)
    assert read(read(text).hex) == read(text)


@pytest.mark.parametrize("value", ["oragne", "#12345", "#ggg", "#", "", (2, 0, 0), (0, 0, -0.1), (math.nan, 0, 0)])
def test_a_wrong_value_is_an_argument_error_that_names_the_argument(value: object) -> None:
    with pytest.raises(ArgumentError, match=r"Scene\.add: colour="):
        read(value)


@pytest.mark.parametrize("value", [None, 7, (1, 1), (1, 1, 1, 1, 1), object(), ("a", "b", "c"), b"red", {"r": 1}])
def test_a_wrong_type_is_a_type_error_that_names_the_argument(value: object) -> None:
    with pytest.raises(ArgumentTypeError, match=r"Scene\.add: colour="):
        read(value)


def test_a_misspelt_name_gets_the_nearest_one() -> None:
    with pytest.raises(ArgumentError, match="did you mean 'orange'"):
        read("oragne")


def test_a_colour_is_a_value() -> None:
    c = Colour(0.25, 0.5, 0.75, 1)
    assert (c.r, c.g, c.b, c.a) == c == (0.25, 0.5, 0.75, 1.0)
    assert hash(c) == hash(Colour(0.25, 0.5, 0.75))
    assert pickle.loads(pickle.dumps(c)) == copy.deepcopy(c) == c
    assert type(copy.copy(c)) is Colour
    with pytest.raises(AttributeError):
        c.r = 1.0  # type: ignore[misc]


def test_parts_outside_0_to_1_are_refused_by_the_class_too() -> None:
    with pytest.raises(ArgumentError, match="r=255"):
        Colour(255, 0, 0)
    with pytest.raises(ArgumentTypeError):
        Colour("red", 0, 0)  # type: ignore[arg-type]


def test_neighbours_in_the_palette_can_be_told_apart() -> None:
    for one, other in itertools.pairwise([*colour.PALETTE, colour.PALETTE[0]]):
        assert math.dist(one, other) > 0.3
    for one in colour.PALETTE:
        assert math.dist(one, colour.BACKGROUND) > 0.7
