"""Characters in levels: what they can do, how keys and the level itself steer them, and what happens to them."""

from __future__ import annotations

import math
from typing import Any

import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.game import Game
from evilengine.level import Level

FLOOR = "new rectangle floor 40 1 at 0 -0.5; "
HERO = FLOOR + "new character hero 0.6 1.5 at 0 0.76"


def play(text: str, steps: int = 0) -> tuple[Game, Level]:
    game = Game("level", headless=True)
    built = level.build(script.read(text), game)
    game.step(steps)
    return game, built


def hero_of(built: Level) -> evil.world.character.Character:
    character = built.world.character_of(built["hero"])
    assert character is not None
    return character


def hold(game: Game, key: str, steps: int) -> None:
    game.device.key(key, down=True)
    game.step(steps)
    game.device.key(key, down=False)
    game.step(1)


def score(built: Level) -> float:
    return built._top.numbers["n"]


def test_a_character_has_its_size_its_abilities_and_its_looks() -> None:
    _, built = play(HERO + ' walkSpeed 7 jumpHeight 250cm airJumps 1 maxSlope 40 mass 60 friction 0.1 colour "gold" '
                    'layer 3 tag "player" gravityScale 1.5 coyoteTime 200ms category 4;')  # fmt: skip
    hero, body = hero_of(built), built["hero"]
    assert body.shapes[0].definition == evil.Capsule((0, -0.45), (0, 0.45), 0.3)
    assert (hero.speed, hero.jump_height, hero.air_jumps, hero.mass) == (7, 2.5, 1, 60)
    assert hero.max_slope == pytest.approx(math.radians(40))
    assert (hero.gravity_scale, hero.coyote_time) == pytest.approx((1.5, 0.2))
    assert (body.friction, body.category, body.tag) == (pytest.approx(0.1), 4, "player")
    assert (body.drawings[0].colour.hex, body.drawings[0].layer) == ("#ffd700", 3)


def test_the_usual_keys_drive_it_and_others_if_they_are_said() -> None:
    game, built = play(HERO + "; drive hero;", 30)
    hold(game, "right", 60)
    assert built["hero"].position.x > 4
    hold(game, "space", 10)
    assert built["hero"].position.y > 1.5
    game, built = play(HERO + '; drive hero left "j" right "l" "pad_b" jump "k" "z";', 30)
    hold(game, "right", 30)
    assert built["hero"].position.x == 0
    hold(game, "l", 60)
    assert built["hero"].position.x > 4
    hold(game, "z", 10)
    assert built["hero"].position.y > 1.5


def test_driving_goes_over_to_another_and_ends() -> None:
    game, built = play(HERO + "; new character bear 1 1.4 at 5 0.71; drive hero; "
                       'on key "tab" { drive bear; } on key "x" { drive off; }', 30)  # fmt: skip
    game.device.key("right", down=True)
    game.step(10)
    game.device.tap("tab")
    game.step(30)
    there = built["hero"].position.x
    game.step(30)
    assert built["hero"].position.x == there
    assert built["bear"].position.x > 6
    game.device.tap("x")
    game.step(60)
    there = built["bear"].position.x
    game.step(30)
    assert built["bear"].position.x == there


def test_a_level_can_tell_it_what_to_do() -> None:
    _, built = play(HERO + "; tell hero walk -1; after 1 { tell hero walk 0; } after 1.5 { tell hero jump; }", 59)
    assert built["hero"].position.x < -4
    game = built.game
    assert game is not None
    game.step(30)
    assert hero_of(built).velocity.x == 0
    game.step(12)
    assert hero_of(built).position.y > 1.5


def test_it_climbs_ladders_that_are_for_it_or_for_all() -> None:
    text = HERO + "; new character other1 0.6 1.5 at 6 0.76; "
    _, built = play(text + "new ladder 1 6 0 3; tell hero climb 1; tell other1 climb 1;", 60)
    assert built["hero"].position.y > 2.5
    assert hero_of(built).ladders == ((-0.5, 0, 0.5, 6),)
    _, built = play(text + "new ladder 20 6 at 0 3 for other1; tell hero climb 1; tell other1 climb 1;", 60)
    assert built["hero"].position.y < 1
    assert built["other1"].position.y > 2.5


def test_what_happens_to_it_is_told() -> None:
    text = FLOOR + "new character hero 0.6 1.5 at 0 3 tag hero; let n 0; "
    game, built = play(text + "on land hero { set n (n + 1); } on jump hero { set n (n + 10); set this airJumps 1; } "
                       'on land "hero" { set n (n + 100); } after 2 { tell hero jump; }', 60)  # fmt: skip
    assert score(built) == 101
    game.step(62)
    assert (score(built), hero_of(built).air_jumps) == (111, 1)
    _, built = play(text + "new rectangle press 3 1 at 0 5 moving velocity 0 -2; on crush hero { destroy this; }", 120)
    assert "hero" not in built


def test_it_can_be_thrown_and_moved_and_given_new_gifts() -> None:
    game, built = play(HERO + '; on key "x" { set hero velocity 0 12; } on key "y" { set hero at 7 3; } '
                       'on key "z" { set hero walkSpeed 9; set hero colour "red"; }', 30)  # fmt: skip
    game.device.tap("x")
    game.step(10)
    assert built["hero"].position.y > 1.5
    game.device.tap("y")
    game.step(1)
    assert built["hero"].position.x == 7
    game.device.tap("z")
    game.step(1)
    assert (hero_of(built).speed, built["hero"].drawings[0].colour.hex) == (9, "#ff0000")


def test_set_on_this_and_other_finds_the_character_among_those_that_met() -> None:
    text = HERO + "; new circle ball 0.3 at 0.2 4 physicsOn; new circle stone 0.3 at 5 2 physicsOn; let n 0; "
    _, built = play(text + "on collide ball { set other walkSpeed 1; set this walkSpeed 2; set n (n + 1); } "
                    "on collide stone { set other walkSpeed 3; }", 90)  # fmt: skip
    assert score(built) >= 2, "the hero, and the floor, which has no speed"
    assert hero_of(built).speed == 1


def test_a_world_alone_has_characters_but_no_keys() -> None:
    world = evil.World()
    built = level.build(script.read(HERO + " colour red; drive hero; tell hero walk 1;"), world)
    for _ in range(60):
        world.step()
    assert built["hero"].position.x > 3


def test_one_who_is_gone_is_neither_driven_nor_told() -> None:
    game, _ = play(HERO + '; drive hero; on key "x" { destroy hero; drive hero; tell hero jump; set hero walkSpeed 1; '
                   "new ladder 1 1 for hero; }", 10)  # fmt: skip
    game.device.tap("x")
    hold(game, "right", 30)
    assert not game.world.characters


# -- enter and leave --

GOAL = "new rectangle goal 2 2 at 5 1.2 sensor tag goal; let n 0; "


def test_a_sensor_tells_who_enters_and_who_leaves() -> None:
    text = HERO + " tag hero; " + GOAL + "tell hero walk 1; new circle ball 0.1 at 5 1 physicsOn gravityScale 0;"
    _, built = play(text + 'on enter goal hero { set n (n + 1); set this colour "gold"; set other colour "red"; } '
                    "on leave goal hero { set n (n + 10); }", 130)  # fmt: skip
    assert score(built) == 11
    assert built["goal"].drawings[0].colour.hex == "#ffd700"
    assert built["hero"].drawings[0].colour.hex == "#ff0000"


def test_anybody_enters_and_tags_stand_for_all() -> None:
    text = FLOOR + GOAL + 'repeat 3 as i { new circle 0.1 at (4 + i / 2) 4 physicsOn tag "coin"; } '
    _, built = play(text + 'on enter "goal" "coin" { set n (n + 1); } on enter goal { destroy other; }', 60)
    assert score(built) == 3
    assert len(built.world.bodies) == 2
    _, built = play(text + 'on enter "goal" "stone" { set n (n + 1); } on leave "goal" { set n (n + 10); }', 90)
    assert score(built) == 30


# -- what is wrong --


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        ("new character hero 1 1;", "a character cannot be as wide as it is high | let it be a little higher"),
        ("new character hero;",
         "a character takes 2 numbers, its width and height, or 4 with its place (width, height, "
         "x, y); there is none | as in: new character hero 0.6 1.5"),
        ("new character hero 1 2 physicsOn;", "a character has no physicsOn | it takes at,"),
        ("new character hero 1 2 velocity 1 0;",
         "a new character stands | throw it later, as in: set hero velocity 0 12;"),
        ("new character hero 1 2 speed 7;", "there is no property 'speed' | did you mean 'walkSpeed'?"),
        ("new character hero 1 2 jumpHight 7;", "there is no property 'jumpHight' | did you mean 'jumpHeight'?"),
        ("new character hero 1 2 maxSlope 100;", "maxSlope cannot be 100 | maxSlope is from 0 to 89"),
        ("new character hero 1 2 airJumps 0.5;", "airJumps is a whole number | write 0"),
        ("new hero it 1 2;", "there is no kind of thing called 'hero' | did you mean 'character'?"),
        ("new circle ball 1; drive ball;", "'ball' is a thing, and this needs a character | "),
        ("new character hero 1 2; drive hreo;", "there is no character called 'hreo' | did you mean 'hero'?"),
        ("drive;", "drive needs the name of a character | as in: drive hero;"),
        ("new character hero 1 2; drive hero jmp \"space\";", "'jmp' is not a way to go | did you mean 'jump'?"),
        ("new character hero 1 2; drive hero jump;", "jump needs a key in quotes | as in: jump \"space\""),
        ("new character hero 1 2; drive hero jump \"spcae\";", "there is no key 'spcae' | did you mean \"space\"?"),
        ("new character hero 1 2; drive hero jump \"a\" jump \"b\";",
         "jump is said twice | put all its keys behind one"),
        ("new character hero 1 2; tell hero;",
         "something to do is missing here | as in: tell hero walk 1;  tell hero jump;"),
        ("new character hero 1 2; tell hero move 1;", "'move' is not something to do | did you mean 'walk'?"),
        ("new character hero 1 2; tell hero walk;", "walk needs a number from -1 to 1 | as in: tell hero walk 1;"),
        ("new character hero 1 2; tell hero walk 2;", "walk cannot be 2 | walk is from -1 to 1"),
        ("new character hero 1 2; impulse hero 0 5;", "'hero' stands still, so no impulse can move it "
         "| write: set hero velocity 0 5;"),
        ("new circle ball 1; on land ball { }", "'ball' is a thing, and this needs a character | "),
        ("new circle ball 1; set ball walkSpeed 1;", "a thing has no walkSpeed to change | "),
        ("new circle goal 1; on enter goal { }", "'goal' is no sensor, so nothing enters it "
         "| make it with sensor, or name the sensor first"),
        ("on enter { }", "on enter needs one or two names | as in: on enter goal ball { ... }"),
        ("on entre goal { }", "there is no event 'entre' | did you mean 'on enter'?"),
        ("on exit goal { }", "there is no event 'exit' | did you mean 'on leave'?"),
        ("steer hero;", "there is no statement 'steer' | did you mean 'drive'?"),
        ("new ladder 1;", "a ladder takes 2 numbers, its width and height, or 4 with its place (width, height, x, y); "
         "here is 1 | as in: new ladder 0.8 4"),
        ("new circle ball 1; new ladder 1 1 for ball;", "'ball' is a thing, and this needs a character | "),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_with_what_was_meant(text: str, refused: str) -> None:
    first = str(script.check(text)[1][0]).splitlines()
    message, _, hint = refused.partition(" | ")
    assert first[0].endswith(message)
    assert first[-1].strip().startswith(hint)


# -- saved and as Python --

BUSY = (
    HERO
    + """ tag "hero" airJumps 1; new character bear 1 1.2 at 4 0.61 walkSpeed 3; drive hero jump "space" "z";
new rectangle goal 3 3 at -3 1.5 sensor tag "goal"; new ladder 1 5 at 8 2.5; new ladder 1 3 at 2 1.5 for hero; let n 0;
new chain bumps 10 0, 12 1, 14 0.5, 20 3; new capsule pill 1.5 0.6 at 2 3 physicsOn; new segment shelf -9 1, -6 2;
new rectangle crate 0.8 0.8 at 1.5 0.4 physicsOn rounding 0.1;
on enter goal hero { set n (n + 1); } on enter "goal" "hero" { set n (n + 2); set other walkSpeed 6; }
on leave goal { set n (n + 4); set other walkSpeed 5; } on leave "goal" hero { tell bear jump; }
on land hero { set n (n + 8); } on jump "hero" { set n (n + 16); set this jumpHeight (2 + n % 3); }
on collide hero pill { set other velocity 0 (n % 5); set this walkSpeed 4; }
every 0.7 as i { tell bear walk (i % 3 - 1); if (i % 2 == 0) { tell bear jump; tell bear climb 1; } tell bear drop; }
every 2 as i { if (i % 2 == 0) { drive bear; } else { drive hero; } }
after 3 { set hero at -3 5; set hero velocity 2 3; new capsule random(1, 2) 0.5 at 0 6 physicsOn; }
text "{n}" at 20 20;
"""
)


def played(game: Game, first: int, last: int) -> list[int]:
    """Checksums of steps in which keys are pressed as if by chance."""
    found = []
    for step in range(first, last):
        for number, key in enumerate(("left", "right", "space", "up")):
            game.device.key(key, down=step // (7 + 4 * number) % 3 == number % 3)
        game.step()
        found.append(game.world.checksum())
    return found


def new_game() -> Game:
    return Game("level", headless=True)


def test_a_level_with_characters_and_its_python_are_the_same() -> None:
    from evilengine.script.translate import translate

    scripted, translated = new_game(), new_game()
    built = level.build(script.read(BUSY), scripted)
    names: dict[str, Any] = {"__name__": "translated"}
    exec(compile(translate(script.read(BUSY)), "translated.py", "exec"), names)
    names["build"](translated)
    assert played(scripted, 0, 400) == played(translated, 0, 400)
    assert score(built) > 30, "much happened"


def test_a_saved_level_with_characters_goes_on_as_if_it_had_never_stopped() -> None:
    text = BUSY.replace("every 2 as i { if (i % 2 == 0) { drive bear; } else { drive hero; } }", "")
    game, other = new_game(), new_game()
    built = level.build(script.read(text), game)
    played(game, 0, 200)
    game.save("slot")
    wanted = played(game, 200, 350)
    other.resume("slot")
    (resumed,) = other.levels
    assert score(resumed) > 0
    other.drive(hero_of(resumed), jump=("space", "z"))
    assert played(other, 200, 350) == wanted
    assert score(resumed) == score(built)
