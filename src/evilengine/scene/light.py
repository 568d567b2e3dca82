"""Light: the handle of one thing that shines (SPEC G5)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.checks import number, switch
from evilengine.values.colour import Colour, ColourLike, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError, StaleReferenceError
from evilengine.values.temperature import COLDEST, HOTTEST, linear_of
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine.scene.lights import Lights
    from evilengine.world.body import Body

FARTHEST = 1e7  # metres: the edge of the world
WIDEST_CONE = 2 * math.pi

LIMITS: dict[str, tuple[float, float]] = {
    "angle": (-1e6, 1e6),
    "cone": (0.01, WIDEST_CONE),
    "edge": (0.0, 1.0),
    "radius": (0.01, 1e5),
    "size": (0.0, 1e4),
    "falloff": (0.0, 60.0),
    "intensity": (0.0, 1e3),
}
"""The least and the most of what a light has in numbers."""


class _Field:
    """A property of a light that the core keeps as it is; `check` is given what it is set to, and its name."""

    def __init__(self, doc: str, check: Callable[[Any, str], object], core_name: str = "") -> None:
        self.__doc__ = doc
        self._check = check
        self._core_name = core_name

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name
        known = self._core_name or name
        self._get: Callable[..., Any] = getattr(_core.Lights, known)
        self._set: Callable[..., None] = getattr(_core.Lights, f"set_{known}")

    def __get__(self, light: Light | None, owner: type) -> Any:
        return self if light is None else self._get(light._lights._core, *light._where())

    def __set__(self, light: Light, value: Any) -> None:
        self._set(light._lights._core, *light._where(), self._check(value, self._name))


def _number(value: float, name: str) -> float:
    least, most = LIMITS[name]
    return number(value, "Light", name, least=least, most=most)


def _switch(value: bool, name: str) -> bool:
    return switch(value, "Light", name)


class Light:
    """A lamp, a spot or a sun: `game.add_light` makes them, and everything about it may change at any time.

    Once it is destroyed, or the body that it is on, every use raises StaleReferenceError; `alive` asks first.

    >>> game = evil.Game(headless=True)
    >>> lamp = game.add_light(at=(0, 5), colour="orange", radius=6)
    >>> lamp.at = (1, 5); lamp.intensity = 2
    >>> lamp.kind, lamp.position
    ('lamp', Vec2(1.0, 5.0))
    >>> lamp.destroy(); lamp.alive
    False
    """

    __slots__ = ("__weakref__", "_generation", "_lights", "_slot")

    def __init__(self, lights: Lights, slot: int, generation: int) -> None:
        self._lights = lights
        self._slot, self._generation = slot, generation

    radius = _Field("Metres from its middle to where its light ends. A sun has no end.", _number)
    size = _Field(
        "Metres from its middle to its rim: the larger it is, the softer are its shadows. Of a sun: how far, a metre"
        " behind what casts it, a shadow is soft to either side.",
        _number,
    )
    intensity = _Field("How bright it is: at 1, what lies in its middle is as bright as its colour says.", _number)
    falloff = _Field(
        "How fast it fades: at distance d the light is (1 - d / radius) ** falloff. 0 keeps it whole up to its"
        " radius; kept in quarters.",
        _number,
    )
    angle = _Field("Radians: where a spot or a sun shines to, seen from its body if it is on one.", _number)
    cone = _Field("Radians: the opening of a spot, from side to side.", _number)
    edge = _Field("The share of a spot's opening, 0..1, in which it fades towards the sides.", _number)
    on = _Field("Does it shine?", _switch)
    shadows = _Field("Do bodies cast shadows in it? Without, it also shines through them.", _switch)
    static = _Field(
        "Does it stand still? What it shows of static bodies is then worked out once and kept, and again when it or one"
        " of them changes. It looks the same and costs less; shadows of what moves fall in it all the same.",
        _switch,
        "still",
    )

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or the body that it is on."""
        body = self._lights._body_of(self._slot, self._generation)
        return self._lights._core.alive(self._slot, self._generation) and (body is None or body.alive)

    @property
    def kind(self) -> str:
        """'lamp': shines all round; 'spot': in a cone; 'sun': from far away, everywhere in one direction."""
        return KINDS[self._lights._core.reach(*self._where())]

    @property
    def body(self) -> Body | None:
        """The body that it moves with, or None."""
        return self._lights._body_of(*self._where())

    @property
    def at(self) -> Vec2:
        """Where it is, in metres: in the world, or on its body."""
        return Vec2(*self._lights._core.at(*self._where()))

    @at.setter
    def at(self, value: Point) -> None:
        slot, generation = self._where()
        self._lights._core.set_at(slot, generation, to_place(value))

    @property
    def position(self) -> Vec2:
        """Where it is in the world."""
        at, body = self.at, self.body
        return at if body is None else body.position + at.turned(body.angle)

    @property
    def colour(self) -> Colour:
        """Its colour, as a white thing in its middle would look."""
        return Colour(*self._lights._core.colour(*self._where()))

    @colour.setter
    def colour(self, value: ColourLike) -> None:
        slot, generation = self._where()
        colour = to_colour(value, "Light", "colour")
        self._lights._core.set_colour(slot, generation, (colour.r, colour.g, colour.b))

    @property
    def temperature(self) -> float | None:
        """Kelvin of what glows, which tints its colour: a candle 1900, a bulb 2700, the noon 5500, the sky 10000."""
        return self._lights._core.temperature(*self._where()) or None

    @temperature.setter
    def temperature(self, value: float | None) -> None:
        slot, generation = self._where()
        kelvin = 0.0 if value is None else number(value, "Light", "temperature", least=COLDEST, most=HOTTEST)
        self._lights._core.set_tint(slot, generation, linear_of(kelvin) if kelvin else (1.0, 1.0, 1.0))
        self._lights._core.set_temperature(slot, generation, kelvin)

    @property
    def texture(self) -> str | None:
        """The name of the image that it shines through, as through a slide or a stained window, or None.

        The image's middle is where the light is, its corners are `radius` away, and it is turned by `angle`. Through a
        sun's it is laid again and again.
        """
        return self._lights._slide_names.get(self._lights._core.slide(*self._where()))

    @texture.setter
    def texture(self, value: str | None) -> None:
        slot, generation = self._where()
        self._lights._core.set_slide(slot, generation, self._lights._slide(value, "Light"))

    @property
    def mask(self) -> int:
        """Which shapes cast shadows in it: those whose `category` has a bit of it."""
        return self._lights._core.mask(*self._where())

    @mask.setter
    def mask(self, value: int) -> None:
        slot, generation = self._where()
        self._lights._core.set_mask(slot, generation, to_mask(value, "Light"))

    def point_to(self, target: Point) -> None:
        """Turn a spot so that it shines on `target`, a point of the world."""
        body, at = self.body, to_vec2(target, "Light.point_to", "target")
        way = at - self.position
        if way == (0.0, 0.0):
            raise ArgumentError(f"Light.point_to: target={target!r} is where the light is; it cannot shine there")
        self.angle = math.atan2(way.y, way.x) - (0.0 if body is None else body.angle)

    def destroy(self) -> None:
        """Let it shine no longer; what it was on stays."""
        self._lights._core.remove(*self._where())

    def _where(self) -> tuple[int, int]:
        if not self.alive:
            raise StaleReferenceError(
                "this Light was destroyed, or went with its body; keep no reference past destroy(), or ask"
                " light.alive first"
            )
        return self._slot, self._generation

    def _key(self) -> tuple[int, int, int]:
        return id(self._lights), self._slot, self._generation

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, Light) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def __repr__(self) -> str:
        if not self.alive:
            return "<Light, destroyed>"
        at = self.position
        return "<Light: a sun>" if self.kind == "sun" else f"<Light: a {self.kind} at ({at.x:g}, {at.y:g})>"


KINDS = {_core.Reach.round: "lamp", _core.Reach.cone: "spot", _core.Reach.parallel: "sun"}


def to_place(value: Point) -> tuple[float, float]:
    """`value` as a point within the world's edge."""
    x, y = to_vec2(value, "Light", "at")
    if max(abs(x), abs(y)) > FARTHEST:
        raise ArgumentError(f"Light: at={value!r} must be at most {FARTHEST:g} metres either way")
    return x, y


def to_mask(value: object, owner: str) -> int:
    """`value` as bits of categories."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise ArgumentTypeError(f"{owner}: mask={value!r} must be a whole number: the bits of categories")
    return int(number(value, owner, "mask", least=0, most=0xFFFFFFFF))
