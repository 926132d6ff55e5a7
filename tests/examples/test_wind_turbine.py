# SPDX-License-Identifier: Apache-2.0
"""The example `wind-turbine`: loads of OpenFAST, and the numbers of its page from a short run.

OpenFAST, NREL 5 MW with elastic blades at 8 m/s and 9.1311 rpm: aerodynamic thrust 379.511 kN, torque 1946.90
kN m (welib, data/NREL5MW/NREL5MW_Oper.csv, MIT).
"""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.report.fatigue import LoadCases, fatigue_loads
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
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


TRAINS = ("two_mass", "rigid_ratio", "gearbox")


@pytest.fixture(scope="module")
def trains():
    """Model, system and channels of the rotating equilibrium at 8 m/s, by drive train."""
    found = {}
    for train in TRAINS:
        model = load_model(FOLDER / "model.yaml", changes={"include": f"{train}.yaml"})
        system = compile_model(model, "production")
        begin = prepare_start(system, system.scenario)
        found[train] = model, begin.system, observed(begin.system, begin.state)
    return found


@pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
@pytest.mark.parametrize("train", TRAINS[1:])
def test_drive_trains_have_the_same_rotor_and_reaction(trains, train):
    """Wind loads and moments of the tower do not depend on the drive train: rings take the reaction."""
    value, other = trains["two_mass"][2], trains[train][2]
    for name in ("rotor_thrust[rotor]", "rotor_torque[rotor]", "displacement[tip_1.x]"):
        assert other(name) == pytest.approx(value(name), rel=1e-4), name
    torque = value("rotor_torque[rotor]")
    for moment in ("mx", "my"):
        name = f"beam_force[tower.1.i.{moment}]"
        assert other(name) == pytest.approx(value(name), abs=4e-3 * torque), name


@pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
def test_tooth_forces_carry_the_torque_of_the_rotor(trains):
    """KISSsoft reports: 829.5 kN and 255.9 kN for 3946 kN m, forces in proportion to the torque, 0.2 %.

    The excess of the torque of the wind, 0.3 %, is held at the carrier of stage 1.
    """
    value = trains["gearbox"][2]
    share = value("signal[generator_torque]") * 96.354167 / 3945.99e3
    sun = np.mean([abs(value(f"mesh_force[sun_1-planet_{k}]")) for k in (1, 2, 3)])
    assert sun == pytest.approx(829.5e3 * share, rel=2e-3)
    assert abs(value("mesh_force[stage_3]")) == pytest.approx(255.9e3 * share, rel=2e-3)
    torque = value("coupling_force[generator_coupling.mz]")
    assert torque == pytest.approx(value("signal[generator_torque]"), rel=1e-6)
    assert value("rotor_torque[rotor]") == pytest.approx(torque * 96.354167, rel=4e-3)


@pytest.mark.study
@pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
def test_first_torsional_frequency_with_the_gearbox():
    """Generator locked: 0.6205 Hz by FAST, 0.6094 Hz by ADAMS (NREL/TP-500-38060), ours between, to 0.5 %."""
    model = load_model(FOLDER / "model.yaml", changes={"include": "gearbox.yaml"})
    found = find_modes(compile_model(model, "parked"))
    shaft = next(k for k, name in enumerate(found.elements) if "main_shaft" in name)
    frequency = found.frequency[np.argmax(found.potential[:, shaft] * (found.frequency < 1.5))]
    assert 0.6094 * 0.995 < frequency < 0.6205 * 1.005


@pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
def test_loads_of_teeth_and_blades_from_a_run(trains):
    """Half a second at 8 m/s: every tooth of the pinion meshes, with the mean force of the torque."""
    import pitchpoint

    model = trains["gearbox"][0]
    changes = {"duration": 0.5, "settle_time": 0.2}
    model = model.replace_all({f"scenarios.production.{key}": value for key, value in changes.items()})
    run = pitchpoint.solve_time(pitchpoint.compile_model(model, "production"))
    found = fatigue_loads(LoadCases(model, [run], [None]))
    pinion = found["teeth"]["pinion_3"]["front"]
    assert min(pinion["pulses"]) >= 3 and 60e3 < max(pinion["largest"]) < 125e3
    assert "beam_force[blade_1.1.i.my]" in found["channels"] and "samples per mesh" in found["notes"][0]


def test_scenarios_stop_the_turbine(model):
    """Loss of the grid: the torque vanishes, the speed rises, the demand feathers at 8 deg/s.

    The blades follow with the deflection of their drives, within 1 %.
    """
    changes = {
        "scenarios.grid_loss.inputs.connected.points": [[0.5, 1.0], [0.52, 0.0]],
        "scenarios.grid_loss.inputs.feathering.points": [[1.0, 0.0], [1.02, 1.57]],
        "scenarios.grid_loss.duration": 2.0,
    }
    system, memory = compile_model(model.replace_all(changes), "grid_loss"), Memory()
    done = run_time(system, sink=memory)
    assert done.status == 1, done.sentence
    rows = np.concatenate(memory.rows)
    torque, speed, demand, pitch = (
        rows[:, system.layout.channel(c)]
        for c in ("signal[generator_torque]", "speed[hub]", "signal[pitch]", "signal[pitch_1]")
    )
    assert torque[20] == pytest.approx(-4.02e6, rel=0.05) and torque[-1] == 0.0
    assert speed[-1] > 1.05 * speed[25]
    assert demand[-1] - demand[-26] == pytest.approx(np.radians(4.0), rel=1e-10)
    assert pitch[-1] - pitch[-26] == pytest.approx(np.radians(4.0), rel=0.01)


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
    shutil.copy(FOLDER / "two_mass.yaml", tmp_path)
    monkeypatch.chdir(tmp_path)
    found: dict = {}
    exec(code, found)
    assert "damping_ratio" in capsys.readouterr().out
    modes = found["modes"]
    edge = modes.frequency.values[(modes.frequency > 0.85) & (modes.frequency < 1.3)]
    assert len(edge) == 2
    assert edge[1] - edge[0] == pytest.approx(2.0 * 0.1517, rel=0.02)
