"""Interaction: from a device's events to what the player does in a step, and what fingers do to bodies."""

from __future__ import annotations

from evilengine.interaction.axis import axis
from evilengine.interaction.collect import Interaction
from evilengine.interaction.grab import Grabs

__all__ = ["Grabs", "Interaction", "axis"]
