"""The liquids that a water is of."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.checks import number
from evilengine.values.colour import Colour, ColourLike, to_colour

if TYPE_CHECKING:
    from evilengine.world.water import Water

BLUE = "#408cd9"
MOST_LIQUIDS: int = _core.MOST_LIQUIDS_OF_WATER
"""Of one water."""


class Liquid:
    """One of the liquids of a water: `water.liquids` has them, `water.add_liquid` makes one more.

    Its attributes may be changed at any time.

    >>> water = evil.World().add_water((0, 0, 4, 3))
    >>> oil = water.add_liquid(density=0.8, colour="gold", viscosity=0.01)
    >>> water.fill((0, 1, 4, 1.5), liquid=oil), oil.count
    (200, 200)
    """

    __slots__ = ("_index", "_serial", "_water")

    def __init__(self, water: Water, index: int, serial: int) -> None:
        self._water, self._index, self._serial = water, index, serial

    @property
    def density(self) -> float:
        """kg/m2, as shapes have it: 1 is water's, and that of shapes which are told nothing. More than 0."""
        return self._values[0]

    @density.setter
    def density(self, value: float) -> None:
        self._change(density=value)

    @property
    def viscosity(self) -> float:
        """m2/s: how thick it is. 0 for water, 0.01 for oil, 1 for honey. 0 or more."""
        return self._values[1]

    @viscosity.setter
    def viscosity(self, value: float) -> None:
        self._change(viscosity=value)

    @property
    def surface_tension(self) -> float:
        """N/m: how strongly its surface draws together to drops. 0 or more."""
        return self._values[2]

    @surface_tension.setter
    def surface_tension(self, value: float) -> None:
        self._change(surface_tension=value)

    @property
    def colour(self) -> Colour:
        """What it looks like."""
        return Colour(*self._values[3])

    @colour.setter
    def colour(self, value: ColourLike) -> None:
        self._change(colour=value)

    @property
    def water(self) -> Water:
        """The water that it is one of."""
        return self._water

    @property
    def number(self) -> int:
        """Its own among all liquids of its world, as saved games have it."""
        return self._water.slot * MOST_LIQUIDS + self._index

    @property
    def count(self) -> int:
        """How many particles it has."""
        return self._water._count_of(self._index, self._serial)

    @property
    def volume(self) -> float:
        """Square metres of it."""
        return self.count * self._water.particle_size**2

    @property
    def alive(self) -> bool:
        """False once its water was destroyed, or a snapshot restored that it is not in."""
        serials = self._water._liquid_serials() if self._water.alive else []
        return self._index < len(serials) and serials[self._index] == self._serial

    @property
    def _values(self) -> tuple[float, float, float, tuple[float, float, float]]:
        return self._water._liquid(self._index, self._serial)

    def _change(self, **changed: Any) -> None:
        density, viscosity, surface_tension, colour = self._values
        now: dict[str, Any] = {
            "density": density, "viscosity": viscosity, "surface_tension": surface_tension, "colour": colour,
        }  # fmt: skip
        self._water._set_liquid(self._index, self._serial, *made_of(**now | changed, me="Liquid"))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Liquid) and (self._water, self._serial) == (other._water, other._serial)

    def __hash__(self) -> int:
        return hash((self._water, self._serial))

    def __repr__(self) -> str:
        return f"<Liquid {self._index} of {self._water!r}>" if self.alive else "<Liquid, gone>"


def made_of(
    density: float, viscosity: float, surface_tension: float, colour: ColourLike, me: str
) -> tuple[float, float, float, tuple[float, float, float]]:
    """What a liquid is, as the core takes it."""
    red, green, blue = to_colour(colour, me, "colour")[:3]
    return (
        number(density, me, "density", above=0.0, most=1e6),
        number(viscosity, me, "viscosity", least=0.0, most=1e4),
        number(surface_tension, me, "surface_tension", least=0.0, most=1e4),
        (red, green, blue),
    )


def of_first(name: str) -> Any:
    """An attribute of a water that is one of its first liquid's."""

    def get(water: Water) -> Any:
        return getattr(water.liquids[0], name)

    def put(water: Water, value: Any) -> None:
        setattr(water.liquids[0], name, value)

    return property(get, put, doc=getattr(Liquid, name).__doc__)
