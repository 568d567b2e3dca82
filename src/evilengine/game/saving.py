"""What a saved game holds, and the game that comes of it (SPEC A9): every module's own state, side by side.

Resuming reads and checks everything first. Only when all of it is sound does anything of the game change.
"""

from __future__ import annotations

import json
import random
import struct
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.audio import saving as sounds
from evilengine.game import scenes
from evilengine.game.controls import read_driver
from evilengine.level.rules import Rounds
from evilengine.level.saving import LevelState, LevelWriter, reference
from evilengine.save import Container, Slots
from evilengine.save import inputs as inputs_code
from evilengine.save.container import Sections
from evilengine.scene import saving as looks
from evilengine.timer import saving as timers
from evilengine.timer.schedule import is_over
from evilengine.values import checks
from evilengine.values.errors import Error, SaveError, SnapshotError
from evilengine.values.tick import FASTEST, SLOWEST
from evilengine.values.vec2 import to_vec2
from evilengine.values.version import VERSION
from evilengine.world import behaviours
from evilengine.world import saving as worlds
from evilengine.world.smoke import Smoke, Source
from evilengine.world.water import Stream, Water, liquids_of

if TYPE_CHECKING:
    from evilengine.game.game import Game

SAVED_GAME = Container(b"EVILSAVE", "a saved game", 0, {})

_RANDOM = struct.Struct("<625I?d")

NOT_SOUND = (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError, struct.error)
"""What reading a state raises that no game has written."""


def save(game: Game, slots: Slots, path: Path, origin: str = "") -> None:
    """Write the game into a slot; while a recording is played, what it saved then stays as it is."""
    if game._playback is not None and not game._playback.over:
        return
    slots.write(path, to_bytes(game, origin), lambda data: SAVED_GAME.read(data, path.name))


def resume(game: Game, slots: Slots, path: Path) -> None:
    """Read the game from a slot; while a recording is played, from there."""
    if game._playback is not None and game._playback.resumes:
        from_bytes(game, game._playback.resumed(), path.name)
        return
    sections = slots.read(path, SAVED_GAME.read)
    _become(game, sections, path.name)
    if game._recorder is not None:
        game._recorder.resumed(SAVED_GAME.write(sections))


def origin_of(slots: Slots, path: Path) -> str:
    """The file that the game in a slot was started from, "" if nobody said."""
    return str(json.loads(slots.read(path, SAVED_GAME.read)["about"])["origin"])


def to_bytes(game: Game, origin: str = "") -> bytes:
    """The game as it is now; `origin` is the file that it was started from.

    Raises SaveError for functions that have no name, and says which.
    """
    try:
        worlds.check_python_forces(game.world)
        world = game.world.snapshot()
    except SnapshotError as problem:
        raise SaveError(f"Game.save: {problem}") from problem
    levels = [LevelWriter(level) for level in game.levels]

    def name_of(function: Callable[..., Any], where: str) -> Any:
        for number, level in enumerate(levels):
            name = level.name_of(function)
            if name is not None:
                return {"level": number, **name}
        if is_over(function):
            function = nothing
        return _method(function) or game._functions.name_of(function, f"Game.save: {where}")

    drawings, scene = looks.state_of(game.scene)
    emitters, particles = looks.emitters_state(game.scene)
    tilted = None if game._tilted is None else [list(each) for each in game._tilted]
    about = {"title": game.title, "engine": VERSION, "origin": origin}
    rest: dict[str, Any] = {
        "life": {**scenes.state_of(game), "speed": game.speed, "substeps": game.substeps},
        "tilt": game.tilt,
        "paused": game.paused,
        "tilted": tilted,
        "strength": game._strength,
        "views": game.views.state(),
        "scene": scene,
        "emitters": emitters,
        "timer": timers.state_of(game.timer, lambda call, where: name_of(call, f"game.timer, {where}")),
        "behaviours": behaviours.state_of(game.world, name_of),
        "driver": None if game._driver is None else game._driver.state(),
        "interaction": game._interaction.state(),
        "grabs": game._grabs.state(),
        "audio": sounds.state_of(game.audio, reference),
    }
    rest["levels"] = [level.state() for level in levels]  # last: the others name what is in them
    return SAVED_GAME.write(
        {
            "about": _json(about),
            "game": _json(rest),
            "world": world,
            "drawings": drawings,
            "particles": b"".join(particles),
            "random": _random_state(game),
            "inputs": inputs_code.encode(game.inputs),
        }
    )


def from_bytes(game: Game, data: bytes, name: str) -> None:
    """Become the game that `data` holds: wholly, or SaveError is raised and the game is as it was."""
    _become(game, SAVED_GAME.read(data, name), name)


def _become(game: Game, sections: Sections, name: str) -> None:
    try:
        put = _read(game, sections)
        there = scenes.return_to(game, json.loads(sections["game"]).get("life", {}))
        if there is not None:
            there()
            put = _read(game, sections)  # again: what is there now is another game's
    except SaveError as problem:
        raise SaveError(f"Game.resume: {name}: {problem}") from problem
    except (SnapshotError, *NOT_SOUND) as problem:
        raise SaveError(f"Game.resume: {name} contradicts itself: {problem}") from problem
    except Error as problem:
        raise SaveError(f"Game.resume: {name}: {problem}") from problem
    put()


def _read(game: Game, sections: Sections) -> Callable[[], None]:
    state = json.loads(sections["game"])
    world = _core.Saved(sections["world"])
    worlds.check_notes(game.world, world.notes)
    bodies, _, forces, joints, smokes, sources, waters, streams, liquids = map(set, world.slots)
    scene = looks.SceneState(game.scene, sections["drawings"], state["scene"])
    emitters = looks.read_emitters(game.scene, state.get("emitters", []), sections.get("particles", b""), bodies)
    none, body_of = _core.NO_SLOT, dict(zip(world.slots[1], world.shape_bodies, strict=True))
    bodies_and_none = bodies | {none}
    if not all(
        body in bodies_and_none and (shape == none or body_of.get(shape) == body) for _, body, shape in scene.places
    ):
        raise ValueError("drawings on what is not there")
    if not bodies_and_none.issuperset(scene.lit_by):
        raise ValueError("lights on what is not there")
    events = {row[0] for row in state["timer"]["events"]}
    known = {
        "body": bodies,
        "force": forces,
        "joint": joints,
        "smoke": smokes,
        "source": sources,
        "water": waters,
        "stream": streams,
        "liquid": liquids,
        "drawing": scene.slots,
        "text": scene.texts,
        "emitter": emitters.serials,
        "light": scene.light_slots,
        "event": events,
    }
    present = [*game.levels, *[None] * len(state["levels"])]
    levels = [LevelState(game, each, known, present[n]) for n, each in enumerate(state["levels"])]
    handles: list[tuple[_Later, list[Any]]] = []

    def find(name: Any, body: int | None = None) -> Callable[..., Any]:
        match name:
            case str():
                return game._functions.find(name)
            case {"level": int(number), **rest}:
                return levels[number].find({str(kind): row for kind, row in rest.items()}, body)
        raise ValueError(f"{name!r} is no function")

    def find_for_timer(name: Any) -> Callable[..., Any]:
        match name:
            case {"destroy": [str(kind), int(number)]} if number in known[kind]:
                later = _Later()
                handles.append((later, [kind, number]))
                return later
        return find(name)

    timer = timers.read(game.timer, state["timer"], find_for_timer)
    in_world = behaviours.read(game.world, state["behaviours"], find, bodies, joints)
    driver = read_driver(game.world, state.get("driver"), bodies)
    interaction = game._interaction.read(state["interaction"])
    heard = sounds.read(game.audio, state["audio"], bodies)
    grabs = game._grabs.read(state["grabs"], game.world, bodies)
    views = game.views.read(state["views"], bodies)
    dice, inputs = _read_random(sections["random"]), inputs_code.decode(sections["inputs"])
    tilted = None
    if state["tilted"] is not None:
        direction, gravity = (to_vec2(each, "game", "tilted") for each in state["tilted"])
        tilted = (direction, gravity)
    tilt, paused, strength = bool(state["tilt"]), bool(state["paused"]), float(state["strength"])
    life = state.get("life", {})
    speed = checks.number(life.get("speed", 1.0), "game", "speed", least=SLOWEST, most=FASTEST)
    substeps = checks.parts(life.get("substeps", 4), "game")

    def put() -> None:
        worlds.become(game.world, world)
        scene.put()
        emitters.put(game.world._body)
        in_world()
        game._driver = driver()
        timer()
        waiting = {event._order: event for event in game.timer.events}
        things: dict[str, Callable[[int], Any]] = {
            "body": game.world._body,
            "force": game.world._forces.__getitem__,
            "joint": game.world._joints.__getitem__,
            "smoke": lambda slot: Smoke(game.world, slot),
            "source": lambda slot: Source(game.world, slot),
            "water": lambda slot: Water(game.world, slot),
            "liquid": lambda number: next(each for each in liquids_of(game.world) if each.number == number),
            "stream": lambda slot: Stream(game.world, slot),
            "drawing": scene.drawing,
            "text": scene.text,
            "emitter": emitters.emitter,
            "light": game.lights._in_slot,
            "event": waiting.__getitem__,
        }
        for later, (kind, number) in handles:
            later.call = things[kind](number).destroy
        for event in waiting.values():
            if isinstance(event._call, _Later):
                event._call = event._call.call
            if isinstance(event._call, Rounds):
                event._call.event = event
        for level in tuple(game.levels):
            if level not in [each.level for each in levels]:
                level.ignore()
        for each in levels:
            each.put(things)
        interaction()
        grabs()
        heard(game.world._body)
        views(game.world._body)
        game.random.setstate(dice)
        game._inputs, game._alpha = inputs, 1.0
        game.tilt, game.paused, game._tilted, game._strength = tilt, paused, tilted, strength
        game.speed, game.substeps = speed, substeps
        scenes.put_level(game)

    return put


def nothing() -> None:
    """What a saved game calls instead of destroying something that was gone when it was saved."""


class _Later:
    """Stands for a function until what it belongs to is there."""

    def __init__(self) -> None:
        self.call: Callable[..., Any] = self

    def __call__(self) -> None: ...


def _json(state: dict[str, Any]) -> bytes:
    return json.dumps(state, allow_nan=False, separators=(",", ":"), sort_keys=True).encode()


def _random_state(game: Game) -> bytes:
    version, words, spare = game.random.getstate()
    if version != 3:
        raise SaveError("Game.save: game.random is no random.Random that this engine knows how to keep")
    return _RANDOM.pack(*words, spare is not None, 0.0 if spare is None else spare)


def _read_random(data: bytes) -> tuple[Any, ...]:
    *words, has_spare, spare = _RANDOM.unpack(data)
    state = (3, tuple(words), spare if has_spare else None)
    random.Random().setstate(state)  # raises ValueError for what is no state
    return state


def _method(function: Callable[..., Any]) -> dict[str, Any] | None:
    """What a saved game calls `body.destroy` and its like, which people plan for later."""
    owner = getattr(function, "__self__", None)
    if getattr(function, "__name__", "") != "destroy" or not getattr(owner, "alive", False):
        return None
    found = reference(owner)
    return None if found is None else {"destroy": found}
