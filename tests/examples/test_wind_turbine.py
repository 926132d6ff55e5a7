# SPDX-License-Identifier: Apache-2.0
"""The example `wind-turbine`: loads of OpenFAST, and the numbers of its page from a short run.

OpenFAST, NREL 5 MW with elastic blades at 8 m/s and 9.1311 rpm: aerodynamic thrust 379.511 kN, torque 1946.90
kN m (welib, data/NREL5MW/NREL5MW_Oper.csv, MIT).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "wind-turbine"


@pytest.fixture(scope="module")
def model():
    return load_model(FOLDER / "model.yaml")


def observed(system, state):
    row = evaluate.observe(system, state)
    return lambda name: float(row[system.layout.channel(name)])


def test_loads_at_8_m_per_s_are_those_of_openfast(model):
    """Equilibrium of the rotating turbine in uniform wind, to 1.5 %, with the blades bent by 3 m."""
    changes = {
        "winds.steady.profile": "uniform",
        "scenarios.production.speed": {"hub": "9.1311 rpm"},
    }
    system = compile_model(model.replace_all(changes), "production")
    begin = prepare_start(system, system.scenario)
    value = observed(begin.system, begin.state)
    assert value("rotor_thrust[rotor]") == pytest.approx(379.511e3, rel=0.015)
    assert value("rotor_torque[rotor]") == pytest.approx(1946.90e3, rel=0.015)
    assert value("displacement[tip_1.x]") == pytest.approx(3.1, abs=0.2)
    # weight and thrust, see tests/validation/test_wind_turbine_matrix.py, and the moment of the air
    assert value("displacement[tower_top.x]") == pytest.approx(0.209, abs=0.005)


@pytest.mark.parametrize("step", [0.02, 0.005])
def test_the_turbine_runs_with_its_controller(model, step):
    """Two seconds from the operating point: the speed remains, the servos hold the pitch."""
    changes = {
        "scenarios.production.duration": 2.0,
        "scenarios.production.settle_time": 0.0,
        "scenarios.production.step": step,
    }
    system, memory = compile_model(model.replace_all(changes), "production"), Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    rows = np.concatenate(memory.rows)
    speed, pitch = (rows[:, system.layout.channel(c)] for c in ("speed[hub]", "signal[pitch_1]"))
    assert np.ptp(speed) < 0.01 * speed.mean()
    assert np.abs(pitch).max() < 0.01


def test_the_page_on_wind_turbines_has_a_model_that_runs():
    """The first model of docs/howto/wind_turbine.md settles at the speed that the page states."""
    page = (FOLDER.parents[1] / "docs" / "howto" / "wind_turbine.md").read_text(encoding="utf-8")
    text = page.split("```yaml\n")[1].split("```")[0]
    text = text.replace("AeroDyn.dat", str(FOLDER / "nrel_5mw" / "onshore" / "AeroDyn.dat"))
    system, memory = compile_model(loads_model(text), "run"), Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    speed = np.concatenate(memory.rows)[-500:, system.layout.channel("speed[hub]")].mean() * 30.0 / np.pi
    assert f"settles at {speed:.1f} rpm" in page


def test_the_python_of_the_page_runs(tmp_path, monkeypatch, capsys):
    """Modes in multi-blade coordinates, with coarse blades: edgewise whirls are two turns apart."""
    page = (FOLDER.parents[1] / "docs" / "howto" / "wind_turbine.md").read_text(encoding="utf-8")
    code = page.split("```python\n")[1].split("```")[0]
    text = (FOLDER / "model.yaml").read_text(encoding="utf-8").replace("pieces: 16", "pieces: 4")
    (tmp_path / "model.yaml").write_text(text.replace("nrel_5mw", str(FOLDER / "nrel_5mw")), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    found: dict = {}
    exec(code, found)
    assert "damping_ratio" in capsys.readouterr().out
    modes = found["modes"]
    edge = modes.frequency.values[(modes.frequency > 0.85) & (modes.frequency < 1.3)]
    assert len(edge) == 2
    assert edge[1] - edge[0] == pytest.approx(2.0 * 0.1517, rel=0.02)
