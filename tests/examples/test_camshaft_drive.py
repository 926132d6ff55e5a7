# SPDX-License-Identifier: Apache-2.0
"""The example `camshaft-drive`: every file of it runs, and each page number that matters is asserted."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.amplification import amplification_factor
from pitchpoint.analysis.statistics import contact_statistics
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.time import Memory, run_time
from pitchpoint.sweep.speed import run_sweep
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "camshaft-drive"
# S1's sum of profile shifts lies outside the range of the stiffness polynomial, and the model says so
outside_polynomial = pytest.mark.filterwarnings("ignore::pitchpoint.core.errors.ValidityWarning")


def signals(file, scenario, **changes):
    model = load_model(FOLDER / file)
    for path, value in changes.items():
        model = model.replace(f"scenarios.{scenario}.{path}", value)
    system = compile_model(model, scenario)
    memory = Memory()
    done = run_time(system, sink=memory)
    t, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    return done, t, lambda name: rows[:, system.layout.channel(name)]


def study():
    spec = importlib.util.spec_from_file_location("camshaft_study", FOLDER / "study.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_contact_loss_over_backlash_and_torque(monkeypatch):
    own = study()
    monkeypatch.setattr(own, "BACKLASHES", (0.05e-3, 0.43e-3))
    monkeypatch.setattr(own, "TORQUES", (5.0, 20.0, 60.0))
    shares, expected = own.table(load_model(FOLDER / "release-backlash.yaml"))
    assert np.abs(shares - expected).max() < 1e-4
    assert np.all(np.diff(shares, axis=0) > 0.0)
    assert np.all(np.diff(shares, axis=1) < 0.0)


def test_transmission_error_of_the_study():
    """TE = theta_g - Z theta_p with Z = z_p/z_g, both positive in driving sense: r_b,g TE = -u_bt."""
    _, _, channel = signals("release-backlash.yaml", "release", duration=0.3)
    theta_p, theta_g = channel("angle[crankshaft]"), -channel("angle[wheel_gap_043]")
    error = 0.5 * 511.1928e-3 * (theta_g - 59 / 68 * theta_p)
    assert error == pytest.approx(-channel("transmission_error[gap_043]"), abs=1e-9)
    assert np.ptp(error) > 0.5e-3


def test_run_up_with_the_printed_stiffness_has_no_resonance_at_19_seconds():
    done, t, channel = signals("run-up-printed.yaml", "run_up", duration=25.0)
    force = channel("mesh_force[stage]")
    assert float(t[np.argmax(force)]) == pytest.approx(8.35, abs=0.2)
    assert force[t > 15.0].max() < 1.45 * 500.0 / 0.2555964
    assert done.channels["deflection[stage]"]["mean"] == pytest.approx(19.6e-3, rel=0.02)


def test_run_up_of_two_free_gears_is_unstable_at_the_resonance():
    _, t, channel = signals("run-up-free.yaml", "run_up", duration=30.0)
    force = channel("mesh_force[gap_043]")
    at = 59 * 0.2 * float(t[np.argmax(force)]) / (2.0 * math.pi)
    assert at == pytest.approx(44.5, abs=1.0)
    assert force.max() > 100.0 * 500.0 / 0.2555964


def test_amplification_follows_the_linear_oscillator():
    model = load_model(FOLDER / "amplification.yaml")
    model = model.replace("scenarios.sweep.sweep.points", 10)
    done = run_sweep(compile_model(model, "sweep"))
    ratio = np.array([p["mesh_frequency"] for p in done.points]) / 41.4
    static = 5.0 / 0.2555964 / 3.16937e6 / math.sqrt(2.0)
    ours = np.array([p["deflection"]["rms"] for p in done.points]) / static
    assert ours == pytest.approx(amplification_factor(ratio, 0.1), rel=1e-3)


@outside_polynomial
def test_natural_frequencies_of_the_train():
    model = load_model(FOLDER / "train.yaml")
    found = find_modes(compile_model(model))
    # the same train by hand: crank, idlers on one shaft, cam
    r1, r2, r3, r4 = (0.5e-3 * d for d in (443.5349, 511.1928, 287.5459, 498.9768))
    k1, k2 = (mean_stiffness(model, name) for name in ("stage_1", "stage_2"))
    one, two = np.array([r1, r2, 0.0]), np.array([0.0, r3, r4])
    stiffness = k1 * np.outer(one, one) + k2 * np.outer(two, two)
    inertia = np.array([4.034, 3.06 + 0.998, 4.503])
    by_hand = np.sqrt(np.abs(np.sort(np.linalg.eigvals(stiffness / inertia[:, None]).real))) / (2.0 * math.pi)
    assert found.frequency[1:] == pytest.approx(by_hand[1:], rel=1e-6)
    assert found.frequency[1:] == pytest.approx([928.65, 1404.64], rel=1e-4)


def mean_stiffness(model, name):
    from pitchpoint.system.rules.gear_mesh import mean_stiffness as of_pair
    from pitchpoint.system.rules.stiffness import describe_stiffness

    return of_pair(model.pairs[name], describe_stiffness(model, name))


@outside_polynomial
def test_cam_torque_makes_the_gears_hammer():
    _, t, channel = signals("train.yaml", "engine", settle_time=0.16, duration=0.32)
    late = t > 0.16
    for mesh, mean in (("stage_1", 1.0), ("stage_2", -1.0)):
        force = channel(f"mesh_force[{mesh}]")[late]
        found = contact_statistics(t[late], channel(f"contact_state[{mesh}]")[late], force)
        assert found.loss_share > 0.3
        assert sum(s.flank_before != s.flank_after for s in found.separations) > 5
        assert math.copysign(1.0, force.mean()) == mean
