"""The core's type stubs say what the compiled core has: no name less, no name more."""

from __future__ import annotations

import ast
from pathlib import Path

import evilengine
from evilengine import _core

STUBS = Path(evilengine.__file__).with_name("_core.pyi")


def stubbed_names(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    """Public names that a module's or a class's body defines."""
    names: dict[str, ast.stmt] = {}
    for node in body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            names[node.name] = node
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names[node.target.id] = node
        elif isinstance(node, ast.Assign):
            names.update({target.id: node for target in node.targets if isinstance(target, ast.Name)})
    return {name: node for name, node in names.items() if not name.startswith("_")}


def test_the_stubs_name_what_the_core_has() -> None:
    stubbed = stubbed_names(ast.parse(STUBS.read_text()).body)
    assert set(stubbed) == {name for name in vars(_core) if not name.startswith("_")}
    classes = {name: node for name, node in stubbed.items() if isinstance(node, ast.ClassDef)}
    assert set(classes) == {name for name, value in vars(_core).items() if isinstance(value, type)}
    for name, node in classes.items():
        members = {member for member in vars(getattr(_core, name)) if not member.startswith("_")}
        assert set(stubbed_names(node.body)) == members, f"of _core.{name}"


def test_every_function_of_the_core_has_types() -> None:
    functions = [node for node in ast.walk(ast.parse(STUBS.read_text())) if isinstance(node, ast.FunctionDef)]
    untyped = [
        node.name
        for node in functions
        if node.returns is None
        or any(a.annotation is None for a in [*node.args.posonlyargs, *node.args.args] if a.arg != "self")
    ]
    assert untyped == []
