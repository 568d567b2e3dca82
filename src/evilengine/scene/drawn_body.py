"""DrawnBody: a body that knows how it is drawn (SPEC A5)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary, ref

from evilengine.values.errors import ArgumentError
from evilengine.world.body import Body, Shape

if TYPE_CHECKING:
    from evilengine.scene.drawing import Drawing
    from evilengine.scene.scene import Scene
    from evilengine.world.shapes import ShapeDefinition
    from evilengine.world.world import World

LOOKS = frozenset(
    (
        *(
            "animation",
            "behind",
            "blend",
            "colour",
            "colours",
            "depth",
            "flip_x",
            "flip_y",
            "glow",
            "glow_map",
            "layer",
        ),
        *("lit", "normal_map", "outline", "slice", "texture", "texture_matrix", "texture_points", "tile", "visible"),
    )
)
"""The words of `scene.add` that say how a thing looks; its others say where it is."""


class DrawnBody(Body):
    """A Body with a list of drawings. The bodies of a game are these.

    >>> from evilengine.scene import Scene
    >>> world = evil.World(); world._body_type = DrawnBody; scene = Scene(world)
    >>> crate = world.add(evil.Rectangle(1, 1))
    >>> crate.draw(colour="orange").colour.hex
    '#ffa500'
    >>> crate.drawings[0].visible = False
    """

    def __init__(self, world: World, slot: int, generation: int) -> None:
        super().__init__(world, slot, generation)
        self._drawings: list[Drawing] = []
        self._restored = -1  # which restore of its scene the drawings have been taken over from

    @property
    def drawings(self) -> list[Drawing]:
        """The drawings on this body, in the order they were made: a new list each time."""
        self._require()
        self._drawings = [drawing for drawing in self._all_drawings() if drawing.alive]
        return list(self._drawings)

    def _all_drawings(self) -> list[Drawing]:
        """The list itself; after a restore of the scene, with what that brought."""
        known = _scenes.get(self.world)
        scene = known() if known is not None else None
        if scene is not None and self._restored != scene._restores:
            self._restored = scene._restores
            self._drawings = scene._take_restored(self)
        return self._drawings

    def draw(self, shape: ShapeDefinition | Shape | None = None, **looks: Any) -> Drawing:
        """Draw one thing more on this body: `shape`, or one of its own shapes. Left out: all its own; gives the last.

        Takes what `scene.add` takes: `at`, `angle` or `matrix` place it on the body, and LOOKS say how it looks.
        """
        self._require()
        scene = scene_of(self.world)
        if shape is not None:
            return scene.add(shape, body=self, **looks)
        made: list[Drawing] = []
        try:
            made.extend(scene.add(own, **looks) for own in self.shapes)
        except BaseException:
            for drawing in made:
                drawing.destroy()
            raise
        if not made:
            raise ArgumentError(f"DrawnBody.draw: {self!r} has no shape of its own; say which shape to draw on it")
        return made[-1]

    def add_shape(self, shape: ShapeDefinition, **options: Any) -> Shape:
        """Add one more shape, as `Body.add_shape` does; on a body that is drawn it looks like the first drawing."""
        added = super().add_shape(shape, **options)
        like = next((drawing for drawing in self._all_drawings() if drawing.alive), None)
        if like is not None:
            scene_of(self.world).add(
                added, colour=like.colour, outline=like.outline, layer=like.layer, visible=like.visible, lit=like.lit
            )
        return added


_scenes: WeakKeyDictionary[World, ref[Scene]] = WeakKeyDictionary()


def show(world: World, scene: Scene) -> None:
    """From now on `scene` is where the bodies of `world` are drawn."""
    _scenes[world] = ref(scene)


def scene_of(world: World) -> Scene:
    """The scene that shows `world`. Raises ArgumentError if there is none."""
    known = _scenes.get(world)
    scene = known() if known is not None else None
    if scene is None:
        raise ArgumentError("DrawnBody: no Scene shows this body's world; make one with Scene(world) and keep it")
    return scene
