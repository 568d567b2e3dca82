"""Lights: what shines on a scene, and how finely light is drawn (SPEC G5, G7)."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

from evilengine import _core
from evilengine.scene.camera import Matrix6
from evilengine.scene.light import LIMITS, Light, to_mask, to_place
from evilengine.values.checks import known_keywords, number, one_of, switch
from evilengine.values.colour import WHITE, Colour, ColourLike, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.governor import QUALITIES
from evilengine.values.image import Image
from evilengine.values.temperature import COLDEST, HOTTEST
from evilengine.values.vec2 import Point, to_vec2
from evilengine.world.body import Body
from evilengine.world.world import World

STEPS = {"low": (4, _core.Quality.low), "medium": (2, _core.Quality.medium), "high": (2, _core.Quality.high)}
"""Pixels that share one measure of light, along each side; and how it is worked out."""

DIM = 0.15
"""The ambient light of a scene that has lights and was told of none: shadows are dark, and one sees what is in them."""

BRIGHTEST = 4.0
"""Ambient light beyond which everything is white."""

MOST_BOUNCE = 4.0
"""Of the light that bodies send on; white paint would shine by itself."""

SUN_SIZE = 0.05
"""A sun's shadow is soft by so much of the distance to what casts it: some six times as soft as the real one's."""


class Slides:
    """The pictures that lights shine through, as the core keeps them; they change as a renderer's do."""

    def __init__(self, core: _core.Lights) -> None:
        self._core = core

    def upload(self, image: Image) -> int:
        """Keep `image` and return its number."""
        return self._core.add_slide(image.pixels, image.width, image.height)

    def update(self, texture: int, image: Image) -> None:
        """Let lights shine through another image, of any size."""
        self._core.change_slide(texture, image.pixels, image.width, image.height)


Loads: TypeAlias = Callable[[str, Slides], int]
"""Gives the picture of a name to the lights, again whenever its file changes; its number. Raises AssetError."""


Asked: TypeAlias = tuple[_core.Scene, Matrix6, float, tuple[int, int], float]
"""What a view was collected with: the scene, its view, alpha, the screen and its scale."""


class Lights:
    """The lights of a scene. Only drawings that are `lit` show them; the others look as they always do.

    >>> game = evil.Game(headless=True)
    >>> wall = game.draw(evil.Rectangle(20, 12), colour="#665544", lit=True)
    >>> lamp = game.lights.add(at=(0, 2), radius=5)
    >>> dusk = game.lights.add(direction=(1, -2), temperature=3000, intensity=0.4)
    >>> [light.kind for light in game.lights]
    ['lamp', 'sun']
    """

    __slots__ = (
        *("_ambient", "_asked", "_bounce", "_core", "_cost", "_depth", "_images", "_present", "_quality"),
        *("_shadows", "_smokes", "_slide_names", "_slides", "_world"),
    )

    def __init__(self, world: World, images: Loads | None = None, threads: int = 1) -> None:
        self._world = world
        self._images = images
        self._core = _core.Lights()
        self._core.threads = threads
        self._slides = Slides(self._core)
        self._slide_names: dict[int, str] = {}
        self._ambient: float | Colour | None = None
        self._depth = 0.8
        self._shadows = True
        self._smokes: list[tuple[int, float]] = []  # that cast shadows, by slot, and how much
        self._bounce = 1.0
        self._quality = "auto"
        self._present = "medium"
        self._cost: float | None = None  # milliseconds of the last frame's light, in all its views
        self._asked: list[tuple[int, Asked]] = []  # by those views, and into which list

    def __len__(self) -> int:
        """How many there are, switched on or not. Those of a body that was destroyed count until the next frame."""
        return len(self._core)

    def __iter__(self) -> Iterator[Light]:
        """Each light, in the order of their slots."""
        lights = [self._in_slot(slot) for slot in self._core.slots()]
        return iter([light for light in lights if light.alive])

    @property
    def ambient(self) -> float | Colour:
        """The light that is everywhere: 1.0 shows things as they are drawn, 0 nothing; or a colour.

        Until it is set, it is 1.0 as long as there are no lights, and 0.15 from the first one on.
        """
        if self._ambient is None:
            return DIM if len(self) else 1.0
        return self._ambient

    @ambient.setter
    def ambient(self, value: float | ColourLike) -> None:
        if isinstance(value, (int, float)):
            self._ambient = number(value, "Lights", "ambient", least=0.0, most=BRIGHTEST)
        else:
            self._ambient = to_colour(value, "Lights", "ambient")

    @property
    def depth(self) -> float:
        """Metres that light soaks into bodies that are lit: their sides shine, and further in they are dark."""
        return self._depth

    @depth.setter
    def depth(self, value: float) -> None:
        self._depth = number(value, "Lights", "depth", least=0.0, most=100.0)

    @property
    def shadows(self) -> bool:
        """Do bodies cast shadows at all? Without, every light shines through everything."""
        return self._shadows

    @shadows.setter
    def shadows(self, value: bool) -> None:
        self._shadows = switch(value, "Lights", "shadows")

    @property
    def bounce(self) -> float:
        """How much of the light that falls on bodies they send on, at high quality: 1.0 as their colours say."""
        return self._bounce

    @bounce.setter
    def bounce(self, value: float) -> None:
        self._bounce = number(value, "Lights", "bounce", least=0.0, most=MOST_BOUNCE)

    @property
    def quality(self) -> str:
        """How light is worked out: "low", with hard shadows; "medium", with soft ones; "high", with light that surfaces
        send on to each other as well, and corners that little ambient light gets into.

        At "auto" a game in a window takes what its machine has time for, at first and while it runs. Where there is no
        window, and in what is replayed, that is "medium", so that pictures come out the same again.
        """
        return self._quality

    @quality.setter
    def quality(self, value: str) -> None:
        self._quality = one_of(value, "Lights", "quality", ("auto", *QUALITIES))
        self._present = "medium" if self._quality == "auto" else self._quality

    @property
    def present_quality(self) -> str:
        """The quality that light has now, which "auto" may change from frame to frame."""
        return self._present

    @known_keywords
    def add(
        self,
        *,
        at: Point | None = None,
        direction: Point | None = None,
        cone: float | None = None,
        edge: float = 0.3,
        colour: ColourLike = WHITE,
        temperature: float | None = None,
        intensity: float = 1.0,
        radius: float = 8.0,
        size: float | None = None,
        falloff: float | None = None,
        shadows: bool = True,
        mask: int = 0xFFFFFFFF,
        on: bool = True,
        body: Body | None = None,
        texture: str | None = None,
        angle: float | None = None,
        static: bool = False,
    ) -> Light:
        """A lamp `at` a point; with a `direction` or a `cone` (radians) a spot; with a direction alone a sun.

        On a `body`, `at` and `direction` are the body's own, and it moves with it; that body casts no shadow in it, nor
        does one that the light is inside of. It shines through the image `texture`, turned by `angle`, as through a
        slide, and then `falloff` is 0 unless said. A `static` one is worked out once. The rest may be changed later:
        see Light.

        Raises ArgumentError or ArgumentTypeError, and adds nothing then.
        """
        owner = "Lights.add"
        if at is None and body is None and direction is None:
            raise ArgumentError(f"{owner}: say where the light is, at=(x, y), or where it comes from, direction=(x, y)")
        sun = at is None and body is None
        if sun and cone is not None:
            raise ArgumentError(f"{owner}: cone={cone!r}: a light from far away has none; say where it is, at=(x, y)")
        where = None if body is None else self._on(body, owner)
        if direction is not None and angle is not None:
            raise ArgumentError(f"{owner}: direction={direction!r} says its angle; leave angle={angle!r} out")
        turn = number(
            0.0 if angle is None else angle, owner, "angle", least=LIMITS["angle"][0], most=LIMITS["angle"][1]
        )
        turn = turn if direction is None else _angle_of(direction, owner)
        slide = self._slide(texture, owner)
        numbers = {
            "cone": 1.0 if cone is None else cone,
            "edge": edge,
            "intensity": intensity,
            "radius": radius,
            "size": (SUN_SIZE if sun else 0.2) if size is None else size,
            "falloff": (2.0 if texture is None else 0.0) if falloff is None else falloff,
        }
        for name, value in numbers.items():
            number(value, owner, name, least=LIMITS[name][0], most=LIMITS[name][1])
        if temperature is not None:
            number(temperature, owner, "temperature", least=COLDEST, most=HOTTEST)
        tint = to_colour(colour, owner, "colour")
        categories = to_mask(mask, owner)
        place = to_place((0.0, 0.0) if at is None else at)
        for name, flag in (("shadows", shadows), ("on", on), ("static", static)):
            switch(flag, owner, name)

        spot = not sun and (direction is not None or cone is not None)
        light = Light(self, *self._core.add(where))
        reach = _core.Reach.parallel if sun else _core.Reach.cone if spot else _core.Reach.round
        self._core.set_reach(light._slot, light._generation, reach)
        for name, value in numbers.items():
            setattr(light, name, value)
        light.at, light.angle, light.colour, light.temperature = place, turn, tint, temperature
        light.shadows, light.mask, light.on, light.static = shadows, categories, on, static
        self._core.set_slide(light._slot, light._generation, slide)
        return light

    def clear(self) -> None:
        """Take away every light, forget the ambient light, and let bodies cast shadows; quality and depth stay."""
        for light in self:
            light.destroy()
        self._ambient, self._shadows = None, True

    def _on(self, body: Any, owner: str) -> tuple[int, int]:
        if not isinstance(body, Body):
            raise ArgumentTypeError(f"{owner}: body={body!r} must be a Body, or None to stand by itself")
        body._require()
        if body.world is not self._world:
            raise ArgumentError(f"{owner}: {body!r} lives in another world than the one that these lights shine on")
        return body.slot, body.generation

    def _slide(self, name: object, owner: str) -> int:
        """The number of the picture called `name`; NO_SLOT for None."""
        if name is None:
            return _core.NO_SLOT
        if not isinstance(name, str):
            raise ArgumentTypeError(f"{owner}: texture={name!r} must be the name of an image, such as 'window.png'")
        if self._images is None:
            raise ArgumentError(
                f"{owner}: texture={name!r}: this scene was given no images; Scene(images=...) takes them"
            )
        slide = self._images(name, self._slides)
        self._slide_names[slide] = name
        return slide

    def _in_slot(self, slot: int) -> Light:
        """The light in a slot."""
        return Light(self, slot, self._core.generation(slot))

    def _body_of(self, slot: int, generation: int) -> Body | None:
        """The body that a light is on, dead or alive; None if there is no such light any more."""
        if not self._core.alive(slot, generation):
            return None
        on = self._core.body(slot, generation)
        return None if on is None else self._world._body(*on)

    def _begin_frame(self) -> None:
        """What comes now is another frame, of one view or of several."""
        self._cost, self._asked = None, []

    def _collect(
        self, scene: _core.Scene, into: int, view: Matrix6, alpha: float, screen: tuple[int, int], scale: float
    ) -> None:
        """Put a view's light into the scene's list of that number; without lights and ambient light, things look as
        they are."""
        if self._ambient is None and not len(self):
            return
        self._asked.append((into, (scene, view, alpha, screen, scale)))
        cost = self._work_out(self._present, *self._asked[-1][1])
        if cost is not None:
            self._cost = cost + (self._cost or 0.0)

    def _debug(self, scene: _core.Scene, view: Matrix6, alpha: float, scale: float, inks: tuple[int, int, int]) -> int:
        """Put what shines and the edges of shadows over the collected frame; how many lights are on."""
        return self._core.debug(scene, self._world._core, view, alpha, scale, inks)

    def _work_out(
        self, quality: str, scene: _core.Scene, view: Matrix6, alpha: float, screen: tuple[int, int], scale: float
    ) -> float | None:
        """Light of a view; how many milliseconds it took, None where nothing is lit."""
        ambient = self.ambient
        colour, strength = (ambient, 1.0) if isinstance(ambient, Colour) else (WHITE, ambient)
        step, method = STEPS[quality]
        start = time.perf_counter()
        lit = self._core.collect(
            scene, self._world._core, view, alpha, *screen, (colour.r, colour.g, colour.b), strength, self._depth,
            step * max(1, round(scale)), method, self._bounce, self._shadows, self._smokes,
        )  # fmt: skip
        return 1e3 * (time.perf_counter() - start) if lit else None

    def _measure(self) -> dict[str, float]:
        """Milliseconds that light of the last frame takes at each quality, once there is memory for it."""
        costs = dict.fromkeys(QUALITIES, 0.0)
        for quality in QUALITIES:
            for into, asked in self._asked:
                asked[0].aim(into)
                costs[quality] += min(self._work_out(quality, *asked) or 0.0 for _ in range(2))
        return costs


def _angle_of(direction: Point, owner: str) -> float:
    x, y = to_vec2(direction, owner, "direction")
    if x == y == 0.0:
        raise ArgumentError(f"{owner}: direction={direction!r} must not be (0, 0); (0, -1) shines down")
    return math.atan2(y, x)
