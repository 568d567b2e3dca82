"""What is published: versions agree, and the files that a public CI runs name what there is."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

import evilengine

ROOT = Path(__file__).resolve().parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


def test_the_project_and_the_package_have_one_version() -> None:
    assert PROJECT["project"]["version"] == evilengine.__version__
    assert f"## {evilengine.__version__}" in (ROOT / "CHANGELOG.md").read_text()


def test_every_system_has_a_machine_that_builds_its_wheels() -> None:
    matrix = (ROOT / ".github" / "workflows" / "wheels.yml").read_text()
    for system in ("ubuntu-24.04", "ubuntu-24.04-arm", "macos-15", "macos-15-intel", "windows-2022"):
        assert re.search(rf"[ \[]{system}[,\]]", matrix), system


@pytest.mark.parametrize("workflow", WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_names_only_files_that_there_are(workflow: Path) -> None:
    named = re.findall(r"(?:tools|\.ci)/[\w./]+", workflow.read_text())
    assert [path for path in named if not (ROOT / path).exists()] == []
    extras = re.findall(r"'\.\[([\w,]+)\]'", workflow.read_text())
    assert set(",".join(extras).split(",")) - {""} <= set(PROJECT["project"]["optional-dependencies"])


def test_wheels_are_built_for_every_python_that_may_install_them() -> None:
    oldest = PROJECT["project"]["requires-python"].removeprefix(">=3.")
    built = PROJECT["tool"]["cibuildwheel"]["build"]
    assert built[0] == f"cp3{oldest}-*"
    assert f"{PROJECT['tool']['scikit-build']['wheel']['py-api']}-*" in built  # one wheel serves the later ones


def test_the_wheels_test_command_names_a_file_that_there_is() -> None:
    (path,) = re.findall(r"\{project\}/(\S+)", PROJECT["tool"]["cibuildwheel"]["test-command"])
    assert (ROOT / path).exists()
