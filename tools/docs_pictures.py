"""Pictures of the documentation, rendered by the engine while the site is built (mkdocs.yml names this file as a hook).

- `pictures/tutorial-3.webp` in a page: how its game looks after all Python blocks above that line.
- The gallery: a film of each example, with its source.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig
    from mkdocs.structure.files import Files

    from evilengine.game import Game
    from evilengine.platform import HeadlessDevice

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
MADE = ROOT / "build" / "docs"

PICTURE = re.compile(r"^!\[[^\]]*\]\(pictures/([\w-]+\.webp)\)", re.MULTILINE)
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SECONDS = 3.2
"""How long a page's game plays before its picture is taken: things have fallen, some still fall."""

FILM_SECONDS = 5.0
FILM_FPS = 15.0
FILM_HEIGHT = 270


GALLERY = """# Gallery

Every example that ships with the engine. `evil play NAME` plays one, `evil examples --copy NAME` copies it for you to
change. Each film is rendered from the source below it when this site is built.
"""


class Quiet:
    """A stage on which the games of a page are made; they are played when their picture is taken."""

    def open(self, title: str, size: tuple[int, int]) -> HeadlessDevice:
        from evilengine.platform import HeadlessDevice

        return HeadlessDevice(size, title=title)

    def run(self, game: Game) -> None:
        """Nothing yet."""


def pictures_of(page: Path) -> dict[str, list[str]]:
    """The pictures that a page shows, and the Python above each."""
    text = page.read_text(encoding="utf-8")
    blocks = [(match.end(), match[1]) for match in BLOCK.finditer(text)]
    return {match[1]: [source for end, source in blocks if end <= match.start()] for match in PICTURE.finditer(text)}


def render(sources: list[str], target: Path) -> None:
    """Run `sources` one after the other, play their `game` for a while, and save its picture."""
    from evilengine.game import STAGE

    token = STAGE.set(Quiet())
    try:
        names: dict[str, object] = {"__name__": "__page__"}
        for source in sources:
            exec(source, names)
        game: Game = names["game"]  # type: ignore[assignment]
        game.step(round(60 * SECONDS))
        game.capture().save(target)
        game.close()
    finally:
        STAGE.reset(token)


def film(path: Path, target: Path) -> None:
    """A small film of an example."""
    from evilengine.cli.film import Shot, film

    film(path, target, Shot(size=(480, FILM_HEIGHT)), seconds=FILM_SECONDS, fps=FILM_FPS)


def gallery() -> str:
    """The page that shows every example."""
    from evilengine.cli.sources import examples

    parts = [GALLERY]
    for example in examples():
        language = "python" if example.path.suffix == ".py" else "text"
        source = "".join(f"    {line}\n" for line in example.path.read_text(encoding="utf-8").splitlines())
        parts.append(
            f"## {example.name}\n\n{example.summary}.\n\n![{example.name}](pictures/{example.name}.webp)\n\n"
            f'??? "Its source"\n\n    ```{language}\n{source}    ```\n'
        )
    return "\n".join(parts)


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """mkdocs asks: which files are there beside those in docs/?"""
    from mkdocs.structure.files import File

    from evilengine.cli.sources import examples

    MADE.mkdir(parents=True, exist_ok=True)

    def add(name: str) -> None:
        files.append(File.generated(config, f"pictures/{name}", abs_src_path=str(MADE / name)))

    for page in sorted(DOCS.rglob("*.md")):
        for name, sources in pictures_of(page).items():
            render(sources, MADE / name)
            add(name)
    for example in examples():
        name = f"{example.name}.webp"
        film(example.path, MADE / name)
        add(name)
    files.append(File.generated(config, "gallery.md", content=gallery()))
    return files
