# SPDX-License-Identifier: Apache-2.0
"""What every registered stiffness source must obey; a source that is not listed here fails the build."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.mesh_cycle import pair_cycle, phase_cycle
from pitchpoint.contact.pair_shape import phase_stiffness
from pitchpoint.contact.stiffness import law_function
from pitchpoint.contact.stiffness.description import PhaseStiffness
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.model.components.stiffness import LAWS, OF_PAIRS
from tests.support.width_moments import table_width_moments, width_moments

OPTIONS = {
    "din3990": [{}, {"T_R": 0.3}, {"S_R": 1.0}, {"c_prime": 14e9, "low_load": True}],
    "energy": [{}, {"T_R": 0.2, "body": "rigid"}, {"line_load": 2e5, "points": 33}],
    "hertz": [
        {"moduli": (206e9, 175e9), "poisson": (0.3, 0.29)},
        {"moduli": (206e9, 175e9), "poisson": (0.3, 0.29), "diameter": "operating", "T_R": 0.3},
        {"moduli": (206e9, 206e9), "poisson": (0.3, 0.3), "constant": 2e10, "exponent": 1.2},
    ],
    "constant": [{"mean": 3e8}],
    "rectangular": [{"high": 3e8, "low": 2e8}, {"high": 2e8, "low": 2e8, "duty": 0.4}],
    "fourier": [{"mean": 4e8, "cosine": [-0.2, -0.1, -0.05]}, {"mean": 4e8, "sine": [0.0, 0.3]}],
    "pair_table": [
        {"single_stiffness": 14e9, "values": [0.8, 1.0, 0.9, 0.7]},
        {"single_stiffness": 14e9, "values": [1.0, 1.0], "tip_relief_factor": 0.3},
    ],
    "table": [{"values": [3e8, 5e8, 4e8]}],
    "user": [{"function": lambda psi: 4e8 + 1e8 * math.cos(2 * math.pi * psi), "points": 256}],
}


def make_pair(beta, internal=False):
    first = CylindricalGear(z=31, m_n=3e-3, beta=beta, x=0.2, b=0.03)
    if internal:
        second = CylindricalGear.internal(z=80, m_n=3e-3, beta=beta, b=0.03)
    else:
        second = CylindricalGear(z=60, m_n=3e-3, beta=-beta, b=0.03)
    return GearPair.from_profile_shifts(first, second)


PAIRS = {"spur": make_pair(0.0), "helical": make_pair(0.3), "internal": make_pair(0.15, internal=True)}
CASES = [
    pytest.param(name, options, pair, id=f"{name}-{i}-{kind}")
    for name, several in OPTIONS.items()
    for i, options in enumerate(several)
    for kind, pair in PAIRS.items()
]


def total(law, pair):
    """Mesh stiffness over the phase [N/m], by an integral over the width."""
    eps_alpha, eps_beta, b = pair.eps_alpha, pair.eps_beta, pair.b_w
    if isinstance(law, PhaseStiffness):
        n, first, second = (np.array(a) if isinstance(a, np.ndarray) else a for a in law.arrays())
        return lambda psi: law.mean * phase_stiffness(psi, law.form, n, first, second)[0]
    L = law.ramp_length(eps_alpha)
    if law.table is None:
        return lambda psi: law.c_prime * width_moments(psi, eps_beta / b, b, eps_alpha, law.S_R, L)[0]
    table = np.array(law.table)
    return lambda psi: law.c_prime * table_width_moments(psi, eps_beta / b, b, eps_alpha, table, L)[0]


def test_every_source_is_covered():
    assert set(OPTIONS) == set(LAWS)


@pytest.mark.parametrize(("name", "options", "pair"), CASES)
def test_source(name, options, pair):
    law = law_function(name)(pair, **options)
    assert isinstance(law, PhaseStiffness) != (name in OF_PAIRS)
    eps_alpha, eps_beta = pair.eps_alpha, pair.eps_beta
    k = total(law, pair)
    cycle = phase_cycle(law) if isinstance(law, PhaseStiffness) else pair_cycle(law, eps_alpha, eps_beta)
    unit = law.mean if isinstance(law, PhaseStiffness) else law.c_prime * pair.b_w
    jumps = law.jumps(eps_alpha, eps_beta)
    assert jumps == cycle.jumps

    phases = np.linspace(0.0, 1.0, 1501) + 1e-4 / 3
    values = np.array([k(psi) for psi in phases])
    assert np.all(np.isfinite(values))
    assert values.min() > 0.0  # positive
    away = [psi for psi in phases[::37] if all(abs((psi - j + 0.5) % 1.0 - 0.5) > 1e-9 for j in jumps)]
    for psi in away:  # periodic
        assert k(psi + 1.0) == pytest.approx(k(psi), rel=1e-10)
        assert k(psi - 3.0) == pytest.approx(k(psi), rel=1e-10)

    # continuous but for the declared jumps, and really discontinuous there
    step = 1e-7
    for psi in [*phases[::11], *cycle.breakpoints, 0.0, eps_alpha % 1.0]:
        if all(abs((psi - j + 0.5) % 1.0 - 0.5) > 10 * step for j in jumps):
            assert abs(k(psi + step) - k(psi - step)) < 1e-4 * unit
    for j in jumps:
        assert abs(k(j + step) - k(j - step)) > 1e-2 * unit

    # extremes and mean of the cycle are those of the law
    assert cycle.minimum * unit <= values.min() * (1 + 1e-9)
    assert cycle.maximum * unit >= values.max() * (1 - 1e-9)
    assert cycle.mean * unit == pytest.approx(values[:-1].mean(), rel=2e-3)
    swing = cycle.peak_to_peak * unit
    assert values.max() - values.min() == pytest.approx(swing, abs=5e-3 * unit)
