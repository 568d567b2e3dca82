"""The words of the camera: where it looks, how closely, how it follows, and where it stops."""

from __future__ import annotations

from evilengine.script.word import PLACE, Of, Property, Range, Statement

CAMERA = "camera"
_HERO = "new circle ball 0.5 at 0 3 physicsOn;\n"

CAMERA_STATEMENTS: tuple[Statement, ...] = (
    Statement(
        word=CAMERA,
        form="camera PROPERTIES;",
        doc="Where the camera looks, how closely, what it follows and where it stops, from now on.",
        example="new circle ball 0.5 at 0 3 physicsOn touchable;\non touch ball { camera at 0 1 zoom 2 over 1.5; }",
        meant=("cam", "zoom", "lookAt"),
    ),
)

_camera = Of((CAMERA,), "camera ")
_extent = Range(least=0.0, most=10_000.0)

# fmt: off
CAMERA_PROPERTIES: tuple[Property, ...] = (
    _camera("at", "point", "What is in the middle of the screen, in metres.", "at 0 2", option="position",
        range=PLACE, meant=("position", "place", "to")),
    _camera("zoom", "number", "How closely it looks: 2 shows everything twice as large.", "zoom 2",
        range=Range(least=0.001, most=1000.0), meant=("scale", "closer")),
    _camera("angle", "angle", "How far it is turned, in degrees against the clock.", "angle 20",
        range=Range(least=-36_000.0, most=36_000.0), meant=("turned", "rotation")),
    _camera("over", "time", "It goes there softly, in so many seconds; at once without it.", "zoom 2 over 1.5",
        option="seconds", range=Range(least=0.02, most=3600.0), meant=("in", "during", "duration", "softly")),
    _camera("follows", "name", "The thing that it keeps in sight.", example=_HERO + "camera follows ball;",
        option="target", meant=("follow", "track", "on")),
    _camera("deadZone", "spot", "How wide and high the part in the middle is in which what it follows moves freely.",
        example=_HERO + "camera follows ball deadZone 4 2;", option="dead_zone", range=_extent, meant=("zone", "free")),
    _camera("smoothing", "time", "How many seconds it takes to come after what it follows, softly.",
        example=_HERO + "camera follows ball smoothing 0.3;", range=Range(least=0.0, most=3600.0),
        meant=("smooth", "lag", "ease")),
    _camera("ahead", "point", "How far from what it follows it looks, as to show more of the way ahead.",
        example=_HERO + "camera follows ball ahead 2 1;", option="offset", range=PLACE, meant=("offset", "lookAhead")),
    _camera("leftBottom", "point", "The lower left corner of what may be seen; nothing beyond is.",
        "leftBottom -20 -5 rightTop 20 10", option="low", range=PLACE, meant=("bounds", "limits", "from")),
    _camera("rightTop", "point", "The upper right corner of what may be seen.", "leftBottom -20 -5 rightTop 20 10",
        option="high", range=PLACE),
)
# fmt: on

NEEDS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("over", ("at", "zoom", "angle")),
    ("deadZone", ("follows",)),
    ("smoothing", ("follows",)),
    ("ahead", ("follows",)),
    ("leftBottom", ("rightTop",)),
    ("rightTop", ("leftBottom",)),
)
"""Words that mean something beside one of these."""
