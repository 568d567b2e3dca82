"""Everything that EvilEngine raises, under one root.

Each error also derives from the built-in that fits, so `except ValueError` works too. A message names the object, the
argument, the value, what is allowed, and the likely fix.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from evilengine.values.diagnostics import Diagnostic


class Error(Exception):
    """Root of all errors that the engine raises."""


class ArgumentError(Error, ValueError):
    """An argument has the right type and a value that is not allowed: NaN, negative, out of range."""


class ArgumentTypeError(Error, TypeError):
    """An argument has the wrong type, is unknown, or is a handle of the wrong kind."""


class ShapeError(ArgumentError):
    """A shape that cannot exist: a negative radius, a polygon with crossing edges, zero area."""


class StaleReferenceError(Error, ReferenceError, ValueError):
    """A handle was used whose object has been destroyed."""


class SnapshotError(Error, ValueError):
    """Bytes that are not a whole, undamaged snapshot of this version."""


class LevelError(Error, ValueError):
    """A level script with errors; `.errors` lists them all."""

    def __init__(self, message: str = "", errors: tuple[Diagnostic, ...] = ()) -> None:
        super().__init__(message)
        self.errors = errors


class AssetError(Error, OSError):
    """An image, font or sound that is missing, unreadable, damaged or too large."""


class ShaderError(Error, ValueError):
    """A shader that does not compile; `.file` and `.line` say where, line 0 when the driver does not say."""

    def __init__(self, message: str = "", file: str = "", line: int = 0) -> None:
        super().__init__(message)
        self.file = file
        self.line = line


class SaveError(Error, OSError):
    """A saved game that cannot be written or read."""


class DamagedSaveError(SaveError):
    """A saved game or a recording whose bytes are not as they were written: cut, changed, or another kind of file."""


class DeviceError(Error, OSError):
    """A window, driver or input device that could not be had."""
