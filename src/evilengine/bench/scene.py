"""What a scene is: a function that fills a world through its public face, and the sizes it is wanted in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from evilengine.values.checks import one_of
from evilengine.world.world import World

Act = Callable[[World, int], None]
"""What happens in a scene before each step, given the world and the number of the step: things come, go or turn."""

Fill = Callable[[World, int], Act | None]

STEP = 1.0 / 60.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """A scene: who fills the world, how large it is for whom, and where to look at it from."""

    name: str
    about: str
    fill: Fill
    size: int
    """How large benchmarks make it: the same as in Box2D's own, where it has one."""
    show: int
    """How large the testbed makes it."""
    small: int
    """How large tests make it."""
    gravity: tuple[float, float]
    warm: int
    """Steps until it is worth timing."""
    steps: int
    """Steps that benchmarks time."""
    centre: tuple[float, float]
    height: float
    """What a camera should see: metres, at the testbed's size."""


@dataclass(slots=True)
class Staged:
    """A world in which a scene plays."""

    world: World
    act: Act | None

    def step(self, substeps: int = 4) -> None:
        self.prepare()
        self.world.step(STEP, substeps)

    def prepare(self) -> None:
        """What the scene itself does before a step."""
        if self.act is not None:
            self.act(self.world, self.world.steps)


SCENES: dict[str, Scene] = {}
"""By name, in the order in which the testbed lists them."""


def scene(
    *,
    size: int,
    show: int,
    small: int,
    centre: tuple[float, float],
    height: float,
    warm: int = 0,
    steps: int = 100,
    gravity: tuple[float, float] = (0.0, -10.0),
) -> Callable[[Fill], Fill]:
    """Decorator: the function below is a scene of this name; the first line of its docstring says what it shows."""

    def enter(fill: Fill) -> Fill:
        name = fill.__name__
        about = (fill.__doc__ or "").strip().splitlines()[0].rstrip(".")
        SCENES[name] = Scene(
            name=name, about=about, fill=fill, size=size, show=show, small=small, gravity=gravity, warm=warm,
            steps=steps, centre=centre, height=height,
        )  # fmt: skip
        return fill

    return enter


def find(name: str) -> Scene:
    """The scene of that name, or an error with the nearest one."""
    return SCENES[one_of(name, "bench", "scene", SCENES)]


def stage(scene: Scene, size: int, *, threads: int = 1, sleep: bool = False) -> Staged:
    """A new world with the scene in it.

    >>> staged = stage(find("pyramid"), 4)
    >>> staged.step(); len(staged.world.bodies)
    11
    """
    world = World(scene.gravity, threads=threads, sleep=sleep)
    return Staged(world, scene.fill(world, size))
