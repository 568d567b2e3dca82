"""Level words for how things, texts, lamps and particles meet what is behind them, lie, turn and begin."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import PIL.Image
import PIL.ImageFont
import pytest

import evilengine as evil
from evilengine import level, script
from evilengine.scene import Drawing, Emitter, Text
from evilengine.script.translate import translate

LEVEL = """
view 16 9;
background "hills.png" parallax 0.5 repeated off colour "#8899aa" layer -20;
plane -2 parallax 0.5 hidden;
lens filmic perspective off eyeDistance 20;
new rectangle floor 12 1 at 0 -3 colours "#102040" "#102040" "orange" "gold" outline lit;
new rectangle board 4 1 at -3 1 angle 20 texture "panel.png" slice 6;
draw rectangle sign 3 1 at 3 2 texture "panel.png" slice 4 6 8 6 flipX flipY;
draw circle halo 1 at 0 0 colour "#ff9a3c60" blend add;
new circle coin 0.5 at 1 2 texture "coin.png" frames 4 1 showing (1 + 1);
draw circle flame 0.5 at -1 3.4 texture "coin.png" frames 4 1 fps 30 plays once;
new light lamp at 0 3 towards -90 cone 60 softEdge 0.8 mask 1 out;
new particles ash at -3 -2 rate 60 flying 1 2 lasting 0.5 1.5 blend multiply most 40 bouncing restitution 0.6;
new particles boom at 3 -2 bursting 20 colour "orange" blend screen;
new particles still at 3 0 rate 50 idle;
text score "Lines of words that break" at 20 12 pinned topRight align centre width 150 font "title.ttf";
text gone "Nobody sees this" at 20 60 hidden;
new circle ball 0.3 at -5 3 physicsOn;
camera follows ball ahead 2 1 smoothing 0;
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    sheet = PIL.Image.new("RGBA", (80, 20))
    for frame, colour in enumerate(("gold", "red", "lime", "blue")):
        sheet.paste(PIL.Image.new("RGBA", (20, 20), colour), (20 * frame, 0))
    sheet.save(tmp_path / "coin.png")
    panel = PIL.Image.new("RGBA", (20, 20), "navy")
    panel.paste(PIL.Image.new("RGBA", (8, 8), "white"), (6, 6))
    panel.save(tmp_path / "panel.png")
    PIL.Image.new("RGBA", (30, 20), "teal").save(tmp_path / "hills.png")
    face = PIL.ImageFont.load_default(20)
    assert isinstance(face, PIL.ImageFont.FreeTypeFont)
    assert isinstance(face.path, io.BytesIO)
    (tmp_path / "title.ttf").write_bytes(face.path.getvalue())
    return tmp_path


def played(folder: Path, text: str = LEVEL) -> tuple[evil.Game, level.Level]:
    game = evil.Game(headless=True, renderer="soft", folder=folder)
    return game, level.build(script.read(text), game)


def seen(game: evil.Game, place: tuple[float, float]) -> tuple[int, ...]:
    """The colour of a point of the world."""
    x, y = game.camera.to_pixel(place)
    return tuple(map(int, np.asarray(game.capture().pixels)[int(y), int(x), :3]))


def emitter(made: level.Level, name: str) -> Emitter:
    found = made[name]
    assert isinstance(found, Emitter)
    return found


def test_looks_are_what_the_words_say(folder: Path) -> None:
    _, made = played(folder)
    sign, halo = made["sign"], made["halo"]
    assert isinstance(sign, Drawing)
    assert (sign.flip_x, sign.flip_y, halo.blend) == (True, True, "add")
    assert made["floor"].drawings[0].outline
    assert made["coin"].drawings[0].frame == 2
    assert not made["coin"].drawings[0].playing


def test_a_film_that_plays_once_stops_at_its_last_frame(folder: Path) -> None:
    game, made = played(folder)
    game.step(30)
    assert made["flame"].frame == 3
    assert not made["flame"].playing


def test_corners_have_their_colours_and_borders_keep_their_width(folder: Path) -> None:
    game, _ = played(
        folder,
        'view 16 9; draw rectangle 8 4 at -4 0 colours "red" "red" "blue" "blue";'
        'draw rectangle 6 3 at 4 0 texture "panel.png" slice 6;',
    )
    low, high = seen(game, (-4, -1.9)), seen(game, (-4, 1.9))
    assert low[0] > 230 > 40 > low[2]
    assert high[2] > 230 > 40 > high[0]
    assert seen(game, (4, 1.42)) == (0, 0, 128)  # the border: 6 points, of which 50 make a metre
    assert seen(game, (4, 0)) == (255, 255, 255)


def test_a_sliced_body_keeps_its_picture_where_it_turns(folder: Path) -> None:
    game, made = played(folder)
    board = made["board"]
    red, green, blue = seen(game, board.position + evil.Vec2(1.96, 0).turned(board.angle))
    assert red == green == 0 < 100 < blue  # the navy border, bent by the film
    board.shapes[0].destroy()
    assert board.drawings == []


def test_texts_hang_and_lie_where_the_words_say(folder: Path) -> None:
    _, made = played(folder)
    score = made["score"]
    assert isinstance(score, Text)
    assert (score.anchor, score.align, score.font) == ("top right", "centre", "title.ttf")
    assert not made["gone"].visible


def test_particles_burst_wait_and_meet_what_is_behind(folder: Path) -> None:
    game, made = played(folder)
    ash, boom, still = (emitter(made, name) for name in ("ash", "boom", "still"))
    assert (ash.blend, ash.speed, ash.life, ash.most, ash.bounce) == ("multiply", (1, 2), (0.5, 1.5), 40, 0.6)
    assert (boom.count, boom.blend, boom.once) == (20, "screen", True)
    game.step(70)
    assert 30 <= ash.count <= 40
    assert still.count == 0
    assert "boom" not in made


def test_set_changes_them(folder: Path) -> None:
    changes = (
        "set coin showing 1; set coin flipX on; set halo blend screen; set lamp out off; set lamp towards 0;"
        "set lamp cone 30; set still idle off; set still bursting 9; set still flying 4; set score align right;"
        "set score pinned bottomLeft; set gone hidden off; set lamp noShadows on; set floor outline off;"
    )
    _, made = played(folder, LEVEL + changes)
    lamp, still, score = made["lamp"], emitter(made, "still"), made["score"]
    assert made["coin"].drawings[0].frame == 1
    assert made["coin"].drawings[0].flip_x
    assert made["halo"].blend == "screen"
    assert (lamp.on, lamp.angle, round(lamp.cone, 4), lamp.shadows) == (True, 0.0, 0.5236, False)
    assert (still.running, still.count, still.speed) == (True, 9, (4, 4))
    assert (score.align, score.anchor, made["gone"].visible) == ("right", "bottom left", True)
    assert not made["floor"].drawings[0].outline


def test_planes_and_the_lens_are_told_off_again(folder: Path) -> None:
    game, _ = played(folder, "lens filmic perspective; plane 1 hidden fogLit;")
    assert (game.post.tone_mapping, game.layers.perspective, game.layers[1].visible) == ("filmic", True, False)
    level.build(script.read("lens filmic off perspective off; plane 1 hidden off fogLit off;"), game)
    assert (game.post.tone_mapping, game.layers.perspective, game.layers[1].visible) == ("plain", False, True)
    assert not game.layers[1].fog_lit


def test_the_level_in_python_looks_the_same(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = LEVEL + 'on key "b" { set still bursting (2 + 3); set coin showing 3; }\n'
    program = translate(script.read(text))
    made: list[evil.Game] = []

    class Shown(evil.Game):
        def __init__(self, *args: object, **options: object) -> None:
            super().__init__(*args, **{**options, "headless": True, "renderer": "soft", "folder": folder})  # type: ignore[arg-type]
            made.append(self)

        def run(self, seconds: float | None = None) -> None:
            after_a_second(self)

    def after_a_second(game: evil.Game) -> None:
        game.device.tap("b")
        game.step(30)

    monkeypatch.setattr(evil, "Game", Shown)
    exec(compile(program, "level.py", "exec"), {"__name__": "__main__"})
    monkeypatch.undo()
    game, _ = played(folder, text)
    after_a_second(game)
    assert made[0].capture().tobytes() == game.capture().tobytes()


def test_it_is_saved_and_goes_on_the_same(folder: Path) -> None:
    game, _ = played(folder)
    game.step(10)
    game.save("s", folder=folder)
    picture = game.capture().tobytes()
    game.step(10)
    game.resume("s", folder=folder)
    assert game.capture().tobytes() == picture


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("draw circle 1 at 0 0 blend ad;", "did you mean 'add'"),
        ("draw circle 1 at 0 0 blend glowy;", "blend is normal, add, multiply or screen"),
        ("draw circle 1 at 0 0 blend;", "blend needs a word"),
        ("draw circle 1 at 0 0 blend 2;", "blend needs a word"),
        ('text "a" at 0 0 align middle;', "align is left, centre or right"),
        ('text "a" at 0 0 pinned topleft;', "did you mean 'topLeft'"),
        ('text "a" at 0 0 anchor topLeft;', "did you mean 'pinned'"),
        ('text "a" at 0 0 font "title.png";', "there is no file 'title.png'"),
        ("new rectangle 2 1 at 0 0 slice 12;", "slice needs texture"),
        ('new rectangle 2 1 at 0 0 texture "panel.png" slice 1 2;', "slice needs one number, or four"),
        ('new rectangle 2 1 at 0 0 texture "panel.png" slice 1 tile 2;', "slice and tile exclude each other"),
        ('new circle 2 at 0 0 texture "panel.png" slice 1;', "no borders to slice"),
        ('new rectangle 2 1 at 0 0 colours "red" "blue";', "this rectangle has 4 corners, but 2 colours"),
        ('new circle 1 at 0 0 colours "red" "blue";', "no corners to colour"),
        ('new circle 1 at 0 0 texture "coin.png" showing 2;', "showing needs frames"),
        ('new circle 1 at 0 0 texture "coin.png" frames 4 1 showing 1.5;', "showing is a whole number"),
        ('new circle 1 at 0 0 texture "coin.png" frames 4 1 showing 1 fps 3;', "showing and fps exclude each other"),
        ("new particles at 0 0 rate 1 flying 5 2;", "flying has its least number first"),
        ("new particles at 0 0 rate 1 lasting 5kg;", "lasting is in seconds"),
        ("new particles at 0 0 rate 1 glowing blend add;", "glowing and blend exclude each other"),
        ("new particles at 0 0 burst 5;", "did you mean 'bursting'"),
        ("camera ahead 2 1;", "ahead needs follows"),
        ("new light at 0 3 softEdge 3;", "softEdge cannot be 3"),
    ],
)
def test_bad_words_are_named(folder: Path, text: str, words: str) -> None:
    _, errors = script.check(text, "level.evil", str(folder))
    assert len(errors) == 1
    assert words in str(errors[0])


def test_what_only_the_game_can_know_is_refused_with_its_line(folder: Path) -> None:
    with pytest.raises(evil.LevelError, match=r"1:5.*must leave something in the middle"):
        played(folder, 'new rectangle 2 1 at 0 0 texture "panel.png" slice 12;')
