"""game.audio: what a game says, and what is heard of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from listening import SOUNDS, read_wav, tone, write_wav

import evilengine as evil
from evilengine.audio import Audio, Listener, WavFile
from evilengine.audio.decode import open_sound
from evilengine.audio.groups import Group
from evilengine.audio.hearing import from_place, gains
from evilengine.values.vec2 import Vec2

FRAMES_A_STEP = 800


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_wav(tmp_path / "tone.wav", tone())
    write_wav(tmp_path / "flat.wav", np.full(48000, 0.5))
    write_wav(tmp_path / "other.wav", tone(1000, 2.0))
    return tmp_path


@pytest.fixture
def game(folder: Path) -> Iterator[evil.Game]:
    game = evil.Game(headless=True, sound=folder / "out.wav", folder=folder, gravity=(0, 0))
    yield game
    game.close()


def out(game: evil.Game) -> np.ndarray:
    """Close the game, and read what was heard of it."""
    game.close()
    return read_wav(game.folder / "out.wav")


# Playing --------------------------------------------------------------------------------------------------------------


def test_a_sound_is_heard_at_the_very_frame_of_its_step(game: evil.Game) -> None:
    game.step(7)
    game.audio.play("flat.wav")
    game.step(20)
    signal = out(game)
    assert len(signal) == 27 * FRAMES_A_STEP
    assert np.flatnonzero(signal[:, 0])[0] == 7 * FRAMES_A_STEP
    assert signal[-1] == pytest.approx([0.5 * math.sqrt(0.5)] * 2, abs=1e-4)  # equal power in the middle


def test_the_same_game_gives_the_same_file_however_it_is_cut_into_frames(folder: Path) -> None:
    def play(name: str, cuts: list[int]) -> bytes:
        game = evil.Game(headless=True, sound=folder / name, folder=folder)
        game.audio.music("other.wav", fade=0.1)
        steps = 0

        @game.on_update
        def sounds(dt: float) -> None:
            nonlocal steps
            steps += 1
            if steps % 7 == 0:
                game.audio.play("tone.wav", pitch=1 + steps / 50, pan=-0.5, volume=0.2)

        for cut in cuts:
            game.step(cut)
        game.close()
        return (folder / name).read_bytes()

    assert play("a.wav", [60]) == play("b.wav", [1] * 60) == play("c.wav", [13, 1, 30, 16])


def test_a_sound_may_have_any_rate_and_any_number_of_channels(game: evil.Game) -> None:
    for rate in (8000, 11025, 22050, 44100, 96000, 192000):
        for channels in (1, 2, 3, 6):
            samples = np.repeat(tone(440, 0.2, rate)[:, None], channels, axis=1)
            write_wav(game.folder / "any.wav", samples, rate)
            audio = Audio(game.folder, output=WavFile(game.folder / "any-out.wav"))
            sound = audio.play("any.wav")
            assert sound.length == pytest.approx(0.2)
            audio.output.update(12, lambda frames: None)
            audio.close()
            signal = read_wav(game.folder / "any-out.wav")[1000:8600, 0]
            crossings = np.count_nonzero(np.diff(np.signbit(signal)))
            assert crossings == pytest.approx(2 * 440 * 7600 / 48000, abs=1.01), (rate, channels)


@pytest.mark.parametrize("kind", ["ogg", "mp3", "flac"])
def test_ogg_mp3_and_flac_are_decoded(kind: str) -> None:
    file = open_sound(SOUNDS / f"tone.{kind}", "tone")
    samples = np.asarray(file.decode())
    assert (file.channels, file.rate, file.frames) == (1, 22050, 5512)
    middle = samples[1000:4500]
    spectrum = np.abs(np.fft.rfft(middle * np.hanning(len(middle)), 1 << 16))
    assert np.argmax(spectrum) * 22050 / (1 << 16) == pytest.approx(440, abs=1)
    assert np.abs(middle).max() == pytest.approx(0.5, abs=0.03)


def test_a_wrong_ending_does_not_matter(game: evil.Game) -> None:
    (game.folder / "really-ogg.wav").write_bytes((SOUNDS / "tone.ogg").read_bytes())
    assert game.audio.play("really-ogg.wav").length == pytest.approx(0.25, abs=1e-3)


def test_volume_pan_and_pitch_are_heard(game: evil.Game) -> None:
    game.audio.play("tone.wav", volume=0.5, pan=-1.0, pitch=2.0)
    game.step(40)
    signal = out(game)
    assert np.abs(signal[:, 1]).max() < 1e-4
    assert np.abs(signal[1000:20000, 0]).max() == pytest.approx(0.25, abs=1e-3)
    assert np.count_nonzero(np.diff(np.signbit(signal[1000:20200, 0]))) == pytest.approx(2 * 880 * 0.4, abs=1.01)
    assert not signal[24200:].any()  # half as long


def test_a_place_is_heard_from_its_side_and_softer_from_afar(game: evil.Game) -> None:
    game.audio.play("tone.wav", at=(-20, 0))
    game.step(20)
    left, right = (np.abs(out(game)[2000:]).max(axis=0) / 0.5).tolist()
    assert math.hypot(left, right) == pytest.approx(0.25, abs=2e-3)  # five metres in twenty
    assert left > 3 * right


def test_hearing_follows_the_camera_and_its_turn() -> None:
    assert from_place(Vec2(10, 0), Listener(Vec2(10, 0))) == (1.0, 0.0)
    assert from_place(Vec2(0, 20), Listener(angle=math.pi / 2))[1] == pytest.approx(0.8)  # above, on its right side
    assert from_place(Vec2(1e9, 0), Listener())[0] == pytest.approx(0.01)
    for pan in np.linspace(-1, 1, 21):
        assert math.hypot(*gains(1.0, float(pan), 1)) == pytest.approx(1.0, abs=1e-6)
        assert math.hypot(*gains(1.0, float(pan), 2)) == pytest.approx(math.sqrt(2), abs=1e-6)


def test_a_sound_goes_along_with_a_body_and_stays_where_it_was_destroyed(game: evil.Game) -> None:
    fly = game.add(evil.Circle(0.1), at=(-30, 0), velocity=(60, 0))
    buzz = game.audio.play("tone.wav", at=fly, loop=True)
    game.step(60)
    assert buzz.at == fly.position
    fly.destroy()
    game.step(10)
    assert buzz.alive
    signal = np.abs(out(game))
    assert signal[800:2400, 0].max() > 3 * signal[800:2400, 1].max()
    assert signal[40000:, 1].max() > 3 * signal[40000:, 0].max()
    with pytest.raises(evil.StaleReferenceError):
        game.audio.play("tone.wav", at=fly)


def test_moving_the_camera_makes_no_clicks(game: evil.Game) -> None:
    game.audio.play("flat.wav", at=(0, 0))
    for step in range(50):
        game.camera.position = (40 * math.sin(step), 0)
        game.step()
    signal = out(game)
    assert np.abs(np.diff(signal[1000:], axis=0)).max() < 0.5 / 800 * 1.5 + 2 / 32767


# The handle -----------------------------------------------------------------------------------------------------------


def test_a_sound_that_has_ended_is_stale(game: evil.Game) -> None:
    sound = game.audio.play("tone.wav")
    assert {sound: 1}[sound] == 1
    game.step(59)
    assert sound.alive
    assert game.audio.sounds == (sound,)
    game.step()
    assert not sound.alive
    assert game.audio.sounds == ()
    for use in (lambda: sound.volume, lambda: sound.stop(), lambda: setattr(sound, "pitch", 2), lambda: sound.position):
        with pytest.raises(evil.StaleReferenceError, match=r"tone\.wav.*come to its end after 1\.00 s"):
            use()


def test_a_sound_that_was_stopped_is_stale_and_dies_away(game: evil.Game) -> None:
    sound = game.audio.play("flat.wav", loop=True)
    game.step(30)
    sound.stop(fade=0.25)
    with pytest.raises(evil.StaleReferenceError, match="was stopped"):
        sound.stop()
    game.step(30)
    signal = out(game)[:, 0]
    assert signal[24000 + 6000] == pytest.approx(0.5 * math.sqrt(0.5) / 2, abs=2e-3)  # half way of sin squared
    assert not signal[24000 + 12000 :].any()
    assert np.abs(np.diff(signal, 2))[100:].max() < 1e-4 + 2 / 32767


def test_a_jump_in_a_sound_is_heard_where_it_leads_and_not_as_a_click(game: evil.Game) -> None:
    ramp = np.linspace(0, 0.9, 48000)
    write_wav(game.folder / "ramp.wav", ramp)
    sound = game.audio.play("ramp.wav", pan=-1.0)
    game.step(12)
    assert sound.position == pytest.approx(0.2)
    sound.position = 0.7
    assert sound.position == pytest.approx(0.7)
    game.step(6)
    signal = out(game)[:, 0]
    assert signal[9600 + 2400] == pytest.approx(ramp[33600 + 2400], abs=1e-4)
    assert np.abs(np.diff(signal, 2)).max() < 3e-4


@pytest.mark.parametrize("name", ["play", "music"])
def test_a_jump_works_in_music_too(game: evil.Game, name: str) -> None:
    options = {"fade": 0.0, "loop": False} if name == "music" else {}
    sound = getattr(game.audio, name)("other.wav", **options)
    game.step(6)
    sound.position = 1.5
    game.step(29)
    assert sound.alive
    game.step()
    assert not sound.alive
    game.step(5)
    signal = out(game)[:, 0]
    assert np.abs(signal[20000:28000]).max() > 0.3
    assert not signal[28800 + 200 :].any()


def test_pitch_changes_how_long_a_sound_takes(game: evil.Game) -> None:
    sound = game.audio.play("tone.wav")
    game.step(30)
    sound.pitch = 0.5
    game.step(30)
    assert sound.position == pytest.approx(0.75)
    game.step(30)
    assert not sound.alive


def test_a_loop_lives_until_it_is_stopped(game: evil.Game) -> None:
    sound = game.audio.play("tone.wav", loop=True)
    game.step(90)
    assert sound.alive
    assert sound.position == pytest.approx(0.5)
    assert np.abs(out(game)[60000:, 0]).max() > 0.3


def test_all_sounds_can_be_stopped(game: evil.Game) -> None:
    sounds = [game.audio.play("tone.wav", loop=True) for _ in range(5)] + [game.audio.music("other.wav")]
    game.step(5)
    game.audio.stop()
    assert not any(sound.alive for sound in sounds if sound)
    game.step(5)
    assert not out(game)[5 * 800 + 300 :].any()


def test_a_game_lives_the_same_life_with_and_without_sound(folder: Path) -> None:
    def life(sound: str | Path) -> list[tuple[bool, ...]]:
        game = evil.Game(headless=True, sound=sound, folder=folder)
        sounds = [game.audio.play("tone.wav", pitch=1 + i / 10) for i in range(10)]
        history = []
        for _ in range(70):
            game.step()
            history.append(tuple(each.alive for each in sounds))
        game.close()
        return history

    assert life("none") == life(folder / "life.wav") == life("auto")


# Music ----------------------------------------------------------------------------------------------------------------


def test_music_goes_round_without_a_gap(game: evil.Game) -> None:
    write_wav(game.folder / "short.wav", np.full(5000, 0.5), 44100)
    game.audio.music("short.wav", fade=0.0)
    game.step(120)
    signal = out(game)[300:, 0]
    assert np.abs(signal - 0.5 * math.sqrt(0.5)).max() < 1e-3


def test_new_music_crosses_the_old_with_constant_power(game: evil.Game) -> None:
    random = np.random.default_rng(1)
    for name in ("one.wav", "two.wav"):
        write_wav(game.folder / name, random.normal(0, 0.08, (48000 * 3, 2)))
    game.audio.music("one.wav", fade=0.0)
    game.step(30)
    first = game.audio.music("two.wav", fade=1.0)
    game.step(90)
    power = (out(game)[: 2 * 48000] ** 2).mean(axis=1).reshape(-1, 12000).mean(axis=1)
    assert first is not None
    assert np.abs(10 * np.log10(power / 0.08**2)).max() < 0.35


def test_music_that_plays_already_plays_on(game: evil.Game) -> None:
    first = game.audio.music("other.wav", volume=0.5)
    game.step(10)
    assert game.audio.music("other.wav", volume=0.25) is first
    assert first is not None
    assert first.volume == 0.25
    assert game.audio.music(None) is None
    assert not first.alive
    assert game.audio.music(None) is None


def test_long_music_is_decoded_while_it_plays(game: evil.Game) -> None:
    seconds = 8.0
    write_wav(game.folder / "long.wav", tone(300, seconds))
    music = game.audio.music("long.wav", fade=0.0, loop=False)
    assert music is not None
    stream = game.audio._streams[music].stream
    assert stream.written < 20000
    game.step(round(seconds * 60))
    signal = out(game)[:, 0]
    assert stream.written == seconds * 48000
    exact = tone(300, seconds) * math.sqrt(0.5)
    assert np.abs(signal[:-200] - exact[:-200]).max() < 2e-4


# Groups, pause --------------------------------------------------------------------------------------------------------


def test_groups_and_the_master_have_volumes(game: evil.Game) -> None:
    game.audio.groups["effects"].volume = 0.5
    game.audio.volume = 0.5
    game.audio.play("flat.wav", pan=-1.0)
    game.step(10)
    game.audio.groups["effects"].volume = 2.0
    game.step(10)
    signal = out(game)[:, 0]
    assert signal[7000] == pytest.approx(0.125, abs=1e-4)
    assert signal[10000] == pytest.approx(0.5, abs=1e-4)
    assert np.abs(np.diff(signal[10:])).max() < 0.001


def test_the_game_s_pause_stills_all_but_the_interface(game: evil.Game) -> None:
    effect = game.audio.play("flat.wav", pan=-1.0, loop=True)
    game.audio.play("flat.wav", pan=1.0, group="interface", loop=True)
    game.frame(0.0)
    for frame in range(1, 200):
        game.paused = 60 <= frame < 120
        game.frame(frame / 60)
    steps = game.world.steps
    assert steps < 145
    assert effect.position == pytest.approx(steps / 60 % 1.0)
    game.close()


def test_a_paused_group_stands_still_in_game_time(game: evil.Game) -> None:
    group = game.audio.groups["effects"]
    sound = game.audio.play("tone.wav")
    game.step(15)
    group.paused = True
    game.step(100)
    assert sound.position == pytest.approx(0.25)
    group.paused = False
    game.step(44)
    assert sound.alive
    game.step()
    assert not sound.alive
    signal = np.abs(out(game)[:, 0])
    assert not signal[15 * 800 + 240 : 115 * 800].any()
    assert signal[116 * 800 : 159 * 800].max() > 0.3


def test_groups_can_be_added_and_are_found_by_name(game: evil.Game) -> None:
    voices = game.audio.groups.add("voices", pauses=False)
    assert isinstance(voices, Group)
    assert game.audio.play("tone.wav", group="voices").group == "voices"
    with pytest.raises(evil.ArgumentError, match="did you mean 'voices'"):
        game.audio.play("tone.wav", group="voice")
    with pytest.raises(evil.ArgumentError, match="already"):
        game.audio.groups.add("music")
    for i in range(11):
        game.audio.groups.add(f"g{i}")
    with pytest.raises(evil.ArgumentError, match="16 groups"):
        game.audio.groups.add("one too many")
