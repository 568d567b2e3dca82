"""EvilEngine: a 2D game engine for Python, with C++ kernels underneath.

>>> import evilengine as evil
>>> world = evil.World()
>>> ball = world.add(evil.Circle(0.5), at=(0, 5))
>>> world.step()
>>> ball.position.y < 5
True
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from evilengine import math
from evilengine.math import Mat4
from evilengine.values.errors import (
    ArgumentError,
    ArgumentTypeError,
    AssetError,
    DeviceError,
    Error,
    LevelError,
    SaveError,
    ShaderError,
    ShapeError,
    SnapshotError,
    StaleReferenceError,
)
from evilengine.values.image import Image
from evilengine.values.sheet import Animation, Sheet
from evilengine.values.vec2 import Vec2
from evilengine.values.version import VERSION
from evilengine.world import joints, soft
from evilengine.world.body import Body, Shape
from evilengine.world.character import Character
from evilengine.world.contacts import Contact
from evilengine.world.forces import ConstantForce, Drag, Force, Gravity, Pull, Spring
from evilengine.world.liquid import Liquid
from evilengine.world.media import Medium
from evilengine.world.queries import RayHit
from evilengine.world.sensors import Visit
from evilengine.world.shapes import Capsule, Chain, Circle, Particle, Polygon, Rectangle, Segment, Triangle
from evilengine.world.smoke import Smoke, Source
from evilengine.world.traits import ALL
from evilengine.world.water import Stream, Water
from evilengine.world.world import World

if TYPE_CHECKING:
    from evilengine.game import Game

__version__ = VERSION

__all__ = [
    "ALL",
    "Animation",
    "ArgumentError",
    "ArgumentTypeError",
    "AssetError",
    "Body",
    "Capsule",
    "Chain",
    "Character",
    "Circle",
    "ConstantForce",
    "Contact",
    "DeviceError",
    "Drag",
    "Error",
    "Force",
    "Game",
    "Gravity",
    "Image",
    "LevelError",
    "Liquid",
    "Mat4",
    "Medium",
    "Particle",
    "Polygon",
    "Pull",
    "RayHit",
    "Rectangle",
    "SaveError",
    "Segment",
    "ShaderError",
    "Shape",
    "ShapeError",
    "Sheet",
    "Smoke",
    "SnapshotError",
    "Source",
    "Spring",
    "StaleReferenceError",
    "Stream",
    "Triangle",
    "Vec2",
    "Visit",
    "Water",
    "World",
    "joints",
    "math",
    "soft",
]


def __getattr__(name: str) -> type[Game]:
    """Game, when it is first asked for: a simulation without windows need not wait for what draws and listens."""
    if name != "Game":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from evilengine.game import Game

    globals()["Game"] = Game
    return Game
