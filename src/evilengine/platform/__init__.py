"""Devices: where a game is seen and what its player holds."""

from __future__ import annotations

from evilengine.platform.device import Device
from evilengine.platform.headless import HeadlessDevice

__all__ = ["Device", "HeadlessDevice"]
