# SPDX-License-Identifier: Apache-2.0
"""NL-MEISSNER: where a mesh stiffness that jumps between two values makes an undamped pair unstable.

Closed form for x'' + k(t) x = 0 with k_1 for the time T_1 and k_2 for T_2 (E. Meissner, Schweizerische
Bauzeitung 72 (1918) 95-98): unstable where |2 cos phi_1 cos phi_2 - (w_1/w_2 + w_2/w_1) sin phi_1 sin phi_2|
is greater than 2, phi = w T. For k_1 : k_2 = 3 : 2 and equal times, in units of sqrt(mean k / m): [0.98495,
1.00493] and [1.87105, 2.12527].

The engine is asked the same question. Two gears carry a large torque, so that the flanks never part; the
difference of two runs over one mesh period then obeys the equation above exactly, and two differences make
the matrix over one period. Undamped means that its determinant is one; a trace beyond 2 means growth. The
stiffness jumps at mesh phase 0 and 1/2, the zeros of the function behind the event `pair_entry`: the adaptive
method starts anew there.

Tolerance 1e-4 as the source gives it. The method is better: its trace is good to some 1e-6, and so the
boundaries agree with the closed form to 1e-5.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint import compile_model, load_model
from pitchpoint.solvers.initial_state.start import Start, prepare_start
from pitchpoint.solvers.time import run_time
from pitchpoint.system import evaluate

BOUNDARIES = [(0.97, 0.995, 0.98495), (0.995, 1.02, 1.00493), (1.8, 2.0, 1.87105), (2.0, 2.2, 2.12527)]

MODEL = """\
title: pair with rectangular stiffness
gears:
  g1: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], inertia: 0.0115 kg m^2}
  driven: {gears: [g2], inertia: 0.0115 kg m^2}
meshes:
  stage:
    gears: [g1, g2]
    center_distance: 150 mm
    backlash: {normal: 0.1 mm}
    stiffness: {law: rectangular, high: 4.8e8 N/m, low: 3.2e8 N/m, duty: 0.5}
loads:
  input:  {body: driver, torque: 15 kN m}
  output: {body: driven, torque: 15 kN m}
scenarios:
  period: {speed: {driver: 1500 rpm}, duration: 1 ms, method: runge_kutta, tolerance: 1e-10,
           events: [pair_entry]}
"""


def closed_form(omega, ratio=1.5, duty=0.5):
    """Trace of the matrix over one period at a mesh frequency in units of sqrt(mean k / m)."""
    mean = ratio * duty + 1.0 - duty
    w1, w2 = math.sqrt(ratio / mean), math.sqrt(1.0 / mean)
    p1, p2 = 2.0 * math.pi / omega * duty * w1, 2.0 * math.pi / omega * (1.0 - duty) * w2
    return 2.0 * math.cos(p1) * math.cos(p2) - (w1 / w2 + w2 / w1) * math.sin(p1) * math.sin(p2)


class Pair:
    """The pair at any mesh frequency."""

    def __init__(self, file):
        file.write_text(MODEL)
        self.model = load_model(file)
        self.scenario = self.model.scenarios["period"]
        self.system = compile_model(self.model, self.scenario)
        self.row = self.system.records["gear_mesh"][0]
        self.r_b = float(self.row["r_b1"])
        mass = 0.5 * self.model.bodies["driver"].inertia / self.r_b**2
        self.natural = math.sqrt(float(self.row["contact"]["k_ref"]) / mass)

    def matrix(self, omega):
        """Matrix over one mesh period of (deflection, its rate / natural frequency)."""
        w = omega * self.natural
        scenario = replace(self.scenario, speed={"driver": w / 50.0}, duration=2.0 * math.pi / w)
        start = prepare_start(self.system, scenario)
        size = float(evaluate.observe(start.system, start.state)[0]) * 0.1
        ends = [
            self.end(start, scenario, *nudge)
            for nudge in ((0.0, 0.0), (size, 0.0), (0.0, size * self.natural))
        ]
        return np.array([(end - ends[0]) / size for end in ends[1:]]).T

    def end(self, start, scenario, move, push):
        """Deflection and its scaled rate after one period, from the start moved and pushed along the mesh."""
        state = start.state.copy()
        for body in ("driver", "driven"):
            state.q[start.system.spin(body)] += 0.5 * move / self.r_b
            state.v[start.system.spin(body)] += 0.5 * push / self.r_b
        done = run_time(start.system, scenario, start=Start(start.system, state))
        assert done.status == 1, done.sentence
        assert done.channels["contact_state[stage]"]["min"] == 1.0
        u = evaluate.observe(start.system, done.state)[0]
        rate = self.r_b * sum(done.state.v[start.system.spin(body)] for body in ("driver", "driven"))
        return np.array([u, rate / self.natural])


@pytest.fixture(scope="module")
def gears(tmp_path_factory):
    return Pair(tmp_path_factory.mktemp("meissner") / "pair.yaml")


@pytest.mark.parametrize(("low", "high", "boundary"), BOUNDARIES)
def test_boundaries(gears, low, high, boundary):
    from scipy.optimize import brentq

    found = brentq(lambda omega: abs(np.trace(gears.matrix(omega))) - 2.0, low, high, xtol=1e-6)
    assert found == pytest.approx(boundary, abs=1e-4)
    exact = brentq(lambda omega: abs(closed_form(omega)) - 2.0, low, high, xtol=1e-12)
    assert found == pytest.approx(exact, abs=1e-5)


@pytest.mark.parametrize("omega", [0.7, 0.9, 0.99, 1.3, 1.7, 1.95, 2.1, 2.5])
def test_matrix_over_one_period(gears, omega):
    matrix = gears.matrix(omega)
    assert np.trace(matrix) == pytest.approx(closed_form(omega), abs=1e-5)
    assert np.linalg.det(matrix) == pytest.approx(1.0, abs=1e-5)
