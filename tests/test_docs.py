"""What the documents say is true: their Python runs, their links lead somewhere, their paths exist."""

from __future__ import annotations

import re
import sys
import types
from pathlib import Path
from typing import Any

import pytest

import evilengine

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "evilengine"
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])


sys.path.insert(0, str(ROOT / "tools"))
import docs_pictures  # noqa: E402


def names(pages: list[Path]) -> list[str]:
    return [str(page.relative_to(ROOT)) for page in pages]


def blocks(page: Path, language: str) -> list[tuple[int, str]]:
    """Fenced blocks of a language: the line each begins on, and its text."""
    text = page.read_text(encoding="utf-8")
    fence = re.compile(rf"^```{language}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    return [(text.count("\n", 0, match.start(1)), match[1]) for match in fence.finditer(text)]


class QuietGame(evilengine.Game):
    """A game as a page writes it, without a window, that ends by itself."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **{**kwargs, "headless": True})

    def run(self) -> None:
        for _ in range(120):
            self.step()


PYTHON_PAGES = [page for page in PAGES if blocks(page, "python")]


@pytest.mark.parametrize("page", PYTHON_PAGES, ids=names(PYTHON_PAGES))
def test_the_python_of_a_page_runs(page: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(evilengine, "Game", QuietGame)
    monkeypatch.chdir(tmp_path)
    module = types.ModuleType("page")  # whose functions a saved game finds by name
    monkeypatch.setitem(sys.modules, "page", module)
    for line, source in blocks(page, "python"):
        exec(compile("\n" * line + source, str(page), "exec"), vars(module))


def test_the_readme_has_a_game_of_fifteen_lines() -> None:
    (_, game), *_ = blocks(ROOT / "README.md", "python")
    assert len([line for line in game.splitlines() if line.strip()]) <= 15
    assert "game.run()" in game


def test_the_levels_of_the_pages_have_no_errors(tmp_path: Path) -> None:
    from evilengine.cli import main

    levels = [text for page in PAGES for _, text in blocks(page, "") if text.startswith("evil 1;")]
    assert len(levels) >= 2
    for number, text in enumerate(levels):
        level = tmp_path / f"{number}.evil"
        level.write_text(text)
        assert main(["check", str(level)]) == 0


def test_the_readme_has_the_two_commands_that_ci_runs() -> None:
    commands = re.findall(r"^python3 -m venv.*$", (ROOT / "README.md").read_text(), re.MULTILINE)
    fresh = "python3 -m venv .venv && . .venv/bin/activate && "
    assert commands == [fresh + "pip install . && evil play", fresh + "pip install '.[test]' && pytest"]


@pytest.mark.parametrize("page", PAGES, ids=names(PAGES))
def test_links_lead_somewhere(page: Path) -> None:
    links = re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8"))
    own = [link for link in links if not link.startswith(("http://", "https://"))]
    rendered = {f"pictures/{name}" for name in docs_pictures.pictures_of(page)}  # when the site is built
    assert [link for link in own if link not in rendered and not (page.parent / link).exists()] == []


def test_the_film_of_the_readme_moves_and_is_small() -> None:
    from PIL import Image

    film = ROOT / "docs" / "prototype1.webp"
    assert film.stat().st_size < 1_500_000
    with Image.open(film) as picture:
        assert getattr(picture, "n_frames", 1) > 50


def test_every_public_name_is_explained() -> None:
    silent = [name for name in evilengine.__all__ if not getattr(getattr(evilengine, name), "__doc__", None)]
    assert [name for name in silent if callable(getattr(evilengine, name))] == []


def test_every_public_class_and_function_is_in_the_documents() -> None:
    text = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
    public = [name for name in evilengine.__all__ if callable(getattr(evilengine, name))]
    assert [name for name in public if not re.search(rf"\b{name}\b", text)] == []


def test_every_path_in_the_architecture_page_exists() -> None:
    page = (ROOT / "ARCHITECTURE.md").read_text()
    quoted = re.findall(r"`((?:core|src|docs|tests|tools|\.ci)/[\w./*-]*)`", page)
    assert len(quoted) >= 20, "the map of ARCHITECTURE.md names the paths of the parts"
    missing = [path for path in quoted if not list(ROOT.glob(path.rstrip("/")))]
    assert missing == []


def test_the_architecture_page_names_every_part() -> None:
    page = (ROOT / "ARCHITECTURE.md").read_text()
    files = [path.relative_to(PACKAGE) for path in PACKAGE.rglob("*.py")]
    parts = {f"src/evilengine/{file.parts[0]}" for file in files} - {"src/evilengine/__init__.py"}
    parts |= {f"core/{path.name}" for path in (ROOT / "core").iterdir() if path.is_dir()}
    assert {part for part in parts if part not in page} == set()


def test_the_pictures_of_the_tutorial_show_what_its_steps_add(tmp_path: Path) -> None:
    pictures = docs_pictures.pictures_of(ROOT / "docs" / "tutorial.md")
    assert len(pictures) >= 4
    seen = set()
    for name, sources in pictures.items():
        docs_pictures.render(sources, tmp_path / name)
        seen.add((tmp_path / name).read_bytes())
    assert len(seen) == len(pictures)


def test_the_gallery_shows_every_example() -> None:
    from evilengine.cli.sources import examples

    page = docs_pictures.gallery()
    assert [example.name for example in examples() if f"](pictures/{example.name}.webp)" not in page] == []


def test_the_sites_contents_name_every_page() -> None:
    contents = set(re.findall(r"[\w/-]+\.md", (ROOT / "mkdocs.yml").read_text()))
    written = {page.relative_to(ROOT / "docs").as_posix() for page in PAGES if page.is_relative_to(ROOT / "docs")}
    assert contents == written | {"gallery.md"}
