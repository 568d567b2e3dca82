"""Emitter: the handle of a particle effect: sparks, smoke, dust, rain (SPEC G8)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from evilengine import _core
from evilengine.scene.animated import BLENDS
from evilengine.scene.camera import FARTHEST, Matrix6
from evilengine.scene.drawing import to_layer
from evilengine.values.checks import known_keywords, number, one_of, refuse_unknown
from evilengine.values.colour import Colour, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError, StaleReferenceError
from evilengine.values.tick import STEP
from evilengine.values.vec2 import Vec2, to_vec2
from evilengine.world.body import Body

if TYPE_CHECKING:
    from evilengine.scene.scene import Scene

T = TypeVar("T")

MOST = 1 << 20
"""Particles that one emitter may have alive (kMost in core/particles/particles.hpp)."""

FASTEST, LONGEST, LARGEST = 1e4, 1e4, 1e4  # m/s, seconds, metres: beyond lies a slip in units


class Setting(Generic[T]):
    """One thing to set about an emitter: checked when it is set, and told to the core."""

    def __init__(self, check: Callable[[Any, str], T], default: Any, doc: str) -> None:
        self.check, self.default, self.__doc__ = check, default, doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, emitter: None, owner: type) -> Setting[T]: ...
    @overload
    def __get__(self, emitter: Emitter, owner: type) -> T: ...
    def __get__(self, emitter: Emitter | None, owner: type) -> Any:
        if emitter is None:
            return self
        emitter._require()
        return emitter._values[self.name]

    def __set__(self, emitter: Emitter, value: Any) -> None:
        emitter._require()
        emitter._set({self.name: self.check(value, "Emitter")})


def _number(name: str, least: float, most: float) -> Callable[[Any, str], float]:
    return lambda value, owner: number(value, owner, name, least=least, most=most)


def _switch(name: str) -> Callable[[Any, str], bool]:
    def check(value: Any, owner: str) -> bool:
        if not isinstance(value, bool):
            raise ArgumentTypeError(f"{owner}: {name}={value!r} must be True or False")
        return value

    return check


def _whole(name: str, least: int, most: int) -> Callable[[Any, str], int]:
    def check(value: Any, owner: str) -> int:
        if isinstance(value, bool) or not isinstance(value, int):
            raise ArgumentTypeError(f"{owner}: {name}={value!r} must be a whole number")
        return int(number(value, owner, name, least=least, most=most))

    return check


def _range(name: str, least: float, most: float) -> Callable[[Any, str], tuple[float, float]]:
    """A number, or (least, most), between which each particle has its own."""

    def check(value: Any, owner: str) -> tuple[float, float]:
        pair = value if isinstance(value, (tuple, list)) else (value, value)
        if len(pair) != 2:
            raise ArgumentTypeError(f"{owner}: {name}={value!r} must be a number, or two: the least and the most")
        low, high = (number(each, owner, name, least=least, most=most) for each in pair)
        if low > high:
            raise ArgumentError(f"{owner}: {name}={value!r} must be the least and then the most")
        return low, high

    return check


def _curve(name: str, least: float, most: float) -> Callable[[Any, str], tuple[float, ...]]:
    """A number, or a list of them over a life."""

    def check(value: Any, owner: str) -> tuple[float, ...]:
        knots = value if isinstance(value, (tuple, list)) else (value,)
        _refuse_count(knots, value, owner, name)
        return tuple(number(each, owner, name, least=least, most=most) for each in knots)

    return check


def _colours(value: Any, owner: str) -> tuple[Colour, ...]:
    knots: Sequence[Any] = value if isinstance(value, list) else [value]
    if isinstance(value, tuple) and not isinstance(value, Colour) and any(isinstance(each, str) for each in value):
        knots = value
    _refuse_count(knots, value, owner, "colour")
    return tuple(to_colour(each, owner, "colour") for each in knots)


def _refuse_count(knots: Sequence[Any], value: Any, owner: str, name: str) -> None:
    if not 1 <= len(knots) <= _core.KNOTS:
        raise ArgumentError(f"{owner}: {name}={value!r} must be 1 to {_core.KNOTS} values over a life")


def _area(value: Any, owner: str) -> float | Vec2:
    if isinstance(value, (tuple, list)):
        size = to_vec2(value, owner, "area")
        number(min(size), owner, "area", least=0.0)
        number(max(size), owner, "area", most=LARGEST)
        return size
    return number(value, owner, "area", least=0.0, most=LARGEST)


def _place(value: Any, owner: str) -> Vec2:
    point = to_vec2(value, owner, "at")
    number(max(abs(point.x), abs(point.y)), owner, "at", most=FARTHEST)
    return point


def _wind(value: Any, owner: str) -> Vec2:
    wind = to_vec2(value, owner, "wind")
    number(max(abs(wind.x), abs(wind.y)), owner, "wind", most=FASTEST)
    return wind


def _blend(value: Any, owner: str) -> str:
    return one_of(value, owner, "blend", BLENDS)


def _image(value: Any, owner: str) -> str | None:
    if value is None or isinstance(value, str):
        return value
    raise ArgumentTypeError(f"{owner}: texture={value!r} must be the name of an image, such as 'leaf.png', or None")


class Emitter:
    """What lets particles go, and those that it has let go: `game.add_particles(...)` makes one.

    Everything it was made with can be set again at any time, and holds for the particles that are there too, but for
    what they got when they were born: place, direction, `speed`, `life`, `spin`, `size_varies`. What is given as a list
    is a curve over a particle's life, its values evenly spread from birth to death. Particles touch bodies and are not
    felt by them.

    >>> game = evil.Game(headless=True)
    >>> sparks = game.add_particles(at=(0, 2), rate=60, life=0.5, speed=(2, 4), colour=["white", "orange", "#f000"])
    >>> game.step(30)
    >>> sparks.count
    30
    >>> sparks.rate = 0; sparks.burst(100); sparks.count
    130
    >>> game.step(40); sparks.count
    0
    """

    at = Setting(_place, (0.0, 0.0), "Where they are born, in metres: in the world, or on the body that it follows.")
    area = Setting(_area, 0.0, "How far round `at`: the radius of a disc, or (width, height) of a rectangle; metres.")
    rate = Setting(_number("rate", least=0.0, most=1e7), 0.0, "How many are born a second.")
    direction = Setting(
        _number("direction", least=-1e6, most=1e6), math.pi / 2, "Which way they fly: radians, 0 is right, pi/2 up."
    )
    cone = Setting(_number("cone", least=0.0, most=2 * math.pi), 0.5, "How wide they fan out, radians; 2 pi: all ways.")
    speed = Setting(_range("speed", least=0.0, most=FASTEST), 1.0, "m/s at birth: one number, or (least, most).")
    life = Setting(_range("life", least=0.01, most=LONGEST), 1.0, "Seconds: one number, or (least, most).")
    size = Setting(_curve("size", least=0.0, most=LARGEST), 0.1, "Metres across, or a list of them over a life.")
    size_varies = Setting(_number("size_varies", least=0.0, most=1.0), 0.0, "How much smaller some are: 0 to 1.")
    colour = Setting(_colours, "white", "A colour, or a list of colours over a life; alpha lets them fade.")
    pace = Setting(_curve("pace", least=0.0, most=100.0), 1.0, "Factor of their speed, or a list of them over a life.")
    gravity_scale = Setting(
        _number("gravity_scale", least=-1e3, most=1e3), 1.0, "How much of the world's gravity they feel; -1: they rise."
    )
    drag = Setting(_number("drag", least=0.0, most=1e3), 0.0, "How fast they take on the speed of `wind`, a second.")
    wind = Setting(_wind, (0.0, 0.0), "Velocity of the air, m/s; it is felt by `drag`.")
    spin = Setting(_range("spin", least=-1e4, most=1e4), 0.0, "How fast those with a texture turn, radians a second.")
    collide = Setting(_switch("collide"), False, "Do they run into bodies?")
    bounce = Setting(_number("bounce", least=0.0, most=1.0), 0.3, "Share of the speed kept when they do.")
    friction = Setting(_number("friction", least=0.0, most=10.0), 0.4, "What slows those that slide along a body.")
    dies = Setting(_switch("dies"), False, "Do they end where they touch a body?")
    mask = Setting(_whole("mask", 0, 0xFFFFFFFF), 0xFFFFFFFF, "Categories of the shapes that they touch, as bits.")
    most = Setting(_whole("most", 1, MOST), 10_000, "How many may be alive; who comes later is not born.")
    soft = Setting(_switch("soft"), True, "Do they fade towards their rim? Otherwise they are discs.")
    lit = Setting(_switch("lit"), False, "Do they take the light of where they are?")
    blend = Setting(
        _blend, "normal", "How they meet what is behind, as with drawings: 'normal', 'add', 'multiply', 'screen'."
    )
    stretch = Setting(
        _number("stretch", least=0.0, most=10.0), 0.0, "Seconds of its way that each is drawn long, as sparks and rain."
    )
    once = Setting(_switch("once"), False, "Is it destroyed with the last of its particles? For a single burst.")
    texture = Setting(_image, None, "The name of an image to draw in place of round specks, or None.")
    layer = Setting(lambda value, owner: to_layer(value, owner), 0, "They lie over the drawings of this layer.")

    __slots__ = ("_alive", "_body", "_core", "_scene", "_serial", "_values")

    def __init__(self, scene: Scene, serial: int, seed: int, body: Body | None, options: dict[str, Any]) -> None:
        owner = "Game.add_particles"
        refuse_unknown(owner, [*SETTINGS, "body", "burst", "running"], options)
        if body is not None:
            _refuse_body(scene, body, owner)
        checked = {name: each.check(options.get(name, each.default), owner) for name, each in SETTINGS.items()}
        self._alive = True
        self._scene, self._serial, self._body = scene, serial, body
        self._core = _core.Emitter()
        self._core.seed(seed)
        self._values: dict[str, Any] = {}
        self._set(checked)

    @property
    def alive(self) -> bool:
        """False once it was destroyed; or its body was, and the last of its particles is gone."""
        return self._alive

    @property
    def body(self) -> Body | None:
        """The body that it follows, or None. When that is destroyed, what was let go of lives on."""
        self._require()
        return self._body

    @property
    def count(self) -> int:
        """How many particles are alive."""
        self._require()
        return self._core.count

    @property
    def running(self) -> bool:
        """Are particles born at its rate? Set it to False for a break; `burst` works all the same."""
        self._require()
        return self._core.running

    @running.setter
    def running(self, on: bool) -> None:
        self._require()
        self._core.running = _switch("running")(on, "Emitter")

    @property
    def positions(self) -> list[Vec2]:
        """Where the particles are, from the oldest to the youngest."""
        self._require()
        return [Vec2(*each) for each in self._core.positions()]

    @property
    def velocities(self) -> list[Vec2]:
        """How fast they fly, in m/s, in the same order."""
        self._require()
        return [Vec2(*each) for each in self._core.velocities()]

    @known_keywords
    def burst(self, count: int) -> None:
        """Let go of so many at once; as many as `most` leaves room for."""
        self._require()
        self._core.burst(self._scene.world._core, _whole("count", 0, MOST)(count, "Emitter.burst"))

    def clear(self) -> None:
        """Take away the particles that are there; new ones are born as before."""
        self._require()
        self._core.clear()

    def destroy(self) -> None:
        """Take it away, with all its particles at once. To let them live to their end, set `rate` to 0."""
        self._require()
        self._scene._emitters.remove(self)
        self._alive = False

    def __repr__(self) -> str:
        return f"<Emitter of {self._core.count} particles>" if self._alive else "<Emitter, destroyed>"

    # What the scene does with it ---------------------------------------------------------------------------------

    def _step(self) -> None:
        self._core.step(self._scene.world._core, STEP)
        left_alone = self.once or (self._body is not None and not self._body.alive)
        if left_alone and not self._core.count:
            self.destroy()

    def _collect(self, view: Matrix6, alpha: float, screen: tuple[int, int]) -> None:
        if self._core.count:
            self._core.collect(self._scene._core, view, alpha, STEP, screen)

    def _require(self) -> None:
        if not self._alive:
            raise StaleReferenceError(
                "this Emitter was destroyed; keep no reference past destroy(), or ask emitter.alive first"
            )

    def _set(self, checked: dict[str, Any]) -> None:
        """Take over values that were checked. An image that cannot be had leaves everything as it was."""
        v = {**self._values, **checked}
        texture = self._scene.texture_id(v["texture"], "Emitter")
        area = v["area"]
        self._core.define(
            body=None if self._body is None else (self._body.slot, self._body.generation),
            half=(area.x / 2, area.y / 2) if isinstance(area, Vec2) else (0.0, 0.0),
            radius=0.0 if isinstance(area, Vec2) else area,
            varies=v["size_varies"], collides=v["collide"],
            **{name: v[name] for name in _AS_THEY_ARE},
        )  # fmt: skip
        self._core.show(
            size=_sampled(v["size"]), pace=_sampled(v["pace"]), colour=_sampled_colours(v["colour"]),
            soft=v["soft"], blend=BLENDS.index(v["blend"]), lit=v["lit"], stretch=v["stretch"], texture=texture,
            layer=v["layer"],
        )  # fmt: skip
        self._values = v

    # Saving ------------------------------------------------------------------------------------------------------

    def _state(self) -> dict[str, Any]:
        body = None if self._body is None else self._body.slot if self._body.alive else _core.NO_SLOT
        return {
            "serial": self._serial, "body": body, "running": self._core.running,
            "settings": {name: _plain(value) for name, value in self._values.items()},
        }  # fmt: skip


SETTINGS: dict[str, Setting[Any]] = {name: each for name, each in vars(Emitter).items() if isinstance(each, Setting)}
"""What an emitter can be told, by name."""

_AS_THEY_ARE = (
    "at", "direction", "cone", "rate", "life", "speed", "spin", "gravity_scale", "drag", "wind", "dies", "bounce",
    "friction", "mask", "most",
)  # fmt: skip


def _refuse_body(scene: Scene, body: Any, owner: str) -> None:
    if not isinstance(body, Body):
        raise ArgumentTypeError(f"{owner}: body={body!r} must be a Body that it follows, or None")
    body._require()
    if body.world is not scene.world:
        raise ArgumentError(f"{owner}: {body!r} lives in another world than the one that this game shows")


def _plain(value: Any) -> Any:
    return [_plain(each) for each in value] if isinstance(value, tuple) else value


def _sampled(knots: Sequence[float]) -> list[float]:
    """A curve as the core's table: straight lines between its values."""
    last = len(knots) - 1
    table = []
    for i in range(_core.KNOTS):
        at = last * i / (_core.KNOTS - 1)
        low = min(int(at), max(last - 1, 0))
        high = min(low + 1, last)
        table.append(knots[low] + (knots[high] - knots[low]) * (at - low))
    return table


def _sampled_colours(knots: Sequence[Colour]) -> list[int]:
    return [Colour(*parts).rgba8 for parts in zip(*(_sampled(part) for part in zip(*knots, strict=True)), strict=True)]


class EmittersState:
    """The emitters of a saved game, read and found sound; nothing has changed before `put`."""

    def __init__(self, scene: Scene, rows: list[dict[str, Any]], particles: list[bytes], bodies: set[int]) -> None:
        self._scene = scene
        self._rows: list[tuple[dict[str, Any], dict[str, Any], bytes]] = []
        if len(rows) != len(particles):
            raise ValueError("particles for each emitter")
        for row, data in zip(rows, particles, strict=True):
            if row["body"] not in (None, _core.NO_SLOT) and row["body"] not in bodies:
                raise ValueError("an emitter on what is not there")
            options = {name: _of_plain(name, value) for name, value in row["settings"].items()}
            trial = Emitter(scene, 0, 0, None, options)  # raises what is wrong with it
            trial._core.restore(data)
            self._rows.append((row, options, data))

    @property
    def serials(self) -> set[int]:
        """The serial numbers of the emitters that there will be."""
        return {int(row["serial"]) for row, _, _ in self._rows}

    def emitter(self, serial: int) -> Emitter:
        """The emitter of that number, after `put`."""
        return next(emitter for emitter in self._scene._emitters if emitter._serial == serial)

    def put(self, body_of: Callable[[int], Body]) -> None:
        """Become what was saved; the world must have been restored. Handles of the same emitters stay good."""
        scene = self._scene
        known = {emitter._serial: emitter for emitter in scene._emitters}
        scene._emitters = []
        for row, options, data in self._rows:
            emitter = known.pop(row["serial"], None) or Emitter(scene, row["serial"], 0, None, {})
            emitter._body = None if row["body"] in (None, _core.NO_SLOT) else body_of(row["body"])
            emitter._set(
                {name: each.check(options.get(name, each.default), "Emitter") for name, each in SETTINGS.items()}
            )
            emitter._core.restore(data)
            emitter._core.running = bool(row["running"]) and row["body"] != _core.NO_SLOT
            scene._emitters.append(emitter)
        for emitter in known.values():
            emitter._alive = False


def _of_plain(name: str, value: Any) -> Any:
    return [Colour(*each) for each in value] if name == "colour" else value


def add_particles(scene: Scene, seed: int, body: Body | None, options: dict[str, Any]) -> Emitter:
    """One more emitter of the scene, which lets go of `burst` particles at once."""
    owner = "Game.add_particles"
    running = _switch("running")(options.pop("running", True), owner)
    burst = _whole("burst", 0, MOST)(options.pop("burst", 0), owner)
    emitter = Emitter(scene, scene._emitters_made, seed, body, options)
    scene._emitters_made += 1
    scene._emitters.append(emitter)
    emitter._core.running = running
    emitter.burst(burst)
    return emitter
