# SPDX-License-Identifier: Apache-2.0
"""TG-FRIS: torsional chains of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010).

Values as in the public test-suite of openTorsion, which quotes the book; discs need no frame mapping.
Tolerance 0.01 Hz (a) and 0.05 Hz (b): one unit of the last printed digit.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.shaft_beam import shaft_row
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.bodies import Body
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import chain, couplings, frequencies, gear_rows


def test_case_a_chain_of_five_discs():
    system = chain([3.5e-3] * 3 + [0.15, 0.05], [12e3, 12e3, 14e3, 10e3])
    M, _, K = evaluate.linearize(system, system.initial_state())
    assert frequencies(M, K) == pytest.approx([0.0, 81.21, 141.21, 378.95, 536.36], abs=0.01)


def test_case_b_two_rotors_over_equal_gears():
    # motor, gear, (1:1 mesh as a rigid coupling) gear, two rotors; the null space eliminates the constraint
    names = ("motor", "gear1", "gear2", "rotor1", "rotor2")
    inertias = (400e-6, 25e-6, 25e-6, 700e-6, 700e-6)
    bodies = [Body(polar_inertia=i, name=n) for i, n in zip(inertias, names, strict=True)]
    links = couplings([(1, 2, 1e4, 0.0, 0.0), (2, 4, 5e3, 0.0, 0.0), (3, 5, 5e3, 0.0, 0.0)])
    system = assemble(bodies, {"coupling": links}, {"ratio": gear_rows([(2, 3, 20, 20)])})
    state = system.initial_state()
    M, _, K = evaluate.linearize(system, state)
    G = evaluate.constraint_jacobian(system, state)
    _, _, vt = np.linalg.svd(G)
    null = vt[G.shape[0] :].T
    found = frequencies(null.T @ M @ null, null.T @ K @ null)
    assert found == pytest.approx([0.0, 425.4, 634.1, 3247.2], abs=0.05)


@pytest.mark.parametrize(
    ("pieces", "published"),
    [
        (5, (1.9417, 4.0719, 6.5437, 9.1547)),
        (8, (1.9225, 3.9187, 6.0625, 8.4185)),
        (50, (1.9106, 3.8232, 5.7394, 7.6613)),
    ],
)
def test_case_d_a_drill_string_of_pieces(pieces, published):
    """800 m of pipe 0.78/0.65 m between discs of 200 and 10 kg m^2; linear elements with consistent mass."""
    shape = Beam(section=tube(0.78, 0.65), length=800.0 / pieces, E=2e11, G=75e9, rho=8000.0)
    ends = {0: 200.0, pieces: 10.0}
    bodies = [
        Body(position=(0.0, 0.0, 800.0 / pieces * k), polar_inertia=ends.get(k, 1e-9), name=f"n{k}")
        for k in range(pieces + 1)
    ]
    rows = [shaft_row(shape, bodies=(k + 1, k + 2)) for k in range(pieces)]
    system = assemble(bodies, {"shaft_beam": np.concatenate(rows)})
    M, _, K = evaluate.linearize(system, system.initial_state())
    for frequency, value in zip(frequencies(M, K)[1:], published, strict=False):
        assert frequency == pytest.approx(value, abs=1e-4)
