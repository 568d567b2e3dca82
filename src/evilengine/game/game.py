"""Game: every module of the engine tied into one frame (SPEC A1, A3). The only file that knows them all."""

from __future__ import annotations

import math
import os
import random
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from evilengine.assets import Images, Pictures
from evilengine.audio import Audio, Listener
from evilengine.game import replaying, saving, scenes
from evilengine.game.controls import Controls
from evilengine.game.life import Life
from evilengine.game.light_quality import LightQuality
from evilengine.game.output import SHIPPED, for_device, open_output
from evilengine.game.screen import GameScreen
from evilengine.game.stage import STAGE, keep_pace, open_device, script_folder, to_path
from evilengine.game.things import Things
from evilengine.platform import Device, HeadlessDevice
from evilengine.renderer import open_renderer, threads_for_pictures
from evilengine.save import Functions, Recorder, Replay, Slots
from evilengine.scene import Camera, DrawnBody, Panel, Scene, Views, collect_views
from evilengine.timer import Clock, Schedule
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import known_keywords, make_up, number
from evilengine.values.drawlist import DrawList
from evilengine.values.errors import ArgumentTypeError, Error
from evilengine.values.events import CloseEvent, Event, ResizeEvent
from evilengine.values.image import Image
from evilengine.values.inputs import Inputs
from evilengine.values.tick import STEP
from evilengine.values.vec2 import Point, Vec2
from evilengine.world.world import World

if TYPE_CHECKING:
    from evilengine.level import Level

F = TypeVar("F", bound=Callable[..., Any])

HEADLESS_SECONDS = 10.0
"""How long `run()` plays where nobody can close a window, unless it is told."""


class Game(Life, GameScreen, Controls, Things):
    """A world, its looks, its player and its time.

    `size` is in logical points; 50 of them show a metre unless `view_height` says how many metres the screen is high.
    `headless=True` needs no screen: tests drive `game.device`, and `game.capture()` gives the picture. `renderer` is
    "gl" (the graphics card), "soft" (the processor), or "auto": the card if there is one. `sound` is "auto" (the sound
    card, and none where there is no window), "none", or the name of a .wav file to write. With `tilt=True` gravity
    follows how the device is held, or the arrow keys, wheel or stick that stand in for it. `seed` starts
    `game.random`. `threads` (1 to 256) share in steps, in light and in pictures that no card draws, which come out to
    the same bits however many they are; None stands for one in steps, and for what is seen as many as the machine has,
    four at most. Files are found beside the script that runs, or in `folder`.

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
        threads: int | None = None,
        sleep: bool = True,
        fullscreen: bool = False,
        folder: str | Path | None = None,
        device: Device | None = None,
    ) -> None:
        if isinstance(seed, bool) or not isinstance(seed, int):
            raise ArgumentTypeError(f"Game: seed={seed!r} must be a whole number")
        if not (folder is None or isinstance(folder, (str, Path))):
            raise ArgumentTypeError(f"Game: folder={folder!r} must be a path, or None for the folder of the script")
        super().__init__()
        self.title = title
        drawing = threads_for_pictures(threads, "Game")
        self.world = World(gravity, threads=threads or 1, sleep=sleep)
        self.world._body_type = DrawnBody
        self.renderer = open_renderer(renderer, threads=drawing)
        self.folder = script_folder() if folder is None else Path(folder)
        self.camera = Camera(view_height=view_height)
        output = open_output(sound)
        # Last: nothing after it can leave a window behind.
        self.device = device or open_device(title, size, headless, gl=renderer != "soft")
        self.renderer.attach(self.device.surface)
        self.views = Views(self.camera, self.device.size)
        """The parts of the window that show the world; the first is the camera's, and covers all of it. See View."""
        self._pictures = Pictures(self.renderer, Images(self.folder, Path.cwd()), scale=self.device.scale)
        self.scene = Scene(
            self.world,
            textures=self._pictures.texture,
            surfaces=self._pictures.surface,
            sizes=self._pictures.size,
            images=self._pictures.slide,
            fonts=self._pictures.font,
            renderer=self.renderer,
            threads=drawing,
        )
        self.panel = Panel(lambda: self._inputs.pointer)
        """Values and knobs on the screen for who makes the game; see Panel."""
        self.scene.panels.append(self.panel.draw)
        self.timer = Schedule(lambda: self.world.steps)
        output = for_device(output, self.device)
        self.audio = Audio(self.folder, Path.cwd(), SHIPPED, output=output, clock=lambda: self.world.steps)
        self.random = random.Random(seed)
        self.tilt = tilt
        if fullscreen:
            self.fullscreen = fullscreen

        self.levels: list[Level] = []
        """The levels at play, in the order in which they were loaded."""
        self._functions = Functions()
        self._recorder: Recorder | None = None
        self._playback: replaying.Playback | None = None
        self._clock = Clock()
        self._light_quality = LightQuality()
        self._alpha = 1.0
        self._steps_made = 0  # in all scenes
        self._blank = self.world.snapshot()
        self._watchers: list[Callable[[Event], object]] = []  # who look on, such as the keys of `evil play`
        self._busy = ""  # inside which part of a frame a callback runs
        self._when_over: list[Callable[[], object]] = []  # what is put off until that part is over
        self._tilted: tuple[Vec2, Vec2] | None = None  # the direction last set, and the gravity it gave
        self._strength = 0.0

        self.on_event: Callbacks[[Event]] = Callbacks("game.on_event", "event")
        self.on_update: Callbacks[[float]] = Callbacks("game.on_update", "dt")
        self.on_draw: Callbacks[[]] = Callbacks("game.on_draw")

    # One frame ------------------------------------------------------------------------------------------------------

    @known_keywords
    def frame(self, now: float) -> None:
        """One frame at wall time `now`, in seconds: the steps that are due, then the picture. `run` calls it."""
        self._refuse_in_a_callback("Game.frame")
        self.timings.begin()
        tick = self._clock.hold(now) if self.paused else self._clock.advance(now, self.speed)
        asked = self._press_window_keys(self._listen())
        if self.paused:
            self._inputs = self._interaction.snapshot(self.views.to_world, 0.0)  # nothing waits for the pause to end
        for _ in range(tick.steps):
            if self.paused or not self.running:
                break
            self._step()
        self._alpha = tick.alpha
        self.timings.steps()
        self._draw()
        self.renderer.show(self.device)
        self._hear(paused=self.paused)
        self.timings.shown()
        self._light_quality.note(self)
        self._tidy_notice(now)
        for each in asked:
            each()

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

    def _listen(self) -> tuple[Event, ...]:
        events = self.device.poll()
        self._interaction.collect(events)
        for event in events:
            if isinstance(event, CloseEvent):
                self.quit()
            elif isinstance(event, ResizeEvent):
                if self._playback is None or self._playback.over:
                    self.views.size = event.size
                self._pictures.scale = self.device.scale
            self.on_event.run(event)
            for watch in tuple(self._watchers):
                watch(event)
        return events

    def _step(self) -> None:
        if self._playback is not None and not self._playback.over:
            self._playback.catch_up()
        if not self._steps_made:
            scenes.begins(self)
        self._steps_made += 1
        self._busy = "a step"
        try:
            self._inputs = self._inputs_of_step()
            self._tell_inputs(self._inputs, self.world)
            self.timer.run_due()
            self.on_update.run(STEP)
            if self.tilt:
                self._turn_gravity(self._inputs.tilt.direction)
            self.world.step(STEP, self.substeps)
            self.scene.step()
            self.views.step()
        finally:
            self._busy = ""
        self._note_step()
        self._hear()
        self._do_what_waited()

    def _inputs_of_step(self) -> Inputs:
        """What the player does, or did when this was recorded."""
        inputs = self._interaction.snapshot(self.views.to_world, STEP)
        if self._playback is not None and not self._playback.over:
            inputs = self._playback.begin_step()
        if self._recorder is not None:
            self._recorder.begin_step(inputs, self.views.size)
        return inputs

    def _note_step(self) -> None:
        """Note for a recording what came of the step, and compare it with what was recorded."""
        if self._playback is not None:
            self._playback.end_step()
        if self._recorder is not None and self._recorder.steps % replaying.interval_of(self) == 0:
            self._recorder.end_step(replaying.sums_of(self))

    def _draw(self) -> None:
        self._busy = "drawing"
        try:
            self.on_draw.run()
            frame = self._collect()
            self.timings.collected()
            self.renderer.draw(frame)
            self.timings.drawn()
        finally:
            self._busy = ""
        self._do_what_waited()

    def _collect(self, *, overlay: bool = True) -> DrawList:
        device = self.device
        return collect_views(self.scene, self.views, self._alpha, device.pixel_size, device.scale, overlay=overlay)

    def _hear(self, *, paused: bool = False) -> None:
        places = [(view.camera.position, view.camera.angle) for view in self.views if view.visible and view.hears]
        first, *others = places or [(self.camera.position, self.camera.angle)]
        listener = Listener(*first, tuple(Listener(*place) for place in others))
        self.audio.update(listener, paused=paused, tempo=self.speed)

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

    # Saving -----------------------------------------------------------------------------------------------------------

    @known_keywords
    def save(self, slot: str, *, folder: str | Path | None = None) -> Path:
        """Save the whole game in `slot`, a name of letters, digits, dashes and underscores; returns the file.

        It lies in the user's data folder, under the title of the game, or in `folder`. The file is written whole or not
        at all, and the save before it is kept as a backup. Inside a callback of a step, the save is made when that step
        is over. Raises SaveError for functions (timers, callbacks of bodies, motions) that could not be found again by
        name, see `register`, and when the file cannot be written; what was saved before is there then.
        """
        slots = Slots(self.title, folder)
        path = slots.path(slot, "Game.save")
        self._when_free(lambda: saving.save(self, slots, path))
        return path

    @known_keywords
    def resume(self, slot: str, *, folder: str | Path | None = None) -> None:
        """Become the game that was saved in `slot`, also by another process: it goes on as if it had never stopped.

        What the player held at the time is let go of. Handles of things that are the same then and now stay good; find
        others by their tags. The game's own callbacks (`on_update` and its kin) stay as they are. If the file is
        damaged, the backup is used, with a line of notice. Inside a callback of a step, it happens when that is over.

        Raises SaveError, and changes nothing, when there is no such save, or it cannot be used.
        """
        slots = Slots(self.title, folder)
        path = slots.path(slot, "Game.resume")
        self._when_free(lambda: saving.resume(self, slots, path))

    @known_keywords
    def register(self, name: str, function: F) -> F:
        """Let saved games call `function` by `name`; returns it.

        Functions at the top of a module need no name. Others (methods, functions inside functions) do, if they are on a
        timer, on a body or a motion when the game is saved; register them again before `resume`.

        >>> game = Game(headless=True)
        >>> def coins(worth):
        ...     return lambda: print("worth", worth)
        >>> ring = game.register("ten coins", coins(10))
        >>> game.timer.after(2.0, ring)
        <Event at 2 s>
        """
        self._functions.register(name, function)
        return function

    @known_keywords
    def record(self, path: str | Path) -> Recorder:
        """Record every step from now on into a file (.evr), until the game or the recording is closed.

        A recording holds what the player did and sums of what came of it; `evil replay` plays it, and says where the
        game first parts from it. A game in Python is best recorded from its first step; later, it must be one that can
        be saved. Raises SaveError if the file cannot be written.
        """
        if getattr(STAGE.get(), "replays", False):  # a program that is played from a recording of it
            path = os.devnull
        recorder = replaying.record(self, to_path(path, "Game.record"))
        self._stop_recording()
        self._recorder = recorder
        return recorder

    @known_keywords
    def replay(self, path: str | Path) -> replaying.Playback:
        """Take the player's part from a recording, for as many steps as it has.

        The game must have been made as the recorded one was; its own keys and fingers count again when the recording is
        over. The playback's `difference` says where the game first came out otherwise, None if nowhere.

        >>> def play():
        ...     game = Game(headless=True)
        ...     ball = game.add(evil.Circle(0.5), at=(0, 4))
        ...     return game
        >>> game = play()
        >>> recording = game.record("fall.evr"); game.step(60); recording.close()
        >>> again = play()
        >>> playback = again.replay("fall.evr"); again.step(60)
        >>> playback.over, playback.difference
        (True, None)
        """
        self._refuse_in_a_callback("Game.replay")
        self._playback = replaying.play(self, Replay.read(to_path(path, "Game.replay")))
        return self._playback

    def _stop_recording(self) -> None:
        if self._recorder is not None:
            self._recorder.close()
            self._recorder = None

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

    def close(self) -> None:
        """Close the window. A game that has ended can still be asked, not shown."""
        self.running = False
        self._stop_recording()
        self.audio.close()
        self.renderer.attach(None)
        self.device.close()

    def capture(self) -> Image:
        """The picture as it is now, in real pixels."""
        self._refuse_in_a_callback("Game.capture")
        self._draw()
        return self.renderer.capture()


make_up(Game, Life, GameScreen, Controls, Things)
