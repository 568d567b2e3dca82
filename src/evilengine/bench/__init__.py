"""Scenes that benchmarks, tests and the testbed share, and what measures them: `evil bench physics`."""

from evilengine.bench import joined as joined  # they enter themselves into SCENES
from evilengine.bench import scenes as scenes
