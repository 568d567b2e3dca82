"""What the words of smoke and water mean together, as the engine takes it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_SIDES = {"openLeft": "left", "openRight": "right", "openBottom": "bottom", "openTop": "top"}


def box_options(said: Mapping[str, Any]) -> dict[str, Any]:
    """Open sides as one text, flags as what they stand for.

    >>> box_options({"openTop": True, "openLeft": True, "quality": True, "buoyancy": 1.0, "lit": True})
    {'buoyancy': 1.0, 'quality': 'high', 'lit': False, 'open_sides': 'left top'}
    """
    options = {name: value for name, value in said.items() if name not in (*_SIDES, "open", "quality", "lit", "stick")}
    meanings = {"quality": "high", "lit": False, "stick": False}
    options |= {name: value for name, value in meanings.items() if name in said}
    sides = "all" if "open" in said else " ".join(side for word, side in _SIDES.items() if word in said)
    return options | ({"open_sides": sides} if sides else {})


def flow_options(said: Mapping[str, Any]) -> dict[str, Any]:
    """All of a source or a stream but its shape, and but what only one that is there can be told.

    >>> flow_options({"wide": 4.0, "tall": 1.0, "rate": 2.0, "running": True})
    {'rate': 2.0}
    """
    return {name: value for name, value in said.items() if name not in ("wide", "tall", "running")}
