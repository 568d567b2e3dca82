"""Grabs: which finger is on which body, and the pull on what it holds (SPEC I1, I3)."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from evilengine.values.events import Finger
from evilengine.values.inputs import Inputs, Touch
from evilengine.values.vec2 import Vec2, to_vec2
from evilengine.world.forces import Pull

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.world import World

STEP_INSIDE = 1.0e-3
"""Metres past a body's edge at which the search along a finger's path goes on; more, and it jumps over thin things;
less, and in single precision it stays on the edge that it has just found."""
MOST_CROSSED = 256
"""Bodies that a finger's path may cross in one step before the search gives up; a bound on work, never met in play."""


@dataclass(slots=True)
class Hold:
    """A finger on a body. `pull` is None where the body answers touches itself, or cannot be moved."""

    body: Body
    pull: Pull | None
    touch: Touch
    aim: Vec2
    """Where the pull was set to, as the core keeps it; a restored world may have set it elsewhere."""

    @property
    def lasts(self) -> bool:
        """False once the body or the pull was destroyed or restored away: then the finger holds nothing."""
        return self.body.alive and (self.pull is None or self.pull.alive)


def answers(body: Body) -> bool:
    """Whether a body has a touch callback of its own, which takes the place of the pull."""
    return bool(body.on_touch)


class Grabs:
    """What every finger holds, from step to step. A finger holds one body, and a body is pulled by one finger.

    >>> import evilengine as evil
    >>> from evilengine.values.inputs import Inputs, Touch
    >>> world = evil.World()
    >>> crate = world.add(evil.Rectangle(1, 1), touchable=True)
    >>> here = evil.Vec2(0.2, 0)
    >>> touch = Touch(1, "began", here, here, pixel=here, previous_pixel=here)
    >>> grabs = Grabs()
    >>> [body is crate for body, _ in grabs.update(Inputs(touches=(touch,), touch_events=(touch,)), world)]
    [True]
    >>> grabs.held(1) is crate, len(crate.forces)
    (True, 1)
    """

    def __init__(self) -> None:
        self._holds: dict[Finger, Hold] = {}

    def held(self, finger: Finger) -> Body | None:
        """The body that a finger is on, or None."""
        hold = self._holds.get(finger)
        return hold.body if hold is not None and hold.lasts else None

    def update(self, inputs: Inputs, world: World) -> tuple[tuple[Body, Touch], ...]:
        """Let the fingers of this step grab, drag and let go; returns which body each touch event went to, in order.

        A finger finds a body that is `touchable` or has a touch callback of its own, which then takes the place of the
        pull; calling it is the game's part. Where several lie under a finger, the one added last is on top. A finger
        that slides onto a body begins to touch it, so the body is told "began" then.
        """
        self._forget_what_is_gone(world)
        told: list[tuple[Body, Touch]] = []
        for touch in inputs.touch_events:
            told.extend(self._follow(touch, world))
        down = {touch.finger: touch for touch in inputs.touches if touch.phase != "ended"}
        for finger in [finger for finger in self._holds if finger not in down]:  # vanished without a word
            hold = self._holds[finger]
            told.append((hold.body, replace(hold.touch, phase="ended", previous=hold.touch.at, cancelled=True)))
            self._let_go(finger)
        for finger, hold in self._holds.items():
            touch, before = down[finger], hold.touch
            if hold.pull is not None and (touch.at != before.at or hold.pull.to != hold.aim):
                # Only then, as setting it wakes the body.
                hold.pull.to = touch.at
                hold.aim = hold.pull.to
            hold.touch = touch
        return tuple(told)

    def state(self) -> list[list[Any]]:
        """What a saved game keeps: finger, its body's slot, its pull's slot, where it is."""
        return [
            [finger, hold.body.slot, None if hold.pull is None else hold.pull._handle().slot, list(hold.touch.at),
             list(hold.touch.pixel)]
            for finger, hold in self._holds.items()
            if hold.lasts
        ]  # fmt: skip

    def read(self, state: list[list[Any]], world: World, bodies: Container[int]) -> Callable[[], None]:
        """Read what `state` gave, and return what puts it in place, once the world is restored."""
        rows = []
        for finger, body, pull, at, pixel in state:
            if not isinstance(finger, (int, str)) or body not in bodies:
                raise ValueError("no finger on no body")
            place, on_screen = to_vec2(at, "grab", "at"), to_vec2(pixel, "grab", "pixel")
            rows.append((finger, body, pull, Touch(finger, "moved", place, place, on_screen, on_screen)))

        def put() -> None:
            self._holds.clear()
            for finger, slot, force, touch in rows:
                pull = None if force is None else world._forces.get(force)
                if isinstance(pull, Pull):
                    self._holds[finger] = Hold(world._body(slot), pull, touch, pull.to)
                elif force is None:
                    self._holds[finger] = Hold(world._body(slot), None, touch, touch.at)

        return put

    def let_go(self) -> None:
        """Every finger lets go of what it holds, as before a world is saved: a pull without a finger would stay."""
        for finger in list(self._holds):
            self._let_go(finger)

    def _forget_what_is_gone(self, world: World) -> None:
        for finger, hold in list(self._holds.items()):
            if not hold.lasts or hold.body.world is not world:
                self._let_go(finger)

    def _follow(self, touch: Touch, world: World) -> Iterator[tuple[Body, Touch]]:
        finger, hold = touch.finger, self._holds.get(touch.finger)
        if touch.phase == "began":
            self._let_go(finger)
            body = self._under(touch.at, world)
            if body is not None:
                self._grab(body, touch)
                yield body, touch
        elif hold is not None:
            yield hold.body, touch
            if touch.phase == "ended":
                self._let_go(finger)
        elif touch.phase == "moved":
            body = self._along(touch.previous, touch.at, world)
            if body is not None:
                self._grab(body, touch)
                yield body, replace(touch, phase="began")

    def _grab(self, body: Body, touch: Touch) -> None:
        pull = None
        if body.kind == "dynamic" and not answers(body):
            pull = body.add_force(Pull(touch.at))
        self._holds[touch.finger] = Hold(body, pull, touch, pull.to if pull else touch.at)

    def _let_go(self, finger: Finger) -> None:
        hold = self._holds.pop(finger, None)
        if hold is not None and hold.pull is not None and hold.pull.alive:
            hold.pull.destroy()

    def _under(self, at: Vec2, world: World) -> Body | None:
        """The topmost free body at a point that fingers can hold."""
        found = [body for body in world.bodies_at(at) if self._is_free(body)]
        return found[-1] if found else None

    def _along(self, start: Vec2, end: Vec2, world: World) -> Body | None:
        """The first free body on a finger's way from `start` to `end` that fingers can hold; others are passed over."""
        for _ in range(MOST_CROSSED):
            body = self._under(start, world)  # a ray does not hit what it starts in
            if body is not None:
                return body
            hit = world.ray_cast(start, end)
            if hit is None or self._is_free(hit.body):
                return hit.body if hit else None
            left = end - hit.point
            inside = max(STEP_INSIDE, 1.0e-6 * max(abs(hit.point.x), abs(hit.point.y)))
            if left.length <= inside:
                break
            start = hit.point + left.direction * inside
        return self._under(end, world)

    def _is_free(self, body: Body) -> bool:
        """Whether one more finger may be on it: any number where it answers itself, one where it is pulled."""
        return answers(body) or (body.touchable and all(hold.body != body for hold in self._holds.values()))
