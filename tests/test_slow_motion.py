"""Slow motion: fewer of the same steps in a second, smooth pictures, and sounds that slow down where they are live."""

from __future__ import annotations

import itertools

import pytest

import evilengine as evil
from evilengine import _core
from evilengine.audio import Card
from evilengine.game import Game
from evilengine.values.tick import STEP


def make(**options):
    game = Game("Slow", size=(320, 180), headless=True, **options)
    game.add(evil.Rectangle(9, 1), at=(0, -2), kind="static")
    game.add(evil.Circle(0.4), at=(0, 1), restitution=0.6)
    return game


@pytest.mark.parametrize("speed", [0.1, 0.5, 1.0, 2.0])
def test_speed_makes_fewer_or_more_steps_of_the_same_time(speed):
    game = make()
    game.speed = speed
    for frame in range(121):
        game.frame(frame * STEP)
    assert abs(game.world.steps - 120 * speed) <= 1
    plain = make()
    plain.step(game.world.steps)
    assert plain.world.snapshot() == game.world.snapshot(), "the steps are the same"


def test_slow_motion_draws_between_steps():
    game = make()
    game.add(evil.Circle(1), at=(-2, 0), velocity=(5, 0), gravity_scale=0)
    game.speed = 0.25
    pictures = set()
    for frame in range(41):
        game.frame(frame * STEP)
        pictures.add(game.device.shown.tobytes())
    assert len(pictures) > 30, "ten steps, and pictures between them"


@pytest.mark.parametrize("bad", [0, 0.01, 5, float("nan"), "fast", True])
def test_speeds_that_cannot_be_are_refused(bad):
    game = make()
    with pytest.raises(evil.ArgumentError if isinstance(bad, (int, float)) and bad is not True else TypeError):
        game.speed = bad
    assert game.speed == 1.0


class Silence:
    """A sound card that somebody else plays: the test asks the mixer for what it would hear."""

    def close(self):
        pass


def live_game():
    game = make()
    game.audio.output = Card(lambda callback, address, keeper, rate: Silence())
    return game


def crossings(game, group):
    """How often a tone of 480 Hz crosses zero in half a second of what the card hears, at half speed."""
    tone = [(1 if n % 100 < 50 else -1) * 0.5 for n in range(48000)]
    game.audio.add("tone", tone, rate=48000)
    game.audio.play("tone", loop=True, group=group)
    game.speed = 0.5
    game.frame(0.0)
    pcm = memoryview(game.audio._mixer.render_pcm(48000)).cast("h")[::2]
    late = pcm[24000:]
    return sum(a * b < 0 for a, b in itertools.pairwise(late))


def test_what_is_heard_live_deepens_with_the_game():
    assert abs(crossings(live_game(), "effects") - 240) <= 8
    assert abs(crossings(live_game(), "interface") - 480) <= 8, "what does not pause with the game keeps its pitch"
    game = live_game()
    game.audio.groups["music"].pauses = False
    assert abs(crossings(game, "music") - 480) <= 8


def test_a_wav_file_hears_steps_alone(tmp_path):
    heard = []
    for speed in (1.0, 0.25):
        game = make(sound=tmp_path / f"{speed}.wav")
        game.audio.add("tick", [0.5, -0.5] * 4000)
        game.audio.play("tick")
        game.speed = speed
        frame = 0
        while game.world.steps < 60:
            game.frame(frame * STEP)
            frame += 1
        game.close()
        heard.append((tmp_path / f"{speed}.wav").read_bytes())
    assert heard[0] == heard[1]


def test_a_sound_lives_as_long_in_steps_at_any_speed():
    assert _core.MIX_RATE == 48000
    lives = []
    for speed in (1.0, 0.25):
        game = live_game()
        game.audio.add("tick", [0.1] * 24000)
        sound = game.audio.play("tick")
        game.speed = speed
        frame = 0
        while sound.alive:
            game.frame(frame * STEP)
            frame += 1
        lives.append((game.world.steps, frame))
    assert lives[0][0] == lives[1][0] == 30
    assert lives[1][1] > 3.5 * lives[0][1]
