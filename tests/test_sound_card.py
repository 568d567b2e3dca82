"""The sound card: SDL's dummy and disk drivers stand in for it."""

from __future__ import annotations

import ctypes
import io
import os
import subprocess
import sys
import threading
import time
import wave
from array import array
from pathlib import Path

import numpy as np
import pytest
from listening import tone, write_wav

import evilengine as evil
from evilengine.audio import Audio, Card, Listener, Output
from evilengine.platform import Speaker
from evilengine.platform.speaker import clock_address


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_wav(tmp_path / "tone.wav", tone())
    write_wav(tmp_path / "flat.wav", np.full(48000, 0.5))
    write_wav(tmp_path / "other.wav", tone(1000, 2.0))
    return tmp_path


@pytest.fixture
def dummy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")


def until(condition: object, seconds: float = 5.0) -> bool:
    deadline = time.perf_counter() + seconds
    while time.perf_counter() < deadline:
        if condition():  # type: ignore[operator]
            return True
        time.sleep(0.005)
    return False


@pytest.mark.usefixtures("dummy")
def test_the_card_is_opened_at_the_first_sound_and_plays_by_itself(folder: Path) -> None:
    audio = Audio(folder, output=Card(Speaker))
    assert audio.output.mixer is None
    audio.play("tone.wav", pitch=4.0)
    mixer = audio.output.mixer
    assert mixer is not None
    assert mixer.voices_in_use == 1

    def over() -> bool:
        mixer.tidy()
        return mixer.voices_in_use == 0

    assert until(over)
    assert mixer.clock >= 12000
    audio.close()
    stopped = mixer.clock
    time.sleep(0.05)
    assert mixer.clock == stopped
    audio.play("tone.wav")  # after that, silence and no error
    audio.update(Listener())


@pytest.mark.usefixtures("dummy")
def test_a_busy_python_thread_does_not_hold_the_card_up(folder: Path) -> None:
    audio = Audio(folder, output=Card(Speaker))
    for _ in range(32):
        audio.play("tone.wav", loop=True, pitch=0.9)
    mixer = audio.output.mixer
    assert mixer is not None
    address, frequency = clock_address()
    mixer.watch(address)

    end = time.perf_counter() + 1.5
    while time.perf_counter() < end:  # holds the GIL all along
        sum(range(20000))
    blocks, gap, longest = mixer.punctuality
    audio.close()
    gap_ms, mix_ms = gap / frequency * 1e3, longest / frequency * 1e3
    print(f"{blocks} blocks of 10.7 ms, worst gap {gap_ms:.1f} ms, worst mix {mix_ms:.2f} ms")
    assert blocks > 80
    assert gap_ms < 250  # on a loaded machine; one callback in Python waits as long even on a free one


def test_what_the_card_gets_is_what_a_file_would_get(folder: Path) -> None:
    """SDL's disk driver writes what a card would play; in a process of its own, which reads the variables first."""
    raw = folder / "raw"
    code = f"""
import time
from pathlib import Path
from evilengine.audio import Audio, Card
from evilengine.platform import Speaker
audio = Audio(Path({str(folder)!r}), output=Card(Speaker))
audio.play("tone.wav", pan=-1.0)
while audio.output.mixer.clock < 52000:
    time.sleep(0.01)
audio.close()
"""
    names = {"SDL_AUDIODRIVER": "disk", "SDL_DISKAUDIOFILE": str(raw), "SDL_DISKAUDIODELAY": "1"}
    subprocess.run([sys.executable, "-c", code], check=True, env=os.environ | names, timeout=60)
    signal = np.fromfile(raw, np.float32).reshape(-1, 2)[:, 0]
    begin = np.flatnonzero(signal)[0] - 1  # a sine begins with a zero
    assert np.abs(signal[begin : begin + 47000] - tone()[:47000]).max() < 1e-4


@pytest.mark.parametrize("driver", ["nonsense", "alsa"])
def test_without_a_sound_card_a_game_is_silent_and_says_why(
    folder: Path, monkeypatch: pytest.MonkeyPatch, driver: str, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", driver)
    monkeypatch.setenv("ALSA_CONFIG_PATH", os.devnull)
    audio = Audio(folder, output=Card(Speaker))
    sound = audio.play("tone.wav")
    music = audio.music("other.wav")
    audio.update(Listener())
    assert sound.alive
    assert music is not None
    assert "no sound card" in audio.output.reason
    assert capfd.readouterr() == ("", "")
    audio.close()


def test_a_game_without_a_window_is_silent_unless_it_is_asked_for_a_file() -> None:
    game = evil.Game(headless=True)
    assert type(game.audio.output) is Output
    game.audio.add("tick", array("f", [0.1] * 100))
    game.audio.play("tick")
    assert game.audio.output.mixer is None


@pytest.mark.usefixtures("dummy")
def test_threads_that_command_and_a_card_that_mixes_get_along(folder: Path) -> None:
    audio = Audio(folder, output=Card(Speaker))
    failures: list[BaseException] = []

    def play() -> None:
        try:
            for i in range(400):
                sound = audio.play("tone.wav", pitch=4.0, volume=0.01)
                sound.pan = (i % 3) - 1.0
                sound.position = 0.5
                sound.stop()
                audio.update(Listener())
        except BaseException as problem:
            failures.append(problem)

    threads = [threading.Thread(target=play) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    audio.close()
    assert failures == []


def test_the_clock_that_watches_is_a_c_function() -> None:
    address, frequency = clock_address()
    clock = ctypes.CFUNCTYPE(ctypes.c_uint64)(address)
    first = clock()
    time.sleep(0.02)
    assert 0.015 < (clock() - first) / frequency < 2.0


def test_a_wav_file_is_whole_when_the_game_is_closed(folder: Path) -> None:
    game = evil.Game(headless=True, sound=folder / "w.wav", folder=folder)
    game.step(30)
    game.close()
    game.close()
    with wave.open(io.BytesIO((folder / "w.wav").read_bytes())) as file:
        assert file.getnframes() == 24000
