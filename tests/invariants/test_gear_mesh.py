# SPDX-License-Identifier: Apache-2.0
"""Rules of a flank law, run on the mesh element for every kind of pair, both flanks and every stiffness
form."""

import math

import numpy as np
import pytest

from pitchpoint.contact.stiffness.description import PairShape, PhaseStiffness
from pitchpoint.core.kernel import address
from pitchpoint.elements.mesh.exact_tangent import turning
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.system.rules.mesh_laws import MeshLaws
from tests.support.energy_slopes import shaken, slope_of_energy
from tests.support.mesh_alone import moved, wrenches_move_with_the_gearbox
from tests.support.one_mesh import OneMesh, make_pair
from tests.support.width_moments import table_width_moments, width_moments

PAIRS = {
    "spur": dict(beta=0.0),
    "helical": dict(beta=0.3),
    "left": dict(beta=-0.25),
    "internal spur": dict(beta=0.0, z2=70, internal=True),
    "internal helical": dict(beta=0.2, z2=70, internal=True),
}
SHAPES = {
    "constant": PhaseStiffness(mean=4e8),
    "fourier": PhaseStiffness(mean=4e8, cosine=[-0.2, 0.1], sine=[0.05, 0.0]),
    "parabola": PairShape(c_prime=14e9, S_R=0.8, T_R=0.3),
    "table": PairShape(c_prime=14e9, table=1 - 0.3 * np.linspace(-1, 0.8, 41) ** 2, T_R=0.4),
    "low load": PairShape(c_prime=14e9, S_R=0.8, T_R=0.3, load_limit=1e5),
    "hertz": PairShape(c_prime=4e12, S_R=1.0, T_R=0.3, power=1.5),
}
every_pair = pytest.mark.parametrize("pair", PAIRS)
every_shape = pytest.mark.parametrize("shape", SHAPES)
both_flanks = pytest.mark.parametrize("flank", [1, -1])


def mesh(pair, shape="constant", **laws):
    return OneMesh(make_pair(**PAIRS[pair]), MeshLaws(stiffness=SHAPES[shape], **laws))


@every_pair
@both_flanks
@pytest.mark.parametrize("tilt", [0.0, 1e-4, 3e-3])
def test_the_wrench_is_the_slope_of_the_stored_energy(pair, flank, tilt):
    """Otherwise the element would create energy. Tilted or not: what is left are the differences (1e-7), and
    the shared width, which changes with the axial offset and holds less energy by the square of the tilt."""
    m = shaken(mesh(pair), tilt)
    m.press(8e-6 + 0.03 * tilt, flank)
    F = m.evaluate()
    slope = slope_of_energy(m)
    left = m.get("elastic_energy") * (tilt * m.row["b1"] / (8e-6 + 0.03 * tilt)) ** 2 / m.row["b1"]
    assert abs(F[:, :3] - slope[:, :3]).max() < 2e-7 * abs(F[:, :3]).max() + left
    assert abs(F[:, 3:] - slope[:, 3:]).max() < 2e-7 * abs(F[:, 3:]).max() + left * abs(m.pair.a_w)


@pytest.mark.parametrize("widths", [(0.03, 0.04), (0.04, 0.03)])
def test_the_narrower_gear_carries_the_width(widths):
    """A narrower gear that slides along a wider tilted one feels the slope of its flanks, exactly."""
    m = OneMesh(make_pair(beta=0.3), MeshLaws(stiffness=SHAPES["constant"]))
    for k, b in enumerate(widths):
        m.rec[f"b{k + 1}"] = b
    m.rec["w_z"] = (0.0 if widths[0] < widths[1] else 1.0) - m.row["w1"]
    m = shaken(m, 1e-3)
    m.press(4e-5)
    F = m.evaluate()
    assert abs(F - slope_of_energy(m)).max() < 2e-7 * abs(F).max()


@every_pair
@every_shape
@both_flanks
def test_action_is_reaction_about_a_common_point(pair, shape, flank):
    m = shaken(mesh(pair, shape, mu=0.08, d_in=2e4, d_out=1e4, d_gap=1e3), 2e-4)
    m.press(8e-6, flank)
    m.frames["tw"] = [[0.01, 0.02, 0.0, 0.1, 0.0, 50.0], [0.0, 0.0, 0.01, 0.0, 0.2, -20.0]]
    F = m.evaluate()
    moment = F[:, 3:] + np.cross(m.frames["r"], F[:, :3])
    assert abs(F[:, :3].sum(0)).max() < 1e-10 * abs(F).max()
    assert abs(moment.sum(0)).max() < 1e-10 * abs(F).max()


@every_pair
@every_shape
@both_flanks
def test_tangent_is_the_derivative_of_the_force(pair, shape, flank):
    """At frozen phase and line of action. The spin of both gears changes the phase, so its columns are
    compared for the travel alone: turning both gears against each other by equal travel keeps the phase."""
    m = mesh(pair, shape)
    m.press(8e-6, flank)
    m.evaluate(jac=1)
    K = m.tangent()
    r1, r2 = m.row["r_b1"], m.row["r_b2"]
    h = 1e-9
    slope = np.zeros((2, 6))
    for sign in (1, -1):
        fr = m.frames.copy()
        fr["phi"] += sign * h * np.array([0.5 / r1, 0.5 / r2])
        slope -= m.evaluate(fr) * sign / (2 * h)
    column = K[:, :, 0, 5] * 0.5 / r1 + K[:, :, 1, 5] * 0.5 / r2
    assert abs(column - slope).max() < 1e-6 * abs(column).max()
    for k in (0, 1, 2):
        slope = np.zeros((2, 6))
        for sign in (1, -1):
            step = np.zeros(6)
            step[k] = sign * h
            slope -= m.evaluate(moved(m.frames, 1, step)) * sign / (2 * h)
        # what is left: the line of action turns (F/a), the phase moves along the ramp at most (F/(L p_bt))
        ramp = max(m.row["now"]["L"], 0.1) * m.row["p_bt"]
        left = abs(m.get("mesh_force")) * (1.2 / ramp + 2.0 / abs(m.pair.a_w))
        assert abs(K[:, :, 1, k] - slope)[:, :3].max() < left


@every_pair
def test_damping_and_friction_tangents(pair):
    m = mesh(pair, "parabola", mu=0.08, d_in=2e4, d_out=2e4, d_gap=1e3, v_eps=0.5)
    m.press(8e-6)
    m.frames["tw"] = [[0, 0, 0, 0, 0, 3.0], [0, 0, 0, 0, 0, -1.2]]
    m.evaluate(jac=1, ck=0.0, cd=1.0)
    D = m.tangent().copy()
    for body in range(2):
        for k in range(6):
            h = 1e-6
            slope = np.zeros((2, 6))
            for sign in (1, -1):
                fr = m.frames.copy()
                fr["tw"][body, k] += sign * h
                slope -= m.evaluate(fr) * sign / (2 * h)
            assert abs(D[:, :, body, k] - slope).max() < 1e-6 * abs(D).max()


@every_pair
@every_shape
@both_flanks
def test_moving_the_whole_gearbox_changes_nothing(pair, shape, flank):
    m = shaken(mesh(pair, shape), 2e-4)
    m.press(8e-6, flank)
    assert wrenches_move_with_the_gearbox(m)


@every_shape
@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_swapping_the_gears_changes_nothing(shape, beta):
    a = OneMesh(make_pair(beta=beta), MeshLaws(stiffness=SHAPES[shape]), theta=0.0)
    a.frames["phi"] = [0.011, -0.003]
    a.press(8e-6)
    A = a.evaluate()
    psi = a.get("mesh_phase")
    pair = GearPair(a.pair.gear2, a.pair.gear1, a.pair.a_w)
    b = OneMesh(pair, MeshLaws(stiffness=SHAPES[shape]), theta=math.pi)
    b.frames["r"] = a.frames["r"][::-1]
    o1, o2 = (float(x) for x in a.frames["phi"])
    b.frames["phi"] = [o2, o1]
    # gear 1 of the second mesh is assembled with a tooth on the line of centres, not a space: half a pitch
    # apart
    b.frames["phi"][0] += math.pi / pair.gear1.z
    b.frames["phi"][1] -= math.pi / pair.gear2.z
    B = b.evaluate()
    # the path runs from A to E of the other gear: the phase counts backwards, so lopsided shapes turn round
    turned = (psi + b.get("mesh_phase") - a.row["now"]["eps"]) % 1.0
    assert min(turned, 1.0 - turned) < 1e-9
    if shape not in ("fourier", "table"):
        assert np.allclose(B[::-1], A, rtol=0.0, atol=1e-9 * abs(A).max())


@every_pair
@every_shape
@both_flanks
def test_periodic_over_a_pitch(pair, shape, flank):
    m = mesh(pair, shape)
    m.frames["phi"] = [0.02, -0.02 * m.row["r_b1"] / m.row["r_b2"]]
    m.press(8e-6, flank)
    F = m.evaluate()
    fr = m.frames.copy()
    fr["phi"] += [2 * math.pi / m.pair.gear1.z, -2 * math.pi / m.pair.gear2.z]
    assert np.allclose(m.evaluate(fr), F, rtol=0, atol=1e-9 * abs(F).max())
    # whole turns held apart give the same bits
    m.frames["turns"] = [m.pair.gear2.z * 3, -m.pair.gear1.z * 3]
    assert np.array_equal(m.evaluate(), F)


@every_pair
@every_shape
def test_never_pulls_and_parts_in_the_gap(pair, shape):
    m = mesh(pair, shape, d_in=5e5, d_out=5e5)
    for flank in (1, -1):
        for depth in (1e-9, 1e-7, 5e-6):
            m.press(depth, flank)
            for speed in (-0.5, -0.01, 0.5):
                fr = m.frames.copy()
                fr["tw"][0, 5] = flank * speed / m.row["r_b1"]
                m.evaluate(fr)
                assert flank * m.get("mesh_force") >= 0.0
    m.press(-0.5 * m.row["now"]["gap"])
    assert not m.evaluate().any()
    assert m.get("contact_state") == 0.0


@every_pair
def test_continuous_over_the_phase(pair):
    """With a relief ramp the force has no jump at any phase; random phases find what even steps would
    miss."""
    m = mesh(pair, "parabola")
    rng = np.random.default_rng(5)
    r1, r2 = m.row["r_b1"], m.row["r_b2"]
    m.press(8e-6)
    start = m.frames["phi"].copy()
    for s in rng.uniform(0, m.row["p_bt"], 40):
        forces = []
        for ds in (0.0, 1e-9):
            m.frames["phi"] = start + (s + ds) * np.array([1 / r1, -1 / r2])
            m.evaluate()
            forces.append(m.get("mesh_force"))
        assert abs(forces[1] - forces[0]) < 2e-5 * forces[0]


@pytest.mark.parametrize("beta, b", [(0.0, 0.03), (1e-7, 0.03), (0.1, 0.03), (0.3, 0.03), (0.3, 0.11)])
@both_flanks
def test_exact_width_integral_is_the_closed_one(beta, b, flank):
    pair = make_pair(beta=beta, b=b)
    shape = PairShape(c_prime=14e9, S_R=0.8, T_R=0.3)
    m = OneMesh(pair, MeshLaws(stiffness=shape))
    for phi in np.linspace(0, 2 * math.pi / pair.gear1.z, 7):
        m.frames["phi"] = [phi, -phi * m.row["r_b1"] / m.row["r_b2"]]
        m.press(8e-6, flank)
        eps = m.row["now"]["eps"]
        L = shape.T_R * (eps % 1.0)
        K = width_moments(m.row["now"]["psi"], m.row["now"]["lam"], b, eps, shape.S_R, L)[0] * shape.c_prime
        assert m.get("mesh_stiffness") == pytest.approx(K, rel=1e-11)
        assert flank * m.get("mesh_force") == pytest.approx(K * 8e-6, rel=1e-8)


TABLES = {
    "three": [0.0, 1.0, 0.0],
    "seven": [0.6, 0.8, 0.95, 1.0, 0.95, 0.8, 0.6],
    "lopsided": [0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1, 1, 0.95, 0.9, 0.9, 0.8, 0.85, 0.6],
    "rough": [0.5, 1.0] * 32,
}


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize(
    "beta, b, T_R", [(0.0, 0.03, 0.0), (0.1, 0.03, 0.3), (0.3, 0.03, 0.0), (-0.3, 0.11, 0.3)]
)
@both_flanks
def test_exact_width_integral_of_a_table_has_pieces_between_its_points(table, beta, b, T_R, flank):
    """Force and stiffness of any contact line over a piecewise linear table, its points being kinks."""
    values = np.array(TABLES[table])
    shape = PairShape(c_prime=14e9, table=values, T_R=T_R)
    m = OneMesh(make_pair(beta=beta, b=b), MeshLaws(stiffness=shape))
    for phi in np.linspace(0, 2 * math.pi / m.pair.gear1.z, 7):
        m.frames["phi"] = [phi, -phi * m.row["r_b1"] / m.row["r_b2"]]
        m.press(8e-6, flank)
        eps, L = m.row["now"]["eps"], T_R * (m.row["now"]["eps"] % 1.0)
        K = table_width_moments(m.row["now"]["psi"], m.row["now"]["lam"], b, eps, values, L)[0] * 14e9
        assert m.get("mesh_stiffness") == pytest.approx(K, rel=1e-11)
        assert flank * m.get("mesh_force") == pytest.approx(K * 8e-6, rel=1e-8)


@pytest.mark.parametrize(("points", "limit"), [(65, 4e-5), (129, 1e-5)])
def test_smooth_tables_of_many_points_are_close_without_such_pieces(points, limit):
    """Error of the mesh stiffness against its mean, over a mesh cycle of narrow and wide faces."""
    values = 1.0 - 0.3 * np.linspace(-1.0, 0.8, points) ** 2
    shape = PairShape(c_prime=14e9, table=values)
    for beta, b in ((0.15, 0.02), (0.26, 0.04), (0.5, 0.02), (0.5, 0.06)):
        m = OneMesh(make_pair(beta=beta, b=b), MeshLaws(stiffness=shape))
        found, exact = [], []
        for phi in np.linspace(0, 2 * math.pi / m.pair.gear1.z, 200):
            m.frames["phi"] = [phi, -phi * m.row["r_b1"] / m.row["r_b2"]]
            m.press(8e-6)
            found.append(m.get("mesh_stiffness") / 14e9)
            row = m.row
            K = table_width_moments(row["now"]["psi"], row["now"]["lam"], b, row["now"]["eps"], values, 0.0)[
                0
            ]
            exact.append(K)
        assert np.abs(np.subtract(found, exact)).max() < limit * np.mean(exact)


@both_flanks
def test_exact_width_integral_where_the_ramps_of_a_short_path_overlap(flank):
    """A contact ratio below one: the ramps of A and E meet half-way."""
    pair = make_pair(beta=0.3, b=0.06, tip_alteration=-1.5e-3)
    shape = PairShape(c_prime=14e9, S_R=0.8, T_R=1.0)
    m = OneMesh(pair, MeshLaws(stiffness=shape))
    assert 0.2 < pair.eps_alpha < 1.0
    for phi in np.linspace(0, 2 * math.pi / pair.gear1.z, 7):
        m.frames["phi"] = [phi, -phi * m.row["r_b1"] / m.row["r_b2"]]
        m.press(8e-6, flank)
        eps = m.row["now"]["eps"]
        K = width_moments(m.row["now"]["psi"], m.row["now"]["lam"], 0.06, eps, 0.8, eps)[0] * 14e9
        assert m.get("mesh_stiffness") == pytest.approx(K, rel=1e-11)


def test_slices_tend_to_the_exact_integral_also_where_tilted_gears_lift_off():
    pair = make_pair(beta=0.3)
    forces = []
    for slices in (0, 11, 101, 4001):
        m = OneMesh(pair, MeshLaws(stiffness=SHAPES["parabola"], slices=slices, mu=0.05, v_eps=1e-6))
        m.frames = moved(m.frames, 1, np.array([0, 0, 0, 4e-4, -3e-4, 0.0]))
        m.frames["tw"] = [[0, 0, 0, 0, 0, 100.0], [0, 0, 0, 0, 0, -100.0 * m.row["r_b1"] / m.row["r_b2"]]]
        m.press(4e-6)
        forces.append(m.evaluate())
    exact = forces[0]
    error = [abs(F - exact).max() / abs(exact).max() for F in forces[1:]]
    assert error[0] < 0.05 and error[1] < 2e-3 and error[2] < 5e-6
    assert abs(exact[1, 3:]).max() > 1.0


@both_flanks
def test_mirrored_helix_mirrors_the_result(flank):
    a = OneMesh(make_pair(beta=0.3), MeshLaws(stiffness=SHAPES["parabola"]))
    b = OneMesh(make_pair(beta=-0.3), MeshLaws(stiffness=SHAPES["parabola"]))
    shift = np.array([1e-5, 2e-5, 4e-5, 1e-4, 2e-4, 0])
    mirror = np.array([1, 1, -1, -1, -1, 1.0])  # reflection in z: axial vectors keep their z part
    a.frames = moved(a.frames, 1, shift)
    b.frames = moved(b.frames, 1, mirror * shift)
    a.press(8e-6, flank)
    b.press(8e-6, flank)
    A, B = a.evaluate(), b.evaluate()
    assert np.allclose(B, A * mirror, rtol=0, atol=1e-8 * abs(A).max())


def power_gap(m, twist, h=3e-8):
    """Power of the gears + parametric power - change of the stored energy - losses, and the largest of them.

    h [s] balances the round-off of the travel (1e-17 m) against the bend of the energy.
    """
    energy = []
    for sign in (-1, 1):
        fr = m.frames
        for body in range(2):
            fr = moved(fr, body, sign * h * twist[body])
        m.evaluate(fr)
        energy.append(m.get("elastic_energy"))
    m.frames["tw"] = twist
    m.frames["spin"] = [twist[k, 3:] @ m.frames["R"][k][:, 2] for k in range(2)]
    F = m.evaluate()
    given = -float((F * twist).sum())
    stored = (energy[1] - energy[0]) / (2 * h)
    losses = m.get("friction_power") + m.get("damping_power")
    parts = (given, m.get("parametric_power"), stored, losses)
    return given + m.get("parametric_power") - stored - losses, max(abs(p) for p in parts)


@every_pair
@pytest.mark.parametrize("shape", ["fourier", "parabola", "table", "low load"])
@pytest.mark.parametrize("slices", [0, 33])
@both_flanks
@pytest.mark.parametrize("motion", ["spin", "any"])
def test_power_balance(pair, shape, slices, flank, motion):
    """Work done by the gears + parametric power = stored energy + losses, with sliding; turning gears on
    parallel axes, and tilted gears that move in all directions.

    Slices keep their places on the flank, so every one of them balances. The nodes of the width integral move
    with the kinks: exact for polynomials, not for the power 4/3."""
    e = {"e_cos": np.array([1e-6]), "e_sin": np.array([2e-6]), "orders2": np.array([[1.0, 3e-6, 0.4]])}
    m = mesh(pair, shape, slices=slices, mu=0.05, d_in=3e4, d_out=2e4, d_gap=5e3, **e)
    ratio = m.row["r_b1"] / m.row["r_b2"]
    twist = np.zeros((2, 6))
    if motion == "any":
        m = shaken(m, 1e-4)
        rng = np.random.default_rng(3)
        twist = rng.normal(size=(2, 6)) * [0.03, 0.03, 0.05, 1.0, 1.0, 0.0]
    m.press(2e-5, flank)
    twist[:, 5] += np.array([40.0, -40.0 * ratio * (1.0 - 0.002 * flank)])
    gap, scale = power_gap(m, twist)
    exact = slices > 0 or shape != "low load"
    assert abs(gap) < (2e-6 if exact else 1e-3) * scale
    assert m.get("friction_power") > 0.0


@every_pair
@both_flanks
@pytest.mark.parametrize("laws", [{}, dict(d_in=3e4, d_out=2e4, mu=0.05), dict(d_in=3e6, d_out=3e6)])
def test_power_balance_of_modified_flanks(pair, flank, laws):
    """Contact lines that run over modified flanks of tilted gears: what the gap takes is parametric power,
    contact damping and flanks that let go (last) included."""
    m = mesh(pair, "parabola", slices=33, **laws)
    rng = np.random.default_rng(7)
    z1, z2 = (abs(int(m.row[name])) for name in ("z1", "z2"))
    m.separate(1e-5 * rng.uniform(size=(2, z1, 4, 6)), 1e-5 * rng.uniform(size=(2, z2, 4, 6)))
    m = shaken(m, 1e-4)
    m.press(3e-5, flank)
    twist = rng.normal(size=(2, 6)) * [0.03, 0.03, 0.05, 1.0, 1.0, 0.0]
    twist[:, 5] += np.array([40.0, -40.0 * m.row["r_b1"] / m.row["r_b2"]])
    gap, scale = power_gap(m, twist)
    assert abs(gap) < 2e-6 * scale
    assert abs(m.get("parametric_power")) > 1e-5 * scale
    assert m.get("damping_power") > 0.0 or not laws


def wavy(pair, **laws):
    """A pair whose stiffness is even over the path, with flanks that rise and fall along it."""
    shape = PairShape(c_prime=14e9, S_R=1.0)
    m = OneMesh(make_pair(**PAIRS[pair]), MeshLaws(stiffness=shape, slices=7, s_0=0.0, **laws))
    rng = np.random.default_rng(11)
    z1, z2 = (abs(int(m.row[name])) for name in ("z1", "z2"))
    m.separate(1e-5 * rng.uniform(size=(2, z1, 4, 6)), 1e-5 * rng.uniform(size=(2, z2, 4, 6)))
    m.rec["b2"] *= 1.2  # the shared width stays that of gear 1
    m.rec["w_z"] = -m.row["w1"]
    return m


@every_pair
@both_flanks
@pytest.mark.parametrize("motion", ["spin", "any"])
def test_contact_damping_acts_on_the_rate_of_the_real_penetration(pair, flank, motion):
    """At even stiffness the elastic forces change by k times the rates of the penetration, and the damping is
    d times the same rates: also those of contacts that run over the flanks. Axes stay parallel."""
    m = wavy(pair, d_in=3e4, d_out=3e4)
    m.press(5e-5, flank)
    twist = np.zeros((2, 6))
    if motion == "any":
        twist[:, :3] = np.random.default_rng(4).normal(size=(2, 3)) * [0.03, 0.03, 0.05]
    twist[:, 5] = np.array([40.0, -40.0 * m.row["r_b1"] / m.row["r_b2"]])
    force = []
    for sign in (-1, 1):
        fr = m.frames
        for body in range(2):
            fr = moved(fr, body, sign * 1e-8 * twist[body])
        m.evaluate(fr)
        force.append(flank * m.get("mesh_force"))
    expected = (force[1] - force[0]) / 2e-8 * 3e4 / m.row["contact"]["k_ref"]
    m.frames["tw"] = twist
    m.frames["spin"] = twist[:, 5]
    m.evaluate()
    found = flank * m.get("mesh_force") - 0.5 * (force[0] + force[1])
    assert abs(expected) > 1.0
    assert found == pytest.approx(expected, rel=1e-5)


@every_pair
@both_flanks
@pytest.mark.parametrize("mu", [0.0, 0.05])
@pytest.mark.parametrize("fixed", [False, True])
def test_damping_tangent_of_modified_flanks(pair, flank, mu, fixed):
    """Over the spins exact; over the other rates but for the place of the contact, which moves with them too:
    less than the steepest flank, 2e-5 m on 2 mm."""
    m = wavy(pair, d_in=3e4, d_out=3e4, mu=mu, v_eps=0.5)
    m.press(5e-5, flank)
    m.rec["fixed"] = fixed  # with the line of action found just now
    m.frames["tw"][:, 5] = m.frames["spin"] = [3.0, -3.1 * m.row["r_b1"] / m.row["r_b2"]]
    m.evaluate(jac=1, ck=0.0, cd=1.0)
    D = m.tangent().copy()
    for body in range(2):
        for k in (5,) if fixed else range(6):
            slope = np.zeros((2, 6))
            for sign in (1, -1):
                fr = m.frames.copy()
                fr["tw"][body, k] += sign * 1e-6
                fr["spin"][body] += sign * 1e-6 * (k == 5)
                slope -= m.evaluate(fr) * sign / 2e-6
            left = 1e-6 if k == 5 else 1e-2
            assert abs(D[:, :, body, k] - slope).max() < left * abs(D).max()


@pytest.mark.parametrize("shape", ["parabola", "table"])
@pytest.mark.parametrize("pair", ["helical", "left", "internal helical"])
def test_power_balance_where_contact_lines_end_without_relief(pair, shape):
    """Without a ramp the ends of the contact lines carry load; what they take along is parametric power."""
    bare = PairShape(**{**vars(SHAPES[shape]), "T_R": 0.0})
    m = shaken(OneMesh(make_pair(**PAIRS[pair]), MeshLaws(stiffness=bare)), 1e-4)
    m.press(2e-5)
    twist = np.array([[0.01, 0.02, 0.03, 0.5, -0.3, 40.0], [0.02, -0.01, 0.01, 0.2, 0.4, 0.0]])
    twist[1, 5] = -40.0 * m.row["r_b1"] / m.row["r_b2"]
    gap, scale = power_gap(m, twist)
    assert abs(gap) < 2e-6 * scale


def test_force_triangle_of_a_helical_mesh():
    """T 1000 N m on r_w 2 m, alpha_n 20 deg, beta 10 deg: tangential 500, radial 184.79, axial 88.16 N
    (closed form; the file of reference cases lists it as 'force triangle of a helical mesh')."""
    beta = math.radians(10.0)
    z = 197
    m_n = 4.0 * math.cos(beta) / z
    g1 = CylindricalGear(z=z, m_n=m_n, beta=beta, b=0.05)
    g2 = CylindricalGear(z=z, m_n=m_n, beta=-beta, b=0.05)
    m = OneMesh(
        GearPair(g1, g2, 4.0), MeshLaws(stiffness=PhaseStiffness(mean=1e6 * math.cos(g1.beta_b) ** 2))
    )
    m.press(1000.0 / m.row["r_b1"] / m.row["c_prime"])
    F = m.evaluate()
    assert m.get("circumferential_force") == pytest.approx(500.0, rel=1e-9)
    assert m.get("radial_force") == pytest.approx(184.79, abs=5e-3)
    assert m.get("radial_force") == pytest.approx(500.0 * math.tan(g1.alpha_n) / math.cos(beta), rel=1e-9)
    assert abs(m.get("axial_force")) == pytest.approx(88.16, abs=5e-3)
    # deflection with k_n 1e6 N/m normal to the flanks: along the pitch circle 5.838e-4 m
    depth = m.get("deflection") - 0.5 * m.row["now"]["gap"]
    assert depth / math.cos(m.pair.alpha_wt) == pytest.approx(5.838e-4, abs=5e-8)
    assert np.linalg.norm(F[1, :3]) == pytest.approx(m.get("normal_force"), rel=1e-12)


@pytest.mark.parametrize("internal", [False, True])
def test_backlash_follows_the_centre_distance(internal):
    m = OneMesh(make_pair(beta=0.2, internal=internal, z2=70), MeshLaws(stiffness=SHAPES["parabola"]))
    sign = -1.0 if internal else 1.0
    out = np.array([math.cos(m.theta), math.sin(m.theta), 0.0])
    for da in (0.0, 5e-5, -2e-5):
        fr = moved(m.frames, 1, np.append(da * out, [0, 0, 0]))
        m.evaluate(fr)
        assert m.row["now"]["gap"] == pytest.approx(
            m.pair.at_center_distance(m.pair.a_w + sign * da).j_bt, rel=1e-9
        )
    fr = moved(m.frames, 1, np.append(sign * -4e-5 * out, [0, 0, 0]))
    m.evaluate(fr)
    assert m.row["now"]["gap"] < 0.0 and m.get("contact_state") == 2.0


@pytest.mark.parametrize("smooth, share", [(False, 0.25), (True, 0.15625)])
def test_contact_damping_grows_with_the_penetration(smooth, share):
    """At a quarter of s_0: a quarter of the damping, or t^2 (3 - 2 t) = 0.15625 of it."""
    m = OneMesh(
        make_pair(beta=0.0),
        MeshLaws(stiffness=SHAPES["constant"], d_in=2e4, d_out=2e4, s_0=4e-5, smooth=smooth),
    )
    m.press(1e-5)
    at_rest = m.get("mesh_force")
    m.frames["tw"][0, 5] = 0.01 / m.row["r_b1"]
    m.evaluate()
    assert m.get("mesh_force") - at_rest == pytest.approx(share * 2e4 * 0.01, rel=1e-6)


@both_flanks
def test_exact_tangents_leave_the_observations_alone(flank):
    """They sum a flank twice; its pairs and powers are told once."""
    m = OneMesh(make_pair(beta=0.3), MeshLaws(stiffness=SHAPES["parabola"], d_in=3e4, d_out=1e4), n_pair=4)
    m.rec["turning"] = address(turning)
    shaken(m, 1e-4)
    m.press(8e-6, flank)
    m.frames["tw"][0] = [0.001, 0.0, 0.002, 0.01, 0.0, 0.02]
    m.evaluate()
    seen = m.out.copy()
    m.evaluate(jac=2, ck=1.0, cd=1.0)
    assert np.array_equal(m.out, seen) and np.abs(m.kk).max() > 0.0
