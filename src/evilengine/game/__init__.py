"""The game: every module of the engine tied into one frame (SPEC A1, A3)."""

from __future__ import annotations

from evilengine.game.game import HEADLESS_SECONDS, Game
from evilengine.game.stage import STAGE, Stage, keep_pace

__all__ = ["HEADLESS_SECONDS", "STAGE", "Game", "Stage", "keep_pace"]
