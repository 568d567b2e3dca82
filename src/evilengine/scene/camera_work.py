"""What a camera does by itself: follows, glides, stays within bounds, shakes. It moves once a step, after the world."""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Protocol, cast

from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.tick import STEP
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine.scene.camera import Camera

LONGEST = 3600.0  # seconds that a glide, a shake or a smoothing may take
WIDEST_SHAKE = 1000.0  # logical points

# Swings a second of a shake, across and down: fast enough to rattle, and in no simple ratio, so no figure is drawn.
SWINGS = (11.0, 13.7)

Area = tuple[float, float, float, float]
"""Left, bottom, right, top; metres."""


class Followed(Protocol):
    """What a camera can follow: bodies and characters."""

    @property
    def position(self) -> Vec2:
        """Where it is."""

    @property
    def alive(self) -> bool:
        """Whether it is still there."""


@dataclass(frozen=True, slots=True)
class Following:
    """Who is followed, and how."""

    target: Followed
    dead_zone: tuple[float, float]
    smoothing: float
    offset: Vec2


@dataclass(frozen=True, slots=True)
class Gliding:
    """On the way from one view to another: position, zoom, angle."""

    start: tuple[Vec2, float, float]
    end: tuple[Vec2, float, float]
    steps: int
    passed: int = 0


@dataclass(frozen=True, slots=True)
class Shaking:
    """How far it still shakes."""

    strength: float
    steps: int
    passed: int = 0


class CameraWork:
    """The part of a camera that moves by itself."""

    __slots__ = ("_before", "_bounds", "_following", "_gliding", "_shaking")
    _bounds: Area | None
    _following: Following | None
    _gliding: Gliding | None
    _shaking: Shaking | None
    _before: tuple[Vec2, float, float] | None

    @known_keywords
    def follow(
        self,
        target: Followed | None,
        *,
        dead_zone: Point = (0.0, 0.0),
        smoothing: float = 0.15,
        offset: Point = (0.0, 0.0),
        jump: bool = False,
    ) -> None:
        """Keep a body or a character in sight from now on; None follows nobody any more.

        It may move freely in a `dead_zone` so many metres wide and high round the middle of the screen. Beyond, the
        camera comes after it, most of the way in `smoothing` seconds; 0 keeps it exactly there. `offset` metres from it
        is what is looked at, as to see more of the way ahead. `jump=True` is there at once.

        >>> from evilengine.scene import Camera
        >>> camera = Camera((960, 540)); world = evil.World(gravity=(0, 0))
        >>> hero = world.add(evil.Circle(0.5), at=(10, 0))
        >>> camera.follow(hero, dead_zone=(4, 4), jump=True); camera.position
        Vec2(8.0, 0.0)
        """
        owner = "Camera.follow"
        if target is None:
            self._following = None
            return
        if not (hasattr(target, "position") and hasattr(target, "alive")):
            raise ArgumentTypeError(f"{owner}: target={target!r} must be a body or a character, or None")
        width, height = to_vec2(dead_zone, owner, "dead_zone")
        zone = (
            number(width, owner, "dead_zone", least=0.0, most=1e6),
            number(height, owner, "dead_zone", least=0.0, most=1e6),
        )
        lag = number(smoothing, owner, "smoothing", least=0.0, most=LONGEST)
        following = Following(target, zone, lag, to_vec2(offset, owner, "offset"))
        target.position  # noqa: B018  (raises for one that is gone)
        self._following = following
        if jump:
            camera = cast("Camera", self)
            camera.position = _kept_within(camera, camera.position + _too_far(camera, following))

    @property
    def following(self) -> Followed | None:
        """Who is followed; None once it is gone."""
        return self._following.target if self._following is not None and self._following.target.alive else None

    @property
    def bounds(self) -> Area | None:
        """What of the world may be seen: left, bottom, right, top in metres, or None for all of it.

        The camera stays within it from step to step; where the screen shows more, it stays in the middle.
        """
        return self._bounds

    @bounds.setter
    def bounds(self, value: Iterable[float] | None) -> None:
        if value is None:
            self._bounds = None
            return
        try:
            left, bottom, right, top = value
        except (TypeError, ValueError):
            raise ArgumentTypeError(f"Camera: bounds={value!r} must be left, bottom, right, top in metres") from None
        sides = [number(side, "Camera", "bounds", least=-1e7, most=1e7) for side in (left, bottom, right, top)]
        if not (sides[0] < sides[2] and sides[1] < sides[3]):
            raise ArgumentError(
                f"Camera: bounds={value!r} must be left, bottom, right, top: left < right, bottom < top"
            )
        self._bounds = (sides[0], sides[1], sides[2], sides[3])
        camera = cast("Camera", self)
        camera.position = _kept_within(camera, camera.position)

    @known_keywords
    def glide(
        self,
        position: Point | None = None,
        *,
        zoom: float | None = None,
        angle: float | None = None,
        seconds: float = 0.5,
    ) -> None:
        """Go to another view in that time, softly; what is left out stays as it is. It follows nobody meanwhile.

        >>> from evilengine.scene import Camera
        >>> camera = Camera((960, 540)); camera.glide((4, 0), zoom=2, seconds=1.0)
        >>> for _ in range(30): camera.step()
        >>> camera.position, camera.zoom
        (Vec2(2.0, 0.0), 1.5)
        """
        from evilengine.scene.camera import Camera

        camera, owner = cast(Camera, self), "Camera.glide"
        there = Camera(  # which checks them
            position=camera.position if position is None else position,
            zoom=camera.zoom if zoom is None else zoom,
            angle=camera.angle if angle is None else angle,
        )
        steps = round(number(seconds, owner, "seconds", above=0.0, most=LONGEST) / STEP)
        self._gliding = Gliding(_view(camera), _view(there), max(steps, 1))

    @known_keywords
    def shake(self, strength: float = 10.0, *, seconds: float = 0.4) -> None:
        """Rattle the picture, at first by `strength` logical points, until it has died away after `seconds`.

        Only the picture: what is under the pointer stays where it is. A weaker shake does not end a stronger one.
        """
        owner = "Camera.shake"
        wanted = number(strength, owner, "strength", least=0.0, most=WIDEST_SHAKE)
        steps = max(round(number(seconds, owner, "seconds", above=0.0, most=LONGEST) / STEP), 1)
        if wanted >= _reach(self._shaking, 0.0):
            self._shaking = Shaking(wanted, steps)

    def step(self) -> None:
        """Move by one step of the world, after it; the game does."""
        camera = cast("Camera", self)
        self._before = _view(camera)
        gliding, following = self._gliding, self._following
        if gliding is not None:
            gliding = replace(gliding, passed=gliding.passed + 1)
            part = gliding.passed / gliding.steps
            eased = part * part * (3.0 - 2.0 * part)
            (at, zoom, angle), (to, to_zoom, to_angle) = gliding.start, gliding.end
            camera._position = at + (to - at) * eased
            camera._zoom, camera._angle = zoom + (to_zoom - zoom) * eased, angle + (to_angle - angle) * eased
            self._gliding = gliding if gliding.passed < gliding.steps else None
        elif following is not None and following.target.alive:
            # A decay by backward Euler: plain arithmetic, where an exponential would differ from machine to machine.
            camera._position = camera._position + _too_far(camera, following) * (STEP / (STEP + following.smoothing))
        camera._position = _kept_within(camera, camera._position)
        if self._shaking is not None:
            shaking = replace(self._shaking, passed=self._shaking.passed + 1)
            self._shaking = shaking if shaking.passed < shaking.steps else None

    def _rest(self) -> None:
        """Do nothing by itself any more."""
        self._bounds = self._following = self._gliding = self._shaking = self._before = None

    def _shown(self, alpha: float) -> tuple[Vec2, float, float]:
        """Position, zoom and angle between the last two steps."""
        camera = cast("Camera", self)
        if self._before is None or alpha >= 1.0:
            return _view(camera)
        (at, zoom, angle), (to, to_zoom, to_angle) = self._before, _view(camera)
        return at + (to - at) * alpha, zoom + (to_zoom - zoom) * alpha, angle + (to_angle - angle) * alpha

    def _rattle(self, alpha: float) -> tuple[float, float]:
        """How far the shake moves the picture, in logical points."""
        if self._shaking is None:
            return (0.0, 0.0)
        reach, time = _reach(self._shaking, alpha), (self._shaking.passed + alpha) * STEP
        return (
            reach * math.cos(2.0 * math.pi * SWINGS[0] * time),
            reach * math.sin(2.0 * math.pi * SWINGS[1] * time + 1.0),
        )

    # Saving -----------------------------------------------------------------------------------------------------------

    def _work_state(self) -> dict[str, Any]:
        following, gliding, shaking = self._following, self._gliding, self._shaking
        followed = None
        if following is not None and following.target.alive:
            body: Any = getattr(following.target, "body", following.target)
            followed = [body.slot, list(following.dead_zone), following.smoothing, list(following.offset)]
        return {
            "bounds": self._bounds and list(self._bounds),
            "following": followed,
            "gliding": gliding
            and [[list(at), zoom, angle] for at, zoom, angle in (gliding.start, gliding.end)]
            + [gliding.steps, gliding.passed],
            "shaking": shaking and [shaking.strength, shaking.steps, shaking.passed],
        }


def _view(camera: Camera) -> tuple[Vec2, float, float]:
    return camera._position, camera._zoom, camera._angle


def _reach(shaking: Shaking | None, alpha: float) -> float:
    """How far a shake goes at that moment: less and less, and softly out."""
    if shaking is None:
        return 0.0
    left = max(0.0, 1.0 - (shaking.passed + alpha) / shaking.steps)
    return shaking.strength * left * left


def _too_far(camera: Camera, following: Following) -> Vec2:
    """How far what is followed is beyond the dead zone, whose sides are the screen's."""
    away = (following.target.position + following.offset - camera._position).turned(-camera._angle)
    width, height = following.dead_zone
    beyond = Vec2(_beyond(away.x, width / 2), _beyond(away.y, height / 2))
    return beyond.turned(camera._angle)


def _beyond(away: float, half: float) -> float:
    return math.copysign(max(abs(away) - half, 0.0), away)


def _kept_within(camera: Camera, position: Vec2) -> Vec2:
    """The place nearest to `position` from which nothing beyond the bounds is seen."""
    if camera._bounds is None:
        return position
    left, bottom, right, top = camera._bounds
    c, s = abs(math.cos(camera._angle)), abs(math.sin(camera._angle))
    width, height = (side / camera.points_a_metre for side in camera.size)
    across, up = 0.5 * (c * width + s * height), 0.5 * (s * width + c * height)
    return Vec2(_between(position.x, left + across, right - across), _between(position.y, bottom + up, top - up))


def _between(value: float, least: float, most: float) -> float:
    return 0.5 * (least + most) if least > most else min(max(value, least), most)


def read_work(state: dict[str, Any], bodies: Container[int]) -> Callable[[Camera, Callable[[int], Followed]], None]:
    """Read what `_work_state` gave, checked by the same doors, and return what puts it on a camera.

    Raises ValueError, TypeError, KeyError or an Error of ours for what is none.
    """
    from evilengine.scene.camera import Camera

    read = Camera()
    read.bounds = state["bounds"]
    gliding, shaking, followed = state["gliding"], state["shaking"], state["following"]
    if gliding is not None:
        *ends, steps, passed = gliding
        views = [_view(Camera(position=at, zoom=zoom, angle=angle)) for at, zoom, angle in ends]
        read._gliding = Gliding(views[0], views[1], *_counted(steps, passed))
    if shaking is not None:
        strength, steps, passed = shaking
        read._shaking = Shaking(number(strength, "camera", "strength", least=0.0), *_counted(steps, passed))
    if followed is not None:
        slot, zone, smoothing, offset = followed
        if slot not in bodies:
            raise ValueError("a camera that follows what is not there")
        read.follow(_Nobody(), dead_zone=zone, smoothing=smoothing, offset=offset)

    def put(camera: Camera, body: Callable[[int], Followed]) -> None:
        camera._rest()
        camera._bounds, camera._gliding, camera._shaking = read._bounds, read._gliding, read._shaking
        if followed is not None and read._following is not None:
            camera._following = replace(read._following, target=body(followed[0]))

    return put


class _Nobody:
    """Stands for a body until it is there."""

    position = Vec2(0.0, 0.0)
    alive = True


def _counted(steps: Any, passed: Any) -> tuple[int, int]:
    if not (isinstance(steps, int) and isinstance(passed, int) and 0 <= passed < steps):
        raise ValueError("a camera in the middle of what is over")
    return steps, passed
