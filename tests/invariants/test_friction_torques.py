# SPDX-License-Identifier: Apache-2.0
"""Torques of friction on both gears of a mesh: closed forms along the line of action, and their power.

With pairs of equal, constant stiffness the normal force on every piece of a contact line is known. Friction
acts across the line of action, whose distance from the axes is the length of roll: rho_1 = r_b1 tan(alpha) +
xi and rho_2 = r_b2 tan(alpha) - xi (signed r_b2). In the plane of action of bevel gears, tangent to both base
cones, axis k leans against the plane by delta_bk and is seen from the pitch ray at Gamma_k, cos(Gamma_k) =
cos(delta_k)/cos(delta_bk): the arm of a force across that plane at the cone distance R and the angle sigma
is R cos(delta_bk) sin(Gamma_k +- sigma).
"""

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.description import PairShape, PhaseStiffness
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.mesh_alone import moved
from tests.support.one_bevel import OneBevel, make_bevels
from tests.support.one_mesh import OneMesh, make_pair

EVEN = PairShape(c_prime=14e9, S_R=1.0, T_R=0.0)
MU = 0.07
COULOMB = dict(mu=MU, v_eps=1e-7)
PAIRS = {
    "spur": dict(beta=0.0),
    "helical": dict(beta=0.3),
    "left": dict(beta=-0.25),
    "internal spur": dict(beta=0.0, z2=70, internal=True),
    "internal helical": dict(beta=0.2, z2=70, internal=True),
}
BEVELS = {"straight": dict(), "miter 75 deg": dict(z1=18, z2=18, Sigma=math.radians(75.0))}
SPIRAL = dict(beta=0.5)
both_flanks = pytest.mark.parametrize("flank", [1, -1])


def spun(m, slip=0.0):
    """Speeds of gears that roll on each other but for a slip, and their twists."""
    r1, r2 = float(m.row["r_b1"]), float(m.row["r_b2"])
    speeds = np.array([80.0, -80.0 * (1.0 + slip) * r1 / r2])
    m.frames["spin"] = speeds
    for k in range(2):
        m.frames["tw"][k] = 0.0
        m.frames["tw"][k, 3:] = speeds[k] * m.frames["R"][k][:, 2]
    return speeds


def along_the_path(m, speeds):
    """Torques by hand: every piece between ends of contact and the pitch point has its middle as centroid."""
    row = m.row
    tan_a = math.tan(m.pair.alpha_wt)
    load = 14e9 * 8e-6 * MU * math.sqrt(1.0 + row["tan_b"] ** 2)  # per width, of 8 µm on every line
    found = np.zeros(2)
    for q in range(-9, 9):
        ends = [row["now"]["z_lo"], row["now"]["z_hi"]]
        if row["now"]["lam"] != 0.0:
            for p in (0.0, row["now"]["eps"], -row["now"]["xi_A"] / row["p_bt"]):
                ends.append(min(max((p - row["now"]["psi"] - q) / row["now"]["lam"], ends[0]), ends[1]))
        ends.sort()
        for a, c in zip(ends[:-1], ends[1:], strict=True):
            p = row["now"]["psi"] + q + 0.5 * row["now"]["lam"] * (a + c)
            if 0.0 < p < row["now"]["eps"]:
                xi = row["now"]["xi_A"] + p * row["p_bt"]
                rolls = np.array([row["r_b1"] * tan_a + xi, row["r_b2"] * tan_a - xi])
                sliding = speeds[0] * rolls[0] + speeds[1] * rolls[1]
                found -= math.copysign(load * (c - a), sliding) * rolls
    return found


@pytest.mark.nojit
@pytest.mark.parametrize("pair", PAIRS)
@both_flanks
def test_cylindrical_gears_have_the_length_of_roll_as_arm(pair, flank):
    """To round-off: nodes of the width integral are exact for what is linear on a piece."""
    m = OneMesh(make_pair(**PAIRS[pair]), MeshLaws(stiffness=EVEN, **COULOMB))
    apart = 0
    for share in (0.05, 0.3, 0.55, 0.8):
        way = share * m.row["p_bt"]
        m.frames["phi"] = [way / m.row["r_b1"], -way / m.row["r_b2"]]
        m.press(8e-6, flank)
        speeds = spun(m)
        m.evaluate()
        expected = along_the_path(m, speeds)
        assert m.friction_torques() == pytest.approx(expected, rel=1e-9, abs=1e-9 * abs(expected).max())
        apart += int(abs(expected).min() > 1.0)
    assert apart > 0


@pytest.mark.nojit
@pytest.mark.parametrize("pair", BEVELS)
@both_flanks
def test_straight_bevel_gears_have_the_arm_of_their_plane_of_action(pair, flank):
    m = OneBevel(make_bevels(**BEVELS[pair]), MeshLaws(stiffness=EVEN, **COULOMB))
    for _ in range(4):
        m.roll(0.23)
        m.press(8e-6, flank)
        speeds = spun(m)
        m.evaluate()
        row = m.row
        delta = np.array([m.pair.gear1.delta, m.pair.gear2.delta])
        base = np.arcsin(np.sin(delta) * row["now"]["cos_a"])
        gamma = np.arccos(np.cos(delta) / np.cos(base))
        psi = m.get("mesh_phase") if flank > 0 else row["now"]["psi"]  # that of the flank looked at last
        places = [psi + q for q in range(-9, 9) if 0.0 < psi + q < row["now"]["eps"]]
        expected = np.zeros(2)
        for p in places:
            sigma = (row["now"]["xi_A"] + p * row["p_bt"]) / row["R_m"]
            arms = row["R_m"] * np.cos(base) * np.sin(gamma + np.array([sigma, -sigma]))
            force = MU * abs(m.get("mesh_force")) / len(places)
            expected -= math.copysign(force, float(speeds @ arms)) * arms
        assert m.friction_torques() == pytest.approx(expected, rel=1e-9, abs=1e-9 * abs(expected).max())


def of(kind):
    laws = MeshLaws(stiffness=EVEN, mu=MU, v_eps=0.05, d_in=3e4, d_out=2e4, d_gap=5e3)
    if kind in PAIRS:
        return OneMesh(make_pair(**PAIRS[kind]), laws, n_pair=3)
    sides = (-1.0, 1.0) if kind == "spiral" else (1.0, 1.0)
    return OneBevel(make_bevels(**(BEVELS | {"spiral": SPIRAL})[kind]), laws, sides=sides)


@pytest.mark.parametrize("kind", [*PAIRS, *BEVELS, "spiral"])
@both_flanks
def test_they_are_what_friction_adds_to_the_wrenches_and_take_its_power(kind, flank):
    """With damping and damper, on gears that have moved, leaned and slip; about the axes where they are."""
    m = of(kind)
    rng = np.random.default_rng(4)
    for body in range(2):
        m.frames = moved(m.frames, body, rng.normal(size=6) * [1e-5, 1e-5, 2e-5, 2e-4, 2e-4, 0.0])
    m.press(3e-5, flank)
    speeds = spun(m, 0.003)
    F = m.evaluate()
    torques, lost = m.friction_torques(), m.get("friction_power")
    m.rec["contact"]["mu"] = 0.0
    added = F - m.evaluate()
    axes = np.array([R[:, 2] for R in m.frames["R"]])
    assert torques == pytest.approx((added[:, 3:] * axes).sum(axis=1), rel=1e-9)
    assert float(torques @ speeds) == pytest.approx(-lost, rel=1e-9)
    assert lost > 0.0
    assert not m.friction_torques().any()


@pytest.mark.parametrize("make", [OneMesh, OneBevel])
def test_a_mesh_without_friction_has_no_such_channels(make):
    from pitchpoint.elements import bevel_mesh, gear_mesh

    module = gear_mesh if make is OneMesh else bevel_mesh
    pair = make_pair() if make is OneMesh else make_bevels()
    names = {
        mu: [name for name, _, _ in module.outputs(make(pair, MeshLaws(stiffness=EVEN, mu=mu)).row)]
        for mu in (0.0, 0.05)
    }
    assert names[0.05] == [*names[0.0], "friction_torque_1", "friction_torque_2"]


def test_a_prescribed_stiffness_acts_at_the_pitch_point_and_hardly_rubs():
    """Rolling gears do not slide there, so nothing is lost; what slips is pulled along with one arm."""
    m = OneMesh(make_pair(beta=0.0), MeshLaws(stiffness=PhaseStiffness(mean=4e8), **COULOMB))
    m.press(8e-6)
    speeds = spun(m, 0.01)
    m.evaluate()
    rolls = np.array([m.row["r_b1"], m.row["r_b2"]]) * math.tan(m.pair.alpha_wt)
    force = math.copysign(MU * m.get("mesh_force"), float(speeds @ rolls))
    assert m.friction_torques() == pytest.approx(-force * rolls, rel=1e-9)
