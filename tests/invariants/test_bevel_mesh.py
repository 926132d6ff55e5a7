# SPDX-License-Identifier: Apache-2.0
"""Rules of a flank law, run on the bevel mesh for straight and spiral teeth, both flanks and both laws.

Sums over the width have five Gauss points per piece: on the pieces of these pairs they are good to 1e-9.
"""

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.description import PairShape, PhaseStiffness
from pitchpoint.elements.mesh.bevel.record import N_OUT
from pitchpoint.geometry.bevel.gear import BevelGear
from pitchpoint.geometry.bevel.pair import BevelPair
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.mesh_alone import moved, rotation
from tests.support.one_bevel import OneBevel, make_bevels

PAIRS = {
    "straight": dict(),
    "right": dict(beta=0.6),
    "left": dict(beta=-0.5, z1=15, z2=45),
    "miter 75 deg": dict(z1=18, z2=18, Sigma=math.radians(75.0)),
    "spiral 110 deg": dict(beta=0.4, Sigma=math.radians(110.0), z2=30),
}
CONSTANT = PhaseStiffness(mean=4e8)
PAIR = PairShape(c_prime=14e9, S_R=0.8, T_R=0.3)
BARE = PairShape(c_prime=14e9, S_R=0.8)
SOFT = PairShape(c_prime=14e9, S_R=0.8, load_limit=1e5)


every_pair = pytest.mark.parametrize("pair", PAIRS)
both_flanks = pytest.mark.parametrize("flank", [1, -1])
both_laws = pytest.mark.parametrize("shape", [CONSTANT, PAIR], ids=["constant", "pair"])


def mesh(pair, shape=CONSTANT, sides=(1.0, 1.0), **laws):
    return OneBevel(make_bevels(**PAIRS[pair]), MeshLaws(stiffness=shape, **laws), sides=sides)


def shaken(m, shift, tilt, seed=1):
    """Both bodies displaced and tilted by random small amounts."""
    rng = np.random.default_rng(seed)
    for body in range(2):
        step = np.concatenate((shift * rng.normal(size=3), tilt * rng.normal(size=3)))
        m.frames = moved(m.frames, body, step)
    return m


def slope(m, value, bodies=(0, 1)):
    """Derivative of what `value` gives over world twists of both bodies, by differences, last axes (2, 6)."""
    found = []
    for body in bodies:
        for k in range(6):
            h = 2e-9 if k < 3 else 5e-8
            step = np.zeros(6)
            step[k] = h
            ends = []
            for sign in (1, -1):
                F = m.evaluate(moved(m.frames, body, sign * step))
                ends.append(value(F))
            found.append((np.asarray(ends[0]) - ends[1]) / (2 * h))
    return np.moveaxis(np.array(found), 0, -1).reshape(*np.shape(found[0]), len(bodies), 6)


@pytest.mark.nojit
@every_pair
@both_flanks
@pytest.mark.parametrize("sides", [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)])
def test_torques_are_as_the_numbers_of_teeth(pair, flank, sides):
    """T2/T1 = z2/z1 exactly, whatever the phase; both are base radius times mesh_force."""
    m = mesh(pair, PAIR, sides)
    for _ in range(3):
        m.roll(0.37)
        m.press(1e-5, flank)
        F = m.evaluate()
        T = [F[k, 3:] @ m.axes[k][:, 2] for k in range(2)]
        assert T[1] / T[0] == pytest.approx(m.row["z2"] / m.row["z1"], rel=1e-12)
        assert T[0] == pytest.approx(-m.row["r_b1"] * m.get("mesh_force"), rel=1e-12)
        assert m.get("contact_state") == flank


@every_pair
@both_flanks
def test_textbook_components_at_the_pitch_ray(pair, flank):
    """ISO 23509 and Niemann/Winter: straight F_r = F_t tan alpha cos delta, F_a = F_t tan alpha sin delta;
    spiral F_a = F_t/cos beta_m (tan alpha_n sin delta +- sin beta_m cos delta), F_r = F_t/cos beta_m
    (tan alpha_n cos delta -+ sin beta_m sin delta), upper signs where a concave flank of the gear drives or
    is driven: the front flank of a right-hand gear 1, and not of its mate. F_a points away from the apex."""
    m = mesh(pair)
    m.press(2e-5, flank)
    m.evaluate()
    F_t = m.get("circumferential_force")
    assert flank * F_t > 0.0
    for gear, names in ((m.pair.gear1, ("axial_force_1", "radial_force_1")), (m.pair.gear2, None)):
        sign = flank if gear is m.pair.gear1 else -flank
        tan, s, c = math.tan(gear.alpha_n), math.sin(gear.delta), math.cos(gear.delta)
        sin_b, cos_b = sign * math.sin(m.pair.gear1.beta_m), math.cos(gear.beta_m)
        axial, radial = names or ("axial_force", "radial_force")
        assert m.get(axial) == pytest.approx(abs(F_t) / cos_b * (tan * s + sin_b * c), rel=1e-9)
        assert m.get(radial) == pytest.approx(abs(F_t) / cos_b * (tan * c - sin_b * s), rel=1e-9)
    normal = abs(F_t) / (math.cos(m.pair.gear1.alpha_n) * math.cos(m.pair.gear1.beta_m))
    assert m.get("normal_force") == pytest.approx(normal, rel=1e-12)


@every_pair
@both_laws
@both_flanks
def test_action_is_reaction_about_a_common_point(pair, shape, flank):
    m = shaken(mesh(pair, shape, mu=0.08, d_in=2e4, d_out=1e4, d_gap=1e3), 1e-5, 2e-4)
    m.press(2e-5, flank)
    m.frames["tw"] = [[0.01, 0.02, 0.0, 0.1, 0.0, 50.0], [0.0, 0.0, 0.01, 0.0, 0.2, -20.0]]
    F = m.evaluate()
    moment = F[:, 3:] + np.cross(m.frames["r"], F[:, :3])
    assert abs(F[:, :3].sum(0)).max() < 1e-12 * abs(F).max()
    assert abs(moment.sum(0)).max() < 1e-12 * abs(F).max()


@every_pair
@both_flanks
@pytest.mark.parametrize("shift, tilt", [(0.0, 0.0), (2e-5, 1e-4), (1e-3, 3e-3)])
def test_the_wrench_is_the_slope_of_the_stored_energy(pair, flank, shift, tilt):
    """Otherwise the element would create energy; a constant stiffness has no other source of it. Exact, so
    that displacements far beyond those of bearings show it best. What is left are the differences."""
    m = shaken(mesh(pair), shift, tilt)
    m.press(2e-5 + 2.0 * shift, flank)
    F = m.evaluate()
    by_difference = -slope(m, lambda F: m.get("elastic_energy"))
    assert abs(F[:, :3] - by_difference[:, :3]).max() < 1e-6 * abs(F[:, :3]).max()
    assert abs(F[:, 3:] - by_difference[:, 3:]).max() < 1e-6 * abs(F[:, 3:]).max()


@every_pair
@both_flanks
@pytest.mark.parametrize("laws", [dict(), dict(d_in=3e4, d_out=3e4, s_0=1e-9, d_gap=2e3)])
def test_exact_tangents_are_derivatives_of_the_force(pair, flank, laws):
    """Over places with all twists kept, and over twists."""
    m = shaken(mesh(pair, **laws), 2e-5, 1e-3)
    m.press(6e-5, flank)
    m.frames["tw"] = np.random.default_rng(2).normal(size=(2, 6)) * [0.01, 0.01, 0.01, 0.3, 0.3, 0.3]
    K = -slope(m, lambda F: F)
    m.evaluate(jac=2)
    assert abs(m.tangent() - K).max() < 2e-6 * abs(K).max()
    m.evaluate(jac=1, ck=0.0, cd=1.0)
    D = m.tangent()
    for body in range(2):
        for k in range(6):
            ends = []
            for sign in (1, -1):
                fr = m.frames.copy()
                fr["tw"][body, k] += sign * 1e-3
                ends.append(m.evaluate(fr))
            difference = -(ends[0] - ends[1]) / 2e-3
            assert abs(D[:, :, body, k] - difference).max() <= 1e-7 * abs(D).max()


@every_pair
@both_flanks
def test_tangents_of_pairs_with_friction(pair, flank):
    """Newton's matrix of tooth pairs, at frozen phase and plane: linear over the travel."""
    m = mesh(pair, PairShape(c_prime=14e9, S_R=1.0, T_R=0.0), mu=0.1, v_eps=1.0)
    m.press(2e-5, flank)
    m.frames["tw"][:, 3:] = [1.2 * m.axes[0][:, 2], -0.6 * m.axes[1][:, 2]]
    m.evaluate(jac=1)
    K = m.tangent()
    way = np.zeros((2, 6))  # apart along the travel: the phase stays
    way[0, 3:], way[1, 3:] = m.axes[0][:, 2] / m.row["r_b1"], m.axes[1][:, 2] / m.row["r_b2"]
    ends = []
    for sign in (1, -1):
        fr = m.frames.copy()
        for k in range(2):
            fr["phi"][k] += sign * 1e-9 * way[k, 3:] @ m.axes[k][:, 2]
        ends.append(m.evaluate(fr))
    expected = -(ends[0] - ends[1]) / 2e-9
    assert abs(np.einsum("ikjl,jl->ik", K, way) - expected).max() < 1e-6 * abs(expected).max()


@every_pair
@pytest.mark.parametrize("shape", [PAIR, BARE, SOFT, CONSTANT], ids=["ramp", "bare", "soft", "constant"])
@both_flanks
@pytest.mark.parametrize("motion", ["spin", "any"])
def test_power_balance(pair, shape, flank, motion):
    """Work done by the gears + parametric power = stored energy + losses, with sliding, for gears in their
    places and for displaced ones that move in all directions; contact lines with and without ramps."""
    m = mesh(pair, shape, mu=0.05, d_in=3e4, d_out=2e4, d_gap=5e3)
    twist = np.zeros((2, 6))
    if motion == "any":
        m = shaken(m, 1e-5, 1e-4)
        twist = np.random.default_rng(3).normal(size=(2, 6)) * [0.03, 0.03, 0.05, 1.0, 1.0, 1.0]
    m.roll(0.2)
    m.press(4e-5, flank)
    for k, speed in enumerate((40.0, -40.0 * m.row["r_b1"] / m.row["r_b2"] * (1.0 - 0.002 * flank))):
        twist[k, 3:] += speed * m.frames["R"][k][:, 2]
    given, cycle, stored, lost = m.powers(twist)
    largest = max(abs(p) for p in (given, cycle, stored, lost))
    assert abs(given + cycle - stored - lost) < 2e-6 * largest
    assert lost > 0.0


@every_pair
def test_the_damper_brakes_the_travel_that_is_told(pair):
    """In the gap it is all there is: its force is the damping times the rate of the transmission error,
    whatever motion makes that; the gap grows as the axes part."""
    m = shaken(mesh(pair, d_gap=1e3), 2e-6, 1e-5)
    m.press(-2e-5)
    twist = np.random.default_rng(5).normal(size=(2, 6)) * [0.03, 0.03, 0.05, 1.0, 1.0, 1.0]
    h, told = 1e-6, []
    for sign in (-1, 1):
        fr = m.frames
        for body in range(2):
            fr = moved(fr, body, sign * h * twist[body])
        m.evaluate(fr)
        assert m.get("contact_state") == 0.0
        told.append(m.get("transmission_error"))
    m.frames["tw"] = twist
    m.evaluate()
    assert m.get("mesh_force") == pytest.approx(1e3 * (told[1] - told[0]) / (2 * h), rel=1e-4)
    gap = float(m.row["now"]["gap"])
    apart = np.zeros(6)
    apart[:3] = 1e-4 * m.row["now"]["e"]
    m.evaluate(moved(m.frames, 1, apart))
    assert m.row["now"]["gap"] - gap == pytest.approx(2e-4 * math.sin(m.pair.alpha_t), rel=1e-2)


@both_flanks
def test_moving_the_whole_machine_changes_nothing(flank):
    m = shaken(mesh("right", PAIR, mu=0.05), 1e-5, 1e-4)
    m.press(3e-5, flank)
    F, seen = m.evaluate(), m.out.copy()
    Q, by = rotation((0.6, 0.0, 0.8), 1.1), np.array([0.3, -0.2, 0.5])
    for k in range(2):
        m.frames["R"][k] = Q @ m.frames["R"][k]
        m.frames["r"][k] = Q @ m.frames["r"][k] + by
    turned = np.concatenate((F[:, :3] @ Q.T, F[:, 3:] @ Q.T), axis=1)
    assert abs(m.evaluate() - turned).max() < 1e-9 * abs(F).max()
    assert np.allclose(m.out, seen, rtol=1e-8, atol=1e-9)


@every_pair
@pytest.mark.parametrize("sides", [(1.0, 1.0), (-1.0, 1.0)])
def test_whole_turns_change_nothing(pair, sides):
    m = mesh(pair, PAIR, sides)
    m.press(1e-5)
    F, phase = m.evaluate(), m.get("mesh_phase")
    m.frames["turns"] = [2 * m.row["z2"], -2 * m.row["z1"]]
    assert np.array_equal(m.evaluate(), F)
    assert m.get("mesh_phase") == phase
    # a carrier that goes round turns the plane of the axes: whole teeth pass
    m.rec["carried"] = 1
    m.frames["turns"] = [3, 5]
    assert np.array_equal(m.evaluate(), F)


def test_teeth_repeat_after_a_base_pitch():
    """At constant travel forces of one place repeat; pair numbers move on by one."""
    m = OneBevel(make_bevels(beta=0.5), MeshLaws(stiffness=PAIR))
    m.press(1e-5)
    F, out = m.evaluate(), m.out.copy()
    m.roll(1.0)
    assert np.allclose(m.evaluate(), F, rtol=0, atol=1e-8 * abs(F).max())
    assert np.allclose(np.roll(out[N_OUT:], 1), m.out[N_OUT:], rtol=1e-7, atol=1e-6)
    assert m.out[N_OUT:].sum() == pytest.approx(m.get("normal_force") * math.cos(m.pair.beta_b))


@both_flanks
def test_every_pair_is_told_apart_however_many_there_are(flank):
    """An overlap of nine pitches: as many slots carry as contact lines cross the face, each counted here."""
    m = OneBevel(make_bevels(30, 45, beta=1.0, b=90e-3), MeshLaws(stiffness=BARE))
    assert m.pair.eps_gamma > 9.0
    for step in range(4):
        m.roll(0.21 * (step > 0))
        m.press(1e-5, flank)
        row = m.row
        way = row["xi_0"] + row["now"]["travel"] if flank > 0 else row["xi_b"] - row["now"]["travel"]
        psi = float(row["now"]["start"][0 if flank > 0 else 1] + way / row["p_bt"])
        per_ln = flank * row["tan_b"] * row["R_m"] / row["p_bt"]
        first, last = sorted(per_ln * math.log1p(row[z] / row["R_m"]) for z in ("z_lo", "z_hi"))
        lines = [q for q in range(-30, 31) if -last < psi % 1.0 + q < row["now"]["eps"] - first]
        carried = flank * m.out[N_OUT:]
        assert len(lines) >= 9 and (carried >= 0.0).all()
        assert np.count_nonzero(carried) == len(lines)
        assert carried.sum() == pytest.approx(m.get("normal_force") * math.cos(m.pair.beta_b))


def test_exact_tangents_leave_the_pair_forces_alone():
    """They sum a flank twice; it is told once."""
    m = OneBevel(make_bevels(beta=0.5), MeshLaws(stiffness=PAIR, d_in=3e4, d_out=3e4))
    m.press(1e-5)
    seen = m.out.copy()
    m.evaluate(jac=2, ck=1.0, cd=1.0)
    assert np.array_equal(m.out, seen)


@both_flanks
@pytest.mark.parametrize("beta", [0.0, 0.5])
def test_leaning_gears_touch_along_a_part_of_the_width(beta, flank):
    """Against a plain sum over 40 000 slices of what the formulas of the page say; never a pull."""
    m = mesh("straight" if beta == 0.0 else "right", BARE)
    apart = np.zeros(6)
    apart[:3] = 4e-5 * m.axes[1][:, 2] + 3e-5 * np.cross(m.axes[0][:, 2], m.axes[1][:, 2])
    m.frames = moved(m.frames, 1, apart)
    m.evaluate()
    row = m.row
    cos_a, sin_a = row["now"]["cos_a"], math.sqrt(1.0 - row["now"]["cos_a"] ** 2)
    across = (
        flank * cos_a * row["now"]["t"] + sin_a * row["now"]["e"] - flank * row["tan_b"] * row["now"]["m"]
    )
    m.press(0.0, flank)  # at mid-face they just touch
    F = m.evaluate()
    n = 40_000
    R = row["R_m"] + row["z_lo"] + (row["z_hi"] - row["z_lo"]) * (np.arange(n) + 0.5) / n
    force, moment, touched = np.zeros(3), 0.0, []
    N, p = sin_a * row["now"]["t"] - flank * cos_a * row["now"]["e"], np.array(row["now"]["m"])
    psi = m.get("mesh_phase")
    if flank < 0:
        psi = float(row["now"]["start"][1] + (row["xi_b"] - row["now"]["travel"]) / row["p_bt"]) % 1.0
    for q in range(-4, 5):
        place = psi + q + flank * row["tan_b"] * row["R_m"] / row["p_bt"] * np.log(R / row["R_m"])
        sigma = (row["now"]["xi_A"] + place * row["p_bt"]) / row["R_m"]
        r = np.cos(sigma)[:, None] * p + np.sin(sigma)[:, None] * np.cross(N, p)
        normal = np.cross(N, r) - flank * row["tan_b"] * r
        x = (
            R * (flank * row["now"]["u"] - 0.5 * row["now"]["gap"] - across @ row["now"]["d"]) / row["R_m"]
            + normal @ row["now"]["d"]
        )
        zeta = 2 * place / row["now"]["eps"] - 1
        k = 14e9 * (1 - 0.2 * zeta**2) * (abs(zeta) <= 1) * (row["z_hi"] - row["z_lo"]) / n
        touched.append([((x > 0) & (k > 0)).sum(), (k > 0).sum()])
        f = k * np.maximum(x, 0)
        force += f @ normal
        moment += f @ R
    touching, in_mesh = np.sum(touched, axis=0)
    assert 0.2 < touching / in_mesh < 0.8
    assert abs(F[1, :3] - force).max() < 1e-4 * abs(force).max()
    assert m.get("mesh_force") == pytest.approx(flank * moment / row["R_m"], rel=1e-4)


@pytest.mark.parametrize("teeth", [(17, 43), (43, 17)])
@pytest.mark.parametrize("tilt", [0.0, 5e-3])
def test_a_working_cone_may_be_wider_than_a_plane(teeth, tilt):
    """A wheel of 89.8 deg whose axis leans by 0.29 deg: the pitch cones fill the wider shaft angle."""
    wide = math.radians(89.8)
    Sigma = wide + math.asin(math.sin(wide) * 17 / 43)
    m = OneBevel(make_bevels(*teeth, Sigma=Sigma), MeshLaws(stiffness=CONSTANT))
    m.evaluate()
    turn = rotation(np.array(m.row["now"]["t"]), tilt)
    m.frames["R"][1] = turn @ m.frames["R"][1]
    m.frames["r"][1] = np.array(m.at) - m.apexes[1] * m.frames["R"][1][:, 2]
    m.press(2e-5)
    F = m.evaluate()
    torques = [F[k, 3:] @ m.frames["R"][k][:, 2] for k in range(2)]
    assert torques[1] / torques[0] == pytest.approx(teeth[1] / teeth[0], rel=1e-12)
    by_difference = -slope(m, lambda F: m.get("elastic_energy"))
    assert abs(F - by_difference).max() < 1e-6 * abs(F[:, :3]).max()


def test_rounded_angles_of_drawings_let_no_gear_gain_on_the_other():
    """Cones of 21.571 and 68.429 deg would make 17 pinion teeth 0.16 µm longer than those of the wheel."""
    gears = [
        BevelGear.of_outer_module(
            z=z, m_et=4e-3, delta=math.radians(delta), b=26e-3, thickness_allowance=-3e-5
        )
        for z, delta in ((17, 21.571), (43, 68.429))
    ]
    m = OneBevel(BevelPair(*gears, 0.5 * math.pi), MeshLaws(stiffness=CONSTANT))
    for r_b, z in (("r_b1", 17), ("r_b2", 43)):
        assert 2.0 * math.pi * m.row[r_b] == pytest.approx(z * m.row["p_bt"], rel=1e-15)
