"""Views: the parts of the window that show the world, each by a camera of its own (split screen, maps, mirrors)."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from evilengine.scene.camera import Camera
from evilengine.scene.saving import camera_state, read_camera
from evilengine.values.checks import did_you_mean, known_keywords, number
from evilengine.values.drawlist import DrawList, Inset
from evilengine.values.errors import ArgumentError, ArgumentTypeError, StaleReferenceError
from evilengine.values.vec2 import Point, Vec2, to_vec2

if TYPE_CHECKING:
    from evilengine.scene.camera_work import Area, Followed
    from evilengine.scene.scene import Scene

WHOLE: Area = (0.0, 0.0, 1.0, 1.0)

AREAS: dict[str, Area] = {
    "all": WHOLE,
    "left": (0.0, 0.0, 0.5, 1.0),
    "right": (0.5, 0.0, 1.0, 1.0),
    "top": (0.0, 0.5, 1.0, 1.0),
    "bottom": (0.0, 0.0, 1.0, 0.5),
    "top left": (0.0, 0.5, 0.5, 1.0),
    "top right": (0.5, 0.5, 1.0, 1.0),
    "bottom left": (0.0, 0.0, 0.5, 0.5),
    "bottom right": (0.5, 0.0, 1.0, 0.5),
}
"""Areas that have names, as shares of the window: left, bottom, right, top."""

SHARES: dict[tuple[int, bool], tuple[str, ...]] = {
    (1, False): ("all",),
    (1, True): ("all",),
    (2, False): ("left", "right"),
    (2, True): ("top", "bottom"),
    **{(3, stacked): ("top left", "top right", "bottom") for stacked in (False, True)},
    **{(4, stacked): ("top left", "top right", "bottom left", "bottom right") for stacked in (False, True)},
}
"""How a window is shared out, by how many share it and whether two lie one over the other."""

MOST = 32
"""Views of one window: each is a picture of its own."""

GAP = 0xFF000000
"""What no view covers is black."""


class View:
    """A part of the window, and the camera that shows the world there: `game.add_view` makes one.

    >>> game = evil.Game(headless=True)
    >>> map_of_it = game.add_view((0.75, 0.7, 0.98, 0.96), view_height=40)
    >>> map_of_it.camera.size, game.views[0].camera is game.camera
    ((221.0, 140.0), True)
    """

    __slots__ = ("_area", "_views", "camera", "hears", "visible")

    def __init__(self, views: Views, camera: Camera, area: Area) -> None:
        self._views: Views | None = views
        self.camera = camera
        """What it shows."""
        self.visible = True
        """Is it seen? One that is not gets no touches either."""
        self.hears = False
        """Are sounds heard where it looks? Where several do, each sound is heard from the nearest. The first does, and
        those of a split screen."""
        self._area = area
        self._lay()

    @property
    def area(self) -> Area:
        """Which part of the window it covers: left, bottom, right, top, as shares of its width and height (0..1).

        It may be set to a word too: "all", "left", "right", "top", "bottom", "top left", "bottom right", ...
        """
        return self._area

    @area.setter
    def area(self, value: str | Iterable[float]) -> None:
        self._area = to_area(value, "View")
        self._lay()

    @property
    def alive(self) -> bool:
        """False once it was destroyed, or the game has become one without it."""
        return self._views is not None

    def destroy(self) -> None:
        """Take it away. The first view is the game's own; it may be made not `visible`."""
        if self._views is None:
            raise StaleReferenceError("this View was destroyed; ask view.alive first")
        if self._views[0] is self:
            raise ArgumentError("View.destroy: the first view is the game's own; set visible=False to hide it")
        self._views._rows.remove(self)
        self._views = None

    def box(self, size: tuple[float, float]) -> tuple[int, int, int, int]:
        """Left, top, width and height of its part of a picture of that size, in whole pixels."""
        left, bottom, right, top = self._area
        x, y = round(left * size[0]), round((1.0 - top) * size[1])
        return x, y, max(round(right * size[0]) - x, 1), max(round((1.0 - bottom) * size[1]) - y, 1)

    def _covers(self, pixel: Vec2) -> bool:
        (x, y), (width, height) = self.camera.corner, self.camera.size
        return self.visible and x <= pixel.x < x + width and y <= pixel.y < y + height

    def _lay(self) -> None:
        """Tell the camera where it is, and how large, in points."""
        if self._views is not None:
            left, top, width, height = self.box(self._views.size)
            self.camera.corner, self.camera.size = (left, top), (width, height)

    def __repr__(self) -> str:
        word = next((word for word, area in AREAS.items() if area == self._area), None)
        return f"<View {word or self._area}{'' if self.alive else ', destroyed'}>"


@dataclass(frozen=True, slots=True)
class Note:
    """How a view is, to be so again."""

    view: View
    area: Area
    visible: bool
    hears: bool
    look: tuple[Vec2, float, float]
    fit: tuple[float, float] | None
    bounds: Area | None


class Views:
    """The views of a window, from the first to the one on top; the first is that of the game's own camera."""

    def __init__(self, camera: Camera, size: tuple[float, float]) -> None:
        self._size = size
        self._rows: list[View] = []
        self._rows.append(View(self, camera, WHOLE))
        self._rows[0].hears = True

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, index: int) -> View:
        return self._rows[index]

    def __iter__(self) -> Iterator[View]:
        return iter(tuple(self._rows))

    def __repr__(self) -> str:
        return f"<Views {list(self._rows)!r}>"

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the window in logical points; the game keeps it up to date."""
        return self._size

    @size.setter
    def size(self, value: tuple[float, float]) -> None:
        self._size = value
        for view in self._rows:
            view._lay()

    def add(
        self, area: str | Iterable[float], follow: Followed | None, view_height: float | None, options: dict[str, Any]
    ) -> View:
        """One more view, over those that there are; see Game.add_view."""
        owner = "Game.add_view"
        place = to_area(area, owner)
        if len(self) >= MOST:
            raise ArgumentError(f"{owner}: there are {MOST} views already, as many as a window may have")
        first = self._rows[0].camera
        look: dict[str, Any] = {"position": first.position, "angle": first.angle, "zoom": first.zoom}
        camera = Camera(view_height=view_height, **(look | options))
        if view_height is None:
            camera._fit = first._fit
        if follow is not None:
            camera.follow(follow)  # raises for what cannot be followed, before there is a view
        view = View(self, camera, place)
        if follow is not None:
            camera.follow(follow, jump=True)
        self._rows.append(view)
        return view

    def share(self, targets: tuple[Followed, ...], stacked: bool) -> tuple[View, ...]:
        """A view for each of these, side by side; see Game.split."""
        owner = "Game.split"
        if (len(targets), stacked) not in SHARES:
            raise ArgumentError(f"{owner}: it takes one to four things to follow, not {len(targets)}")
        for target in targets:
            Camera().follow(target)  # raises for what cannot be followed, before anything has changed
        areas = SHARES[len(targets), stacked]
        for view in self._rows[1:]:
            view.destroy()
        self._rows[0].area, self._rows[0].visible = areas[0], True
        self._rows[0].camera.follow(targets[0], jump=True)
        for target, area in zip(targets[1:], areas[1:], strict=True):
            self.add(area, target, None, {}).hears = True
        return tuple(self._rows)

    @known_keywords
    def at(self, pixel: Point) -> View:
        """The view that `pixel` (logical points of the window) is in: the topmost, or the first where there is none."""
        point = to_vec2(pixel, "Views.at", "pixel")
        return next((view for view in reversed(self._rows) if view._covers(point)), self._rows[0])

    def to_world(self, pixel: Vec2, began: Vec2 | None = None) -> Vec2:
        """Where in the world a point of the window is. A finger stays in the view in which it `began`."""
        return self.at(pixel if began is None else began).camera.to_world(pixel)

    def step(self) -> None:
        """The cameras move by one step of the world, after it; the game does."""
        for view in self._rows:
            view.camera.step()

    # What becomes of them with scenes and saved games ------------------------------------------------------------

    def notes(self) -> tuple[Note, ...]:
        """How they are now, for `become`."""
        cameras = [(view, view.camera) for view in self._rows]
        return tuple(
            Note(view, view.area, view.visible, view.hears, (c.position, c.zoom, c.angle), c._fit, c.bounds)
            for view, c in cameras
        )

    def become(self, notes: tuple[Note, ...]) -> None:
        """Be as they were when that was noted; the cameras follow nobody."""
        self._have([note.view for note in notes])
        for note in notes:
            camera = note.view.camera
            camera._rest()
            (camera.position, camera.zoom, camera.angle), camera._fit, camera._bounds = note.look, note.fit, note.bounds
            note.view.area, note.view.visible, note.view.hears = note.area, note.visible, note.hears

    def state(self) -> list[dict[str, Any]]:
        """What a saved game keeps of them; the size of the window is the device's."""
        return [
            {
                "area": list(view.area),
                "visible": view.visible,
                "hears": view.hears,
                "camera": camera_state(view.camera),
            }
            for view in self._rows
        ]

    def read(self, state: list[dict[str, Any]], bodies: Container[int]) -> Callable[[Callable[[int], Followed]], None]:
        """Read what `state` gave, and return what puts it in place, given who finds bodies by their slots."""
        if not 1 <= len(state) <= MOST:
            raise ValueError("a window has a view, and not too many")
        known = [*self._rows, *(View(self, Camera(), WHOLE) for _ in state[len(self) :])][: len(state)]
        rows = [
            (
                view,
                to_area(row["area"], "view"),
                bool(row["visible"]),
                bool(row.get("hears", view is known[0])),  # saves of 0.1 and before say nothing of it
                read_camera(view.camera, row["camera"], bodies),
            )
            for view, row in zip(known, state, strict=True)
        ]

        def put(body: Callable[[int], Followed]) -> None:
            self._have(known)
            for view, area, visible, hears, camera in rows:
                view.area, view.visible, view.hears = area, visible, hears
                camera(body)

        return put

    def _have(self, views: list[View]) -> None:
        for view in self._rows:
            if view not in views:
                view._views = None
        for view in views:
            view._views = self
        self._rows = list(views)


def to_area(value: Any, owner: str) -> Area:
    """Shares of the window, or a word for them, as left, bottom, right, top."""
    if isinstance(value, str):
        if value not in AREAS:
            words = ", ".join(map(repr, AREAS))
            raise ArgumentError(f"{owner}: area={value!r} must be one of {words}{did_you_mean(value, AREAS)}")
        return AREAS[value]
    try:
        left, bottom, right, top = value
    except (TypeError, ValueError):
        raise ArgumentTypeError(
            f"{owner}: area={value!r} must be left, bottom, right, top as shares of the window, or a word such as "
            "'left'"
        ) from None
    low_x, low_y, high_x, high_y = (
        number(side, owner, "area", least=0.0, most=1.0) for side in (left, bottom, right, top)
    )
    if not (low_x < high_x and low_y < high_y):
        raise ArgumentError(
            f"{owner}: area={value!r} must be left, bottom, right, top: left < right, bottom < top, and y is up"
        )
    return low_x, low_y, high_x, high_y


def collect_views(
    scene: Scene, views: Views, alpha: float, pixel_size: tuple[int, int], scale: float, *, overlay: bool
) -> DrawList:
    """The frame of all views: one picture where there is one view, else a picture each, and what lies over all."""
    shown = [view for view in views if view.visible]
    if len(shown) == 1 and shown[0].area == WHOLE:
        return scene.collect(shown[0].camera, alpha, pixel_size, scale, overlay=overlay)
    scene.lights._begin_frame()
    insets = []
    for number_of_list, view in enumerate(shown, 1):
        left, top, width, height = view.box(pixel_size)
        width, height = min(width, pixel_size[0] - left), min(height, pixel_size[1] - top)
        if width > 0 and height > 0:
            frame = scene.collect_world(view.camera, alpha, (width, height), scale, into=number_of_list)
            insets.append(Inset(left, top, frame))
    return DrawList(pixel_size, GAP, scene.collect_screen(pixel_size, scale, overlay=overlay), tuple(insets))
