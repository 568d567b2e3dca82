"""The part of the parser that reads how the picture looks: background, plane, lens, camera."""

from __future__ import annotations

from evilengine.script.expressions import Skip
from evilengine.script.flowing import Flowing
from evilengine.script.syntax import Item, Picturing
from evilengine.values.level import Place


class Pictured(Flowing):
    """Readers of `background`, `plane`, `lens` and `camera`."""

    def picturing(self, word: str, place: Place, before: int) -> Picturing:
        what: Item | None = None
        try:
            if word == "background":
                what = self.colour("background")
            elif word == "plane":
                what = self.number("plane needs a layer, a whole number, as in: plane -2 parallax 0.3;")
        except Skip:
            pass  # its properties may hold errors of their own
        settings = self.settings(word)
        broken = self.broken(before)
        self.finish()
        return Picturing(word, what, settings, place, broken)
