"""Panel: values on the screen while a game is made, and knobs to turn them: said anew each step, nothing to tidy up."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from evilengine.scene.text import Fonts
from evilengine.scene.typeset import layout
from evilengine.values.checks import known_keywords, number
from evilengine.values.colour import to_colour
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.inputs import Pointer

if TYPE_CHECKING:
    from evilengine._core import Scene as CoreScene

Kind = Literal["value", "graph", "slider", "toggle", "button"]

WIDTH, MARGIN, LETTERS = 250.0, 12.0, 13.0  # logical points, as all lengths here
ROW, GRAPH_ROW, GAP = 20.0, 44.0, 8.0
KNOB = 4.0
REMEMBERED = 120
"""Values of a graph: two seconds of steps."""

FORGOTTEN = 30
"""Frames after which a row that is not said any more is gone; fewer, and rows of a slow game would flicker."""

MOST_ROWS = 200


@dataclass(slots=True)
class _Row:
    kind: Kind
    words: str = ""
    part: float = 0.0
    """How far a slider is out, 0..1; whether a toggle is on."""
    past: list[float] = field(default_factory=list)
    unsaid: int = 0
    """Frames since it was said."""
    top: float | None = None
    """Where it was drawn last, in logical points."""


class Panel:
    """What `game.panel` is: rows of names and values in a corner of the screen, for who makes the game.

    Say a row in `on_update` or `on_draw` for as long as it shall be there; half a second after the last time it is
    gone. Knobs give back what the mouse made of them.

    >>> game = evil.Game(headless=True)
    >>> speed = 4.0
    >>> @game.on_update
    ... def update(dt):
    ...     global speed
    ...     game.panel.show("steps", game.world.steps)
    ...     speed = game.panel.slider("speed", speed, 0, 10)
    ...     if game.panel.button("begin again"):
    ...         game.restart()
    >>> game.step(2); game.panel.rows
    ['steps', 'speed', 'begin again']
    """

    def __init__(self, pointer: Callable[[], Pointer]) -> None:
        self._pointer = pointer
        self._rows: dict[str, _Row] = {}
        self._held: str | None = None
        self.visible = True
        """Is it drawn? What is said is forgotten while it is not, and no knob turns."""
        self.left = False
        """Is it in the left upper corner, rather than the right?"""
        self._begin = 0.0  # x where it was drawn last

    @property
    def rows(self) -> list[str]:
        """The names of its rows, from the top."""
        return list(self._rows)

    @known_keywords
    def show(self, name: str, value: object) -> None:
        """A name and a value; numbers are rounded to what can be read."""
        self._say(name, "value").words = _written(value)

    @known_keywords
    def graph(self, name: str, value: float) -> None:
        """A number, and a graph of what it was the last times that this was said."""
        latest = number(value, "Panel.graph", "value")
        row = self._say(name, "graph")
        row.words = _written(latest)
        row.past = [*row.past[-REMEMBERED + 1 :], latest]

    @known_keywords
    def slider(self, name: str, value: float, low: float, high: float) -> float:
        """A knob that is dragged from `low` to `high`; gives `value`, or what it was dragged to."""
        owner = "Panel.slider"
        low, high = number(low, owner, "low"), number(high, owner, "high")
        if not low < high:
            raise ArgumentError(f"{owner}: low={low!r} must be less than high={high!r}")
        value = min(max(number(value, owner, "value"), low), high)
        row = self._say(name, "slider")
        pointer = self._pointer()
        if self._pressed(row):
            self._held = name
        if self._held == name and "left" not in pointer.buttons:
            self._held = None
        if self._held == name:
            along = (pointer.pixel.x - self._begin - GAP) / (WIDTH - 2 * GAP)
            value = low + (high - low) * min(max(along, 0.0), 1.0)
        row.part, row.words = (value - low) / (high - low), _written(value)
        return value

    @known_keywords
    def toggle(self, name: str, value: bool) -> bool:
        """A switch; gives `value`, or its opposite when it was just pressed."""
        row = self._say(name, "toggle")
        on = bool(value) ^ self._pressed(row)
        row.part, row.words = float(on), "on" if on else "off"
        return on

    @known_keywords
    def button(self, name: str) -> bool:
        """A button; True in the step in which it is pressed."""
        return self._pressed(self._say(name, "button"))

    def clear(self) -> None:
        """Forget every row."""
        self._rows.clear()
        self._held = None

    def _say(self, name: str, kind: Kind) -> _Row:
        if not isinstance(name, str) or not name:
            raise ArgumentTypeError(f"Panel: name={name!r} must be a text")
        row = self._rows.get(name)
        if row is None or row.kind != kind:
            if row is None and len(self._rows) >= MOST_ROWS:
                raise ArgumentError(f"Panel: {name!r} would be one row more than {MOST_ROWS}")
            row = self._rows[name] = _Row(kind)
        row.unsaid = 0
        return row

    def _pressed(self, row: _Row) -> bool:
        pointer = self._pointer()
        if row.top is None or not (self.visible and "left" in pointer.pressed):
            return False
        return 0 <= pointer.pixel.y - row.top < _height(row) and 0 <= pointer.pixel.x - self._begin < WIDTH

    # Drawing ----------------------------------------------------------------------------------------------------------

    def draw(self, core: CoreScene, fonts: Fonts | None, screen: tuple[int, int], scale: float) -> None:
        """Put it on top of the collected frame; `screen` in real pixels, `scale` of them a logical point."""
        self._age()
        if fonts is None or not self._rows or not self.visible:
            return
        self._begin = MARGIN if self.left else screen[0] / scale - MARGIN - WIDTH
        bottom = MARGIN + GAP + sum(_height(row) for row in self._rows.values())
        brush = _Brush(core, fonts, scale)
        brush.box(self._begin, MARGIN, self._begin + WIDTH, bottom + GAP, "#10141fd8")
        top = MARGIN + GAP
        for name, row in self._rows.items():
            row.top = top
            brush.row(self._begin, top, name, row)
            top += _height(row)

    def _age(self) -> None:
        for row in self._rows.values():
            row.unsaid += 1
        self._rows = {name: row for name, row in self._rows.items() if row.unsaid <= FORGOTTEN}


class _Brush:
    """Draws the parts of a panel, in logical points."""

    def __init__(self, core: CoreScene, fonts: Fonts, scale: float) -> None:
        self._core, self._scale = core, scale
        self._texture, self._font = fonts(max(round(LETTERS * scale), 6))

    def box(self, left: float, top: float, right: float, bottom: float, colour: str) -> None:
        x1, y1, x2, y2 = (float(round(edge * self._scale)) for edge in (left, top, right, bottom))
        self._core.box(x1, y1, x2, y2, to_colour(colour, "Panel", "colour").rgba8)

    def words(self, text: str, x: float, top: float, colour: str, across: float = 0.0) -> None:
        boxes, _ = layout(self._font, text, across)
        drop = 0.5 * (ROW * self._scale - self._font.line_height)
        place = round(x * self._scale), round(top * self._scale + drop)
        self._core.glyphs(boxes, *place, self._texture, to_colour(colour, "Panel", "colour").rgba8)

    def row(self, begin: float, top: float, name: str, row: _Row) -> None:
        left, right = begin + GAP, begin + WIDTH - GAP
        if row.kind == "button":
            self.box(left, top + 1, right, top + ROW - 2, "#3b4a6b")
            self.words(name, 0.5 * (left + right), top, "#ffffff", 0.5)
            return
        if row.kind == "slider":
            knob = left + row.part * (right - left)
            self.box(left, top + ROW, right, top + ROW + 2, "#3b4256")
            self.box(left, top + ROW, knob, top + ROW + 2, "#6cc4ff")
            self.box(knob - KNOB / 2, top + ROW - 3, knob + KNOB / 2, top + ROW + 5, "#ffffff")
        elif row.kind == "toggle" and row.part:
            self.box(right - 34, top + 2, right + 2, top + ROW - 3, "#2f6b45")
        elif row.kind == "graph":
            self._graph(left, top + ROW, right, top + GRAPH_ROW - 4, row.past)
        self.words(name, left, top, "#aeb8cc")
        self.words(row.words, right, top, "#ffffff", 1.0)

    def _graph(self, left: float, top: float, right: float, bottom: float, past: Sequence[float]) -> None:
        self.box(left, top, right, bottom, "#00000070")
        low, high = min(past), max(past)
        bar, height = (right - left) / REMEMBERED, bottom - top
        for place, value in enumerate(past, REMEMBERED - len(past)):
            part = (value - low) / (high - low) if high > low else 0.5
            x = left + place * bar
            self.box(x, bottom - max(part * height, 1.0), x + bar, bottom, "#6cc4ff")


def _height(row: _Row) -> float:
    return GRAPH_ROW if row.kind == "graph" else ROW + 8.0 if row.kind == "slider" else ROW


def _written(value: object) -> str:
    """As short as it can be read.

    >>> _written(1 / 3), _written((1.0, -0.00001)), _written(True)
    ('0.3333', '1, -1e-05', 'True')
    """
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, tuple):
        return ", ".join(_written(each) for each in value)
    return str(value)[:60]
