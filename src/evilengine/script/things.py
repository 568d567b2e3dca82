"""The part of the parser that reads what makes and changes things: new, text, set; and where a statement ends."""

from __future__ import annotations

from abc import ABC, abstractmethod

from evilengine.script.expressions import Skip, cut, shown
from evilengine.script.lexer import Source, Token
from evilengine.script.settings import Settings, one_of
from evilengine.script.syntax import Block, Change, Expression, Identifier, New, Sounding, Spot, Text, TextLine
from evilengine.script.word import Kind
from evilengine.script.words import (
    DRAWN,
    EVENT_NAMES,
    FUNCTIONS,
    KINDS,
    PROPERTY_WORDS,
    RESERVED,
    STATEMENTS,
    has,
    near_change,
    near_kind,
    placed,
    property_of,
    some,
)
from evilengine.values.level import Place


class Things(Settings, ABC):
    """Readers of `new`, `text` and `set`."""

    def __init__(self, source: Source, tokens: list[Token]) -> None:
        super().__init__(source, tokens)
        self.made: dict[str, str] = {}
        """Names made so far, wherever, and their families; only for better suggestions."""
        self._swapped: Identifier | None = None
        """A name that was written before its kind."""

    @abstractmethod
    def block(self, place: Place) -> Block:
        """The statements in { }."""

    # set NAME PROPERTY VALUE, set NAME NUMBER

    def changed(self, place: Place, before: int) -> Change | None:
        target, setting, value = None, None, None
        try:
            target = self.name_of("set needs the name of what changes, as in: set ball velocity 1 0;")
            if self.token.kind in ("=", "=="):
                self.error("odd-equals", "there is no = here", self.advance(), f"as in: set {cut(target.name)} 1;")
            if self.at_number() or target.name in self.number_names:
                value = self.number(f"set {cut(target.name)} needs a number, as in: set {cut(target.name)} 1;")
            else:
                setting = self.setting_to_change(self.made.get(target.name, ""))
        except Skip:
            self.resync()
        broken = self.broken(before)
        self.finish()
        return Change(target, setting, value, place, broken) if target is not None else None

    # text [NAME] "WORDS" PROPERTIES

    def text(self, place: Place, before: int) -> TextLine | None:
        name = None
        if self.token.kind == "name" and self.token.text not in PROPERTY_WORDS:
            name = self.name_to_make()
            if name is not None:
                self.made[name.name] = "text"
        if self.token.kind != "string":
            if name is not None:
                self.error(
                    "unquoted-text", "the words of a text stand in quotes", name.place, f'write "{cut(name.name)}"'
                )
            else:
                self.error(
                    "missing-text", 'text needs words in quotes, as in: text "Hello" at 20 20;', self.after_last()
                )
            self.settings("text")
            self.finish()
            return None
        words = self.advance()
        settings = self.settings("text")
        broken = self.broken(before)
        self.finish()
        return TextLine(name, Text(words.text, words.place), settings, place, broken)

    # play "FILE" PROPERTIES, music "FILE" PROPERTIES, music off

    def sounding(self, word: str, place: Place, before: int) -> Sounding:
        file = None
        try:
            if word == "music" and self.at_word("off"):
                self.advance()
            else:
                file = self.file(word, "a sound", "thud.ogg" if word == "play" else "wind.ogg")
        except Skip:
            pass  # its properties may hold errors of their own
        settings = self.settings("sound" if word == "play" else "music")
        broken = self.broken(before)
        self.finish()
        return Sounding(word, file, settings, place, broken)

    def unknown_statement(self, token: Token) -> None:
        """Say that nothing starts with this word, and what was probably meant."""
        word, name = token.text, self.next.text
        hint = f"statements start with {', '.join(STATEMENTS)}"
        if "." in word:
            owner = word.split(".")[0]
            hint = f"as in: set {owner} velocity 1 0;  destroy {owner};"
        elif name in self.made:
            changed = near_change(word, self.made[name])
            hint = f"did you mean: set {name} {changed} ...?" if changed else f"what changes is said by set {name} ..."
        self.error("unknown-statement", f"there is no statement {shown(token)}", token, hint)

    # new KIND [NAME] SIZES PROPERTIES

    def thing(self, place: Place, before: int, *, drawn: bool = False) -> New:
        kind, kind_place = self._kind("draw" if drawn else "new")
        if drawn and kind is not None and kind.word not in DRAWN:
            hint = f"write: new {kind.word}; draw makes pictures of {one_of(DRAWN)}"
            self.error("wrong-kind", f"{some(kind.word)} cannot be drawn", kind_place or place, hint)
        family = "drawing" if drawn else kind.family if kind else ""
        name = self._name_of_new(family)
        if name is not None:
            self.made[name.name] = family
        sizes: tuple[Expression, ...] = ()
        corners: tuple[Spot, ...] = ()
        try:
            if kind is None or kind.corners is None:
                sizes = self._sizes(kind)
            else:
                corners = self._corners(kind)
        except Skip:
            self.resync()
        settings = self.settings(family)
        broken = self.broken(before)
        self.finish()
        return New(kind.word if kind else None, name, sizes, corners, settings, kind_place or place, broken, drawn)

    def _kind(self, word: str) -> tuple[Kind | None, Place | None]:
        token = self.token
        if token.kind != "name" or self.starts_statement(token):
            kinds = DRAWN if word == "draw" else KINDS
            message = f"{word} needs what to make, as in: {word} circle 0.5 at 0 3;"
            if token.kind == "name" and not token.first:
                hint = f"{token.text} stands alone: leave {word} out"
                self.error("missing-kind", f"{word} does not go with {token.text}", self.last, hint)
                raise Skip
            self.error("missing-kind", message, self.after_last(), f"there are {', '.join(kinds)}")
            raise Skip
        self.advance()
        if token.text in KINDS:
            return KINDS[token.text], token.place
        after = self.token
        if after.kind == "name" and after.text in KINDS and token.text not in RESERVED:
            self.error(
                "word-order", "the kind comes before the name", token, f"write: {word} {after.text} {cut(token.text)}"
            )
            self.advance()
            self._swapped = Identifier(token.text, token.place)
            return KINDS[after.text], after.place
        suggestion = near_kind(token.text)
        if not self.just_reported(token.place):
            hint = f"did you mean '{suggestion}'?" if suggestion else f"there are {', '.join(KINDS)}"
            self.error("unknown-kind", f"there is no kind of thing called {shown(token)}", token, hint)
        return (KINDS[suggestion] if suggestion else None), token.place

    def _name_of_new(self, family: str) -> Identifier | None:
        if self._swapped is not None:
            swapped, self._swapped = self._swapped, None
            return swapped
        token, after = self.token, self.next
        if self.starts_statement(token) and not token.first and after.kind in ("number", "(", "-"):
            return self.name_to_make()
        if token.kind != "name" or token.text in PROPERTY_WORDS or self._at_call() or self.starts_statement(token):
            if token.kind == "string" and not token.first:
                self.error("quoted-name", "a name stands without quotes", token, f"write {cut(token.text)}")
                self.advance()
            return None
        if after.kind == "(" and after.start == token.end:
            self.unknown_function(self.advance())
            return None
        name_follows = after.kind in ("number", "(", "-", "+", ";", "}", "end") or (
            after.kind == "name" and (after.text in RESERVED - EVENT_NAMES or after.text in FUNCTIONS or after.first)
        )  # and neither `this` nor `other`: they are what a property such as `follows` is about
        if not name_follows and self.near_property(token.text, family):
            return None  # a misspelt property, which its reader reports
        return self.name_to_make()

    def _sizes(self, kind: Kind | None) -> tuple[Expression, ...]:
        start = self.token.start
        names = " and ".join(each.name for each in kind.sizes) if kind else ""
        result: list[Expression] = []
        while self.at_number() or (self.token.kind == "name" and self.token.text in self.number_names):
            value = self.number("a number")
            if self.token.kind == "," and not self.next.first:
                value = self.comma(value)
            result.append(value)
            self.unit_apart()
        if kind is None:
            return tuple(result)
        wanted = len(kind.sizes)
        allowed = (wanted, wanted + 2) if placed(kind) else (wanted,)
        if len(result) in allowed:
            return tuple(result)
        form = _counted(wanted, names) if wanted else "no number here"
        if placed(kind):
            form += f", or {wanted + 2} with its place ({names.replace(' and ', ', ')}, x, y)"
        found = {0: "there is none"}.get(len(result), f"here {'is' if len(result) == 1 else 'are'} {len(result)}")
        where = self.span(start) if result else self.after_last()
        lines = kind.example.splitlines()
        example = next((line for line in lines if line.split()[:2] == ["new", kind.word]), lines[-1])
        hint = f"as in: {example}"
        if not wanted and len(result) == 2 and property_of("at", kind.family):
            hint = "its place comes after at, as in: at 0 3"
        elif not result and self.token.text in PROPERTY_WORDS - {"at"} and self.next.kind == "number":
            word = self.token.text
            hint = f"'{word}' is a word of the language, so as a name write {word}1; or {hint}"
        self.error("wrong-count", f"{has(kind.word, 'takes')} {form}; {found}", where, hint)
        return tuple(result)

    def _corners(self, kind: Kind) -> tuple[Spot, ...]:
        start = self.token.start
        word = "point" if kind.open else "corner"
        result, said = self.spots(word)
        fewest, most = kind.corners or (0, 0)
        if not fewest <= len(result) <= most and not said:
            where = self.span(start) if result else self.after_last()
            allowed = f"{fewest} {word}s" if fewest == most else f"{fewest} to {most} {word}s"
            found = "there is none" if not result else f"here {'is' if len(result) == 1 else 'are'} {len(result)}"
            self.error("wrong-count", f"{has(kind.word)} {allowed}; {found}", where, f"as in: {kind.example}")
        return result

    # The end of a statement

    def finish(self) -> None:
        """The semicolon at the end of a statement."""
        if self.take(";"):
            return
        token = self.token
        if token.kind in ("}", "end") or self.starts_statement(token) or token.first:
            self.error(
                "missing-semicolon", "a ; is missing at the end of this statement", self.after_last(), "put a ; here"
            )
        elif token.kind == "{":
            self.error("odd-brace", "this statement takes no block", token, "is a ; missing before it?")
            self.block(token.place)
        else:
            self._left_over(token)

    def _left_over(self, token: Token) -> None:
        if not self.unit_apart():
            self.error("odd-word", f"{shown(token)} has no place here", token, "is a ; missing before it?")
            self.advance()
        self.resync()
        while self.token.kind == "name" and self.token.text in PROPERTY_WORDS and not self.token.first:
            self.advance()
            self.resync()
        self.take(";")

    def broken(self, before: int) -> bool:
        """Whether there are more errors than `before`."""
        return len(self.source.diagnostics) > before


def _counted(count: int, names: str) -> str:
    return f"one number, its {names}" if count == 1 else f"{count} numbers, its {names}"
