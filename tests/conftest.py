"""What every test begins with."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def saves_of_its_own(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> None:
    """No test reads or writes the saved games of whoever runs it."""
    monkeypatch.setenv("EVILENGINE_SAVES", str(tmp_path_factory.getbasetemp() / "saves"))
