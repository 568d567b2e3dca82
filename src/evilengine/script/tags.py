"""Events by tag: what happens when any body that carries a word meets another, or is touched."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

from evilengine.world.body import Body

if TYPE_CHECKING:
    from evilengine.values.inputs import Touch
    from evilengine.world.contacts import Contact

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
        self._bodies: list[Body] = []
        self._rules: list[tuple[str, Callable[[Body], None]]] = []

    def add(self, body: Body) -> Body:
        """Let every rule for the body's tag, present and to come, hold for it too; returns it."""
        if body.tag:
            self._bodies = [each for each in self._bodies if each.alive]
            self._bodies.append(body)
            for tag, watch in self._rules:
                if tag == body.tag:
                    watch(body)
        return body

    def change(self, body: Body, tag: str) -> None:
        """Give a body another tag, with its rules. Those of its old one hold no longer."""
        if body.tag != tag:
            body.tag = tag
            self.add(body)

    def on_collide(self, first: str, second: Body | str | None, met: Met) -> None:
        """Call `met(this, other)` when contact begins of a body tagged `first` with `second` (None: with any)."""
        self._on_contact("on_collide", first, second, met)

    def on_separate(self, first: str, second: Body | str | None, met: Met) -> None:
        """As `on_collide`, when contact ends."""
        self._on_contact("on_separate", first, second, met)

    def on_touch(self, first: str, touched: Touched) -> None:
        """Call `touched(this)` when a finger presses a body tagged `first`."""
        self._on(first, lambda body: when_touched(body, touched, first))

    def _on_contact(self, event: str, first: str, second: Body | str | None, met: Met) -> None:
        self._on(first, lambda body: when_met(body, event, second, met, first))

    def _on(self, tag: str, watch: Callable[[Body], None]) -> None:
        self._rules.append((tag, watch))
        watched: set[Body] = set()
        for body in self._bodies:
            if body.alive and body.tag == tag and body not in watched:
                watched.add(body)
                watch(body)


def when_met(this: Body, event: str, second: Body | str | None, met: Met, tag: str | None = None) -> None:
    """Call `met(this, other)` on `event` ("on_collide" or "on_separate") of `this` with `second`: a body, a tag, any.

    With `tag`, only as long as `this` carries it.
    """

    def told(contact: Contact) -> None:
        other = contact.other(this)
        if tag is not None and this.tag != tag:
            return
        if isinstance(second, str):
            if not other.alive or other.tag != second:
                return
            if second == tag and contact.a != this:
                return  # both carry it and both are told; once is enough
        elif second is not None and other != second:
            return
        met(this, other)

    getattr(this, event)(told)


def when_touched(this: Body, touched: Touched, tag: str | None = None) -> None:
    """Call `touched(this)` when a finger presses `this`; with `tag`, only as long as it carries it."""

    def told(touch: Touch) -> None:
        if touch.phase == "began" and (tag is None or this.tag == tag):
            touched(this)

    this.on_touch(told)
