"""How water is seen: one smooth surface, clear where it is thin and deep in colour where it is not, and foam."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.scene.camera import Matrix6
from evilengine.scene.drawing import to_layer
from evilengine.scene.gases import to_ramp
from evilengine.values.checks import number
from evilengine.values.colour import BLACK, WHITE, Colour
from evilengine.values.tick import STEP
from evilengine.world.arguments import flag
from evilengine.world.water import Water

if TYPE_CHECKING:
    from evilengine.scene.scene import Scene

LOOKS = {
    "ramp": None, "clarity": 1.5, "refraction": 1.0, "rim": 0.8, "waves": 1.0, "foam": 1.0, "lit": True, "layer": 0,
}  # fmt: skip
"""What `game.add_water` can be told of looks, and what is so unless it is."""

_FOAM = Colour(0.97, 0.99, 1.0)

_TINT = 0.6
"""How much of what comes through takes the liquid's colour; the rest takes none."""


class WaterLook:
    """One water as it is seen."""

    def __init__(self, slot: int, row: dict[str, Any]) -> None:
        owner = "Game.add_water"
        self.slot = slot
        self.water: Water | None = None
        self.ramp = None if row["ramp"] is None else to_ramp(row["ramp"], owner, "ramp")
        self.layer = to_layer(row["layer"], owner)
        self.foam = number(row["foam"], owner, "foam", least=0.0, most=10.0)
        self._foam = _core.Foam(slot)
        if "flecks" in row:
            self._foam.restore(base64.b64decode(row["flecks"]))
        self._colours: list[list[float]] = []  # that the tables are made of
        self._core = _core.LiquidLook()
        self._core.clarity = number(row["clarity"], owner, "clarity", above=0.0, most=1e4)
        self._core.refraction = number(row["refraction"], owner, "refraction", least=0.0, most=10.0)
        self._core.rim = number(row["rim"], owner, "rim", least=0.0, most=1.0)
        self._core.waves = number(row["waves"], owner, "waves", least=0.0, most=10.0)
        self._core.lit = flag(row["lit"], owner, "lit")

    def _collect(self, scene: Scene, view: Matrix6, alpha: float, screen: tuple[int, int], points: float) -> None:
        world = scene.world
        self._take_colours(world._core)
        late = STEP * (1.0 - min(max(alpha, 0.0), 1.0))
        self._core.collect(
            scene._core, world._core, self.slot, view, alpha, late, STEP * world.steps - late, *screen, points,
            self.layer,
        )  # fmt: skip
        assert self.water is not None
        self._foam.collect(
            scene._core, view, late, *screen, self.water.particle_size, points, self._core.lit, _FOAM.rgba8, self.layer
        )

    def _step(self, scene: Scene) -> None:
        self._foam.step(scene.world._core, self.slot, self.foam, STEP)

    def _take_colours(self, world: _core.World) -> None:
        """Make the tables anew when there is another liquid."""
        colours = _core.liquid_colours(world, self.slot)
        if colours != self._colours:
            self._colours = colours
            ramps = [ramp_of(Colour(*colour)) for colour in colours]
            if self.ramp is not None:
                ramps[0] = self.ramp
            self._core.set_tables([table_of(ramp) for ramp in ramps])

    def state(self) -> dict[str, Any]:
        """What a saved game keeps of it."""
        core = self._core
        return {
            "slot": self.slot, "ramp": None if self.ramp is None else [list(colour) for colour in self.ramp],
            "clarity": core.clarity, "refraction": core.refraction, "rim": core.rim, "waves": core.waves,
            "foam": self.foam, "lit": core.lit, "layer": self.layer,
            "flecks": base64.b64encode(self._foam.snapshot()).decode("ascii"),
        }  # fmt: skip


class WaterLooks:
    """The looks of a scene's waters."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._looks: list[WaterLook] = []

    def add(self, water: Water, words: dict[str, Any]) -> None:
        """Show a water from now on. What is wrong with the words is raised before anything is shown."""
        look = WaterLook(water.slot, LOOKS | words)
        look.water = water
        self._looks.append(look)

    def alive(self) -> list[WaterLook]:
        """Those whose water is there."""
        self._looks = [look for look in self._looks if look.water is not None and look.water.alive]
        return self._looks

    def step(self) -> None:
        """Foam and spray move on by one step, after the world."""
        for look in self.alive():
            look._step(self._scene)

    def clear(self) -> None:
        """Show none of them any longer."""
        self._looks = []

    # -- saving --

    def state(self) -> list[dict[str, Any]]:
        """What a saved game keeps of them."""
        return [look.state() for look in self.alive()]

    def read(self, rows: list[dict[str, Any]]) -> list[WaterLook]:
        """Read what `state` gave; raises what is wrong with it."""
        return [WaterLook(int(row["slot"]), LOOKS | row) for row in rows]

    def put(self, looks: list[WaterLook]) -> None:
        """Become what was read; the world must have been restored."""
        waters = {water.slot: water for water in self._scene.world.waters}
        for look in looks:
            look.water = waters.get(look.slot)
        self._looks = looks


def ramp_of(colour: Colour) -> list[Colour]:
    """The colours of a liquid from its surface to its depth, where nobody has said them: light and clear, then dark."""
    return [
        colour.mixed(WHITE, 0.18).with_alpha(0.4),
        colour.mixed(BLACK, 0.2).with_alpha(0.7),
        colour.mixed(BLACK, 0.66).with_alpha(0.92),
    ]


def table_of(ramp: Sequence[Colour]) -> list[list[float]]:
    """A ramp as the core's table: of what lies behind, and of the liquid's own colour, how much is seen."""
    last, table = len(ramp) - 1, []
    for k in range(_core.LIQUID_TABLE):
        at = last * k / (_core.LIQUID_TABLE - 1)
        low = min(int(at), last - 1)
        part = at - low
        *colour, alpha = ((1.0 - part) * a + part * b for a, b in zip(ramp[low], ramp[low + 1], strict=True))
        most = max(*colour, 1e-3)
        through = [(1.0 - alpha) * (1.0 - _TINT + _TINT * channel / most) for channel in colour]
        table.append([*through, *(alpha * channel for channel in colour)])
    return table
