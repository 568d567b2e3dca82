"""`evil bench draw`: the same sprites for everybody, and numbers that can be read."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from evilengine.bench.crowd import crowd
from evilengine.cli import main


def test_the_numbers_of_a_small_crowd_are_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "numbers.json"
    assert main(["bench", "draw", "--size", "20", "--steps", "2", "--peer", "none", "--json", str(file)]) == 0
    numbers = json.loads(file.read_text())
    rows = numbers["draw"]
    assert all(0 < seconds < 60 for seconds in numbers["first_frame"].values())
    assert [row["scene"] for row in rows] == [
        "turning", "straight", "8 lights, low", "8 lights, medium", "8 lights, high", "particles"
    ]  # fmt: skip
    assert all(row["engines"]["evil soft"]["min"] > 0 and row["before_the_driver"] > 0 for row in rows)
    assert "evil soft" in capsys.readouterr().out


def test_everybody_draws_the_same_crowd() -> None:
    assert crowd(50, turning=True) == crowd(50, turning=True)
    assert all(each.spin == 0 for each in crowd(50, turning=False))
