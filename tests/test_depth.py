"""Depth of things in perspective: where they are seen, their sides, and what of them is saved."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from golden_pictures import assert_golden

import evilengine as evil

RENDERERS = ("soft", "gl")


def flat(renderer: str = "soft") -> evil.Game:
    game = evil.Game("Depth", size=(240, 160), headless=True, renderer=renderer, gravity=(0, 0))
    game.add_background("black")
    game.layers.perspective = True
    return game


def picture(game: evil.Game) -> npt.NDArray[np.int64]:
    return np.array(game.capture().pixels).astype(np.int64)


def extent(channel: npt.NDArray[np.int64]) -> tuple[int, int, int, int]:
    """Left, top, right and bottom of what is brighter than half."""
    y, x = np.nonzero(channel > 127)
    return int(x.min()), int(y.min()), int(x.max()) + 1, int(y.max()) + 1


def scenery(renderer: str) -> evil.Game:
    game = flat(renderer)
    game.draw(evil.Rectangle(14, 9), colour="#59627a", behind=8, layer=-1, lit=True)
    game.add(evil.Rectangle(5, 0.5), at=(0, -1.2), kind="static", colour="#8a8f9c", depth=3, lit=True)
    game.add(evil.Circle(0.4), at=(-1.2, -0.3), colour="orange", depth=1, lit=True)
    game.add(evil.Rectangle(0.7, 0.7), at=(1.3, 0.2), angle=0.4, colour="tomato", depth=1, lit=True)
    ring = evil.Polygon([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)],
                        holes=[[(-0.3, -0.3), (0.3, -0.3), (0.3, 0.3), (-0.3, 0.3)]])  # fmt: skip
    game.draw(ring, at=(0.1, 0.9), colour="gold", depth=0.8, behind=1)
    game.add_light(at=(-0.5, 1.2), radius=5)
    game.ambient = 0.4
    return game


@pytest.mark.parametrize("renderer", RENDERERS)
@pytest.mark.parametrize("zoom", [1.0, 2.0])
def test_what_is_behind_is_smaller_by_its_distance(renderer: str, zoom: float) -> None:
    game = flat(renderer)
    game.layers.distance = 10.0
    game.camera.zoom = zoom
    game.draw(evil.Rectangle(2, 1), colour="white", behind=10)
    left, top, right, bottom = extent(picture(game)[..., 0])
    by = zoom / (1 + zoom)  # the world is 10 / zoom from the eye
    assert (right - left, bottom - top) == (pytest.approx(100 * by, abs=1), pytest.approx(50 * by, abs=1))


def test_what_is_behind_moves_less_with_the_camera() -> None:
    game = flat()
    game.layers.distance = 10.0
    game.draw(evil.Rectangle(0.4, 0.4), colour="white", behind=10)
    game.camera.position = (2, 0)
    left, _, right, _ = extent(picture(game)[..., 0])
    assert (left + right) / 2 == pytest.approx(120 - 50, abs=1)


def test_depth_within_a_layer_adds_to_that_of_the_layer() -> None:
    game = flat()
    game.layers.distance = 10.0
    game.layers[-1].parallax = 0.5  # 10 m behind the world
    game.draw(evil.Rectangle(3, 1), colour="white", behind=10, layer=-1)
    left, _, right, _ = extent(picture(game)[..., 0])
    assert right - left == pytest.approx(150 / 3, abs=1)


@pytest.mark.parametrize("renderer", RENDERERS)
def test_sides_go_towards_the_middle_and_are_darker(renderer: str) -> None:
    game = flat(renderer)
    game.layers.distance = 10.0
    game.draw(evil.Rectangle(0.4, 0.4), at=(-2, 0), colour="white", depth=10)
    row = picture(game)[80, :, 0]
    assert (row[12:29] == 255).all()  # its face
    side = row[31:60]
    assert ((side > 60) & (side < 200)).all()
    assert (np.diff(side) <= 0).all()  # darker the farther back
    assert row[:9].max() == 0
    assert extent(picture(game)[..., 0] + 80)[2] == pytest.approx(120 - 90 / 2, abs=2)  # its back is half as far off


def test_faces_lie_over_the_sides_of_all_of_their_layer() -> None:
    game = flat()
    game.draw(evil.Rectangle(0.4, 1), at=(-1, 0), colour="lime")
    game.draw(evil.Rectangle(0.4, 1), at=(-1.5, 0), colour="red", depth=9)
    assert tuple(picture(game)[80, 70, :3]) == (0, 255, 0)


def test_without_perspective_all_is_flat() -> None:
    game = flat()
    game.draw(evil.Rectangle(0.4, 0.4), at=(-1, 0.5), colour="white", depth=3, behind=4)
    deep = picture(game)
    game.layers.perspective = False
    plain = flat()
    plain.draw(evil.Rectangle(0.4, 0.4), at=(-1, 0.5), colour="white")
    assert np.array_equal(picture(game), picture(plain))
    assert not np.array_equal(picture(game), deep)


def test_what_comes_too_near_to_the_eye_is_no_fault() -> None:
    game = flat()
    game.draw(evil.Rectangle(0.4, 0.4), at=(0.01, 0), colour="white", behind=-5000, depth=9000)
    assert picture(game).max() == 255


def test_depth_looks_as_it_always_did() -> None:
    assert_golden("depth", scenery("soft").capture().pixels)


def test_both_renderers_draw_the_same_depth() -> None:
    soft, gl = (picture(scenery(renderer)) for renderer in RENDERERS)
    assert np.abs(soft - gl).max() <= 4


def test_it_is_saved(tmp_path: Path) -> None:
    game = scenery("soft")
    game.layers.distance = 7.5
    game.step(2)
    game.save("s", folder=tmp_path)
    before = game.capture().tobytes()
    other = flat()
    other.resume("s", folder=tmp_path)
    assert other.capture().tobytes() == before
    assert other.layers.distance == 7.5


@pytest.mark.parametrize(
    ("name", "value"), [("depth", -1), ("behind", float("nan")), ("depth", 1e9), ("behind", "far")]
)
def test_bad_depth_is_refused(name: str, value: Any) -> None:
    game = flat()
    drawing = game.draw(evil.Circle(1))
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=f"Drawing: {name}="):
        setattr(drawing, name, value)
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=f"Scene.add: {name}="):
        game.draw(evil.Circle(1), **{name: value})
    assert (drawing.depth, drawing.behind, len(game.scene)) == (0.0, 0.0, 1)
    with pytest.raises(evil.ArgumentError, match="distance"):
        game.layers.distance = 0
