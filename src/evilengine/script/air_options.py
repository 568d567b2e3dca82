"""What the words of particles mean together, as an emitter takes it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def emitter_options(said: Mapping[str, Any]) -> dict[str, Any]:
    """Beginning and end as one curve, width and height as one area, flags as what they stand for.

    >>> emitter_options({"size": 0.1, "end_size": 1.0, "wide": 4.0, "glowing": True, "rate": 9.0})
    {'size': [0.1, 1.0], 'rate': 9.0, 'area': (4.0, 0.0), 'blend': 'add'}
    >>> emitter_options({"burst": 40.0, "running": True})
    {'burst': 40.0, 'running': False, 'once': True}
    """
    options = dict(said)
    for first, last, usual in (("size", "end_size", 0.1), ("colour", "fade", "white")):
        if last in options:
            end = options.pop(last)
            options[first] = [options.get(first, usual), end]
    if "wide" in options or "tall" in options:
        options["area"] = (options.pop("wide", 0.0), options.pop("tall", 0.0))
    if options.pop("glowing", False):
        options["blend"] = "add"
    for name in ("soft", "running"):
        if name in options:
            options[name] = False
    if "burst" in options and "rate" not in options:
        options["once"] = True
    return options
