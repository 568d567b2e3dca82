"""The testbed: every scene of the benchmarks to look at, to take by hand, and to see what it costs."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from evilengine.bench.menu import WIDTH, Menu
from evilengine.bench.scene import SCENES, Scene, find
from evilengine.game import Game
from evilengine.scene import DrawnBody
from evilengine.scene.debug import PARTS
from evilengine.values.events import Event, KeyEvent, PointerEvent, WheelEvent
from evilengine.values.image import Image
from evilengine.world.body import Body

if TYPE_CHECKING:
    from evilengine.platform import Device

SIZE = (1200, 740)
KEYS = (
    ("up, down", "another scene"),
    ("- , +", "smaller, larger"),
    ("R", "start again"),
    ("P, space", "pause"),
    ("full stop", "one step"),
    ("D, F1, 1-9", "debug view, its parts"),
    ("G, F4", "graph of timings"),
    ("S", "let bodies sleep"),
    ("wheel", "zoom"),
    ("Esc", "quit"),
)
ACTIONS = {
    "up": "previous", "down": "next", "minus": "smaller", "equals": "larger", "r": "restart", "p": "pause",
    "space": "pause", "period": "step", "d": "debug", "f1": "debug", "g": "graph", "f4": "graph", "s": "sleep",
    "escape": "quit",
}  # fmt: skip
SWITCHES = {str(number): part for number, part in enumerate(PARTS[:9], start=1)}
"""Which key turns which part of the debug view on and off; there are no fluids here."""
LARGEST = 4.0
"""Times its benchmark's size that a scene may grow to by hand."""
AIR = 1.06
"""How much more than a scene's height the camera shows."""


class Testbed:
    """A game whose scenes are those of the benchmarks, with a menu over it."""

    __test__ = False  # no test of pytest's

    def __init__(
        self,
        first: str = "pyramid",
        *,
        size: tuple[int, int] = SIZE,
        renderer: str = "auto",
        threads: int = 1,
        device: Device | None = None,
    ) -> None:
        chosen = find(first)
        self.game = Game(
            "EvilEngine testbed", size=size, renderer=renderer, sound="none", threads=threads, device=device
        )
        for scene in SCENES.values():
            self.game.scenes(scene.name)(partial(self._begin, scene))
        self.menu = Menu("EvilEngine testbed", list(SCENES))
        self.menu.keys = KEYS
        self.sleep = True
        self.game.scene.panels.append(self.menu.draw)
        self.game.scene.debug_view.legend = False  # the menu counts bodies and contacts
        self.game.frame_graph = True
        self.game._watchers.append(self._hear)
        self.go(chosen.name)

    def go(self, name: str) -> None:
        """Begin a scene, as large as the testbed shows it at first."""
        self._go(name, SCENES[name].show)

    def _go(self, name: str, size: int) -> None:
        self.size, self.menu.chosen, self.menu.caption = size, name, SCENES[name].about
        self.game.go(name, size)

    def frame(self, now: float) -> None:
        """A frame of the game, with what it cost in the menu."""
        world = self.game.world
        self.menu.readings = (
            ("bodies", f"{len(world.bodies):,}"),
            ("contacts", f"{len(world.contacts.active):,}"),
            ("step", f"{self.game.timings.last.steps:.2f} ms"),
            ("time", f"{world.time:.1f} s" + (", paused" if self.game.paused else "")),
        )
        shown = self.game.debug_view.shown if self.game.debug else None
        self.menu.parts = [(part, part in shown) for part in SWITCHES.values()] if shown is not None else ()
        self.game.frame(now)

    def frames(self, count: int, fps: float) -> Iterator[Image]:
        """So many pictures, for a film."""
        for number in range(count):
            self.frame(number / fps)
            yield self.game.capture()

    # -- a scene --

    def _begin(self, scene: Scene, size: int) -> None:
        game = self.game
        game.world.gravity = scene.gravity
        game.world.sleep = self.sleep
        act = scene.fill(game.world, size)
        self._look_at(scene)
        self._painted: set[Body] = set()
        self._paint()
        if act is not None:

            @game.on_update
            def carry_on(dt: float) -> None:
                act(game.world, game.world.steps)
                self._paint()

    def _look_at(self, scene: Scene) -> None:
        """The scene, in the part of the screen that the menu leaves free."""
        camera = self.game.camera
        camera.view_height = AIR * scene.height
        camera.zoom = 1.0
        x, y = scene.centre
        camera.position = (x - 0.5 * WIDTH / camera.points_a_metre, y)

    def _paint(self) -> None:
        """Draw the bodies that are not drawn yet, and let the mouse take hold of those that can move."""
        for body in self.game.world.bodies:
            if body in self._painted or not isinstance(body, DrawnBody):
                continue
            self._painted.add(body)
            body.touchable = body.kind == "dynamic"
            body.draw()

    # -- what the player does --

    def _hear(self, event: Event) -> None:
        match event:
            case PointerEvent():
                self.menu.pointer = event.at
                name = self.menu.name_at(event.at)
                if event.button == "left" and event.down and name is not None:
                    self.go(name)
            case WheelEvent():
                zoom = self.game.camera.zoom * 1.15**event.turn.y
                self.game.camera.zoom = min(max(zoom, 0.2), 20.0)
            case KeyEvent(down=True) if event.key in ACTIONS:
                self._do(ACTIONS[event.key])
            case KeyEvent(down=True) if event.key in SWITCHES:
                self._switch(SWITCHES[event.key])

    def _switch(self, part: str) -> None:
        """Show or hide a part of the debug view; whoever asks for one wants to see it."""
        view = self.game.debug_view
        setattr(view, part, not (self.game.debug and getattr(view, part)))
        self.game.debug = True

    def _do(self, action: str) -> None:
        game = self.game
        match action:
            case "previous" | "next":
                self.go(self.menu.next(-1 if action == "previous" else 1))
            case "smaller" | "larger":
                most = LARGEST * SCENES[self.menu.chosen].size
                size = max(1, round(self.size * (0.8 if action == "smaller" else 1.25)))
                size += (size == self.size) * (1 if action == "larger" else -1)
                self._go(self.menu.chosen, int(min(max(size, 1), most)))
            case "restart":
                game.restart()
            case "pause":
                game.paused = not game.paused
            case "step":
                game.paused = True
                game._when_free(game.step)
            case "debug":
                game.debug = not game.debug
            case "graph":
                game.frame_graph = not game.frame_graph
            case "sleep":
                self.sleep = game.world.sleep = not self.sleep
            case "quit":
                game.quit()


def names() -> list[str]:
    """The scenes that there are, with what they show."""
    return [f"  {scene.name:<15} {scene.about}" for scene in SCENES.values()]
