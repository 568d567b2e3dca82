"""Shaders: read from their files, and errors of theirs told with file, line and the driver's words.

A line `#include "area.glsl"` stands for the text of the file of that name beside it. It stands outside of `#if`: where
that leaves lines out, the numbers of those after it would be lost.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from evilengine.renderer.gl.device import Source
from evilengine.values.errors import AssetError, ShaderError

FOLDER = Path(__file__).parent.parent / "shaders"
ES_HEADER = "#version 300 es"
DESKTOP_HEADER = "#version 330"

INCLUDED = 100_000
"""Lines of a shader's first included file count from here on, of its second from twice that. `#line` could name the
file by a number of its own, but some drivers lose that."""

# How drivers begin a line about an error: Mesa 0:12(5), NVIDIA 0(12), most others 0:12. The line is the second number.
_PLACE = re.compile(r"\b\d+[:(](\d+)[):(]")
_INCLUDE = re.compile(r'#include "([^"/\\]+)"\s*')
_STAGE = re.compile(r"(vertex|fragment)[ _]shader", re.IGNORECASE)


def load(name: str) -> Source:
    """The shader in the file called `name`, of those that ship with the engine."""
    folder, lines, included = FOLDER, [], []
    for number, line in enumerate(_read(folder, name).split("\n"), 1):
        include = _INCLUDE.fullmatch(line)
        if include is None:
            lines.append(line)
            continue
        included.append(include[1])
        first = INCLUDED * len(included) + 1
        lines += [f"#line {first}", _read(folder, include[1]).rstrip("\n"), f"#line {number + 1}"]
    return Source(str(folder / name), "\n".join(lines), tuple(str(folder / file) for file in included))


def _read(folder: Path, name: str) -> str:
    try:
        return (folder / name).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise AssetError(f"shader {name!r} cannot be read: {error}; install evilengine again") from None


def prepare(source: Source, defines: Mapping[str, int], *, es: bool) -> str:
    """What the driver gets: the header that it wants, then the definitions; lines keep the numbers of the file."""
    first, _, rest = source.text.partition("\n")
    if first.strip() != ES_HEADER:
        raise ShaderError(f"{source.file}:1: a shader begins with {ES_HEADER!r}, not {first!r}", source.file, 1)
    lines = [ES_HEADER if es else DESKTOP_HEADER, *(f"#define {name} {value}" for name, value in defines.items())]
    return "\n".join([*lines, "#line 2", rest])


def complaint(text: str, vertex: Source, fragment: Source) -> ShaderError:
    """What a driver said about two shaders, as one error."""
    stage = _STAGE.search(text)
    source = vertex if stage and stage[1].lower() == "vertex" else fragment
    words = [line.strip() for line in text.splitlines() if _says_something(line)]
    files = source.file, *source.included
    for line in words:
        place = _PLACE.search(line)
        if place:
            number, at = divmod(int(place[1]), INCLUDED)
            file = files[min(number, len(files) - 1)]
            return ShaderError(f"{file}:{at}: {line}", file, at)
    said = "; ".join(words) or "the driver gives no reason"
    return ShaderError(f"{vertex.file} and {fragment.file} do not fit together: {said}", fragment.file, 0)


def _says_something(line: str) -> bool:
    """Not a heading, an underline or nothing."""
    text = line.strip()
    return bool(text.strip("=-")) and not text.startswith("GLSL ") and text not in ("vertex_shader", "fragment_shader")
