"""Saved games and recordings: their bytes, where they lie on the disk, the names by which functions come back."""

from __future__ import annotations

from evilengine.save.container import Container
from evilengine.save.files import Slots, write_whole
from evilengine.save.names import Functions
from evilengine.save.replay import Recorder, Replay

__all__ = ["Container", "Functions", "Recorder", "Replay", "Slots", "write_whole"]
