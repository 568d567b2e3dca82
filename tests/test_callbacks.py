"""Callbacks: functions that are called when something happens."""

from __future__ import annotations

import pytest

from evilengine.values.callbacks import Callbacks
from evilengine.values.errors import ArgumentTypeError


def test_functions_are_called_in_the_order_they_were_added():
    happened, seen = Callbacks("on_it", "value"), []
    happened(lambda value: seen.append(("first", value)))
    happened(lambda value: seen.append(("second", value)))
    happened.run(7)
    assert seen == [("first", 7), ("second", 7)]


def test_a_decorated_function_stays_itself():
    def function(value):
        return value

    assert Callbacks("on_it", "value")(function) is function


def test_one_added_meanwhile_waits_and_one_removed_meanwhile_is_not_called():
    happened, seen = Callbacks("on_it"), []

    def last():
        seen.append("last")

    def added():
        seen.append("added")

    @happened
    def first():
        seen.append("first")
        happened.remove(last)
        happened.remove(first)
        happened(added)

    happened(last)
    happened.run()
    assert seen == ["first"]
    happened.run()
    assert seen == ["first", "added"]


def test_an_exception_goes_through_and_changes_nothing():
    happened, seen = Callbacks("on_it"), []
    happened(lambda: seen.append(1))
    happened(lambda: 1 / 0)
    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            happened.run()
    assert (seen, len(happened)) == ([1, 1], 2)


@pytest.mark.parametrize("wrong", [None, 3, lambda: 0, lambda a, b: 0])
def test_what_cannot_take_the_arguments_is_refused_when_it_is_added(wrong):
    happened = Callbacks("game.on_update", "dt")
    with pytest.raises(ArgumentTypeError, match=r"game\.on_update: .* must be a function that takes \(dt\)"):
        happened(wrong)
    assert len(happened) == 0
