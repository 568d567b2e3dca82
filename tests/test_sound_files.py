"""Files that are no sound, or not all of one: refused with a reason, and nothing is harmed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from listening import SOUNDS, tone, write_wav

import evilengine as evil
from evilengine.audio import Audio
from evilengine.audio.containers import DamagedError, check, format_of
from evilengine.audio.decode import MAX_VALUES, open_sound


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


@pytest.mark.parametrize("kind", ["wav", "ogg", "mp3", "flac"])
def test_a_file_cut_anywhere_is_refused_with_its_name_and_the_reason(kind: str, tmp_path: Path) -> None:
    whole = SOUNDS / f"tone.{kind}"
    if kind == "wav":
        whole = write_wav(tmp_path / "whole.wav", tone(440, 0.02))
    data = whole.read_bytes()
    cut = tmp_path / f"cut.{kind}"
    for length in range(len(data)):
        cut.write_bytes(data[:length])
        with pytest.raises(evil.AssetError, match=rf"cut\.{kind}.*(cut short|damaged|empty|no samples)"):
            open_sound(cut, cut.name).decode()


@pytest.mark.parametrize("kind", ["ogg", "flac", "mp3"])
def test_a_file_with_a_wrong_byte_is_refused_or_played_and_harms_nothing(kind: str, tmp_path: Path) -> None:
    data = bytearray((SOUNDS / f"tone.{kind}").read_bytes())
    file = tmp_path / f"flipped.{kind}"
    refused = 0
    for at in range(0, len(data), 3):
        data[at] ^= 0xFF
        file.write_bytes(data)
        data[at] ^= 0xFF
        try:
            open_sound(file, file.name).decode()
        except evil.AssetError:
            refused += 1
    assert refused > (0 if kind == "mp3" else 0.9 * len(data) / 3)  # MP3 has no checksums


def test_a_vorbis_file_whose_tags_lead_out_of_it_never_reaches_the_decoder() -> None:
    data = bytearray((SOUNDS / "tone.ogg").read_bytes())
    at = data.index(b"\x03vorbis") + 7
    for where in (at, at + 4 + int.from_bytes(data[at : at + 4], "little")):
        bad = bytearray(data)
        bad[where : where + 4] = b"\xff\xff\xff\x7f"
        with pytest.raises(DamagedError, match="checksum"):
            check(bytes(bad), "ogg")
        from evilengine.audio import containers

        page = bytes(bad)
        begin = page.index(b"OggS", 4)
        _, _, _, end = containers._ogg_page(bytes(data), begin)
        sealed = page[begin : begin + 22] + bytes(4) + page[begin + 26 : end]
        bad[begin + 22 : begin + 26] = containers._ogg_checksum(sealed).to_bytes(4, "little")
        with pytest.raises(DamagedError, match="tags"):
            check(bytes(bad), "ogg")


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "empty"),
        (b"hello, this is text and no sound at all", "no sound that can be read"),
        (b"\x89PNG\r\n\x1a\n" + bytes(100), "no sound that can be read"),
        (b"RIFF\x04\x00\x00\x00WAVE", "no samples"),
        (b"RIFF\xff\xff\xff\xffWAVEfmt \xff\xff\xff\x7f", "cut short"),
        (b"ID3\x04\x00\x00\x7f\x7f\x7f\x7f" + bytes(50), "cut short"),
        (b"\xff\xfb\x90\x00", "cut short"),
    ],
)
def test_what_is_no_sound_is_refused_with_a_reason(folder: Path, content: bytes, reason: str) -> None:
    (folder / "bad.ogg").write_bytes(content)
    for call in (Audio(folder).play, Audio(folder).music):
        with pytest.raises(evil.AssetError, match=rf"bad\.ogg.*{reason}"):
            call("bad.ogg")


def test_a_missing_sound_is_named_with_the_nearest_there_is(game: evil.Game) -> None:
    with pytest.raises(evil.AssetError, match=r"'tome\.wav'.*did you mean 'tone\.wav'"):
        game.audio.play("tome.wav")
    with pytest.raises(evil.AssetError, match="folder"):
        game.audio.play(".")
    for name in ("", "\0", "x" * 5000):
        with pytest.raises(evil.AssetError):
            game.audio.play(name)
    with pytest.raises(evil.ArgumentTypeError):
        game.audio.play(7)  # type: ignore[arg-type]


def test_a_sound_too_long_to_be_held_is_sent_to_music(folder: Path) -> None:
    """A header may promise more than there is memory for; nothing is allocated on its word."""
    frames = MAX_VALUES + 1
    file = folder / "long.wav"
    write_wav(file, np.zeros(10), 8000)
    header = bytearray(file.read_bytes()[:44])
    header[22], header[32], header[34] = 1, 1, 8  # one byte a frame
    header[40:44] = frames.to_bytes(4, "little")
    with file.open("wb") as out:
        out.write(header)
        out.truncate(44 + frames + frames % 2)  # a file with a hole: long, and yet small
    with pytest.raises(evil.AssetError, match=r"may last 4194 s; play longer ones with game\.audio\.music"):
        Audio(folder).play("long.wav")


@pytest.mark.parametrize(
    "wrong",
    [
        {"volume": -1}, {"volume": math.nan}, {"volume": 9}, {"pitch": 0}, {"pitch": 5}, {"pan": 2}, {"start": 1.0},
        {"start": -1}, {"fade": -1}, {"fade": 1e9}, {"at": (math.nan, 0)}, {"at": "here"}, {"volume": "loud"},
        {"group": "nobody"}, {"group": None},
    ],
)  # fmt: skip
def test_wrong_arguments_are_refused_and_nothing_plays(game: evil.Game, wrong: dict[str, object]) -> None:
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=str(next(iter(wrong)))):
        game.audio.play("tone.wav", **wrong)  # type: ignore[arg-type]
    assert game.audio.sounds == ()
    with pytest.raises(evil.ArgumentTypeError, match="did you mean 'volume'"):
        game.audio.play("tone.wav", volum=1)  # type: ignore[call-arg]


def test_made_sounds_are_checked(game: evil.Game) -> None:
    game.audio.add("stereo", [0.1, -0.1] * 480, channels=2, rate=24000)
    assert game.audio.play("stereo").length == pytest.approx(0.02)
    for samples, options in (([], {}), ([0.1], {"channels": 2}), ([0.1], {"rate": 0}), ([0.1], {"channels": 9})):
        with pytest.raises(evil.ArgumentError):
            game.audio.add("bad", samples, **options)
    with pytest.raises(evil.ArgumentTypeError):
        game.audio.add("bad", ["loud"])  # type: ignore[list-item]


def test_where_the_sound_goes_is_checked(folder: Path) -> None:
    with pytest.raises(evil.ArgumentError, match="did you mean 'none'"):
        evil.Game(headless=True, sound="nome")
    with pytest.raises(evil.AssetError, match="cannot be written"):
        evil.Game(headless=True, sound=folder / "missing" / "out.wav")


def test_formats_are_told_by_what_a_file_holds() -> None:
    assert [format_of((SOUNDS / f"tone.{kind}").read_bytes()) for kind in ("ogg", "mp3", "flac")] == [
        "ogg",
        "mp3",
        "flac",
    ]
