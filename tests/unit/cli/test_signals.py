# SPDX-License-Identifier: Apache-2.0
"""Controlled machines on the command line: exit codes, partial results, cases, pages."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.reading import open_result, read_header
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.remarks.keys_without_effect import keys_without_effect
from tests.support.cli_files import json_of

ROTOR = """\
title: rotor with a speed loop
bodies: {rotor: {motion: torsion, inertia: 0.5 kg m^2}}
sensors: {speed: {type: joint, coordinate: rotor, derivative: 1}}
blocks:
  error: {type: sum, inputs: {speed: -1}, offset: 3 rad/s, unit: rad/s}
  seen: {type: python, input: error, function: 'laws.py:seen', parameters: [1]}
controllers:
  loop: {type: python, function: 'laws.py:loop', inputs: [seen], outputs: [u], period: 20 ms, unit: N m,
    parameters: [4, 0]}
actuators: {motor: {type: torque, signal: u, bodies: [rotor]}}
scenarios: {run: {duration: 0.4 s, step: 1 ms, settle_time: 0 s, sample_rate: 1 kHz}}
"""
LAWS = """\
def seen(t, x, p):
    return p[0] * x if t < 0.25 or p[0] > 0.0 else float("nan")


def loop(t, inputs, state, parameters):
    gain, fault = parameters
    if t > 0.1 and fault == 1.0:
        raise RuntimeError("sensor lost")
    return gain * inputs[0] if t < 0.1 or fault < 2.0 else float("nan")
"""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "laws.py").write_text(LAWS, encoding="utf-8")
    (tmp_path / "rotor.yaml").write_text(ROTOR, encoding="utf-8")
    return tmp_path / "rotor.yaml"


def test_check_and_results_show_the_signals(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["check", str(file), "--allow-code"], capsys)
    assert [line["signal"] for line in found["signals"]] == ["speed", "error", "seen", "u", "motor"]
    assert found["signals"][1] == {
        "signal": "error",
        "what it is": "block: sum",
        "made of": "speed",
        "read by": "seen",
    }
    done = json_of(["run", str(file), "--allow-code", "-o", "out.h5"], capsys)
    assert done["channels"]["signal[u]"]["unit"] == "N m"
    assert done["channels"]["signal[speed]"]["unit"] == "rad/s"
    with open_result("out.h5") as data:
        assert data["signal[error]"].attrs["units"] == "rad/s"
        # a held torque u = 4 e over 20 ms: e falls by the factor 1 - 4*0.02/0.5
        # (files hold single precision)
        np.testing.assert_allclose(data["signal[error]"][::20], 3.0 * 0.84 ** np.arange(21), rtol=1e-7)


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("1", "controllers.loop (line 8) raised RuntimeError: sensor lost (t = 0.12 s, laws.py, line 8)"),
        ("2", "controllers.loop (line 8) returned nan for 'u' (t = 0.1 s)"),
    ],
)
def test_a_controller_that_fails(
    file: Path, capsys: pytest.CaptureFixture[str], fault: str, said: str
) -> None:
    file.write_text(ROTOR.replace("[4, 0]", f"[4, {fault}]"), encoding="utf-8")
    assert run_command(["run", str(file), "--allow-code", "-o", "out.h5"]) == 3
    error = capsys.readouterr().err
    assert said in error
    assert "partial results are in out.h5" in error
    assert "Traceback" not in error
    header = read_header("out.h5")
    assert header["status"] == "failed"
    with open_result("out.h5") as data:
        assert float(data["time"][-1]) >= 0.099
        assert bool(np.isfinite(data["signal[speed]"]).all())


def test_a_block_that_returns_nan(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file.write_text(ROTOR.replace("parameters: [1]}", "parameters: [-1]}"), encoding="utf-8")
    assert run_command(["run", str(file), "--allow-code", "-o", "out.h5"]) == 3
    error = capsys.readouterr().err
    assert "laws.py:seen returned nan" in error
    assert "blocks.seen (line 6)" in error
    with open_result("out.h5") as data:
        assert float(data["time"][-1]) == pytest.approx(0.249, abs=2e-3)


def test_without_permission_nothing_runs(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (file.parent / "laws.py").write_text("raise SystemExit(5)\n", encoding="utf-8")
    assert run_command(["run", str(file)]) == 2
    assert "controllers.loop.function (line 8)" in capsys.readouterr().err


def test_cases_over_gains_and_periods(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pid = ROTOR[: ROTOR.index("controllers:")].replace("  seen: {type: python", "  skip: {type: python")
    pid = "\n".join(line for line in pid.splitlines() if "skip" not in line)
    pid += "\n  u: {type: pid, input: error, proportional: 4}\n" + ROTOR[ROTOR.index("actuators:") :]
    file.write_text(pid, encoding="utf-8")
    varied = ["run", str(file), "--vary", "blocks.u.proportional=2,4", "-o", "cases.h5", "--jobs", "1"]
    found = json_of(varied, capsys)
    ends = [case["channels"]["signal[error]"]["min"] for case in found["cases"]]
    # generalised-alpha of second order: 3.2 time constants times (8 1/s * 1 ms)^2/12
    np.testing.assert_allclose(ends, 3.0 * np.exp(-np.array([2.0, 4.0]) * 0.4 / 0.5), rtol=5e-5)


def test_a_page_lists_the_signals(file: Path) -> None:
    assert run_command(["run", str(file), "--allow-code", "-o", "out.h5", "-q"]) == 0
    assert run_command(["report", str(file), "out.h5", "--allow-code", "-o", "page.html", "-q"]) == 0
    page = Path("page.html").read_text(encoding="utf-8")
    assert "Signals and control" in page
    assert "controller loop (python), every 20 ms" in page


def test_idle_keys_are_told(file: Path) -> None:
    text = ROTOR.replace("signal: u,", "signal: error,")
    text = text.replace(
        "  seen:", "  p: {type: pid, input: error, proportional: 1, filter_time: 1 ms}\n  seen:"
    )
    file.write_text(text, encoding="utf-8")
    said = keys_without_effect(load_model(file, allow_code=True))
    assert "controllers.loop.output: nothing reads u: it is only recorded" in said
    assert "blocks.p.filter_time: has no effect without derivative" in said


def test_replace(file: Path) -> None:
    model = load_model(file, allow_code=True)
    changed = model.replace_all(
        {
            "blocks.error.inputs.speed": "-2",
            "blocks.error.offset": "60 rpm",
            "controllers.loop.period": "5 ms",
            "controllers.loop.parameters": [5, 0],
            "actuators.motor": {
                "type": "force",
                "signal": "u",
                "ends": ["rotor", "ground"],
                "quantity": "moment",
            },
            "blocks.seen": {"type": "filter", "input": "error", "time_constant": "1 ms"},
        }
    )
    assert changed.blocks["error"].inputs == {"speed": -2.0}
    assert changed.blocks["error"].offset == pytest.approx(2.0 * np.pi)
    assert changed.controllers["loop"].period == 0.005
    assert changed.actuators["motor"].form == "force"
    assert changed.blocks["seen"].form == "filter"
    function = model.replace("controllers.loop.function", "laws.py:loop").controllers["loop"].function
    assert function == model.controllers["loop"].function
    with pytest.raises(ModelError, match=r"blocks.seen.type: is missing"):
        model.replace("blocks.seen", {"input": "error"})
    with pytest.raises(ModelError, match="names the signal 'seen', which does not exist"):
        model.replace("blocks.seen", None)
    with pytest.raises(ModelError, match=r"controllers.loop.period: -1.0? is out of range"):
        model.replace("controllers.loop.period", -1.0)


def test_json_schema_knows_the_forms() -> None:
    from pitchpoint.model.reference import reference_page
    from pitchpoint.model.schema import json_schema

    found = json_schema()
    forms = found["properties"]["blocks"]["additionalProperties"]["oneOf"]
    assert {"$ref": "#/$defs/Pid"} in forms
    assert found["$defs"]["Pid"]["properties"]["type"] == {"const": "pid"}
    assert "type" in found["$defs"]["Pid"]["required"]
    assert "`type: transfer_function`" in reference_page()
    assert json.dumps(found)
