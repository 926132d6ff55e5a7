# SPDX-License-Identifier: Apache-2.0
"""TG-FRIS: torsional examples of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010).

Numbers as used in the tests of the openTorsion package. Tolerance: half a unit of the last printed digit,
widened to 2e-4 where the printed value is rounded from data that were rounded themselves.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.solvers.modal import find_modes
from tests.support.machines import chain, compiled


def test_chain_of_five_discs():
    """Case a: engine with flywheel and load."""
    system = compiled(chain([3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05], [12e3, 12e3, 14e3, 10e3]))[1]
    printed = [0.0, 81.21, 141.21, 378.95, 536.36]
    assert find_modes(system).frequency == pytest.approx(printed, abs=0.006)


def geared(mesh: float) -> str:
    """Case b: motor, two 1:1 gears, two rotors; the second rotor hangs on the second gear."""
    discs = {"motor": 400e-6, "rotor1": 700e-6, "rotor2": 700e-6}
    bodies = "".join(f"  {n}: {{motion: torsion, inertia: {v}}}\n" for n, v in discs.items())
    gear = "number_of_teeth: 30, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0"
    return (
        f"gears:\n  g1: {{{gear}}}\n  g2: {{{gear}}}\n"
        f"bodies:\n{bodies}"
        "  wheel1: {gears: [g1], motion: torsion, inertia: 25e-6}\n"
        "  wheel2: {gears: [g2], motion: torsion, inertia: 25e-6}\n"
        f"meshes:\n  m: {{gears: [g1, g2], stiffness: {{law: constant, value: {mesh}}}}}\n"
        "couplings:\n"
        "  shaft: {bodies: [motor, wheel1], stiffness: {torsion: 1e4}}\n"
        "  one: {bodies: [wheel1, rotor1], stiffness: {torsion: 5e3}}\n"
        "  two: {bodies: [wheel2, rotor2], stiffness: {torsion: 5e3}}\n"
        "loads:\n  in: {body: motor, torque: 1 N m}\n  out: {body: rotor2, torque: balance}\n"
    )


def test_branched_system_with_rigid_gears():
    """Case b is printed for rigid teeth: the four modes are the limit for a stiff mesh."""
    found = find_modes(compiled(geared(1e13))[1]).frequency
    assert found[:4] == pytest.approx([0.0, 425.4, 634.1, 3247.2], abs=0.06)
    softer = find_modes(compiled(geared(1e11))[1]).frequency
    assert softer[1] < found[1] + 1e-6  # from below


@pytest.mark.parametrize(
    ("elements", "printed"),
    [
        (5, [1.9417, 4.0719, 6.5437, 9.1547]),
        (8, [1.9225, 3.9187, 6.0625, 8.4185]),
        (50, [1.9106, 3.8232, 5.7394, 7.6613]),
    ],
)
def test_drill_string(elements, printed):
    """Case d with linear elements: consistent inertia rho I_p L/6 [[2, 1], [1, 2]] on the springs G I_p/L.

    The bodies here are lumped, so the consistent inertia is put on the matrices of the same chain.
    """
    import numpy as np

    from pitchpoint.solvers.eigen import undamped

    area = math.pi / 32.0 * (0.78**4 - 0.65**4)
    length = 800.0 / elements
    n = elements + 1
    M, K = np.zeros((n, n)), np.zeros((n, n))
    for e in range(elements):
        M[e : e + 2, e : e + 2] += 8000.0 * area * length / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]])
        K[e : e + 2, e : e + 2] += 75e9 * area / length * np.array([[1.0, -1.0], [-1.0, 1.0]])
    M[0, 0] += 200.0
    M[-1, -1] += 10.0
    omega, _ = undamped(M, K, np.eye(n), np.zeros((0, n)))
    assert omega[0] == 0.0
    assert omega[1:5] / (2 * math.pi) == pytest.approx(printed, abs=6e-5)
