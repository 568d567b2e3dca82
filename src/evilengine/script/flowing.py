"""The part of the parser that reads how water comes and goes: fill, pour, drain."""

from __future__ import annotations

from evilengine.script.expressions import Skip
from evilengine.script.steering import Steered
from evilengine.script.syntax import Expression, Identifier, New, Setting
from evilengine.script.waters import FLOWS
from evilengine.values.level import Place


class Flowing(Steered):
    """Readers of `fill`, `pour` and `drain`; each is as a `new` of what is in that water."""

    def flowing(self, word: str, place: Place, before: int) -> New:
        kind, name = FLOWS[word], None
        sizes: tuple[Expression, ...] = ()
        water: tuple[Setting, ...] = ()
        try:
            example = kind.example.splitlines()[1]
            target = self.name_of(f"{word} needs the name of a water, as in: {example}")
            water = (Setting("in", (target,), target.place),)
            if self.at_word("as") and word != "fill":
                name = self._name_after_as(word)
            sizes = self._sizes(kind)
        except Skip:
            self.resync()
        settings = self.settings(kind.family)
        broken = self.broken(before)
        self.finish()
        return New(word, name, sizes, (), (*water, *settings), place, broken)

    def _name_after_as(self, word: str) -> Identifier | None:
        self.advance()
        if self.token.kind != "name":
            self.error("missing-name", f"as needs a name, as in: {word} pool as tap ...", self.after_last())
            raise Skip
        name = self.name_to_make()
        if name is not None:
            self.made[name.name] = "stream"
        return name
