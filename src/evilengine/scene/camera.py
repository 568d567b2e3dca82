"""Camera: which part of the world is seen, and where each point of it is on the screen (SPEC I2)."""

from __future__ import annotations

import math

from evilengine.scene.camera_work import CameraWork
from evilengine.values.checks import known_keywords, make_up, number
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import Point, Vec2, to_vec2

POINTS_A_METRE = 50.0
"""Logical points a metre when nothing else is said: a crate of one metre is as wide as a fingertip needs."""

FARTHEST = 1e7  # metres from the origin: as far as bodies go
LARGEST_ZOOM = 1e6
LARGEST_SCREEN = 100_000  # logical points

Matrix6 = tuple[float, float, float, float, float, float]
"""An affine map a b c d tx ty, columns first: x' = a x + c y + tx, y' = b x + d y + ty."""


class Camera(CameraWork):
    """Looks at `position` (world, metres), enlarged by `zoom` and turned by `angle` (radians, counter-clockwise).

    Screen positions are logical points: x to the right and y down from the top left corner, as fingers and the pointer
    report them. Without more words the camera shows 50 points a metre with the world's origin in the middle.
    `view_height` shows that many metres from bottom to top instead, whatever the screen's size; `fit` shows at least a
    given width and height.

    >>> camera = Camera((960, 540))
    >>> camera.to_world((480, 270)), camera.to_world((530, 270)), camera.to_pixel((0, 1))
    (Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(480.0, 220.0))
    """

    __slots__ = ("_angle", "_fit", "_position", "_size", "_zoom", "corner")

    @known_keywords
    def __init__(
        self,
        size: Point = (960, 540),
        *,
        position: Point = (0.0, 0.0),
        zoom: float = 1.0,
        angle: float = 0.0,
        view_height: float | None = None,
    ) -> None:
        self._rest()
        self._fit: tuple[float, float] | None = None  # metres that must be seen; None: POINTS_A_METRE
        self.corner = (0.0, 0.0)
        """Where in the window the top left corner of what it shows is, in logical points; its view keeps it."""
        self.size = size
        self.position = position
        self.zoom = zoom
        self.angle = angle
        self.view_height = view_height

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of what it fills, the screen or a view, in logical points; the game keeps it up to date."""
        return self._size

    @size.setter
    def size(self, value: Point) -> None:
        width, height = to_vec2(value, "Camera", "size")
        if not (1 <= width <= LARGEST_SCREEN and 1 <= height <= LARGEST_SCREEN):
            raise ArgumentError(f"Camera: size={value!r} must be between 1 and {LARGEST_SCREEN} points each way")
        self._size = (width, height)

    @property
    def position(self) -> Vec2:
        """The point of the world in the middle of the screen; metres, at most 1e7 from the origin each way."""
        return self._position

    @position.setter
    def position(self, value: Point) -> None:
        point = to_vec2(value, "Camera", "position")
        if max(abs(point.x), abs(point.y)) > FARTHEST:
            raise ArgumentError(f"Camera: position={value!r} must be at most {FARTHEST:g} metres from the origin")
        self._position, self._before = point, None  # a jump: nothing lies between

    @property
    def zoom(self) -> float:
        """How much larger things are than without zoom; more than 0. 2 shows half as much each way."""
        return self._zoom

    @zoom.setter
    def zoom(self, value: float) -> None:
        self._zoom = number(value, "Camera", "zoom", least=1.0 / LARGEST_ZOOM, most=LARGEST_ZOOM)
        self._before = None

    @property
    def angle(self) -> float:
        """How far the camera is turned, in radians counter-clockwise; the picture turns the other way."""
        return self._angle

    @angle.setter
    def angle(self, value: float) -> None:
        self._angle = number(value, "Camera", "angle", least=-1e6, most=1e6)
        self._before = None

    @property
    def view_height(self) -> float | None:
        """Metres from the bottom to the top of the screen at zoom 1, or None: 50 logical points a metre."""
        return None if self._fit is None else self._size[1] / self._points_before_zoom()

    @view_height.setter
    def view_height(self, value: float | None) -> None:
        self._fit = None if value is None else (0.0, _metres(value, "Camera", "view_height"))

    @known_keywords
    def fit(self, width: float, height: float) -> None:
        """Show at least `width` x `height` metres at zoom 1, as large as fits the screen, also when that changes.

        >>> camera = Camera((960, 540)); camera.fit(16, 9); camera.points_a_metre
        60.0
        >>> camera.size = (400, 540); camera.points_a_metre
        25.0
        """
        self._fit = (_metres(width, "Camera.fit", "width"), _metres(height, "Camera.fit", "height"))

    @property
    def points_a_metre(self) -> float:
        """Logical points that one metre is long on the screen."""
        return self._points_before_zoom() * self._zoom

    def _points_before_zoom(self) -> float:
        if self._fit is None:
            return POINTS_A_METRE
        width, height = self._fit
        return min(self._size[0] / width if width else math.inf, self._size[1] / height)

    @known_keywords
    def to_pixel(self, point: Point) -> Vec2:
        """Where `point` of the world is on the screen, in logical points; also for points that are not on it."""
        x, y = to_vec2(point, "Camera.to_pixel", "point") - self._position
        c, s = math.cos(self._angle), math.sin(self._angle)
        per_metre = self.points_a_metre
        across, up = c * x + s * y, c * y - s * x
        left, top = self.corner
        return Vec2(left + self._size[0] / 2 + across * per_metre, top + self._size[1] / 2 - up * per_metre)

    @known_keywords
    def to_world(self, pixel: Point) -> Vec2:
        """The point of the world that is at `pixel` (logical points) of the screen; undoes `to_pixel`."""
        x, y = to_vec2(pixel, "Camera.to_world", "pixel") - Vec2(*self.corner)
        per_metre = self.points_a_metre
        across, up = (x - self._size[0] / 2) / per_metre, (self._size[1] / 2 - y) / per_metre
        c, s = math.cos(self._angle), math.sin(self._angle)
        return Vec2(c * across - s * up, s * across + c * up) + self._position

    @known_keywords
    def sees(self, point: Point, *, margin: float = 0.0) -> bool:
        """Is `point` of the world on the screen, or at most `margin` metres beside it?"""
        x, y = self.to_pixel(point) - Vec2(*self.corner)
        slack = number(margin, "Camera.sees", "margin") * self.points_a_metre
        return -slack <= x <= self._size[0] + slack and -slack <= y <= self._size[1] + slack

    def matrix(
        self, pixel_size: tuple[int, int] | None = None, scale: float | None = None, alpha: float = 1.0
    ) -> Matrix6:
        """World to real pixels of a picture of `pixel_size`, where a logical point is `scale` pixels long.

        It is the view at `alpha` (0..1) between the last two steps, shaken if the camera shakes. Without `pixel_size`
        the picture is as large as the screen; without `scale` what the screen shows fits into it.
        """
        width, height = self._size if pixel_size is None else pixel_size
        if scale is None:
            scale = min(width / self._size[0], height / self._size[1])
        (x, y), zoom, angle = self._shown(alpha)
        per_metre = self._points_before_zoom() * zoom * scale
        c, s = math.cos(angle) * per_metre, math.sin(angle) * per_metre
        right, down = (each * scale for each in self._rattle(alpha))
        # Across and up as in to_pixel, then the middle of the picture and y down.
        return (c, s, s, -c, width / 2 - c * x - s * y + right, height / 2 - s * x + c * y + down)

    def __repr__(self) -> str:
        return f"Camera({self._size}, position={tuple(self._position)}, zoom={self._zoom:g}, angle={self._angle:g})"


make_up(Camera, CameraWork)


def _metres(value: object, owner: str, argument: str) -> float:
    return number(value, owner, argument, least=1e-6, most=2 * FARTHEST)
