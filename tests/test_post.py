"""The post pass: bloom, tones, colours, vignette, grain; nothing at all when it is off."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from golden_pictures import GOLDEN, assert_golden

import evilengine as evil
from evilengine import _core
from evilengine.game import Game, saving


def quiet(background: str = "#808080", **options: Any) -> Game:
    game = Game("Post", size=(240, 160), headless=True, **{"renderer": "soft", **options})
    game.add_background(background)
    return game


def picture(game: Game) -> npt.NDArray[np.int64]:
    return np.array(game.capture().pixels).astype(np.int64)[..., :3]


def test_off_costs_nothing_and_changes_nothing() -> None:
    game = quiet()
    assert not game.post.on
    plain = bytes(game.capture().pixels)
    game.post.bloom_threshold = 0.2  # alone it does nothing
    assert not game.post.on
    game.post.bloom = 1.0
    game.post.clear()
    assert bytes(game.capture().pixels) == plain


def test_a_pass_that_is_on_and_neutral_changes_nothing() -> None:
    game = quiet()
    for n, colour in enumerate(("black", "white", "#ff8000", "#123456")):
        game.draw(evil.Rectangle(1, 1), at=(n - 1.5, 0), colour=colour)
    plain = picture(game)
    game.post.bloom, game.post.bloom_threshold = 1.0, 1.0  # nothing is brighter than white
    assert game.post.on
    assert abs(picture(game) - plain).max() <= 1


def test_bloom_lights_what_is_round_a_bright_thing_and_leaves_dark_ones() -> None:
    game = quiet("black")
    game.draw(evil.Circle(0.5), colour="white")
    game.draw(evil.Circle(0.3), at=(1.8, 0), colour="#505050")
    game.post.bloom = 1.0
    line = picture(game)[80, :, 0]
    assert line[120] == 255
    assert line[150] > 20, "a glow outside the disc"
    assert (np.diff(line[146:190]) <= 1).all(), "that fades with the distance"
    game.scene.clear()
    game.add_background("black")
    game.draw(evil.Circle(0.5), colour="#505050")
    game.post.bloom = 1.0
    assert picture(game)[80, 150].max() == 0


def test_exposure_doubles_light_not_numbers() -> None:
    game = quiet("#404040")
    game.post.exposure = 2.0
    linear = ((0x40 / 255 + 0.055) / 1.055) ** 2.4
    assert picture(game)[80, 120, 0] == round(255 * (1.055 * (2 * linear) ** (1 / 2.4) - 0.055))


def test_film_bends_where_plain_light_clips() -> None:
    game = quiet("#c0c0c0")
    game.post.exposure = 3.0
    assert picture(game)[80, 120, 0] == 255
    game.post.tone_mapping = "filmic"
    assert 200 < picture(game)[80, 120, 0] < 255


def test_saturation_goes_from_grey_to_gaudy() -> None:
    game = quiet("#806040")
    game.post.saturation = 0.0
    assert np.ptp(picture(game)[80, 120]) <= 1
    game.post.saturation = 2.0
    assert np.ptp(picture(game)[80, 120]) > 100


def test_contrast_turns_about_the_middle() -> None:
    game = quiet("#808080")
    game.draw(evil.Rectangle(1, 1), colour="#c0c0c0")
    game.post.contrast = 0.5
    shown = picture(game)
    assert abs(shown[10, 10, 0] - 128) <= 1
    assert abs(shown[80, 120, 0] - 160) <= 1


def test_a_tint_filters_light() -> None:
    game = quiet("white")
    game.post.tint = "#ff8000"
    assert list(picture(game)[80, 120]) == pytest.approx([255, 128, 0], abs=2)


def test_a_vignette_darkens_the_corners_alone() -> None:
    game = quiet("white")
    game.post.vignette = 1.0
    shown = picture(game)[..., 0]
    assert shown[80, 120] == 255
    assert shown[0, 0] < 8
    assert shown[80, 0] > 180
    assert (shown == shown[::-1]).mean() > 0.98
    assert (shown == shown[:, ::-1]).mean() > 0.98


def test_grain_is_noise_of_no_bias_another_each_step_and_the_same_when_played_again() -> None:
    def shown(steps: int) -> npt.NDArray[np.int64]:
        game = quiet()
        game.post.grain = 0.1
        game.step(steps)
        return picture(game)

    first = shown(3)[..., 0] - 128
    assert abs(first.mean()) < 0.3
    assert 10 < first.std() < 20
    beside = np.corrcoef(first[:, :-1].ravel(), first[:, 1:].ravel())[0, 1]
    below = np.corrcoef(first[:-1].ravel(), first[1:].ravel())[0, 1]
    then = np.corrcoef(first.ravel(), shown(4)[..., 0].ravel())[0, 1]
    assert max(abs(beside), abs(below), abs(then)) < 0.03
    assert (shown(3)[..., 0] - 128 == first).all()


def test_text_and_the_debug_view_lie_over_it() -> None:
    game = quiet("black")
    game.post.exposure = 0.0
    game.draw(evil.Rectangle(9, 9), colour="white")
    assert picture(game).max() == 0
    game.text("shines", size=40)
    assert picture(game).max() == 255


@pytest.mark.parametrize(
    ("name", "value"),
    [("bloom", -1), ("bloom", 4), ("bloom_threshold", 2), ("exposure", "1"), ("tone_mapping", "film"),
     ("contrast", None), ("saturation", float("nan")), ("tint", "wram"), ("vignette", 1.1), ("grain", True)],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(name: str, value: Any) -> None:
    post = quiet().post
    before = getattr(post, name)
    with pytest.raises(evil.Error, match="Post"):
        setattr(post, name, value)
    assert getattr(post, name) == before
    assert not post.on


def test_it_is_saved() -> None:
    game = lantern("soft")
    data = saving.to_bytes(game)
    other = quiet()
    saving.from_bytes(other, data, "saved")
    assert saving.to_bytes(other) == data
    assert repr(other.post) == repr(game.post)
    assert bytes(other.capture().pixels) == bytes(game.capture().pixels)


def lantern(renderer: str) -> Game:
    game = quiet("#1a2030", renderer=renderer)
    for n, colour in enumerate(("#ffd080", "white", "#60b0ff")):
        game.draw(evil.Circle(0.25 - 0.05 * n), at=(1.4 * n - 1.4, 0.4), colour=colour)
    game.draw(evil.Rectangle(5, 0.6), at=(0, -1.3), colour="#705038")
    post = game.post
    post.bloom, post.exposure, post.tone_mapping, post.contrast = 0.9, 1.3, "filmic", 1.1
    post.saturation, post.tint, post.vignette, post.grain = 1.2, "#fff0d8", 0.5, 0.04
    game.step(5)
    return game


def test_the_golden_picture_comes_out_to_the_bit() -> None:
    assert_golden("post", lantern("soft").capture().pixels)


def test_the_graphics_card_finishes_it_as_the_processor_does() -> None:
    pytest.importorskip("moderngl")
    from drawing_gl import any_driver

    any_driver()
    for plain in (True, False):
        pictures = []
        for renderer in ("gl", "soft"):
            game = lantern(renderer)
            assert game.renderer.name == renderer
            if plain:
                game.post.clear()
                game.post.bloom, game.post.vignette, game.post.grain = 0.9, 0.5, 0.04
            pictures.append(picture(game))
        difference = abs(pictures[0] - pictures[1])
        assert difference.max() <= 2
        assert difference.mean() < 0.02


def test_what_is_on_the_card_is_given_back() -> None:
    pytest.importorskip("moderngl")
    from drawing_gl import any_driver

    from evilengine.renderer.gl import GlRenderer

    device = any_driver()
    before = device.counts()
    game = lantern("soft")
    game.layers[0].blur = 3
    renderer = GlRenderer(device)
    for size in ((240, 160), (99, 31)):
        renderer.draw(game.scene.collect(game.camera, 1.0, size))
    renderer.close()
    with device:
        pass
    assert device.counts() == before


def test_every_instruction_set_gives_the_same_bits() -> None:
    frame, shown = lantern("soft")._collect(), set()
    for instructions in _core.instruction_sets():
        pixels = bytearray(240 * 160 * 4)
        _core.Raster().draw(frame.content, pixels, 240, 160, frame.background, instructions)
        shown.add(bytes(pixels))
    assert len(shown) == 1


if __name__ == "__main__":
    lantern("soft").capture().save(GOLDEN / "post.png")
    print(GOLDEN / "post.png", file=sys.stderr)
