"""What a saved game keeps of lights, and the lights that come of it."""

from __future__ import annotations

from typing import Any

from evilengine import _core
from evilengine.scene.light import LIMITS
from evilengine.scene.lights import Lights
from evilengine.values.colour import Colour

_FIELDS = (*LIMITS, "at", "colour", "temperature", "tint", "mask", "on", "shadows", "still", "reach")
"""What is kept of each light, as the core has it."""


def lights_state(lights: Lights) -> dict[str, Any]:
    """Every light and the ambient light. How finely they are drawn is the player's choice, no part of the game."""
    ambient = lights._ambient
    rows = []
    for light in lights:
        body = light.body
        rows.append(
            {
                "slot": light._slot,
                "serial": lights._core.serial(*light._where()),
                "on_body": None if body is None else body.slot,
                "kind": light.kind,
                "at": list(light.at),
                "colour": list(light.colour),
                "temperature": light.temperature,
                "mask": light.mask,
                "on": light.on,
                "shadows": light.shadows,
                "static": light.static,
                "texture": light.texture,
                **{name: getattr(light, name) for name in LIMITS},
            }
        )
    return {
        "ambient": list(ambient) if isinstance(ambient, Colour) else ambient,
        "depth": lights.depth,
        "shadows": lights.shadows,
        "bounce": lights.bounce,
        "next": lights._core.next_serial,
        "rows": rows,
    }


class SavedLights:
    """Lights that were read, and checked as those are that a game adds; nothing has changed before `put`.

    Raises ValueError, TypeError, KeyError or ArgumentError for what are no lights.
    """

    def __init__(self, lights: Lights, state: dict[str, Any] | None) -> None:
        self._lights = lights
        self._read = Lights(lights._world)
        self.slots: list[int] = []
        self._serials: list[int] = []
        self._slides: list[int] = []
        self.bodies: list[int] = []
        """The slots of the bodies that lights are on; NO_SLOT for none."""
        state = state or {"ambient": None, "depth": self._read.depth, "next": 0, "rows": []}
        if state["ambient"] is not None:
            self._read.ambient = state["ambient"]
        self._read.depth = state["depth"]
        self._read.shadows = state.get("shadows", True)
        self._read.bounce = state.get("bounce", self._read.bounce)  # saves of 0.1 and before have none
        self._next = int(state["next"])
        if not 0 <= self._next < 1 << 63:
            raise ValueError("how many lights there have been")
        for row in state["rows"]:
            self._read_row(row)
        if self.slots != sorted(set(self.slots)) or not all(0 <= slot < MOST_LIGHTS for slot in self.slots):
            raise ValueError("lights in their slots")
        if len(set(self._serials)) != len(self._serials) or not all(0 <= s < self._next for s in self._serials):
            raise ValueError("lights in their order")

    def _read_row(self, row: dict[str, Any]) -> None:
        words = {name: row[name] for name in (*LIMITS, "mask", "shadows", "on", "colour", "temperature")}
        words["static"] = row.get("static", False)
        self._slides.append(self._lights._slide(row.get("texture"), "Lights.restore"))
        angle = words.pop("angle")
        kind = str(row["kind"])
        if kind == "sun":
            del words["cone"]
            light = self._read.add(direction=(1.0, 0.0), **words)
            light.at, light.cone = row["at"], row["cone"]
        elif kind == "spot":
            light = self._read.add(at=row["at"], **words)
        else:
            cone = words.pop("cone")
            light = self._read.add(at=row["at"], **words)
            light.cone = cone
        light.angle = angle
        if light.kind != kind:
            raise ValueError(f"{kind!r} is no kind of light")
        self.slots.append(int(row["slot"]))
        self._serials.append(int(row["serial"]))
        self.bodies.append(_core.NO_SLOT if row["on_body"] is None else int(row["on_body"]))

    def put(self) -> None:
        """Become what was saved. The world must have been restored, and have the bodies that lights are on."""
        lights, read = self._lights, self._read._core
        places = lights._core.restore(lights._world._core, self.slots, self._serials, self.bodies, self._next)
        for number, place in enumerate(places):
            for name in _FIELDS:
                value = getattr(read, name)(number, read.generation(number))
                getattr(lights._core, f"set_{name}")(*place, value)
            lights._core.set_slide(*place, self._slides[number])
        lights._ambient, lights._depth, lights._shadows = self._read._ambient, self._read._depth, self._read._shadows
        lights._bounce = self._read._bounce


MOST_LIGHTS = 1 << 20
"""Slots; a forged file may not ask for all memory."""
