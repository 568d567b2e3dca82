"""What a world tells of its last step: contacts, what sensors saw, who slept and woke."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from evilengine import _core
from evilengine.values.checks import number
from evilengine.world.contacts import Contacts
from evilengine.world.events import Events
from evilengine.world.sensors import Sensors

if TYPE_CHECKING:
    from evilengine.world.world import World


class Happenings:
    """The events of a world's last step, as lists."""

    _core: _core.World

    @property
    def contacts(self) -> Contacts:
        """What touched in the last step: `.begun`, `.ended`, `.hit`, `.active`."""
        return Contacts(cast("World", self))

    @property
    def sensors(self) -> Sensors:
        """What sensors saw in the last step: `.entered`, `.left`, `.inside`."""
        return Sensors(cast("World", self))

    @property
    def events(self) -> Events:
        """What else happened in the last step: `.slept`, `.woke`, `.broken`."""
        return Events(cast("World", self))

    @property
    def hit_speed(self) -> float:
        """Metres a second: bodies that come together faster are told as hits (`world.contacts.hit`). 1 at first."""
        return self._core.hit_speed

    @hit_speed.setter
    def hit_speed(self, value: float) -> None:
        self._core.hit_speed = number(value, "World", "hit_speed", least=0.0, most=1e6)
