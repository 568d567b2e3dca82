"""What a level says becomes commands in the engine's own words; what it may be is fuzzed."""

from __future__ import annotations

import math
import random
import string

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from evilengine import script
from evilengine.script.statements import EVENTS, FUNCTIONS, STATEMENTS
from evilengine.script.word import LANGUAGE_VERSION, MAX_NESTING, MAX_ROUNDS
from evilengine.script.words import JOINING_WORDS, KINDS, PROPERTIES, PROPERTY_WORDS
from evilengine.values import level as values
from evilengine.values.level import Called, Corners, LevelScript, Make, Option, Pair

WHOLE = """
# a comment
gravity 0 -9.81;   view 16 9;   tilt on;
new walls 16 9;
new rectangle 2 1 0 4 physicsOn;
new rectangle crate 2 1 at 0 4 angle 30 physicsOn friction 0.6 restitution 0 density 1 colour "#cc9966";
new circle ball 0.5 at 1 6 physicsOn touchable;
new triangle 0 0, 1 0, 0.5 1 at 3 3 physicsOn;
new polygon rock 0 0, 1 0, 1.2 0.8, 0.3 1.1 at 2 5 physicsOn;
new spring from crate to 0 8 stiffness 20 length 2;
on collide crate ball { destroy ball; }
after 5 { destroy crate; }      every 2 { new circle 0.2 at 0 8 physicsOn; }
"""


def body(text: str) -> values.AddBody:
    """The only thing that a level makes."""
    (command,) = [each for each in script.read(text).commands if isinstance(each, values.AddBody)]
    return command


def option(text: str, name: str) -> object:
    return next(each.value for each in body(text).options if each.name == name)


def test_the_whole_first_level_is_understood() -> None:
    names = [type(command).__name__ for command in script.read(WHOLE).commands]
    added = ["AddBody"] * 6
    assert names == ["SetGravity", "SetView", "SetTilt", *added, "AddForce", "OnMeeting", "After", "Every"]


def test_the_line_of_the_thesis_means_the_same_as_readable_words() -> None:
    thesis, readable = body("new rectangle 2 1 0 4 physicsOn;"), body("new rectangle 2 1 at 0 4 physicsOn;")
    assert (thesis.shapes, set(thesis.options)) == (readable.shapes, set(readable.options))


def test_a_thing_without_physics_stands_still() -> None:
    assert option("new circle 1;", "kind") == "static"
    assert option("new circle 1 physicsOn;", "kind") == "dynamic"
    assert option("new circle 1 moving;", "kind") == "kinematic"


def test_degrees_become_radians() -> None:
    assert option("new circle 1 angle 30;", "angle") == math.radians(30)
    assert option("new circle 1 angle 30deg;", "angle") == math.radians(30)
    assert option("new circle 1 angle 2rad;", "angle") == pytest.approx(2)
    assert option("new circle 1 physicsOn spin 90;", "angular_velocity") == math.radians(90)


def test_units_become_metres_and_kilograms() -> None:
    assert body("new circle 50cm;").shapes[0].arguments == (0.5,)
    assert option("new circle 1 at 1km 20mm;", "at") == Pair(1000.0, 0.02)
    assert option("new circle 1 physicsOn mass 250g;", "mass") == 0.25
    assert option("new circle 1 physicsOn velocity 36km/h 0;", "velocity") == Pair(10.0, 0.0)


def test_corners_of_a_polygon_stay_as_they_are_written() -> None:
    points = tuple(Pair(x, y) for x, y in [(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)])
    assert body("new triangle 0 0, 1 0, 0.5 1 at 3 3;").shapes == (Make("Triangle", points),)


def edges(shape: Make) -> tuple[float, float, float, float]:
    """Left, bottom, right, top of a polygon."""
    (corners,) = shape.arguments
    assert isinstance(corners, Corners)
    xs, ys = [point.x for point in corners.points], [point.y for point in corners.points]
    return min(xs), min(ys), max(xs), max(ys)


def test_walls_stand_round_the_room() -> None:
    below, above, left, right = map(edges, body("new walls 16 9 thickness 2;").shapes)
    assert (below, above) == ((-10, -6.5, 10, -4.5), (-10, 4.5, 10, 6.5))
    assert (left, right) == ((-10, -4.5, -8, 4.5), (8, -4.5, 10, 4.5))


def test_two_numbers_with_a_minus_stay_two_and_arithmetic_is_one() -> None:
    assert option("new circle 1 at 3 -2;", "at") == Pair(3.0, -2.0)
    assert option("new circle 1 at (3 - 2) -2;", "at") == Pair(1.0, -2.0)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("(1 + 2 * 3)", 7.0),
        ("((1 + 2) * 3)", 9.0),
        ("(7 - 2 - 1)", 4.0),
        ("(-2 - -3)", 1.0),
        ("(7 % 4)", 3.0),
        ("(1 / 4)", 0.25),
        ("(2 > 1 and not 3 <= 2)", 1.0),
        ("(1 == 2 or 1 != 1)", 0.0),
        ("sin(30)", 0.5),
        ("cos(180)", -1.0),
        ("sqrt(16)", 4.0),
        ("max(1, min(5, 3))", 3.0),
        ("(abs(-2) + floor(1.9) + round(0.5))", 4.0),
        ("(2m / 50cm)", 4.0),
    ],
)
def test_arithmetic_gives_what_it_gives_on_paper(text: str, value: float) -> None:
    assert option(f"new circle 1 at {text} 0;", "at") == Pair(value, 0.0)


def test_an_option_keeps_the_order_in_which_it_is_written() -> None:
    names = [each.name for each in body("new circle 1 at 0 0 physicsOn friction 1 density 2;").options]
    assert names == ["kind", "at", "friction", "density"]


def test_a_name_in_a_block_is_known_only_there() -> None:
    text = "repeat 2 { new circle coin 1; } repeat 2 { new circle coin 1; }"
    assert script.check(text)[1] == ()
    assert [error.code for error in script.check(text + "destroy coin;")[1]] == ["unknown-name"]


def test_an_event_knows_what_met() -> None:
    (event,) = script.read('on collide "ball" "coin" { destroy other; }').commands
    assert isinstance(event, values.OnMeeting)
    assert event.block[0] == values.Destroy(event.block[0].place, Called("other"))


def test_else_if_chains() -> None:
    text = "let a 1; if (a > 2) { set a 1; } else if (a > 1) { set a 2; } else { set a 3; }"
    (_, choice) = script.read(text).commands
    assert isinstance(choice, values.If)
    assert isinstance(choice.otherwise[0], values.If)
    assert len(choice.otherwise[0].otherwise) == 1


def test_a_range_that_arithmetic_can_leave_is_found_beforehand() -> None:
    assert [error.code for error in script.check("repeat 3 as i { new circle (2 - i); }")[1]] == ["out-of-range"]
    assert [error.code for error in script.check("new circle random(-1, 1);")[1]] == ["out-of-range"]


def test_no_false_alarm_where_a_condition_or_another_use_keeps_the_range() -> None:
    assert script.check("repeat 3 as i { if (i < 2) { new circle (2 - i); } }")[1] == ()
    assert script.check("repeat 3 as i { new circle (i - i + 1); }")[1] == ()


def test_statement_words_and_property_words_never_coincide() -> None:
    assert not set(STATEMENTS) & PROPERTY_WORDS
    assert not set(STATEMENTS) & JOINING_WORDS
    assert not PROPERTY_WORDS & JOINING_WORDS


PICTURED = (
    "evil",
    "texture",
    "frames",
    "fps",
    "showing",
    "plays",
    "slice",
    "font",
    "tile",
    "normalMap",
    "glowMap",
    "tall",
    "lit",
)
"""Words whose examples need a picture beside the level, or stand alone."""


@pytest.mark.parametrize("entry", [*STATEMENTS.values(), *KINDS.values(), *PROPERTIES, *FUNCTIONS.values()])
def test_every_word_has_an_example_that_works(entry: object) -> None:
    example = getattr(entry, "example", "")
    level, errors = script.check(example)
    assert errors == ()
    of_backgrounds = getattr(entry, "families", ()) == ("background",)
    assert level.commands or of_backgrounds or getattr(entry, "word", "") in PICTURED


def test_the_language_version_is_known() -> None:
    assert script.check(f"evil {LANGUAGE_VERSION};")[1] == ()


def nested(depth: int) -> str:
    return "after 1 { " * depth + "new circle 1; " + "} " * depth


def test_blocks_nest_up_to_the_cap() -> None:
    assert script.check(nested(MAX_NESTING))[1] == ()
    assert [error.code for error in script.check(nested(MAX_NESTING + 1))[1]] == ["too-deep"]
    assert [error.code for error in script.check(nested(5000))[1]] == ["too-deep"]


@pytest.mark.parametrize(
    "text",
    [
        "new circle " + "(" * 10000 + "1" + ")" * 10000 + ";",
        "new circle (" + "-" * 10000 + "1);",
        "new circle (" + "not " * 10000 + "1);",
        "new circle (" + "1 + " * 10000 + "1);",
        "new circle " + "1 + " * 10000 + "1;",
        "if (1) { } " + "else if (1) { } " * 5000,
        "{" * 10000,
        "}" * 10000,
        "on " * 10000,
        "new " * 10000,
        "new circle 1 at " * 5000,
        "new polygon " + "1 1, " * 10000 + "at 0 0;",
        f"repeat {MAX_ROUNDS} " * 3 + "{ new circle 1; }",
    ],
)
def test_no_depth_or_length_is_too_much(text: str) -> None:
    assert script.check(text)[1] != ()


WORDS = [
    *STATEMENTS, *KINDS, *sorted(PROPERTY_WORDS), *sorted(JOINING_WORDS), *FUNCTIONS, *EVENTS, "this", "other", "on",
    "off", "ball", "crate", "i", "{", "}", "(", ")", ";", ",", "-", "+", "*", "/",
    "%", "<", "==", "0", "1", "2.5", "-3", "30deg", "2s", "1e9",
    '"red"', '"space"', '"{i}"', '"', "#", "\n", "§", "circel", "1.5m/s",
]  # fmt: skip


def is_sound(text: str) -> None:
    """Commands or errors, each error somewhere in the text; nothing else, whatever the text."""
    level, errors = script.check(text)
    assert isinstance(level, LevelScript)
    lines = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    for error in errors:
        assert 1 <= error.line <= len(lines)
        assert 1 <= error.column <= len(lines[error.line - 1]) + 1
        assert error.length >= 1
        assert error.message
        assert str(error)


@given(st.text(max_size=300))
@settings(max_examples=150, deadline=None)
def test_any_text_is_a_level_or_has_errors(text: str) -> None:
    is_sound(text)


@given(st.lists(st.sampled_from(WORDS), max_size=60))
@settings(max_examples=300, deadline=None)
def test_any_words_are_a_level_or_have_errors(words: list[str]) -> None:
    is_sound(" ".join(words))


@given(st.randoms(use_true_random=False))
@settings(max_examples=200, deadline=None)
def test_a_level_with_some_signs_changed_is_a_level_or_has_errors(chance: random.Random) -> None:
    letters = list(WHOLE)
    for _ in range(chance.randint(1, 8)):
        at = chance.randrange(len(letters))
        match chance.randrange(3):
            case 0:
                letters[at] = chance.choice(string.printable)
            case 1:
                del letters[at]
            case _:
                letters.insert(at, chance.choice(WORDS))
    is_sound("".join(letters))


@given(st.integers(0, len(WHOLE)))
@settings(max_examples=100, deadline=None)
def test_a_level_that_is_cut_off_is_a_level_or_has_errors(length: int) -> None:
    is_sound(WHOLE[:length])


def test_every_line_left_out_gives_errors_only_where_it_was_needed() -> None:
    lines = WHOLE.strip().split("\n")
    assert [error.code for error in script.check("\n".join(lines[:5] + lines[6:]))[1]] == ["unknown-name"]


def test_options_are_values_that_can_be_compared() -> None:
    assert Option("at", Pair(1.0, 2.0)) == Option("at", Pair(1.0, 2.0))
    assert hash(script.read(WHOLE).commands) == hash(script.read(WHOLE).commands)
