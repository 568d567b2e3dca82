"""Capsules, segments, chains and rounded corners in levels; numbers that are drawn by chance are drawn once."""

from __future__ import annotations

import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.game import Game
from evilengine.level import Level

PLATE = "new polygon it 0 0, 4 0, 4 3, 0 3 "


def play(text: str, steps: int = 0) -> Level:
    game = Game("level", headless=True)
    built = level.build(script.read(text), game)
    game.step(steps)
    return built


def shape_of(text: str) -> evil.world.body.Shape:
    (shape,) = play(text)["it"].shapes
    return shape


def refusal(text: str) -> str:
    """The first error of a level, without where it is."""
    first = str(script.check(text)[1][0]).splitlines()
    return first[0].split("error")[1] + " | " + first[-1].strip()


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("new capsule it 2 0.6;", evil.Capsule((-0.7, 0), (0.7, 0), 0.3)),
        ("new capsule it 60cm 2 at 1 1;", evil.Capsule((0, -0.7), (0, 0.7), 0.3)),
        ("new segment it -1 0, 3 1;", evil.Segment((-1, 0), (3, 1))),
        ("new chain it -4 0, 0 1, 4 0, 5 3;", evil.Chain([(-4, 0), (0, 1), (4, 0), (5, 3)])),
        ("new chain it -4 0, 0 -1, 4 0 closed;", evil.Chain([(-4, 0), (0, -1), (4, 0)], loop=True)),
        ("new rectangle it 2 1 rounding 0.2;", evil.Rectangle(2, 1, rounding=0.2)),
        ("new triangle it 0 0, 2 0, 0 2 at 1 1 rounding 0.1;", evil.Triangle((0, 0), (2, 0), (0, 2), rounding=0.1)),
        ("new polygon it 0 0, 2 0, 2 2, 0 2 at 0 0 rounding 10cm;",
         evil.Polygon([(0, 0), (2, 0), (2, 2), (0, 2)], rounding=0.1)),
        ("new polygon it 0 0, 4 0, 4 3, 0 3 hole 1 1, 2 1, 1 2 at 0 0 hole 3 1, 3.5 1, 3 2 rounding 0.1;",
         evil.Polygon([(0, 0), (4, 0), (4, 3), (0, 3)], holes=[[(1, 1), (2, 1), (1, 2)], [(3, 1), (3.5, 1), (3, 2)]],
                      rounding=0.1)),
    ],
)  # fmt: skip
def test_a_level_says_every_shape_that_the_engine_has(text: str, shape: evil.Circle) -> None:
    assert shape_of(text).definition == shape


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        ("new capsule it 1 1;", "[bad-shape]: a capsule cannot be as wide as it is high | write: circle 0.5"),
        ("new capsule it 2;", "[wrong-count]: a capsule takes 2 numbers, its width and height, or 4 with its place "
         "(width, height, x, y); here is 1 | as in: new capsule pill 2 0.6 at 0 4 physicsOn;"),
        ("new segment it 0 0;",
         "[wrong-count]: a segment has 2 points; here is 1 | as in: new segment ramp -6 -2, 2 -4;"),
        ("new segment it 1 1, 1 1;", "[bad-shape]: this segment cannot be: points 1 and 2 are in one place "
         "| leave one of them out"),
        ("new chain it 0 0, 1 0, 1 0, 2 0;", "[bad-shape]: this chain cannot be: points 2 and 3 are in one place "
         "| leave one of them out"),
        ("new chain it 0 0, 1 0 closed;", "[bad-shape]: a closed chain has three points or more | leave closed out"),
        (PLATE + "hole 1 1, 9 1, 9 2 at 0 0;", "[bad-shape]: this polygon cannot be: edges 2-3 and 1-2 of hole 1 "
         "cross or touch | give the corners in order round the outline, and holes within it and apart from each other"),
        (PLATE + "hole 1 1, 2 1, 1 2 hole 1.2 1.1, 1.3 1.1, 1.2 1.2 at 0 0;", "[bad-shape]: this polygon cannot be: "
         "hole 2 lies within hole 1 | what is solid there is a polygon of its own"),
        (PLATE + "hole 1 1, 2 1 at 0 0;", "[bad-shape]: this polygon cannot be: 2 corners of hole 1 are too few "
         "| a hole needs 3 or more"),
        (PLATE + "hole at 0 0;", "[missing-number]: hole needs its corners "
         "| as in: hole 0.5 0.5, 3.5 0.5, 3.5 2.5, 0.5 2.5"),
        (PLATE + "hole 1 1 2 1, 1 2 at 0 0;", "[missing-comma]: a comma is missing between two corners "
         "| as in: 0 0, 1 0"),
        (PLATE + "window 1 1, 2 1, 1 2 at 0 0;", "[unknown-property]: there is no property 'window' "
         "| did you mean 'hole'?"),
        ("new rectangle it 1 1 hole 1 1, 2 1, 1 2;", "[wrong-property]: a rectangle has no hole | it is for polygon"),
        ("new circle it 1 rounding 0.1;", "[wrong-property]: a circle has no rounding | it is for rectangle, triangle, "
         "polygon"),
        ("draw circle 1 rounding 0.1;", "[wrong-property]: a circle has no rounding | it is for rectangle, triangle, "
         "polygon"),
        ("new rectangle it 1 1 thickness 2;", "[wrong-property]: a rectangle has no thickness | it is for walls"),
        ("new rectangle it 2 1 rounding 0.6;", "[out-of-range]: the rounding of a rectangle of this size cannot be 0.6 "
         "| at most 0.5, half of its shorter side"),
        ("new triangle it 0 0, 1 0, 0 1 at 0 0 rounding 1;", "[out-of-range]: rounding is too large for these corners "
         "| at most about 0.2927 fits"),
        ("new rectangle it 2 1 rounding -1;", "[out-of-range]: rounding cannot be -1 | rounding is from 0 to 1000000"),
        ("new capsul it 2 1;", "[unknown-kind]: there is no kind of thing called 'capsul' | did you mean 'capsule'?"),
        ("new pill it 2 1;", "[unknown-kind]: there is no kind of thing called 'pill' | did you mean 'capsule'?"),
        ("new terrain it 0 0, 1 0;",
         "[unknown-kind]: there is no kind of thing called 'terrain' | did you mean 'chain'?"),
        ("new line it 0 0, 1 0;", "[unknown-kind]: there is no kind of thing called 'line' | did you mean 'segment'?"),
        ("new rectangle it 2 1 roundin 0.1;", "[unknown-property]: there is no property 'roundin' "
         "| did you mean 'rounding'?"),
        ("new chain it 0 0, 1 0, 1 1 loop;",
         "[unknown-property]: there is no property 'loop' | did you mean 'closed'?"),
    ],
)  # fmt: skip
def test_what_is_no_shape_is_refused_in_the_words_of_the_level(text: str, refused: str) -> None:
    assert refusal(text) == refused


def test_a_shape_that_only_turns_out_wrong_at_play_says_so_too() -> None:
    with pytest.raises(evil.LevelError, match=r"level.evil:1:.*error\[refused\]: Capsule: points 0 and 1 are nearer"):
        play("let side 1; new capsule it (side) (side);")
    with pytest.raises(evil.LevelError, match=r"rounding=0.5 must be a finite number, at least 0 and at most 0.25"):
        play("let side 0.5; new rectangle it 2 (side) rounding 0.5;")


def test_what_is_drawn_has_the_new_shapes_too() -> None:
    built = play("draw capsule a 1 0.3 at 0 0; draw chain b 0 0, 1 1, 2 0 colour red; draw segment c 0 0, 1 1; "
                 "draw rectangle d 1 1 rounding 0.3 layer 2;")  # fmt: skip
    assert built.game is not None
    assert len(built.game.scene) == 4
    assert built["d"].layer == 2


def test_things_slide_along_a_chain_and_lie_on_a_segment() -> None:
    built = play("new chain slope -8 4, -4 0, 8 -0.5 friction 0; new segment shelf -1 -4, 1 -4 at 3 0; "
                 "new circle ball 0.3 at -6 3 physicsOn friction 0; new capsule pill 1 0.4 at 3 -3 physicsOn;",
                 120)  # fmt: skip
    assert built["ball"].position.x > 0
    assert built["pill"].position.y == pytest.approx(-3.8, abs=0.02)


def test_a_thing_falls_into_the_hole_of_another() -> None:
    text = "new polygon box -2 -2, 2 -2, 2 2, -2 2 hole -1 -1, 1 -1, 1 1, -1 1 at 0 0; new circle ball 0.3 physicsOn;"
    built = play(text + "draw polygon 0 0, 1 0, 1 1, 0 1 hole 0.2 0.2, 0.8 0.2, 0.5 0.8 at 3 3;", 90)
    assert built["ball"].position.y == pytest.approx(-0.7, abs=0.02)


def test_a_number_by_chance_is_the_same_wherever_a_thing_needs_it() -> None:
    built = play("new walls room random(4, 9) random(3, 6) thickness random(0.2, 1); "
                 "repeat 20 { new capsule random(1, 3) random(0.2, 0.9) at 0 0; } "
                 "new medium random(1, 5) random(1, 5) at random(-5, 5) random(-5, 5) drag 1;")  # fmt: skip
    below, above, left, right = (shape.definition.corners for shape in built["room"].shapes)
    assert {x for x, _ in below} == {x for x, _ in above}, "as wide below as above"
    thickness = max(y for _, y in above) - min(y for _, y in above)
    assert max(x for x, _ in left) == pytest.approx(min(x for x, _ in below) + thickness)
    assert min(x for x, _ in right) == -max(x for x, _ in left)
    pills = [body.shapes[0].definition for body in list(built.world.bodies)[1:]]
    assert all(pill.a == -pill.b for pill in pills), "their place is their middle"
    assert all(min(abs(pill.b.x), abs(pill.b.y)) == 0 for pill in pills), "they lie or stand"
    assert len({pill.b for pill in pills}) == 20


def test_rounding_may_be_reckoned_and_shapes_cannot_be_changed_later() -> None:
    assert shape_of("let r 0.1; new rectangle it 2 1 rounding (r * 2);").definition.rounding == pytest.approx(0.2)
    assert refusal("new rectangle it 2 1; after 1 { set it rounding 0.1; }").startswith("[wrong-property]")
