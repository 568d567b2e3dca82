"""Events by tag: what happens when any body that carries a word meets another, or is touched."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from evilengine.values.inputs import Touch
from evilengine.world.body import Body
from evilengine.world.character import EVENTS as CHARACTERS
from evilengine.world.character import Character
from evilengine.world.contacts import Contact
from evilengine.world.sensors import Visit

EVENTS = ("on_collide", "on_separate", "on_enter", "on_leave", "on_touch", *CHARACTERS)
"""What a rule may wait for."""

Met: TypeAlias = Callable[[Body, Body], object]
Touched: TypeAlias = Callable[[Body], object]


class Tags:
    """What happens when bodies that carry a tag meet others or are touched, whenever they are made.

    >>> import evilengine as evil
    >>> world, tags = evil.World(gravity=(0, 0)), Tags()
    >>> tags.on_collide("ball", "coin", lambda ball, coin: coin.destroy())
    >>> ball = tags.add(world.add(evil.Circle(1), tag="ball", velocity=(3, 0)))
    >>> coin = tags.add(world.add(evil.Circle(1), at=(3, 0), tag="coin"))
    >>> for _ in range(60):
    ...     world.step(1 / 60)
    >>> coin.alive
    False
    """

    def __init__(self) -> None:
        self.bodies: list[Body] = []
        """Those that carry a tag, in the order in which they got it."""
        self.rules: list[Rule] = []

    def add(self, body: Body) -> Body:
        """Let every rule for the body's tag, present and to come, hold for it too; returns it."""
        if body.tag:
            self.bodies = [each for each in self.bodies if each.alive]
            self.bodies.append(body)
            for rule in self.rules:
                if rule.tag == body.tag:
                    rule.watch(body)
        return body

    def change(self, body: Body, tag: str) -> None:
        """Give a body another tag, with its rules. Those of its old one hold no longer."""
        if body.tag != tag:
            body.tag = tag
            self.add(body)

    def on_collide(self, first: str, second: Body | str | None, met: Met) -> None:
        """Call `met(this, other)` when contact begins of a body tagged `first` with `second` (None: with any)."""
        self.on(Rule("on_collide", first, second, met))

    def on_separate(self, first: str, second: Body | str | None, met: Met) -> None:
        """As `on_collide`, when contact ends."""
        self.on(Rule("on_separate", first, second, met))

    def on_enter(self, first: str, second: Body | str | None, met: Met) -> None:
        """Call `met(this, other)` when `second` (None: anything) enters a sensor of a body tagged `first`."""
        self.on(Rule("on_enter", first, second, met))

    def on_leave(self, first: str, second: Body | str | None, met: Met) -> None:
        """As `on_enter`, when it leaves."""
        self.on(Rule("on_leave", first, second, met))

    def on_land(self, first: str, happened: Touched) -> None:
        """Call `happened(this)` when a character whose body is tagged `first` lands."""
        self.on(Rule("on_land", first, None, happened))

    def on_jump(self, first: str, happened: Touched) -> None:
        """As `on_land`, when it jumps."""
        self.on(Rule("on_jump", first, None, happened))

    def on_crush(self, first: str, happened: Touched) -> None:
        """As `on_land`, when it begins to be crushed."""
        self.on(Rule("on_crush", first, None, happened))

    def on_touch(self, first: str, touched: Touched) -> None:
        """Call `touched(this)` when a finger presses a body tagged `first`."""
        self.on(Rule("on_touch", first, None, touched))

    def on(self, rule: Rule) -> None:
        """Let `rule` hold for every body with its tag, present and to come."""
        self.rules.append(rule)
        for body in self.bodies:
            if body.alive and body.tag == rule.tag:
                rule.watch(body)


class Rule:
    """What happens on one of EVENTS of the bodies that it watches.

    With a `tag`, it holds for a body only as long as that carries it. `second` is whom a meeting must be with: a body,
    a tag, or None for anybody.
    """

    __slots__ = ("call", "event", "second", "tag")

    def __init__(self, event: str, tag: str | None, second: Body | str | None, call: Met | Touched) -> None:
        self.event = event
        self.tag = tag
        self.second = second
        self.call: Callable[..., object] = call

    def watch(self, body: Body) -> None:
        """Hold for `body` from now on. Watching what is watched already changes nothing."""
        owner = Character(body) if self.event in CHARACTERS else body
        callbacks = getattr(owner, self.event)
        if not any(isinstance(each, Told) and each.rule is self for each in callbacks):
            callbacks(Told(self, body))


class Told:
    """A rule on one of its bodies: the function that the body calls."""

    __slots__ = ("rule", "this")

    def __init__(self, rule: Rule, this: Body) -> None:
        self.rule = rule
        self.this = this

    def __call__(self, happened: Contact | Visit | Touch | float | None = None) -> None:
        """`happened` is what the event gives: nothing, or how fast it landed, of a character."""
        rule, this = self.rule, self.this
        if not this.alive or (rule.tag is not None and this.tag != rule.tag):
            return  # another rule on the same event may have destroyed it
        match happened:
            case Contact() | Visit():
                self._met(happened)
            case Touch(phase=phase) if phase != "began":
                pass
            case _:
                rule.call(this)

    def _met(self, happened: Contact | Visit) -> None:
        rule, this = self.rule, self.this
        other = happened.visitor if isinstance(happened, Visit) else happened.other(this)
        if not other.alive:
            return
        if isinstance(rule.second, str):
            if other.tag != rule.second:
                return
            if rule.second == rule.tag and isinstance(happened, Contact) and happened.a != this:
                return  # both carry it and both are told; once is enough
        elif rule.second is not None and other != rule.second:
            return
        rule.call(this, other)


def when_met(this: Body, event: str, second: Body | str | None, met: Met) -> None:
    """Call `met(this, other)` on `event` ("on_collide", "on_enter") of `this` with `second`: a body, a tag, any."""
    Rule(event, None, second, met).watch(this)
