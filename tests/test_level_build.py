"""Levels at play: what a script says is what is in the world, and what happens there."""

from __future__ import annotations

import logging
import math
from pathlib import Path

import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.game import Game
from evilengine.level import Level
from evilengine.script import reference
from evilengine.script.word import MAX_BODIES
from evilengine.values.errors import AssetError, LevelError

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = sorted((ROOT / "src" / "evilengine" / "examples").glob("*.evil"))
FLOOR = "new rectangle floor 20 1 at 0 -3;"


def play(text: str, steps: int = 0) -> tuple[Game, Level]:
    game = Game("level", headless=True)
    built = level.build(script.read(text), game)
    game.step(steps)
    return game, built


def test_things_come_into_the_world_as_they_are_described() -> None:
    _, built = play("new rectangle crate 2 1 at 1 4 angle 30 physicsOn friction 0.3 restitution 0.5 mass 7 tag box;")
    crate = built["crate"]
    assert (crate.kind, crate.tag, crate.position) == ("dynamic", "box", (1, 4))
    assert crate.angle == pytest.approx(math.radians(30))
    assert (crate.friction, crate.restitution, crate.mass) == pytest.approx((0.3, 0.5, 7))


def test_what_has_no_physics_stands_still_and_holds_what_falls() -> None:
    _, built = play(FLOOR + "new circle ball 0.5 at 0 0 physicsOn;", 240)
    assert built["floor"].position == (0, -3)
    assert built["ball"].position.y == pytest.approx(-2, abs=0.02)


def test_a_moving_thing_keeps_its_velocity() -> None:
    _, built = play("new rectangle lift 2 0.2 at 0 0 moving velocity 0 1;", 60)
    assert built["lift"].position.y == pytest.approx(1, abs=1e-3)


def test_walls_keep_things_in_the_room() -> None:
    game, _ = play("gravity 0 0; new walls 10 6; new circle ball 0.3 at 0 0 physicsOn velocity 9 7 restitution 1;", 600)
    ball = list(game.world.bodies)[1]
    assert abs(ball.position.x) < 5
    assert abs(ball.position.y) < 3


def test_a_collision_does_what_its_block_says_once() -> None:
    text = (
        FLOOR + "let hits 0; new circle ball 0.5 at 0 0 physicsOn;"
        'text "{hits}" at 0 0; on collide ball floor { set hits (hits + 1); }'
    )
    game, built = play(text, 240)
    game.capture()
    assert built._texts[0][0].text == "1"


def test_a_collision_with_another_thing_is_not_meant() -> None:
    _, built = play(FLOOR + "new circle other1 0.1 at 9 9; new circle ball 0.5 at 0 0 physicsOn;"
                    "on collide ball other1 { destroy ball; }", 240)  # fmt: skip
    assert "ball" in built


def test_other_is_what_was_met_and_tags_hold_for_what_is_made_later() -> None:
    text = """
    new circle ball 0.5 at 0 3 physicsOn;
    on collide ball "coin" { destroy other; }
    after 0.1 { repeat 3 as i { new circle coin 0.2 at 0 (1 - i) tag "coin"; } }
    """
    game, built = play(text, 120)
    assert [body.tag for body in game.world.bodies] == [None]
    assert "ball" in built


def test_what_one_rule_destroyed_no_other_rule_is_told_of() -> None:
    text = (
        FLOOR
        + """
    let hits 0;
    new circle 0.5 at 0 0 physicsOn tag "coin"; new circle 0.5 at 3 0 physicsOn tag "ball";
    repeat 2 as i { on collide "coin" floor { set hits (hits + 1); destroy this; impulse other 0 2; } }
    repeat 2 as i { on collide floor "ball" { set hits (hits + 1); destroy other; } }
    """
    )
    game, built = play(text, 240)
    assert [body.tag for body in game.world.bodies if body.tag] == []
    assert built._top.numbers["hits"] == 2


def test_two_things_with_the_same_tag_meet_once() -> None:
    text = """
    gravity 0 0; let hits 0;
    repeat 2 as i { new circle 0.5 at (i * 4 - 6) 0 physicsOn velocity (3 - i * 2) 0 tag "ball"; }
    on collide "ball" "ball" { set hits (hits + 1); }
    """
    _, built = play(text, 120)
    assert built._top.numbers["hits"] == 1


def test_another_tag_brings_other_rules() -> None:
    text = (
        FLOOR
        + """
    new circle ball 0.5 at 0 0 physicsOn tag "a";
    on collide "b" floor { destroy this; }
    after 2 { set ball tag "b"; set ball at 0 0; }
    """
    )
    game, built = play(text, 110)
    assert "ball" in built
    game.step(100)
    assert "ball" not in built


def test_separation_is_an_event() -> None:
    text = FLOOR + 'new circle ball 0.5 at 0 -2 physicsOn; on separate ball floor { set floor tag "left"; }'
    _, built = play(text + "after 1 { impulse ball 0 5; }", 50)
    assert built["floor"].tag is None
    built.game.step(60)  # type: ignore[union-attr]
    assert built["floor"].tag == "left"


def test_after_and_every_keep_their_times() -> None:
    game, built = play("new circle ball 0.5; after 1 { destroy ball; } every 0.5 times 3 { new circle 0.1; }")
    game.step(59)
    assert "ball" in built
    assert len(game.world.bodies) == 2
    game.step(2)
    assert "ball" not in built
    game.step(600)
    assert len(game.world.bodies) == 3


def test_the_counter_of_every_counts() -> None:
    game, _ = play("every 0.1 times 3 as i { new circle 0.1 at (i) 0; }", 60)
    assert [body.position.x for body in game.world.bodies] == [1, 2, 3]


def test_names_of_one_round_are_not_those_of_another() -> None:
    text = "every 0.5 times 4 { new circle drop 0.1 at 0 0; after 1.2 { destroy drop; } }"
    game, _ = play(text, 32)
    assert len(game.world.bodies) == 1
    game.step(60)
    assert len(game.world.bodies) == 3
    game.step(120)
    assert len(game.world.bodies) == 0


def test_destroying_and_changing_what_is_gone_does_nothing() -> None:
    text = """
    new circle ball 0.5 physicsOn; new spring cord from ball to 0 3; text label "x" at 0 0;
    destroy ball; destroy ball; set ball velocity 1 0; impulse ball 1 0; new spring from ball to 0 1;
    destroy cord; destroy label; destroy label; set label size 20; on collide ball { tilt off; }
    """
    game, built = play(text, 10)
    assert len(game.world.bodies) == 0
    assert "ball" not in built


def test_keys_touches_and_shakes_are_events() -> None:
    text = """
    view 16 9; new circle ball 0.5 at 0 0; new circle second 0.5 at 4 0;
    on key "space" { set ball tag "key"; } on touch second { set this tag "touched"; } on shake { destroy ball; }
    """
    game, built = play(text)
    game.device.key("space", down=True)
    game.device.touch(1, "began", at=game.camera.to_pixel((4, 0)))
    game.step(2)
    assert built["ball"].tag == "key"
    assert built["second"].tag == "touched"


def test_tilt_view_gravity_and_background_reach_the_game() -> None:
    game, _ = play('view 32 18; tilt on; gravity 1 -5; background "red";')
    assert game.tilt is True
    assert game.world.gravity == (1, -5)
    assert game.camera.to_world((960, 0)) == pytest.approx((16, 9))
    assert tuple(game.capture().pixels[5, 5, channel] for channel in range(3)) == (255, 0, 0)


def test_looks_reach_the_drawings() -> None:
    game, built = play('new circle ball 0.5 colour "#ff0000" layer 3 hidden; draw circle sun 1 at 0 3 colour gold;')
    (drawing,) = built["ball"].drawings
    assert (drawing.colour.hex, drawing.layer, drawing.visible) == ("#ff0000", 3, False)
    assert built["sun"].colour.hex == "#ffd700"
    assert len(game.world.bodies) == 1


def test_set_changes_what_it_names() -> None:
    text = "new circle ball 0.5 physicsOn; set ball at 3 4; set ball colour blue; set ball hidden on; set ball spin 90;"
    _, built = play(text + "set ball gravityScale 0; set ball touchable on;")
    ball = built["ball"]
    assert (ball.position, ball.touchable, ball.gravity_scale) == ((3, 4), True, 0)
    assert ball.angular_velocity == pytest.approx(math.radians(90))
    assert (ball.drawings[0].colour.hex, ball.drawings[0].visible) == ("#0000ff", False)


def test_forces_act() -> None:
    text = """
    gravity 0 0;
    new circle a 0.5 at -5 0 physicsOn; new circle b 0.5 at 0 0 physicsOn;
    new circle c 0.5 at 5 0 physicsOn velocity 0 9;
    new spring from a to 0 4 stiffness 30; new force 3 0 for b; new medium 4 4 at 5 0 drag 9;
    """
    _, built = play(text, 30)
    assert built["a"].position.x > -5
    assert built["b"].velocity.x > 0
    assert built["c"].velocity.y < 9


def test_things_deal_with_what_they_meet_as_the_level_says() -> None:
    text = """
    new rectangle belt 30 0.5 at 0 -0.25 conveyor 2; new circle cargo 0.4 at 0 0.4 physicsOn friction 1;
    new rectangle ledge 4 0.2 at 20 2 oneWay; new circle jumper 0.3 at 20 0 physicsOn velocity 0 9;
    new circle ghost 0.4 at 5 2 physicsOn category 2 mask 4; new circle left 0.4 at -30 0 physicsOn group -3;
    new rectangle gate 2 2 at 0 1 sensor;
    """
    _, built = play(text + "set ghost category 6; after 1 { set belt conveyor -1; }", 110)
    assert built["belt"].surface_speed == -1
    assert built["cargo"].velocity.x < 2
    assert built["jumper"].position.y > 2
    assert built["ghost"].position.y < -1
    assert (built["ghost"].category, built["ghost"].mask, built["left"].group) == (6, 4, -3)
    assert (built["gate"].sensor, built["ledge"].one_way) == (True, (0, 1))


def test_media_lift_and_blow() -> None:
    text = """
    new medium 9 4 at 0 -2 density 1 drag 3; new rectangle raft 2 1 at 0 0.5 physicsOn density 0.5;
    new medium 2 20 at 9 0 velocity 0 15 drag 2; new circle leaf 0.2 at 9 0 physicsOn mass 0.1;
    """
    _, built = play(text, 400)
    assert built["raft"].position.y == pytest.approx(0, abs=0.05)
    assert built["leaf"].position.y > 5


def test_numbers_are_shown_in_texts() -> None:
    game, built = play(
        'let score 2; text board "Score {score} of {{3}}" at 10 10; on key "a" { set score (score + 0.5); }'
    )
    assert built["board"].text == "Score 2 of {3}"
    game.device.key("a", down=True)
    game.step()
    game.capture()
    assert built["board"].text == "Score 2.5 of {3}"


def test_the_same_seed_gives_the_same_level_and_another_a_different_one() -> None:
    def places(seed: int) -> list[float]:
        game, _ = play(f"seed {seed}; repeat 5 {{ new circle 0.1 at random(-5, 5) 0; }}")
        return [body.position.x for body in game.world.bodies]

    assert places(1) == places(1)
    assert places(1) != places(2)


def test_a_world_alone_takes_what_it_can() -> None:
    world = evil.World()
    text = FLOOR + 'tilt on; text "x" at 0 0; new circle ball 0.5 at 0 0 physicsOn colour red;'
    built = level.build(script.read(text + "after 1 { destroy ball; } on collide ball floor { destroy ball; }"), world)
    for _ in range(120):
        world.step(1 / 60)
    assert "ball" not in built
    assert len(world.bodies) == 1


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("let n 0; new circle (n);", "refused"),
        ("let n 0; new circle (1 / n);", "no-result"),
        ("let n 0; new polygon 0 0, 1 0, (n) 0 at 0 0;", "refused"),
        ("let n 2000; repeat (n) { new circle 1; }", "refused"),
        ("let n 0; every (n) { new circle 1; }", "refused"),
    ],
)
def test_what_only_shows_while_playing_says_where_it_is_written(text: str, code: str) -> None:
    game = Game("level", headless=True)
    before = game.world.checksum()
    with pytest.raises(LevelError) as raised:
        level.build(script.read("gravity 0 1;\nnew circle 1;\n" + text), game)
    (error,) = raised.value.errors
    assert (error.line, error.code) == (3, code)
    assert len(game.world.bodies) == 0
    assert game.world.gravity == evil.World().gravity
    assert before != 0


def test_an_error_in_a_callback_says_where_it_is_written() -> None:
    game, _ = play("let n 1;\nevery 0.5 { set n (n - 1);\n new circle (n); }")
    with pytest.raises(LevelError) as raised:
        game.step(60)
    assert raised.value.errors[0].line == 3


def test_an_endless_every_stops_making_things_in_time(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.WARNING):
        text = "gravity 0 0; repeat 20 { repeat 600 as i { new particle 1 at (i) 0; } }"
        world = evil.World()
        level.build(script.read(text), world)
    assert len(world.bodies) == MAX_BODIES
    assert len(caplog.records) == 1


def test_loading_a_file_that_is_missing_or_broken_leaves_the_game_as_it_was(tmp_path: Path) -> None:
    (tmp_path / "level.evil").write_text("new circle ball 0.5 at 0 3;")
    game = Game("level", headless=True, folder=tmp_path)
    level.load(game, tmp_path / "level.evil")
    with pytest.raises(AssetError, match="nowhere"):
        level.load(game, tmp_path / "nowhere.evil")
    (tmp_path / "broken.evil").write_text("new circle 1; new circel 1;")
    with pytest.raises(LevelError, match="circle"):
        level.load(game, tmp_path / "broken.evil")
    assert len(game.world.bodies) == 1


@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_every_shipped_level_plays_and_keeps_its_things_on_the_screen(path: Path) -> None:
    game = Game("level", headless=True, folder=path.parent)
    level.load(game, path)
    game.step(600)
    assert len(game.world.bodies) > 3
    assert all(abs(body.position.x) < 12 and body.position.y > -9 for body in game.world.bodies)


def test_prototype_1_has_what_the_thesis_names() -> None:
    text = (ROOT / "src" / "evilengine" / "examples" / "prototype1.evil").read_text(encoding="utf-8")
    assert all(f"new {kind}" in text for kind in ("walls", "circle", "rectangle", "triangle", "polygon"))
    game = Game("level", headless=True)
    level.build(script.read(text), game)
    dynamic = [body for body in game.world.bodies if body.kind == "dynamic"]
    assert len(dynamic) > 15
    assert all(body.touchable and body.restitution == 0 for body in dynamic)
    assert game.tilt


def test_the_crates_of_prototype_1_stand_until_the_room_is_tilted() -> None:
    game = Game("level", headless=True)
    level.load(game, ROOT / "src" / "evilengine" / "examples" / "prototype1.evil")
    crates = [body for body in game.world.bodies if body.kind == "dynamic"][:10]
    before = [body.position for body in crates]
    game.step(300)
    assert max((body.position - start).length for body, start in zip(crates, before, strict=True)) < 0.1
    game.device.tilt(1, 0)
    game.step(120)
    assert min((body.position - start).length for body, start in zip(crates, before, strict=True)) > 0.5


def test_the_reference_page_is_current() -> None:
    assert (ROOT / "docs" / "level-language.md").read_text(encoding="utf-8") == reference.reference()
