# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint contact --shafts` with several meshes: table, JSON, result file, page, failures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.progress import silent
from pitchpoint.core.status import DIVERGED
from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.collect import collect
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from tests.support.cli_files import json_of, written
from tests.support.contact_trains import two_stages
from tests.unit.cli.test_contact import MODEL

SHORT = ["--shafts", "--positions", "4"]


@pytest.fixture
def file(tmp_path: Path) -> str:
    return written(tmp_path, two_stages())


def test_a_row_per_mesh_and_flanks_of_all_gears(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["contact", file, *SHORT]) == 0
    text = capsys.readouterr().out
    rows = [line.split()[0] for line in text.splitlines() if " N m " in line]
    assert rows == ["fast", "slow"]
    gears = [line.split()[:2] for line in text.splitlines() if line.count(" deg ") >= 2]
    assert gears == [["fast", "z1"], ["fast", "z2"], ["slow", "z3"], ["slow", "z4"]]
    for words in ("misalignment", "K_Hβ", "d, root side", "fast: level flexible", "shafts in equilibrium"):
        assert words in text


def test_json_by_mesh(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Each entry is the JSON of the mesh alone."""
    every = json_of(["contact", file, *SHORT], capsys)
    assert (every["status"], every["omitted"], every["failed"]) == ("finished", {}, {})
    assert list(every["meshes"]) == ["fast", "slow"]
    alone = json_of(["contact", file, *SHORT, "--mesh", "slow"], capsys)
    assert every["meshes"]["slow"].items() <= alone.items()
    assert list(json_of(["contact", file, *SHORT, "-m", "slow", "-m", "fast"], capsys)["meshes"]) == [
        "slow",
        "fast",
    ]


def test_files_hold_all_meshes(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    target, page = tmp_path / "c.h5", tmp_path / "c.html"
    found = json_of(["contact", file, *SHORT, "-o", str(target), "--picture", str(page)], capsys)
    header = read_header(target)
    assert (header["kind"], header["status"]) == ("contact", "finished")
    assert header["options"] == {"meshes": ["fast", "slow"], "omitted": {}}
    for mesh, one in found["meshes"].items():
        with open_result(target, f"meshes/{mesh}") as data:
            assert data["transmission_error"].values.tolist() == one["curves"]["transmission_error"]
            assert data["line_load"].attrs["symbol"] == "w"
    text = page.read_text(encoding="utf-8")
    for words in ("All meshes", 'id="mesh1"', 'id="mesh2"', "position over the common face width"):
        assert words in text
    # the report of gears without bodies takes less time; it is another machine, which a report refuses
    monkeypatch.setattr("pitchpoint.report.same_machine.require_same_machine", lambda *_: None)
    gears = MODEL[: MODEL.index("bodies:")] + MODEL[MODEL.index("meshes:") : MODEL.index("loads:")]
    shown, _ = collect(load_model(written(tmp_path, gears, "gears.yaml")), [target], silent)
    assert list(shown.contacts) == ["fast", "slow"]
    assert np.isfinite(shown.contacts["slow"].numbers["face_load_factor"]).all()


def test_a_mesh_that_fails(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    solve = FlankStates.solve

    def failing(self: FlankStates, states: np.ndarray, keep_nodes: bool = False) -> np.ndarray | None:
        nodes = solve(self, states, keep_nodes)
        if self.mesh == "fast":
            states["status"][3] = DIVERGED
        return nodes

    monkeypatch.setattr(FlankStates, "solve", failing)
    target = tmp_path / "c.h5"
    assert run_command(["contact", file, *SHORT, "-o", str(target), "--json"]) == 3
    captured = capsys.readouterr()
    assert "mesh fast: the Newton iteration diverged" in captured.err
    assert '"fast": "the Newton iteration diverged"' in captured.out
    header = read_header(target)
    assert (header["status"], header["options"]["meshes"]) == ("failed", ["slow"])


def test_a_mesh_with_a_stiffness_law_is_omitted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, two_stages("stiffness: {law: din3990}"))
    assert run_command(["contact", file, *SHORT]) == 0
    text = capsys.readouterr().out
    assert "note: mesh fast is omitted: it has a stiffness law; give the mesh `contact:" in text


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["-m", "fast", "-m", "slow"], "several --mesh require --shafts"),
        (["--shafts", "--speed", "5 rpm"], "--speed is that of gear 1 of one mesh, and there are 2"),
        (["--shafts", "-m", "fas"], "did you mean fast?"),
    ],
)
def test_what_it_refuses(
    options: list[str], words: str, file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command(["contact", file, *options]) == 2
    assert words in capsys.readouterr().err
