"""What a game is made of: bodies that are seen, drawings, text, levels and images."""

from __future__ import annotations

import inspect
import random
from collections.abc import Callable
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any, cast

from evilengine.assets import Pictures
from evilengine.scene import (
    LOOKS,
    Camera,
    DebugView,
    Drawing,
    DrawnBody,
    Emitter,
    Layers,
    Light,
    Lights,
    Post,
    Scene,
    Text,
)
from evilengine.scene.camera import POINTS_A_METRE
from evilengine.scene.drawing import DEEPEST_LAYER
from evilengine.scene.gases import LOOKS as SMOKE_LOOKS
from evilengine.scene.particles import add_particles
from evilengine.scene.waters import LOOKS as WATER_LOOKS
from evilengine.values.checks import did_you_mean, known_keywords, number, refuse_unknown
from evilengine.values.colour import Colour, ColourLike
from evilengine.values.errors import ArgumentError, ArgumentTypeError, AssetError
from evilengine.values.sheet import Sheet
from evilengine.values.vec2 import Point, to_vec2
from evilengine.world.character import Character
from evilengine.world.shapes import MAX_SIZE, Rectangle
from evilengine.world.smoke import Smoke
from evilengine.world.water import Water
from evilengine.world.world import World

if TYPE_CHECKING:
    from evilengine.game.game import Game
    from evilengine.level import Level

REPEATED = 201
"""How often a background is repeated: odd, so that one lies in the middle, and more than a camera's way is long."""

_BODY_OPTIONS = frozenset(inspect.signature(World.add).parameters) - {"self", "shape"}


class Things:
    """The part of a game that things are added to."""

    world: World
    scene: Scene
    camera: Camera
    folder: Path
    random: random.Random
    _pictures: Pictures

    def add(self, shape: Any, **options: Any) -> DrawnBody:
        """Add a body that is seen: everything that `world.add` takes, and the looks that `body.draw` takes.

        >>> game = evil.Game(headless=True)
        >>> crate = game.add(evil.Rectangle(1, 1), at=(0, 4), friction=0.8, colour="#c96")
        >>> crate.drawings[0].colour.hex
        '#cc9966'
        """
        looks = {word: options.pop(word) for word in LOOKS if word in options}
        unknown = next((word for word in options if word not in _BODY_OPTIONS), None)
        if unknown is not None:
            words = sorted(_BODY_OPTIONS | LOOKS)
            raise ArgumentTypeError(
                f"Game.add() got an unknown argument {unknown}={options[unknown]!r}{did_you_mean(unknown, words)}"
                f"; it takes {', '.join(words)}"
            )
        body = cast(DrawnBody, self.world.add(shape, **options))
        try:
            body.draw(**looks)
        except BaseException:
            self.world._take_back(body)
            raise
        return body

    def add_character(self, shape: Any = None, **options: Any) -> Character:
        """Add a character that is seen: everything that `world.add_character` takes, and the looks of `add`.

        >>> game = evil.Game(headless=True)
        >>> hero = game.add_character(at=(0, 1), jump_height=3, colour="orange")
        >>> hero.body.drawings[0].colour.hex
        '#ffa500'
        """
        looks = {word: options.pop(word) for word in LOOKS if word in options}
        character = self.world.add_character(shape, **options)
        try:
            cast(DrawnBody, character.body).draw(**looks)
        except BaseException:
            self.world._take_back(character.body)
            raise
        return character

    def draw(self, shape: Any, **options: Any) -> Drawing:
        """Draw a shape that takes no part in the physics."""
        return self.scene.add(shape, **options)

    def sprite(
        self,
        image: str | Sheet,
        *,
        height: float | None = None,
        size: Point | None = None,
        slice: float | tuple[float, float, float, float] | None = None,
        **options: Any,
    ) -> Drawing:
        """Draw an image by its name, or a Sheet's frame, `height` metres high or as large as it is: 50 points a metre.

        `size` gives width and height instead, whatever the picture's shape; then `slice` keeps its borders as wide as
        they are (so many points of it, or left, top, right, bottom), and only what lies between them is stretched.
        Takes what `draw` takes; with `body=` it is drawn on that body, moves with it and stays out of the physics.
        """
        owner = "Game.sprite"
        if size is None:
            if slice is not None:
                raise ArgumentError(f"{owner}: slice={slice!r} needs a size=(width, height) to fill")
            across, down = self.scene._size_of(image, owner)
            high = down / POINTS_A_METRE if height is None else number(height, owner, "height", above=0.0)
            return self.scene.add(Rectangle(high * across / down, high), texture=image, **options)
        if height is not None:
            raise ArgumentError(f"{owner}: height={height!r} and size={size!r} contradict each other; give one")
        wide, high = to_vec2(size, owner, "size")
        return self.scene.add(Rectangle(wide, high), texture=image, slice=slice, **options)

    def add_particles(self, *, body: Any = None, **settings: Any) -> Emitter:
        """Add a particle effect: sparks, smoke, rain. Takes what an Emitter can be told, and the `body` it follows;
        `burst` lets go of so many at once, and with `once=True` it goes away with the last of them.

        It takes its chances from `game.random`, so that a game that is played again shows the same.

        >>> game = evil.Game(headless=True)
        >>> smoke = game.add_particles(at=(0, 1), rate=20, size=[0.2, 1.5], colour=["#8888", "#8880"])
        >>> game.step(60); smoke.count
        20
        """
        return add_particles(self.scene, self.random.getrandbits(64), body, settings)

    def add_smoke(self, area: Any, **options: Any) -> Smoke:
        """Add smoke that is seen: everything that `world.add_smoke` takes, and looks.

        `ramp` is a list of its colours from thin to thick, the smoke's own colour unless said; `opacity` how much of
        that a density of 1 shows. Heat shines in the colours of `fire`, from cold to hot, and lights what is round it
        by a lamp that reaches `light_radius` metres (0: none); `glow` is how bright, 0 for no fire at all. Lights fall
        on it where it is `lit`, and `shadow` is how much of their light a metre of it takes away at a density of 1, so
        that what lies behind is darker, and its own far side. It lies in `layer`.

        >>> game = evil.Game(headless=True)
        >>> smoke = game.add_smoke((-2, 0, 2, 4), cells=32, ramp=["#0000", "#445a", "#dde"])
        >>> flame = smoke.add_source(at=(0, 0.5), radius=0.3, fuel=3, temperature=1)
        """
        looks = _looks(options, SMOKE_LOOKS, World.add_smoke, "Game.add_smoke")
        smoke = self.world.add_smoke(area, **options)
        try:
            self.scene.gases.add(smoke, looks)
        except BaseException:
            smoke._take_back()
            raise
        return smoke

    def add_water(self, area: Any, **options: Any) -> Water:
        """Add water that is seen: everything that `world.add_water` takes, and looks.

        `ramp` is a list of its colours from its surface to the deep, each as solid as its alpha says; unless said, it
        is made of the water's `colour`, and so are those of other liquids in it. `clarity` is how many metres below the
        surface a third of the light is left. `refraction` is how much what lies behind is displaced, `waves` how much
        that wavers, `rim` how bright the line of its surface is (0 to 1), `foam` how much foam and spray it throws up;
        0 is none of it. Lights fall on it where it is `lit`; it lies over the drawings of `layer`.

        >>> game = evil.Game(headless=True)
        >>> pool = game.add_water((-4, 0, 4, 3), particle_size=0.1, colour="teal", clarity=3)
        >>> pool.fill((-4, 0, 4, 1.5)) > 0
        True
        """
        looks = _looks(options, WATER_LOOKS, World.add_water, "Game.add_water")
        water = self.world.add_water(area, **options)
        try:
            self.scene.waters.add(water, looks)
        except BaseException:
            water.destroy()
            raise
        return water

    def add_light(self, **options: Any) -> Light:
        """Let a light shine on what is `lit`, with soft shadows: everything that `game.lights.add` takes.

        >>> game = evil.Game(headless=True)
        >>> lamp = game.add_light(at=(0, 5), colour="#ffd9a0", radius=8)
        >>> game.ambient = 0.1
        >>> lamp.on = False
        """
        return self.scene.lights.add(**options)

    @property
    def lights(self) -> Lights:
        """The lights of this game, the ambient light, and how finely light is drawn."""
        return self.scene.lights

    @property
    def ambient(self) -> float | Colour:
        """The light that is everywhere: a number, 1.0 for as bright as drawn, or a colour. See `Lights.ambient`."""
        return self.scene.lights.ambient

    @ambient.setter
    def ambient(self, value: float | ColourLike) -> None:
        self.scene.lights.ambient = value

    def text(self, text: object, **options: Any) -> Text:
        """Put a line of text on the screen, `at` logical points from its top left corner."""
        return self.scene.text(text, **options)

    @property
    def layers(self) -> Layers:
        """How layers are seen: `game.layers[-2].parallax = 0.4`; fog between them, out of focus, in one colour."""
        return self.scene.layers

    @property
    def post(self) -> Post:
        """What is done to the whole picture: `game.post.bloom = 0.6`."""
        return self.scene.post

    @known_keywords
    def add_background(
        self,
        what: ColourLike,
        *,
        parallax: float = 1.0,
        layer: int | None = None,
        height: float | None = None,
        repeat: bool | None = None,
        colour: ColourLike = "white",
        lit: bool = False,
    ) -> Drawing | None:
        """Set what lies behind everything: a colour, or an image by its file name.

        An image is a Drawing in a layer of its own, each in front of those that were added before it, or in `layer`. It
        covers what the camera shows, or is `height` metres high, and makes `parallax` of the camera's motion: 1 stays
        where it is in the world, 0 on the screen. One with a parallax of its own is repeated to both sides, unless
        `repeat` says otherwise. `colour` tints it, and with `lit` lights fall on it. A colour gives None.
        """
        if not (isinstance(what, str) and PurePath(what).suffix):
            self.scene.background = what
            return None
        if layer is None:
            layer = -DEEPEST_LAYER + self.scene.backgrounds
        width, points = self._pictures.size(what)
        if height is None:
            across, up = (side / self.camera.points_a_metre for side in self.camera.size)
            metres = max(across / width, up / points)  # a pixel of it: as small as covers the screen both ways
        else:
            metres = number(height, "Game.add_background", "height", above=0.0, most=1e6) / points
        number(parallax, "Game.add_background", "parallax", least=0.0, most=100.0)
        fitting = max(int(MAX_SIZE / (width * metres)), 1)  # of a picture that is very wide
        copies = min(REPEATED, fitting - 1 + fitting % 2) if (parallax != 1.0 if repeat is None else repeat) else 1
        drawing = self.scene.add(
            Rectangle(copies * width * metres, points * metres),
            at=self.camera.position,
            texture=what,
            texture_matrix=(copies, 0, 0, 1, 0, 0),
            layer=layer,
            colour=colour,
            lit=lit,
        )
        self.scene.backgrounds += 1
        if parallax != 1.0:
            self.scene.layers[layer].parallax = parallax
        return drawing

    @known_keywords
    def load(self, path: str | Path) -> Level:
        """Build a level script into this game and return the level, whose things have names: `level["ball"]`.

        Raises LevelError with all its errors, AssetError if it is missing; nothing is added then.
        """
        from evilengine import level  # games without levels need no parser

        return level.load(cast("Game", self), self.find(path))

    @known_keywords
    def find(self, name: str | Path) -> Path:
        """The file called `name`, in the game's folder or in the current one. Raises AssetError if it is in neither."""
        if not isinstance(name, (str, PurePath)):
            raise ArgumentTypeError(f"Game: {name!r} must be the name of a file")
        for folder in (self.folder, Path.cwd()):
            if (folder / name).is_file():
                return folder / name
        raise AssetError(f"Game: there is no file {str(name)!r} in {self.folder} or in the current folder")

    def reload_images(self) -> list[str]:
        """Show the images whose files have changed as they are now; `evil play` asks for it while it plays.

        An image that cannot be read any more stays as it was, and a line in the list says why. Normals and what glows
        are seen from when they lie beside a picture.
        """
        return self._pictures.reload() + self.scene.dress_anew()

    @property
    def debug(self) -> bool:
        """Is the debug view on: outlines, contact normals as arrows, the arrow of gravity (SPEC G12)?"""
        return self.scene.debug

    @debug.setter
    def debug(self, on: bool) -> None:
        self.scene.debug = bool(on)

    @property
    def debug_view(self) -> DebugView:
        """What the debug view shows when it is on, and in which colours.

        >>> import evilengine as evil
        >>> game = evil.Game(headless=True)
        >>> game.debug = game.debug_view.velocities = True
        """
        return self.scene.debug_view


def _looks(options: dict[str, Any], looks: dict[str, Any], adds: Callable[..., object], owner: str) -> dict[str, Any]:
    """Take what is said of looks out of the options; the rest must be what `adds` knows."""
    said = {word: options.pop(word) for word in looks if word in options}
    known = [word for word in inspect.signature(adds).parameters if word not in ("self", "area")]
    refuse_unknown(owner, [*known, *looks], options)
    return said
