"""The timer: fixed steps out of wall time, and events at planned times."""

from __future__ import annotations

import gc
import random
import weakref

import pytest

import evilengine as evil
from evilengine.timer import Clock, Schedule
from evilengine.timer.clock import MOST_STEPS
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.tick import STEP


class Stepped(Schedule):
    """A schedule with a count of steps of its own, where a game has a world's."""

    def __init__(self) -> None:
        self.count = 0
        super().__init__(lambda: self.count)


def run(schedule: Stepped, steps: int) -> None:
    for _ in range(steps):
        schedule.run_due()
        schedule.count += 1


# the clock


def test_the_first_frame_owes_nothing_whatever_the_time_is():
    assert Clock().advance(123456.0).steps == 0


def test_a_screen_at_sixty_frames_gets_one_step_each_frame_for_an_hour():
    clock = Clock()
    clock.advance(0.0)
    assert {clock.advance(frame / 60.0).steps for frame in range(1, 60 * 60 * 60)} == {1}


def test_a_screen_at_144_frames_gets_sixty_steps_a_second():
    clock = Clock()
    ticks = [clock.advance(frame / 144.0) for frame in range(10 * 144 + 1)]
    assert sum(tick.steps for tick in ticks) == 600
    assert {tick.steps for tick in ticks} == {0, 1}


def test_alpha_is_the_time_that_is_left_over_in_steps():
    clock = Clock()
    clock.advance(0.0)
    assert clock.advance(1.25 * STEP).alpha == pytest.approx(0.25)
    assert clock.advance(1.75 * STEP).alpha == pytest.approx(0.75)
    assert clock.advance(2.0 * STEP).alpha == pytest.approx(0.0, abs=1e-9)


def test_steps_and_alpha_together_never_lose_or_make_time():
    clock, chance, now = Clock(), random.Random(1), 0.0
    clock.advance(now)
    simulated = 0
    for _ in range(10_000):
        now += chance.uniform(0.0, 5.0 * STEP)
        tick = clock.advance(now)
        simulated += tick.steps
        assert 0.0 <= tick.alpha <= 1.0
        assert (simulated + tick.alpha) * STEP == pytest.approx(now, abs=1e-6)


def test_catching_up_is_capped_and_the_rest_is_let_go():
    clock = Clock()
    clock.advance(0.0)
    tick = clock.advance(10.0)
    assert tick.steps == MOST_STEPS
    assert tick.dropped == pytest.approx(10.0 - MOST_STEPS * STEP)
    assert clock.advance(10.0 + STEP).steps == 1


def test_time_that_runs_backwards_stands_still():
    clock = Clock()
    clock.advance(5.0)
    assert clock.advance(4.0) == Clock().advance(0.0)
    assert clock.advance(4.0 + STEP).steps == 1


def test_holding_shows_the_last_step_and_forgets_the_time_that_passes():
    clock = Clock()
    clock.advance(0.0)
    clock.advance(1.5 * STEP)
    assert (clock.hold(5.0).steps, clock.hold(9.0).alpha) == (0, 1.0)
    tick = clock.advance(9.0 + 0.25 * STEP)
    assert (tick.steps, tick.alpha) == (1, pytest.approx(0.25))


@pytest.mark.parametrize("now", [float("nan"), float("inf"), 1e300, "soon", None])
def test_a_time_that_is_no_time_is_refused_and_changes_nothing(now):
    clock = Clock()
    clock.advance(1.0)
    with pytest.raises((ArgumentError, ArgumentTypeError), match="now="):
        clock.advance(now)
    assert clock.advance(1.0 + STEP).steps == 1


# the schedule


def test_an_event_happens_once_at_the_step_of_its_time():
    schedule, seen = Stepped(), []
    event = schedule.after(0.5, lambda: seen.append(schedule.time))
    assert event.alive
    run(schedule, 600)
    assert seen == [0.5]
    assert not event.alive
    assert len(schedule) == 0


def test_an_event_never_comes_early():
    schedule, seen = Stepped(), []
    schedule.after(0.51, lambda: seen.append(schedule.time))
    run(schedule, 60)
    assert seen == [31 * STEP]


def test_every_keeps_its_rhythm_without_drift():
    schedule, seen = Stepped(), []
    schedule.every(0.1, lambda: seen.append(schedule.time))
    run(schedule, 60 * 100 + 1)
    assert len(seen) == 1000
    assert seen[-1] == pytest.approx(100.0)
    assert seen == pytest.approx([0.1 * k for k in range(1, 1001)])


def test_events_of_one_time_come_in_the_order_they_were_made():
    schedule, seen = Stepped(), []
    schedule.every(0.1, lambda: seen.append("every"))
    for name in "abc":
        schedule.at(0.3, lambda name=name: seen.append(name))
    schedule.after(0.3, lambda: seen.append("after"))
    run(schedule, 20)
    assert seen == ["every", "every", "every", "a", "b", "c", "after"]


def test_events_of_one_step_come_in_the_order_of_their_times():
    schedule, seen = Stepped(), []
    for time in (0.303, 0.301, 0.302):
        schedule.at(time, lambda time=time: seen.append(time))
    run(schedule, 30)
    assert seen == [0.301, 0.302, 0.303]


def test_a_thousand_events_come_sorted():
    schedule, seen, chance = Stepped(), [], random.Random(2)
    times = [chance.uniform(0.0, 10.0) for _ in range(1000)]
    for time in times:
        schedule.at(time, lambda time=time: seen.append(time))
    run(schedule, 602)
    assert seen == sorted(times)


def test_a_time_that_has_passed_comes_at_the_next_step():
    schedule, seen = Stepped(), []
    run(schedule, 60)
    schedule.at(0.2, lambda: seen.append(schedule.time))
    run(schedule, 2)
    assert seen == [1.0]


def test_a_cancelled_event_does_not_happen_and_cancelling_twice_is_fine():
    schedule, seen = Stepped(), []
    event = schedule.every(0.1, lambda: seen.append(1))
    run(schedule, 7)
    event.cancel()
    event.cancel()
    run(schedule, 60)
    assert seen == [1]
    assert (event.alive, event.time, len(schedule)) == (False, None, 0)


def test_a_callback_may_cancel_itself_and_others_of_the_same_step():
    schedule, seen = Stepped(), []
    first = schedule.every(0.1, lambda: (seen.append("first"), first.cancel(), second.cancel()))
    second = schedule.every(0.1, lambda: seen.append("second"))
    run(schedule, 60)
    assert seen == ["first"]


def test_a_callback_may_plan_more_which_waits_for_the_next_step():
    schedule, seen = Stepped(), []

    def again():
        seen.append(schedule.time)
        schedule.after(0.0, again)

    schedule.after(0.0, again)
    run(schedule, 5)
    assert seen == [0.0, STEP, 2 * STEP, 3 * STEP, 4 * STEP]


def test_clearing_inside_a_callback_leaves_nothing():
    schedule, seen = Stepped(), []
    schedule.every(0.1, lambda: (seen.append(1), schedule.after(0.0, lambda: seen.append(2)), schedule.clear()))
    schedule.every(0.1, lambda: seen.append(3))
    run(schedule, 60)
    assert seen == [1]
    assert len(schedule) == 0


def test_a_callback_that_raises_counts_as_called_and_the_rest_stay_due():
    schedule, seen = Stepped(), []

    def fail():
        raise RuntimeError("boom")

    broken = schedule.every(0.1, fail)
    schedule.after(0.1, lambda: seen.append(1))
    run(schedule, 6)
    with pytest.raises(RuntimeError, match="boom"):
        schedule.run_due()
    assert seen == []
    assert broken.time == pytest.approx(0.2)
    schedule.run_due()
    assert seen == [1]


def test_destroying_what_is_gone_by_then_is_passed_over():
    world = evil.World()
    schedule = Schedule(lambda: world.steps)
    spark = world.add(evil.Circle(1))
    schedule.after(0, spark.destroy)
    schedule.after(0, spark.destroy)
    schedule.run_due()
    assert not spark.alive
    assert len(schedule) == 0


def test_a_schedule_keeps_nothing_of_events_that_are_over():
    class Thing:
        def ring(self):
            pass

    schedule, thing = Stepped(), Thing()
    watched = weakref.ref(thing)
    schedule.after(0.0, thing.ring)
    schedule.after(1.0, thing.ring).cancel()
    run(schedule, 1)
    del thing
    gc.collect()
    assert watched() is None


@pytest.mark.parametrize("verb", ["after", "every", "at"])
@pytest.mark.parametrize("time", [float("nan"), float("inf"), -1.0, 1e300, "soon", None])
def test_bad_times_are_refused_and_plan_nothing(verb, time):
    schedule = Stepped()
    with pytest.raises((ArgumentError, ArgumentTypeError), match=f"timer.{verb}"):
        getattr(schedule, verb)(time, print)
    assert len(schedule) == 0


def test_every_refuses_less_than_a_step():
    with pytest.raises(ArgumentError, match=r"at least 0\.016"):
        Stepped().every(0.0, print)


@pytest.mark.parametrize("verb", ["after", "every", "at"])
def test_what_cannot_be_called_is_refused(verb):
    with pytest.raises(ArgumentTypeError, match="must be a function"):
        getattr(Stepped(), verb)(1.0, "print")
