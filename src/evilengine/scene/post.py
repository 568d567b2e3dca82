"""Post: what is done to the whole picture before text goes over it (bloom, tones, colours, vignette, grain)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from evilengine.values.checks import number, one_of
from evilengine.values.colour import WHITE, Colour, ColourLike, to_colour

if TYPE_CHECKING:
    from evilengine import _core

TONES = ("plain", "filmic")
PLAIN: dict[str, Any] = {
    "bloom": 0.0, "bloom_threshold": 0.6, "exposure": 1.0, "tone_mapping": "plain", "contrast": 1.0, "saturation": 1.0,
    "tint": WHITE, "vignette": 0.0, "grain": 0.0,
}  # fmt: skip


class Post:
    """What is done to the finished picture: one line each, off by default, and free when all is off.

    >>> game = evil.Game(headless=True)
    >>> game.post.bloom = 0.6
    >>> game.post.vignette, game.post.grain = 0.4, 0.03
    >>> game.post.on
    True
    >>> game.post.clear(); game.post.on
    False
    """

    __slots__ = ("_values",)

    def __init__(self) -> None:
        self._values = dict(PLAIN)

    @property
    def on(self) -> bool:
        """Is anything done at all?"""
        return any(self._values[name] != plain for name, plain in PLAIN.items() if name != "bloom_threshold")

    def clear(self) -> None:
        """Leave the picture as it is."""
        self._values = dict(PLAIN)

    @property
    def bloom(self) -> float:
        """How much of the light of what is bright is spread over what is near it: 0 to 3; 0.6 glows."""
        return float(self._values["bloom"])

    @bloom.setter
    def bloom(self, value: float) -> None:
        self._set("bloom", value, 0.0, 3.0)

    @property
    def bloom_threshold(self) -> float:
        """How bright something must be to shine: 0 to 1, where 1 is white."""
        return float(self._values["bloom_threshold"])

    @bloom_threshold.setter
    def bloom_threshold(self, value: float) -> None:
        self._set("bloom_threshold", value, 0.0, 1.0)

    @property
    def exposure(self) -> float:
        """Factor of all light: 2 is one stop brighter."""
        return float(self._values["exposure"])

    @exposure.setter
    def exposure(self, value: float) -> None:
        self._set("exposure", value, 0.0, 16.0)

    @property
    def tone_mapping(self) -> str:
        """'plain': what is brighter than white is white; 'filmic': light and dark bend softly, as on film."""
        return str(self._values["tone_mapping"])

    @tone_mapping.setter
    def tone_mapping(self, value: str) -> None:
        self._values["tone_mapping"] = one_of(value, "Post", "tone_mapping", TONES)

    @property
    def contrast(self) -> float:
        """How far light and dark are apart: 1 is as they are, 0 is one grey."""
        return float(self._values["contrast"])

    @contrast.setter
    def contrast(self, value: float) -> None:
        self._set("contrast", value, 0.0, 4.0)

    @property
    def saturation(self) -> float:
        """How colourful it is: 1 is as it is, 0 is black and white."""
        return float(self._values["saturation"])

    @saturation.setter
    def saturation(self, value: float) -> None:
        self._set("saturation", value, 0.0, 4.0)

    @property
    def tint(self) -> Colour:
        """A colour that all light is multiplied with, as a filter before a lens: '#ffe0b0' is warm."""
        tint: Colour = self._values["tint"]
        return tint

    @tint.setter
    def tint(self, value: ColourLike) -> None:
        self._values["tint"] = to_colour(value, "Post", "tint")

    @property
    def vignette(self) -> float:
        """How much darker the corners are: 0 to 1, where they are black."""
        return float(self._values["vignette"])

    @vignette.setter
    def vignette(self, value: float) -> None:
        self._set("vignette", value, 0.0, 1.0)

    @property
    def grain(self) -> float:
        """How strong the grain of the film is: 0 to 1; 0.03 is fine."""
        return float(self._values["grain"])

    @grain.setter
    def grain(self, value: float) -> None:
        self._set("grain", value, 0.0, 1.0)

    def _set(self, name: str, value: float, least: float, most: float) -> None:
        self._values[name] = number(value, "Post", name, least=least, most=most)

    def __repr__(self) -> str:
        changed = ", ".join(f"{name}={value!r}" for name, value in self._values.items() if value != PLAIN[name])
        return f"<Post {changed or 'off'}>"

    # What the scene does with it ---------------------------------------------------------------------------------

    def put(self, core: _core.Scene, steps: int) -> None:
        """Do it to all that the frame has; the grain is another each step."""
        v = self._values
        linear = tuple(_linear(part) for part in v["tint"][:3])
        core.post(
            bloom=v["bloom"], threshold=v["bloom_threshold"], saturation=v["saturation"], vignette=v["vignette"],
            grain=v["grain"], seed=steps * 0x9E3779B9 & 0xFFFFFFFF, exposure=v["exposure"], contrast=v["contrast"],
            filmic=v["tone_mapping"] == "filmic", tint=(linear[0], linear[1], linear[2]),
        )  # fmt: skip

    def state(self) -> dict[str, Any]:
        """What a saved game keeps of it."""
        return {**self._values, "tint": list(self.tint)}

    def read(self, state: dict[str, Any]) -> dict[str, Any]:
        """What `state` gave, checked, for `become`."""
        read = Post()
        for name in PLAIN:
            setattr(read, name, Colour(*state[name]) if name == "tint" else state[name])
        return read._values

    def become(self, values: dict[str, Any]) -> None:
        """Take over what was read."""
        self._values = values


def _linear(part: float) -> float:
    """A part of an sRGB colour as light; close enough to the curve by its usual power, for a filter's colour."""
    return part * part * (0.305306011 * part + 0.682171111) + 0.012522878 * part
