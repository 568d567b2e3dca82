"""The course of a game: its scenes, how fast its time goes, its end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from evilengine.game import scenes
from evilengine.values.checks import known_keywords, number, parts
from evilengine.values.errors import Error
from evilengine.values.tick import FASTEST, SLOWEST

if TYPE_CHECKING:
    from evilengine.game.game import Game


class Life:
    """The part of a game that says what plays, and how fast."""

    _busy: str
    _when_over: list[Callable[[], object]]

    def __init__(self) -> None:
        super().__init__()
        self.scenes = scenes.Scenes()
        """The scenes of the game by name; `@game.scenes` makes a function one. `game.scenes.present` is what plays."""
        self.paused = False
        """Does the world stand still? The picture lives on, and `on_event` and `on_draw` are called."""
        self.running = True
        """False once it was told to quit."""
        self._speed = 1.0
        self._substeps = 4

    @known_keywords
    def go(self, scene: str | Path, *arguments: Any, sounds: str = "stop") -> None:
        """Begin another scene: one that `@game.scenes` made, with these arguments, or a level (`"level2.evil"`).

        Everything of the scene before is gone then: bodies, forces, drawings, texts, timers, levels, and the callbacks
        that the game was given since its first step. Gravity, tilt, camera and background are as they were before that;
        time starts at 0. `game.random`, volumes and the keys that are held stay. `sounds` says what becomes of what is
        heard: "stop", "music" for the music alone to play on, or "keep".

        Inside a callback of a step it happens when that is over, so nothing vanishes under anybody's hands; the last
        of several calls counts. Raises ArgumentError for a scene that does not exist, AssetError and LevelError for a
        level that cannot be read, and the scene that plays goes on then.

        >>> game = evil.Game(headless=True)
        >>> @game.scenes
        ... def play():
        ...     ball = game.add(evil.Circle(0.5), at=(0, 3))
        ...     game.timer.after(0.5, lambda: game.go("over", 7))
        >>> @game.scenes
        ... def over(points):
        ...     game.text(f"{points} points")
        >>> game.go("play"); game.step(29); game.scenes.present
        'play'
        >>> game.step(2); game.scenes.present, len(game.world.bodies), game.world.steps
        ('over', 0, 0)
        """
        self._visit(scenes.visit(cast("Game", self), scene, arguments, sounds))

    @known_keywords
    def restart(self, *, sounds: str = "stop") -> None:
        """Begin the present scene again, with the same arguments; a level that was loaded by itself counts as one."""
        self._visit(scenes.again(cast("Game", self), sounds))

    def _note_settings(self) -> None:
        """A level is about to change what the game was told about itself."""
        scenes.settings_of(cast("Game", self))

    def _visit(self, to: scenes.Visit) -> None:
        game = cast("Game", self)
        going = _Going(game, replace(to, inside=self._busy in ("a step", scenes.BEGINNING)))
        if not self._busy:
            going()
            self._do_what_waited()
            return
        self._when_over = [each for each in self._when_over if not isinstance(each, _Going)]
        self._when_over.append(going)

    def _when_free(self, do: Callable[[], object]) -> None:
        """Do it now or, inside a callback, when the part of the frame that called it is over."""
        if self._busy:
            self._when_over.append(do)
        else:
            do()

    def _do_what_waited(self) -> None:
        for _ in range(scenes.MOST_IN_A_ROW):
            if not self._when_over:
                return
            waiting, self._when_over = self._when_over, []
            for do in waiting:
                do()
        self._when_over = []
        raise Error(f"Game.go: {scenes.MOST_IN_A_ROW} scenes passed on to each other without a step between them")

    @property
    def speed(self) -> float:
        """How fast the game's time goes: 0.25 is slow motion, 2 twice as fast; from 0.05 to 4.

        The steps stay 1/60 s, and fewer or more of them are made in a second, so the game plays the same, bit for bit;
        in slow motion the picture goes between two steps and stays smooth. From a sound card, groups that pause with
        the game slow down and deepen with it. A film shows it as the window does; a .wav file, like `game.step`, knows
        steps alone and hears the game at its own pace.
        """
        return self._speed

    @speed.setter
    def speed(self, value: float) -> None:
        self._speed = number(value, "Game", "speed", least=SLOWEST, most=FASTEST)

    @property
    def substeps(self) -> int:
        """In how many parts the world makes a step, from 1 to 256; 4 unless told.

        More parts cost more time and hold more: 8 bear high towers, 16 ten boxes with one on them a hundred times as
        heavy. A scene begins with what the game was told before its first step, and saved games keep it.

        >>> game = evil.Game(headless=True)
        >>> game.substeps = 16
        """
        return self._substeps

    @substeps.setter
    def substeps(self, value: int) -> None:
        self._substeps = parts(value, "Game")

    def quit(self) -> None:
        """Stop `run` after this frame."""
        self.running = False


class _Going:
    """A scene that is gone to as soon as nothing of the present one runs."""

    def __init__(self, game: Game, to: scenes.Visit) -> None:
        self._game, self._to = game, to

    def __call__(self) -> None:
        scenes.go(self._game, self._to)
