"""The part of the parser that reads properties, and finds its way back after an error."""

from __future__ import annotations

import functools
from collections.abc import Iterable

from evilengine.script.expressions import Expressions, Skip, cut, shown
from evilengine.script.lexer import Token
from evilengine.script.syntax import Identifier, Item, Setting, Spot, Text
from evilengine.script.word import Property
from evilengine.script.words import (
    KINDS,
    PROPERTIES,
    PROPERTY_WORDS,
    RESERVED,
    changes_of,
    has,
    meant_for,
    near,
    near_property,
    near_statement,
    properties_of,
    property_of,
)
from evilengine.values.level import Place

_SWITCHES = {"on": True, "off": False}
_TRUTHS = {"true": "on", "false": "off", "yes": "on", "no": "off", "1": "on", "0": "off"}


class Settings(Expressions):
    """Readers of property words and their values."""

    def settings(self, family: str) -> tuple[Setting, ...]:
        """Properties up to the end of the statement; `family` "" is one that nobody could guess."""
        result: list[Setting] = []
        while not self._at_end_of_statement(family):
            before = self._at
            try:
                result += self._setting(family)
                self.unit_apart()
            except Skip:
                self.resync()
            if self._at == before:
                self.advance()
        return tuple(result)

    def _at_end_of_statement(self, family: str) -> bool:
        token = self.token
        if token.kind in (";", "}", "end", "{") or self.starts_statement(token):
            return True
        # A misspelt statement on a new line means that the semicolon before it is missing.
        if token.first and token.kind == "name" and token.text not in PROPERTY_WORDS:
            return self.near_property(token.text, family) is None and self._misspelt_statement(token)
        return token.first and token.kind != "name" and self.last.kind != ","

    def _misspelt_statement(self, token: Token) -> bool:
        return near_statement(token.text) is not None or token.text in KINDS

    def near_property(self, word: str, family: str) -> str | None:
        return near_property(word, family) if family else _near_any(word)

    def _setting(self, family: str) -> tuple[Setting, ...]:
        """A property; none, after an error that left nothing to use."""
        token = self.token
        if token.kind != "name":
            self._unexpected(token, family)
            return ()
        entry = property_of(token.text, family)
        if entry is None and token.text in PROPERTY_WORDS:
            self._foreign_property(token, family)
            return ()
        if entry is None:
            suggestion = self.near_property(token.text, family)
            if suggestion is None and family and self._is_kind_or_joining(token):
                return ()
            self._unknown_property(token, family, suggestion)
            if suggestion is None:
                self.advance()
                self._skip_values()
                return ()
            entry = property_of(suggestion, family) or next(each for each in PROPERTIES if each.word == suggestion)
        self.advance()
        return (Setting(entry.word, self._values(entry), token.place),)

    def _unexpected(self, token: Token, family: str) -> None:
        if token.kind == "number" or token.kind in ("(", "-", "+"):
            entry = property_of("at", family) or property_of("angle", "body")
            assert entry is not None
            what = "what stands in these ( )" if token.kind == "(" else f"the number {cut(token.text)}"
            self.error("odd-number", f"{what} belongs to nothing", token, f"what is it? as in: {example_of(entry)}")
        elif token.kind == "string":
            self.error("odd-text", f"{shown(token)} belongs to nothing", token, 'what is it? as in: colour "red"')
        elif token.kind in ("=", "=="):
            self.error("odd-equals", "there is no = in a statement", token, "leave it out, as in: angle 30")
            self.advance()
            if self.at_number():
                self.number("a number")
            return
        elif token.kind == ",":
            self.error("odd-comma", "there is no comma between properties", token, "put a space instead")
            self.advance()
            return
        else:
            self.error("odd-mark", f"{shown(token)} has no place here", token, "leave it out")
        self.advance()
        raise Skip

    def _foreign_property(self, token: Token, family: str) -> None:
        """A known word that this kind of thing has no use for; its values are read, to find errors in them."""
        entry = next(each for each in PROPERTIES if token.text in (each.word, *each.spellings))
        owner = family or "thing"
        own = properties_of(family) if family else ()
        meant = next((each.word for each in own if token.text in each.meant), "")
        names = ", ".join(each.word for each in own)
        hint = f"did you mean '{meant}'?" if meant else f"it takes {names}" if names else ""
        if family == "drawing" and "body" in entry.families:
            hint = f"what is drawn is only seen; what new makes has {token.text}"
        if self.last.text in KINDS:
            hint = f"if it is a name, choose another, such as {token.text}1"
        if family:
            self.error("wrong-property", f"{has(owner)} no {token.text}", token, hint)
        self.advance()
        if self.token.kind == "string" or self.at_number():
            self._values(entry)

    def _is_kind_or_joining(self, token: Token) -> bool:
        if token.text not in RESERVED:
            return False
        self.error("odd-word", f"{shown(token)} has no place here", token, "is a ; missing before it?")
        self.advance()
        raise Skip

    def _unknown_property(self, token: Token, family: str, suggestion: str | None) -> None:
        if suggestion:
            hint = f"did you mean '{suggestion}'?"
        elif family:
            hint = f"there are {', '.join(each.word for each in properties_of(family))}"
        else:
            return  # what it belongs to is unknown, and that has been said
        self.error("unknown-property", f"there is no property {shown(token)}", token, hint)

    def setting_to_change(self, family: str) -> Setting:
        """The property and value of `set` for something of a family, "" if nobody knows; flags take on or off."""
        token = self.token
        changeable = {each.word: each for each in PROPERTIES if each.settable}
        own = [each for each in properties_of(family) if each.settable] or list(changeable.values())
        if token.text in _SWITCHES and not self.begins_event(token):
            shine = f"set lamp out {'off' if token.text == 'on' else 'on'};"
            flag = next((each.word for each in own if each.takes == "flag"), "lit")
            example = shine if family == "light" else f"set ball {flag} {token.text};"
            self.error("missing-property", f"set needs what is {token.text}, as in: {example}", token)
            self.advance()
            raise Skip
        if token.kind != "name" or self.starts_statement(token):
            where: Token | Place = self.after_last() if token.kind in (";", "}", "{", "end") else token
            self.error("missing-property", "set needs what to change, as in: set ball velocity 1 0;", where)
            raise Skip
        word = token.text
        entry = changeable.get(word) or next((each for each in changeable.values() if word in each.spellings), None)
        if entry is None:
            if word in PROPERTY_WORDS:
                self.error("wrong-property", f"{word} cannot be changed later", token, _changes_near(word))
                self.advance()
                raise Skip
            suggestion = near(word, [each.word for each in own], meant_for(own))
            entry = changeable.get(suggestion or "")
            hint = f"did you mean '{suggestion}'?" if entry else changes_of(family or "body") or changes_of("body")
            self.error("unknown-property", f"there is no property {shown(token)}", token, hint)
            if entry is None or self.next.kind in (";", "}", "end"):
                self.advance()
                raise Skip
        self.advance()
        if entry.takes == "flag":
            return Setting(entry.word, (self.switch(entry.word),), token.place)
        return Setting(entry.word, self._values(entry), token.place)

    def _values(self, entry: Property) -> tuple[Item, ...]:
        word = entry.word
        as_in = f"as in: {example_of(entry)}"
        match entry.takes:
            case "flag":
                self._no_value(word)
                return ()
            case "switch":
                return (self.switch(word),) if self.token.kind == "name" and self.token.text in _SWITCHES else ()
            case "choice":
                return (self._one_word(entry),)
            case "span":
                first = self.number(f"{word} needs one number, or the least and the most, {as_in}")
                return (first, self.number(as_in)) if self._more_numbers() else (first,)
            case "sides":
                return self._sides(f"{word} needs one number, or four: left, top, right, bottom, {as_in}")
            case "point" | "direction" | "spot":
                return (self.spot(f"{word} needs two numbers, {as_in}"),)
            case "colour":
                return (self.colour(word, as_in),)
            case "colours":
                return self._colours(word, as_in)
            case "corners":
                corners, said = self.spots("corner")
                if not corners and not said:
                    self.error("missing-number", f"{word} needs its corners", self.after_last(), as_in)
                    raise Skip
                return corners
            case "picture":
                return (self.file(word, "a picture", "crate.png"),)
            case "font":
                return (self.file(word, "a font file", "title.ttf"),)
            case "tag":
                return (self._tag(word),)
            case "name":
                return (self.name_of(f"{word} needs a name, {as_in}"),)
            case "names":
                return self._names(f"{word} needs one or more names, {as_in}")
            case "place":
                if self.at_number():
                    return (self.spot(f"{word} needs a name or two numbers, {as_in}"),)
                return (self.name_of(f"{word} needs a name or two numbers, {as_in}"),)
            case _:
                return (self.number(f"{word} needs a number, {as_in}"),)

    def spots(self, word: str) -> tuple[tuple[Spot, ...], bool]:
        """Points with commas between them, each a `word`; and whether something was wrong with them."""
        result: list[Spot] = []
        said = False
        wanted = f"each {word} is two numbers, x and y, as in: 0 0, 1 0, 0.5 1"
        while self.at_number():
            result.append(self.spot(wanted))
            if self.take(","):
                if not self.at_number():
                    self.error(
                        "odd-comma", f"after this comma another {word} is missing", self.last, "leave the comma out"
                    )
                continue
            if self.at_number() and not said:
                said = True
                self.error(
                    "missing-comma", f"a comma is missing between two {word}s", self.after_last(), "as in: 0 0, 1 0"
                )
        return tuple(result), said

    def _one_word(self, entry: Property) -> Text:
        """One of the words that there are, with or without quotes."""
        token, choices = self.token, entry.choices or {}
        stands = token.kind == "name" and (token.text in choices or (token.text not in RESERVED and not token.first))
        if token.kind == "string" or stands:
            self.advance()
            return Text(token.text, token.place)
        where: Token | Place = token if token.kind == "number" else self.after_last()
        self.error("missing-choice", f"{entry.word} needs a word", where, f"{entry.word} is {one_of(choices)}")
        if token.kind == "number":
            self.advance()
        raise Skip

    def _more_numbers(self) -> bool:
        return self.at_number() and not self.token.first

    def _sides(self, wanted: str) -> tuple[Item, ...]:
        """One number, or four."""
        result: list[Item] = [self.number(wanted)]
        while self._more_numbers() and len(result) < 4:
            result.append(self.number(wanted))
        if len(result) not in (1, 4):
            self.error("wrong-count", wanted, self.after_last())
            raise Skip
        return tuple(result)

    def _no_value(self, word: str) -> None:
        token = self.token
        if token.kind == "name" and token.text in ("on", "off", "true", "false", "yes", "no"):
            if self.begins_event(token):
                return
            self.error("odd-word", f"{word} stands alone, without {shown(token)}", token, "leave it out")
            self.advance()

    def _names(self, wanted: str) -> tuple[Item, ...]:
        result: list[Item] = [self.name_of(wanted)]
        while True:
            if self.token.kind == ",":
                self.error("odd-comma", "there is no comma between names", self.advance(), "put a space instead")
            if self.token.kind != "name" or self.token.text in RESERVED or self.token.first:
                return tuple(result)
            result.append(self.name_of(wanted))

    def switch(self, word: str) -> Identifier:
        """on or off."""
        token = self.token
        if token.kind == "name" and token.text in _SWITCHES:
            return Identifier(self.advance().text, token.place)
        guess = _TRUTHS.get(token.text.lower())
        where: Token | Place = token if guess or token.kind == "name" else self.after_last()
        self.error("missing-switch", f"{word} is on or off", where, f"did you mean '{guess}'?" if guess else "")
        if token.kind in ("name", "number") and not token.first and not self.starts_statement(token):
            self.advance()
        if guess:
            return Identifier(guess, token.place)
        raise Skip

    def colour(self, word: str, as_in: str = "") -> Text:
        """A colour's name, with or without quotes, or `"#rrggbb"` in quotes."""
        token = self.token
        if token.kind == "name" and self.next.kind == "(" and self.next.start == token.end:
            self.advance()
            self._skip_values()
            hint = f'as in: {word} "red", or {word} "#cc9966"'
            self.error("unknown-colour", f"a colour is not worked out, as by {cut(token.text)}( )", token, hint)
            raise Skip
        if token.kind == "string" or (token.kind == "name" and token.text not in RESERVED and not token.first):
            self.advance()
            return Text(token.text, token.place)
        where: Token | Place = self.after_last() if token.kind in (";", "}", "{", "end", "name") else token
        usual = f'as in: {word} "red", or {word} "#cc9966"'
        self.error("missing-colour", f"{word} needs a colour", where, as_in if "#" in as_in else usual)
        if token.kind == "number":
            self.advance()
        raise Skip

    def _colours(self, word: str, as_in: str) -> tuple[Item, ...]:
        """Two colours in quotes, or more."""
        result: list[Item] = []
        while self.token.kind == "string":
            token = self.advance()
            result.append(Text(token.text, token.place))
            if self.token.kind == ",":
                self.error("odd-comma", "there is no comma between colours", self.advance(), "put a space instead")
        if len(result) < 2:
            self.error("missing-colour", f"{word} needs two colours in quotes, or more", self.after_last(), as_in)
            raise Skip
        return tuple(result)

    def file(self, word: str, what: str, example: str) -> Text:
        """The name of a file, in quotes."""
        token = self.token
        if token.kind == "string":
            self.advance()
            return Text(token.text, token.place)
        if token.kind == "name" and token.text not in RESERVED and not token.first:
            self.advance()
            self.error("unquoted-file", "a file name stands in quotes", token, f'write "{cut(token.text)}"')
            raise Skip
        self.error("missing-file", f'{word} needs {what}, as in: {word} "{example}"', self.after_last())
        raise Skip

    def _tag(self, word: str) -> Text:
        token = self.token
        if token.kind == "string" or (token.kind == "name" and token.text not in RESERVED and not token.first):
            self.advance()
            return Text(token.text, token.place)
        self.error("missing-text", f'{word} needs a word, as in: {word} "coin"', self.after_last())
        raise Skip

    # Finding back

    def _skip_values(self) -> None:
        """Step over what seems to be the value of a word that nobody knows."""
        token = self.token
        stands_alone = self.next.kind not in ("number", "string", "(", "-")
        if token.kind == "name" and token.text not in RESERVED and not token.first and stands_alone:
            self.advance()
            return
        depth = 0
        while self.token.kind not in (";", "{", "}", "end") and (depth > 0 or self.token.kind != "name"):
            depth += {"(": 1, ")": -1}.get(self.token.kind, 0)
            self.advance()

    def resync(self) -> None:
        """After an error: on to the next property, or to where the statement ends."""
        while True:
            token = self.token
            if token.kind in (";", "{", "}", "end") or self.starts_statement(token):
                return
            if token.kind == "name" and (
                token.text in PROPERTY_WORDS
                or self.near_property(token.text, "") is not None
                or (token.first and self._misspelt_statement(token))
            ):
                return
            self.advance()

    def just_reported(self, where: Place) -> bool:
        """Whether the last error is about the very same spot, so that one there would be noise."""
        if not self.source.diagnostics:
            return False
        last = self.source.diagnostics[-1]
        return last.line == where.line and last.column == where.column


@functools.lru_cache(maxsize=1000)
def _near_any(word: str) -> str | None:
    return near(word, PROPERTY_WORDS)


def _changes_near(word: str) -> str:
    """What `set` changes of what has this property: of a thing, if that has it."""
    families = [family for each in PROPERTIES if each.word == word for family in each.families]
    return next(filter(None, map(changes_of, families)), "") if "body" not in families else changes_of("body")


def one_of(words: Iterable[str]) -> str:
    """Words to choose from, as people say them.

    >>> one_of(("loop", "once", "back"))
    'loop, once or back'
    """
    *others, last = words
    return f"{', '.join(others)} or {last}" if others else last


def example_of(entry: Property) -> str:
    """A property with its value, out of the table's example; of what needs a picture there is none."""
    if entry.example:
        return _extract(entry.example.splitlines()[-1], entry.word)
    return _PICTURED.get(entry.word, f'{entry.word} "crate.png"' if entry.takes == "picture" else entry.word)


_PICTURED = {
    "frames": "frames 4 1", "fps": "fps 10", "showing": "showing 2", "plays": "plays once", "tile": "tile 0.5",
    "slice": "slice 12", "tall": "tall 6", "layer": "layer -5", "colour": 'colour "grey"', "font": 'font "title.ttf"',
}  # fmt: skip


def _extract(example: str, word: str) -> str:
    """The part of an example statement that starts with `word`, up to the next property."""
    words = example.rstrip(";").split()
    if word not in words:
        return example
    start = words.index(word)
    end = start + 1
    while end < len(words) and words[end].rstrip(";") not in RESERVED:
        end += 1
    return " ".join(words[start:end])
