"""The level language: text becomes commands for a game, or a list of everything that is wrong with it."""

from __future__ import annotations

from pathlib import Path

from evilengine.script.builder import Builder
from evilengine.script.lexer import MAX_CHARACTERS, Source
from evilengine.script.parser import parse
from evilengine.values.diagnostics import Diagnostic, level_error
from evilengine.values.errors import AssetError
from evilengine.values.level import LevelScript


def check(text: str, file: str = "level.evil", folder: str | Path = "") -> tuple[LevelScript, tuple[Diagnostic, ...]]:
    """The level that `text` is, and its errors, from first to last; one with errors is not fit to be played.

    Pictures are looked for in `folder`; with "" nobody looks. Whatever the text is, nothing is raised.

    >>> level, errors = check("new circel 0.5 at 0 3;")
    >>> print(errors[0])
    level.evil:1:5: error[unknown-kind]: there is no kind of thing called 'circel'
        new circel 0.5 at 0 3;
            ^^^^^^
        did you mean 'circle'?
    """
    source = Source(text, file)
    level, lost = parse(source)
    commands = Builder(source, level, str(folder), lost).block(level.statements)
    errors = tuple(sorted(source.diagnostics, key=lambda each: (each.line, each.column)))
    return LevelScript(file, str(folder), commands, lines=source.lines), errors


def read(text: str, file: str = "level.evil", folder: str | Path = "") -> LevelScript:
    """The level that `text` is. Raises LevelError with all its errors.

    >>> read("new circle 0.5 at 0 3;").commands[0].shapes[0].type
    'Circle'
    """
    level, errors = check(text, file, folder)
    if errors:
        raise level_error(errors)
    return level


def check_file(path: str | Path) -> tuple[LevelScript, tuple[Diagnostic, ...]]:
    """As `check`, of a file; one that is no text has an error that says so. Raises AssetError if it cannot be read."""
    file = Path(path)
    try:
        with file.open("rb") as stream:
            data = stream.read(4 * MAX_CHARACTERS + 1)
    except FileNotFoundError:
        raise AssetError(f"{path}: there is no such file") from None
    except OSError as error:
        raise AssetError(f"{path}: cannot be read: {error.strerror or error}") from None
    except ValueError:
        raise AssetError(f"{str(path)!r} is not a file's name") from None
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        return LevelScript(str(path), "", ()), (_not_text(data, error.start, str(path)),)
    return check(text, str(path), file.parent)


def read_file(path: str | Path) -> LevelScript:
    """As `read`, of a file. Raises AssetError when it cannot be read."""
    level, errors = check_file(path)
    if errors:
        raise level_error(errors)
    return level


def _not_text(data: bytes, at: int, file: str) -> Diagnostic:
    line = data.count(b"\n", 0, at) + 1
    start = data.rfind(b"\n", 0, at) + 1
    shown = data[start:at].decode("utf-8")
    return Diagnostic(
        "not-text",
        "here is a byte that is no text in UTF-8",
        file,
        line,
        len(shown) + 1,
        1,
        "save the file as UTF-8 text; is it really a level?",
        shown + "?",
    )


__all__ = ["check", "check_file", "read", "read_file"]
