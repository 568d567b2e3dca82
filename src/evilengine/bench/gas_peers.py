"""Whose smoke is timed beside ours: `pip install 'evilengine[bench-fluid]'` brings Taichi and Warp, on the processor.

Both run the example that they ship, with nothing changed but the size of its grid and, where its own comment says which
number is the quick one, the number of sweeps. The third is written here, with NumPy's arrays.
"""

from __future__ import annotations

import atexit
import contextlib
import importlib
import importlib.util
import io
import os
import shutil
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any

from evilengine.bench.scene import STEP
from evilengine.values.errors import DeviceError

Divergence = tuple[float, float]
"""Before the last projection and after it, root mean square; in whatever unit the engine has."""

SWEEPS = 40


def size_of(field: Any) -> float:
    """Root mean square of an array's numbers."""
    return float((field**2).mean() ** 0.5)


class Arrays:
    """Stam's steps with NumPy: a jet, one projection by forty Jacobi sweeps, semi-Lagrangian paths, no obstacles."""

    name = "NumPy"

    def __init__(self, cells: int) -> None:
        self._np: Any = importlib.import_module("numpy")
        np, side = self._np, cells + 2
        self.cells = cells
        self.u, self.v, self.density, self.pressure = (np.zeros((side, side), np.float32) for _ in range(4))
        rows, columns = np.mgrid[0:side, 0:side].astype(np.float32)
        self._rows, self._columns = rows, columns
        self._jet = (columns - 0.5 * side) ** 2 + (rows - 0.1 * side) ** 2 < (0.06 * side) ** 2
        self._left: Divergence = (0.0, 0.0)

    def prepare(self) -> None: ...

    def step(self) -> None:
        self.v[self._jet] = 0.75 * self.cells  # cells a second
        self.density[self._jet] += 4.0 * STEP
        self._project()
        paths = self._paths()
        self.u, self.v, self.density = (self._moved(field, paths) for field in (self.u, self.v, self.density))
        self._walls()

    def divergence(self) -> Divergence:
        self.v[self._jet] = 0.75 * self.cells
        before = self._gathered()
        self._project()
        return size_of(before), size_of(self._gathered())

    def _gathered(self) -> Any:
        return 0.5 * (self.u[1:-1, 2:] - self.u[1:-1, :-2] + self.v[2:, 1:-1] - self.v[:-2, 1:-1])

    def _project(self) -> None:
        gathered, p = self._gathered(), self.pressure
        p[...] = 0.0
        for _ in range(SWEEPS):
            p[1:-1, 1:-1] = 0.25 * (p[1:-1, 2:] + p[1:-1, :-2] + p[2:, 1:-1] + p[:-2, 1:-1] - gathered)
            p[0], p[-1], p[:, 0], p[:, -1] = p[1], p[-2], p[:, 1], p[:, -2]
        self.u[1:-1, 1:-1] -= 0.5 * (p[1:-1, 2:] - p[1:-1, :-2])
        self.v[1:-1, 1:-1] -= 0.5 * (p[2:, 1:-1] - p[:-2, 1:-1])
        self._walls()

    def _walls(self) -> None:
        u, v = self.u, self.v
        u[:, 0], u[:, -1], v[0], v[-1] = -u[:, 1], -u[:, -2], -v[1], -v[-2]

    def _paths(self) -> tuple[Any, ...]:
        """Where each cell's content comes from: its lower left cell and the shares of the next ones."""
        np, top = self._np, self.cells + 0.5
        x = np.clip(self._columns - STEP * self.u, 0.5, top)
        y = np.clip(self._rows - STEP * self.v, 0.5, top)
        i, j = x.astype(np.intp), y.astype(np.intp)
        return j * (self.cells + 2) + i, x - i, y - j

    def _moved(self, field: Any, paths: tuple[Any, ...]) -> Any:
        at, s, t = paths
        flat, row = field.ravel(), self.cells + 2
        a, b, c, d = (flat.take(at + step, mode="clip") for step in (0, 1, row, row + 1))
        low = a + s * (b - a)
        return low + t * (c + s * (d - c) - low)


class Taichi:
    """Taichi's own `stable_fluid.py` on the processor, on all of its threads, with the forty sweeps it calls quick."""

    name = "Taichi"

    def __init__(self, cells: int) -> None:
        os.environ.setdefault("TI_LOG_LEVEL", "error")
        with _quietly(), _no_arguments():
            importlib.import_module("taichi")
            self._example: Any = _shipped(
                "taichi",
                "examples/simulation/stable_fluid.py",
                cells,
                {"res = 512": f"res = {cells}", "p_jacobi_iters = 500": f"p_jacobi_iters = {SWEEPS}"},
            )
        np: Any = importlib.import_module("numpy")
        middle = (0.0, 1.0, 0.5 * cells, 0.2 * cells, 1.0, 1.0, 1.0, 0.0)  # the mouse goes up there
        self._mouse = np.array(middle, dtype=np.float32)
        self.step()  # compiles

    def prepare(self) -> None: ...

    def step(self) -> None:
        self._example.step(self._mouse)

    def divergence(self) -> Divergence:
        example = self._example
        self.step()
        before = example.velocity_divs.to_numpy()
        example.divergence(example.velocities_pair.cur)
        return size_of(before), size_of(example.velocity_divs.to_numpy())


class Warp:
    """Warp's own `example_fluid.py` on the processor: one of its two steps a frame, with a hundred sweeps."""

    name = "Warp"

    def __init__(self, cells: int) -> None:
        with _quietly():
            self._warp: Any = importlib.import_module("warp")
            self._warp.config.quiet = True
            self._warp.set_device("cpu")
            sizes = {f"grid_{way} = wp.constant({n})": f"grid_{way} = wp.constant({cells})" for way, n in _WARP_GRID}
            self._kernels: Any = _shipped("warp", "examples/core/example_fluid.py", cells, sizes)
            self._example = self._kernels.Example()
            self._example.sim_substeps = 1
            self.step()  # compiles

    def prepare(self) -> None: ...

    def step(self) -> None:
        with _quietly():
            self._example.step()

    def divergence(self) -> Divergence:
        """Its step again, up to where the velocity is projected."""
        warp, kernels, example = self._warp, self._kernels, self._example
        shape, found = example.div.shape, []
        warp.launch(kernels.init, dim=shape, inputs=[example.rho0, example.u0, 5, warp.vec2(400.0, 0.0)])
        for _ in range(2):
            warp.launch(kernels.divergence, dim=shape, inputs=[example.u0, example.div])
            found.append(size_of(example.div.numpy()))
            example.p0.zero_()
            example.p1.zero_()
            example.pressure_iterations()
            warp.launch(kernels.pressure_apply, dim=shape, inputs=[example.p0, example.u0])
        return found[0], found[1]


_WARP_GRID = (("width", 256), ("height", 128))

PEERS: dict[str, Any] = {each.name: each for each in (Arrays, Taichi, Warp)}
"""Who moves smoke beside us."""


def _shipped(package: str, file: str, cells: int, changes: dict[str, str]) -> ModuleType:
    """A package's own example, as a module of its own, with some of its lines changed.

    It is written to a file, since both look their functions' text up there.
    """
    spec = importlib.util.find_spec(package)
    if spec is None or spec.origin is None:
        raise ImportError(f"{package} is not installed")
    origin = Path(spec.origin).parent / file
    if not origin.is_file():
        raise DeviceError(f"this release has no {file}")
    text = origin.read_text()
    for old, new in changes.items():
        if text.count(old) != 1:
            raise DeviceError(f"the {file} of this release has no line {old!r}")
        text = text.replace(old, new)
    name = f"_{package}_example_{cells}"  # the same each time, since both keep what they compiled
    folder = tempfile.mkdtemp(prefix="evil-bench-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    copy = Path(folder) / f"{name}.py"
    copy.write_text(text)
    found = importlib.util.spec_from_file_location(name, copy)
    assert found is not None
    assert found.loader is not None
    module = importlib.util.module_from_spec(found)
    sys.modules[name] = module
    found.loader.exec_module(module)
    return module


@contextlib.contextmanager
def _no_arguments() -> Any:
    """An example reads the command's words when it is imported; ours are not for it."""
    kept, sys.argv = sys.argv, sys.argv[:1]
    try:
        yield
    finally:
        sys.argv = kept


def _quietly() -> contextlib.redirect_stdout[io.StringIO]:
    return contextlib.redirect_stdout(io.StringIO())
