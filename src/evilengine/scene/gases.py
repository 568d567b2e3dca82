"""How smoke is seen: pictures of its density and of its heat, made anew after each step, and the light of its fire."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, Protocol

from evilengine import _core
from evilengine.values.checks import number
from evilengine.values.colour import Colour, to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.image import Image
from evilengine.world.arguments import flag
from evilengine.world.shapes import Rectangle
from evilengine.world.smoke import Smoke

if TYPE_CHECKING:
    from evilengine.scene.light import Light
    from evilengine.scene.scene import Scene

FIRE = ("#000000", "#240300", "#7a1602", "#dc4a08", "#ff9a24", "#ffdc88", "#fff8e4")
"""The colours of fire, from none to the hottest; they are added to what lies behind."""

GLOW = "#ff9a50"
"""The colour of a fire's lamp."""

HOT = 0.5
"""Temperature from which on gas lights what is round it."""

HEAT_SCALE = 0.9
"""Of a temperature of 1, fire shows 1 - exp(-0.9) of its colours: 0.6 of the way to the hottest."""

KINDS = ("smoke", "fire")
HEAT = KINDS.index("fire")

FINER = 2
"""Pixels of a picture along a side of a cell, as the core paints them."""

LOOKS = {
    "ramp": None, "opacity": 2.0, "fire": None, "glow": 1.0, "layer": 0, "lit": True, "light_radius": 8.0,
    "shadow": 1.0,
}  # fmt: skip
"""What `game.add_smoke` can be told of looks, and what is so unless it is."""


class Textures(Protocol):
    """Who keeps pictures for drawing."""

    def upload(self, image: Image) -> int:
        """Keep `image` and return its id."""

    def update(self, texture: int, image: Image) -> None:
        """Show another image wherever `texture` is drawn."""


class Look:
    """One smoke as it is seen: two ramps of colours, two textures, and a light."""

    def __init__(self, slot: int, row: dict[str, Any], textures: Textures) -> None:
        self.slot = slot
        self.smoke: Smoke | None = None
        owner = "Game.add_smoke"
        self.colours = to_ramp(row["ramp"], owner, "ramp"), to_ramp(row["fire"], owner, "fire")
        self.opacity = number(row["opacity"], owner, "opacity", above=0.0, most=100.0)
        self.glow = number(row["glow"], owner, "glow", least=0.0, most=16.0)
        self.radius = number(row["light_radius"], owner, "light_radius", least=0.0, most=1e4)
        self.shadow = number(row.get("shadow", LOOKS["shadow"]), owner, "shadow", least=0.0, most=100.0)
        self.lit = flag(row.get("lit", LOOKS["lit"]), owner, "lit")
        self.saved_lights: list[list[int]] = [[int(source), int(light)] for source, light in row.get("lights", ())]
        self.lights: dict[int, Light] = {}  # by the slot of the source whose fire it is
        self.step = -1
        self._tables = [table_of(colours) for colours in self.colours]
        self._keeper = textures
        self.textures = [textures.upload(Image.of(1, 1, bytes(4))) for _ in KINDS]

    def paint(self, smoke: Smoke) -> None:
        """Make its pictures anew."""
        size = (FINER * smoke.cells[0], FINER * smoke.cells[1])
        for kind, table in enumerate(self._tables):
            if kind == HEAT and self.glow == 0.0:
                continue
            scale = HEAT_SCALE if kind == HEAT else self.opacity
            self._keeper.update(self.textures[kind], Image.of(*size, smoke._paint(table, scale, kind == HEAT)))

    def state(self) -> dict[str, Any]:
        """What a saved game keeps of it."""
        ramp, fire = ([list(colour) for colour in colours] for colours in self.colours)
        return {
            "slot": self.slot, "ramp": ramp, "fire": fire, "opacity": self.opacity, "glow": self.glow,
            "light_radius": self.radius, "shadow": self.shadow,
            "lights": [[source, light._slot] for source, light in self.lights.items() if light.alive],
        }  # fmt: skip


class Gases:
    """The looks of a scene's smokes."""

    def __init__(self, scene: Scene, textures: Textures | None) -> None:
        self._scene, self._textures = scene, textures
        self._looks: list[Look] = []

    def add(self, smoke: Smoke, words: dict[str, Any]) -> None:
        """Show a smoke from now on. What is wrong with the words is raised before anything is shown."""
        if self._textures is None:
            raise ArgumentError("Game.add_smoke: this scene has no renderer that smoke could be shown by")
        row = LOOKS | words
        own = Colour(*smoke._colour)
        row["ramp"] = [own.with_alpha(0.0), own.with_alpha(0.95)] if row["ramp"] is None else row["ramp"]
        row["fire"] = FIRE if row["fire"] is None else row["fire"]
        look = Look(smoke.slot, row, self._textures)
        left, bottom, right, top = smoke.area
        shape, at = Rectangle(right - left, top - bottom), ((left + right) / 2, (bottom + top) / 2)
        for kind, blend in zip(KINDS, ("normal", "add"), strict=True):
            if kind == "fire" and look.glow == 0.0:
                continue
            lit = look.lit and kind == "smoke"
            drawing = self._scene.add(shape, at=at, colour="white", blend=blend, lit=lit, layer=row["layer"])
            texture = look.textures[KINDS.index(kind)]
            self._scene._texture_names[texture] = name_of(kind, smoke.slot)
            self._scene._show(drawing._at(), texture, None)
        look.smoke = smoke
        self._looks.append(look)

    def step(self) -> None:
        """Bring the lamps of their fires up to the world's step."""
        self._drop_gone()
        for look in self._looks:
            if look.smoke is not None:
                self._shine(look, look.smoke)

    def refresh(self) -> None:
        """Bring pictures up to the last step."""
        self._drop_gone()
        steps = self._scene.world.steps
        for look in self._looks:
            if look.step != steps and look.smoke is not None:
                look.step = steps
                look.paint(look.smoke)

    def _drop_gone(self) -> None:
        self._looks = [look for look in self._looks if look.smoke is not None and look.smoke.alive]

    def _shine(self, look: Look, smoke: Smoke) -> None:
        """The fire's lamps: one for each source that it burns near, where the heat is, as bright as there is much."""
        if look.glow == 0.0 or look.radius == 0.0:
            return
        burning = {source: blaze for source, *blaze in smoke._blazes(HOT)}
        for source in sorted(burning.keys() - look.lights.keys()):  # the first flame
            look.lights[source] = self._scene.lights.add(at=burning[source][1:3], colour=GLOW, radius=look.radius)
        for source, light in look.lights.items():
            if not light.alive:
                continue
            light.on = source in burning
            if light.on:
                strength, x, y, size = burning[source]
                light.at = (x, y)
                light.intensity = min(look.glow * strength**0.5, 4.0)
                light.size = max(0.5 * size, 0.05)

    def shadows(self) -> list[tuple[int, float]]:
        """The smokes that take light away, by their slots, and how much."""
        return [(each.slot, each.shadow) for each in self._looks if each.shadow > 0.0]

    # -- saving --

    def state(self) -> list[dict[str, Any]]:
        """What a saved game keeps of them."""
        return [look.state() for look in self._looks if look.smoke is not None and look.smoke.alive]

    def read(self, rows: list[dict[str, Any]]) -> SavedGases:
        """Read what `state` gave; raises what is wrong with it."""
        if rows and self._textures is None:
            raise ValueError("smoke in a scene without a renderer")
        return SavedGases(
            self, [] if self._textures is None else [Look(int(r["slot"]), r, self._textures) for r in rows]
        )


class SavedGases:
    """Looks that were read; nothing has changed before `put`."""

    def __init__(self, gases: Gases, looks: list[Look]) -> None:
        self._gases, self._looks = gases, looks
        self._by_name = {name_of(kind, look.slot): look.textures[k] for look in looks for k, kind in enumerate(KINDS)}

    def texture(self, name: object) -> int | None:
        """The texture of the picture that is called so, or None: it is no smoke's."""
        return self._by_name.get(name) if isinstance(name, str) else None

    def put(self) -> None:
        """Become what was saved; the world must have been restored."""
        scene = self._gases._scene
        smokes = {smoke.slot: smoke for smoke in scene.world.smokes}
        for look in self._looks:
            look.smoke = smokes.get(look.slot)
            look.lights = {source: scene.lights._in_slot(light) for source, light in look.saved_lights}
        scene._texture_names.update({texture: name for name, texture in self._by_name.items()})
        self._gases._looks = self._looks


def name_of(kind: str, slot: int) -> str:
    """How a saved game calls the picture of a smoke."""
    return f"{kind}:{slot}"


def table_of(colours: Sequence[Colour]) -> list[int]:
    """A ramp as the core's table: straight lines between its colours."""
    last, table = len(colours) - 1, []
    for k in range(_core.RAMP):
        at = last * k / (_core.RAMP - 1)
        low = min(int(at), last - 1)
        table.append(colours[low].mixed(colours[low + 1], at - low).rgba8)
    return table


def to_ramp(colours: object, owner: str, argument: str) -> list[Colour]:
    """Two colours or more."""
    if not isinstance(colours, str) and isinstance(colours, Iterable):
        known = [to_colour(colour, owner, argument) for colour in colours]
        if len(known) > 1:
            return known
    raise ArgumentTypeError(f"{owner}: {argument}={colours!r} must be a list of two or more colours")
