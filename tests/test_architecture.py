"""The rules that keep the engine in one piece: who imports whom, what the core may know, how long a file may grow."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "evilengine"
CORE = ROOT / "core"
LONGEST_FILE = 450  # lines; past that a file holds more than one subject

# From the ground up. A part imports parts below it, never one beside it.
LAYERS = (
    {"_core", "values"},
    {"math"},
    {"world"},
    {"assets", "audio", "interaction", "platform", "renderer", "save", "scene", "script", "timer"},
    {"game", "level", "cli", "examples", "bench"},
    {"__init__", "__main__"},
)
LAYER_OF = {part: layer for layer, parts in enumerate(LAYERS) for part in parts}
TOP = len(LAYERS) - 1
FREE_TO_IMPORT_BESIDE = {
    ("values", "_core"),  # types only: values name what the core hands over
    *((a, b) for a in LAYERS[4] for b in LAYERS[4]),  # what ties the modules together is one floor
}

# Packages that are not ours, and the only files that may know them. NumPy is in no file: games use it if they have it.
FOREIGN = {
    "sdl2": ("platform/",),
    "sdl2dll": ("platform/", "cli/doctor.py"),
    "miniaudio": ("audio/decode.py",),
    "platformdirs": ("save/",),
    "pyb2d3": ("bench/box2d.py",),
    "pymunk": ("bench/chipmunk.py",),
    "moderngl": ("renderer/gl/moderngl_device.py",),
    "PIL": ("assets/", "values/picture_files.py", "cli/doctor.py"),
}


def python_files() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def core_files() -> list[Path]:
    return sorted([*CORE.rglob("*.hpp"), *CORE.rglob("*.cpp")])


def written_files() -> list[Path]:
    """Every text file that people write and read here."""
    folders = [PACKAGE, CORE, *(ROOT / name for name in (".ci", ".github", "docs", "tests", "tools"))]
    inside = [path for folder in folders if folder.exists() for path in folder.rglob("*")]
    found = [path for path in [*inside, *ROOT.glob("*")] if path.is_file() and "__pycache__" not in path.parts]
    texts = {".py", ".pyi", ".hpp", ".cpp", ".evil", ".md", ".toml", ".txt", ".yml", ""}
    return sorted(path for path in found if path.suffix in texts and path.name not in {".git", ".coverage"})


def part_of(file: Path) -> str:
    """The part of the engine that a file belongs to: its folder in the package, or its own name."""
    inside = file.relative_to(PACKAGE)
    return inside.parts[0] if len(inside.parts) > 1 else inside.stem


def imports(source: str, package: tuple[str, ...]) -> Iterator[str]:
    """Every module that `source` imports, wherever in the file, as an absolute dotted name."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            stem = ".".join([*base, *([node.module] if node.module else [])])
            yield from (f"{stem}.{alias.name}" for alias in node.names)


def imports_of(file: Path) -> set[str]:
    return set(imports(file.read_text(), file.relative_to(PACKAGE.parent).parent.parts))


def broken_import_rules(part: str, imported: set[str]) -> list[str]:
    """What a file of `part` imports against the rule."""
    broken = []
    for name in sorted(imported):
        top, *rest = name.split(".")
        if top != "evilengine":
            continue
        target = rest[0] if rest and rest[0] in LAYER_OF else "__init__"
        if target == part or (part, target) in FREE_TO_IMPORT_BESIDE or LAYER_OF[target] < LAYER_OF[part]:
            continue
        if part == "examples" and target == "__init__":
            continue  # an example is a game: it sees the engine as games do
        broken.append(f"{part} imports {name}")
    return broken


def test_the_import_rule_can_see_a_broken_rule() -> None:
    sideways = set(imports("def f():\n    from ..scene import camera\n", ("evilengine", "timer")))
    assert broken_import_rules("timer", sideways) == ["timer imports evilengine.scene.camera"]
    assert broken_import_rules("world", {"evilengine.game.Game"}) == ["world imports evilengine.game.Game"]
    assert broken_import_rules("scene", {"evilengine.World"}) == ["scene imports evilengine.World"]
    assert not broken_import_rules("scene", {"evilengine.world.body", "evilengine._core", "evilengine.values.vec2"})


@pytest.mark.parametrize("file", python_files(), ids=lambda file: str(file.relative_to(PACKAGE)))
def test_imports_run_one_way(file: Path) -> None:
    part = part_of(file)
    assert part in LAYER_OF, f"{file.relative_to(ROOT)}: {part!r} has no place in LAYERS; give it one"
    assert not broken_import_rules(part, imports_of(file))


def test_no_file_of_the_engine_imports_numpy() -> None:
    assert [file for file in python_files() if any(name.split(".")[0] == "numpy" for name in imports_of(file))] == []


@pytest.mark.parametrize("package", sorted(FOREIGN))
def test_a_foreign_package_is_known_in_one_place_only(package: str) -> None:
    users = {str(f.relative_to(PACKAGE)) for f in python_files() if package in {n.split(".")[0] for n in imports_of(f)}}
    assert {user for user in users if not user.startswith(FOREIGN[package])} == set()


def test_the_engine_needs_nothing_that_is_not_declared() -> None:
    import sys

    declared = {"sdl2", "sdl2dll", "PIL", "uharfbuzz", "miniaudio", "moderngl", "platformdirs", "evilengine"}
    beside = {"pymunk", "pyb2d3"}  # of the extra `bench`: without them, nothing is measured beside the engine
    used = {name.split(".")[0] for file in python_files() for name in imports_of(file)} - beside
    assert used - declared - sys.stdlib_module_names == set()


def includes(file: Path) -> set[str]:
    return set(re.findall(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]', file.read_text(), re.MULTILINE))


# A kernel has no clock, no files, no threads but the World's own, no screen to print on; nor does it know who called.
CLOCKS, FILES, THREADS = {"chrono", "ctime", "time.h"}, {"fstream", "filesystem"}, {"thread", "mutex", "future"}
PRINTING, CHANCE = {"iostream", "cstdio", "stdio.h"}, {"random"}
KEPT_OUT_OF_THE_CORE = CLOCKS | FILES | THREADS | PRINTING | CHANCE


@pytest.mark.parametrize("file", core_files(), ids=lambda file: str(file.relative_to(CORE)))
def test_the_core_knows_no_python_no_clock_and_no_files(file: Path) -> None:
    if file.is_relative_to(CORE / "bind"):
        return
    included = includes(file) - (THREADS if file.name in ("threads.cpp", "door.hpp") else set())
    assert included & KEPT_OUT_OF_THE_CORE == set()
    foreign = {name for name in included if name.startswith(("nanobind", "Python", "bind/"))}
    assert foreign == set(), "only core/bind may know Python"


# Folders of the core from the ground up: maths knows nothing but itself, shapes know maths, and so on.
CORE_GROUND = {
    "math": {"math"},
    "shapes": {"math", "shapes"},
    "raster": {"math", "shapes", "draw", "raster", "light"},
    "mixer": {"math", "mixer"},
    "gpu": {"math", "shapes", "draw", "raster", "gpu"},
}


@pytest.mark.parametrize("folder", sorted(CORE_GROUND))
def test_the_ground_of_the_core_knows_only_what_is_below_it(folder: str) -> None:
    for file in (CORE / folder).glob("*.[ch]pp"):
        folders = {name.split("/")[0] for name in includes(file) if "/" in name and (CORE / name).exists()}
        assert folders <= CORE_GROUND[folder], f"{file.relative_to(ROOT)} includes {folders - CORE_GROUND[folder]}"


def bind_headers(file: Path) -> set[str]:
    """The headers of core/bind that a file of it includes, straight or by others."""
    found: set[str] = set()
    for name in re.findall(r'#include "bind/(\w+\.hpp)"', file.read_text()):
        found |= {name} | bind_headers(CORE / "bind" / name)
    return found


def test_no_call_of_python_comes_into_a_world_past_its_door() -> None:
    takers = [file for file in (CORE / "bind").glob("*.cpp") if re.search(r"\bWorld& ", file.read_text())]
    assert len(takers) > 5
    assert [file.name for file in takers if "visit.hpp" not in bind_headers(file)] == []


def test_every_header_is_guarded() -> None:
    unguarded = [f for f in CORE.rglob("*.hpp") if "#pragma once" not in f.read_text().splitlines()[:5]]
    assert unguarded == []


def test_no_file_is_too_long() -> None:
    code = [path for path in written_files() if path.suffix in {".py", ".hpp", ".cpp"}]
    lengths = {str(path.relative_to(ROOT)): len(path.read_text().splitlines()) for path in code}
    too_long = {name: lines for name, lines in lengths.items() if lines > LONGEST_FILE}
    assert too_long == {}, f"over {LONGEST_FILE} lines; split by subject"


def test_no_file_names_a_place_on_somebodys_machine() -> None:
    place = re.compile(r"(?<![\w.])/(?:home/\w|Users/\w|root/\w|work/\w|workspace/)")
    named = [str(path.relative_to(ROOT)) for path in written_files() if place.search(path.read_text())]
    assert [name for name in named if name != "tests/test_architecture.py"] == []
