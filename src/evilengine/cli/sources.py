"""What a person may name on the command line: a level, a game, or one of the examples that ship with the engine."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path

from evilengine.values.checks import did_you_mean
from evilengine.values.errors import AssetError

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
ENDINGS = (".evil", ".py")


@dataclass(frozen=True, slots=True)
class Example:
    """A level or game that ships with the engine."""

    name: str
    path: Path
    summary: str


def examples() -> tuple[Example, ...]:
    """Every example, by name."""
    paths = sorted(path for path in EXAMPLES.iterdir() if path.suffix in ENDINGS and not path.name.startswith("_"))
    return tuple(Example(path.stem, path, _summary(path)) for path in paths)


def example(name: str) -> Example:
    """The example called `name`; its number may be left out. Raises AssetError with the nearest name."""
    for shipped in examples():
        if name in (shipped.name, _without_number(shipped.name)):
            return shipped
    raise AssetError(f"there is no example {name!r}{_near(name)}; `evil examples` lists them")


def things_of(path: Path) -> Path:
    """The folder with the pictures and sounds of an example: called as it is, without number; many have none."""
    return path.with_name(_without_number(path.stem))


def source(name: str) -> Path:
    """The level or game that `name` means: a file, else an example. Raises AssetError if it is neither."""
    path = Path(name)
    if path.suffix in ENDINGS:
        if path.is_file():
            return path
        raise AssetError(f"{name}: there is no such file{' but a folder' if path.is_dir() else ''}{_near(path.stem)}")
    if path.is_file():
        raise AssetError(f"{name}: neither a level (.evil) nor a game (.py)")
    return example(name).path


def _near(name: str) -> str:
    return did_you_mean(name, [word for each in examples() for word in (each.name, _without_number(each.name))])


def _without_number(name: str) -> str:
    return name.lstrip("0123456789").lstrip("_")


def _summary(path: Path) -> str:
    """The first line that says what a file is: a docstring's in Python, a comment's in a level."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        text = ast.get_docstring(ast.parse(text)) or ""
        return text.strip().splitlines()[0].rstrip(".") if text.strip() else ""
    comments = (line.lstrip()[1:].strip() for line in text.splitlines() if line.lstrip().startswith("#"))
    return next((comment.rstrip(".") for comment in comments if comment), "")
