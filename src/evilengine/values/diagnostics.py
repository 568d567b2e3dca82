"""Diagnostics: what is wrong with a level, for a person to read."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass

from evilengine.values.errors import LevelError

CARET_WINDOW = 100  # characters of a source line shown round the caret; longer lines are cut with "..."


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One error in a level: where it is, what is wrong, and what would mend it.

    `line` and `column` count from 1, in characters; `length` is how many characters are wrong.
    """

    code: str
    message: str
    file: str
    line: int
    column: int
    length: int = 1
    suggestion: str = ""
    source: str = ""
    """The source line, for showing."""

    @property
    def headline(self) -> str:
        """`file:line:col: error[code]: message`"""
        return f"{self.file}:{self.line}:{self.column}: error[{self.code}]: {self.message}"

    def __str__(self) -> str:
        lines = [self.headline]
        if self.source:
            lines += _pointed_out(self.source, self.column, self.length)
        if self.suggestion:
            lines.append(f"    {self.suggestion}")
        return "\n".join(lines)

    def as_dict(self) -> dict[str, str | int]:
        """The fields for JSON."""
        return {
            "file": self.file,
            "line": self.line,
            "column": self.column,
            "length": self.length,
            "severity": "error",
            "code": self.code,
            "message": self.message,
            "suggestion": self.suggestion,
        }


def _pointed_out(source: str, column: int, length: int) -> list[str]:
    """The source line and carets below it; tabs stay tabs and wide letters count twice, so that they align."""
    start = max(0, column - 1 - CARET_WINDOW // 2)
    end = min(len(source), start + CARET_WINDOW)
    shown = "".join(letter if letter.isprintable() or letter == "\t" else "?" for letter in source[start:end])
    before = "..." if start > 0 else ""
    after = "..." if end < len(source) else ""
    at = column - 1 - start
    under = "".join("\t" if letter == "\t" else " " * _cells(letter) for letter in shown[:at])
    marked = sum(_cells(letter) for letter in shown[at : at + length])
    carets = "^" * max(1, marked)
    return [f"    {before}{shown}{after}", f"    {' ' * len(before)}{under}{carets}"]


def _cells(letter: str) -> int:
    """How many columns of a terminal a letter fills."""
    if unicodedata.combining(letter):
        return 0
    return 2 if unicodedata.east_asian_width(letter) in "WF" else 1


def level_error(diagnostics: tuple[Diagnostic, ...]) -> LevelError:
    """The error to raise for a level with these diagnostics: its message shows them all, its `.errors` holds them."""
    return LevelError("\n".join(str(each) for each in diagnostics), diagnostics)
