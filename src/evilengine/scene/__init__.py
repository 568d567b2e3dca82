"""What is seen: the camera, drawings on bodies and alone, layers, lights, particles, text, and the debug view."""

from evilengine.scene.camera import Camera
from evilengine.scene.debug import DebugView
from evilengine.scene.drawing import Drawing
from evilengine.scene.drawn_body import LOOKS, DrawnBody
from evilengine.scene.layers import Layer, Layers
from evilengine.scene.light import Light
from evilengine.scene.lights import Lights
from evilengine.scene.panel import Panel
from evilengine.scene.particles import Emitter
from evilengine.scene.post import Post
from evilengine.scene.scene import Scene
from evilengine.scene.text import Text
from evilengine.scene.views import View, Views, collect_views

__all__ = [
    "LOOKS",
    "Camera",
    "DebugView",
    "Drawing",
    "DrawnBody",
    "Emitter",
    "Layer",
    "Layers",
    "Light",
    "Lights",
    "Panel",
    "Post",
    "Scene",
    "Text",
    "View",
    "Views",
    "collect_views",
]
