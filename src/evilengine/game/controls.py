"""What the player does: held state to ask for, and the callbacks that are told when it changes."""

from __future__ import annotations

from collections.abc import Iterable

from evilengine.interaction import Grabs, Interaction, axis
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import known_keywords
from evilengine.values.inputs import Inputs, Keys, Pointer, Tilt, Touch
from evilengine.world.world import World


class Controls:
    """The part of a game that its player holds."""

    def __init__(self) -> None:
        super().__init__()
        self._interaction = Interaction()
        self._grabs = Grabs()
        self._inputs = Inputs()
        self.on_key_press: Callbacks[[str]] = Callbacks("game.on_key_press", "key")
        self.on_key_release: Callbacks[[str]] = Callbacks("game.on_key_release", "key")
        self.on_pointer: Callbacks[[Pointer]] = Callbacks("game.on_pointer", "pointer")
        self.on_touch: Callbacks[[Touch]] = Callbacks("game.on_touch", "touch")
        self.on_tilt: Callbacks[[Tilt]] = Callbacks("game.on_tilt", "tilt")
        self.on_shake: Callbacks[[]] = Callbacks("game.on_shake")

    def _tell_inputs(self, inputs: Inputs, world: World) -> None:
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
