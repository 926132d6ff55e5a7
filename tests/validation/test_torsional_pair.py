# SPDX-License-Identifier: Apache-2.0
"""The torsional pair of the README's contract against an integration written out here.

Two equal gears under equal torques leave one equation for the deflection d = u - e along the base tangent,
m d'' + c d' + k(psi) g(d) = T/r_b - m e'', with m = I/(2 r_b^2), psi = f t, g = d -+ j/2 outside the gap, and
k, e the Fourier series of the file. It is solved here with SciPy's DOP853 at rtol 1e-9: another method, other
code, and none of the package's geometry.

Tolerances: 1e-3 of the rms for what vibrates, 1e-3 of the mean force for forces, of half the gap for means.
What limits them is the step of the engine, 1/200 of the period of the mesh mode: it leaves 3e-4. Extremes are
taken at the steps. The reference agrees with itself to 1e-6.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pitchpoint import compile_model, load_model
from pitchpoint.solvers.time import run_time
from pitchpoint.sweep.speed import run_sweep
from tests.support.model_files import TORSIONAL_PAIR

R_B = 0.5 * 50 * 3e-3 * math.cos(math.radians(20.0))
MASS = 0.5 * 0.0115 / R_B**2
MEAN, COSINE = 4.0e8, (-0.2, -0.1, -0.05)
ERROR = (1.0e-6, 0.5e-6)
DAMPING = 2.0 * 0.05 * math.sqrt(MEAN * MASS)
FORCE = 150.0 / R_B
HALF_GAP = 0.5 * 0.1e-3  # spur gears: normal and base tangent are the same


class Reference:
    """The oscillator at one mesh frequency, from where the last one ended."""

    def __init__(self):
        self.state = np.array([HALF_GAP + FORCE / MEAN, 0.0])

    def run(self, frequency, periods, samples=0):
        """Go on for some mesh periods; with samples per period: deflection, transmission error, force."""
        w = 2.0 * math.pi * frequency

        def stiffness(t, cos=np.cos):
            return MEAN * (1.0 + sum(c * cos(h * w * t) for h, c in enumerate(COSINE, 1)))

        def error(t, order=0, cos=np.cos):
            sign = -1.0 if order else 1.0
            return sum(sign * c * (h * w) ** order * cos(h * w * t) for h, c in enumerate(ERROR, 1))

        def spring(t, d):
            return stiffness(t) * (np.maximum(d - HALF_GAP, 0.0) + np.minimum(d + HALF_GAP, 0.0))

        def rates(t, y):  # as `spring`, for numbers: arrays of one take five times as long
            d, v = y.tolist()
            outside = max(d - HALF_GAP, 0.0) + min(d + HALF_GAP, 0.0)
            force = stiffness(t, math.cos) * outside + DAMPING * v
            return [v, (FORCE - force) / MASS - error(t, 2, math.cos)]

        end = periods / frequency
        t = np.arange(samples * periods + 1) / (samples * frequency) if samples else None
        found = solve_ivp(rates, (0.0, end), self.state, "DOP853", t_eval=t, rtol=1e-9, atol=[1e-15, 1e-11])
        assert found.success
        self.state = found.y[:, -1]
        if not samples:
            return None
        t, d, v = t[:-1], found.y[0, :-1], found.y[1, :-1]
        return {
            "deflection": d,
            "transmission_error": d + error(t),
            "mesh_force": spring(t, d) + DAMPING * v,
        }


def compare(engine, reference):
    """Statistics of the engine against samples of the reference."""
    for name, x in reference.items():
        found = engine[name]
        rms = float(np.std(x))
        size = FORCE if name == "mesh_force" else HALF_GAP
        assert found["mean"] == pytest.approx(float(x.mean()), abs=1e-3 * size), name
        assert found["rms"] == pytest.approx(rms, rel=1e-3), name
        assert found["min"] == pytest.approx(float(x.min()), abs=1e-3 * rms), name
        assert found["max"] == pytest.approx(float(x.max()), abs=1e-3 * rms), name


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    file = tmp_path_factory.mktemp("pair") / "pair.yaml"
    file.write_text(TORSIONAL_PAIR)
    return load_model(file)


@pytest.fixture(scope="module")
def points(model):
    found = run_sweep(compile_model(model, "sweep"))
    assert found.status == 1, found.sentence
    assert len(found.points) == 162
    assert [j["direction"] for j in found.jumps] == ["up", "up", "down", "down"]
    return {(p["direction"], round(p["mesh_frequency"])): p for p in found.points}


def test_steady(model):
    done = run_time(compile_model(model, "steady"))
    assert done.status == 1, done.sentence
    reference = Reference()
    reference.run(1250.0, 60)
    found = {n.partition("[")[0]: c for n, c in done.channels.items() if n.endswith("[stage]")}
    compare(found, reference.run(1250.0, 10, 500))


@pytest.mark.parametrize(
    ("direction", "way"),
    [
        ("up", (2000.0,)),  # lower branch, always in contact
        # upper branch of the same speed
        pytest.param("down", tuple(np.arange(2600.0, 1999.0, -100.0)), marks=pytest.mark.study),
        ("up", (1400.0,)),  # half the natural frequency: the second harmonic parts the flanks
    ],
)
def test_sweep(points, direction, way):
    reference = Reference()
    for frequency in way:
        reference.run(frequency, 60)
    expected = reference.run(way[-1], 10, 500)
    point = points[direction, round(way[-1])]
    compare(point, expected)
    apart = float(np.mean(np.abs(expected["deflection"]) < HALF_GAP))
    assert point["contact_loss_share"] == pytest.approx(apart, abs=5e-3)  # a step or two per period
    assert point["back_contact_share"] == 0.0
