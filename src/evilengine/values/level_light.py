"""The commands of light, beside the others of a level."""

from __future__ import annotations

from dataclasses import dataclass

from evilengine.values.level_values import Number, Option, Place


@dataclass(frozen=True, slots=True)
class AddLight:
    """A light, called `name` ("" for none); nothing, when what it follows is gone."""

    place: Place
    name: str
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class SetAmbient:
    """The light that is everywhere."""

    place: Place
    strength: Number
