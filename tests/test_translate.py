"""A level and its Python build the same world, to the last bit, whatever happens in it."""

from __future__ import annotations

import subprocess
import sys
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from evilengine import level, script
from evilengine.cli import translate as command
from evilengine.game import Game
from evilengine.script.translate import translate

EXAMPLES = sorted((Path(__file__).resolve().parent.parent / "src" / "evilengine" / "examples").glob("*.evil"))
STEPS = 600

BUSY = """
seed 3; let score 0; let lives 3; gravity 1 -8; view 20 12; tilt on;
new walls 18 10;
text board "Score {score} 'q' {{x}}" at 20 20 size 20; text "plain {{y}}" at 0 0;
new circle ball 0.5 at 0 3 physicsOn tag "ball" colour red touchable;
new circle class 0.3 at 2 3 physicsOn;
repeat 5 as i {
    new circle coin 0.2 at (i * 2 - 5) (random(0, 3) + sin(30 * i)) physicsOn tag "coin";
    on touch coin { destroy coin; set score (score + i); }
    on collide coin ball { set coin tag "used"; impulse other (i) 0; }
}
repeat 3 as i { new rectangle 1 0.2 at (i) -2 angle (i * 10) friction max(0.1, i / 10); }
on collide "ball" "coin" {
    set score (score + 1);
    if (score >= 3 and not score == 7 or random(0, 1) < 0.2) { set ball colour "gold"; set ball velocity 0 5; }
    else if (score % 2 == 0) { impulse this 1 0; } else { destroy other; }
}
every 0.5 times 10 as k {
    new circle drop 0.1 at (k / 4) 4 physicsOn tag "coin";
    after 1 { impulse ball (k) 0; destroy drop; }
    let inner 2; repeat 2 as j { set inner (inner * j - 1); }
    if (inner > 0) { new circle spark 0.1 at (inner) 0 physicsOn; on separate spark { set spark spin (k * 10); } }
    if (inner > 1) { new circle spark 0.15 at 0 0 physicsOn; on collide spark { destroy spark; } }
}
every 0.7 { set lives (lives - 0.5); if (lives < 0) { gravity 0 (random(-9, 9)); } }
on key "space" { impulse ball 0 6; } on shake { gravity 0 5; } on touch { set score 0; }
new spring cord from ball to class stiffness 30 length 1 damping 0.3;
on separate ball { destroy cord; new spring cord2 from ball to class; destroy cord2; }
new force wind 1 0 for ball class; new drag 0.2; new medium 4 2 at 0 -3 drag 4; destroy wind; destroy class;
new polygon rock -0.5 -0.5, 0.5 -0.4, 0 0.6 at -3 2 physicsOn angle 33.3 spin -120 mass 2 damping 0.9 spinDamping 0.5;
new rectangle mill 3 0.2 at -4 0 moving spin 50 hidden; draw circle 1 at 0 0 colour gold layer -1;
new particle 1 at 0 1;
new rectangle belt 5 0.3 at 3 -4 conveyor 2; new rectangle ledge 3 0.2 at -2 2 oneWay; new circle eye 1 at 0 0 sensor;
new circle ghost 0.3 at 5 5 physicsOn category 2 mask 5 group -1; new medium lake 6 2 at -6 -5 density 1.5 drag 2;
new medium wind2 3 9 at 6 0 velocity 0 12 drag 1;
new capsule pill 1.5 0.4 at 2 2 physicsOn; new chain bumps -8 -4, -6 -3.5, -4 -4; new segment shelf 5 0, 7 0.5;
new rectangle soft 1 0.6 at 6 3 rounding 0.2 physicsOn; on enter eye { set score (score + 1); }
draw capsule 1 0.3 at 1 1;
on leave eye ball { set score (score - 1); } on enter eye "coin" { set other tag "seen"; }
after 2 { set belt conveyor -3; set ghost mask 1; set eye sensor off; set ledge oneWay off; }
after 3 { set mill velocity 0 1; set ball at 0 3; set ball angle 45; set board size 30;
    repeat (floor(2.7)) { new circle 0.1; } }
"""


def checksums(build: Any, steps: int = STEPS) -> list[int]:
    """Of a game on which the same things are done each time, now and then."""
    game = Game("level", headless=True, folder=EXAMPLES[0].parent)
    build(game)
    found = []
    for step in range(steps):
        if step % 50 == 20:
            game.device.key("space", down=True)
            game.device.touch(1, "began", at=(300 + step, 270))
            game.device.tilt(0.3 * (step % 3 - 1), -0.9)
        if step % 50 == 30:
            game.device.key("space", down=False)
            game.device.touch(1, "ended", at=(320 + step, 270))
        game.step()
        if step % 60 == 0:
            game.capture()
        if step % 100 == 99:
            found.append(game.world.checksum())
    return found


def built_by_python(text: str) -> Any:
    """The `build` of a translation."""
    names: dict[str, Any] = {"__name__": "translated"}
    exec(compile(translate(script.read(text)), "translated.py", "exec"), names)
    return names["build"]


def same(text: str, steps: int = STEPS) -> bool:
    scripted = checksums(lambda game: level.build(script.read(text), game), steps)
    return scripted == checksums(built_by_python(text), steps)


@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_every_shipped_level_and_its_python_are_the_same_after_600_steps(path: Path) -> None:
    assert same(path.read_text(encoding="utf-8"))


def test_a_level_with_everything_in_it_and_its_python_are_the_same() -> None:
    assert script.check(BUSY)[1] == ()
    assert same(BUSY)


MOVING_ON = """
seed 4; new walls 15 8; new circle ball 0.5 at 0 3 physicsOn tag "ball"; new rectangle floor 9 1 at 0 -3;
every 0.3 { new circle 0.2 at random(-3, 3) 2 physicsOn; }
on collide floor "ball" { pace (0.5 / 2); after 0.4 { restart; } }
on key "space" { go "07_forces.evil"; }
"""


def test_a_level_that_starts_again_and_goes_on_is_the_same_in_python() -> None:
    names: dict[str, Any] = {"__name__": "translated"}
    program = translate(script.read(MOVING_ON, "round.evil"))
    assert 'game.scenes("round")(lambda: build(game))' in program
    exec(compile(program, "translated.py", "exec"), names)
    sums = []
    for begin in (lambda game: level.build(script.read(MOVING_ON, "round.evil"), game), names["build"]):
        game = Game("level", headless=True, folder=EXAMPLES[0].parent)
        game.scenes("round")(lambda begin=begin, game=game: begin(game))
        game.go("round")
        seen = []
        for step in range(300):
            if step == 250:
                game.device.tap("space")
            game.step()
            seen.append((game.world.checksum(), game.speed, game.world.steps))
        assert {speed for _, speed, _ in seen} == {1.0, 0.25}
        assert max(steps for _, _, steps in seen) < 200, "it began again"
        assert game.scenes.present == "07_forces.evil"
        sums.append(seen)
    assert sums[0] == sums[1]


def test_the_test_can_tell_levels_apart() -> None:
    one = checksums(lambda game: level.build(script.read(BUSY), game), 100)
    other = checksums(lambda game: level.build(script.read(BUSY.replace("seed 3", "seed 4")), game), 100)
    assert one != other


STATEMENTS = [
    "new circle NAME 0.4 at X Y physicsOn;",
    "new rectangle NAME 1 0.5 at X Y physicsOn tag \"box\";",
    "new circle NAME 0.3 at X Y physicsOn tag \"coin\";",
    "destroy OLD;",
    "set OLD velocity X Y;",
    "set OLD tag \"coin\";",
    "impulse OLD X 1;",
    "new spring NAME from OLD to X Y;",
    "new spring from OLD to OLD;",
    "new force X 1 for OLD;",
    "on collide OLD { set score (score + 1); }",
    "on collide \"coin\" \"box\" { destroy this; impulse other 0 2; }",
    "on separate OLD OLD { new circle 0.1 at X Y physicsOn; }",
    "repeat 2 as i { new circle inner 0.2 at (i) Y physicsOn; after (i) { destroy inner; destroy OLD; } }",
    "every 0.4 times 3 as i { new circle 0.2 at (i + score) Y physicsOn; }",
    "if (score > X) { destroy OLD; } else { impulse OLD 0 1; }",
    "gravity X Y;",
]  # fmt: skip


@given(
    st.lists(st.tuples(st.sampled_from(STATEMENTS), st.integers(-5, 5), st.integers(-3, 4), st.randoms()), max_size=12)
)
@settings(max_examples=12, deadline=None)
def test_any_level_and_its_python_are_the_same(parts: Any) -> None:
    names = ["floor"]
    lines = ["let score 0; new rectangle floor 20 1 at 0 -4; new circle first 0.5 at 0 2 physicsOn;"]
    for number, (statement, x, y, chance) in enumerate(parts):
        text = statement.replace("X", str(x)).replace("Y", str(y))
        while "OLD" in text:
            text = text.replace("OLD", chance.choice([*names[1:], "first"]), 1)
        if "NAME" in text:
            name = f"n{number}"
            text = text.replace("NAME", name)
            if "spring" not in text:
                names.append(name)
        lines.append(text)
    level_text = "\n".join(lines)
    if not script.check(level_text)[1]:
        assert same(level_text, 120)


def test_the_program_reads_like_one_that_a_person_wrote() -> None:
    text = """
    new rectangle crate 2 1 at 0 4 angle 30 physicsOn colour "#cc9966";
    new circle ball 0.5 at 1 6 physicsOn;
    on collide crate ball { destroy ball; }
    after 5 { destroy crate; }
    """
    assert (
        translate(script.read(text, "first.evil"))
        == '''"""first.evil as Python, made by `evil translate`."""

import math

import evilengine as evil


def build(game):
    crate = game.add(evil.Rectangle(2, 1), kind="dynamic", at=(0, 4), angle=math.radians(30), colour="#cc9966")
    ball = game.add(evil.Circle(0.5), kind="dynamic", at=(1, 6))

    @crate.on_collide
    def crate_meets_ball(contact):
        if contact.other(crate) == ball:
            if ball.alive:
                ball.destroy()

    def later():
        if crate.alive:
            crate.destroy()

    game.timer.after(5, later)


if __name__ == "__main__":
    game = evil.Game("first")
    build(game)
    game.run()
'''
    )


@pytest.mark.parametrize("name", ["game", "tags", "class", "None", "build", "math", "contact", "range", "print"])
def test_a_name_of_python_is_no_trouble(name: str) -> None:
    assert same(f"new circle {name} 0.5 at 0 3 physicsOn; on collide {name} {{ destroy {name}; }}", 10)


def run(*words: str) -> int:
    parser = ArgumentParser()
    command.add_arguments(parser)
    return command.run(parser.parse_args(words))


def test_evil_translate_prints_a_program_that_runs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = tmp_path / "level.evil"
    source.write_text("new circle ball 0.5 at 0 3 physicsOn;")
    assert run(str(source)) == 0
    program = capsys.readouterr().out
    assert run(str(source), "-o", str(tmp_path / "level.py")) == 0
    assert (tmp_path / "level.py").read_text() == program
    only_build = [sys.executable, "-c", "import level, evilengine as evil; level.build(evil.Game('x', headless=True))"]
    subprocess.run(only_build, cwd=tmp_path, check=True, timeout=60)


def test_evil_translate_of_a_broken_level_prints_its_errors(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = tmp_path / "level.evil"
    source.write_text("new circel 1;")
    assert run(str(source)) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert "did you mean 'circle'?" in err
