"""Which quality of light a machine has time for: by what it costs, and again when frames turn out otherwise."""

from __future__ import annotations

QUALITIES = ("low", "medium", "high")
"""How light is worked out, the cheapest first."""

LOOKS = 4  # frames before the first choice: what comes before is loading
ROOM = 0.7  # of a frame's time: what is chosen shall fit into so much, so that there is room for a busier moment
FULL = 0.95  # of it: a frame that takes more is slow
LATE = 1.3  # of it: a frame that takes so long, waiting for the screen included, has missed one
WINDOW = 30  # frames that are looked at together
SLOW = 20  # of them: so many slow ones are no accident
PATIENCE = 120  # frames with room before more is tried; twice as many each time that this went wrong
MOST_PATIENCE = 7200
WORTH = 0.1  # of a frame's time: light that costs less than that is not what makes frames slow


class Governor:
    """The quality of light for frames of `budget` milliseconds.

    >>> governor = Governor(16.7)
    >>> governor.choose({"low": 0.5, "medium": 2.0, "high": 9.0}, rest=4.0)
    'medium'
    >>> for _ in range(30):
    ...     quality = governor.note(light=6.0, busy=19.0, whole=19.0)
    >>> quality
    'low'
    """

    def __init__(self, budget: float) -> None:
        self._budget = budget
        self._costs: dict[str, float] = {}
        self._slow: list[bool] = []
        self._with_room = 0
        self._patience = PATIENCE
        self.quality = "medium"
        """What there is time for."""

    @property
    def chosen(self) -> bool:
        """Was anything measured yet?"""
        return bool(self._costs)

    def choose(self, costs: dict[str, float], rest: float) -> str:
        """The best quality whose light fits beside the `rest` of a frame; milliseconds, as measured."""
        self._costs = costs
        fitting = [quality for quality in QUALITIES if rest + costs[quality] <= ROOM * self._budget]
        self.quality = fitting[-1] if fitting else QUALITIES[0]
        return self.quality

    def note(self, light: float, busy: float, whole: float) -> str:
        """A frame whose light took so long, all its work, and it itself with waiting; the quality from now on."""
        self._slow = [*self._slow, busy > FULL * self._budget or whole > LATE * self._budget][-WINDOW:]
        place = QUALITIES.index(self.quality)
        if sum(self._slow) >= SLOW and light > WORTH * self._budget and place > 0:
            self._patience = min(2 * self._patience, MOST_PATIENCE)
            self._go_to(place - 1)
        elif place + 1 < len(QUALITIES):
            better = light * self._costs[QUALITIES[place + 1]] / max(self._costs[self.quality], 1e-3)
            room = not any(self._slow) and busy - light + better <= ROOM * self._budget
            self._with_room = self._with_room + 1 if room else 0
            if self._with_room >= self._patience:
                self._go_to(place + 1)
        return self.quality

    def _go_to(self, place: int) -> None:
        self.quality = QUALITIES[place]
        self._slow, self._with_room = [], 0
