# SPDX-License-Identifier: Apache-2.0
"""`solve_campbell` against a rotor whose whirl frequencies are the roots of a polynomial."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import SolverError
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.system.system import assemble
from tests.support.beams import nodes, shaft, supports
from tests.support.machines import compiled, pair
from tests.support.synchronous import synchronous_speeds

M, I_P, I_T = 3.0, 0.02, 0.012
K_1, K_2, A, B = 2e7, 5e7, 0.05, 0.12
K_Z, C_Z = 4e6, 150.0
ROTOR = f"""\
bodies:
  disc: {{motion: free, mass: {M}, inertia: {I_P}, transverse_inertia: {I_T}}}
bearings:
  left: {{body: disc, position: [0, 0, {-A}], stiffness: {{radial: {K_1}, axial: {K_Z}, torsion: 1}},
         damping: {{axial: {C_Z}}}}}
  right: {{body: disc, position: [0, 0, {B}], stiffness: {{radial: {K_2}}}}}
"""


def whirl(speed: float) -> np.ndarray:
    """Whirl frequencies [rad/s] of a rigid rotor on two isotropic bearings, by value.

    With z = x + i y, p = ry - i rx and e^(i w t): m z'' + k z + c p = 0 and I_t p'' - i I_p W p' + q p + c z
    = 0, so (k - m w^2) (q + I_p W w - I_t w^2) = c^2; negative roots whirl backwards.
    """
    k, c, q = K_1 + K_2, K_2 * B - K_1 * A, K_1 * A**2 + K_2 * B**2
    left, right = np.poly1d([-M, 0.0, k]), np.poly1d([-I_T, I_P * speed, q])
    return np.sort(np.abs((left * right - c**2).roots.real))


def test_whirl_of_a_rotor_on_two_bearings():
    speeds = np.array([0.0, 200.0, 1000.0])
    data = pp.solve_campbell(compiled(ROTOR)[1], speeds, "disc")
    assert data["frequency"].dims == data["damping_ratio"].dims == ("speed", "mode")
    assert (data["frequency"].attrs["units"], data["speed"].attrs["units"]) == ("Hz", "rad/s")
    names = [str(name) for name in data["name"].values]
    lateral = [k for k, name in enumerate(names) if name.startswith(("tilting", "translation"))]
    found = np.sort(data["frequency"].values[:, lateral], axis=1) * 2.0 * math.pi
    assert found == pytest.approx(np.array([whirl(speed) for speed in speeds]), rel=1e-9)
    assert np.all(np.diff(found[:, -1]) > 0.0)  # the highest mode whirls forwards and stiffens
    axial = names.index("axial mode of disc")
    zeta = C_Z / (2.0 * math.sqrt(K_Z * M))
    damped = math.sqrt(K_Z / M * (1.0 - zeta**2)) / (2.0 * math.pi)
    assert data["damping_ratio"].values[:, axial] == pytest.approx(np.full(3, zeta), rel=1e-9)
    assert data["frequency"].values[:, axial] == pytest.approx(np.full(3, damped), rel=1e-9)


def test_orders_follow_from_the_teeth():
    system = compiled(pair("{law: constant, value: 3e8 N/m}"))[1]
    for body, teeth in (("driver", 30), ("driven", 45)):
        data = pp.solve_campbell(system, [0.0, 50.0], body)
        assert data.attrs["body"] == body
        assert data["order"].sel(mesh="stage").item() == teeth
        expected = teeth * 50.0 / (2.0 * math.pi)
        assert data["mesh_frequency"].sel(speed=50.0, mesh="stage").item() == pytest.approx(expected)


def test_an_unknown_body_is_named():
    with pytest.raises(SolverError, match="no body 'rotor'; there are: disc"):
        pp.solve_campbell(compiled(ROTOR)[1], [0.0], "rotor")


def test_whirl_and_critical_speeds_of_a_rotor_on_a_beam():
    """Disc in the middle of a light shaft on stiff bearings, made from numbers alone.

    Half a shaft of length a with the shear parameter phi: k = 2 E I/(a^3 (1/3 + phi/12)) laterally and
    k_t = 24 E I/((4 + phi) a) against tilt. Whirl of the tilt: w = W I_p/(2 I_t) +- root(...), and w = W for
    W^2 = k_t/(I_t - I_p) forwards, k_t/(I_t + I_p) backwards.
    """
    a, mass, i_t, i_p = 0.5, 8.0, 0.05, 0.03
    piece = Beam(section=tube(0.03, nu=0.3), length=a, E=2.1e11, G=8e10, rho=0.0)
    ends = (1e-3, 1e-8, 1e-8)
    bodies = nodes([0.0, a, 2.0 * a], {0: ends, 1: (mass, i_t, i_p), 2: ends}, name="n")
    stiff = np.diag([1e12, 1e12, 1e12, 0.0, 0.0, 0.0])
    held = supports(bodies, [(1, stiff, 0.0 * stiff), (3, stiff, 0.0 * stiff)])
    system = assemble(bodies, {"shaft_beam": shaft([piece, piece]), "bearing": held})
    EI, phi = piece.E * piece.section.I_1, piece.phi(1)
    k = 2.0 * EI / (a**3 * (1.0 / 3.0 + phi / 12.0))
    k_t = 24.0 * EI / ((4.0 + phi) * a)
    speeds = np.linspace(0.0, 2500.0, 101)
    found = follow_modes(system, speeds, "n1")
    assert found.orders == {}
    half = 0.5 * i_p * speeds / i_t
    root = np.sqrt(half**2 + k_t / i_t)
    expected = np.column_stack([np.full_like(speeds, math.sqrt(k / mass))] * 2 + [root - half, root + half])
    low = np.sort(found.frequency, axis=1)[:, 1:5] * 2.0 * math.pi  # after the rigid rotation
    # bearings give way by k/1e12
    assert low == pytest.approx(np.sort(expected, axis=1), rel=1e-5)
    lateral = [
        c for c in range(found.frequency.shape[1]) if 0 < found.frequency[0, c] * 2 * math.pi < 1.01 * root[0]
    ]
    critical = [math.sqrt(k / mass)] * 2 + [math.sqrt(k_t / (i_t + s * i_p)) for s in (1.0, -1.0)]
    # straight lines between speeds 25 rad/s apart
    assert synchronous_speeds(speeds, found.frequency[:, lateral]) == pytest.approx(
        sorted(critical), rel=2e-4
    )


CANTILEVER = """\
shafts:
  r: {sections: [{length: 400 mm, diameter: 30 mm}], markers: {e: {position: [0, 0, 400 mm]}},
    position: [0, 0, 0], material: {density: 0.1 kg/m^3, youngs_modulus: 206 GPa, poisson_ratio: 0.3}}
bodies: {disc: {mass: 10 kg, inertia: 0.2 kg m^2, transverse_inertia: 0.1 kg m^2}}
joints: {j: {type: fixed, bodies: [r.e, disc]}}
bearings: {a: {body: r, position: [0, 0, 0], stiffness: {radial: CLAMP, axial: 1e10, tilt: CLAMP}}}
"""


@pytest.mark.parametrize(("clamp", "most"), [("1e12", "the lowest have no correct digit"), ("1e9", "up to")])
def test_rounding_errors_are_noted(clamp, most):
    """A disc of 10 kg on a shaft of 28 mg: 29.089 and 153.471 Hz at rest, twice each but for rounding."""
    system = pp.compile_model(pp.load_model(text=CANTILEVER.replace("CLAMP", clamp)))
    found = pp.solve_campbell(system, [0.0, 300.0], "r")
    assert "rounding errors of more than 0.01 %, " + most in found.attrs["notes"]
    if most == "up to":
        bending = np.sort(found["frequency"].values[0])[1:5]
        assert np.abs(bending / [29.089, 29.089, 153.471, 153.471] - 1.0).max() < 0.067
