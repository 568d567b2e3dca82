#!/usr/bin/env python3
"""One command for each chore of a developer. Run it with the Python of your virtual environment.

python tools/dev.py setup      install what development needs, then build
python tools/dev.py build      compile the core into src/evilengine and write its type stubs
python tools/dev.py test       build, then run pytest with the arguments that follow
python tools/dev.py format     format Python and C++
python tools/dev.py lint       check format, style, types and stubs; changes nothing
python tools/dev.py docs       build the documentation's site into site/, with warnings as errors
python tools/dev.py release    source and wheel into dist/, and the wheel tried where there is no compiler
python tools/dev.py sanitize   run the core's tests with AddressSanitizer and UndefinedBehaviorSanitizer; with --thread,
                               those of threads with ThreadSanitizer
python tools/dev.py watched    compile what sanitize and fuzz run, and run nothing
python tools/dev.py exact      compare the scenes' bits with builds without optimisation, for ARM64 and by Clang
python tools/dev.py fuzz       let libFuzzer play with the core, for a minute or the seconds that follow; needs clang
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "evilengine"
STUBS = PACKAGE / "_core.pyi"
BUILD = ROOT / "build" / "dev"
SANITIZED = ROOT / "build" / "sanitize"
FUZZED = ROOT / "build" / "fuzz"
CPP = [
    str(path)
    for folder in ("core", "tests")
    for suffix in ("hpp", "cpp")
    for path in sorted((ROOT / folder).rglob(f"*.{suffix}"))
]

# Tests that start processes or open windows say nothing about the core, and a sanitizer would watch SDL instead; those
# of what is Python alone, or plays games to see what Python makes of them, go where others have been in the core; those
# that step whole scenes again and again to compare bits do too, and would take it many minutes.
NOT_THE_CORE = (
    *("architecture", "cli*", "docs", "examples", "gl*", "import", "screen", "sound_card", "stubs", "window*"),
    *("assets", "autosave", "callbacks", "camera", "colour", "film", "frame", "headless_device", "interaction"),
    *("level_*", "pictures", "player", "release", "replay", "save_files", "slow_motion", "sound_files", "tilt"),
    *("bench*", "scene_bits", "scenes", "testbed", "timer", "translate"),
)


def run(*command: str | Path, **environment: str) -> None:
    print("+", " ".join(str(part) for part in command), flush=True)
    if subprocess.run([str(part) for part in command], cwd=ROOT, env=os.environ | environment).returncode:
        sys.exit(1)


def tool(name: str) -> str:
    """The tool of this virtual environment, else the one on the path."""
    return shutil.which(name, path=str(Path(sys.executable).parent)) or shutil.which(name) or name


def requirements() -> list[str]:
    """What the engine, its tests and its developers need, as pyproject.toml lists it."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    listed = project["dependencies"] + extras["test"] + extras["dev"]
    return [requirement for requirement in listed if not requirement.startswith(project["name"])]


def compile_core(folder: Path, *options: str) -> list[Path]:
    """Build the extension in `folder`; where the finished module lies."""
    run(
        *(tool("cmake"), "-S", ".", "-B", folder, "-G", "Ninja", "--log-level=WARNING"),
        *(f"-DPython_EXECUTABLE={sys.executable}", f"-DCMAKE_MAKE_PROGRAM={tool('ninja')}"),
        *("-DEVIL_WERROR=ON", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *options),
    )
    run(tool("cmake"), "--build", folder)
    return [*folder.glob("_core*.so"), *folder.glob("_core*.pyd")]


def setup() -> None:
    run(sys.executable, "-m", "pip", "install", "-q", *requirements())
    Path(sysconfig.get_path("purelib"), "evilengine-dev.pth").write_text(f"{ROOT / 'src'}\n")
    command = Path(sysconfig.get_path("scripts"), "evil.cmd" if sys.platform == "win32" else "evil")
    line = '@"{}" -m evilengine %*' if sys.platform == "win32" else '#!/bin/sh\nexec "{}" -m evilengine "$@"'
    command.write_text(line.format(sys.executable) + "\n")
    command.chmod(0o755)
    build()


def build() -> None:
    for library in compile_core(BUILD, "-DCMAKE_BUILD_TYPE=Release"):
        temporary = PACKAGE / (library.name + ".new")
        shutil.copy2(library, temporary)
        temporary.replace(PACKAGE / library.name)  # a running process keeps the old one
    write_stubs(STUBS)


def write_stubs(file: Path) -> None:
    run(sys.executable, "-m", "nanobind.stubgen", "-q", "-P", "-m", "evilengine._core", "-o", file)


def check_stubs() -> None:
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder, "_core.pyi")
        write_stubs(fresh)
        if fresh.read_text() != STUBS.read_text():
            sys.exit(f"{STUBS.relative_to(ROOT)} is not what the built core says: run tools/dev.py build, commit it")


def test(*arguments: str) -> None:
    build()
    run(sys.executable, "-m", "pytest", *arguments)


def format() -> None:
    run(tool("ruff"), "check", "--fix", "--exit-zero", "-q", ".")
    run(tool("ruff"), "format", "-q", ".")
    run(tool("clang-format"), "-i", *CPP)


def lint() -> None:
    run(tool("ruff"), "check", ".")
    run(tool("ruff"), "format", "--check", ".")
    run(tool("clang-format"), "--dry-run", "--Werror", *CPP)
    run(sys.executable, "-m", "mypy")
    check_stubs()


def compile_fuzzer() -> bool:
    """False: there is no Clang."""
    clang = shutil.which("clang++")
    if clang is not None:
        make_target(
            *(FUZZED, "world_fuzzer", f"-DCMAKE_CXX_COMPILER={clang}", "-DCMAKE_BUILD_TYPE=None"),
            *("-DCMAKE_CXX_FLAGS=-O1", "-DEVIL_BINDINGS=OFF", "-DEVIL_FUZZ=ON"),
        )
    return clang is not None


def fuzz(seconds: str = "60") -> None:
    """What it finds stays in build/fuzz/corpus, where the next run goes on; an input that fails, in build/fuzz."""
    if not compile_fuzzer():
        print("fuzz: there is no clang++, so libFuzzer cannot play: apt-get install clang")
        return
    corpus = FUZZED / "corpus"
    corpus.mkdir(exist_ok=True)
    sys.path.insert(0, str(ROOT / "tests" / "fuzz"))
    seeds = importlib.import_module("seeds")

    seeds.write(corpus)
    run(
        *(FUZZED / "world_fuzzer", f"-max_total_time={seconds}", "-max_len=8192", "-timeout=20", "-rss_limit_mb=2048"),
        *(("-seed=1",) if os.environ.get("CI") else ()),  # what fails there fails again on the desk
        *(f"-artifact_prefix={FUZZED}/", "-print_final_stats=1", "-verbosity=0", corpus),
    )


@dataclass(frozen=True)
class Watch:
    """What a sanitizer is built with, what must be loaded before Python, what it looks at, and how it is told to."""

    folder: Path
    flags: str
    libraries: tuple[str, ...]
    tests: tuple[str, ...]
    environment: dict[str, str]


MEMORY = Watch(
    SANITIZED,
    "address,undefined",
    ("libasan.so", "libubsan.so"),
    tuple(f"--ignore-glob=tests/test_{name}.py" for name in NOT_THE_CORE),
    {
        "PYTHONMALLOC": "malloc",  # every allocation of its own, so that a read past its end is seen
        "ASAN_OPTIONS": "detect_leaks=0:strict_string_checks=1:detect_stack_use_after_return=1",  # Python leaks at exit
        "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
    },
)
THREADS = Watch(
    ROOT / "build" / "threads",
    "thread",
    ("libtsan.so",),
    ("tests/test_threads.py", "tests/test_other_threads.py", "tests/test_mixer.py", "tests/test_raster_bands.py"),
    {"TSAN_OPTIONS": "halt_on_error=1:die_after_fork=0:second_deadlock_stack=1"},
)


def exact(*builds: str) -> None:
    """All ways to build, or those named: -O0, ARM64, Clang."""
    sys.path.insert(0, str(ROOT / "tools"))
    importlib.import_module("exact").main(make_target, builds)


def make_target(folder: Path, target: str, *options: str) -> None:
    """Configure the core in `folder` and compile one target of it."""
    run(
        *(tool("cmake"), "-S", ".", "-B", folder, "-G", "Ninja", "--log-level=WARNING"),
        *(f"-DCMAKE_MAKE_PROGRAM={tool('ninja')}", *options),
    )
    run(tool("cmake"), "--build", folder, "--target", target)


def compile_watched(watch: Watch) -> list[Path]:
    return compile_core(
        watch.folder,
        f"-DEVIL_SANITIZE={watch.flags}",
        "-DCMAKE_BUILD_TYPE=None",
        "-DCMAKE_CXX_FLAGS=-O1 -D_GLIBCXX_ASSERTIONS -fno-var-tracking",
    )


def watched() -> None:
    """Compile what `sanitize` and `fuzz` run, and run nothing."""
    compile_watched(MEMORY)
    compile_fuzzer()


def sanitize(*arguments: str) -> None:
    """A second copy of the package, beside the build, holds the watched module: the normal one stays as it is."""
    watch, arguments = (THREADS, arguments[1:]) if arguments[:1] == ("--thread",) else (MEMORY, arguments)
    libraries = compile_watched(watch)
    site = watch.folder / "site"
    shutil.rmtree(site, ignore_errors=True)
    shutil.copytree(PACKAGE, site / "evilengine", ignore=shutil.ignore_patterns("*.so", "*.pyd", "__pycache__"))
    for library in libraries:
        shutil.copy2(library, site / "evilengine")

    # Python itself is not watched, so the sanitizers must be there before it; libstdc++ too, or they miss exceptions.
    compiler = os.environ.get("CXX", "c++")
    watchers = [
        subprocess.check_output([compiler, f"-print-file-name={name}"], text=True).strip()
        for name in (*watch.libraries, "libstdc++.so")
    ]
    named = any(not argument.startswith("-") for argument in arguments)
    tests = () if named and watch is THREADS else watch.tests
    run(
        # What a sanitizer or an assertion says on its way out must not end in pytest's own file.
        *(sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--capture=sys", *tests, *arguments),
        PYTHONPATH=str(site),
        LD_PRELOAD=" ".join(watchers),
        EVIL_SANITIZED=watch.flags,
        **watch.environment,
    )


def docs() -> None:
    """mkdocs and its parts are installed when they are first needed: who does not build the site does without."""
    extra = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]["docs"]
    if importlib.util.find_spec("mkdocs") is None:
        run(sys.executable, "-m", "pip", "install", "-q", *extra)
    run(sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", NO_MKDOCS_2_WARNING="1")
    pages = list((ROOT / "site").rglob("*.html"))
    print(f"site/: {len(pages)} pages, {sum(f.stat().st_size for f in (ROOT / 'site').rglob('*.*')) / 1e6:.1f} MB")


def release(built: str | None = None) -> None:
    """Source and wheel as they would be published, tried where there is no compiler. A wheel that is built already is
    tried as it is; it is as good as one built from the source if all its files are in there."""
    shutil.rmtree(ROOT / "dist", ignore_errors=True)
    run(sys.executable, "-m", "build", "--outdir", "dist", *(["--sdist"] if built else []))
    (source,) = (ROOT / "dist").glob("*.tar.gz")
    wheel = Path(built) if built else next((ROOT / "dist").glob("*.whl"))

    package = [file for file in PACKAGE.rglob("*.*") if file.suffix not in (".so", ".pyd", ".pyc")]
    core = [path for path in (ROOT / "core").rglob("*.*") if path.is_file()]
    with tarfile.open(source) as archive:
        packed = {name.partition("/")[2] for name in archive.getnames()}
    lacks(
        source, packed, [*package, *core, *(ROOT / name for name in ("CMakeLists.txt", "LICENSE", "README.md"))], ROOT
    )
    with zipfile.ZipFile(wheel) as archive:
        lacks(wheel, set(archive.namelist()), package, PACKAGE.parent)
    for file in (source, wheel):
        print(f"{file.name}: {file.stat().st_size / 1000:.0f} kB")

    with tempfile.TemporaryDirectory() as folder:
        run(sys.executable, "-m", "venv", folder)
        programs = Path(folder, Path(sys.executable).parent.name)  # bin, or Scripts
        for command in ((programs / "pip", "install", "-q", wheel), (programs / "python", "tools/try_wheel.py")):
            run(*command, PATH=str(programs), CC="no-compiler", CXX="no-compiler", PYTHONPATH="", DISPLAY="")


def lacks(archive: Path, inside: set[str], wanted: list[Path], root: Path) -> None:
    """Stop if `archive` lacks one of the files it should hold."""
    missing = [name for file in wanted if (name := file.relative_to(root).as_posix()) not in inside]
    if missing:
        sys.exit(f"{archive.name} lacks {', '.join(missing)}")


CHORES = {
    "setup": setup,
    "build": build,
    "test": test,
    "format": format,
    "lint": lint,
    "docs": docs,
    "release": release,
    "watched": watched,
    "sanitize": sanitize,
    "fuzz": fuzz,
    "exact": exact,
}

if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in CHORES:
        sys.exit(__doc__)
    if sys.prefix == sys.base_prefix:
        sys.exit("make a virtual environment first: python3 -m venv .venv && . .venv/bin/activate")
    CHORES[sys.argv[1]](*sys.argv[2:])
