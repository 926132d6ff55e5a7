# SPDX-License-Identifier: Apache-2.0
"""TG-FRIS: torsional chains of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010).

Values as in the public test-suite of openTorsion, which quotes the book; discs need no frame mapping.
Tolerance 0.01 Hz (a) and 0.05 Hz (b): one unit of the last printed digit.
"""

from __future__ import annotations

import numpy as np
import pytest

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
