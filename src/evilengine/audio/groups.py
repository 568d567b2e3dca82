"""Groups: sounds whose volume is set together."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from evilengine import _core
from evilengine.values.checks import did_you_mean, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.tick import STEP

MASTER = "master"
BUILT_IN = (MASTER, "effects", "music", "interface")
LOUDEST = 8.0  # +18 dB
MOST_GROUPS = 16
RAMP = 800  # frames that a change of volume takes: one step, no zipper to be heard


class Group:
    """Sounds with a common volume and pause, such as all effects or the music.

    "interface" plays on while the game is paused; the others stand still then, unless `pauses` says otherwise.
    """

    def __init__(self, name: str, index: int, *, pauses: bool, tell: Callable[[Group], None]) -> None:
        self.name = name
        self.pauses = pauses
        self._index = index
        self._tell = tell
        self._volume = 1.0
        self._paused = False
        self._told_paused = False
        self._stood_still = 0  # steps
        self._paused_at = 0

    def __repr__(self) -> str:
        return f"<Group {self.name!r}, volume {self._volume:g}{', paused' if self._paused else ''}>"

    @property
    def volume(self) -> float:
        """1 is as recorded, 0 silent, at most 8."""
        return self._volume

    @volume.setter
    def volume(self, value: float) -> None:
        self._volume = number(value, f"group {self.name!r}", "volume", least=0.0, most=LOUDEST)
        self._tell(self)

    @property
    def paused(self) -> bool:
        """Its sounds stand still, and go on from there."""
        return self._paused

    @paused.setter
    def paused(self, on: bool) -> None:
        self._paused = bool(on)
        self._tell(self)

    def _note_pause(self, step: int) -> None:
        """Keep the group's own time: `step` is the game's."""
        if self._paused and not self._told_paused:
            self._paused_at = step
        elif self._told_paused and not self._paused:
            self._stood_still += step - self._paused_at
        self._told_paused = self._paused

    def _seconds(self, step: int) -> float:
        """How long its sounds have been playing, in seconds of the game."""
        return ((self._paused_at if self._told_paused else step) - self._stood_still) * STEP

    def _send(self, mixer: _core.Mixer, *, frozen: bool, when: int, ramp: int = RAMP) -> None:
        mixer.group_gain(self._index, self._volume, ramp, when)
        mixer.group_pause(self._index, frozen, when)


class Groups(Mapping[str, Group]):
    """The groups by name: "master", which all go through, "effects", "music", "interface", and those that are added."""

    def __init__(self, tell: Callable[[Group], None]) -> None:
        self._tell = tell
        self._groups: dict[str, Group] = {}
        for name in BUILT_IN:
            self.add(name, pauses=name in ("effects", "music"))

    def add(self, name: str, *, pauses: bool = True) -> Group:
        """Make a group. `pauses`: it stands still while the game is paused. At most 16 with those there are."""
        if not isinstance(name, str) or not name:
            raise ArgumentTypeError(f"audio.groups.add: name={name!r} must be a word")
        if name in self._groups:
            raise ArgumentError(f"audio.groups.add: there is a group {name!r} already")
        if len(self._groups) >= MOST_GROUPS:
            raise ArgumentError(f"audio.groups.add: there are {MOST_GROUPS} groups already, which is the most")
        group = self._groups[name] = Group(name, len(self._groups), pauses=pauses, tell=self._tell)
        return group

    def __getitem__(self, name: str) -> Group:
        try:
            return self._groups[name]
        except (KeyError, TypeError):
            raise ArgumentError(
                f"audio.groups: there is no group {name!r}{did_you_mean(name, self._groups)}; "
                f"there are {', '.join(self._groups)}, and audio.groups.add() makes more"
            ) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._groups)

    def __len__(self) -> int:
        return len(self._groups)

    def __contains__(self, name: object) -> bool:
        return name in self._groups
