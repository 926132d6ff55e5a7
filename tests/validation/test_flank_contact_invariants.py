# SPDX-License-Identifier: Apache-2.0
"""FC-8, FC-18: invariants of whole contact analyses of flexible teeth, backlash, interference.

* Module times k and torque times k^3 leave pressures. The additional compliance of the nodes is a share of
  the compliance of a pair at a line load of 300 N/mm, which 2 k changes by 2 %: 1e-4 of the pressure.
* Compliance matrices are symmetric to 1e-12.
* A helix angle of 0.1 degrees instead of 0 changes the highest pressure by at most 0.5 %: no jump from spur
  to helical gears.
* A centre distance changed by 1e-9 to 1e-3 of itself changes results in proportion.
* Normal backlash of 17/23, m 1 mm, a 20.05 mm, and of 17/43, m 1 mm, 20 degrees, x 0.5 and 0.2: 34.5219 and
  38.6366 um, printed to 1e-6 of themselves. The second one comes without a centre distance; like the first
  one it is 0.05 mm above that without backlash. eps_gamma of 17/43, 20 degrees, b 10 mm: 2.5805624 (closed
  forms of ISO 21771). Ring 17/-43 without profile shift: the tip circle of the ring reaches beyond
  the base circle of the pinion, it would require a tip radius of 20.687 mm and has 20.5 mm.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.compliance.gear import flank_compliance
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.flank_levels import model_of
from tests.support.whole_contact import Pair

TORQUE = 20.0


def spur(k=1.0, **more):
    return Pair(**({"z": (17, 43), "m": k, "b": 10.0 * k, "a": 30.0 * k} | more))


@pytest.mark.parametrize("k", [2.0, 5.0])
def test_module_and_torque_leave_pressures(k):
    one = spur().analysed(TORQUE, positions=16)
    two = spur(k).analysed(TORQUE * k**3, positions=16)
    found = two["pressure"].values / one["pressure"].values
    assert np.nanmax(np.abs(found - 1.0)) < 2e-4
    assert two["mesh_force"].values == pytest.approx(k**2 * one["mesh_force"].values, rel=1e-9)


@pytest.mark.parametrize("coupling", ["plate", "springs", "none"])
def test_compliance_is_symmetric(coupling):
    gear = CylindricalGear(z=17, m_n=1e-3, beta=0.2, b=10e-3)
    found = flank_compliance(gear, planes=7, coupling=coupling)
    own = found.own
    assert abs(own - own.transpose(1, 0, 3, 2)).max() < 1e-12 * abs(own).max()
    C = found.matrix(np.linspace(*found.roll, 7))
    assert abs(C - C.T).max() < 1e-12 * abs(C).max()


def test_no_jump_from_spur_to_helical_gears():
    peak = [
        float(Pair(z=(25, 31), m=3.0, b=20.0, beta=beta).analysed(200.0, positions=64)["pressure"].max())
        for beta in (0.0, 0.1)
    ]
    assert peak[1] == pytest.approx(peak[0], rel=5e-3)


def test_centre_distance_changes_results_in_proportion():
    """Differences over the change: equal from 1e-9 to 1e-5, no jump; beyond, the curvature adds to them."""
    base = spur(a=30.02).analysed(TORQUE, positions=8)
    slopes = {}
    for share in (1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3):
        found = spur(a=30.02 * (1.0 + share)).analysed(TORQUE, positions=8)
        # the mesh phase counts from A, which moves with the centre distance
        change = found["elastic_energy"].values.mean() / base["elastic_energy"].values.mean() - 1.0
        slopes[share] = change / share
    reference = slopes[1e-6]
    assert abs(reference) > 1.0
    for share, most in ((1e-9, 1e-3), (1e-7, 1e-3), (1e-5, 2e-3), (1e-4, 0.02), (1e-3, 0.2)):
        assert slopes[share] == pytest.approx(reference, rel=most)


def test_backlash_and_contact_ratio():
    pair = GearPair(CylindricalGear(z=17, m_n=1e-3), CylindricalGear(z=23, m_n=1e-3), 20.05e-3)
    assert pair.j_bn * 1e6 == pytest.approx(34.5219, rel=2e-6)
    beta = math.radians(20.0)
    shifted = [CylindricalGear(z=z, m_n=1e-3, beta=b, x=x) for z, b, x in ((17, beta, 0.5), (43, -beta, 0.2))]
    apart = GearPair(*shifted, GearPair.from_profile_shifts(*shifted).a_w + 0.05e-3)
    assert apart.j_bn * 1e6 == pytest.approx(38.6366, rel=2e-6)
    gears = (CylindricalGear(z=z, m_n=1e-3, beta=b, b=10e-3) for z, b in ((17, beta), (43, -beta)))
    assert GearPair(*gears, 30e-3 / math.cos(beta)).eps_gamma == pytest.approx(2.5805624, rel=1e-7)


def test_interference_of_a_ring_is_named():
    pair = GearPair(CylindricalGear(z=17, m_n=1e-3, b=0.01), CylindricalGear(z=-43, m_n=1e-3, b=0.01), -13e-3)
    required = math.hypot(pair.gear2.r_b, pair.T1T2) * 1e3
    assert required == pytest.approx(20.687, abs=5e-4)
    assert abs(pair.gear2.d_a) * 500.0 == pytest.approx(20.5, rel=1e-9)
    data = solve_contact(model_of(pair), torque=5.0, positions=16)
    assert "interference, g1 touches inside its base circle" in data.attrs["notes"]
    assert np.isfinite(data["transmission_error"].values).all()
