"""The colour of what glows: from kelvin to linear red, green and blue."""

from __future__ import annotations

COLDEST, HOTTEST = 1000.0, 25000.0
"""Kelvin: glowing coal, and the clearest blue sky; what the curves below are good for, and a little more."""


def linear_of(kelvin: float) -> tuple[float, float, float]:
    """Linear red, green and blue of a black body, the largest of them 1.

    The chromaticity by cubics in 1/T (Kim et al., "Design of advanced color temperature control system for HDTV
    applications", 2002), then from XYZ to linear sRGB (IEC 61966-2-1).

    >>> red, green, blue = linear_of(2700)
    >>> red, round(green, 1), round(blue, 1)
    (1.0, 0.4, 0.1)
    """
    t = 1000.0 / max(kelvin, 1667.0)
    if t > 0.25:
        x = ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
    else:
        x = ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390
    if t > 1000.0 / 2222.0:
        y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
    elif t > 0.25:
        y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
    else:
        y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483
    big_x, big_z = x / y, (1.0 - x - y) / y
    red = 3.2406 * big_x - 1.5372 - 0.4986 * big_z
    green = -0.9689 * big_x + 1.8758 + 0.0415 * big_z
    blue = 0.0557 * big_x - 0.2040 + 1.0570 * big_z
    if kelvin < 1667.0:  # below, the curves end: green dies away towards coal
        green, blue = green * kelvin / 1667.0, 0.0
    most = max(red, green, blue)
    return max(red, 0.0) / most, max(green, 0.0) / most, max(blue, 0.0) / most
