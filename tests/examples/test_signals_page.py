# SPDX-License-Identifier: Apache-2.0
"""The page on signals: its file, its commands, its numbers and its Python are tried as they stand there."""

from __future__ import annotations

import json
import math
import re
import shlex
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.actuator import ACTUATORS
from pitchpoint.model.components.block import BLOCKS
from pitchpoint.model.components.controller import CONTROLLERS
from pitchpoint.model.components.sensor import QUANTITIES, SENSORS
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

TEXT = (Path(__file__).parents[2] / "docs" / "signals.md").read_text(encoding="utf-8")
WORDS = " ".join(TEXT.split())
FILE = re.search(r"^```yaml\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)[1]  # type: ignore[index]
J, KP, KI, STEP = 0.02 + 0.4 / 4.0, 4.0, 50.0, 40.0


def test_commands_run_and_numbers_are_right(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "speed.yaml").write_text(FILE, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    lines = re.findall(r"^pitchpoint (.*)$", TEXT, re.MULTILINE)
    assert len(lines) == 3
    for line in lines:
        assert run_command(shlex.split(line)) == 0, line
    shown = " ".join(capsys.readouterr().out.split())
    root = max(np.roots([J, KP, KI]), key=lambda z: z.imag)
    assert f"{root.real:.2f} ± {root.imag:.2f}i 1/s" in WORDS
    printed = re.search(r"eigenvalues of states \[1/s\]: (\S+) ± (\S+)i", shown)
    assert printed is not None
    # the mesh gives kp |s| over its torsional stiffness: 4 * 20 / 3.2e5
    assert complex(float(printed[1]), float(printed[2])) == pytest.approx(root, rel=2.5e-4)
    assert run_command(["run", "speed.yaml", "--json", "-o", "again.h5"]) == 0
    channels = json.loads(capsys.readouterr().out)["channels"]
    # J e'' + kp e' + ki e = 0 after the step: e = M/(J b) exp(-a t) sin(b t)
    a, b = -root.real, root.imag
    at = math.atan2(b, a) / b
    lowest = 1000.0 - STEP / (J * b) * math.exp(-a * at) * math.sin(b * at) * 30.0 / math.pi
    assert f"falls to {lowest:.0f} rpm" in WORDS
    # a load that rises over 1 ms, and a vibration of the pair beside it
    assert channels["signal[speed]"]["min"] * 30.0 / math.pi == pytest.approx(lowest, abs=0.3)


def test_where_the_integral_begins() -> None:
    system = compile_model(loads_model(FILE), "step")
    start = prepare_start(system, system.scenario)  # type: ignore[arg-type]
    row = evaluate.observe(start.system, start.state)
    assert row[system.layout.channel("signal[wanted]")] == pytest.approx(20.0, rel=1e-9)
    assert "`wanted` begins at 20 N m" in WORDS
    assert start.notes == ()


def test_the_tables_are_complete() -> None:
    forms = set(re.findall(r"^\| `(\w+)` \|", TEXT.split("## In Python")[0], re.MULTILINE))
    assert forms == {*SENSORS, *BLOCKS, *ACTUATORS, *CONTROLLERS}
    assert all(f"`{quantity}`" in TEXT for quantity in QUANTITIES)


def test_the_python_of_the_page() -> None:
    code = re.search(r"^```python\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)
    assert code is not None
    names: dict = {}
    exec(code[1], names)
    assert names["system"].controllers[0].name == "loop"
