"""The level words `play` and `music`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from listening import read_wav, tone, write_wav

import evilengine as evil
from evilengine import script
from evilengine.level import build
from evilengine.script.translate import translate


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_wav(tmp_path / "thud.wav", np.full(4800, 0.5))
    write_wav(tmp_path / "wind.wav", tone(300, 1.0, size=0.2))
    return tmp_path


def game_of(text: str, folder: Path, *, sound: str = "out.wav") -> evil.Game:
    game = evil.Game(headless=True, sound=folder / sound, folder=folder)
    (folder / "level.evil").write_text(text)
    game.load(folder / "level.evil")
    return game


def problems(text: str, folder: Path) -> str:
    (folder / "level.evil").write_text(text)
    with pytest.raises(evil.LevelError) as caught:
        script.read_file(folder / "level.evil")
    return str(caught.value)


def test_a_level_plays_a_sound_when_things_meet(folder: Path) -> None:
    game = game_of(
        "new rectangle floor 8 1 at 0 -2;\nnew circle ball 0.5 at 3 0 physicsOn;\n"
        'on collide ball floor { play "thud.wav" at ball volume 0.5 pitch 2; }',
        folder,
    )
    while not game.world.contacts.begun:
        game.step()
    (thud,) = game.audio.sounds
    assert (thud.name, thud.volume, thud.pitch) == ("thud.wav", 0.5, 2.0)
    assert thud.at == list(game.world.bodies)[1].position
    begin = game.world.steps
    game.step(10)
    game.close()
    heard = np.flatnonzero(read_wav(folder / "out.wav").any(axis=1))
    assert begin * 800 <= heard[0] <= begin * 800 + 1


def test_a_level_has_music_that_changes_and_ends(folder: Path) -> None:
    write_wav(folder / "rain.wav", tone(500, 1.0))
    game = game_of(
        'music "wind.wav" volume 0.3;\non key "a" { music "rain.wav" fade 0.1; }\non key "b" { music off; }', folder
    )
    (wind,) = game.audio.sounds
    assert (wind.name, wind.volume, wind.looping, wind.group) == ("wind.wav", 0.3, True, "music")
    for key, names in (("a", ["rain.wav"]), ("b", [])):
        game.device.key(key, down=True)
        game.step(20)
        assert [sound.name for sound in game.audio.sounds] == names
    game.close()


def test_a_sound_at_something_that_is_gone_is_not_played(folder: Path) -> None:
    game = game_of('new circle ball 0.5;\ndestroy ball;\nplay "thud.wav" at ball;', folder)
    assert game.audio.sounds == ()
    game.close()


def test_a_level_that_cannot_be_built_falls_silent_again(folder: Path) -> None:
    (folder / "bad.wav").write_bytes(b"this is no sound")
    game = evil.Game(headless=True, folder=folder)
    (folder / "level.evil").write_text('music "wind.wav";\nplay "thud.wav";\nplay "bad.wav";')
    with pytest.raises(evil.LevelError, match=r"level\.evil:3.*bad\.wav.*no sound that can be read"):
        game.load(folder / "level.evil")
    assert game.audio.sounds == ()


def test_a_world_alone_hears_nothing(folder: Path) -> None:
    world = evil.World()
    build(script.read('play "thud.wav";\nmusic "wind.wav";\nmusic off;'), world)
    assert len(world.bodies) == 0


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('play "thut.wav";', "did you mean 'thud.wav'"),
        ('play "../thud.wav";', "not a file in the level's folder"),
        ("play thud;", 'write "thud"'),
        ("play;", 'play needs a sound\n    play;\n        ^\n    as in: play "thud.ogg"'),
        ("music;", 'music needs a sound\n    music;\n         ^\n    as in: music "wind.ogg"'),
        ('play "thud.wav" volume 9;', "volume is from 0 to 8"),
        ('play "thud.wav" pitch 0;', "pitch is from 0.0625 to 4"),
        ('play "thud.wav" volum 1;', "did you mean 'volume'"),
        ('play "thud.wav" at nobody;', "nobody"),
        ('music "wind.wav" at 0 0;', "music has no at"),
        ('music "wind.wav" fade 2m;', "metres"),
        ('sound "thud.wav";', "did you mean 'play'"),
        ("new circle volume 1;", "volume"),
    ],
)
def test_mistakes_are_explained(folder: Path, text: str, told: str) -> None:
    assert told in problems(text, folder)


def test_the_python_of_a_level_plays_the_same(folder: Path) -> None:
    text = 'new circle ball 0.5;\nplay "thud.wav" at ball volume 0.5;\nmusic "wind.wav" fade 2;\nmusic off;'
    python = translate(script.read(text))
    for line in (
        'game.audio.play("thud.wav", at=ball, volume=0.5)',
        'game.audio.music("wind.wav", fade=2)',
        "game.audio.music(None)",
    ):
        assert line in python
