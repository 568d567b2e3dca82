"""Assets: images and fonts by name, decoded once; films written frame by frame (assets/film.py)."""

from evilengine.assets.fonts import Fonts
from evilengine.assets.images import Images
from evilengine.assets.pictures import Pictures

__all__ = ["Fonts", "Images", "Pictures"]
