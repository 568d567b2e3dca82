"""Text to tokens. Whatever the text is, there are tokens and a list of what was odd about it; nothing is raised."""

from __future__ import annotations

import bisect
import re
from collections.abc import Iterator
from dataclasses import dataclass

from evilengine.script.word import UNITS
from evilengine.script.words import PROPERTY_WORDS, near
from evilengine.values.diagnostics import Diagnostic
from evilengine.values.level import Place

MAX_CHARACTERS = 500_000  # a level of ten thousand objects takes 600,000 at most; more is a wrong file, not a level
MAX_DIAGNOSTICS = 1000  # enough to mend for a day; a picture opened as a level has no end of them

_TOKEN = re.compile(
    r"""
    (?P<space>\s+)
  | (?P<comment>\#[^\n]*)
  | (?P<slashes>//[^\n]*|/\*.*?(?:\*/|\Z))
  | (?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)
  | (?P<name>[^\W\d]\w*(?:\.[^\W\d]\w*)*)
  | (?P<string>"[^"\n]*"?)
  | (?P<quoted>'[^'\n]*'|[“”„][^“”"\n]*[“”"])
  | (?P<mark><=|>=|==|!=|[;{}(),+*/%<>=-])
  | (?P<odd>[^\s\w";{}(),+*/%<>=\-\#]+|.)
    """,
    re.VERBOSE | re.DOTALL,
)
_UNIT = re.compile(r"(?:m/s|km/h|deg/s|rad/s|°/s|°|[^\W\d]\w*)")
_HEX = re.compile(r"#(?:[0-9a-fA-F]{8}|[0-9a-fA-F]{6}|[0-9a-fA-F]{3,4})\b")
_WORDS = "|".join(sorted(PROPERTY_WORDS))
_TEXT_END = re.compile(rf"(?<=#[0-9a-fA-F]{{6}})(?=\s)|\s+(?:{_WORDS})\b|;|\s+\{{(?=\s|$)|\}}\s*$")
_COLOUR_WORDS = {"colour", "color", "background"}
_LOOKALIKES = {"\uff1b": ";", "\u037e": ";", "\uff0c": ",", "\u2212": "-", "\u2013": "-", "\u2014": "-"}


@dataclass(frozen=True, slots=True)
class Token:
    """A word, number, string or mark. `kind` is name, number, string, end, or the mark itself."""

    kind: str
    text: str
    place: Place
    start: int
    end: int
    first: bool = False
    """Whether it is the first on its line."""
    number: float = 0.0
    unit: str = ""


class Source:
    """The text of a level, and its diagnostics so far."""

    def __init__(self, text: str, file: str) -> None:
        self.file = file
        self.text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
        self.lines = tuple(self.text.split("\n"))
        self._starts = [0]
        for line in self.lines:
            self._starts.append(self._starts[-1] + len(line) + 1)
        self.diagnostics: list[Diagnostic] = []

    def place(self, start: int, end: int) -> Place:
        """The place of `text[start:end]`; of what goes on over several lines, the part on the first."""
        line = max(1, bisect.bisect_right(self._starts, start, 0, len(self.lines)))
        column = start - self._starts[line - 1]
        length = min(end - start, len(self.lines[line - 1]) - column)
        return Place(line, column + 1, max(1, length))

    @property
    def full(self) -> bool:
        """Whether there are so many errors that reading on is of no use."""
        return len(self.diagnostics) > MAX_DIAGNOSTICS

    def error(self, code: str, message: str, place: Place, suggestion: str = "") -> None:
        """Note an error."""
        if self.full:
            return
        if len(self.diagnostics) == MAX_DIAGNOSTICS:
            code, message = "too-many-errors", "there are more errors after this one"
            suggestion = "mend the first ones and check again; is this really a level?"
        line = self.lines[place.line - 1] if 0 < place.line <= len(self.lines) else ""
        self.diagnostics.append(
            Diagnostic(code, message, self.file, place.line, place.column, place.length, suggestion, line)
        )


def tokens(source: Source) -> list[Token]:
    """The tokens of `source`, the last of kind "end"; errors go to `source.diagnostics`."""
    if len(source.text) > MAX_CHARACTERS:
        source.error(
            "too-long",
            f"this file has {len(source.text):,} characters; a level has at most {MAX_CHARACTERS:,}",
            Place(1, 1),
            "is it really a level?",
        )
        return [_end(source, [])]
    result: list[Token] = []
    last_line = 0
    for kind, text, start, end in _pieces(source, result):
        place = source.place(start, end)
        first = place.line != last_line
        last_line = place.line
        if kind == "number" and result and result[-1].kind == "number" and result[-1].end == start:
            whole = source.place(result[-1].start, end)
            source.error("bad-number", "this number has two points in it", whole, "a number is written like 12 or 0.5")
        elif kind == "number":
            result.append(_number(source, text, place, start, end, first))
        else:
            result.append(Token(kind, text, place, start, end, first))
    result.append(_end(source, result))
    return result


def _end(source: Source, before: list[Token]) -> Token:
    size = len(source.text)
    place = source.place(size, size)
    return Token("end", "", place, size, size, not before or place.line != before[-1].place.line)


def _pieces(source: Source, before: list[Token]) -> Iterator[tuple[str, str, int, int]]:
    """(kind, text, start, end) of each token, with what is odd reported and mended."""
    text, position = source.text, 0
    while position < len(text) and not source.full:
        match = _TOKEN.match(text, position)
        assert match is not None, "the last alternative takes any character"
        kind, piece, start = match.lastgroup or "odd", match.group(), position
        position = match.end()
        if kind == "string":
            for token in _string(source, piece, start):
                position = token[3]
                yield token
        elif kind == "comment":
            colour = _HEX.match(piece)
            if colour and before and before[-1].text in _COLOUR_WORDS:  # `colour #f00;` would be a comment
                position = start + colour.end()
                source.error(
                    "unquoted-colour",
                    f"the colour {colour.group()} needs quotes round it, because # starts a comment",
                    source.place(start, position),
                    f'write "{colour.group()}"',
                )
                yield "string", colour.group(), start, position
        elif kind == "number":
            unit = _UNIT.match(text, position)
            if unit:
                position = unit.end()
            yield kind, text[start:position], start, position
        elif kind in ("name", "mark"):
            yield piece if kind == "mark" else kind, piece, start, position
        elif kind == "quoted":
            content = piece[1:-1]
            source.error(
                "wrong-quotes",
                "these quotes are of another kind",
                source.place(start, position),
                f'use straight double quotes: "{content}"',
            )
            yield "string", content, start, position
        elif kind == "slashes":
            source.error(
                "wrong-comment",
                f"a comment starts with #, not with {piece[:2]}",
                source.place(start, start + 2),
                "write # instead",
            )
        elif kind == "odd":
            yield from _odd(source, piece, start)


def _string(source: Source, piece: str, start: int) -> Iterator[tuple[str, str, int, int]]:
    closed = len(piece) > 1 and piece.endswith('"')
    line = source.lines[source.place(start, start).line - 1]
    if closed and (line.count('"') % 2 == 0 or not _TEXT_END.search(piece)):
        yield "string", piece[1:-1], start, start + len(piece)
        return
    message = 'this text has no end: a second " is missing on its line'
    source.error("unclosed-text", message, source.place(start, start + 1), 'put a " where the text ends')
    # What was meant ends before the next word of the language, block or semicolon; then nothing else looks wrong.
    end = _TEXT_END.search(piece)
    content = piece[: end.start()] if end else piece.rstrip()
    yield "string", content[1:], start, start + len(content)


def _odd(source: Source, piece: str, start: int) -> Iterator[tuple[str, str, int, int]]:
    meant = _LOOKALIKES.get(piece)
    place = source.place(start, start + len(piece))
    if meant:
        source.error("odd-character", f"this looks like {meant} but is another letter", place, f"type {meant} again")
        yield meant, meant, start, start + len(piece)
        return
    shown = piece if piece.isprintable() else f"(code {ord(piece[0])})"
    if len(shown) > 12:
        shown = shown[:12] + "..."
    hint = {"[": "a block of statements stands in { }", ":": "leave it out", ".": "a number such as 0.5 has digits"}
    source.error("odd-character", f"{shown} means nothing in a level", place, hint.get(piece[0], "leave it out"))


def _number(source: Source, text: str, place: Place, start: int, end: int, first: bool) -> Token:
    match = _TOKEN.match(text)
    assert match is not None
    digits, unit = match.group("number"), text[match.end("number") :]
    value = float(digits)
    if value > 1e15:
        source.error("number-too-large", f"{digits} is too large a number", place, "a level's numbers stay below 1e15")
        value = 1.0
    if unit and unit not in UNITS:
        wrong = Place(place.line, place.column + len(digits), len(unit))
        suggestion = near(unit, UNITS)
        source.error(
            "unknown-unit",
            f"'{unit}' is not a unit",
            wrong,
            f"did you mean {digits}{suggestion}?" if suggestion else _unit_hint(unit),
        )
        unit = suggestion or ""
    return Token("number", text, place, start, end, first, value, unit)


def _unit_hint(unit: str) -> str:
    units = f"units are {', '.join(UNITS)}"
    return f"a name starts with a letter; {units}" if len(unit) > 3 else units
