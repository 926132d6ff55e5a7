# SPDX-License-Identifier: Apache-2.0
"""WT-MODES: the NREL 5 MW turbine at rest against a linearisation of OpenFAST, by way of assumed modes.

Source: OpenFAST 2.5.0, data/linearization_outputs/ws00.0.1.lin of OpenFAST/openfast_toolbox (Apache 2.0), a
state matrix of 30 states. Its inputs, beside it: blades and tower of examples/wind-turbine, weight, no air,
generator and pitch locked, no ServoDyn. Without it the yaw bearing has no spring, and yaw is free. The
nacelle has inertia about the vertical axis only, a locked generator none.

ElastoDyn has two assumed modes of a blade flapwise and one edgewise, two of the tower in each direction, and
sums over 17 and 20 elements. Three steps lead to the beams of the example: (1) the same assumptions in an
independent implementation give the row of the matrix; (2) the mass and stiffness matrices of the example,
projected on these shapes, give the frequencies of that implementation with many elements; (3) with
polynomials of degree 12 instead of the shapes it has the frequencies of the example.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import scipy.linalg

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.body_shapes import body_motions
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.assumed_modes import Turbine
from tests.support.rotors import FOLDER

FREQUENCY = (
    *(0.31410, 0.32444, 0.62080, 0.66668, 0.69905, 0.96070, 1.08362, 1.16059),
    *(1.91092, 2.00734, 2.53770, 2.91589, 2.95457, 3.68803),
)
RATIO = (
    *(0.00352, 0.00352, 0.00930, 0.00472, 0.00551, 0.00605, 0.00472, 0.00548),
    *(0.00490, 0.00500, 0.00748, 0.00950, 0.01008, 0.03946),
)
"""Absolute values of the eigenvalues [Hz] and damping ratios of the matrix."""
FILES = FOLDER / "5MW_Baseline"
INERTIA = ((8.8e5, 8.8e5, 1.7415e6), (115926.0, 57964.0, 57964.0))
"""Moments of inertia of nacelle and hub in the example; those that ElastoDyn has alone no body can have."""


def test_assumed_modes_give_the_matrix_of_openfast():
    """To 1e-4 (the matrix is of single precision, its tower still sways by 2 mm), damping to all digits."""
    found, ratio = Turbine(FILES).modes()
    np.testing.assert_allclose(found, FREQUENCY, rtol=1e-4)
    np.testing.assert_allclose(ratio, RATIO, atol=1e-5)


@cache
def turbine(gravity: bool):
    """The example with free yaw and without air, and its matrices about the position at rest."""
    changes = {
        "wind_rotors.rotor": None,
        "bushings.yaw_drive": None,
        "bodies.generator.inertia": 1.0,
        "bodies.hub.transverse_inertia": INERTIA[1][1],
        "beams.tower.pieces": 20,
        **{f"beams.blade_{k}.pieces": 48 for k in (1, 2, 3)},
    }
    if not gravity:
        changes |= {"gravity": None, "scenarios.parked.start": "assembled"}
    system = compile_model(load_model(FOLDER.parent / "model.yaml").replace_all(changes), "parked")
    return system, linearise(system, "parked")


def test_our_matrices_with_assumed_modes_are_those_of_elastodyn():
    """Projected on the shapes of ElastoDyn, without weight: to 0.3 %, the error of the pieces."""
    system, linear = turbine(gravity=False)
    found = find_modes(system, "parked", count=1, linear=linear)
    assumed = Turbine(FILES, gravity=0.0, nodes=(300, 300), inertia=INERTIA)
    bodies = [i for i, name in enumerate(found.bodies) if not name.startswith("state.")]
    ours = body_motions(linear.system, linear.state, np.eye(len(linear.at_rest.M)))[:, bodies]
    theirs = np.array([assumed.motion(found.bodies[i], found.place[i]) for i in bodies]).transpose(1, 0, 2)
    theirs[:, 0] = 0.0  # the ground
    n = len(ours)
    shapes = np.linalg.lstsq(ours.reshape(n, -1).T, theirs.reshape(15, -1).T, rcond=None)[0]
    assert np.abs(shapes.T @ ours.reshape(n, -1) - theirs.reshape(15, -1)).max() < 1e-3
    K, M = (shapes.T @ matrix @ shapes for matrix in (linear.at_rest.K, linear.at_rest.M))
    squares = scipy.linalg.eigh(0.5 * (K + K.T), M, eigvals_only=True)
    projected = np.sqrt(squares[1:]) / (2.0 * np.pi)  # the first is the free yaw
    np.testing.assert_allclose(projected, assumed.modes()[0], rtol=3e-3)


ASSUMED_EXCESS = (0.8, 3.4, 1.4, 1.2, 0.8, 0.7, 0.4, 0.7, 2.8, 1.9, 3.7, 5.5, 3.1, 20.5)
"""Frequencies of the modes of ElastoDyn's files over those of beams [%], with as many elements."""
SUMS_DEFICIT = (0.2, 0.1, 0.7, 1.6, 1.5, 1.3, 1.2, 1.2, 0.6, 0.6, 0.1, -0.1, 0.2, -0.3)
"""Frequencies of ElastoDyn with 17 and 20 elements below those with 200 [%]."""


def test_beams_are_the_limit_of_assumed_modes():
    """With the weight. Polynomials are stiffer, by Rayleigh, and pieces softer: the error decreases with the
    square of their number, 0.5 % with 48 (1.9 % with 12). The two tables are the difference of OpenFAST."""
    system, linear = turbine(gravity=True)
    beams = find_modes(system, "parked", count=15, linear=linear).frequency[1:]
    many = Turbine(FILES, nodes=(200, 80), degree=12, inertia=INERTIA).modes()[0]
    assert (beams < many).all()
    np.testing.assert_allclose(beams, many, rtol=5e-3)
    few = Turbine(FILES, nodes=(200, 80), inertia=INERTIA).modes()[0]
    np.testing.assert_allclose(100.0 * (few / many - 1.0), ASSUMED_EXCESS, atol=0.1)
    coarse = Turbine(FILES, inertia=INERTIA).modes()[0]
    np.testing.assert_allclose(100.0 * (1.0 - coarse / few), SUMS_DEFICIT, atol=0.1)


def deflection(turbine: Turbine, thrust: float) -> float:
    """Tower top downwind under a force along the shaft on the apex [m]."""
    q = np.zeros(turbine.count)
    K = turbine.stiffness(q)
    K[turbine.yaw, turbine.yaw] += 1e9  # without a lateral force yaw does not matter
    for _ in range(60):
        _, apex, _, hub, _ = turbine.top(q + 1e-30j * np.eye(turbine.count))
        rest = turbine.forces(q) - thrust * apex.imag / 1e-30 @ hub[0].real[:, 0]
        q = q - np.linalg.solve(K, rest)
        if np.abs(rest).max() < 0.1:
            return float(turbine.tower.line(q[: turbine.yaw])[0][-1, 0])
    raise AssertionError("no equilibrium")


def test_the_tower_yields_to_the_thrust_as_in_openfast():
    """Tower top under 379.5 kN along the shaft at the hub, with the weight, which bends it upwind by 16 mm.

    Beams have the deflection of polynomials, 0.209 m. The modes of the files are stiffer: 0.198 m, or 0.559
    um/N, against 0.568 um/N in OpenFAST between 3 and 11 m/s, with the moments of the air (welib, MIT,
    NREL5MW_Oper_Onshore_Flexible_Discon.csv: 27.1 mm at 73.639 kN, 356.2 mm at 652.744 kN), and 1.81 MN/m, 14
    mm upwind without wind of D. Schlipf (SLOW, NREL5MWDefaultParameter). The older NREL5MW_Oper.csv, 0.136 m
    at 379.5 kN, has 0.386 um/N, as is (77.6/87.6)^3 times the onshore one: that of a tower on a base at 10 m.
    """
    changes = {
        "wind_rotors.rotor": None,
        "beams.tower.pieces": 20,
        **{f"beams.blade_{k}.pieces": 48 for k in (1, 2, 3)},
    }
    push = "loads:\n  thrust: {body: hub, force: [378066.96 N, 0, -33076.55 N]}\nscenarios:\n"
    file = FOLDER.parent / "model.yaml"
    text = file.read_text(encoding="utf-8").replace("scenarios:\n", push)
    model = loads_model(text, file=str(file), changes=changes)
    system = compile_model(model, "parked")
    top = prepare_start(system, system.scenario).state.q[system.layout.coordinate("tower_top.x")]
    assert top == pytest.approx(deflection(Turbine(FILES, nodes=(60, 60), degree=8), 379.511e3), rel=2e-3)
    files = Turbine(FILES)
    assert deflection(files, 379.511e3) == pytest.approx(0.1983, abs=1e-4)
    assert deflection(files, 0.0) == pytest.approx(-0.0138, abs=1e-4)
    per_newton = (deflection(files, 652.744e3) - deflection(files, 73.639e3)) / (652.744e3 - 73.639e3)
    assert per_newton == pytest.approx((0.3562 - 0.0271) / (652.744e3 - 73.639e3), rel=0.02)
