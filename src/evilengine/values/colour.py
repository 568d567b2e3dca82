"""Colour: what names, hex strings and tuples become, and the palette for things that were given none."""

from __future__ import annotations

import math
from typing import TypeAlias

from evilengine.values.checks import did_you_mean
from evilengine.values.errors import ArgumentError, ArgumentTypeError


class Colour(tuple[float, float, float, float]):
    """Red, green, blue and alpha, each 0..1 (sRGB, straight alpha): a tuple with names.

    Raises ArgumentTypeError for a part that is no number and ArgumentError for one outside 0..1.

    >>> Colour(1, 0.5, 0).with_alpha(0.5)
    Colour(1.0, 0.5, 0.0, 0.5)
    >>> Colour(1, 0, 0) == (1, 0, 0, 1)
    True
    """

    __slots__ = ()

    def __new__(cls, r: float, g: float, b: float, a: float = 1.0) -> Colour:
        try:
            parts = (float(r), float(g), float(b), float(a))
        except (TypeError, ValueError, OverflowError):
            raise ArgumentTypeError(f"Colour({r!r}, {g!r}, {b!r}, {a!r}): each part must be a number") from None
        for name, part in zip("rgba", parts, strict=True):
            if not 0.0 <= part <= 1.0:
                raise ArgumentError(
                    f"Colour: {name}={part!r} must be between 0 and 1; "
                    "divide parts of 0..255 by 255, or write '#rrggbb'"
                )
        return tuple.__new__(cls, parts)

    @property
    def r(self) -> float:
        """Red, 0..1."""
        return self[0]

    @property
    def g(self) -> float:
        """Green, 0..1."""
        return self[1]

    @property
    def b(self) -> float:
        """Blue, 0..1."""
        return self[2]

    @property
    def a(self) -> float:
        """Alpha: 0 is not seen, 1 hides what is behind."""
        return self[3]

    @staticmethod
    def of_rgba8(packed: int) -> Colour:
        """The colour packed as 0xAABBGGRR; undoes `rgba8`."""
        return Colour(*(((packed >> shift) & 255) / 255.0 for shift in (0, 8, 16, 24)))

    @property
    def rgba8(self) -> int:
        """The colour as 0xAABBGGRR: bytes r, g, b, a in memory.

        >>> hex(Colour(1, 0.5, 0).rgba8)
        '0xff0080ff'
        """
        r, g, b, a = (math.floor(part * 255.0 + 0.5) for part in self)
        return r | g << 8 | b << 16 | a << 24

    @property
    def hex(self) -> str:
        """The colour as '#rrggbb', or '#rrggbbaa' when it is not opaque.

        >>> Colour(1, 0.5, 0).hex
        '#ff8000'
        """
        packed = self.rgba8
        digits = "".join(f"{packed >> shift & 255:02x}" for shift in (0, 8, 16, 24))
        return "#" + (digits[:6] if digits.endswith("ff") else digits)

    def with_alpha(self, a: float) -> Colour:
        """The same colour with another alpha."""
        return Colour(self[0], self[1], self[2], a)

    def mixed(self, other: Colour, part: float) -> Colour:
        """This colour with `part` (0..1) of `other` in it.

        >>> Colour(0, 0, 0).mixed(Colour(1, 1, 1), 0.25)
        Colour(0.25, 0.25, 0.25, 1.0)
        """
        return Colour(*(mine + part * (theirs - mine) for mine, theirs in zip(self, other, strict=True)))

    def __repr__(self) -> str:
        return f"Colour({self[0]!r}, {self[1]!r}, {self[2]!r}, {self[3]!r})"

    def __getnewargs__(self) -> tuple[float, float, float, float]:
        return self[0], self[1], self[2], self[3]


ColourLike: TypeAlias = Colour | str | tuple[float, float, float] | tuple[float, float, float, float]
"""Whatever a function takes for a colour: a Colour, a CSS name, '#hex', or 3 or 4 parts of 0..1."""


def to_colour(value: object, owner: str, argument: str) -> Colour:
    """`value` as a Colour: a CSS name, '#rgb', '#rgba', '#rrggbb', '#rrggbbaa', or 3 or 4 parts of 0..1.

    Raises ArgumentTypeError or ArgumentError that names `owner` and `argument`.

    >>> to_colour("orange", "Scene.add", "colour").hex
    '#ffa500'
    >>> to_colour("#f80", "Scene.add", "colour").hex
    '#ff8800'
    """
    if type(value) is Colour:
        return value
    if isinstance(value, str):
        return _from_text(value, owner, argument)
    try:
        parts = [] if isinstance(value, bytes) else [float(part) for part in value]  # type: ignore[attr-defined]
    except (TypeError, ValueError, OverflowError):
        parts = []
    if len(parts) not in (3, 4):
        raise ArgumentTypeError(
            f"{owner}: {argument}={value!r} must be a colour: a name such as 'orange', '#rrggbb', "
            "or 3 or 4 numbers between 0 and 1"
        )
    if not all(0.0 <= part <= 1.0 for part in parts):
        raise ArgumentError(
            f"{owner}: {argument}={value!r} must have parts between 0 and 1; "
            "divide parts of 0..255 by 255, or write '#rrggbb'"
        )
    return Colour(*parts)


def _from_text(text: str, owner: str, argument: str) -> Colour:
    word = text.strip().lower()
    digits = word[1:] if word.startswith("#") else f"{NAMES[word]:06x}" if word in NAMES else ""
    if word == "transparent":
        digits = "00000000"
    if len(digits) in (3, 4):
        digits = "".join(digit * 2 for digit in digits)
    if len(digits) not in (6, 8) or not set(digits) <= _HEX_DIGITS:
        allowed = "3, 4, 6 or 8 hex digits after #" if word.startswith("#") else "a CSS colour name or '#rrggbb'"
        raise ArgumentError(f"{owner}: {argument}={text!r} must be {allowed}{did_you_mean(word, NAMES)}")
    return Colour(*(int(digits[i : i + 2], 16) / 255.0 for i in range(0, len(digits), 2)))


_HEX_DIGITS = frozenset("0123456789abcdef")

# The named colours of CSS (CSS Color Module Level 4, 6.1), as 0xRRGGBB.
# fmt: off
NAMES: dict[str, int] = {
    "aliceblue": 0xF0F8FF, "antiquewhite": 0xFAEBD7, "aqua": 0x00FFFF, "aquamarine": 0x7FFFD4, "azure": 0xF0FFFF,
    "beige": 0xF5F5DC, "bisque": 0xFFE4C4, "black": 0x000000, "blanchedalmond": 0xFFEBCD, "blue": 0x0000FF,
    "blueviolet": 0x8A2BE2, "brown": 0xA52A2A, "burlywood": 0xDEB887, "cadetblue": 0x5F9EA0, "chartreuse": 0x7FFF00,
    "chocolate": 0xD2691E, "coral": 0xFF7F50, "cornflowerblue": 0x6495ED, "cornsilk": 0xFFF8DC, "crimson": 0xDC143C,
    "cyan": 0x00FFFF, "darkblue": 0x00008B, "darkcyan": 0x008B8B, "darkgoldenrod": 0xB8860B, "darkgray": 0xA9A9A9,
    "darkgreen": 0x006400, "darkgrey": 0xA9A9A9, "darkkhaki": 0xBDB76B, "darkmagenta": 0x8B008B,
    "darkolivegreen": 0x556B2F, "darkorange": 0xFF8C00, "darkorchid": 0x9932CC, "darkred": 0x8B0000,
    "darksalmon": 0xE9967A, "darkseagreen": 0x8FBC8F, "darkslateblue": 0x483D8B, "darkslategray": 0x2F4F4F,
    "darkslategrey": 0x2F4F4F, "darkturquoise": 0x00CED1, "darkviolet": 0x9400D3, "deeppink": 0xFF1493,
    "deepskyblue": 0x00BFFF, "dimgray": 0x696969, "dimgrey": 0x696969, "dodgerblue": 0x1E90FF, "firebrick": 0xB22222,
    "floralwhite": 0xFFFAF0, "forestgreen": 0x228B22, "fuchsia": 0xFF00FF, "gainsboro": 0xDCDCDC,
    "ghostwhite": 0xF8F8FF, "gold": 0xFFD700, "goldenrod": 0xDAA520, "gray": 0x808080, "green": 0x008000,
    "greenyellow": 0xADFF2F, "grey": 0x808080, "honeydew": 0xF0FFF0, "hotpink": 0xFF69B4, "indianred": 0xCD5C5C,
    "indigo": 0x4B0082, "ivory": 0xFFFFF0, "khaki": 0xF0E68C, "lavender": 0xE6E6FA, "lavenderblush": 0xFFF0F5,
    "lawngreen": 0x7CFC00, "lemonchiffon": 0xFFFACD, "lightblue": 0xADD8E6, "lightcoral": 0xF08080,
    "lightcyan": 0xE0FFFF, "lightgoldenrodyellow": 0xFAFAD2, "lightgray": 0xD3D3D3, "lightgreen": 0x90EE90,
    "lightgrey": 0xD3D3D3, "lightpink": 0xFFB6C1, "lightsalmon": 0xFFA07A, "lightseagreen": 0x20B2AA,
    "lightskyblue": 0x87CEFA, "lightslategray": 0x778899, "lightslategrey": 0x778899, "lightsteelblue": 0xB0C4DE,
    "lightyellow": 0xFFFFE0, "lime": 0x00FF00, "limegreen": 0x32CD32, "linen": 0xFAF0E6, "magenta": 0xFF00FF,
    "maroon": 0x800000, "mediumaquamarine": 0x66CDAA, "mediumblue": 0x0000CD, "mediumorchid": 0xBA55D3,
    "mediumpurple": 0x9370DB, "mediumseagreen": 0x3CB371, "mediumslateblue": 0x7B68EE, "mediumspringgreen": 0x00FA9A,
    "mediumturquoise": 0x48D1CC, "mediumvioletred": 0xC71585, "midnightblue": 0x191970, "mintcream": 0xF5FFFA,
    "mistyrose": 0xFFE4E1, "moccasin": 0xFFE4B5, "navajowhite": 0xFFDEAD, "navy": 0x000080, "oldlace": 0xFDF5E6,
    "olive": 0x808000, "olivedrab": 0x6B8E23, "orange": 0xFFA500, "orangered": 0xFF4500, "orchid": 0xDA70D6,
    "palegoldenrod": 0xEEE8AA, "palegreen": 0x98FB98, "paleturquoise": 0xAFEEEE, "palevioletred": 0xDB7093,
    "papayawhip": 0xFFEFD5, "peachpuff": 0xFFDAB9, "peru": 0xCD853F, "pink": 0xFFC0CB, "plum": 0xDDA0DD,
    "powderblue": 0xB0E0E6, "purple": 0x800080, "rebeccapurple": 0x663399, "red": 0xFF0000, "rosybrown": 0xBC8F8F,
    "royalblue": 0x4169E1, "saddlebrown": 0x8B4513, "salmon": 0xFA8072, "sandybrown": 0xF4A460, "seagreen": 0x2E8B57,
    "seashell": 0xFFF5EE, "sienna": 0xA0522D, "silver": 0xC0C0C0, "skyblue": 0x87CEEB, "slateblue": 0x6A5ACD,
    "slategray": 0x708090, "slategrey": 0x708090, "snow": 0xFFFAFA, "springgreen": 0x00FF7F, "steelblue": 0x4682B4,
    "tan": 0xD2B48C, "teal": 0x008080, "thistle": 0xD8BFD8, "tomato": 0xFF6347, "turquoise": 0x40E0D0,
    "violet": 0xEE82EE, "wheat": 0xF5DEB3, "white": 0xFFFFFF, "whitesmoke": 0xF5F5F5, "yellow": 0xFFFF00,
    "yellowgreen": 0x9ACD32,
}
# fmt: on

WHITE = Colour(1.0, 1.0, 1.0)
BLACK = Colour(0.0, 0.0, 0.0)
CLEAR = Colour(0.0, 0.0, 0.0, 0.0)

BACKGROUND = to_colour("#1b2130", "values", "BACKGROUND")
"""A night blue that lets every colour of the palette stand out."""

STONE = to_colour("#46506a", "values", "STONE")
"""What stands still and was given no colour: walls, floors."""

PALETTE: tuple[Colour, ...] = tuple(
    to_colour(text, "values", "PALETTE")
    for text in ("#f2a65a", "#5ec2b7", "#ee6c6c", "#7aa5f0", "#f4d06f", "#b58be0", "#8fc773", "#f08fb3")
)
"""Bodies that were given no colour take these in turn: equally light, and neighbours far apart in hue."""
