"""A game's frame: what happens in which order, pausing, running, and callbacks that misbehave."""

from __future__ import annotations

import random

import pytest

import evilengine as evil
from evilengine.game import STAGE
from evilengine.platform import HeadlessDevice
from evilengine.timer.clock import MOST_STEPS
from evilengine.values.tick import STEP


@pytest.fixture
def game():
    return evil.Game(headless=True, gravity=(0, -10))


def frames(game, count, start=0.0):
    """`count` frames on a screen of sixty a second; the first one only starts the clock."""
    for number in range(count + 1):
        game.frame(start + number * STEP)


# one frame


def test_a_step_goes_inputs_timer_update_physics_contacts(game):
    order = []
    game.add(evil.Rectangle(10, 1), at=(0, -0.5), kind="static")
    ball = game.add(evil.Circle(0.5), at=(0, 0.5), velocity=(0, -1), touchable=True)
    game.on_event(lambda event: order.append("event"))
    game.on_key_press(lambda key: order.append("key"))
    game.on_touch(lambda touch: order.append("touch"))
    game.timer.after(0, lambda: order.append("timer"))
    game.on_update(lambda dt: order.append("game update"))
    ball.on_update(lambda dt: order.append("body update"))
    ball.on_collide(lambda contact: order.append("contact"))
    game.device.key("space", down=True)
    game.device.touch(1, "began", at=(10, 10))
    game.step()
    assert order == ["event", "event", "key", "touch", "timer", "game update", "body update", "contact"]


def test_a_frame_draws_once_after_its_steps(game):
    order = []
    game.on_update(lambda dt: order.append(dt))
    game.on_draw(lambda: order.append("draw"))
    game.frame(0.0)
    game.frame(2.5 * STEP)
    game.frame(2.6 * STEP)
    assert order == ["draw", STEP, STEP, "draw", "draw"]


def test_a_late_frame_catches_up_on_a_few_steps_only(game):
    game.frame(0.0)
    game.frame(10.0)
    assert game.world.steps == MOST_STEPS


def test_what_happened_is_told_in_the_first_step_of_a_frame_that_has_one(game):
    told = []
    game.on_update(lambda dt: told.append(game.inputs.pressed))
    game.frame(0.0)
    game.device.tap("space")
    game.frame(0.4 * STEP)
    assert told == []
    game.frame(3.1 * STEP)
    assert told == [("space",), (), ()]


def test_drawing_stands_between_the_last_two_steps(game):
    ball = game.add(evil.Circle(0.5), at=(0, 0), velocity=(30, 0), gravity_scale=0, colour="white")
    assert ball.position.x == 0

    def middle():
        lit = [x for x in range(960) if game.device.shown.pixels[270, x, 0] > 200]
        return (lit[0] + lit[-1]) / 2

    game.frame(0.0)
    game.frame(STEP)
    assert middle() == pytest.approx(480, abs=1.5)
    game.frame(1.5 * STEP)
    assert middle() == pytest.approx(480 + 12.5, abs=1.5)
    game.step()
    game.frame(1.5 * STEP)
    assert ball.position.x == pytest.approx(1.0, abs=1e-3)


def test_the_same_inputs_give_the_same_game():
    def play():
        game = evil.Game(headless=True, tilt=True, seed=7)
        game.add(evil.Rectangle(20, 1), at=(0, -5), kind="static")
        boxes = [game.add(evil.Rectangle(1, 1), at=(game.random.uniform(-5, 5), 3), touchable=True) for _ in range(9)]
        game.timer.every(0.5, lambda: boxes[0].apply_impulse((game.random.uniform(-3, 3), 2)))
        for number in range(200):
            if number == 20:
                game.device.touch(1, "began", at=game.camera.to_pixel(boxes[1].position))
            if 20 < number < 90:
                game.device.touch(1, "moved", at=(400 + 3 * number, 200))
            if number % 50 == 0:
                game.device.tilt(random.Random(number).uniform(-1, 1), -1)
            game.step()
        return game.world.checksum()

    assert play() == play()


def test_drawing_changes_nothing_in_the_world():
    def play(draw):
        game = evil.Game(headless=True)
        game.add(evil.Circle(1), at=(0, 3))
        for _ in range(50):
            game.step()
            if draw:
                game.capture()
        return game.world.checksum()

    assert play(draw=True) == play(draw=False)


# pausing and stepping


def test_a_paused_game_stands_still_and_goes_on_without_a_jump(game):
    frames(game, 3)
    game.paused = True
    frames(game, 10, start=1.0)
    assert game.world.steps == 3
    game.paused = False
    game.frame(1.0 + 10.5 * STEP)
    assert game.world.steps == 4


def test_one_step_by_hand_while_paused(game):
    game.paused = True
    game.frame(0.0)
    game.step()
    game.frame(1.0)
    assert game.world.steps == 1


def test_a_callback_that_pauses_stops_the_catching_up(game):
    @game.on_update
    def pause(dt):
        game.paused = True

    game.frame(0.0)
    game.frame(5 * STEP)
    assert game.world.steps == 1


def test_what_the_player_does_during_a_pause_is_not_made_up_for(game):
    pressed = []
    game.on_key_press(pressed.append)
    game.paused = True
    game.frame(0.0)
    game.device.tap("a")
    game.device.key("b", down=True)
    game.frame(1.0)
    game.paused = False
    game.step()
    assert pressed == []
    assert game.keys["b"]


def test_events_are_told_during_a_pause(game):
    told = []
    game.on_event(told.append)
    game.paused = True
    game.device.key("p", down=True)
    game.frame(0.0)
    assert [event.key for event in told] == ["p"]


@pytest.mark.parametrize("n", [-1, 1.5, "2", None, True, float("nan")])
def test_a_number_of_steps_that_is_none_is_refused(game, n):
    with pytest.raises((evil.ArgumentError, evil.ArgumentTypeError), match=r"Game\.step"):
        game.step(n)
    assert game.world.steps == 0


# callbacks


def test_destroying_is_safe_in_every_callback(game):
    def crowd():
        return [game.add(evil.Circle(0.4), at=(0.5 * n, 0), touchable=True) for n in range(4)]

    def kill(body):
        if body.alive:
            body.destroy()

    game.step()
    for register in ("on_update", "on_key_press", "on_touch", "on_pointer", "on_tilt"):
        victims = crowd()
        getattr(game, register)(lambda _, victims=victims: [kill(body) for body in victims])
    game.on_draw(lambda: None)
    for own in ("on_update", "on_collide"):
        victims = crowd()
        for body in victims:
            getattr(body, own)(lambda _, victims=victims: [kill(each) for each in victims])
    game.timer.after(0, lambda: [kill(body) for body in crowd()])
    game.device.key("a", down=True)
    game.device.pointer(at=(100, 100))
    game.device.touch(1, "began", at=(480, 270))
    game.device.tilt(1, 0)
    game.step(5)
    game.capture()
    assert len(game.world.bodies) == 0


@pytest.mark.parametrize("register", ["on_update", "on_key_press", "on_touch", "on_tilt", "on_draw", "on_event"])
def test_an_exception_in_a_callback_comes_out_and_the_game_can_go_on(game, register):
    ball = game.add(evil.Circle(0.5), at=(0, 3))
    broken = [True]

    def fail(*_):
        if broken[0]:
            raise RuntimeError("boom")

    getattr(game, register)(fail if register != "on_draw" else lambda: fail())
    game.device.key("a", down=True)
    game.device.touch(1, "began", at=(10, 10))
    game.device.tilt(1, 0)
    game.frame(0.0) if register not in ("on_draw", "on_event") else None
    with pytest.raises(RuntimeError, match="boom"):
        frames(game, 2, start=0.0)
    broken[0] = False
    steps = game.world.steps
    game.step(10)
    assert game.world.steps == steps + 10
    assert ball.position.y < 3


def test_an_exception_in_a_contact_callback_leaves_a_world_that_goes_on(game):
    game.add(evil.Rectangle(10, 1), at=(0, -0.5), kind="static")
    ball = game.add(evil.Circle(0.5), at=(0, 0.5), velocity=(0, -1))

    @ball.on_collide
    def fail(contact):
        raise RuntimeError("boom")

    with pytest.raises(RuntimeError, match="boom"):
        game.step(10)
    game.step(60)
    assert game.timer.time == pytest.approx(game.world.time)


@pytest.mark.parametrize("call", ["step", "frame", "capture"])
def test_a_callback_cannot_step_or_draw_inside_a_step(game, call):
    @game.on_update
    def again(dt):
        getattr(game, call)(*([0.0] if call == "frame" else []))

    with pytest.raises(evil.Error, match="inside"):
        game.step()


def test_drawing_cannot_draw_again(game):
    game.on_draw(lambda: game.capture())
    with pytest.raises(evil.Error, match="inside"):
        game.capture()


def test_timer_events_count_simulated_time(game):
    seen = []
    game.timer.after(0.5, lambda: seen.append(game.world.time))
    frames(game, 60)
    assert seen == pytest.approx([0.5])


# running


def test_without_a_window_run_plays_ten_seconds(game):
    game.run()
    assert game.world.steps == 600
    assert not game.running


def test_run_stops_after_the_seconds_it_is_given(game):
    game.run(0.5)
    assert game.world.steps == 30


def test_run_stops_when_the_window_is_closed_or_the_game_quits(game):
    game.timer.after(0.25, game.device.close)
    game.run()
    assert 15 <= game.world.steps <= 17
    other = evil.Game(headless=True)
    other.timer.after(0.25, other.quit)
    other.run()
    assert other.world.steps == 16


def test_an_exception_in_run_closes_the_window(game):
    game.on_update(lambda dt: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        game.run()
    assert not game.device.is_open


def test_a_stage_takes_the_place_of_window_and_loop(game):
    class Stage:
        def open(self, title, size):
            return HeadlessDevice(size, title=title)

        def run(self, game):
            self.ran = game

    stage = Stage()
    token = STAGE.set(stage)
    try:
        staged = evil.Game("Play", size=(320, 200))
        staged.run()
    finally:
        STAGE.reset(token)
    assert stage.ran is staged
    assert (staged.device.title, staged.device.size) == ("Play", (320, 200))
