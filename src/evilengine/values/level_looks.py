"""A level's commands about how the picture looks: what lies behind and between, what shines, what is done to it all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.level_values import Number, Option, Place


@dataclass(frozen=True, slots=True)
class SetBackground:
    """A colour, or a picture's file name and how it is seen."""

    place: Place
    what: str
    options: tuple[Option, ...] = ()


@dataclass(frozen=True, slots=True)
class SetPlane:
    """How a layer is seen."""

    place: Place
    layer: int
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class SetLens:
    """What is done to the whole picture."""

    place: Place
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class SetCamera:
    """Where the camera looks and what it follows; nobody, when that is gone."""

    place: Place
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddParticles:
    """An emitter, called `name` ("" for none); nothing, when what it follows is gone."""

    place: Place
    name: str
    options: tuple[Option, ...]


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
    strength: Number | str
    """Or a colour."""


@dataclass(frozen=True, slots=True)
class SetShadows:
    """Whether things cast shadows at all."""

    place: Place
    on: bool


Picture: TypeAlias = SetBackground | SetPlane | SetLens | SetCamera | AddParticles | AddLight | SetAmbient | SetShadows
"""Any of them."""
