"""`import evilengine` is quick, and loads nothing that a game may never need."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time

MOST = 0.100  # seconds beyond bare Python: what a person does not notice when a script starts
WRITES_BYTECODE = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def seconds(code: str) -> float:
    """Processor time of a fresh Python that runs `code`: a machine that is busy with others does not change it much."""
    try:
        import resource
    except ImportError:  # Windows: wall time
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True, env=WRITES_BYTECODE)
        return time.perf_counter() - start
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], check=True, env=WRITES_BYTECODE)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def test_the_engine_imports_in_under_a_tenth_of_a_second() -> None:
    seconds("import evilengine")  # writes the bytecode
    bare = min(seconds("pass") for _ in range(7))
    best = math.inf
    for _ in range(30):  # whatever else runs only makes it longer
        best = min(best, seconds("import evilengine") - bare)
        if best < MOST:
            break
    print(f"import evilengine: {best * 1000:.0f} ms beyond bare Python's {bare * 1000:.0f} ms")
    assert best < MOST


def test_import_loads_no_numpy_no_window_and_no_images() -> None:
    heavy = {"numpy", "sdl2", "sdl2dll", "PIL", "miniaudio", "asyncio", "unittest"}
    code = f"import evilengine, sys; print(*({heavy!r} & sys.modules.keys()))"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.split() == []
