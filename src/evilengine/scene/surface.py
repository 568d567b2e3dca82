"""What a drawing's surface does with light: bumps that it shows, and what of it shines by itself (SPEC G3, G5)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from evilengine.values.checks import number

if TYPE_CHECKING:
    from evilengine.scene.scene import Scene

BRIGHTEST_GLOW = 64.0
"""kMostGlow in core/draw/draw_list.hpp."""

AS_SHOWN = -1.0
"""A glow that the picture decides (kGlowAsShown in core/draw/scene.hpp)."""


class Surfaced:
    """The part of a drawing that knows its surface."""

    __slots__ = ()
    _scene: Scene

    def _at(self) -> tuple[int, int]:
        """Slot and generation, or the error that says that it is gone."""
        raise AssertionError("a drawing says where it is")

    @property
    def normal_map(self) -> str | None:
        """The name of an image that says which way each point of it faces, so that lights show bumps; it matters where
        the drawing is `lit`. None: the one beside its texture, such as `rock.normal.png` beside `rock.png`, if there is
        one."""
        normals, _ = self._scene._core.surface(*self._at())
        return self._scene._name_of(normals)

    @normal_map.setter
    def normal_map(self, value: str | None) -> None:
        place, core = self._at(), self._scene._core
        core.set_surface(*place, self._scene.texture_id(value, "Drawing", "normal_map"), core.surface(*place)[1])

    @property
    def glow_map(self) -> str | None:
        """The name of an image of what of it shines by itself, black where nothing does. None: the one beside its
        texture, such as `lamp.glow.png` beside `lamp.png`, if there is one."""
        _, glows = self._scene._core.surface(*self._at())
        return self._scene._name_of(glows)

    @glow_map.setter
    def glow_map(self, value: str | None) -> None:
        place, core = self._at(), self._scene._core
        core.set_surface(*place, core.surface(*place)[0], self._scene.texture_id(value, "Drawing", "glow_map"))

    @property
    def glow(self) -> float | None:
        """How strongly it shines by itself, whatever light falls on it: with a glow map what that shows, without one
        all of it, in its own colours. 0 not at all. None: 1 with a glow map and 0 without."""
        glow = self._scene._core.glow(*self._at())
        return None if glow == AS_SHOWN else glow

    @glow.setter
    def glow(self, value: float | None) -> None:
        place = self._at()
        self._scene._core.set_glow(*place, to_glow(value, "Drawing"))


def to_glow(value: float | None, owner: str) -> float:
    """`value` as the core has it."""
    return AS_SHOWN if value is None else number(value, owner, "glow", least=0.0, most=BRIGHTEST_GLOW)
