"""What a drawing does with a picture of many frames: plays, stops, turns round."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from evilengine.values.checks import known_keywords, number, one_of, switch
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.sheet import COURSES, Animation, Sheet, rate
from evilengine.values.tick import STEP

if TYPE_CHECKING:
    from evilengine.scene.scene import Scene

BLENDS = ("normal", "add", "multiply", "screen")
"""How a drawing meets what is behind it, by the numbers of draw::Blend: covers it, shines on it, shades it, shines
without ever burning out."""

LONGEST_AGE = 1e6  # seconds


class Clip(NamedTuple):
    """Frames of a sheet as a drawing shows them; a single one stands still."""

    sheet: Sheet
    name: str | None
    frames: tuple[int, ...]
    fps: float
    course: str


def clip_of(sheet: Sheet, name: str | None, owner: str, fps: float | None = None, course: str | None = None) -> Clip:
    """An animation of a sheet, faster or otherwise than it says if asked for."""
    animation: Animation = sheet.animation(name, owner)
    own_rate = sheet.fps if animation.fps is None else animation.fps
    return Clip(
        sheet,
        name,
        animation.frames,
        own_rate if fps is None else rate(fps, owner),
        animation.course if course is None else one_of(course, owner, "course", COURSES),
    )


def still(sheet: Sheet, frame: int) -> Clip:
    """One frame of a sheet."""
    return Clip(sheet, None, (frame,), sheet.fps, "loop")


class Animated:
    """The part of a drawing that knows sheets."""

    __slots__ = ()
    _scene: Scene

    def _at(self) -> tuple[int, int]:
        """Slot and generation, or the error that says that it is gone."""
        raise AssertionError("a drawing says where it is")

    @known_keywords
    def play(
        self,
        animation: str | None = None,
        *,
        fps: float | None = None,
        course: str | None = None,
        start: float = 0.0,
        restart: bool = False,
    ) -> None:
        """Show an animation of its sheet, by name; without one, all frames of the sheet in a row.

        `fps` and `course` ("loop", "once", "back") take the place of the animation's own, and `start` seconds of it are
        left out. One that is shown already goes on, so this can be said in every step; `restart=True` begins it anew.
        It goes with the steps of the world: slow motion slows it, and a pause stops it.

        Raises ArgumentError if its texture is no Sheet, or the sheet has no such animation.
        """
        owner, (slot, generation) = "Drawing.play", self._at()
        clip = clip_of(self._sheet(owner), animation, owner, fps, course)
        skipped = number(start, owner, "start", least=0.0, most=LONGEST_AGE)
        wanted, core, world = self._scene._clip_number(clip), self._scene._core, self._scene.world
        now = core.playing(world._core, slot, generation)
        if now is None or now[0] != wanted or restart:
            core.play(slot, generation, wanted, world.steps - round(skipped / STEP))

    def stop(self) -> None:
        """Stand still at the frame that is shown now."""
        self.frame = self.frame

    @property
    def frame(self) -> int:
        """The number of the frame that is shown after the last step; set it to show another, which stands still."""
        clip, index, _ = self._shown("Drawing.frame")
        return clip.frames[index]

    @frame.setter
    def frame(self, value: int) -> None:
        slot, generation = self._at()
        sheet = self._sheet("Drawing.frame")
        if isinstance(value, bool) or not isinstance(value, int):
            raise ArgumentTypeError(f"Drawing: frame={value!r} must be a whole number")
        if not 0 <= value < len(sheet):
            raise ArgumentError(f"Drawing: frame={value!r} must be 0 to {len(sheet) - 1}: {sheet!r}")
        self._scene._core.play(slot, generation, self._scene._clip_number(still(sheet, value)), 0)

    @property
    def animation(self) -> str | None:
        """The name of the animation that is shown, also when it is over; None for one without a name, or none."""
        slot, generation = self._at()
        clip = self._scene._clip_shown(slot, generation)
        return None if clip is None else clip.name

    @property
    def playing(self) -> bool:
        """Does its picture change? False for a single frame, and once an animation that is shown once is over."""
        slot, generation = self._at()
        now = self._scene._core.playing(self._scene.world._core, slot, generation)
        return now is not None and len(self._scene._clips[now[0]].frames) > 1 and not now[3]

    @property
    def flip_x(self) -> bool:
        """Is its picture mirrored, left for right?"""
        return self._scene._core.flip_x(*self._at())

    @flip_x.setter
    def flip_x(self, value: bool) -> None:
        self._scene._core.set_flip_x(*self._at(), switch(value, "Drawing", "flip_x"))

    @property
    def flip_y(self) -> bool:
        """Is its picture mirrored, top for bottom?"""
        return self._scene._core.flip_y(*self._at())

    @flip_y.setter
    def flip_y(self, value: bool) -> None:
        self._scene._core.set_flip_y(*self._at(), switch(value, "Drawing", "flip_y"))

    @property
    def blend(self) -> str:
        """How it meets what is behind it: "normal" covers, "add" shines on it, "multiply" shades it, "screen" shines
        and never burns out."""
        return BLENDS[self._scene._core.blend(*self._at())]

    @blend.setter
    def blend(self, value: str) -> None:
        blend = BLENDS.index(one_of(value, "Drawing", "blend", BLENDS))
        self._scene._core.set_blend(*self._at(), blend)

    def _sheet(self, owner: str) -> Sheet:
        return self._shown(owner)[0].sheet

    def _shown(self, owner: str) -> tuple[Clip, int, bool]:
        """The clip, which frame of it is shown, and whether it is over."""
        slot, generation = self._at()
        now = self._scene._core.playing(self._scene.world._core, slot, generation)
        if now is None:
            raise ArgumentError(f"{owner}: {self!r} has no frames; give it texture=evil.Sheet(...)")
        return self._scene._clips[now[0]], now[2], now[3]
