# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint compare-solvers`: table, JSON and page."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from tests.support.cli_files import TORSION, json_of, written

TEXT = TORSION.replace("duration: 0.5 s", "duration: 5 ms")


def test_json_and_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "page.html"
    found = json_of(["compare-solvers", written(tmp_path, TEXT), "-s", "steady", "-o", str(page)], capsys)
    assert found["status"] == "finished"
    assert found["reference"] == "wstiff with tolerance 1e-09"
    assert {run["method"] for run in found["runs"]} >= {"gstiff", "generalized_alpha", "rk4"}
    for run in found["runs"]:
        assert run["status"] == "finished"
        assert run["error"] < 1.0
        assert run["steps"] > 0
    text = page.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "processor time" in text
    assert "gstiff" in text


def test_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["compare-solvers", written(tmp_path, TEXT), "-s", "steady"]) == 0
    printed = capsys.readouterr().out
    assert "constant_bdf" in printed
    assert "tolerance 1e-06" in printed
    assert "error against wstiff with tolerance 1e-09" in printed


def test_a_sweep_is_no_time_response(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = TEXT + "  roll: {quasi_static: {points: 2}}\n"
    assert run_command(["compare-solvers", written(tmp_path, text), "-s", "roll"]) == 2
    assert "kind" in capsys.readouterr().err
