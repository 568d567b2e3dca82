"""Characters: bodies that walk, jump, climb and push as a player wishes (SPEC P9)."""

from __future__ import annotations

import inspect
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import known_keywords, refuse_unknown
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.arguments import place
from evilengine.world.body import Body
from evilengine.world.shapes import Capsule, ShapeDefinition

if TYPE_CHECKING:
    from evilengine.world.world import World

Area = tuple[float, float, float, float]

ABILITIES = (
    "speed", "acceleration", "deceleration", "air_acceleration", "air_deceleration", "jump_height", "jump_cut",
    "coyote_time", "jump_buffer", "air_jumps", "gravity_scale", "fall_speed", "max_slope", "step_height", "climb_speed",
    "push_force", "mass",
)  # fmt: skip
EVENTS = ("on_land", "on_jump", "on_crush")
NOT_FOR_CHARACTERS = ("kind", "angle", "velocity", "angular_velocity", "restitution")
PUSH = 40.0
"""Newtons a kilogram of the character: what it pushes with when nothing else is said."""


class Character(_core.Character):
    """A body that does as a player wishes: `world.add_character` makes one.

    It walks up slopes and steps and stays on the ground where that falls away; it jumps as high as it can while the
    jump is held and lower when it is let go; a jump that comes a little too early or too late still counts. What moves
    carries it, what stands in its way is pushed, what comes at it pushes it. It goes on doing what it was told until
    it is told something else.

    Its body is `hero.body`: kinematic, so that everything meets it as a thing that moves. It is at
    `hero.position`; abilities are attributes that may change at any time, say `hero.air_jumps = 1`.

    >>> world = evil.World(); floor = world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    >>> hero = world.add_character(at=(0, 1))
    >>> for _ in range(60):
    ...     world.step()
    >>> hero.grounded, hero.ground is floor
    (True, True)
    >>> hero.move(1)
    >>> for _ in range(60):
    ...     world.step()
    >>> hero.velocity.x == hero.speed, hero.position.x > 4
    (True, True)
    """

    def __init__(self, body: Body) -> None:
        super().__init__(body._world._core, body.slot, body.generation)
        self._body = body

    # -- telling it --

    @known_keywords
    def move(self, axis: float) -> None:
        """Walk: -1 to the left, 1 to the right, anything between; 0 to stand. It holds until told otherwise."""
        self._move(axis)

    @known_keywords
    def climb(self, axis: float) -> None:
        """On a ladder, go up (1) or down (-1); 0 holds on. Elsewhere nothing comes of it."""
        self._climb(axis)

    def jump(self) -> None:
        """Jump as soon as it can within `jump_buffer` seconds, and as high as it can unless `let_go` comes first."""
        self._jump()

    def let_go(self) -> None:
        """Hold the jump no longer: on its way up, it rises less high."""
        self._let_go()

    def drop(self) -> None:
        """In the next step, fall through a platform that is solid from above only."""
        self._drop()

    @known_keywords
    def add_ladder(self, area: Iterable[float]) -> None:
        """Let it climb inside `area`: (left, bottom, right, top) in the world.

        >>> hero = evil.World().add_character()
        >>> hero.add_ladder((4, 0, 5, 6)); hero.ladders
        ((4.0, 0.0, 5.0, 6.0),)
        """
        self._add_ladder(*to_area(area, "Character.add_ladder"))

    # -- asking it --

    @property
    def body(self) -> Body:
        """The body that it is in the world."""
        return self._body

    @property
    def position(self) -> Vec2:
        """Where its body is; set it to put it somewhere else."""
        return self._body.position

    @position.setter
    def position(self, value: Point) -> None:
        self._body.position = place(value, "Character", "position")

    @property
    def ground(self) -> Body | None:
        """The body that it stands on."""
        slot = self._ground
        return None if slot == _core.NO_SLOT else self._body._world._body(slot)

    @property
    def ladders(self) -> tuple[Area, ...]:
        """Where it can climb: (left, bottom, right, top) each."""
        return tuple(self._ladders)

    @ladders.setter
    def ladders(self, areas: Iterable[Iterable[float]]) -> None:
        known = to_areas(areas, "Character")
        self._clear_ladders()
        for area in known:
            self._add_ladder(*area)

    # -- events --

    @property
    def on_land(self) -> Callbacks[...]:
        """Decorator: call a function with the speed (m/s) at which it met the ground, when it lands."""
        return self._body._callback("on_land", "speed")

    @property
    def on_jump(self) -> Callbacks[[]]:
        """Decorator: call a function, without arguments, when it jumps."""
        return self._body._callback("on_jump")

    @property
    def on_crush(self) -> Callbacks[[]]:
        """Decorator: call a function, without arguments, when it begins to be crushed."""
        return self._body._callback("on_crush")

    def destroy(self) -> None:
        """Take it and its body out of the world."""
        self._body.destroy()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Character) and other._body == self._body

    def __hash__(self) -> int:
        return hash(self._body)

    def __repr__(self) -> str:
        if not self.alive:
            return "<Character, gone>"
        how = "climbing" if self.climbing else "on the ground" if self.grounded else "in the air"
        return f"<Character {self._body.slot}, {how}, at ({self.position.x:g}, {self.position.y:g})>"


class Cast:
    """What a world knows of its characters."""

    _core: _core.World

    if TYPE_CHECKING:
        add: Any

        def _body(self, slot: int, generation: int | None = None) -> Body: ...
        def _take_back(self, body: Body) -> None: ...

    def add_character(
        self, shape: ShapeDefinition | None = None, *, at: Point = (0.0, 0.0), tag: str | None = None, **options: Any
    ) -> Character:
        """Add a character with its body's origin `at`: a capsule 1.5 m high and 0.6 m wide, or any shape.

        Further words are abilities (`speed`, `jump_height`, `air_jumps`, ...: see Character) and what `add` takes of a
        body that is no mass: `density`, `touchable`, `category`, `mask`, `group`, ... . `ladders` is a list of areas
        (left, bottom, right, top). It weighs what its shape and density say unless `mass` is given, and pushes with 40
        newtons a kilogram unless `push_force` is.

        >>> hero = evil.World().add_character(at=(0, 2), speed=7, jump_height=3, tag="hero")
        >>> hero.speed, hero.body.tag
        (7.0, 'hero')
        """
        me = "World.add_character"
        shape = Capsule((0, -0.45), (0, 0.45), 0.3) if shape is None else shape
        ladders = to_areas(options.pop("ladders", ()), me)
        abilities = {word: options.pop(word) for word in ABILITIES if word in options}
        for word in NOT_FOR_CHARACTERS:
            if word in options:
                raise ArgumentTypeError(
                    f"{me}() got an unknown argument {word}={options[word]!r}; a character has none"
                )
        known = _BODY_OPTIONS.get(type(self)) or _BODY_OPTIONS.setdefault(type(self), options_of(type(self).add))
        refuse_unknown(me, sorted({*known, *ABILITIES, "ladders"}), options)
        options.setdefault("friction", 0.0)
        body: Body = self.add(shape, at=at, tag=tag, kind="kinematic", **options)
        abilities.setdefault("mass", max(sum(each.mass for each in body.shapes), 1e-3))
        try:
            return self._make_character(body, abilities, ladders)
        except BaseException:
            self._take_back(body)
            raise

    def _make_character(self, body: Body, abilities: dict[str, Any], ladders: Iterable[Area]) -> Character:
        _core.add_character(self._core, body.slot)
        character = Character(body)
        for word, value in abilities.items():
            setattr(character, word, value)
        if "push_force" not in abilities:
            character.push_force = PUSH * character.mass
        for area in ladders:
            character._add_ladder(*area)
        return character

    @property
    def characters(self) -> tuple[Character, ...]:
        """All characters, in the order in which they were made."""
        return tuple(Character(self._body(slot)) for slot in _core.characters(self._core))

    @known_keywords
    def character_of(self, body: Body) -> Character | None:
        """The character whose body this is, or None."""
        return next((character for character in self.characters if character._body == body), None)


_BODY_OPTIONS: dict[type, frozenset[str]] = {}


def options_of(add: Any) -> frozenset[str]:
    """The words that `add` takes for a body."""
    return frozenset(inspect.signature(add).parameters) - {"self", "shape", *NOT_FOR_CHARACTERS}


def to_area(area: object, me: str) -> Area:
    """Four numbers (left, bottom, right, top), or an error that says what is wrong."""
    if not isinstance(area, Iterable) or isinstance(area, (str, bytes)):
        raise ArgumentTypeError(f"{me}: area={area!r} must be (left, bottom, right, top)")
    sides = tuple(area)
    if len(sides) != 4:
        raise ArgumentError(f"{me}: area={area!r} must be four numbers: left, bottom, right, top")
    low, high = place(sides[:2], me, "area"), place(sides[2:], me, "area")
    if not (low.x < high.x and low.y < high.y):
        raise ArgumentError(f"{me}: area={area!r}: left must be less than right, and bottom less than top")
    return (low.x, low.y, high.x, high.y)


def to_areas(areas: object, me: str) -> list[Area]:
    """Several areas, or an error."""
    if not isinstance(areas, Iterable):
        raise ArgumentTypeError(f"{me}: ladders={areas!r} must be a list of areas, each (left, bottom, right, top)")
    return [to_area(area, me) for area in areas]


def tell_characters(world: World) -> None:
    """Tell those who listen what became of the characters in the last step."""
    if not world._heard.intersection(EVENTS):
        return
    for character in world.characters:
        if not character.alive:
            continue
        listeners = character._body._callbacks
        landing, jumped, crushed = character._told
        if jumped and "on_jump" in listeners:
            listeners["on_jump"].run()
        if landing > 0 and "on_land" in listeners:
            listeners["on_land"].run(landing)
        if crushed and "on_crush" in listeners:
            listeners["on_crush"].run()
