# SPDX-License-Identifier: Apache-2.0
"""The page on gearboxes: its complete example is read without remarks and runs all load cases."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command

PAGE = (Path(__file__).parents[2] / "docs" / "gearboxes.md").read_text(encoding="utf-8")
MODEL = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)[-1]


def test_the_example_of_the_page_runs_its_load_cases(tmp_path, capsys):
    file = tmp_path / "gearbox.yaml"
    file.write_text(MODEL, encoding="utf-8")
    assert run_command(["check", str(file), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert not found["messages"]
    assert found["housing"]["seats"]["input_1"]["seat"] == "housing"
    assert found["lubricant"]["temperature"] == pytest.approx(333.15)
    out = str(tmp_path / "cases.h5")
    assert run_command(["run", str(file), "-s", "steady", "--load-cases", "-o", out, "--json"]) == 0
    cases = json.loads(capsys.readouterr().out)["cases"]
    assert [case["status"] for case in cases] == ["finished"] * 2
    forces = [case["channels"]["mesh_force[stage]"]["mean"] for case in cases]
    assert forces[1] == pytest.approx(2.5 * forces[0], rel=0.02)
