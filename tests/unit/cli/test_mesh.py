# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint mesh` without a file: the overlap cases of the SIMPACK user meeting 2006."""

from __future__ import annotations

import json

import pytest

from pitchpoint.cli.main import run_command


def mesh_of(arguments: str, capsys: pytest.CaptureFixture[str]) -> dict[str, object]:
    """Run `mesh --json` and return its only mesh."""
    assert run_command(["mesh", "--json", *arguments.split()]) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    (found,) = json.loads(captured.out)["meshes"].values()
    return found


def test_contract_example(capsys: pytest.CaptureFixture[str]) -> None:
    found = mesh_of("--eps-alpha 1.3 --eps-beta 0.85 --stiffness-ratio 0.8 --tip-relief-factor 0", capsys)
    assert found["mean"] == pytest.approx(1.3 * (1 - 0.2 / 3), abs=1e-12)
    assert found["peak_to_peak"] == pytest.approx(0.1408632, abs=1e-6)
    assert found["phase"][0] == 0.0
    assert found["phase"][-1] == 1.0
    assert len(found["phase"]) == len(found["stiffness_ratio"]) == 401
    assert max(found["stiffness_ratio"]) <= found["maximum"] + 1e-12


def test_defaults_are_a_spur_pair_with_stiffness_ratio_08(capsys: pytest.CaptureFixture[str]) -> None:
    found = mesh_of("--eps-alpha 1.3 --points 11", capsys)
    assert found["mean"] == pytest.approx(1.3 * (1 - 0.2 / 3), abs=1e-12)
    assert found["jumps"] == pytest.approx([0.0, 0.3])
    assert len(found["phase"]) == 11


def test_extremes_do_not_depend_on_the_samples(capsys: pytest.CaptureFixture[str]) -> None:
    few = mesh_of("--eps-alpha 1.62 --eps-beta 0.37 --points 2", capsys)
    many = mesh_of("--eps-alpha 1.62 --eps-beta 0.37 --points 2001", capsys)
    assert few["peak_to_peak"] == many["peak_to_peak"]
    samples = many["stiffness_ratio"]
    assert max(samples) - min(samples) == pytest.approx(many["peak_to_peak"], rel=1e-3)


def test_people_get_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["mesh", "--eps-alpha", "1.3"]) == 0
    out = capsys.readouterr().out
    assert "peak to peak" in out
    assert "1.213333" in out
    assert "jumps at the phases 0.0000, 0.3000" in out
