"""EvilEngine: a 2D game engine for Python, with C++ kernels underneath.

>>> import evilengine as evil
>>> world = evil.World()
>>> ball = world.add(evil.Circle(0.5), at=(0, 5))
>>> world.step()
>>> ball.position.y < 5
True
"""

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
    ShapeError,
    SnapshotError,
    StaleReferenceError,
)
from evilengine.values.image import Image
from evilengine.values.vec2 import Vec2
from evilengine.world.body import Body, Shape
from evilengine.world.contacts import Contact, RayHit
from evilengine.world.forces import ConstantForce, Drag, Force, Gravity, Medium, Pull, Spring
from evilengine.world.shapes import Circle, Particle, Polygon, Rectangle, Triangle
from evilengine.world.world import World

__version__ = "0.1.0"

__all__ = [
    "ArgumentError",
    "ArgumentTypeError",
    "AssetError",
    "Body",
    "Circle",
    "ConstantForce",
    "Contact",
    "DeviceError",
    "Drag",
    "Error",
    "Force",
    "Gravity",
    "Image",
    "LevelError",
    "Mat4",
    "Medium",
    "Particle",
    "Polygon",
    "Pull",
    "RayHit",
    "Rectangle",
    "SaveError",
    "Shape",
    "ShapeError",
    "SnapshotError",
    "Spring",
    "StaleReferenceError",
    "Triangle",
    "Vec2",
    "World",
    "math",
]
