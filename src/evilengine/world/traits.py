"""How bodies and shapes deal with those they meet: words for filters, sensors, one-way platforms, conveyor belts."""

from __future__ import annotations

from typing import Any, TypeAlias

from evilengine.values.vec2 import Point

ALL = 0xFFFFFFFF
"""A mask of all 32 categories."""

Side: TypeAlias = Point | bool | None
"""What `one_way` takes: the side from which it is solid, or True for above."""


def given(**traits: Any) -> dict[str, Any] | None:
    """Those that are not None, or None if all are; the core checks them."""
    found = {name: value for name, value in traits.items() if value is not None}
    return found or None
