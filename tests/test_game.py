"""Game: what an author makes with it, and what its player does."""

from __future__ import annotations

import pytest

import evilengine as evil


@pytest.fixture
def game():
    return evil.Game(headless=True, gravity=(0, -10))


# inputs


def test_keys_are_held_and_polled(game):
    game.device.key("left", down=True)
    game.step()
    assert (game.keys["left"], game.keys["right"], game.axis("left", "right")) == (True, False, -1.0)
    game.device.key("right", down=True)
    game.step()
    assert game.axis("left", "right") == 0.0
    game.device.key("left", down=False)
    game.step()
    assert game.axis("left", "right") == 1.0


def test_a_key_that_does_not_exist_is_refused_with_the_nearest(game):
    with pytest.raises(evil.ArgumentError, match="did you mean 'right'"):
        game.axis("left", "rihgt")


def test_key_callbacks_come_once_each(game):
    seen = []
    game.on_key_press(lambda key: seen.append(("down", key)))
    game.on_key_release(lambda key: seen.append(("up", key)))
    game.device.key("a", down=True)
    game.step(5)
    game.device.key("a", down=False)
    game.step(5)
    assert seen == [("down", "a"), ("up", "a")]


def test_touches_are_seen_in_the_world(game):
    touches = []
    game.on_touch(touches.append)
    game.device.touch(1, "began", at=(530, 220))
    game.step()
    assert game.touches[0].at == (1, 1)
    game.device.touch(1, "moved", at=(580, 220))
    game.device.touch(1, "ended")
    game.step()
    assert [(touch.phase, touch.at, touch.previous) for touch in touches] == [
        ("began", (1, 1), (1, 1)),
        ("moved", (2, 1), (1, 1)),
        ("ended", (2, 1), (2, 1)),
    ]
    game.step()
    assert game.touches == ()


def test_the_pointer_is_seen_in_the_world_and_told(game):
    seen = []
    game.on_pointer(lambda pointer: seen.append((pointer.at, pointer.pressed)))
    game.step()
    game.device.pointer(at=(530, 270))
    game.step(3)
    game.device.pointer(button="right", down=True)
    game.step(3)
    assert seen == [((1, 0), ()), ((1, 0), ("right",))]
    assert game.pointer.buttons == ("right",)


def test_a_shake_is_told(game):
    seen = []
    game.on_shake(lambda: seen.append(game.world.steps))
    for number in range(30):
        game.device.tilt(3.0 if number % 4 < 2 else -3.0, -1.0)
        game.step()
    assert seen


# tilt


def test_tilt_turns_gravity_and_keeps_its_strength():
    game = evil.Game(headless=True, tilt=True, gravity=(0, -10))
    game.step()
    assert game.world.gravity == pytest.approx((0, -10))
    game.device.tilt(3.0, 0.0)
    game.step()
    assert game.world.gravity == pytest.approx((10, 0))
    game.device.tilt(-0.1, -0.1)
    game.step()
    assert game.world.gravity == pytest.approx((-(50**0.5), -(50**0.5)))


def test_tilt_lets_a_body_fall_to_the_side():
    game = evil.Game(headless=True, tilt=True)
    ball = game.add(evil.Circle(0.5), at=(0, 0))
    game.device.tilt(1, 0)
    game.step(30)
    assert ball.position.x > 1
    assert abs(ball.position.y) < 0.01


def test_without_tilt_gravity_stays(game):
    game.device.tilt(1, 0)
    game.step()
    assert game.world.gravity == (0, -10)


def test_tilted_gravity_keeps_a_strength_that_is_set_meanwhile():
    game = evil.Game(headless=True, tilt=True, gravity=(0, -10))
    game.device.tilt(1, 0)
    game.step()
    game.world.gravity = (0, -4)
    game.step()
    assert game.world.gravity == pytest.approx((4, 0))


def test_a_turned_camera_turns_tilt_with_it():
    game = evil.Game(headless=True, tilt=True, gravity=(0, -10))
    game.camera.angle = 0.5
    game.device.tilt(0, -1)
    game.step()
    above = game.camera.to_pixel((0, 0))
    below = game.camera.to_pixel(game.world.gravity)
    assert below.x == pytest.approx(above.x)
    assert below.y > above.y


# fingers and bodies


def test_a_finger_drags_what_is_touchable_and_lets_go(game):
    game.world.gravity = (0, 0)
    box = game.add(evil.Rectangle(1, 1), at=(0, 0), touchable=True)
    rock = game.add(evil.Rectangle(1, 1), at=(0, 3))
    game.device.touch(1, "began", at=(480, 270))
    game.device.touch(2, "began", at=(480, 120))
    game.step()
    game.device.touch(1, "moved", at=(580, 270))
    game.device.touch(2, "moved", at=(580, 120))
    game.step(120)
    assert box.position == pytest.approx((2, 0), abs=0.1)
    assert rock.position == pytest.approx((0, 3), abs=1e-3)


def test_a_touch_callback_replaces_the_pull(game):
    game.world.gravity = (0, 0)
    box = game.add(evil.Rectangle(1, 1), at=(0, 0), touchable=True)
    seen = []
    box.on_touch(lambda touch: seen.append(touch.phase))
    game.device.touch(1, "began", at=(480, 270))
    game.step()
    game.device.touch(1, "moved", at=(580, 270))
    game.step(60)
    game.device.touch(1, "ended")
    game.step()
    assert seen == ["began", "moved", "ended"]
    assert box.position == (0, 0)


def test_a_body_may_be_destroyed_in_its_touch_callback(game):
    box = game.add(evil.Rectangle(1, 1), at=(0, 0), touchable=True)
    box.on_touch(lambda touch: box.destroy())
    game.device.touch(1, "began", at=(480, 270))
    game.step()
    game.device.touch(1, "moved", at=(580, 270))
    game.device.touch(1, "ended")
    game.step(3)
    assert not box.alive


# what there is


def test_add_takes_looks_and_physics_and_refuses_the_rest(game):
    box = game.add(evil.Rectangle(1, 1), at=(1, 2), friction=0.3, colour="red", layer=2, tag="box")
    assert (box.position, box.tag, box.drawings[0].layer) == ((1, 2), "box", 2)
    with pytest.raises(evil.ArgumentTypeError, match="did you mean 'colour'"):
        game.add(evil.Circle(1), color="red")
    with pytest.raises(evil.ArgumentTypeError, match="did you mean 'friction'"):
        game.add(evil.Circle(1), frction=1)
    with pytest.raises(evil.Error):
        game.add(evil.Circle(1), colour="no such colour")
    assert list(game.world.bodies) == [box]


def test_capture_is_the_picture_in_real_pixels(game):
    game.add(evil.Rectangle(2, 2), at=(0, 0), kind="static", colour="#ff0000")
    image = game.capture()
    assert image.size == (960, 540)
    assert image.pixels[270, 480, 0] > 200 > 60 > image.pixels[270, 480, 1]


def test_a_resized_window_keeps_its_scale_and_its_middle(game):
    game.device.resize((480, 270))
    game.step()
    assert game.camera.to_pixel((0, 0)) == (240, 135)
    assert game.capture().size == (480, 270)


def test_debug_view_changes_the_picture(game):
    game.add(evil.Rectangle(2, 2), at=(0, 0), kind="static")
    plain = game.capture().tobytes()
    game.debug = True
    assert game.debug
    assert game.capture().tobytes() != plain
    game.debug = False
    assert game.capture().tobytes() == plain


def test_text_is_seen_and_changes(game):
    empty = game.capture().tobytes()
    score = game.text("score: 1", at=(20, 20))
    one = game.capture().tobytes()
    score.text = "score: 2"
    two = game.capture().tobytes()
    assert len({empty, one, two}) == 3


@pytest.mark.parametrize("size", [(0, 10), (10, -1), (10,), "big", None, (1e9, 10), (float("nan"), 1)])
def test_a_size_that_is_none_is_refused(size):
    with pytest.raises(evil.Error, match="size="):
        evil.Game(headless=True, size=size)


@pytest.mark.parametrize(
    "wrong",
    [{"seed": "x"}, {"seed": 1.5}, {"folder": 7}, {"view_height": float("nan")}, {"view_height": 0}, {"threads": 0}]
    + [{"gravity": (0, float("inf"))}, {"gravity": 9.81}, {"sleep": "no"}, {"renderer": None}],
    ids=repr,
)
def test_arguments_that_mean_nothing_are_refused_by_name(wrong):
    with pytest.raises(evil.Error, match=next(iter(wrong))):
        evil.Game(headless=True, **wrong)


def test_an_unknown_argument_is_refused_with_the_nearest():
    with pytest.raises(evil.ArgumentTypeError, match="did you mean 'headless'"):
        evil.Game(headles=True)


def test_an_unknown_renderer_is_refused_with_those_there_are():
    with pytest.raises(evil.ArgumentError, match="'auto', 'gl', 'soft'"):
        evil.Game(headless=True, renderer="vulkan")


def test_a_missing_file_is_an_asset_error_that_names_it(game):
    with pytest.raises(evil.AssetError, match=r"nowhere\.evil"):
        game.find("nowhere.evil")
