"""The reference page of the level language, written from the word tables.

python -m evilengine.script.reference docs/level-language.md
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

from evilengine.script.expressions import MAX_DEPTH
from evilengine.script.joints import JOINTS
from evilengine.script.settings import example_of
from evilengine.script.word import (
    MAX_BODIES,
    MAX_CORNERS,
    MAX_NESTING,
    MAX_ROUNDS,
    MAX_WORK,
    MEASURES,
    UNITS,
    Kind,
    Property,
)
from evilengine.script.words import EVENTS, FUNCTIONS, KINDS, STATEMENTS, placed, properties_of, takes

_INTRODUCTION = """\
# The level language

A level is a text file that ends in `.evil`. It says what is in a world and what happens there, one statement after the
other. `evil play level.evil` plays it, and loads it again whenever you save it; `evil check level.evil` says everything
that is wrong with it; `evil translate level.evil` prints it as Python.

```
# A ball falls on a crate.
view 16 9;
new rectangle ground 16 1 at 0 -4;
new rectangle crate 2 1 at 0 -2 physicsOn colour "#cc9966";
new circle ball 0.5 at 0.3 3 physicsOn touchable;
on collide ball crate { set ball colour "gold"; }
```

This page is written from the tables that the engine itself reads: `python -m evilengine.script.reference FILE`.

## How it is written

- A statement ends with `;`. What belongs together stands in `{ }`. Lines and spaces are free.
- `#` starts a comment, up to the end of its line. Colours such as `"#cc9966"` therefore stand in quotes.
- Numbers are metres, seconds, degrees and kilograms, unless a unit stands right behind them: UNITS.
- A point is two numbers with a space between: `at 0 4`. y goes up. A list of points has commas: `0 0, 1 0, 0.5 1`.
- Arithmetic stands inside parentheses: `(2 * i + 1)`. So `0 -9.81` is two numbers, and `(0 - 9.81)` is one.
- Names are made of letters, digits and `_`. No two things share one. A name that is made in a block is known there,
  and in the blocks inside it; each round of a `repeat` or an `every` has its own. Something has to be made before it
  is spoken of.
- What is gone stays gone: destroying, changing or kicking it does nothing.
- File names stay inside the level's folder.
- There are limits, far beyond what a level needs: LIMITS.
"""


def reference() -> str:
    """The whole page."""
    units = ", ".join(f"`{unit}`" for unit in UNITS)
    limits = (
        f"{MAX_ROUNDS} rounds of one `repeat`, {MAX_WORK} of repeats in each other, {MAX_NESTING} blocks and "
        f"{MAX_DEPTH} parentheses inside each other, {MAX_CORNERS} corners, and {MAX_BODIES} things at a time; "
        "with that many, `new` does nothing"
    )
    parts = [_INTRODUCTION.replace("UNITS", units).replace("LIMITS", limits)]
    parts.append("## Statements\n")
    for statement in STATEMENTS.values():
        forms = "\n".join(each.strip() for each in statement.form.split("  "))
        parts.append(f"### {statement.word}\n\n```\n{forms}\n```\n\n{statement.doc}\n\n{_example(statement.example)}")
    events = "\n".join(f"- `on {event}`: when {meaning}" for event, meaning in EVENTS.items())
    parts.append(f"### Events\n\n{events}\n")
    parts.append("## What `new` makes\n")
    parts += [_kind(kind) for kind in KINDS.values()]
    parts.append(
        "## Properties\n\n`set` can change those that are marked; the last column is what Python calls them.\n"
    )
    parts.append("### Of things\n\n" + _table(properties_of("body")))
    parts.append("### Of characters\n\n" + _table(properties_of("character")))
    parts.append("### Of springs\n\n" + _table(properties_of("spring")))
    parts.append("### Of joints\n\n" + _table(_merged(*JOINTS)))
    parts.append("### Of forces, drag and media\n\n" + _table(_merged("force", "drag", "medium")))
    parts.append("### Of backgrounds, planes and the lens\n\n" + _table(_merged("background", "plane", "lens")))
    parts.append("### Of the camera\n\n" + _table(properties_of("camera")))
    parts.append("### Of lights\n\n" + _table(properties_of("light")))
    parts.append("### Of smoke\n\n" + _table(properties_of("smoke")))
    parts.append("### Of sources of smoke\n\n" + _table(properties_of("source")))
    parts.append("### Of water and liquids\n\n" + _table(_merged("water", "liquid")))
    parts.append("### Of what is filled, poured and drained\n\n" + _table(_merged("stream", "filling", "drain")))
    parts.append("### Of particles\n\n" + _table(properties_of("particles")))
    parts.append("### Of drawings\n\n" + _table(properties_of("drawing")))
    parts.append("### Of texts\n\n" + _table(properties_of("text")))
    parts.append("### Of sounds and music\n\n" + _table(_merged("sound", "music")))
    parts.append(
        "## Arithmetic\n\n`+ - * / %` and parentheses; for conditions `< > <= >= == !=`, `and`, `or`, `not`.\n"
    )
    parts.append("\n".join(f"- `{word.example.split(';')[0]}`: {word.doc}" for word in FUNCTIONS.values()) + "\n")
    return "\n".join(parts)


def _example(text: str) -> str:
    return f"```\n{text}\n```\n"


def _kind(kind: Kind) -> str:
    if kind.corners is not None:
        fewest, most = kind.corners
        form = f"new {kind.word} [NAME] {', '.join(['X Y'] * fewest)}" + (", ..." if most > fewest else "")
        form += " at X Y" if "at" in kind.needs else ""
    else:
        form = f"new {kind.word} [NAME] " + " ".join(size.name.upper() for size in kind.sizes)
        form = form.strip() + (" [X Y]" if placed(kind) else "")
    needs = [need for need in kind.needs if need != "at"]
    form += "".join(f" {need} ..." for need in needs) + " [PROPERTIES];"
    ranges = [
        f"{size.name.capitalize()}: {size.range}" + (f" {MEASURES[size.measure]}." if size.measure else ".")
        for size in kind.sizes
        if str(size.range) != "any number"
    ]
    words = ", ".join(f"`{each.word}`" for each in properties_of(kind.family) if takes(kind, each))
    lines = [f"### {kind.word}\n", f"```\n{form}\n```\n", " ".join([kind.doc, *ranges]) + "\n"]
    return "\n".join([*lines, f"Properties: {words}\n" if words else "", _example(kind.example)])


def _merged(*families: str) -> list[Property]:
    result: list[Property] = []
    for family in families:
        result += [each for each in properties_of(family) if each not in result]
    return result


def _table(properties: Iterable[Property]) -> str:
    lines = ["| write | it means | allowed | `set` | in Python |", "|---|---|---|---|---|"]
    for each in properties:
        allowed = str(each.range) if each.takes not in _WITHOUT_RANGE else ""
        if each.choices is not None:
            allowed = ", ".join(f"`{word}`" for word in each.choices)
        changes = "yes" if each.settable else ""
        lines.append(f"| `{example_of(each)}` | {each.doc} | {allowed} | {changes} | `{each.option}` |")
    return "\n".join(lines) + "\n"


_WITHOUT_RANGE = {"flag", "switch", "choice", "colour", "colours", "picture", "font", "tag", "name", "names"}


def main(arguments: list[str]) -> int:
    """Write the page to the file that is named, or print it."""
    if arguments:
        Path(arguments[0]).write_text(reference(), encoding="utf-8")
    else:
        print(reference(), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
