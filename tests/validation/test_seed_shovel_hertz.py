# SPDX-License-Identifier: Apache-2.0
"""SEED-SHOVEL, Table 4 and eq. 1-3 of the paper: tooth pairs as impact forces with a constant by Hertz.

Table 4 follows from eq. 3 with the operating pitch diameter as d_1 (tolerance 1e-4: the table has four
digits); the reference diameter, which the nomenclature of the paper names, gives 0.5 to 2 % less and is the
exact radius of curvature. Forces and overlaps here are normal to the flanks; the mesh element counts along
the base tangent, cos(beta_b) between them.
"""

from __future__ import annotations

import math

import pytest

from pitchpoint.contact.stiffness.hertz import equivalent_radius, hertz, hertz_constant
from pitchpoint.elements.mesh.record import N_OUT
from pitchpoint.geometry import CylindricalGear, GearPair, profile_shift_for_center_distance
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.one_mesh import OneMesh

STAGES = {
    1: (11, 81, 12, 16, 580, (130, 120)),
    2: (12, 68, 16, 12, 665, (210, 200)),
    3: (11, 36, 30, 12, 750, (280, 270)),
}
TABLE_4 = {1: 6.824e5, 2: 8.102e5, 3: 10.941e5}
STANDARD = {1: 6.78996e5, 2: 8.03634e5, 3: 10.72487e5}
MODULI, POISSON = (2.1e11, 1.75e11), (0.29, 0.29)
TO_SI = 1e3**1.5
"""N/mm^1.5 in N/m^1.5."""


def pair_of(stage):
    z1, z2, m_n, beta, a_w, (b1, b2) = STAGES[stage]
    common = {"m_n": m_n * 1e-3, "alpha_n": math.radians(20.0)}
    x = profile_shift_for_center_distance(z_sum=z1 + z2, beta=math.radians(beta), a_w=a_w * 1e-3, **common)
    pinion = CylindricalGear(z=z1, beta=math.radians(beta), x=0.5 * x, b=b1 * 1e-3, **common)
    wheel = CylindricalGear(z=z2, beta=-math.radians(beta), x=0.5 * x, b=b2 * 1e-3, **common)
    return GearPair(pinion, wheel, a_w * 1e-3)


@pytest.mark.parametrize("stage", STAGES)
def test_table_4(stage):
    pair = pair_of(stage)
    operating = hertz_constant(pair, MODULI, POISSON, "operating") / TO_SI
    assert operating == pytest.approx(TABLE_4[stage], rel=1e-4)
    assert hertz_constant(pair, MODULI, POISSON) / TO_SI == pytest.approx(STANDARD[stage], rel=1e-5)


@pytest.mark.parametrize("stage", STAGES)
def test_the_reference_diameter_is_the_exact_curvature(stage):
    """Radii of curvature of two involutes at the pitch point, normal to the flanks; and from the wheel."""
    pair = pair_of(stage)
    rho = [0.5 * g.d_b * math.tan(pair.alpha_wt) / math.cos(g.beta_b) for g in (pair.gear1, pair.gear2)]
    assert equivalent_radius(pair) == pytest.approx(1.0 / (1.0 / rho[0] + 1.0 / rho[1]), rel=1e-13)
    swapped = GearPair(pair.gear2, pair.gear1, pair.a_w)
    for diameter in ("reference", "operating"):
        assert equivalent_radius(swapped, diameter) == pytest.approx(
            equivalent_radius(pair, diameter), rel=1e-13
        )


def one_mesh(stage, **laws):
    pair = pair_of(stage)
    law = hertz(pair, moduli=MODULI, poisson=POISSON, diameter="operating")
    return OneMesh(pair, MeshLaws(stiffness=law, **laws), backlash=1e-4, n_pair=4)


def test_penetration_of_stage_3_at_the_stated_output():
    """SHOVEL-437: 861.2 kN on one pair press it in by 0.853 mm. The mesh shares the force among its pairs;
    the pairs whose contact lines run over the whole width carry K delta^1.5 each."""
    m = one_mesh(3)
    delta = (861.2e3 / (TABLE_4[3] * TO_SI)) ** (2.0 / 3.0)
    assert delta == pytest.approx(0.853e-3, rel=1e-3)
    cos_b = math.cos(m.pair.gear1.beta_b)
    largest = 0.0
    for k in range(60):
        m.frames["phi"][0] = k * 2.0 * math.pi / 11 / 60
        m.frames["phi"][1] = -m.frames["phi"][0] * 11 / 36
        m.press(delta / cos_b)
        assert m.get("penetration") == pytest.approx(delta, rel=1e-9)
        largest = max(largest, *m.out[N_OUT : N_OUT + 4])
    # eps_alpha of stage 3 is 1.2, its overlap 0.6: lines over the whole width exist in part of the cycle
    assert largest / cos_b == pytest.approx(861.2e3, rel=2e-4)


@pytest.mark.parametrize("depth, share", [(0.05e-3, 0.5), (0.1e-3, 1.0), (0.3e-3, 1.0), (0.02e-3, 0.104)])
def test_impact_damping_grows_by_the_cubic_step(depth, share):
    """C S(delta/d) delta' per pair with the normalised argument: S(d/2) = 0.5, S(0.2) = 0.104."""
    from pitchpoint.model.components.mesh import ContactDamping
    from pitchpoint.system.rules.mesh_laws import flank_damping, mean_stiffness

    C, speed = 1e6, 1e-3  # 1000 N s/mm
    pair = pair_of(1)
    law = hertz(pair, moduli=MODULI, poisson=POISSON)
    k = mean_stiffness(pair, law)
    damping = ContactDamping(pair=C, s_0=0.1e-3, law="smooth")
    given = flank_damping(damping, math.cos(pair.gear1.beta_b), law.c_prime * pair.b_w, k, 0.0)
    m = OneMesh(pair, MeshLaws(stiffness=law, k_ref=k, **given), backlash=1e-4)
    cos_b = math.cos(pair.gear1.beta_b)
    m.press(depth / cos_b)
    rest = m.get("normal_force")
    pairs = rest / (hertz_constant(pair, MODULI, POISSON) * depth**1.5)  # whole pairs in contact
    for sign in (1.0, -1.0):
        m.frames["tw"][0, 5] = sign * speed / cos_b / m.row["r_b1"]
        m.evaluate()
        # opposes the motion
        assert m.get("normal_force") - rest == pytest.approx(sign * pairs * C * share * speed, rel=1e-9)


def test_a_parting_flank_never_pulls():
    """Parting at 1 m/s the damping would pull with 1 MN against 86 kN: the flank lets go."""
    m = one_mesh(1, d_in=1e6, d_out=1e6, s_0=1e-4)
    m.press(0.2e-3)
    assert m.get("normal_force") > 0.0
    m.frames["tw"][0, 5] = -1.0 / m.row["r_b1"]
    m.evaluate()
    assert m.get("normal_force") == 0.0


@pytest.mark.parametrize("e", [0.9, 0.5])
def test_restitution_gives_back_its_share_of_the_speed(e):
    """A gear that hits at the stated speed leaves with the share e of it; independent integration of one
    degree of freedom with the force of the element in 2700 steps: error 2e-9."""
    from pitchpoint.contact.impact import restitution_factor

    speed, inertia = 0.1, 4.0
    m = one_mesh(1, chi=restitution_factor(e) / speed)
    m.press(0.0)
    r_b, phi, rate, h = float(m.row["r_b1"]), float(m.frames["phi"][0]), speed / float(m.row["r_b1"]), 2e-6
    start = phi
    while True:
        # leapfrog with the rate of the half step: second order
        half = rate + 0.5 * h * _torque(m, phi, rate) / inertia
        phi += h * half
        rate = half + 0.5 * h * _torque(m, phi, half) / inertia
        if phi <= start:
            break
    assert -rate * r_b / speed == pytest.approx(e, rel=1e-7)


def _torque(m, phi, rate):
    m.frames["phi"][0] = phi
    m.frames["tw"][0, 5] = rate
    return m.evaluate()[0, 5]


@pytest.mark.parametrize("v, mu", [(1e-3, 0.1), (5.5e-3, 0.09), (20e-3, 0.08), (0.5e-3, 0.06875)])
def test_static_and_dynamic_friction(v, mu):
    """0.1 at 1 mm/s, 0.08 from 10 mm/s on, 0.09 at 5.5 mm/s; 0.6875 of the static one at half its speed."""
    pair = pair_of(2)
    law = hertz(pair, moduli=MODULI, poisson=POISSON)
    m = OneMesh(pair, MeshLaws(stiffness=law, mu=0.08, v_eps=10e-3, mu_s=0.1, v_s=1e-3), backlash=1e-4)
    m.press(0.2e-3)
    # both gears translate along tau of the front flank against each other: every point slides at v
    n = math.cos(pair.alpha_wt), math.sin(pair.alpha_wt)
    e = math.cos(m.theta), math.sin(m.theta)
    t = -e[1], e[0]
    tau = [-(n[0] * t[1] + n[1] * e[1]), n[0] * t[0] + n[1] * e[0]]  # m x n
    m.frames["tw"][0, :2] = [v * x for x in tau]
    m.evaluate()
    assert m.get("friction_power") == pytest.approx(mu * m.get("normal_force") * v, rel=1e-9)
