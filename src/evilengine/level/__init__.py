"""Levels: the commands of a level script, carried out on a game, or on a world alone."""

from __future__ import annotations

from evilengine.level.level import Level, build, load
from evilengine.level.making import TYPES
from evilengine.level.rules import Thing

__all__ = ["TYPES", "Level", "Thing", "build", "load"]
