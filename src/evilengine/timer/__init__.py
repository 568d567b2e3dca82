"""Time inside the engine: the clock that turns wall time into fixed steps, and events planned for later."""

from evilengine.timer.clock import Clock
from evilengine.timer.schedule import Event, Schedule

__all__ = ["Clock", "Event", "Schedule"]
