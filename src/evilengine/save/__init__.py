"""Saved games: their bytes, where they lie on the disk, and the names by which functions come back."""

from __future__ import annotations

from evilengine.save.container import Container
from evilengine.save.files import Slots, write_whole
from evilengine.save.names import Functions

__all__ = ["Container", "Functions", "Slots", "write_whole"]
