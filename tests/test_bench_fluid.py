"""`evil bench fluid`: numbers that can be read, and peers that do what a fluid does."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from evilengine.bench import gas, liquid
from evilengine.bench.gas_peers import PEERS
from evilengine.cli import main

BRIEF = ["bench", "fluid", "--steps", "4", "--warm", "3"]
SHORT = [*BRIEF, "--only", "smoke", "--size", "32"]


def test_the_numbers_of_a_small_smoke_are_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "numbers.json"
    assert main([*SHORT, "--threads", "1", "--peer", "NumPy", "--json", str(file)]) == 0
    numbers = json.loads(file.read_text())
    (row,) = numbers["smoke"]
    assert list(row["engines"]) == ["evil fast", "evil high", "Stam in C", "NumPy"]
    assert row["cells"] == 32
    assert row["floor"] > 0
    for one in row["engines"].values():
        assert 0 < one["min"] <= one["median"]
    assert row["engines"]["evil fast"]["times_ours"] == 1
    shown = capsys.readouterr().out
    assert "32 x 32" in shown
    assert "copying as much memory" in shown


def test_threads_stand_beside_one_another() -> None:
    rows, missing = gas.measure([32], gas.Plan(steps=3, warm=2, threads=(1, 2)), [], lambda said: None)
    assert "evil fast, 2 threads" in rows[0]["engines"]
    assert missing == []


def test_the_plume_rises_round_the_ball_and_hardly_anything_gathers() -> None:
    ours = gas.Ours(64, "fast", 1, "ours")
    before, after = ours.divergence()
    assert after < 0.01 * before
    assert ours.smoke.velocity_at((2.0, 0.8)).y > 0.5
    assert len(ours.world.bodies) == 9
    assert sum(body.velocity.length > 0 for body in ours.world.bodies) == 1


@pytest.mark.parametrize("peer", PEERS)
def test_a_peer_moves_smoke_and_takes_some_of_its_divergence_out(peer: str) -> None:
    pytest.importorskip({"NumPy": "numpy", "Taichi": "taichi", "Warp": "warp"}[peer])
    one = PEERS[peer](32)
    for _ in range(20):
        one.prepare()
        one.step()
    before, after = one.divergence()
    assert 0.01 * before < after < 0.95 * before


def test_a_jet_of_arrays_rises_and_stays_in_its_box() -> None:
    one = PEERS["NumPy"](48)
    for _ in range(60):
        one.step()
    middle = one.density[:, 20:28].sum(axis=1)
    assert middle[12] > 0.1, "above the jet"
    assert one.density.sum() == pytest.approx(60 * 4 / 60 * one._jet.sum(), rel=0.3)


def test_a_peer_that_is_not_installed_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "taichi", None)
    assert main([*SHORT, "--threads", "1", "--peer", "Taichi"]) == 0
    said = capsys.readouterr().out
    assert "left out: Taichi (" in said
    assert "pip install 'evilengine[bench-fluid]'" in said


def test_water_and_the_frame_of_a_game_are_timed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "numbers.json"
    assert main([*BRIEF, "--only", "water", "--only", "frame", "--threads", "1", "--json", str(file)]) == 0
    numbers = json.loads(file.read_text())
    assert [round(row["particles"], -3) for row in numbers["water"]] == [10_000, 20_000, 50_000]
    assert all(row["engines"]["evil"]["min"] > 0 for row in numbers["water"])
    assert numbers["frame"]["min"] > 0
    assert "smoke" not in numbers
    shown = capsys.readouterr().out
    assert "ns a particle" in shown
    assert "10,011 particles of water" in shown


def test_a_dam_holds_the_water_it_is_asked_for() -> None:
    dam = liquid.Dam(2000, 1, "dam")
    assert dam.water.count == pytest.approx(2000, rel=0.05)
    assert sum(body.kind == "dynamic" for body in dam.world.bodies) == liquid.BODIES


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--peer", "Taichy"], "did you mean 'Taichi'"),
        (["--json", "no/such/folder/x.json"], "there is no folder"),
        (["--only", "watter"], "did you mean 'water'"),
        (["--only", "water"], "--size is of one part"),
    ],
)
def test_the_command_refuses_what_it_cannot_do(words: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*SHORT, *words]) == 1
    assert said in capsys.readouterr().err
