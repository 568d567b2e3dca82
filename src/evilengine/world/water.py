"""Water: liquid of particles, round the bodies and in their way (SPEC F5, F7)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from evilengine import _core
from evilengine.values.checks import known_keywords, number
from evilengine.values.colour import ColourLike, to_colour
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Point
from evilengine.world.character import to_area
from evilengine.world.smoke import LEAST_CELLS, MOST_CELLS, flow, sides
from evilengine.world.smoke import Fluids as Fluids

if TYPE_CHECKING:
    from evilengine.world.world import World

BLUE = "#408cd9"
CELL = 2
"""Particles along a side of a cell."""


class Water(_core.Water):
    """Liquid of particles in a box: `world.add_water` makes one.

    `positions` and `velocities` are (count, 2) float32 buffers: views without a copy.

    >>> world = evil.World()
    >>> water = world.add_water((0, 0, 4, 3), particle_size=0.1)
    >>> water.fill((0, 0, 4, 1))
    400
    >>> water.count
    400
    """

    def __init__(self, world: World, slot: int) -> None:
        super().__init__(world._core, slot)
        self._world = world

    @known_keywords
    def fill(self, area: Iterable[float], *, velocity: Point = (0.0, 0.0)) -> int:
        """Fill a box (left, bottom, right, top) where no body and no liquid is; returns how many particles came."""
        me = "Water.fill"
        wanted = flow(velocity, me, "velocity")
        return self._fill(to_area(area, me), (wanted.x, wanted.y))

    def destroy(self) -> None:
        """Take it out of the world."""
        self._destroy()

    def __len__(self) -> int:
        return self.count

    def __repr__(self) -> str:
        return f"<Water {self.slot}, {self.count} particles>" if self.alive else "<Water, gone>"


class Waters(Fluids):
    """What a world knows of its waters."""

    @known_keywords
    def add_water(
        self,
        area: Iterable[float],
        *,
        particle_size: float = 0.1,
        viscosity: float = 0.0,
        surface_tension: float = 0.0,
        density: float = 1.0,
        colour: ColourLike = BLUE,
        open_sides: str | Iterable[str] = (),
    ) -> Water:
        """Make a box (left, bottom, right, top) that may hold liquid, empty at first; returns it.

        A particle stands for a square of side `particle_size` (metres). Walls are all round unless `open_sides` names
        some of "left", "right", "bottom", "top", or "all": liquid that leaves by one is gone. `density` (kg/m2) is
        compared with that of shapes: 1 is what a shape has that is told nothing else.

        >>> world = evil.World()
        >>> world.add_water((0, 0, 4, 3), particle_size=0.1)
        <Water 0, 0 particles>
        """
        me = "World.add_water"
        box = to_area(area, me)
        size = number(particle_size, me, "particle_size", above=0.0, most=1e4)
        nx, ny = (max(LEAST_CELLS, round((box[k + 2] - box[k]) / (CELL * size))) for k in (0, 1))
        if max(nx, ny) > MOST_CELLS:
            least = max(box[2] - box[0], box[3] - box[1]) / (CELL * MOST_CELLS)
            raise ArgumentError(
                f"{me}: particle_size={particle_size!r} is too small for this area; at least {least:.2g} fits"
            )
        slot = _core.add_water(
            self._core,
            nx=nx,
            ny=ny,
            low=box[:2],
            particle_size=size,
            open=sides(open_sides, me),
            density=number(density, me, "density", above=0.0, most=1e6),
            viscosity=number(viscosity, me, "viscosity", least=0.0, most=1e4),
            surface_tension=number(surface_tension, me, "surface_tension", least=0.0, most=1e4),
            colour=to_colour(colour, me, "colour")[:3],
        )
        return Water(self, slot)  # type: ignore[arg-type]

    @property
    def waters(self) -> tuple[Water, ...]:
        """All waters, in the order of their slots."""
        return tuple(Water(self, slot) for slot in _core.water_slots(self._core))  # type: ignore[arg-type]
