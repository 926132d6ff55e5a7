# SPDX-License-Identifier: Apache-2.0
"""The bevel mesh against others: cylindrical gears, the formula of its cycle, itself with gears exchanged."""

import dataclasses
import math

import numpy as np
import pytest

from pitchpoint.contact.bevel_cycle import bevel_cycle
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.contact.stiffness.din3990 import VirtualTooth, single_stiffness, stiffness_of_teeth
from pitchpoint.elements.mesh.bevel.record import N_OUT
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.pair import BevelPair
from pitchpoint.system.rules.bevel_mesh import square_mean
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.invariants.test_bevel_mesh import BARE, CONSTANT, PAIR, PAIRS, both_flanks, every_pair, mesh
from tests.support.one_bevel import OneBevel, make_bevels
from tests.support.one_mesh import OneMesh, make_pair


def vars_of(gear):
    """Fields of a gear."""
    return {f.name: getattr(gear, f.name) for f in dataclasses.fields(gear)}


def limit(Sigma, beta, flank):
    """Largest differences between a bevel pair and the cylindrical one, over the force, and b/R_m."""
    z1, z2, b, shape = 25, 60, 0.03, PairShape(c_prime=14e9, S_R=0.8, T_R=0.3)
    bevels = make_bevels(z1, z2, Sigma, beta, 3e-3, b)
    m = OneBevel(bevels, MeshLaws(stiffness=shape), backlash=3e-5, apexes=(0.0, 0.0))
    pair = make_pair(z1, z2, beta, 3e-3, b, widening=0.0)
    straight = OneMesh(pair, MeshLaws(stiffness=shape), backlash=3e-5)
    left = [m.row["r_b1"] / straight.row["r_b1"] - 1.0, m.row["r_b2"] / straight.row["r_b2"] - 1.0]
    for _ in range(3):
        way = 0.31 * straight.row["p_bt"]
        straight.frames["phi"] += [way / straight.row["r_b1"], -way / straight.row["r_b2"]]
        m.roll(0.31)
        straight.press(1e-5, flank)
        m.press(1e-5, flank)
        left += [m.row["now"]["eps"] - pair.eps_alpha, m.get("mesh_phase") - straight.get("mesh_phase")]
        scale = abs(straight.get("mesh_force"))
        for name in ("mesh_force", "circumferential_force", "radial_force", "axial_force", "normal_force"):
            left.append((m.get(name) - straight.get(name)) / scale)
        for name in ("mesh_stiffness", "elastic_energy", "penetration"):
            left.append(m.get(name) / straight.get(name) - 1.0)
    return max(abs(x) for x in left), b / bevels.R_m


@pytest.mark.parametrize("beta", [0.0, 0.3])
@both_flanks
def test_cylindrical_limit(beta, flank):
    """As the shaft angle goes to zero, with one c' and one backlash: phase, forces and stiffness of the
    cylindrical pair, to the order of b/R_m, which here is also that of the cone angles.

    The difference is a b/R_m + c (b/R_m)^2 with c of the order of a: a quarter to the relative order b/R_m of
    the coarse one, and a is the outer radius over the mean one in the deflection and in its lever: 1 to 1.2.
    """
    coarse, fine = (limit(Sigma, beta, flank) for Sigma in (4e-3, 1e-3))
    assert fine[1] < fine[0] < 1.2 * fine[1] < 3e-4
    assert fine[0] == pytest.approx(0.25 * coarse[0], rel=2.0 * coarse[1])


@pytest.mark.parametrize("pair", ["straight", "right", "left"])
@both_flanks
@pytest.mark.parametrize("shape", [PAIR, BARE], ids=["ramp", "bare"])
def test_the_cycle_of_the_stiffness_is_that_of_the_formula(pair, flank, shape):
    """Rigid gears in their places, phase by phase; the mean over the cycle is that of spur gears."""
    m = mesh(pair, shape)
    face = (m.pair.R_i / m.pair.R_m, m.pair.R_e / m.pair.R_m)
    rate = flank * math.tan(m.pair.beta_b) / m.pair.sigma_p
    cycle = bevel_cycle(shape, m.pair.eps_alpha, rate, face, 4001)
    for _ in range(7):
        m.roll(0.137)
        m.press(1e-6, flank)
        psi = (
            m.get("mesh_phase") if flank > 0 else float(m.row["now"]["psi"])
        )  # the back flank is the last one summed
        ratio = m.get("mesh_stiffness") / (shape.c_prime * square_mean(m.pair))
        expected = np.interp(psi, cycle.phase, cycle.stiffness_ratio)
        assert ratio == pytest.approx(expected, rel=3e-6)
    if rate != 0.0:
        assert cycle.stiffness_ratio[:-1].mean() == pytest.approx(cycle.mean, rel=1e-6)


def test_single_stiffness_of_the_cylindrical_limit():
    """Virtual gears of bevel gears that are nearly cylindrical are the virtual spur gears of these."""
    bevels, pair = make_bevels(25, 60, 1e-3, 0.3, 3e-3, 0.03), make_pair(25, 60, 0.3, 3e-3, 0.03)
    one, two = (
        VirtualTooth(g.z_vn, g.x_hm, g.rack.h_fP_star, g.alpha_n, g.beta_m)
        for g in (bevels.gear1, bevels.gear2)
    )
    found = stiffness_of_teeth((one, two), bevels.eps_alpha)
    assert found.c_prime == pytest.approx(single_stiffness(pair).c_prime, rel=1e-6)


@every_pair
@both_flanks
def test_numbering_the_gears_the_other_way_changes_nothing(pair, flank):
    """Gear 2 as gear 1, with another face width than its mate: what was E is A, the rest is the same."""
    given = make_bevels(**PAIRS[pair])
    wide = BevelGear(**{**vars_of(given.gear2), "b": 1.2 * given.gear2.b})
    m = OneBevel(BevelPair(given.gear1, wide, given.Sigma), MeshLaws(stiffness=PAIR))
    other = OneBevel(BevelPair(wide, given.gear1, given.Sigma), MeshLaws(stiffness=PAIR))
    for _ in range(3):
        m.roll(0.29)
        m.press(1e-5, flank)
        other.press(1e-5, flank)
        pitches = [x.get("mesh_phase") if flank > 0 else float(x.row["now"]["psi"]) for x in (m, other)]
        other.roll(flank * (m.row["now"]["eps"] - pitches[0] - pitches[1]))
        other.press(1e-5, flank)
        for name in (
            "mesh_force",
            "mesh_stiffness",
            "normal_force",
            "circumferential_force",
            "elastic_energy",
        ):
            assert other.get(name) == pytest.approx(m.get(name), rel=1e-9), name
        for name in ("axial_force", "radial_force"):
            assert other.get(name) == pytest.approx(m.get(f"{name}_1"), rel=1e-9)
            assert other.get(f"{name}_1") == pytest.approx(m.get(name), rel=1e-9)


@every_pair
def test_events_change_sign_where_flanks_touch(pair):
    """Apart they are the gap at R_m; in contact that of the deepest place, in the outer half of the face."""
    m = mesh(pair, PAIR)
    outer = m.pair.R_e / m.pair.R_m
    for flank in (1, -1):
        for depth, sign in ((-1e-7, -1.0), (1e-7, 1.0)):
            m.press(depth, flank)
            gap = m.events[0 if flank > 0 else 1]
            assert math.copysign(1.0, gap) == sign
            if depth < 0.0:
                assert gap == pytest.approx(depth, rel=1e-9)
            else:
                assert 0.5 * (1.0 + outer) * depth < gap <= outer * depth
            assert m.events[1 if flank > 0 else 0] < 0.0


@pytest.mark.parametrize("smooth, share", [(False, 0.25), (True, 0.15625)])
def test_contact_damping_grows_with_the_penetration(smooth, share):
    """At a quarter of s_0, on a face so narrow that the penetration is even: 1/4 of the damping, or
    t^2 (3 - 2 t) = 0.15625 of it."""
    m = OneBevel(
        make_bevels(b=1e-5), MeshLaws(stiffness=CONSTANT, d_in=2e4, d_out=2e4, s_0=4e-5, smooth=smooth)
    )
    m.press(1e-5)
    at_rest = m.get("mesh_force")
    m.frames["tw"][0, 3:] = 0.01 / m.row["r_b1"] * m.axes[0][:, 2]
    m.evaluate()
    assert m.get("mesh_force") - at_rest == pytest.approx(share * 2e4 * 0.01, rel=1e-5)


def test_sliding_is_that_of_two_rolling_cones():
    """Each pair loses mu F_n |omega_1 - omega_2| R sin(sigma)."""
    m = OneBevel(make_bevels(b=1e-5), MeshLaws(stiffness=PAIR, mu=0.1, v_eps=1e-6))
    m.roll(0.4)
    m.press(1e-5)
    speeds = 100.0, -100.0 * m.row["r_b1"] / m.row["r_b2"]
    for k in range(2):
        m.frames["tw"][k, 3:] = speeds[k] * m.axes[k][:, 2]
    m.evaluate()
    row = m.row
    relative = np.linalg.norm(m.frames["tw"][0, 3:] - m.frames["tw"][1, 3:])
    assert relative == pytest.approx(100.0 * math.sin(m.pair.Sigma) / math.sin(m.pair.gear2.delta), rel=1e-9)
    forces = sorted(f for f in m.out[N_OUT : N_OUT + int(row["n_pair"])] if f > 0.0)
    psi = m.get("mesh_phase")
    sigma = [
        (row["now"]["xi_A"] + (psi + q) * row["p_bt"]) / row["R_m"]
        for q in range(2)
        if psi + q < row["now"]["eps"]
    ]
    assert len(forces) == len(sigma)
    zeta = [2.0 * (psi + q) / row["now"]["eps"] - 1.0 for q in range(len(sigma))]
    order = sorted(range(len(sigma)), key=lambda q: 1.0 - 0.2 * zeta[q] ** 2)
    lost = sum(0.1 * forces[i] * relative * row["R_m"] * abs(math.sin(sigma[q])) for i, q in enumerate(order))
    assert m.get("friction_power") == pytest.approx(lost, rel=1e-4)
