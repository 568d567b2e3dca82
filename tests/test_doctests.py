"""The examples in the engine's docstrings do what they say."""

from __future__ import annotations

import ast
import doctest
import importlib
from pathlib import Path

import pytest

import evilengine

PACKAGE = Path(evilengine.__file__).parent


def modules_with_examples() -> list[str]:
    """Modules whose text shows a prompt; found without importing them."""
    found = []
    for file in sorted(PACKAGE.rglob("*.py")):
        docstrings = (
            ast.get_docstring(node) or ""
            for node in ast.walk(ast.parse(file.read_text()))
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
        )
        if any(">>> " in text for text in docstrings):
            dotted = ".".join(("evilengine", *file.relative_to(PACKAGE).with_suffix("").parts))
            found.append(dotted.removesuffix(".__init__"))
    return found


@pytest.mark.parametrize("name", modules_with_examples())
def test_the_examples_in_docstrings_are_true(
    name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)  # an example that saves a file leaves nothing behind
    module = importlib.import_module(name)
    result = doctest.testmod(module, extraglobs={"evil": evilengine}, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert result.failed == 0, capsys.readouterr().out
    assert result.attempted > 0


def test_there_are_examples_to_run() -> None:
    assert len(modules_with_examples()) >= 2
