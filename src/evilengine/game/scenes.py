"""Scenes: what a game is made of, one after the other: a menu, its levels, the end."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any, TypeVar, overload

from evilengine.save.replay import Visited
from evilengine.scene.views import Note
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import did_you_mean, one_of
from evilengine.values.colour import Colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError, Error
from evilengine.values.level import LevelScript
from evilengine.values.vec2 import Vec2

if TYPE_CHECKING:
    from evilengine.game.game import Game

F = TypeVar("F", bound=Callable[..., Any])

SOUNDS = ("stop", "music", "keep")
"""What becomes of sounds when a scene ends: all stop, only the music goes on, all go on."""

FADE = 0.1
"""Seconds in which a scene's sounds die away: short enough to be over with it, long enough not to click."""

MOST_IN_A_ROW = 100
"""Scenes that may pass on to each other without a step between them; more go round in circles."""


BEGINNING = "the beginning of a scene"
"""What the game is busy with while a scene is built."""


@dataclass(frozen=True, slots=True)
class Visit:
    """One visit to a scene: its name, what it is begun with, and of a level its commands."""

    name: str
    arguments: tuple[Any, ...] = ()
    script: LevelScript | None = None
    sounds: str = "stop"
    inside: bool = False
    """Was it asked for inside a step? What plays a recording asks again by itself then."""
    read: bool = False
    """Was the level read from its file just now? A recording keeps it then."""


@dataclass(frozen=True, slots=True)
class Settings:
    """What a game was told about itself before it began: each of its scenes begins with it."""

    gravity: Vec2
    sleep: bool
    substeps: int
    tilt: bool
    background: Colour
    views: tuple[Note, ...]
    """What each view shows, and where."""
    air: tuple[dict[str, Any], dict[str, Any]]
    """How layers are seen, and what is done to the picture."""


class Scenes:
    """The scenes of a game. Calling it with a function makes that a scene, of the function's name or of one given.

    >>> game = evil.Game(headless=True)
    >>> @game.scenes
    ... def menu():
    ...     game.text("space begins", anchor="centre", at=(0, 0))
    >>> @game.scenes("play")
    ... def play_level(number=1):
    ...     for n in range(number):
    ...         game.add(evil.Circle(0.5), at=(n, 0))
    >>> list(game.scenes), game.scenes.present
    (['menu', 'play'], None)
    >>> game.go("play", 3); game.scenes.present, len(game.world.bodies)
    ('play', 3)
    >>> game.go("menu"); len(game.world.bodies)
    0
    """

    def __init__(self) -> None:
        self._builders: dict[str, Callable[..., object]] = {}
        self._now: Visit | None = None
        self._settings: Settings | None = None
        self._callbacks: list[tuple[Callbacks[...], tuple[Callable[..., Any], ...]]] | None = None

    @overload
    def __call__(self, scene: str) -> Callable[[F], F]: ...
    @overload
    def __call__(self, scene: F) -> F: ...
    def __call__(self, scene: Any) -> Any:
        """Make a function a scene: `@game.scenes`, or `@game.scenes("name")`."""
        if isinstance(scene, str):
            return lambda function: self._add(scene, function)
        return self._add(getattr(scene, "__name__", ""), scene)

    def __iter__(self) -> Iterator[str]:
        """Their names, in the order in which they were made."""
        return iter(self._builders)

    def __len__(self) -> int:
        return len(self._builders)

    def __contains__(self, name: object) -> bool:
        return name in self._builders

    @property
    def present(self) -> str | None:
        """The name of the scene at play; a level's is that of its file. None before the first."""
        return None if self._now is None else self._now.name

    def _add(self, name: str, function: F) -> F:
        if not callable(function):
            raise ArgumentTypeError(f"game.scenes: {function!r} must be a function that builds the scene")
        if not name or name.endswith(".evil") or name == "<lambda>":
            raise ArgumentError(f'game.scenes: a scene cannot be called {name!r}; give it a name: game.scenes("menu")')
        if name in self._builders:
            raise ArgumentError(f"game.scenes: there is a scene {name!r} already")
        self._builders[name] = function
        return function


def visit(game: Game, scene: object, arguments: tuple[Any, ...], sounds: str) -> Visit:
    """What `game.go` was asked for, or an error that says what there is."""
    one_of(sounds, "Game.go", "sounds", SOUNDS)
    if not isinstance(scene, (str, PurePath)):
        raise ArgumentTypeError(f"Game.go: scene={scene!r} must be the name of a scene, or of a level file (.evil)")
    name = str(scene)
    try:
        json.dumps(arguments, allow_nan=False)
    except (TypeError, ValueError):
        raise ArgumentTypeError(
            f"Game.go({name!r}): {arguments!r} must be numbers, text, True, False, None, or lists of them, which can be"
            " saved with the game"
        ) from None
    if name in game.scenes:
        return Visit(name, arguments, sounds=sounds)
    if not name.endswith(".evil"):
        known = list(game.scenes)
        there_are = f"; there are {', '.join(known)}" if known else "; @game.scenes makes one"
        raise ArgumentError(f"Game.go: there is no scene {name!r}{did_you_mean(name, known)}{there_are}")
    if arguments:
        raise ArgumentError(f"Game.go({name!r}): a level takes no arguments; got {arguments!r}")
    from evilengine import script  # games without levels need no parser

    source = None if game._playback is None else game._playback.source_of(name)
    if source is not None:
        found, errors = script.check(source, name)
        if errors:
            raise ArgumentError(f"Game.go({name!r}): this engine cannot read the level: {errors[0].headline}")
        folder = Path(game.folder, name).parent
        return Visit(name, script=replace(found, folder=str(folder)), sounds=sounds, read=True)
    return Visit(name, script=script.read_file(game.find(name)), sounds=sounds, read=True)


def again(game: Game, sounds: str) -> Visit:
    """What `game.restart` is about: the present scene, or the level that was loaded without one."""
    one_of(sounds, "Game.restart", "sounds", SOUNDS)
    now = game.scenes._now
    if now is not None:
        return replace(now, sounds=sounds, read=False)
    if len(game.levels) == 1:
        source = game.levels[0].script
        return Visit(PurePath(source.file).name, script=source, sounds=sounds)
    raise Error("Game.restart: no scene has begun; game.go(...) begins one")


def go(game: Game, to: Visit) -> None:
    """Go to a scene now, and to those that it passes on to; a recording notes it, or says whether it happens."""
    if game._playback is not None and not game._playback.goes(to):
        return
    if game._recorder is not None and (to.read or not to.inside):
        source = to.script.text if to.script is not None and to.read else None
        game._recorder.visited(Visited(to.name, to.arguments, source, to.inside, to.sounds))
    begin(game, to)


def begin(game: Game, to: Visit) -> None:
    """End the scene that plays and begin another. Where that raises, the game is left in it, empty."""
    clear(game, to)
    before, game._busy = game._busy, BEGINNING
    try:
        if to.script is not None:
            from evilengine import level

            level.build(to.script, game)
        else:
            game.scenes._builders[to.name](*to.arguments)
    except BaseException:
        game._when_over.clear()
        clear(game, to)
        raise
    finally:
        game._busy = before


def settings_of(game: Game) -> Settings:
    """What the game was told about itself, noted when a level is about to change it, or when the game begins."""
    if game.scenes._settings is None:
        world = game.world
        game.scenes._settings = Settings(
            world.gravity, world.sleep, game.substeps, game.tilt, game.scene.background,
            game.views.notes(),
            (game.scene.layers.state(), game.scene.post.state()),
        )  # fmt: skip
    return game.scenes._settings


def begins(game: Game) -> None:
    """The first step or the first scene: the settings and callbacks that there are now last."""
    if game.scenes._callbacks is None:
        settings_of(game)
        heard = [function for level in game.levels for function in level.listening]
        every = [each for each in vars(game).values() if isinstance(each, Callbacks)]
        game.scenes._callbacks = [(each, tuple(f for f in each if f not in heard)) for each in every]


def clear(game: Game, to: Visit | None) -> None:
    """Take away everything of the scene that plays, and be in `to`, empty: as the game was made.

    What the game was told before its first step (or scene) stays: that is the game's own, not a scene's.
    """
    scenes = game.scenes
    game._grabs.let_go()
    begins(game)
    for level in tuple(game.levels):
        level.ignore()
    for callbacks, functions in scenes._callbacks or ():
        callbacks.become(functions)
    game.world.restore(game._blank)
    game.scene.clear()
    game.panel.clear()
    game.timer.clear()
    own = settings_of(game)
    game.world.gravity, game.world.sleep, game.scene.background = own.gravity, own.sleep, own.background
    game.substeps = own.substeps
    game.views.become(own.views)
    layers, post = own.air
    game.scene.layers.become(game.scene.layers.read(layers))
    game.scene.post.become(game.scene.post.read(post))
    game.tilt, game._tilted, game.paused, game.speed, game._alpha = own.tilt, None, False, 1.0, 1.0
    if to is None or to.sounds == "stop":
        game.audio.stop(fade=FADE)
    elif to.sounds == "music":
        for sound in game.audio.sounds:
            if sound is not game.audio._music:
                sound.stop(fade=FADE)
    scenes._now = to


# Saving -------------------------------------------------------------------------------------------------------------


def state_of(game: Game) -> dict[str, Any]:
    """Which scene plays, for a saved game."""
    now = game.scenes._now
    return {"scene": None if now is None else now.name, "arguments": [] if now is None else list(now.arguments)}


def return_to(game: Game, state: dict[str, Any]) -> Callable[[], None] | None:
    """What takes the game to the scene that was saved, or None if it is there. Raises ValueError for one unknown.

    A scene written in Python is begun as always, so that its callbacks are there; the save is put over it then.
    """
    name, arguments = state.get("scene"), tuple(state.get("arguments", ()))
    now = game.scenes._now
    if name is None:
        return None if now is None else lambda: clear(game, None)
    to = Visit(str(name), arguments)
    if now is not None and (now.name, json.dumps(now.arguments)) == (to.name, json.dumps(arguments)):
        return None
    if to.name.endswith(".evil"):
        return lambda: clear(game, to)
    if to.name not in game.scenes:
        raise ValueError(f"it is of the scene {to.name!r}, which this game does not have")
    return lambda: begin(game, to)


def put_level(game: Game) -> None:
    """After a resume: the level that came with the save is what starts again."""
    now = game.scenes._now
    if now is not None and now.name.endswith(".evil") and game.levels:
        game.scenes._now = replace(now, script=game.levels[0].script, read=False)
