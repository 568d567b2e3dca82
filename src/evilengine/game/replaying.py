"""Recording a game, and playing a recording: the same inputs in the same steps, and sums of what comes of them."""

from __future__ import annotations

import hashlib
import struct
import sys
import zlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from evilengine.game import saving, scenes
from evilengine.save.replay import MODULES, Recorder, Replay, Step, Sums, Visited
from evilengine.values.errors import Error, SaveError
from evilengine.values.inputs import Inputs
from evilengine.values.tick import STEP
from evilengine.values.version import VERSION
from evilengine.world import saving as worlds
from evilengine.world.forces import PYTHON

if TYPE_CHECKING:
    from evilengine.game.game import Game

BODIES_A_STEP = 300
"""Bodies that are summed in each step, on average: with more, sums are taken more seldom, so that a recording costs the
same however large the world is."""
SELDOMEST = 60  # steps

LEVEL, PROGRAM = "level", "program"
"""What made the recorded game: a level, whose source the recording holds, or a program in Python, which runs again."""


@dataclass(frozen=True, slots=True)
class Difference:
    """Where a game that is played again first parts from its recording."""

    step: int
    """Counted from 1, the first step of the recording."""
    modules: tuple[str, ...]
    """Which of "bodies", "contacts", "forces", "timers" and "random" are not as they were."""

    def __str__(self) -> str:
        return f"step {self.step} ({self.step * STEP:.2f} s) in {', '.join(self.modules)}"


def sums_of(game: Game) -> Sums:
    """32 bits of each part of a game's state."""
    if any(force._kind == PYTHON for force in game.world._forces.values()):
        worlds.note_python_forces(game.world)
    bodies, contacts, forces = game.world._core.sums()
    timer, (_, dice, spare) = game.timer, game.random.getstate()
    first = timer._heap[0][:2] if timer._heap else (0.0, 0)
    # The Mersenne Twister's position and its first word change with every draw; that is enough to tell two apart.
    random = struct.pack("<2I?", dice[-1], dice[0], spare is not None)
    events = struct.pack("<2QdQ", timer._made, len(timer._heap), *first)
    low = 0xFFFFFFFF
    return bodies & low, contacts & low, forces & low, zlib.crc32(events), zlib.crc32(random)


def interval_of(game: Game) -> int:
    """How many steps apart sums are taken."""
    return min(max(1, -(-len(game.world.bodies) // BODIES_A_STEP)), SELDOMEST)


def record(game: Game, path: Path, *, level: bool = False) -> Recorder:
    """Record `game` from now on; with `level`, nothing but a level made it."""
    header: dict[str, Any] = {
        "engine": VERSION,
        "title": game.title,
        "size": [round(side) for side in game.views.size],
        "of": LEVEL if level else PROGRAM,
        "hash": "",
    }
    program = getattr(sys.modules.get("__main__"), "__file__", None)
    if level:
        source = game.levels[0].script
        folder = str(Path(source.folder).resolve()) if source.folder else ""
        header |= {"file": source.file, "folder": folder, "text": source.text}
        header["hash"] = hash_of(source.text.encode("utf-8", "surrogatepass"))
    elif program is not None and Path(program).is_file():
        header |= {"file": str(Path(program).resolve()), "hash": hash_of(Path(program).read_bytes())}
    return Recorder(path, header, saving.to_bytes(game) if game._steps_made or game.world.steps else None)


def hash_of(source: bytes) -> str:
    """What tells one source from another."""
    return hashlib.blake2b(source, digest_size=16).hexdigest()


class Playback:
    """A recording that a game plays: it gives each step its inputs, and looks whether the same comes of them.

    `difference` is None as long as everything is as it was recorded.
    """

    def __init__(self, game: Game, replay: Replay) -> None:
        self.replay = replay
        self.difference: Difference | None = None
        self._game = game
        self._step: Step | None = None
        self._made = 0
        self._between = list(replay.between)

    @property
    def over(self) -> bool:
        """Has every step of the recording been made?"""
        return self._made >= len(self.replay.steps)

    @property
    def made(self) -> int:
        """How many of its steps have been made."""
        return self._made

    @property
    def resumes(self) -> bool:
        """Does a saved game come from here rather than from the disk?"""
        return not self.over or bool(self._between)

    def begin_step(self) -> Inputs:
        """The inputs of the step that begins now; there must be one."""
        self._step = step = self.replay.steps[self._made]
        self._made += 1
        self._between = list(step.between)
        if step.size != self._game.views.size:
            self._game.views.size = step.size
        return step.inputs

    def end_step(self) -> None:
        """Compare what came of the step with what was recorded."""
        recorded = self._step.sums if self._step is not None else None
        self._step = None
        if recorded is None or self.difference is not None:
            return
        wrong = tuple(
            name for name, now, then in zip(MODULES, sums_of(self._game), recorded, strict=True) if now != then
        )
        if wrong:
            self.difference = Difference(self._made, wrong)

    def resumed(self) -> bytes:
        """The saved game that was resumed here when this was recorded."""
        if not self._between or not isinstance(self._between[0], bytes):
            raise SaveError(f"{self.replay.name} has no saved game that was resumed in step {self._made}")
        return self._between.pop(0)  # type: ignore[return-value]

    def goes(self, to: scenes.Visit) -> bool:
        """Does the game go to this scene now? Outside of steps, only where it did when this was recorded."""
        next_one = self._between[0] if self._between else None
        if isinstance(next_one, Visited) and (next_one.name, next_one.inside) == (to.name, to.inside):
            self._between.pop(0)
            return True
        return to.inside or not self.resumes

    def source_of(self, name: str) -> str | None:
        """The level that was read from the file `name` here when this was recorded, None if none was."""
        found = (each for each in self._between if isinstance(each, Visited) and each.name == name)
        return next((each.source for each in found), None)

    def catch_up(self) -> None:
        """Before a step: do what was done here outside of steps, when this was recorded, and nobody did this time."""
        while self._between:
            match self._between[0]:
                case Visited(inside=False, name=name, arguments=arguments, sounds=sounds, source=source):
                    if source is None and name.endswith(".evil"):
                        scenes.go(self._game, scenes.again(self._game, sounds))
                    else:
                        scenes.go(self._game, scenes.visit(self._game, name, arguments, sounds))
                case bytes() as saved:
                    self._between.pop(0)
                    saving.from_bytes(self._game, saved, self.replay.name)
                case _:
                    self._between.pop(0)


def game_of(replay: Replay, **options: Any) -> Game:
    """The game that a recording of a level begins with. `options` are those of Game.

    Raises SaveError for a recording of a program, which only that program can begin again.
    """
    from evilengine import level, script
    from evilengine.game.game import Game

    header = replay.header
    if header.get("of") != LEVEL:
        raise SaveError(f"{replay.name} is of a program in Python, {header.get('file')}; run that to replay it")
    try:
        file, source, folder = (str(header[word]) for word in ("file", "text", "folder"))
        width, height = (int(side) for side in header["size"])
    except (KeyError, ValueError, TypeError) as problem:
        raise SaveError(f"{replay.name} does not say what it begins with: {problem!r}") from problem
    found, errors = script.check(source, file)
    if errors:
        raise SaveError(f"{replay.name} is of a level that this engine cannot read: {errors[0].headline}")
    folder = folder if Path(folder).is_dir() else ""
    title = str(header.get("title"))
    game = Game(title, **{"size": (width, height), "folder": folder or Path.cwd(), **options})
    if replay.state is None:
        level.build(replace(found, folder=folder), game)
    return game


def play(game: Game, replay: Replay) -> Playback:
    """Let `game`, which was just made as the recorded one was, play `replay`."""
    if replay.state is not None:
        saving.from_bytes(game, replay.state, replay.name)
    elif game._steps_made or game.world.steps:
        made = game._steps_made or game.world.steps
        raise Error(f"Game.replay: {replay.name} begins with the first step; this game has made {made}")
    return Playback(game, replay)
