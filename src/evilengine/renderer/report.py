"""What there is to draw with on this machine, for people who ask why something is slow or missing."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Graphics:
    """The driver that draws without a window, which is nearly always the one in a window too."""

    renderer: str
    """The graphics card, or the program that plays one, as the driver calls it; empty where there is no driver."""
    driver: str
    software: bool
    """It is a program on the processor: "auto" draws in software, which is faster."""
    problem: str
    """Why there is none, and what to install; empty where there is one."""


def graphics() -> Graphics:
    """Ask the driver. Never raises."""
    try:
        from evilengine.renderer.gl.moderngl_device import is_software, make_headless

        device = make_headless()
    except ImportError as error:
        return Graphics("", "", False, f"{error}; pip install moderngl")
    except Exception as error:  # drivers fail in ways of their own
        return Graphics("", "", False, " ".join(str(error).split()) or type(error).__name__)
    return Graphics(device.renderer, device.driver, is_software(device.renderer), "")
