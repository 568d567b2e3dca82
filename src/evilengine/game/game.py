"""Game: every module of the engine tied into one frame (SPEC A1, A3). The only file that knows them all."""

from __future__ import annotations

import inspect
import math
import random
import time
from collections.abc import Iterable
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any, cast

from evilengine.assets import Images, Pictures
from evilengine.audio import Audio, Listener
from evilengine.game.output import SHIPPED, for_device, open_output
from evilengine.game.stage import STAGE, keep_pace, open_device, script_folder
from evilengine.interaction import Grabs, Interaction, axis
from evilengine.platform import Device, HeadlessDevice
from evilengine.renderer import open_renderer
from evilengine.scene import LOOKS, Camera, Drawing, DrawnBody, Scene, Text
from evilengine.scene.camera import POINTS_A_METRE
from evilengine.scene.drawing import DEEPEST_LAYER
from evilengine.timer import Clock, Schedule
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import did_you_mean, known_keywords, number
from evilengine.values.colour import ColourLike
from evilengine.values.errors import ArgumentTypeError, AssetError, Error
from evilengine.values.events import CloseEvent, Event, ResizeEvent
from evilengine.values.image import Image
from evilengine.values.inputs import Inputs, Keys, Pointer, Tilt, Touch
from evilengine.values.tick import STEP
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.shapes import Rectangle
from evilengine.world.world import World

if TYPE_CHECKING:
    from evilengine.level import Level

HEADLESS_SECONDS = 10.0
"""How long `run()` plays where nobody can close a window, unless it is told."""


class Game:
    """A world, its looks, its player and its time.

    `size` is in logical points; 50 of them show a metre unless `view_height` says how many metres the screen is high.
    `headless=True` needs no screen: tests drive `game.device`, and `game.capture()` gives the picture. `renderer` is
    "auto" or "soft"; `sound` is "auto" (the sound card, and none where there is no window), "none", or the name of a
    .wav file to write. With `tilt=True` gravity follows how the device is held, or the arrow keys, wheel or stick that
    stand in for it. `seed` starts `game.random`. Files are found beside the script that runs, or in `folder`.

    Its callbacks are decorators. Each step: `on_key_press(key)`, `on_key_release(key)`, `on_pointer(pointer)`,
    `on_touch(touch)`, `on_tilt(tilt)` and `on_shake()` for what the player did, then the timer's events, then
    `on_update(dt)`, then the bodies' own. Each frame: `on_event(event)` for all that the device reports, also while
    the game is paused, and `on_draw()` before the picture is drawn.

    >>> game = Game("Drop", headless=True)
    >>> ball = game.add(evil.Circle(0.5), at=(0, 4), colour="tomato")
    >>> @game.on_update
    ... def push(dt):
    ...     ball.apply_force((5 * game.axis("left", "right"), 0))
    >>> game.device.key("right", down=True)
    >>> game.step(60)
    >>> ball.position.x > 0, ball.position.y < 4
    (True, True)
    """

    @known_keywords
    def __init__(
        self,
        title: str = "EvilEngine",
        *,
        size: tuple[int, int] = (960, 540),
        headless: bool = False,
        renderer: str = "auto",
        sound: str | Path = "auto",
        tilt: bool = False,
        gravity: Point = (0.0, -9.81),
        view_height: float | None = None,
        seed: int = 0,
        threads: int = 1,
        sleep: bool = True,
        folder: str | Path | None = None,
        device: Device | None = None,
    ) -> None:
        if isinstance(seed, bool) or not isinstance(seed, int):
            raise ArgumentTypeError(f"Game: seed={seed!r} must be a whole number")
        if not (folder is None or isinstance(folder, (str, Path))):
            raise ArgumentTypeError(f"Game: folder={folder!r} must be a path, or None for the folder of the script")
        self.world = World(gravity, threads=threads, sleep=sleep)
        self.world._body_type = DrawnBody
        self.renderer = open_renderer(renderer)
        self.folder = script_folder() if folder is None else Path(folder)
        self.camera = Camera(view_height=view_height)
        output = open_output(sound)
        self.device = device or open_device(title, size, headless)  # last: nothing after it can leave a window behind
        self.camera.size = self.device.size
        self._pictures = Pictures(self.renderer, Images(self.folder, Path.cwd()), scale=self.device.scale)
        self.scene = Scene(self.world, textures=self._pictures.texture, fonts=self._pictures.font)
        self.timer = Schedule(lambda: self.world.steps)
        output = for_device(output, self.device)
        self.audio = Audio(self.folder, Path.cwd(), SHIPPED, output=output, clock=lambda: self.world.steps)
        self.random = random.Random(seed)
        self.tilt = tilt
        self.paused = False
        self.running = True

        self._clock = Clock()
        self._interaction = Interaction()
        self._grabs = Grabs()
        self._inputs = Inputs()
        self._alpha = 1.0
        self._busy = ""  # inside which part of a frame a callback runs
        self._tilted: tuple[Vec2, Vec2] | None = None  # the direction last set, and the gravity it gave
        self._strength = 0.0

        self.on_event: Callbacks[[Event]] = Callbacks("game.on_event", "event")
        self.on_update: Callbacks[[float]] = Callbacks("game.on_update", "dt")
        self.on_draw: Callbacks[[]] = Callbacks("game.on_draw")
        self.on_key_press: Callbacks[[str]] = Callbacks("game.on_key_press", "key")
        self.on_key_release: Callbacks[[str]] = Callbacks("game.on_key_release", "key")
        self.on_pointer: Callbacks[[Pointer]] = Callbacks("game.on_pointer", "pointer")
        self.on_touch: Callbacks[[Touch]] = Callbacks("game.on_touch", "touch")
        self.on_tilt: Callbacks[[Tilt]] = Callbacks("game.on_tilt", "tilt")
        self.on_shake: Callbacks[[]] = Callbacks("game.on_shake")

    # One frame ------------------------------------------------------------------------------------------------------

    @known_keywords
    def frame(self, now: float) -> None:
        """One frame at wall time `now`, in seconds: the steps that are due, then the picture. `run` calls it."""
        self._refuse_in_a_callback("Game.frame")
        tick = self._clock.hold(now) if self.paused else self._clock.advance(now)
        self._listen()
        if self.paused:
            self._inputs = self._interaction.snapshot(self.camera.to_world, 0.0)  # nothing waits for the pause to end
        for _ in range(tick.steps):
            if self.paused or not self.running:
                break
            self._step()
        self._alpha = tick.alpha
        self._draw()
        self.device.show(self.renderer.pixels, self.device.pixel_size)
        self._hear(paused=self.paused)

    @known_keywords
    def step(self, n: int = 1) -> None:
        """Simulate `n` steps of 1/60 s by hand, paused or not; nothing is drawn and no clock is read."""
        self._refuse_in_a_callback("Game.step")
        if isinstance(n, bool) or not isinstance(n, int):
            raise ArgumentTypeError(f"Game.step: n={n!r} must be a whole number of steps of 1/60 s")
        number(n, "Game.step", "n", least=0)
        self._listen()
        for _ in range(n):
            self._step()
        self._alpha = 1.0

    def _listen(self) -> None:
        events = self.device.poll()
        self._interaction.collect(events)
        for event in events:
            if isinstance(event, CloseEvent):
                self.quit()
            elif isinstance(event, ResizeEvent):
                self.camera.size = event.size
                self._pictures.scale = self.device.scale
            self.on_event.run(event)

    def _step(self) -> None:
        self._busy = "a step"
        try:
            self._inputs = self._interaction.snapshot(self.camera.to_world, STEP)
            self._tell_inputs(self._inputs)
            self.timer.run_due()
            self.on_update.run(STEP)
            if self.tilt:
                self._turn_gravity(self._inputs.tilt.direction)
            self.world.step(STEP)
        finally:
            self._busy = ""
        self._hear()

    def _draw(self) -> None:
        self._busy = "drawing"
        try:
            self.on_draw.run()
            self.renderer.draw(self.scene.collect(self.camera, self._alpha, self.device.pixel_size, self.device.scale))
        finally:
            self._busy = ""

    def _hear(self, *, paused: bool = False) -> None:
        self.audio.update(Listener(self.camera.position, self.camera.angle), paused=paused)

    def _tell_inputs(self, inputs: Inputs) -> None:
        for key in inputs.pressed:
            self.on_key_press.run(key)
        for key in inputs.released:
            self.on_key_release.run(key)
        pointer = inputs.pointer
        if pointer.pressed or pointer.released or pointer.pixel != pointer.previous_pixel:
            self.on_pointer.run(pointer)
        for body, touch in self._grabs.update(inputs, self.world):
            if body.alive:
                body.on_touch.run(touch)
        for touch in inputs.touch_events:
            self.on_touch.run(touch)
        if inputs.tilt.changed:
            self.on_tilt.run(inputs.tilt)
        if inputs.tilt.shaken:
            self.on_shake.run()

    def _turn_gravity(self, direction: Vec2) -> None:
        """Turn gravity and keep its strength (SPEC I4), which is that of the gravity that anybody else set last."""
        if self.camera.angle:
            direction = direction.turned(self.camera.angle)
        gravity = self.world.gravity
        if self._tilted == (direction, gravity):
            return
        if self._tilted is None or self._tilted[1] != gravity:
            self._strength = math.sqrt(gravity.dot(gravity))
        self.world.gravity = direction * self._strength
        self._tilted = (direction, self.world.gravity)

    def _refuse_in_a_callback(self, what: str) -> None:
        if self._busy:
            raise Error(f"{what}: cannot be called inside {self._busy}; a callback is part of the frame that calls it")

    # What the player does ---------------------------------------------------------------------------------------------

    @property
    def inputs(self) -> Inputs:
        """Everything the player did in the last step, as one value."""
        return self._inputs

    @property
    def keys(self) -> Keys:
        """The keys held: `game.keys["left"]`."""
        return self._inputs.keys

    @property
    def pointer(self) -> Pointer:
        """The mouse."""
        return self._inputs.pointer

    @property
    def touches(self) -> tuple[Touch, ...]:
        """The fingers on the screen, the mouse with its button down among them."""
        return self._inputs.touches

    @known_keywords
    def axis(self, negative: str | Iterable[str], positive: str | Iterable[str]) -> float:
        """-1 while the key `negative` is held, 1 while `positive` is, 0 with both or none.

        Each side may be several keys; a pad's stick ("stick_left", "stick_right", ...) gives what lies between.
        """
        return axis(self._inputs, negative, positive)

    # What there is ----------------------------------------------------------------------------------------------------

    def add(self, shape: Any, **options: Any) -> DrawnBody:
        """Add a body that is seen: everything that `world.add` takes, and the looks that `body.draw` takes.

        >>> game = Game(headless=True)
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

    def draw(self, shape: Any, **options: Any) -> Drawing:
        """Draw a shape that takes no part in the physics."""
        return self.scene.add(shape, **options)

    def sprite(self, image: str, *, height: float | None = None, **options: Any) -> Drawing:
        """Draw the image called `image`, `height` metres high or as large as it is: 50 logical points a metre.

        Takes what `draw` takes; with `body=` it is drawn on that body, moves with it and stays out of the physics.
        """
        width, points = self._pictures.size(image)
        high = points / POINTS_A_METRE if height is None else number(height, "Game.sprite", "height", above=0.0)
        return self.scene.add(Rectangle(high * width / points, high), texture=image, **options)

    def text(self, text: str, **options: Any) -> Text:
        """Put a line of text on the screen, `at` logical points from its top left corner."""
        return self.scene.text(text, **options)

    @known_keywords
    def add_background(self, what: ColourLike) -> Drawing | None:
        """Set what lies behind everything: a colour, or an image by its file name, which covers what the camera shows.

        The image is a Drawing in the deepest layer and stays where it is in the world; a colour gives None.
        """
        if not (isinstance(what, str) and PurePath(what).suffix):
            self.scene.background = what
            return None
        width, height = self._pictures.size(what)
        across, up = (side / self.camera.points_a_metre for side in self.camera.size)
        metres = max(across / width, up / height)  # a pixel of it: as small as covers the screen both ways
        shape = Rectangle(width * metres, height * metres)
        return self.scene.add(shape, at=self.camera.position, texture=what, layer=-DEEPEST_LAYER)

    @known_keywords
    def load(self, path: str | Path) -> Level:
        """Build a level script into this game and return the level, whose things have names: `level["ball"]`.

        Raises LevelError with all its errors, AssetError if it is missing; nothing is added then.
        """
        from evilengine import level  # games without levels need no parser

        return level.load(self, self.find(path))

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

        An image that cannot be read any more stays as it was, and a line in the list says why.
        """
        return self._pictures.reload()

    @property
    def debug(self) -> bool:
        """Is the debug view on: outlines, contact normals as arrows, the arrow of gravity (SPEC G12)?"""
        return self.scene.debug

    @debug.setter
    def debug(self, on: bool) -> None:
        self.scene.debug = bool(on)

    # Running ----------------------------------------------------------------------------------------------------------

    @known_keywords
    def run(self, seconds: float | None = None) -> None:
        """Play until the window is closed, `quit()` is called, or `seconds` have passed.

        Where nobody can close a window, it plays ten seconds as fast as it can unless `seconds` says otherwise.
        """
        if seconds is not None:
            number(seconds, "Game.run", "seconds", least=0.0)
        stage = STAGE.get()
        if stage is not None:
            stage.run(self)
            return
        try:
            if isinstance(self.device, HeadlessDevice):
                self._run_headless(HEADLESS_SECONDS if seconds is None else seconds)
            else:
                self._run_window(math.inf if seconds is None else seconds)
        finally:
            self.close()

    def _run_window(self, seconds: float) -> None:
        start = now = time.perf_counter()
        while self.running and now - start < seconds:
            self.frame(now)
            keep_pace(self.device, now)
            now = time.perf_counter()

    def _run_headless(self, seconds: float) -> None:
        for count in range(round(seconds / STEP) + 1):
            if self.running:
                self.frame(count * STEP)

    def quit(self) -> None:
        """Stop `run` after this frame."""
        self.running = False

    def close(self) -> None:
        """Close the window. A game that has ended can still be asked, not shown."""
        self.running = False
        self.audio.close()
        self.device.close()

    def capture(self) -> Image:
        """The picture as it is now, in real pixels."""
        self._refuse_in_a_callback("Game.capture")
        self._draw()
        return self.renderer.capture()


_BODY_OPTIONS = frozenset(inspect.signature(World.add).parameters) - {"self", "shape"}
