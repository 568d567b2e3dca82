"""What is heard goes on where it was when the game was saved."""

from __future__ import annotations

import json

import pytest

import evilengine as evil
from evilengine.game import saving
from evilengine.game.saving import SAVED_GAME


def game_with_sounds(folder, sound="none"):
    game = evil.Game("Sounds", headless=True, folder=folder, sound=sound)
    game.audio.add("hum", [0.1, 0.2, -0.2, -0.1] * 12_000)
    game.audio.add("beep", [0.5, -0.5] * 6_000)
    game.ball = game.add(evil.Circle(0.5), at=(3, 0), tag="ball")
    return game


def playing(game):
    return [
        (s.name, s.group, s.looping, s.volume, s.pitch, s.pan, s.at, round(s.position, 6)) for s in game.audio.sounds
    ]


@pytest.fixture
def game(tmp_path):
    game = game_with_sounds(tmp_path)
    game.audio.groups.add("voices", pauses=False)
    game.audio.groups["voices"].volume = 0.25
    game.audio.groups["effects"].paused = True
    game.audio.volume = 0.5
    game.audio.play("hum", at=game.ball, volume=0.7, loop=True, pitch=0.5)
    game.audio.play("beep", at=(1, 2), pan=0.5, group="voices")
    game.audio.play("beep", group="interface", start=0.1)
    game.step(5)
    return game


def test_sounds_go_on_where_they_were(game, tmp_path):
    data = saving.to_bytes(game)
    other = game_with_sounds(tmp_path)
    other.audio.play("beep")
    saving.from_bytes(other, data, "test.evs")
    assert playing(other) == playing(game)
    assert len(playing(other)) == 3
    for each in (game, other):
        each.step(4)
    assert playing(other) == playing(game)
    voices = other.audio.groups["voices"]
    assert (voices.volume, voices.pauses, other.audio.groups["effects"].paused) == (0.25, False, True)
    assert other.audio.volume == 0.5
    other.ball.position = (-2, 0)
    assert other.audio.sounds[0].at == (-2, 0), "it goes along with the ball"


def test_music_goes_on_where_it_was(tmp_path):
    import wave

    with wave.open(str(tmp_path / "music.wav"), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(8000)
        file.writeframes(bytes(2 * 8000 * 3))
    game = game_with_sounds(tmp_path)
    game.audio.music("music.wav", volume=0.4)
    game.step(60)
    data = saving.to_bytes(game)
    other = game_with_sounds(tmp_path)
    saving.from_bytes(other, data, "test.evs")
    assert playing(other) == playing(game)
    assert other.audio.music("music.wav").position == pytest.approx(1.0)
    (tmp_path / "music.wav").unlink()
    silent = game_with_sounds(tmp_path)
    with pytest.raises(evil.SaveError, match=r"music\.wav"):
        saving.from_bytes(silent, data, "test.evs")


def test_sounds_that_cannot_be_are_refused_before_anything_changes(game, tmp_path):
    data = saving.to_bytes(game)
    sections = SAVED_GAME.read(data, "x")
    for change in (
        {"name": "none"},
        {"group": "none"},
        {"volume": 99},
        {"at": ["body", 77]},
        {"start": "x"},
        {"pitch": 0},
    ):
        state = json.loads(sections["game"])
        state["audio"]["sounds"][0] |= change
        before = playing(game)
        with pytest.raises(evil.SaveError):
            saving.from_bytes(game, SAVED_GAME.write(sections | {"game": json.dumps(state).encode()}), "x")
        assert playing(game) == before
