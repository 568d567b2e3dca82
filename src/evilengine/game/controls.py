"""What the player does: held state to ask for, and the callbacks that are told when it changes."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable
from typing import Any

from evilengine.interaction import Grabs, Interaction, axis
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import known_keywords
from evilengine.values.errors import ArgumentTypeError
from evilengine.values.events import key_name
from evilengine.values.inputs import Inputs, Keys, Pointer, Tilt, Touch
from evilengine.world.character import Character
from evilengine.world.world import World

Words = str | Iterable[str]


class Steering:
    """The keys for each thing that a character does."""

    def __init__(self, left: Words, right: Words, up: Words, down: Words, jump: Words) -> None:
        self.left, self.right, self.up, self.down, jumps = map(_words, (left, right, up, down, jump))
        self.jump = tuple(key_name(name, "Game.drive", "jump") for name in jumps)
        axis(Inputs(), self.left, self.right), axis(Inputs(), self.down, self.up)  # refuses names that are none


def _words(words: Words) -> tuple[str, ...]:
    return (words,) if isinstance(words, str) else tuple(words)


class Driver:
    """Who is steered, and by which keys."""

    def __init__(self, character: Character, keys: Steering) -> None:
        self._character, self._keys = character, keys

    def drive(self, inputs: Inputs) -> None:
        """Tell the character what the player wants in this step."""
        hero, keys = self._character, self._keys
        if not hero.alive:
            return
        climb = axis(inputs, keys.down, keys.up)
        hero.move(axis(inputs, keys.left, keys.right))
        hero.climb(climb)
        if any(name in inputs.pressed for name in keys.jump):
            hero.drop() if climb < 0 else hero.jump()
        elif not any(inputs.keys[name] for name in keys.jump):
            hero.let_go()

    def stop(self) -> None:
        """Let it stand."""
        if self._character.alive:
            self._character.move(0)
            self._character.climb(0)
            self._character.let_go()

    def state(self) -> dict[str, Any] | None:
        """What a saved game keeps of it."""
        return {"body": self._character.body.slot, "keys": vars(self._keys)} if self._character.alive else None


def read_driver(world: World, state: dict[str, Any] | None, bodies: Container[int]) -> Callable[[], Driver | None]:
    """Read what `Driver.state` gave, and return what makes it once the world is restored."""
    if state is None:
        return lambda: None
    slot, keys = state["body"], Steering(**state["keys"])
    if slot not in bodies:
        raise ValueError("keys that steer what is not there")
    return lambda: Driver(Character(world._body(slot)), keys)


class Controls:
    """The part of a game that its player holds."""

    def __init__(self) -> None:
        super().__init__()
        self._interaction = Interaction()
        self._grabs = Grabs()
        self._inputs = Inputs()
        self._driver: Driver | None = None
        self.on_key_press: Callbacks[[str]] = Callbacks("game.on_key_press", "key")
        self.on_key_release: Callbacks[[str]] = Callbacks("game.on_key_release", "key")
        self.on_pointer: Callbacks[[Pointer]] = Callbacks("game.on_pointer", "pointer")
        self.on_touch: Callbacks[[Touch]] = Callbacks("game.on_touch", "touch")
        self.on_tilt: Callbacks[[Tilt]] = Callbacks("game.on_tilt", "tilt")
        self.on_shake: Callbacks[[]] = Callbacks("game.on_shake")

    def _tell_inputs(self, inputs: Inputs, world: World) -> None:
        if self._driver is not None:
            self._driver.drive(inputs)
        for key in inputs.pressed:
            self.on_key_press.run(key)
        for key in inputs.released:
            self.on_key_release.run(key)
        pointer = inputs.pointer
        if pointer.pressed or pointer.released or pointer.pixel != pointer.previous_pixel:
            self.on_pointer.run(pointer)
        for body, touch in self._grabs.update(inputs, world):
            if body.alive:
                body.on_touch.run(touch)
        for touch in inputs.touch_events:
            self.on_touch.run(touch)
        if inputs.tilt.changed:
            self.on_tilt.run(inputs.tilt)
        if inputs.tilt.shaken:
            self.on_shake.run()

    @known_keywords
    def drive(
        self,
        character: Character | None,
        *,
        left: Words = ("left", "a", "stick_left"),
        right: Words = ("right", "d", "stick_right"),
        up: Words = ("up", "w", "stick_up"),
        down: Words = ("down", "s", "stick_down"),
        jump: Words = ("space", "pad_a"),
    ) -> None:
        """Let the player's keys steer `character` from now on, and whoever was steered before stand; None: nobody.

        `left` and `right` walk, `up` and `down` climb ladders, `jump` jumps, as high as it is held; `down` and `jump`
        together drop through a platform that is solid from above.

        >>> game = evil.Game(headless=True)
        >>> hero = game.add_character(at=(0, 1), colour="orange")
        >>> game.drive(hero, jump=("space", "z"))
        """
        if character is not None and not isinstance(character, Character):
            raise ArgumentTypeError(f"Game.drive: character={character!r} must be a Character, or None for nobody")
        driver = None if character is None else Driver(character, Steering(left, right, up, down, jump))
        if self._driver is not None:
            self._driver.stop()
        self._driver = driver

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
