"""The picture in the README of what the engine can show: moments of examples, side by side.

Run it from the folder of the project after an example has changed its looks: python tools/draw_readme.py
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from PIL import Image

from evilengine.cli.film import Shot, picture
from evilengine.cli.sources import examples

TARGET = Path(__file__).resolve().parent.parent / "docs" / "moments.webp"
MOMENTS = {
    "prototype2": 4.0, "17_nightwood": 3.0,
    "23_pool": 5.0, "21_campfire": 3.0,
    "22_smoke_lamp": 4.5, "24_tilt_aquarium": 2.0,
}  # fmt: skip
"""Examples, two a row, and after how many seconds each is shown."""
WIDTH, HEIGHT, GAP = 480, 270, 6


def moment(path: Path, seconds: float) -> Image.Image:
    """Rendered twice as large, and shrunk: smooth edges everywhere."""
    with tempfile.TemporaryDirectory() as folder:
        file = picture(path, Path(folder, "moment.png"), Shot(size=(2 * WIDTH, 2 * HEIGHT), sway=False), at=seconds)
        return Image.open(file).convert("RGB").resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)


def main() -> None:
    paths = {example.name: example.path for example in examples()}
    rows = len(MOMENTS) // 2
    sheet = Image.new("RGB", (2 * WIDTH + GAP, rows * (HEIGHT + GAP) - GAP), "white")
    for number, (name, seconds) in enumerate(MOMENTS.items()):
        at = (number % 2 * (WIDTH + GAP), number // 2 * (HEIGHT + GAP))
        sheet.paste(moment(paths[name], seconds), at)
    sheet.save(TARGET, quality=82, method=6)
    print(f"{TARGET}: {TARGET.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
