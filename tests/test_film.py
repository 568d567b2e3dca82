"""Films: every frame in its place and time, whatever the format, and never half a file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import PIL.Image
import pytest

from evilengine.assets.film import save_film
from evilengine.values.errors import ArgumentError, ArgumentTypeError, AssetError
from evilengine.values.image import Image

SIZE = (96, 54)
ENDINGS = (".webp", ".gif", ".png")


def frame(at: float, size: tuple[int, int] = SIZE) -> Image:
    """A bright square on a gradient, `at` 0..1 of the way across."""
    width, height = size
    pixels = np.zeros((height, width, 4), np.uint8)
    pixels[..., 2] = np.linspace(40, 120, height).astype(np.uint8)[:, None]
    pixels[..., 3] = 255
    left = int(at * (width - 20))
    pixels[15:35, left : left + 20, :3] = (240, 180, 40)
    return Image.of(width, height, pixels.tobytes())


def frames(count: int) -> Iterator[Image]:
    return (frame(i / count) for i in range(count))


def read(path: Path) -> tuple[list[np.ndarray], float, int]:
    """Each frame as drawn, the whole duration in milliseconds, and how often it plays (0: for ever)."""
    with PIL.Image.open(path) as film:
        shown, duration = [], 0.0
        for index in range(film.n_frames):
            film.seek(index)
            shown.append(np.asarray(film.convert("RGB")).astype(int))
            duration += film.info["duration"]
        return shown, duration, film.info.get("loop", -1)


@pytest.mark.parametrize(("ending", "tolerance"), [(".webp", 3.0), (".gif", 2.0), (".png", 0.0)])
def test_every_frame_looks_as_it_was_drawn(tmp_path: Path, ending: str, tolerance: float) -> None:
    path = save_film(frames(12), tmp_path / f"film{ending}", fps=25)
    shown, duration, loop = read(path)
    assert len(shown) == 12
    assert duration == pytest.approx(480)
    assert loop == 0
    for found, expected in zip(shown, frames(12), strict=True):
        assert np.abs(found - np.asarray(expected.pixels)[..., :3]).mean() <= tolerance


@pytest.mark.parametrize("ending", ENDINGS)
@pytest.mark.parametrize("fps", [30.0, 7.3, 24.0])
def test_a_film_keeps_time_although_clocks_are_coarse(tmp_path: Path, ending: str, fps: float) -> None:
    _, duration, _ = read(save_film(frames(20), tmp_path / f"film{ending}", fps=fps))
    assert duration == pytest.approx(20_000 / fps, abs=6)


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_picture_that_stays_is_stored_once_and_lasts(tmp_path: Path, ending: str) -> None:
    still = [frame(0.2)] * 10 + [frame(0.7)] * 5
    shown, duration, _ = read(save_film(still, tmp_path / f"film{ending}", fps=10))
    assert len(shown) == 2
    assert duration == pytest.approx(1500)


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_single_frame_is_a_still_picture(tmp_path: Path, ending: str) -> None:
    path = save_film([frame(0.5)], tmp_path / f"film{ending}")
    with PIL.Image.open(path) as picture:
        assert getattr(picture, "n_frames", 1) == 1
        assert (
            np.abs(np.asarray(picture.convert("RGB")).astype(int) - np.asarray(frame(0.5).pixels)[..., :3]).mean() < 2
        )


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_film_can_play_once(tmp_path: Path, ending: str) -> None:
    assert read(save_film(frames(3), tmp_path / f"film{ending}", loop=False))[2] != 0


@pytest.mark.parametrize("ending", ENDINGS)
def test_what_moves_on_leaves_nothing_behind(tmp_path: Path, ending: str) -> None:
    shown, _, _ = read(save_film(frames(24), tmp_path / f"film{ending}"))
    behind = shown[-1][15:35, :40]
    before = np.asarray(frame(1.0).pixels)[15:35, :40, :3].astype(int)
    assert np.abs(behind - before).max() <= 12


def test_new_colours_get_a_new_palette(tmp_path: Path) -> None:
    calm = np.zeros((54, 96, 4), np.uint8)
    calm[..., 3] = 255
    wild = calm.copy()
    wild[..., 0], wild[..., 1] = np.meshgrid(np.linspace(0, 255, 96), np.linspace(0, 255, 54))
    film = [Image.of(96, 54, picture.tobytes()) for picture in (calm, wild, calm, wild)]
    shown, _, _ = read(save_film(film, tmp_path / "film.gif"))
    assert np.abs(shown[1] - wild[..., :3]).mean() < 8


def test_what_is_not_opaque_stands_on_black(tmp_path: Path) -> None:
    ghost = [Image.of(8, 8, bytes([255, 255, 255, alpha] * 64)) for alpha in (0, 128)]
    shown, _, _ = read(save_film(ghost, tmp_path / "film.png"))
    assert shown[0].max() == 0
    assert np.abs(shown[1] - 128).max() <= 1


def test_progress_counts_the_frames(tmp_path: Path) -> None:
    done: list[int] = []
    save_film(frames(5), tmp_path / "film.gif", progress=done.append)
    assert done == [1, 2, 3, 4, 5]
    save_film(frames(1), tmp_path / "film.gif", progress=done.append)
    assert done[5:] == [1]


def test_frames_are_taken_one_by_one(tmp_path: Path) -> None:
    done: list[int] = []

    def lazy() -> Iterator[Image]:
        for i in range(6):
            assert len(done) >= i - 2  # not more than the two that tell a film from a picture
            yield frame(i / 6)

    save_film(lazy(), tmp_path / "film.webp", progress=done.append)
    assert len(done) == 6


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_film_that_fails_leaves_the_old_file_alone(tmp_path: Path, ending: str) -> None:
    def breaks() -> Iterator[Image]:
        yield from frames(3)
        raise KeyError("the game broke")

    path = tmp_path / f"film{ending}"
    path.write_text("old")
    with pytest.raises(KeyError, match="the game broke"):
        save_film(breaks(), path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_frames_of_different_sizes_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ArgumentError, match=r"frame 3 is \(48, 54\), those before were \(96, 54\)"):
        save_film([frame(0), frame(0.5), frame(0.5, (48, 54))], tmp_path / "film.webp")


@pytest.mark.parametrize(
    ("name", "options", "problem"),
    [
        ("film.mp4", {}, r"'\.mp4' must be one of \.webp, \.gif, \.png"),
        ("film.wepb", {}, r"did you mean '\.webp'"),
        ("film.webp", {"fps": 0}, "fps=0 must be"),
        ("film.webp", {"fps": float("nan")}, "fps=nan must be"),
        ("film.gif", {"fps": 60}, "at most 50"),
    ],
)
def test_what_a_film_cannot_be_is_refused(tmp_path: Path, name: str, options: dict[str, float], problem: str) -> None:
    with pytest.raises(ArgumentError, match=problem):
        save_film(frames(3), tmp_path / name, **options)
    assert list(tmp_path.iterdir()) == []


def test_a_film_without_frames_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ArgumentError, match="there are no frames"):
        save_film([], tmp_path / "film.webp")
    assert list(tmp_path.iterdir()) == []


def test_an_unknown_option_is_named(tmp_path: Path) -> None:
    with pytest.raises(ArgumentTypeError, match="unknown argument frames_per_second"):
        save_film(frames(3), tmp_path / "film.webp", frames_per_second=3)  # type: ignore[call-arg]


def test_a_film_that_cannot_be_written_fails_before_the_first_frame(tmp_path: Path) -> None:
    def never() -> Iterator[Image]:
        raise AssertionError("a frame was drawn")
        yield

    with pytest.raises(AssetError, match="cannot write"):
        save_film(never(), tmp_path / "nowhere" / "film.webp")
