"""Errors of levels read as people speak: one for each mistake, with the right article, and what would be right."""

from __future__ import annotations

import pytest

from evilengine import script

LAMP = "new light lamp at 0 3; "

MISTAKES = [
    ("new particles at 0 2 velocity 3 0;", "particles have no velocity", "did you mean 'flying'?"),
    ("new particles soot at 0 0;", "particles have no soot", "if it is a name, choose another, such as soot1"),
    ("new particles 20 at 0 2;", "particles take no number here", "as in: new particles fire at"),
    ("new particles 0 2 rate 5;", "particles take no number here", "its place comes after at"),
    ("draw particles at 0 3;", "particles cannot be drawn", "write: new particles;"),
    ('new walls 15 8 colours "red" "blue";', "walls have no corners to colour", "say: colour"),
    ("new circle glow 1 at 0 3;", "a circle takes one number", "as a name write glow1"),
    ("new smoke at 0 3;", "smoke takes 2 numbers", "as in: new smoke air"),
    ("draw circle sun 1 at 0 0 physicsOn;", "a drawing has no physicsOn", "what new makes has physicsOn"),
    ('draw text "Hi" at 1 1;', "draw does not go with text", "text stands alone: leave draw out"),
    ("shadows maybe;", "shadows is on or off", ""),
    ("shadows on off;", "'off' has no place here", ""),
    ("tilt 2;", "tilt is on or off", ""),
    ("lens bloom on;", "bloom needs a number, not 'on'", "as in: bloom 0.6"),
    ("new circle ball 1 at 0 3 lit on;", "lit stands alone, without 'on'", "leave it out"),
    (LAMP + "set lamp on;", "set needs what is on", "as in: set lamp out off;"),
    (LAMP + "set lamp off;", "set needs what is off", "as in: set lamp out on;"),
    (LAMP + "set lamp brightness 2;", "there is no property 'brightness'", "did you mean 'intensity'?"),
    (LAMP + 'set lamp texture "x.png";', "a light has no texture to change", "of a light, set changes at, towards"),
    ("new particles p rate 1; set p count 2;", "there is no property 'count'", "did you mean 'rate'?"),
    ("new particles p rate 1; set p size 2;", "particles have no size to change", "of particles, set changes at, rate"),
    ("plane -2;", "plane needs a property", "as in: plane -2 parallax 0.3;"),
    ("lens;", "lens needs a property", "as in: lens bloom 0.6;"),
    ("plane -2 fog 0.5;", "fog needs a colour", 'as in: fog "#8fa3b840"'),
    ('background "red" lit;', "lit is for pictures, and red is a colour", 'as in: background "hills.png" lit ...'),
    (LAMP + "dim lamp 0.5;", "there is no statement 'dim'", "what changes is said by set lamp ..."),
    (LAMP + "intensify lamp 2;", "there is no statement 'intensify'", "did you mean: set lamp intensity ...?"),
    ("new particles p rate 1; burst p 20;", "there is no statement 'burst'", "did you mean: set p bursting ...?"),
    ("rectangel 2 1 at 0 3;", "to make a rectangle, start with new", "did you mean 'new rectangle'?"),
    ("lantern at 0 3;", "to make a light, start with new", "did you mean 'new light'?"),
    ("camera over 2;", "over needs at, zoom or angle", "as in: at 0 2"),
    ('text "Hi" 20 20;', "the number 20 belongs to nothing", "what is it? as in: at 20 20"),
    ("new circle ball 1 colour rgb(1, 0, 0);", "a colour is not worked out, as by rgb( )", 'as in: colour "red"'),
]


@pytest.mark.parametrize(("text", "message", "suggestion"), MISTAKES)
def test_a_mistake_is_one_error_that_says_what_would_be_right(text: str, message: str, suggestion: str) -> None:
    (error,) = script.check(text)[1]
    assert message in error.message
    assert suggestion in error.suggestion


def test_a_text_breaks_its_line_where_it_says_so() -> None:
    (text,) = script.read(r'text "one\ntwo {{x}}" at 0 0;').commands
    assert getattr(text, "pieces", None) == ("one\ntwo {x}",)


@pytest.mark.parametrize(
    "text",
    [
        "new circle ball 1 at 0 3 lit\non touch ball { destroy ball; }",
        "new circle ball 1 at 0 3; on touch ball { destroy ball; }",
        'shadows on; on key "a" { shadows off; }',
    ],
)
def test_an_on_that_begins_an_event_is_still_read_as_one(text: str) -> None:
    level, errors = script.check(text)
    assert [error.code for error in errors] == (["missing-semicolon"] if "lit\n" in text else [])
    assert len(level.commands) == 2
