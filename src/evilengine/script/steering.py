"""The part of the parser that reads how characters are steered: drive, tell."""

from __future__ import annotations

from evilengine.script.characters import AXES, KEYS, TELLINGS
from evilengine.script.expressions import Skip, shown
from evilengine.script.syntax import Expression, Identifier, Steering, Text
from evilengine.script.things import Things
from evilengine.script.words import near
from evilengine.values.level import Place

_MEANT = {"move": "walk", "go": "walk", "run": "walk", "fall": "drop", "release": "letGo", "stop": "walk"}


class Steered(Things):
    """Readers of `drive` and `tell`."""

    def steering(self, word: str, place: Place, before: int) -> Steering:
        target: Identifier | None = None
        keys: tuple[tuple[str, tuple[Text, ...]], ...] = ()
        telling, value = "", None
        try:
            if word == "drive" and self.at_word("off"):
                self.advance()
            else:
                example = "drive hero;" if word == "drive" else "tell hero walk 1;"
                target = self.name_of(f"{word} needs the name of a character, as in: {example}")
                if word == "drive":
                    keys = self._keys()
                else:
                    telling, value = self._telling()
        except Skip:
            self.resync()
        broken = self.broken(before)
        self.finish()
        return Steering(word, target, keys, telling, value, place, broken)

    # drive NAME left "KEY" "KEY" jump "KEY"

    def _keys(self) -> tuple[tuple[str, tuple[Text, ...]], ...]:
        found: dict[str, tuple[Text, ...]] = {}
        while self.token.kind in ("name", "string") and not self.starts_statement(self.token):
            what = self._word(KEYS, "a way to go", 'as in: drive hero left "a" right "d" jump "space";')
            if what in found:
                self.error("said-twice", f"{what} is said twice", self.last, "put all its keys behind one")
            names: list[Text] = []
            while self.token.kind == "string":
                token = self.advance()
                names.append(Text(token.text, token.place))
                if self.token.kind == ",":
                    self.error("odd-comma", "there is no comma between keys", self.advance(), "put a space instead")
            if not names:
                self.error("missing-key", f"{what} needs a key in quotes", self.after_last(), f'as in: {what} "space"')
                raise Skip
            found[what] = tuple(names)
        return tuple(found.items())

    # tell NAME walk NUMBER, tell NAME jump

    def _telling(self) -> tuple[str, Expression | None]:
        what = self._word(tuple(TELLINGS), "something to do", "as in: tell hero walk 1;  tell hero jump;")
        if what not in AXES:
            return what, None
        return what, self.number(f"{what} needs a number from -1 to 1, as in: tell hero {what} 1;")

    def _word(self, words: tuple[str, ...], wanted: str, example: str) -> str:
        """One of these words, or the one that was meant."""
        token = self.token
        if token.kind != "name" or self.starts_statement(token):
            self.error("missing-word", f"{wanted} is missing here", self.after_last(), example)
            raise Skip
        self.advance()
        if token.text in words:
            return token.text
        suggestion = near(token.text, words, {wrong: word for wrong, word in _MEANT.items() if word in words})
        hint = f"did you mean '{suggestion}'?" if suggestion else f"there are {', '.join(words)}"
        self.error("unknown-word", f"{shown(token)} is not {wanted}", token, hint)
        if suggestion is None:
            raise Skip
        return suggestion
