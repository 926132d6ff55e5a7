# SPDX-License-Identifier: Apache-2.0
"""The example `overlap-ratio`: stiffness and dynamic force of helical pairs over the overlap ratio.

Source: L. Mauer, "The new, powerful gearwheel module", SIMPACK User Meeting 2006, "What is the best overlap
ratio?". The oracle is the pair as a single mass on k(psi(t)), integrated by SciPy: m x'' + d x' + k x =
T/r_b, with the phase at nominal speed. That neglects the speed ripple in the phase, 5e-4 of the speed;
tolerance 1e-3.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.numbers import cycles_of_model
from pitchpoint.solvers.time import run_time
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "overlap-ratio"
PEAK_TO_PEAK = {"overlap_070": 0.3337278, "overlap_085": 0.1408632, "overlap_100": 0.0}


@pytest.fixture(scope="module")
def model():
    return load_model(FOLDER / "pairs.yaml")


@pytest.fixture(scope="module")
def channels(model):
    return run_time(compile_model(model, "steady")).channels


def swing(values):
    return (values["max"] - values["min"]) / values["mean"]


def oscillator(model, mesh):
    """Peak to peak over mean of the force of the single mass, spring and damper."""
    pair = model.pairs[mesh]
    cycle = dict(cycles_of_model(model, 4001))[mesh][0]
    k = np.asarray(cycle.stiffness_ratio)
    body = next(b for b in model.bodies if model.bodies[b].gears.keys() & {model.meshes[mesh].gears[0]})
    r_b = 0.5 * pair.gear1.d_b
    mass = model.body_inertia(body).polar / (2.0 * r_b**2)
    load = model.loads[f"input_{mesh[-3:]}"].torque.value / r_b
    scale = model_unit(model, mesh)
    d = 2.0 * 0.05 * math.sqrt(scale * cycle.mean * mass)
    f = 30 * 50.0

    def stiffness(t):
        return scale * np.interp((f * t) % 1.0, cycle.phase, k)

    def rates(t, y):
        return [y[1], (load - d * y[1] - stiffness(t) * y[0]) / mass]

    t = np.linspace(0.04, 0.042, 4001)
    start = [load / (scale * cycle.mean), 0.0]
    y = solve_ivp(rates, (0.0, 0.042), start, t_eval=t, rtol=1e-8, atol=1e-15, max_step=2e-6).y
    force = stiffness(t) * y[0] + d * y[1]
    return np.ptp(force) / (load)


def model_unit(model, mesh):
    """c' b of a mesh [N/m]."""
    from pitchpoint.system.rules.stiffness import describe_stiffness

    return describe_stiffness(model, mesh).c_prime * model.pairs[mesh].b_w


def test_contact_ratios_and_stiffness(model):
    for mesh, expected in PEAK_TO_PEAK.items():
        pair = model.pairs[mesh]
        assert pair.eps_alpha == pytest.approx(1.3, abs=1e-9)
        assert pair.eps_beta == pytest.approx(int(mesh[-3:]) / 100.0, abs=1e-9)
        cycle = dict(cycles_of_model(model, 401))[mesh][0]
        assert cycle.peak_to_peak == pytest.approx(expected, abs=1e-6)


def test_constant_force_at_an_overlap_of_one(channels):
    assert swing(channels["mesh_force[overlap_100]"]) < 1e-9


@pytest.mark.parametrize(
    ("mesh", "expected"),
    [("overlap_070", 0.1729), pytest.param("overlap_085", 0.1207, marks=pytest.mark.study)],
)
def test_dynamic_force(model, channels, mesh, expected):
    found = swing(channels[f"mesh_force[{mesh}]"])
    assert found == pytest.approx(oscillator(model, mesh), rel=1e-3)
    assert found == pytest.approx(expected, abs=1e-4)
