"""EvilEngine: a 2D game engine for Python."""

__version__ = "0.1.0"
