"""What a level script turns into: commands for a game to carry out.

Commands speak the engine's own units and words (metres, radians, `restitution=`), so that carrying one out is a call.
A number in them is a float, or a name or formula whose value is known only while the level plays.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from evilengine.values.diagnostics import Diagnostic
from evilengine.values.level_fluids import AddLiquid as AddLiquid
from evilengine.values.level_fluids import AddSmoke as AddSmoke
from evilengine.values.level_fluids import AddSource as AddSource
from evilengine.values.level_fluids import AddStream as AddStream
from evilengine.values.level_fluids import AddWater as AddWater
from evilengine.values.level_fluids import FillWater as FillWater
from evilengine.values.level_fluids import Fluid as Fluid
from evilengine.values.level_looks import AddLight as AddLight
from evilengine.values.level_looks import AddParticles as AddParticles
from evilengine.values.level_looks import Picture as Picture
from evilengine.values.level_looks import SetAmbient as SetAmbient
from evilengine.values.level_looks import SetBackground as SetBackground
from evilengine.values.level_looks import SetCamera as SetCamera
from evilengine.values.level_looks import SetLens as SetLens
from evilengine.values.level_looks import SetPlane as SetPlane
from evilengine.values.level_looks import SetShadows as SetShadows
from evilengine.values.level_values import (
    FARTHEST_LIMIT as FARTHEST_LIMIT,
)
from evilengine.values.level_values import (
    Area as Area,
)
from evilengine.values.level_values import (
    Called as Called,
)
from evilengine.values.level_values import (
    Colours as Colours,
)
from evilengine.values.level_values import (
    Corners as Corners,
)
from evilengine.values.level_values import (
    Formula as Formula,
)
from evilengine.values.level_values import (
    Holes as Holes,
)
from evilengine.values.level_values import (
    Make as Make,
)
from evilengine.values.level_values import (
    Name as Name,
)
from evilengine.values.level_values import (
    Number as Number,
)
from evilengine.values.level_values import (
    Numbers as Numbers,
)
from evilengine.values.level_values import (
    Option as Option,
)
from evilengine.values.level_values import (
    Pair as Pair,
)
from evilengine.values.level_values import (
    Place as Place,
)
from evilengine.values.level_values import (
    Tagged as Tagged,
)
from evilengine.values.level_values import (
    Target as Target,
)
from evilengine.values.level_values import (
    Value as Value,
)

# Commands ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class SetGravity:
    place: Place
    gravity: Pair


@dataclass(frozen=True, slots=True)
class SetView:
    """The camera shows an area of this size round the origin, in metres."""

    place: Place
    width: float
    height: float


@dataclass(frozen=True, slots=True)
class SetTilt:
    place: Place
    on: bool


@dataclass(frozen=True, slots=True)
class SetSeed:
    place: Place
    seed: int


@dataclass(frozen=True, slots=True)
class AddBody:
    """A body made of `shapes`; `options` go to `game.add`."""

    place: Place
    name: str
    shapes: tuple[Make, ...]
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddCharacter:
    """A character of that shape; `options` go to `game.add_character`. Its name stands for its body."""

    place: Place
    name: str
    shape: Make
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddLadder:
    """An area where the characters of `bodies` climb; of none of them, all that there are."""

    place: Place
    area: Area
    bodies: tuple[Called, ...] = ()


@dataclass(frozen=True, slots=True)
class Drive:
    """Lets the player's keys steer the character of `target` (None: nobody); `keys` are those that are not usual."""

    place: Place
    target: Called | None
    keys: tuple[tuple[str, tuple[str, ...]], ...] = ()


@dataclass(frozen=True, slots=True)
class Tell:
    """Calls `what` of the character of `target`, such as "jump", with `value` if there is one."""

    place: Place
    target: Called
    what: str
    value: Number | None = None


@dataclass(frozen=True, slots=True)
class AddDrawing:
    """A shape that is seen and nothing else; `options` go to `game.draw`."""

    place: Place
    name: str
    shape: Make
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class AddForce:
    """A force on `bodies`; on none of them, on the whole world."""

    place: Place
    name: str
    force: Make
    bodies: tuple[Called, ...] = ()


@dataclass(frozen=True, slots=True)
class AddJoint:
    """A joint between the two bodies that its first arguments call."""

    place: Place
    name: str
    joint: Make


@dataclass(frozen=True, slots=True)
class AddText:
    """A line of text at a point of the screen; `pieces` alternate between fixed text and numbers."""

    place: Place
    name: str
    pieces: tuple[str | Number, ...]
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class PlaySound:
    """Plays a sound file; nothing, when what it is heard from is gone."""

    place: Place
    file: str
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class PlayMusic:
    """Plays music, or none ("")."""

    place: Place
    file: str
    options: tuple[Option, ...]


@dataclass(frozen=True, slots=True)
class Go:
    """Begins another level; this one again (""), when the step is over."""

    place: Place
    file: str


@dataclass(frozen=True, slots=True)
class SetPace:
    """How fast time goes: below 1 is slow motion."""

    place: Place
    pace: Number


@dataclass(frozen=True, slots=True)
class Follow:
    place: Place
    target: Called


@dataclass(frozen=True, slots=True)
class Split:
    """A view for each of these."""

    place: Place
    targets: tuple[Called, ...]


@dataclass(frozen=True, slots=True)
class Quake:
    place: Place
    strength: Number


@dataclass(frozen=True, slots=True)
class Let:
    """Makes a number that the level can change."""

    place: Place
    name: str
    value: Number


@dataclass(frozen=True, slots=True)
class SetNumber:
    place: Place
    name: str
    value: Number


@dataclass(frozen=True, slots=True)
class SetProperty:
    """Changes `property` of what is called `target`, or of a part of it; nothing, when that is gone."""

    place: Place
    target: Called
    property: str
    value: Value
    part: str = ""
    """"drawings", "character", or "" for the thing itself."""


@dataclass(frozen=True, slots=True)
class Destroy:
    """Destroys what is called `target`; nothing, when that is gone."""

    place: Place
    target: Called


@dataclass(frozen=True, slots=True)
class Impulse:
    place: Place
    target: Called
    impulse: Pair


@dataclass(frozen=True, slots=True)
class OnMeeting:
    """When `event` ("on_collide", "on_separate", "on_enter", "on_leave") is of `first` with `second` (None: any)."""

    place: Place
    event: str
    first: Target
    second: Target | None
    block: Block


@dataclass(frozen=True, slots=True)
class OnTouch:
    """When a finger presses `first` (None: anything, or nothing)."""

    place: Place
    first: Target | None
    block: Block


@dataclass(frozen=True, slots=True)
class OnCharacter:
    """When `event` ("on_land", "on_jump", "on_crush") comes to a character."""

    place: Place
    event: str
    first: Target
    block: Block


@dataclass(frozen=True, slots=True)
class OnKey:
    place: Place
    key: str
    block: Block


@dataclass(frozen=True, slots=True)
class OnShake:
    place: Place
    block: Block


@dataclass(frozen=True, slots=True)
class After:
    place: Place
    seconds: Number
    block: Block


@dataclass(frozen=True, slots=True)
class Every:
    """A round each `seconds`, `times` rounds (None: without end); `counter` is 1 in the first."""

    place: Place
    seconds: Number
    times: Number | None
    counter: str
    block: Block


@dataclass(frozen=True, slots=True)
class Repeat:
    place: Place
    times: Number
    counter: str
    block: Block


@dataclass(frozen=True, slots=True)
class If:
    place: Place
    condition: Number
    then: Block
    otherwise: Block


Rule: TypeAlias = OnMeeting | OnTouch | OnCharacter | OnKey | OnShake
"""What waits for an event, for good."""
Waiting: TypeAlias = Rule | After | Every
"""What has a block that is carried out later."""
Command: TypeAlias = (
    SetGravity
    | SetView
    | SetTilt
    | Picture
    | SetSeed
    | AddBody
    | AddCharacter
    | AddLadder
    | Fluid
    | Drive
    | Tell
    | AddDrawing
    | AddForce
    | AddJoint
    | AddText
    | PlaySound
    | PlayMusic
    | Go
    | SetPace
    | Follow
    | Split
    | Quake
    | Let
    | SetNumber
    | SetProperty
    | Destroy
    | Impulse
    | Waiting
    | Repeat
    | If
)
Block: TypeAlias = tuple[Command, ...]


@dataclass(frozen=True, slots=True)
class LevelScript:
    """A level without errors, ready to be carried out. `folder` is where its pictures are found ("" for none)."""

    file: str
    folder: str
    commands: Block
    version: int = 1
    lines: tuple[str, ...] = ()
    """The source, for showing where something went wrong while the level plays."""

    @property
    def text(self) -> str:
        """The source, from which the same commands are read again."""
        return "\n".join(self.lines)

    @property
    def numbered(self) -> tuple[Command, ...]:
        """Every command, those in blocks too, in the order in which they are written."""
        return tuple(_walk(self.commands))

    def diagnostic(self, code: str, message: str, place: Place, suggestion: str = "") -> Diagnostic:
        """A diagnostic at `place` of this level."""
        source = self.lines[place.line - 1] if 0 < place.line <= len(self.lines) else ""
        return Diagnostic(code, message, self.file, place.line, place.column, place.length, suggestion, source)


def _walk(block: Block) -> Iterator[Command]:
    for command in block:
        yield command
        for inner in ("block", "then", "otherwise"):
            yield from _walk(getattr(command, inner, ()))
