"""The values of a joint that may be read and changed at any time, before it is added and after.

Each is kept where the core keeps it: in the joint's specification until it is added, in its row from then on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from evilengine.values.checks import number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2, to_vec2
from evilengine.world.arguments import WORLD_EDGE, place

if TYPE_CHECKING:
    from evilengine.world.joints.joint import Joint

NO_LIMIT = 1e30
"""What the core takes for a force that is never reached."""

MOST_FORCE = 1e18
"""Newtons or newton metres: the greatest that can be asked for."""

MOST_HERTZ = 1e4


def greatest(
    value: float | None, owner: str, argument: str, *, above: float | None = None, least: float | None = None
) -> float:
    """A greatest force as the core takes it: None is no limit."""
    if value is None:
        return NO_LIMIT
    return number(value, owner, argument, above=above, least=least, most=MOST_FORCE)


def or_none(value: float) -> float | None:
    return None if value >= NO_LIMIT else value


class Amount:
    """A number of a joint that may be read and changed at any time."""

    def __init__(self, field: str, doc: str, *, least: float | None = None, most: float = MOST_FORCE) -> None:
        self.field, self.least, self.most, self.__doc__ = field, least, most, doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, joint: Joint | None, owner: type) -> Any:
        return self if joint is None else getattr(joint._fields, self.field)

    def __set__(self, joint: Joint, value: float) -> None:
        setattr(
            joint._fields, self.field, number(value, type(joint).__name__, self.name, least=self.least, most=self.most)
        )


class Greatest:
    """The greatest force or torque of a part of a joint; None for as much as it takes."""

    def __init__(self, field: str, doc: str) -> None:
        self.field, self.__doc__ = field, doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, joint: Joint | None, owner: type) -> Any:
        return self if joint is None else or_none(getattr(joint._fields, self.field))

    def __set__(self, joint: Joint, value: float | None) -> None:
        setattr(joint._fields, self.field, greatest(value, type(joint).__name__, self.name, least=0.0))


class MotorSpeed:
    """The speed that a motor keeps; None: there is no motor."""

    def __init__(self, drive: str, doc: str) -> None:
        self.motor, self.speed, self.__doc__ = f"{drive}_motor", f"{drive}_speed", doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, joint: Joint | None, owner: type) -> Any:
        if joint is None:
            return self
        return getattr(joint._fields, self.speed) if getattr(joint._fields, self.motor) else None

    def __set__(self, joint: Joint, value: float | None) -> None:
        speed = 0.0 if value is None else number(value, type(joint).__name__, self.name, least=-1e5, most=1e5)
        setattr(joint._fields, self.speed, speed)
        setattr(joint._fields, self.motor, value is not None)


class Limits:
    """The least and the greatest of a coordinate, as a pair; None: it is free."""

    def __init__(self, drive: str, doc: str, *, least: float = -WORLD_EDGE) -> None:
        self.limited, self.lower, self.upper = f"{drive}_limited", f"{drive}_lower", f"{drive}_upper"
        self.least, self.__doc__ = least, doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, joint: Joint | None, owner: type) -> Any:
        if joint is None:
            return self
        fields = joint._fields
        return (getattr(fields, self.lower), getattr(fields, self.upper)) if getattr(fields, self.limited) else None

    def __set__(self, joint: Joint, value: tuple[float, float] | None) -> None:
        lower, upper = (0.0, 0.0) if value is None else self._checked(value, type(joint).__name__)
        setattr(joint._fields, self.lower, lower)
        setattr(joint._fields, self.upper, upper)
        setattr(joint._fields, self.limited, value is not None)

    def _checked(self, value: Any, owner: str) -> tuple[float, float]:
        try:
            lower, upper = value
        except (TypeError, ValueError):
            raise ArgumentTypeError(f"{owner}: {self.name}={value!r} must be (least, greatest), or None") from None
        lower = number(lower, owner, self.name, least=self.least, most=WORLD_EDGE)
        upper = number(upper, owner, self.name, least=self.least, most=WORLD_EDGE)
        if lower > upper:
            raise ArgumentError(f"{owner}: {self.name}={value!r} must have the smaller number first")
        return lower, upper


def place_or_none(value: Point | None, owner: str, argument: str) -> Vec2 | None:
    return None if value is None else place(value, owner, argument)


def direction(value: Point, owner: str) -> Vec2:
    axis = to_vec2(value, owner, "axis")
    if not axis.length > 0.0:
        raise ArgumentError(f"{owner}: axis={value!r} must have a direction, such as (1, 0)")
    return axis.direction


def to_ratio(value: float, owner: str) -> float:
    ratio = number(value, owner, "ratio", least=-1e3, most=1e3)
    if abs(ratio) < 1e-3:
        raise ArgumentError(f"{owner}: ratio={value!r} must be at least 0.001 away from 0")
    return ratio
