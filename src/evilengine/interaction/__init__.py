"""Interaction: from a device's events to what the player does in a step, and what fingers do to bodies."""

from __future__ import annotations

from evilengine.interaction.axis import axis
from evilengine.interaction.collect import Interaction

__all__ = ["Interaction", "axis"]
