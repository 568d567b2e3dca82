"""A level's commands about smoke, fire and water."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.level_values import Area, Called, Make, Option, Place


@dataclass(frozen=True, slots=True)
class AddSmoke:
    """Gas in an area, called `name` ("" for none); `options` are what a level says of it."""

    place: Place
    name: str
    area: Area
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddSource:
    """Where smoke comes from; nothing, when the smoke or what it follows is gone."""

    place: Place
    name: str
    smoke: Called
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddWater:
    """An area for liquid, called `name` ("" for none)."""

    place: Place
    name: str
    area: Area
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddLiquid:
    """One more liquid of a water; nothing, when that is gone."""

    place: Place
    name: str
    water: Called
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class FillWater:
    """Liquid where a shape is; nothing, when the water is gone."""

    place: Place
    water: Called
    shape: Make
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddStream:
    """A stream into a water; with a shape, one that drains it there. Nothing, when what it needs is gone."""

    place: Place
    name: str
    water: Called
    shape: Make | None
    options: tuple[Option, ...]


Fluid: TypeAlias = AddSmoke | AddSource | AddWater | AddLiquid | FillWater | AddStream
"""Any of them."""
