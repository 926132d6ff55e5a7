# SPDX-License-Identifier: Apache-2.0
"""Rules of a flank law for teeth that have something of their own: broken parts, gaps, added compliance."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.geometry import GearPair
from pitchpoint.system import evaluate
from pitchpoint.system.rules.gear_mesh import MeshLaws
from tests.invariants.test_gear_mesh import (
    PAIRS,
    SHAPES,
    both_flanks,
    every_pair,
    moved,
    power_gap,
    shaken,
)
from tests.invariants.test_tangents import gears, pressed, scaled
from tests.support.machines import compiled
from tests.support.mesh_alone import wrenches_move_with_the_gearbox
from tests.support.one_mesh import OneMesh, make_pair

KINDS = ["level", "gap", "soft", "all"]
LAWS = ["parabola", "table", "low load", "hertz"]
SMOOTH = ["parabola", "table"]
"""Laws that three points integrate exactly; powers of the penetration are no polynomials."""
every_kind = pytest.mark.parametrize("kind", KINDS)


def levels(rng, teeth, cells=(9, 17)):
    """Straight edges across all flanks, with nothing, a part or all of them broken out; slope about 1."""
    z, roll = np.meshgrid(*(np.linspace(-1.0, 1.0, n) for n in cells), indexing="ij")
    a, b, c = rng.uniform(-1.0, 1.0, (3, 2, teeth, 1, 1))
    return 1e-2 * (a + b * z + c * roll - 0.3)


def waves(rng, teeth, cells=(9, 33)):
    """Hollows along and across the flanks of every tooth, between 0 and 1."""
    z, roll = np.meshgrid(*(np.linspace(-1.0, 1.0, n) for n in cells), indexing="ij")
    a, b, c = rng.uniform(-1.0, 1.0, (3, 2, teeth, 1, 1))
    return 0.5 + 0.5 * np.sin(3.0 * (a + b * z + c * roll))


def grids(m, kind, seed=7):
    """Random grids for all teeth of both gears."""
    rng = np.random.default_rng(seed)
    made = {"gap": [], "soft": [], "level": []}
    for name in ("z1", "z2"):
        teeth = abs(int(m.row[name]))
        made["gap"].append(1e-5 * waves(rng, teeth))
        made["soft"].append(5e-11 * waves(rng, teeth))
        made["level"].append(levels(rng, teeth))
    return made if kind == "all" else {kind: made[kind]}


def faulty(pair, kind, shape="parabola", **laws):
    m = OneMesh(make_pair(**PAIRS[pair]), MeshLaws(stiffness=SHAPES[shape], **laws))
    m.own(**grids(m, kind))
    return m


def turned_to_load(m, flank, depth=3e-5):
    """A place of the gears at which some, but not all of the force is lost."""
    whole = OneMesh(m.pair, m.laws, theta=m.theta)
    least = 0.2 if m.row["contact"]["power"] == 1.0 else 0.1  # powers of the penetration lose more
    for step in range(40):
        s = 0.37 * step * m.row["p_bt"]
        m.frames["phi"] = whole.frames["phi"] = [s / m.row["r_b1"], -s / m.row["r_b2"]]
        whole.frames["R"], whole.frames["r"] = m.frames["R"], m.frames["r"]
        whole.press(depth, flank)
        m.frames["phi"] = whole.frames["phi"]
        m.evaluate()
        left = m.get("mesh_force") / whole.get("mesh_force")
        if least < left < 0.95:
            return m
    raise AssertionError("no such place")


@every_pair
@both_flanks
@every_kind
@pytest.mark.parametrize("laws", [{}, dict(d_in=3e4, d_out=2e4, mu=0.05)])
def test_power_balance(pair, flank, kind, laws):
    """Contact lines that run over edges, gaps and soft places of tilted gears. What the moving separation and
    compliance take is parametric power; the pieces end at stations over the width, and the curved lines
    between them leave 2e-5 of the powers."""
    balanced(turned_to_load(shaken(faulty(pair, kind, **laws), 1e-4), flank), 2e-5)


@every_pair
@both_flanks
@pytest.mark.parametrize("laws", [dict(), dict(d_in=3e4, d_out=2e4, smooth=True), dict(chi=2.0)])
def test_power_balance_of_cracks_behind_a_power(pair, flank, laws):
    """Slices, which keep their places: no pieces whose integrals of x^1.5 are off, the balance is exact."""
    m = faulty(pair, "soft", "hertz", slices=33, mu=0.05, **laws)
    balanced(turned_to_load(shaken(m, 1e-4), flank), 2e-6)


def balanced(m, most):
    twist = np.random.default_rng(3).normal(size=(2, 6)) * [0.03, 0.03, 0.05, 1.0, 1.0, 0.0]
    twist[:, 5] += np.array([40.0, -40.0 * m.row["r_b1"] / m.row["r_b2"]])
    gap, scale = power_gap(m, twist)
    assert abs(gap) < most * scale
    assert abs(m.get("parametric_power")) > 2e-4 * scale


@every_pair
@both_flanks
@every_kind
@pytest.mark.parametrize("shape", ["parabola", "hertz"])
def test_the_wrench_is_the_slope_of_the_stored_energy(pair, flank, kind, shape):
    """At a stiffness that is even over the path, along motions that leave the phase as it is. Where x runs
    out to zero at an edge, three points integrate x^1.5 and x^2.5 to 1e-4."""
    m = turned_to_load(faulty(pair, kind, shape), flank)
    h = 1e-9
    energy = []
    for sign in (1, -1):
        fr = m.frames.copy()
        fr["phi"] += sign * h * np.array([0.5 / m.row["r_b1"], 0.5 / m.row["r_b2"]])
        m.evaluate(fr)
        energy.append(m.get("elastic_energy"))
    force = (energy[0] - energy[1]) / (2 * h)
    m.evaluate()
    assert m.get("mesh_force") == pytest.approx(
        force, rel=2e-6 if shape in SMOOTH or kind == "soft" else 1e-4
    )


@every_pair
@both_flanks
@every_kind
@pytest.mark.parametrize("shape", LAWS)
def test_tangent_is_the_derivative_of_the_force(pair, flank, kind, shape):
    """Where x runs out to zero at an edge, three points integrate x^(4/3) and its slope to 3e-4."""
    m = turned_to_load(faulty(pair, kind, shape), flank)
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
    assert abs(column - slope).max() < (2e-6 if shape in SMOOTH else 3e-4) * abs(column).max()


@every_pair
@both_flanks
@pytest.mark.parametrize("shape", LAWS)
def test_grids_of_nothing_change_nothing(pair, flank, shape):
    """Pieces between stations integrate the same polynomials; the power 4/3 is no polynomial: 5e-4."""
    m = shaken(OneMesh(make_pair(**PAIRS[pair]), MeshLaws(stiffness=SHAPES[shape], d_in=1e4)), 1e-4)
    m.press(2e-5, flank)
    m.frames["tw"] = [[0.01, 0.02, 0.0, 0.1, 0.0, 50.0], [0.0, 0.0, 0.01, 0.0, 0.2, -20.0]]
    F = m.evaluate()
    made = {k: [0.0 * g for g in v] for k, v in grids(m, "all").items()}
    made["level"] = [g - 1.0 for g in made["level"]]
    m.own(**made)
    assert abs(m.evaluate() - F).max() < (1e-12 if shape in SMOOTH else 5e-4) * abs(F).max()


@every_pair
@both_flanks
@every_kind
def test_moving_the_gearbox_and_whole_turns_change_nothing(pair, flank, kind):
    m = turned_to_load(shaken(faulty(pair, kind), 2e-4), flank)
    F = m.evaluate()
    # round-off of 1e-16 m beside edges that rise 1:1, on 3e-5 m
    assert wrenches_move_with_the_gearbox(m)
    m.frames["turns"] = [m.pair.gear2.z * 3, -m.pair.gear1.z * 3]
    assert np.array_equal(m.evaluate(), F)


@every_kind
@both_flanks
def test_a_tooth_comes_round_after_a_turn_of_its_gear(kind, flank):
    """Only gear 1 has faults: the same force after one of its turns, another one after a pitch."""
    m = OneMesh(make_pair(), MeshLaws(stiffness=SHAPES["parabola"]))
    made = grids(m, kind)
    m.own(**{k: (v[0], None) for k, v in made.items()})
    turned_to_load(m, flank)
    F = m.evaluate()
    fr = m.frames.copy()
    fr["phi"][1] -= 2 * math.pi * m.row["z1"] / m.row["z2"]
    fr["turns"][0] = 1
    assert np.allclose(m.evaluate(fr), F, rtol=0, atol=1e-7 * abs(F).max())
    fr = m.frames.copy()
    fr["phi"] += [2 * math.pi / m.pair.gear1.z, -2 * math.pi / m.pair.gear2.z]
    assert not np.allclose(m.evaluate(fr), F, rtol=0, atol=1e-3 * abs(F).max())


@pytest.mark.parametrize("beta", [0.0, 0.3])
@every_kind
@both_flanks
def test_swapping_the_gears_changes_nothing(beta, kind, flank):
    """The same two gears, named the other way round: each takes its grids along."""
    laws = MeshLaws(stiffness=SHAPES["parabola"], slices=0)
    a = OneMesh(make_pair(beta=beta), laws, theta=0.0)
    made = grids(a, kind)
    a.own(**made)
    turned_to_load(a, flank)
    A = a.evaluate()
    pair = GearPair(a.pair.gear2, a.pair.gear1, a.pair.a_w)
    b = OneMesh(pair, laws, theta=math.pi)
    # where one gear has its tooth 0 on the line of centres now, it had a space before
    b.own(**{k: (np.roll(v[1], -1, axis=1), np.roll(v[0], 1, axis=1)) for k, v in made.items()})
    b.frames["r"] = a.frames["r"][::-1]
    o1, o2 = (float(x) for x in a.frames["phi"])
    b.frames["phi"] = [o2 + math.pi / pair.gear1.z, o1 - math.pi / pair.gear2.z]
    B = b.evaluate()
    assert np.allclose(B[::-1], A, rtol=0.0, atol=1e-7 * abs(A).max())


@both_flanks
@pytest.mark.parametrize("pair", PAIRS)
@every_kind
def test_mirrored_faces_mirror_the_result(pair, kind, flank):
    """The other hand of helix, all grids upside down, bodies moved the other way along and about the axes."""
    mirror = np.array([1, 1, -1, -1, -1, 1.0])
    found = []
    for sign in (1, -1):
        given = dict(PAIRS[pair])
        given["beta"] *= sign
        m = OneMesh(make_pair(**given), MeshLaws(stiffness=SHAPES["parabola"]))
        made = grids(m, kind)
        m.own(**{k: [np.ascontiguousarray(g[:, :, ::sign]) for g in v] for k, v in made.items()})
        step = np.array([1e-5, 2e-5, 4e-5, 1e-4, 2e-4, 0])
        m.frames = moved(m.frames, 1, step if sign == 1 else mirror * step)
        turned_to_load(m, flank)
        found.append(m.evaluate())
    assert np.allclose(found[1], found[0] * mirror, rtol=0, atol=1e-7 * abs(found[0]).max())


@pytest.mark.nojit
def test_a_broken_end_takes_its_share_of_the_width():
    """Spur gears, even stiffness: with a third of the face gone two thirds of the force are left, and what
    reaches over the edge, half of the penetration wide."""
    shape = PairShape(c_prime=14e9, S_R=1.0)
    m = OneMesh(make_pair(beta=0.0), MeshLaws(stiffness=shape))
    z = np.linspace(-0.5, 0.5, 33) * m.row["b1"]
    level = (-m.row["b1"] / 6.0 - z)[None, None, :, None] * np.ones((2, 1, 1, 5))
    m.press(2e-5)
    F = m.get("mesh_force")
    m.own(level=(level, None))
    m.evaluate()
    assert m.get("mesh_force") == pytest.approx(F * (2.0 / 3.0 + 1e-5 / m.row["b1"]), rel=1e-9)


def test_added_compliance_is_in_series():
    """c/(1 + c q) of every pair; with the same q on both gears twice of it."""
    shape = PairShape(c_prime=14e9, S_R=1.0)
    m = OneMesh(make_pair(beta=0.3), MeshLaws(stiffness=shape))
    m.press(2e-5)
    F = m.get("mesh_force")
    q = np.full((2, 1, 3, 4), 2e-11)
    for grids_ in ((q, None), (None, q), (q, q)):
        m.own(soft=grids_)
        m.evaluate()
        total = 2e-11 * sum(g is not None for g in grids_)
        assert m.get("mesh_force") == pytest.approx(F / (1.0 + 14e9 * total), rel=1e-12)


@pytest.mark.nojit
@pytest.mark.parametrize("power", [1.0, 1.2, 1.5, 3.0])
@pytest.mark.parametrize("beta", [0.0, 0.3])
def test_a_crack_lies_in_series_with_a_power_of_the_overlap(power, beta):
    """F = K (x - C F)^e for every pair: by a bracketing solver at the same share of the path. Continuous over
    the exponent, so that a linear pair is no other law."""
    depth, q = 2e-5, 4e-11
    c = 14e9 * depth ** (1.0 - power)
    shape = PairShape(c_prime=c, S_R=1.0, power=power)
    m = OneMesh(make_pair(beta=beta), MeshLaws(stiffness=shape))
    m.press(depth)
    F = m.get("mesh_force")
    m.own(soft=(np.full((2, 1, 3, 4), q), None))
    m.evaluate(jac=1)
    load = brentq(lambda f: c * (depth - q * f) ** power - f, 0.0, depth / q, xtol=1e-9, rtol=1e-14)
    assert m.get("mesh_force") == pytest.approx(F * load / (c * depth**power), rel=1e-8)
    u = depth - q * load
    slope = 1.0 / (1.0 / (power * c * u ** (power - 1.0)) + q)
    assert m.get("mesh_stiffness") == pytest.approx(F / (c * depth**power) * slope, rel=1e-8)
    near = OneMesh(m.pair, MeshLaws(stiffness=PairShape(c_prime=c, S_R=1.0, power=power + 1e-9)))
    near.frames["phi"] = m.frames["phi"]
    near.own(soft=(np.full((2, 1, 3, 4), q), None))
    near.evaluate()
    assert near.get("mesh_force") == pytest.approx(m.get("mesh_force"), rel=1e-7)


@pytest.mark.parametrize("power", [1.0, 1.5])
@pytest.mark.parametrize("laws", [dict(d_in=4e4, d_out=2e4, s_0=4e-5), dict(chi=3.0)])
@pytest.mark.parametrize("speed", [0.05, -0.05])
def test_damping_acts_on_the_overlap_of_the_contact(power, laws, speed):
    """Of a spur pair: elastic force at u, damping at u and at its rate, du/dx of that of the bodies; tangents
    against differences."""
    depth, q = 2e-5, 4e-11
    c = 14e9 * depth ** (1.0 - power)
    m = OneMesh(make_pair(beta=0.0), MeshLaws(stiffness=PairShape(c_prime=c, S_R=1.0, power=power), **laws))
    m.own(soft=(np.full((2, 1, 3, 4), q), None))
    m.press(depth)
    F = m.get("mesh_force")
    width = F / brentq(lambda f: c * (depth - q * f) ** power - f, 0.0, depth / q, rtol=1e-14)
    u = depth - q * F / width
    w = speed / (1.0 + q * power * c * u ** (power - 1.0))
    m.frames["tw"][0, 5] = speed / m.row["r_b1"]
    m.frames["spin"][0] = speed / m.row["r_b1"]
    m.evaluate()
    if "chi" in laws:
        wanted = F * (1.0 + 3.0 * w)
    else:
        wanted = F + (4e4 if w > 0 else 2e4) * c * width / m.row["contact"]["k_ref"] * u / 4e-5 * w
    assert m.get("mesh_force") == pytest.approx(wanted, rel=1e-8)
    assert abs(wanted - F) > 1e-3 * F
    for ck, cd, key, size in ((1.0, 0.0, "phi", 1e-9), (0.0, 1.0, "tw", 1e-4)):
        m.evaluate(jac=1, ck=ck, cd=cd)
        found = m.tangent()[0, 5, 0, 5]
        slope = 0.0
        for sign in (1, -1):
            fr = m.frames.copy()
            if key == "phi":  # at the same phase
                fr["phi"] += sign * size * np.array([0.5 / m.row["r_b1"], 0.5 / m.row["r_b2"]])
            else:
                fr["tw"][0, 5] += sign * size / m.row["r_b1"]
            slope -= sign * m.evaluate(fr)[0, 5] / (2 * size) * m.row["r_b1"]
        assert found == pytest.approx(slope, rel=1e-6)


@pytest.mark.parametrize("shape", ["parabola", "hertz"])
def test_cracked_teeth_never_pull(shape):
    m = faulty("helical", "soft", shape, d_in=5e5, d_out=5e5)
    for depth in (1e-9, 1e-7, 5e-6):
        m.press(depth)
        for speed in (-0.5, -0.01, 0.5):
            fr = m.frames.copy()
            fr["tw"][0, 5] = speed / m.row["r_b1"]
            m.evaluate(fr)
            assert m.get("mesh_force") >= 0.0


FAULTS = {
    "corner": "type: broken_tooth, tooth: {}, width: 25 mm, height: 6 mm, shape: corner",
    "band": "type: broken_tooth, tooth: {}, height: 2.5 mm",
    "crack": "type: root_crack, tooth: {}, flank: both, depth: 2 mm, length: 20 mm",
    "pits": "type: pitting, tooth: {}, flank: both, "
    "pattern: {{number: 20, length: 5 mm, height: 3 mm, depth: 100 um}}",
    "wear": "type: wear, flank: both, depth: 10 um",
    "pitch": "type: pitch_error, tooth: {}, amount: 4 um",
}


@pytest.mark.parametrize("kind", ["external", "internal"])
@pytest.mark.parametrize("fault", FAULTS)
@both_flanks
def test_exact_matrices_of_faulty_teeth(kind, fault, flank):
    """Free helical bodies, every tooth with a fault. At rest, at frozen phase, the forces have a potential: K
    is symmetric. It is not that of healthy teeth."""
    law = "law: din3990, stiffness_ratio: 0.7, tip_relief_factor: 0.4"
    text = gears(kind, 20, "free", "", law)
    found = []
    for severity in (1, 0):
        teeth = range(1 if fault == "wear" else 23)
        listed = ", ".join(f"f{k}: {{{FAULTS[fault].format(k)}, severity: {severity}}}" for k in teeth)
        system = compiled(text.replace("g1: {", f"g1: {{faults: {{{listed}}}, ", 1))[1]
        state = pressed(system, np.random.default_rng(3), 0.0, flank, 1e-4)
        state.v[:] = 0.0
        K = scaled(evaluate.linearize(system, state)[2], system)
        assert np.abs(K - K.T).max() < 1e-10 * np.abs(K).max()
        found.append(K)
    # displaced alike, all teeth only turn the gear: on one flank more overlap, on the other less
    assert np.abs(found[0] - found[1]).max() > 1e-7 * np.abs(found[1]).max()
