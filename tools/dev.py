#!/usr/bin/env python3
"""One command for each chore of a developer. Run it with the Python of your virtual environment.

python tools/dev.py setup      install what development needs, then build
python tools/dev.py build      compile the core into src/evilengine
python tools/dev.py test       build, then run pytest with the arguments that follow
python tools/dev.py format     format Python and C++
python tools/dev.py lint       check format, style and types; changes nothing
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "evilengine"
BUILD = ROOT / "build" / "dev"
CPP = [str(path) for suffix in ("hpp", "cpp") for path in sorted((ROOT / "core").rglob(f"*.{suffix}"))]


def run(*command: str | Path) -> None:
    print("+", " ".join(str(part) for part in command), flush=True)
    if subprocess.run([str(part) for part in command], cwd=ROOT).returncode:
        sys.exit(1)


def tool(name: str) -> str:
    """The tool of this virtual environment, else the one on the path."""
    return shutil.which(name, path=str(Path(sys.executable).parent)) or shutil.which(name) or name


def setup() -> None:
    run(
        sys.executable,
        "-m",
        "pip",
        "install",
        "-q",
        "nanobind>=2.10,<3",
        "cmake>=3.26,<5",
        "ninja>=1.11,<2",
        "ruff>=0.9,<1",
        "mypy>=1.14,<3",
        "clang-format>=19,<23",
        "pytest>=8,<10",
        "hypothesis>=6.100,<7",
        "numpy>=1.26,<3",
        "PySDL2>=0.9.16,<0.10",
        "pysdl2-dll>=2.28,<3",
        "Pillow>=10.1,<14",
    )
    Path(sysconfig.get_paths()["purelib"], "evilengine-dev.pth").write_text(f"{ROOT / 'src'}\n")
    build()


def build() -> None:
    run(
        tool("cmake"),
        "-S",
        ".",
        "-B",
        BUILD,
        "-G",
        "Ninja",
        f"-DPython_EXECUTABLE={sys.executable}",
        f"-DCMAKE_MAKE_PROGRAM={tool('ninja')}",
        "-DCMAKE_BUILD_TYPE=Release",
        "-DEVIL_WERROR=ON",
        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
        "--log-level=WARNING",
    )
    run(tool("cmake"), "--build", BUILD)
    for library in (*BUILD.glob("_core*.so"), *BUILD.glob("_core*.pyd")):
        temporary = PACKAGE / (library.name + ".new")
        shutil.copy2(library, temporary)
        temporary.replace(PACKAGE / library.name)  # a running process keeps the old one


def test(*arguments: str) -> None:
    build()
    run(sys.executable, "-m", "pytest", *arguments)


def format() -> None:
    run(tool("ruff"), "check", "--fix", "-q", ".")
    run(tool("ruff"), "format", "-q", ".")
    run(tool("clang-format"), "-i", *CPP)


def lint() -> None:
    run(tool("ruff"), "check", ".")
    run(tool("ruff"), "format", "--check", ".")
    run(tool("clang-format"), "--dry-run", "--Werror", *CPP)
    run(sys.executable, "-m", "mypy")


CHORES = {"setup": setup, "build": build, "test": test, "format": format, "lint": lint}

if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in CHORES:
        sys.exit(__doc__)
    CHORES[sys.argv[1]](*sys.argv[2:])
