# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram and modes of the example turbine with few beam pieces: orders, whirl, names, components.

Names and order: NREL/TP-500-38060, table 9-1. Pitch at 15 m/s: table 7-1 there, 10.45 deg.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers import linear_system, speed_states, wind_campbell
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.campbell_dataset import campbell_dataset
from pitchpoint.solvers.linear_system import linearise, rates_of
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.multiblade import find_multiblade_modes
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.wind_campbell import solve_wind_campbell
from pitchpoint.solvers.wind_states import Operation, WindStates, _Trial
from pitchpoint.system.compile import compile_model
from tests.support.rotors import FOLDER

COARSE = {f"beams.blade_{k}.pieces": 5 for k in (1, 2, 3)} | {"beams.tower.pieces": 4}
RPM = math.pi / 30.0
SPEEDS = np.array([0.0, 6.0, 9.1, 14.0]) * RPM
BLADES = ["blade_1", "blade_2", "blade_3"]


def turbine(scenario: str, **changes):
    """The example turbine with coarse beams."""
    model = load_model(FOLDER.parent / "model.yaml", changes=changes or None).replace_all(COARSE)
    return compile_model(model, scenario)


@pytest.fixture(scope="module")
def production():
    """System and linear system in production."""
    system = turbine("production")
    return system, linearise(system, "production")


@pytest.fixture(scope="module")
def diagram(production):
    """Modes over the speed, and their dataset."""
    system, linear = production
    found = follow_modes(system, SPEEDS, "hub", "production", linear=linear, count=10)
    return found, campbell_dataset(system, found)


def test_modes_of_the_parked_turbine_have_the_names_of_the_field():
    system = compile_model(load_model(FOLDER.parent / "model.yaml"), "parked")
    modes = find_modes(system, "parked", count=12)
    assert list(modes.names[:11]) == [
        "1st tower side-to-side",
        "1st tower fore-aft",
        "drive-train torsion",
        "1st flapwise (yaw)",
        "1st flapwise (tilt)",
        "1st flapwise (collective)",
        "1st edgewise (vertical)",
        "1st edgewise (horizontal)",
        "2nd flapwise (yaw)",
        "2nd flapwise (tilt)",
        "2nd flapwise (collective)",
    ]


@pytest.mark.parametrize("stiffer", [0.1, 1.0])
def test_torsion_of_the_drive_train_has_one_name(stiffer):
    """Whether most of the strain is in the shaft or in the blades; gearboxes make the train softer."""
    stiffness = {"torsion_springs.shaft.stiffness": f"{8.67637e8 * stiffer} N m/rad"}
    system = turbine("production", include="rigid_ratio.yaml", **stiffness)
    modes = find_multiblade_modes(system, "production", hub="hub", blades=BLADES, azimuths=1)
    at = modes.names.index("drive-train torsion")
    mostly = max(modes.strain[at], key=modes.strain[at].get)
    assert mostly == ("blades of rotor" if stiffer == 1.0 else "coupling shaft")


def in_other_units(linear, factor):
    """The linear system with states that are larger by a factor."""
    own, other = list(linear.states), np.ones(len(linear.D))
    other[own] = factor

    def scaled(A):
        return A * other[:, None] / other

    at_rest = replace(linear.at_rest, M=scaled(linear.at_rest.M), K=scaled(linear.at_rest.K))
    return replace(linear, D=scaled(linear.D), K=scaled(linear.K), at_rest=at_rest)


@pytest.mark.parametrize("large", [False, True])
def test_eigenvalues_of_states_do_not_depend_on_units(production, monkeypatch, large):
    """All are found, of large systems up to a stated value; filter 2 pi 0.25 Hz, rate limit 1/0.1 s."""
    if large:
        for name, value in (("MAX_MODES", 1), ("SPARSE", 2.0), ("DENSE", 0)):
            monkeypatch.setattr(linear_system, name, value)
    _, linear = production
    one, two = (
        linear_system.damped_modes(system, linear_system.lowest(system, 12), complete=True)
        for system in (linear, in_other_units(linear, 1e3))
    )
    assert one.reach == (pytest.approx(two.reach) if large else math.inf)
    np.testing.assert_allclose(two.states, one.states, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(two.values[1:], one.values[1:], rtol=1e-6)
    assert len(one.states) == len(linear.states) == 4
    assert one.states[[0, 3]] == pytest.approx([0.0, -10.0], rel=1e-3, abs=1e-9)
    assert one.states[2].real == pytest.approx(-math.tau * 0.25, rel=0.1)


def test_all_eigenvalues_are_modes_or_of_states(production):
    """The spectrum of the matrices of first order, which has two eigenvalues for each mode."""
    _, linear = production
    found = linear_system.damped_modes(linear, linear_system.lowest(linear, 10**6))
    basis, own = np.asarray(linear.basis), list(linear.states)
    n = basis.shape[1]
    M, D, K = linear.at_rest.M, linear.D, linear.K
    free = np.hstack([basis, np.eye(len(M))[:, own]])
    m, d, k = (free.T @ A @ free for A in (M, D, K))
    rates = -np.linalg.solve(m, np.hstack([k[:, :n], d]))
    spectrum = np.linalg.eigvals(np.vstack([np.eye(n, 2 * n + len(own), n), rates]))
    listed = np.concatenate([found.values, found.values.conj(), found.states, found.states.conj()])
    missing = [x for x in spectrum if np.abs(listed - x).min() > 1e-4 * abs(x) + 1e-3]
    assert np.abs(np.imag(missing)).max() < 1e-6 * np.abs(missing).max()  # second ones of overdamped modes
    pairs = int(np.sum(found.states.imag > 0.0))
    overdamped = int(np.sum(found.values.imag == 0.0))
    assert len(missing) <= overdamped
    assert len(found.states) + pairs == len(own)


def test_strain_energy_is_that_of_whole_components(diagram):
    found, data = diagram
    components = list(data["component"].values)
    assert {"beam tower", "blades of rotor", "air on rotor", "actuator servo_torque_1"} <= set(components)
    assert not [name for name in components if "link" in name or name[-1:].isdigit() and "." in name]
    tower = found.names.index("1st tower side-to-side")
    assert found.energies[0].strain[tower, components.index("beam tower")] > 0.9
    assert "tower" in data["part"].values and "blades of rotor" in data["part"].values


def test_orders_are_those_of_the_blades(diagram):
    _, data = diagram
    orders = dict(zip(data["excitation"].values.tolist(), data["excitation_order"].values, strict=True))
    assert orders == pytest.approx({"1P": 1.0, "3P": 3.0, "6P": 6.0, "9P": 9.0})
    assert set(data["excitation_kind"].values.tolist()) == {"shaft", "blades"}
    assert "blade passing" in data["crossing_source"].values


def test_edgewise_whirl_differs_by_twice_the_speed(diagram):
    """f0 + Omega/2 pi and f0 - Omega/2 pi; the support bends little. At one azimuth: 0.01 Hz apart."""
    found, _ = diagram
    ahead, back = (found.names.index(f"1st edgewise ({way})") for way in ("forward", "backward"))
    apart = found.frequency[:, ahead] - found.frequency[:, back]
    assert apart[1:] == pytest.approx(SPEEDS[1:] / math.pi, rel=0.03)
    assert found.frequency[0, ahead] == pytest.approx(found.frequency[0, back], rel=0.02)
    names = set(found.names)
    assert {f"1st flapwise ({way})" for way in ("forward", "backward", "collective")} <= names


def test_a_turbine_in_operation_is_stable_at_all_speeds(diagram):
    found, data = diagram
    assert data.sizes["unstable"] == 0
    assert found.rotors == ("rotor",) and data.attrs["multiblade"] == "rotor"
    assert not [text for text in found.notes if "one position" in text]


def test_multiblade_modes_and_diagram_agree(production, diagram):
    """Three and five azimuths: the flow around the tower has many harmonics."""
    system, _ = production
    modes = find_multiblade_modes(system, "production", hub="hub", blades=BLADES, azimuths=5)
    found, _ = diagram
    for name in ("1st tower fore-aft", "1st flapwise (forward)", "1st edgewise (backward)"):
        one = modes.frequency[modes.names.index(name)]
        assert found.frequency[2, found.names.index(name)] == pytest.approx(one, rel=3e-3), name


def test_the_whole_train_turns_with_the_rotor(production):
    system, linear = production
    rates = rates_of(linear, "hub", "production")
    states = speed_states.SpeedStates(linear, rates)
    _, turned = states.turned(linear.state, states.operating, 0.6)
    for body in ("hub", "generator"):
        spin = system.spin(body)
        assert turned.q[spin] - linear.state.q[spin] == pytest.approx(0.6, abs=1e-2), body


def without_equilibrium(monkeypatch, low: float, high: float) -> None:
    """No equilibrium at speeds of the hub in a range."""
    solve = speed_states.find_equilibrium

    def find(system, start, *more, **options):
        speed = abs(float(start.v[system.spin("hub")]))
        if low < speed < high:
            raise SolverError("the blades have no equilibrium", 3)
        return solve(system, start, *more, **options)

    monkeypatch.setattr(speed_states, "find_equilibrium", find)


def test_a_speed_without_equilibrium_is_left_out(production, monkeypatch):
    system, linear = production
    without_equilibrium(monkeypatch, 5.0 * RPM, 7.0 * RPM)
    found = follow_modes(system, SPEEDS, "hub", "production", linear=linear, count=4)
    assert found.speed == pytest.approx(SPEEDS[[0, 2, 3]])
    assert found.frequency.shape == (3, 4)
    assert list(found.omitted) == [pytest.approx(6.0 * RPM)]
    notes = campbell_dataset(system, found).attrs["notes"]
    assert "no equilibrium at 6 rpm of hub, this speed is omitted: the blades have no equilibrium" in notes


def test_a_diagram_without_any_equilibrium_is_an_error(production, monkeypatch):
    system, linear = production
    without_equilibrium(monkeypatch, -1.0, 100.0)
    with pytest.raises(SolverError, match="the blades have no equilibrium"):
        follow_modes(system, SPEEDS[1:2], "hub", "production", linear=linear, count=4)


def test_the_command_keeps_the_other_speeds(monkeypatch, capsys):
    without_equilibrium(monkeypatch, 5.0 * RPM, 7.0 * RPM)
    sets = [f"--set={path}={value}" for path, value in COARSE.items()]
    file = str(FOLDER.parent / "model.yaml")
    options = ["-s", "production", "--speeds", "0..12rpm", "--points", "3", "--modes", "4", "--json"]
    assert run_command(["campbell", file, *options, *sets]) == 3
    written = capsys.readouterr()
    summary = json.loads(written.out)
    assert summary["status"] != "ok" and summary["omitted_speeds"] == [pytest.approx(6.0 * RPM)]
    assert len(summary["modes"]) == 4 and summary["body"] == "hub"
    assert "no equilibrium at 6 rpm of hub" in written.err


def test_an_integrator_behind_a_rate_limit_finds_its_pitch():
    """At its rated speed the integrator of the pitch has the value that balances the torque."""
    system = turbine("rated", include="rigid_ratio.yaml")
    point = operating_point(system, "rated")
    pitch = math.degrees(float(point.state.q[system.layout.coordinate("root_1.spin")]))
    assert pitch == pytest.approx(10.45, abs=0.5)
    assert not [text for text in point.notes if "wanted_pitch" in text or "do not balance" in text]


@pytest.fixture(scope="module")
def over_wind(production):
    """Modes at one wind speed below and two above the rated one."""
    system, linear = production
    return solve_wind_campbell(system, [8.0, 12.0, 13.0], "production", count=12, linear=linear)


def test_operating_points_are_those_of_the_report(over_wind):
    """NREL/TP-500-38060, table 7-1: 9.16 rpm, 3.83 and 6.60 deg without the shear of the example, which takes
    1 % of the speed and 0.5 deg of the pitch (10.1 of 10.45 deg at 15 m/s)."""
    rotor, pitch = over_wind["rotor_speed"].values / RPM, np.degrees(over_wind["pitch"].values)
    assert rotor == pytest.approx([9.16, 12.1, 12.1], rel=0.01)
    assert rotor[1:] == pytest.approx(12.1, rel=1e-6)
    assert pitch == pytest.approx([0.0, 3.83, 6.60], abs=0.55)
    lines = over_wind["order_frequency"]
    assert lines.sel(order="6P").values == pytest.approx(0.1 * rotor)


def test_modes_over_the_wind_are_those_of_one_operating_point(production, over_wind):
    """A scenario with the speed found at 8 m/s; the mean over six azimuths and over as many."""
    system, _ = production
    found = replace(system.scenario, speed={"generator": float(over_wind["rotor_speed"][0])})
    modes = find_multiblade_modes(system, found, hub="hub", blades=BLADES, azimuths=6)
    names = [str(name) for name in over_wind["name"].values]
    for name in (
        "1st tower fore-aft",
        "1st flapwise (collective)",
        "1st edgewise (forward)",
        "drive-train torsion",
    ):
        k, at = names.index(name), modes.names.index(name)
        assert over_wind["frequency"].values[0, k] == pytest.approx(modes.frequency[at], rel=2e-3), name
        assert over_wind["damping_ratio"].values[0, k] == pytest.approx(modes.damping_ratio[at], rel=1e-2), (
            name
        )


def test_damping_over_the_wind_is_that_of_the_air(over_wind):
    ratio = dict(zip(map(str, over_wind["name"].values), over_wind["damping_ratio"].values.T, strict=True))
    assert np.all(ratio["1st flapwise (collective)"] > 0.4)
    assert np.all((ratio["1st edgewise (backward)"] > 0.005) & (ratio["1st edgewise (backward)"] < 0.03))
    assert np.all((ratio["1st tower fore-aft"] > 0.05) & (ratio["1st tower fore-aft"] < 0.12))
    assert not [name for name in ratio if name.startswith("rigid")]


def test_a_resonance_is_where_mode_and_order_meet(over_wind):
    assert over_wind.sizes["resonance"] > 0
    order, mode = str(over_wind["resonance_order"][0].values), int(over_wind["resonance_mode"][0])
    wind, f = float(over_wind["resonance_wind_speed"][0]), float(over_wind["resonance_frequency"][0])
    line = np.interp(wind, over_wind["wind_speed"], over_wind["order_frequency"].sel(order=order))
    curve = np.interp(wind, over_wind["wind_speed"], over_wind["frequency"].sel(mode=mode))
    assert line == pytest.approx(f) and curve == pytest.approx(f)


def test_a_mode_with_exactly_the_frequency_of_an_order_is_a_resonance():
    frequency, order = np.array([[0.5], [0.6], [0.7]]), np.array([[0.6] * 3] + [[9.0] * 3] * 3)
    found = SimpleNamespace(speed=np.array([8.0, 9.0, 10.0]), frequency=frequency, damping_ratio=frequency)
    rows = wind_campbell._of_resonances(found, np.ones(3), order, 3)
    assert rows["resonance_wind_speed"][1] == pytest.approx([9.0])


def test_a_free_rotor_requires_a_speed(production):
    system, linear = production
    stopped = linear.state.copy()
    stopped.v[:] = 0.0
    with pytest.raises(SolverError, match="give the scenario a speed of the rotor"):
        WindStates(replace(linear, state=stopped), rates_of(linear, "hub", "production"))


@pytest.mark.parametrize(
    ("acts", "speed", "moves"), [(97.0, 1.2, True), (0.0, 1.2, False), (97.0, 1.0, False)]
)
def test_an_integrator_at_rest_has_no_input_or_no_effect(acts, speed, moves):
    """Integrator of a generator torque [N m], with the error of the speed against 1 rad/s as input."""

    class Machine(_Trial):
        def _at(self, speed, values):
            return np.array([4e6 * (1.2 - speed) - acts * values[0], 2e4 * (speed - 1.0)]), None

    state = SimpleNamespace(v=np.zeros(1), copy=lambda: None)
    trial = Machine(SimpleNamespace(idle=[0]), None, Operation(speed, None, state))
    assert trial.moves(trial.last) is moves


def test_the_command_over_the_wind(tmp_path, capsys, monkeypatch, over_wind):
    monkeypatch.setattr(wind_campbell, "solve_wind_campbell", lambda *_, **__: over_wind)
    file, plot, csv = str(FOLDER.parent / "model.yaml"), tmp_path / "w.html", tmp_path / "w.csv"
    options = ["campbell", file, "-s", "production", "--wind-speeds", "8..13m/s"]
    assert run_command([*options, "--plot", str(plot), "--table", str(csv)]) == 0
    shown = capsys.readouterr().out
    assert "12.1 rpm" in shown and "1st tower fore-aft" in shown
    assert "damping ratio [%]" in plot.read_text(encoding="utf-8")
    rows = csv.read_text(encoding="utf-8").splitlines()
    assert len(rows) == 5 and rows[1].startswith("wind speed [m/s],rotor speed [rad/s],pitch [rad]")
    assert run_command([*options, "--json", "--modes", "Edgewise"]) == 0
    summary = json.loads(capsys.readouterr().out)
    assert summary["wind_speed"] == [8.0, 12.0, 13.0]
    assert summary["modes"] and all("edgewise" in row["name"] for row in summary["modes"])
    assert run_command([*options, "--modes", "50..60"]) == 2
    assert "no mode 50..60; there are: 1st tower" in capsys.readouterr().err
    assert run_command([*options, "--speeds", "0..9rpm"]) == 2
    assert "--speeds has no effect with --wind-speeds" in capsys.readouterr().err
    assert run_command([*options[:-1], "8m/s"]) == 2
    assert "0 < LOW < HIGH" in capsys.readouterr().err


def test_machines_without_wind_have_no_modes_over_it(capsys):
    file = str(FOLDER.parents[1] / "geared-rotor" / "model.yaml")
    assert run_command(["campbell", file, "-s", "fast", "--wind-speeds", "4..8m/s", "--quiet"]) == 3
    assert "the model has no wind_rotors" in capsys.readouterr().err
