"""A level's commands about smoke and fire."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.level_values import Area, Called, Option, Place


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


Fluid: TypeAlias = AddSmoke | AddSource
"""Any of them."""
