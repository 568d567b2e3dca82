"""Joints in levels: each word does what it says, what is wrong is said with what was meant, and all of it is saved."""

from __future__ import annotations

import math
from typing import Any

import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.game import Game
from evilengine.level import Level
from evilengine.script.translate import translate

DOOR = "new rectangle wall 1 1; new rectangle door 2 0.2 at 1 0 physicsOn; "
BALL = "new circle hook 0.1 at 0 4; new circle ball 0.4 at 2 4 physicsOn; "
LIFT = "new rectangle tower 1 1; new rectangle lift 2 0.2 at 2 0 physicsOn; "
WHEELS = "gravity 0 0; new circle large 2 at -2 0 physicsOn; new circle small 1 at 1 0 physicsOn; "
BLOCKS = "new rectangle left 1 1 at -2 0 physicsOn; new rectangle right 1 1 at 2 0 physicsOn; "


def play(text: str, steps: int = 0) -> Level:
    game = Game("level", headless=True)
    built = level.build(script.read(text), game)
    game.step(steps)
    return built


def test_a_hinge_turns_between_its_least_and_its_most() -> None:
    built = play(DOOR + "new hinge pin from wall to door at 0 0 least -40 most 30;", 180)
    assert built["pin"].angle == pytest.approx(math.radians(-40), abs=0.01)
    built = play(DOOR + "gravity 0 9; new hinge pin from wall to door at 0 0 least -40 most 0.5rad;", 180)
    assert built["pin"].angle == pytest.approx(0.5, abs=0.01)
    built = play(DOOR + "new hinge pin from wall to door at 0 0 least -40;", 180)
    assert built["pin"].limits == pytest.approx((math.radians(-40), 100_000.0))


def test_a_motor_turns_as_fast_as_it_is_told_and_no_harder() -> None:
    built = play(DOOR + "gravity 0 0; new hinge pin from wall to door at 0 0 motorSpeed 90;", 60)
    assert built["door"].angular_velocity == pytest.approx(math.radians(90), rel=0.01)
    built = play(DOOR + "new hinge pin from wall to door at 0 0 motorSpeed 90 torque 0.1;", 30)
    assert built["door"].angular_velocity < 0
    game = play(DOOR + "gravity 0 0; new hinge pin from wall to door at 0 0 motorSpeed 90; "
                "after 0.5 { set pin motorSpeed -180; set pin torque 1000; }", 90).game  # fmt: skip
    assert game is not None
    assert list(game.world.bodies)[1].angular_velocity == pytest.approx(-math.pi, rel=0.01)


def test_a_weld_holds_and_with_a_frequency_it_bends() -> None:
    stiff = play(DOOR + "new weld pin from wall to door;", 120)
    assert abs(stiff["pin"].angle) < 0.01
    soft = play(DOOR + "new weld pin from wall to door at 0 0 frequency 2;", 120)
    assert soft["pin"].angle < -0.02


def test_a_rod_keeps_its_length_and_a_rope_only_its_greatest() -> None:
    rod = play(BALL + "new rod pin from hook to ball;", 150)
    assert rod["pin"].length == pytest.approx(2, abs=0.02)
    rope = play(BALL + "new rope pin from hook to ball length 3m;")
    assert (rope["pin"].max_length, rope["pin"].length) == (3, 2)
    assert rope.game is not None
    rope.game.step(240)
    assert rope["pin"].length <= 3.05
    bouncy = play(BALL + "new rod pin from hook to ball stiffness 5 damping 0.5 length 1;", 600)
    weight = bouncy["ball"].mass * 9.81
    assert bouncy["pin"].length == pytest.approx(1 + weight / 5, rel=0.05)


def test_a_slider_drives_along_its_axis_as_far_as_it_may() -> None:
    built = play(LIFT + "new slider rail from tower to lift axis 0 1 least 0 most 3 slideSpeed 2;", 60)
    assert built["lift"].position == pytest.approx((2, 2), abs=0.05)
    assert built.game is not None
    built.game.step(120)
    assert built["lift"].position == pytest.approx((2, 3), abs=0.02)
    weak = play(LIFT + "new slider rail from tower to lift axis 0 1 slideSpeed 2 effort 0.5;", 60)
    assert weak["lift"].position.y < 0
    assert abs(weak["lift"].angle) < 0.01


def test_an_axle_drives_a_car_on_springs() -> None:
    built = play("new rectangle ground 60 1 at 0 -0.5; new rectangle car 2 0.5 at 0 0.9 physicsOn; "
                 "new circle back 0.4 at -0.8 0.4 physicsOn friction 1; new circle front 0.4 at 0.8 0.4 physicsOn; "
                 "new axle drive1 from car to back motorSpeed -400; new axle from car to front;", 120)  # fmt: skip
    assert built["car"].position.x > 1
    assert abs(built["car"].angle) < 0.3
    assert built["drive1"].motor_speed == pytest.approx(math.radians(-400))


def test_gears_turn_by_their_ratio_and_a_pulley_lifts_by_its() -> None:
    built = play(WHEELS + "new rectangle frame 1 1 at 0 6; new hinge from frame to large at -2 0; "
                 "new hinge from frame to small at 1 0; new gear from large to small ratio -2;"
                 "set large spin 90;", 30)  # fmt: skip
    assert built["small"].angular_velocity / built["large"].angular_velocity == pytest.approx(-2, rel=0.01)
    built = play(BLOCKS + "set left velocity 0 -1; new pulley from left to right over -2 4 across 2 4;", 30)
    assert built["left"].position.y + built["right"].position.y == pytest.approx(0, abs=0.05)
    assert built["left"].position.y < -0.2


def test_what_a_joint_ties_may_meet_only_if_it_says_so() -> None:
    text = "gravity 0 0; new circle a 1 physicsOn; new circle b 1 at 3 0 physicsOn velocity -4 0; new rope from a to b"
    assert not play(text + ";", 60).world.contacts.active
    met = play(text + " meeting; let n 0; on collide a b { set n (n + 1); }", 60)
    assert met._top.numbers["n"] == 1


def test_a_joint_breaks_and_what_speaks_of_it_then_does_nothing() -> None:
    built = play(DOOR + "new weld pin from wall to door breaks 0.5; after 1 { destroy pin; }", 90)
    assert "pin" not in built
    assert built["door"].position.y < -1
    strong = play(DOOR + "new weld pin from wall to door breaks 1000;", 90)
    assert strong["door"].position.y == pytest.approx(0, abs=0.02)


def test_a_joint_can_be_destroyed_and_its_ends_too() -> None:
    built = play(DOOR + "new hinge pin from wall to door at 0 0; after 0.5 { destroy pin; }", 120)
    assert built["door"].position.y < -3
    built = play(DOOR + "new hinge pin from wall to door at 0 0; after 0.1 { destroy door; set pin motorSpeed 9; "
                 "new weld from wall to door; new hinge pin2 from wall to door at 0 0; set pin2 torque 1; }",
                 30)  # fmt: skip
    assert not built.world.joints


def test_a_world_alone_has_joints_too() -> None:
    world = evil.World()
    built = level.build(script.read(DOOR + "new hinge pin from wall to door at 0 0 least -40 most 40;"), world)
    assert [type(joint) for joint in world.joints] == [evil.joints.Hinge]
    assert built["pin"].limits == pytest.approx((-math.radians(40), math.radians(40)))


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        ("new hinge;", "a hinge needs from | as in: from wall"),
        ("new hinge from wall to door;", "a hinge needs at | as in: at 0 0"),
        ("new pulley from wall to door over 1 1;", "a pulley needs across | as in: across 2 4"),
        ("new hinge from wal to door at 0 0;", "there is no thing called 'wal' | did you mean 'wall'?"),
        ("new hinge from wall to door at 0;", "at needs two numbers; here is only one | as in: at 0 0"),
        ("new hinge from wall to door at 0 0 leas 3;", "there is no property 'leas' | did you mean 'least'?"),
        ("new hinge from wall to door at 0 0 lower 3;", "there is no property 'lower' | did you mean 'least'?"),
        ("new hinge from wall to door at 0 0 motor 3;", "there is no property 'motor' | did you mean 'motorSpeed'?"),
        ("new slider from wall to door motor 3;", "there is no property 'motor' | did you mean 'slideSpeed'?"),
        ("new hinge from wall to door at 0 0 length 3;",
         "a hinge has no length | it takes from, to, at, least, most, "),
        ("new hinge from wall to door at 0 0 least 2m;", "least is in degrees, but this is in metres | its units are "
         "deg, °, rad; without one it is in degrees"),
        ("new slider from wall to door least 20deg;", "least is in metres, but this is in degrees | its units are m,"),
        ("new weld from wall to door breaks 0;", "breaks cannot be 0 | breaks is more than 0 and at most 1000000000"),
        ("new rope from wall to door length -1;", "length cannot be -1 | length is from 0 to 10000"),
        ("new hinge from wall to door at 0 0 from wall;", "from is said twice | keep one of them"),
        ("new hinge pin from wall to door at 0 0; set pin least 3;", "least cannot be changed later | of a hinge, set"),
        ("new hinge pin from wall to door at 0 0; set pin slideSpeed 3;", "a hinge has no slideSpeed to change | "),
        ("new hinge pin from wall to door at 0 0; impulse pin 0 5;", "'pin' is a hinge, and this needs a thing | "),
        ("new hinge pin from wall to door at 0 0; new weld from pin to door;",
         "'pin' is a hinge, and this needs a thing "
         "| known here: wall, door"),
        ("new pivot from wall to door at 0 0;", "there is no kind of thing called 'pivot' | did you mean 'hinge'?"),
        ("new wheel from wall to door;", "there is no kind of thing called 'wheel' | did you mean 'axle'?"),
        ("new roep from wall to door;", "there is no kind of thing called 'roep' | did you mean 'rope'?"),
        ("draw hinge from wall to door at 0 0;", "a hinge cannot be drawn | write: new hinge; draw makes"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_joint_is_said_with_what_was_meant(text: str, refused: str) -> None:
    first = str(script.check(DOOR + text)[1][0]).splitlines()
    message, _, hint = refused.partition(" | ")
    assert first[0].endswith(message)
    assert first[-1].strip().startswith(hint)


# -- as Python, and saved --

BUSY = """
new rectangle ground 60 1 at 0 -5; new rectangle post 0.4 0.4 at -6 3;
new rectangle door 2 0.2 at -5 3 physicsOn;
new hinge pin from post to door at -6 3 least -80 most 60 motorSpeed 120 torque 20;
new rectangle shelf 1.5 0.2 at -5 1 physicsOn; new weld from post to shelf at -6 1 frequency 3 breaks 200;
new circle hook 0.1 at 0 4; new circle ball 0.4 at 2 4 physicsOn; new rope cord from hook to ball length 2.5 breaks 300;
new circle bob 0.3 at 1 1 physicsOn; new rod from hook to bob stiffness 30 damping 0.5;
new rectangle lift 1.5 0.2 at 4 0 physicsOn;
new slider rail from ground to lift axis 0 1 least 0 most 3 slideSpeed 1 effort 90;
new rectangle car 2 0.5 at 8 -3.5 physicsOn; new circle tyre 0.4 at 7.2 -4 physicsOn;
new circle tyre2 0.4 at 8.8 -4 physicsOn;
new axle engine from car to tyre motorSpeed -300 torque 20;
new axle from car to tyre2 least -0.3 most 0.3 stiffness 90 damping 5;
new circle large 1 at -2 -1 physicsOn; new circle small 0.5 at -0.4 -1 physicsOn;
new hinge from ground to large at -2 -1 motorSpeed 60; new hinge from ground to small at -0.4 -1;
new gear from large to small ratio -2;
new rectangle left 0.6 0.6 at 11 0 physicsOn; new rectangle right 0.6 0.6 at 14 0 physicsOn density 2;
new pulley from left to right over 11 4 across 14 4 ratio 1 meeting;
every 0.5 as i { set pin motorSpeed (120 - 240 * (i % 2)); set rail slideSpeed (1 - 2 * (i % 2)); impulse ball 2 1; }
after 2 { set engine motorSpeed 300; set engine torque 5; }
on key "x" { destroy cord; new rope cord2 from hook to ball; after 1 { destroy cord2; destroy post;
set pin torque 1; } }
"""


def played(game: Game, first: int, last: int) -> list[int]:
    found = []
    for step in range(first, last):
        if step == 160:
            game.device.tap("x")
        game.step()
        found.append(game.world.checksum())
    return found


def new_game() -> Game:
    return Game("level", headless=True)


def test_a_level_with_every_joint_and_its_python_are_the_same() -> None:
    scripted, translated = new_game(), new_game()
    level.build(script.read(BUSY), scripted)
    names: dict[str, Any] = {"__name__": "translated"}
    exec(compile(translate(script.read(BUSY)), "translated.py", "exec"), names)
    names["build"](translated)
    assert len({type(joint) for joint in scripted.world.joints}) == 8
    assert played(scripted, 0, 300) == played(translated, 0, 300)


@pytest.mark.parametrize("at", [100, 190])
def test_a_saved_level_with_every_joint_goes_on_as_if_it_had_never_stopped(at: int) -> None:
    game, other = new_game(), new_game()
    level.build(script.read(BUSY), game)
    played(game, 0, at)
    game.save("slot")
    wanted = played(game, at, 300)
    other.resume("slot")
    (resumed,) = other.levels
    assert ("pin" in resumed, "cord" in resumed) == (True, at < 160)
    assert isinstance(resumed["pin"], evil.joints.Hinge)
    assert played(other, at, 300) == wanted
