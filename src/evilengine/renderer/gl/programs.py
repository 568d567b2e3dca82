"""The shader programs of one device: compiled when they are first needed, and again when their files change."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from evilengine.renderer.gl import shaders
from evilengine.renderer.gl.device import GraphicsDevice, Program
from evilengine.values.errors import AssetError, ShaderError

Key = tuple[str, str, tuple[tuple[str, int], ...]]


@dataclass(slots=True)
class _Made:
    """A program, and the files that it is made of, with what changes when they do."""

    program: Program
    stamps: dict[str, tuple[int, int] | None]


class Programs:
    """Programs by the names of their files and by what is defined for them."""

    def __init__(self, device: GraphicsDevice) -> None:
        self._device = device
        self._made: dict[Key, _Made] = {}

    def get(self, vertex: str, fragment: str, **defines: int) -> Program:
        """The program of two files. Raises ShaderError with place and the driver's words if it cannot be made."""
        key = vertex, fragment, tuple(defines.items())
        made = self._made.get(key)
        if made is None:
            made = self._made[key] = _Made(*self._make(key))
        return made.program

    def reload(self) -> list[str]:
        """Make those programs anew whose files have changed.

        One that cannot be made stays in use as it was; the lines returned say why, once for each change of its files.
        """
        lines: dict[str, None] = {}
        for key, made in self._made.items():
            now = {file: _stamp(file) for file in made.stamps}
            if now == made.stamps:
                continue
            made.stamps = now
            try:
                made.program, made.stamps = self._make(key)
            except (ShaderError, AssetError) as error:
                lines[f"{error}; it is drawn as before"] = None
        return list(lines)

    def _make(self, key: Key) -> tuple[Program, dict[str, tuple[int, int] | None]]:
        vertex, fragment = (shaders.load(name) for name in key[:2])
        files = (vertex.file, *vertex.included, fragment.file, *fragment.included)
        return self._device.program(vertex, fragment, dict(key[2])), {file: _stamp(file) for file in files}


def _stamp(file: str) -> tuple[int, int] | None:
    try:
        status = Path(file).stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size
