# SPDX-License-Identifier: Apache-2.0
"""SEED-SHOVEL: crawler gearbox of a mining shovel, three helical stages (founding paper on the shovel).

Inputs are printed: teeth, normal modules, helix angles, pressure angle, centre distances, face widths. The
numbers below were derived from them with independent code and are given to 5-6 digits, so the tolerance is
half a unit of the last digit (better than the 1e-4 asked for). Profile shifts are not printed: only their
sum follows from the centre distance, and nothing checked here depends on how it is shared.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.geometry import CylindricalGear, GearPair, profile_shift_for_center_distance
from tests.support.printed import printed

STAGES = {
    1: (11, 81, 12, 16, 580, (130, 120)),
    2: (12, 68, 16, 12, 665, (210, 200)),
    3: (11, 36, 30, 12, 750, (280, 270)),
}
DERIVED = {
    1: "20.73857 15.01159 574.2453 22.19147 0.495790 137.3195 138.6957 0.87738".split(),
    2: "20.41031 11.26652 654.2980 22.75958 0.706365 196.2894 199.5000 0.82725".split(),
    3: "20.41031 11.26652 720.7501 25.75401 1.101642 337.3724 351.0638 0.59562".split(),
}


@pytest.mark.parametrize("stage", STAGES)
def test_derived_geometry(stage):
    z1, z2, m_n, beta, a_w, (b1, b2) = STAGES[stage]
    common = {"m_n": m_n * 1e-3, "alpha_n": math.radians(20.0)}
    x_sum = profile_shift_for_center_distance(
        z_sum=z1 + z2, beta=math.radians(beta), a_w=a_w * 1e-3, **common
    )
    pinion = CylindricalGear(z=z1, beta=math.radians(beta), x=0.5 * x_sum, b=b1 * 1e-3, **common)
    wheel = CylindricalGear(z=z2, beta=-math.radians(beta), x=0.5 * x_sum, b=b2 * 1e-3, **common)
    pair = GearPair(pinion, wheel, a_w * 1e-3)
    ours = [
        math.degrees(pinion.alpha_t),
        math.degrees(pinion.beta_b),
        pair.a_d * 1e3,
        math.degrees(pair.alpha_wt),
        pair.x_sum,
        pinion.d * 1e3,
        pair.d_w1 * 1e3,
        pair.eps_beta,
    ]
    for value, text in zip(ours, DERIVED[stage], strict=True):
        assert value == printed(text)
    assert pair.j_bt == pytest.approx(0.0, abs=1e-15)
    assert pair.d_w1 == pytest.approx(2.0 * pair.a_w / (1.0 + pair.u), rel=1e-14)


def test_the_whole_shift_on_the_wheel_of_stage_one_leaves_an_undercut_pinion():
    """An unshifted pinion of 11 teeth runs, but on less involute than the tip circles promise."""
    z1, z2, m_n, beta, a_w, _ = STAGES[1]
    pinion = CylindricalGear(z=z1, m_n=m_n * 1e-3, beta=math.radians(beta), b=0.12)
    wheel = CylindricalGear(z=z2, m_n=m_n * 1e-3, beta=-math.radians(beta), x=0.49579, b=0.12)
    pair = GearPair(pinion, wheel, a_w * 1e-3)
    assert not pair.problems()
    assert ["undercut" in p.text for p in pair.warnings()] == [True]
    assert pair.eps_alpha_form < 1.22 < pair.eps_alpha
