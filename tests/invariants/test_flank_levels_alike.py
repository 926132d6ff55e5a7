# SPDX-License-Identifier: Apache-2.0
"""Rules of the contact of tooth surfaces for two meshes or with losses: swap, size, never pulling."""

import functools
import math

import numpy as np
import pytest

from pitchpoint.core.status import OK, UNBOUNDED
from pitchpoint.geometry import GearPair
from pitchpoint.model.components.flank_contact import OilFilm, StructuralDamping
from tests.support.flank_levels import N_PAIR, flexible, precomputed, rigid
from tests.support.mesh_alone import moved
from tests.support.one_mesh import OneMesh, make_pair

LOSSES = dict(oil=OilFilm(rate=3e4, thickness=5e-6), structural=StructuralDamping(factor=0.3, speed=1e-3))
every_level = pytest.mark.parametrize("level", ["rigid", "flexible", "precomputed"])
both_flanks = pytest.mark.parametrize("flank", [1, -1])
HELICAL = dict(beta=0.3)


@functools.cache
def made(level, losses=False):
    more = LOSSES if losses else {}
    return {"rigid": rigid, "flexible": flexible, "precomputed": precomputed}[level](
        make_pair(**HELICAL), **more
    )


@pytest.mark.each_value
@every_level
@both_flanks
def test_never_pulls(level, flank):
    """Flanks that part fast, with film and structural damping of each plane and damping of the mesh. The wide
    gap keeps the film of the other flank away."""
    rng = np.random.default_rng(4)
    laws = made(level, losses=True)
    for _ in range(60):
        m = OneMesh(make_pair(**HELICAL), laws, n_pair=N_PAIR, backlash=1e-3)
        m.rec["contact"]["d_in"] = m.rec["contact"]["d_out"] = 1e5
        m.frames["phi"] = rng.uniform(0.0, 1.0) * np.array([1.0, -m.row["r_b1"] / m.row["r_b2"]])
        m.frames = moved(m.frames, 0, 1e-5 * rng.normal(size=6) * [1, 1, 5, 10, 10, 0])
        m.press(rng.uniform(-1e-5, 3e-5), flank)
        m.frames["tw"] = rng.normal(size=(2, 6)) * [0.1, 0.1, 0.1, 1.0, 1.0, 10.0]
        m.evaluate()
        assert flank * m.get("mesh_force") >= 0.0


@every_level
def test_power_balance_of_flanks_that_part_fast(level):
    """Damping cancels elastic forces: power of the gears = change of the stored energy + losses. An axial
    offset, since the common width of equal gears has a kink without one."""
    rng = np.random.default_rng(4)
    for _ in range(4):
        m = OneMesh(make_pair(**HELICAL), made(level, losses=True), n_pair=N_PAIR, backlash=1e-3)
        m.rec["contact"]["d_in"] = m.rec["contact"]["d_out"] = 1e5
        m.frames["r"][1, 2] = 1e-4
        m.press(rng.uniform(1e-6, 3e-5))
        given, cycle, stored, lost = m.powers(rng.normal(size=(2, 6)) * [0.1, 0.1, 0.1, 1.0, 1.0, 10.0])
        assert abs(given + cycle - stored - lost) < 1e-6 * abs(stored)


@pytest.mark.each_value
@every_level
@both_flanks
@pytest.mark.parametrize("losses", [False, True])
def test_observations_change_nothing(level, flank, losses):
    """Wrenches and tangents with and without them: step loops evaluate without, nearly all tests with."""
    rng = np.random.default_rng(6)
    for _ in range(20):
        m = OneMesh(make_pair(**HELICAL), made(level, losses), n_pair=N_PAIR)
        m.frames["phi"] = rng.uniform(0.0, 1.0) * np.array([1.0, -m.row["r_b1"] / m.row["r_b2"]])
        m.frames = moved(m.frames, 0, 1e-5 * rng.normal(size=6) * [1, 1, 5, 10, 10, 0])
        m.press(rng.uniform(1e-6, 3e-5), flank)
        m.frames["tw"] = rng.normal(size=(2, 6)) * [0.1, 0.1, 0.1, 1.0, 1.0, 10.0]
        status, forces = m.attempt(jac=1, cd=1e-4)
        tangents = m.kk.copy()
        m.ctl["out"] = 0
        again, plain = m.attempt(jac=1, cd=1e-4)
        assert status == again == OK
        assert np.abs(forces).max() > 0.0
        assert np.abs(plain - forces).max() <= 1e-12 * np.abs(forces).max()
        assert np.abs(m.kk - tangents).max() <= 1e-12 * np.abs(tangents).max()


@pytest.mark.parametrize("level", ["rigid", "flexible"])
def test_more_pairs_than_a_mesh_can_have_end_with_a_status(level):
    """Gears that a diverging solution moves towards each other overlap in ever more pairs, beyond the memory
    of the nodes."""
    m = OneMesh(make_pair(**HELICAL), made(level), n_pair=N_PAIR, backlash=1e-3)
    m.frames["phi"] += [3e-3 / m.row["r_b1"], 0.0]
    found = []
    for closer in np.linspace(0.0, 12e-3, 25):
        frames = m.frames.copy()
        frames["r"][1, 0] -= closer
        found.append(m.attempt(frames)[0])
        assert int(m.row["n_nodes"]) <= int(m.row["max_nodes"])
    assert found[0] == OK
    assert UNBOUNDED in found


@pytest.mark.parametrize("level", ["rigid", "flexible"])
@pytest.mark.parametrize("depth", [-2e-6, 1e-6])
def test_tangent_with_film(level, depth):
    """Newton matrix of flanks with a squeeze film, at a gap and in contact where other planes have a gap, by
    positions and by velocities."""
    m = OneMesh(make_pair(**HELICAL), made(level, losses=True), n_pair=N_PAIR, backlash=1e-3)
    m.frames["phi"] = [0.07, -0.07 * 25 / 60]
    m.press(depth)
    m.frames["tw"][0, 5] = 0.5
    for name, h in (("phi", 1e-8), ("tw", 1e-6)):
        m.evaluate(jac=1, ck=float(name == "phi"), cd=float(name == "tw"))
        slope = m.tangent()[0, 5, 0, 5]
        torque = []
        for sign in (1, -1):
            frames = m.frames.copy()
            where = frames[name][0, 5:] if name == "tw" else frames[name][:1]
            where += sign * h
            torque.append(m.evaluate(frames)[0, 5])
        assert slope == pytest.approx((torque[1] - torque[0]) / (2 * h), rel=5e-3)


@pytest.mark.parametrize("level", ["rigid", "flexible"])
@both_flanks
def test_swapping_the_gears_changes_nothing(level, flank):
    """The same gears with exchanged numbers: same wrench on each, same energy. Without an axial offset, equal
    widths are where the common width begins to decrease, on one side for each number."""
    pair = make_pair(**HELICAL)
    first = OneMesh(pair, made(level), theta=0.0, n_pair=N_PAIR)
    first.frames["phi"], first.frames["r"][1, 2] = [0.011, -0.003], 1e-4
    first.press(2e-5, flank)
    F = first.evaluate()
    swapped = GearPair(pair.gear2, pair.gear1, pair.a_w)
    laws = rigid(swapped) if level == "rigid" else flexible(swapped, order=(1, 0))
    second = OneMesh(swapped, laws, theta=math.pi, n_pair=N_PAIR)
    second.frames["r"] = first.frames["r"][::-1]
    second.frames["phi"] = first.frames["phi"][::-1]
    # its gear 1 is assembled with a tooth on the line of centres, not a space: half a pitch apart
    second.frames["phi"] += [math.pi / swapped.gear1.z, -math.pi / swapped.gear2.z]
    found = second.evaluate()[::-1]
    assert second.get("elastic_energy") == pytest.approx(first.get("elastic_energy"), rel=1e-9)
    assert abs(found - F).max() < 1e-9 * abs(F).max()


@pytest.mark.each_value
@every_level
@both_flanks
def test_size(level, flank):
    """All lengths doubled, same material: forces by 4, moments by 8. The overlap of a table is a share of
    the compliance at a given line load, which the contact width changes by 2 %: 1e-4 of the force."""
    laws = {"rigid": rigid, "flexible": flexible, "precomputed": precomputed}[level]
    wrench = []
    for k in (1.0, 2.0):
        pair = make_pair(**HELICAL, m_n=3e-3 * k, b=0.03 * k, widening=2e-5 * k)
        m = OneMesh(pair, laws(pair, **({} if level == "rigid" else {"scale": k})), n_pair=N_PAIR)
        m.frames["phi"] = np.array([0.07, -0.07 * 25 / 60])
        m.frames = moved(m.frames, 0, np.array([1e-5, -1e-5, 4e-5, 0, 0, 0]) * k + [0, 0, 0, 2e-4, 1e-4, 0])
        m.press(2e-5 * k, flank)
        wrench.append(m.evaluate() / k**2 / [1, 1, 1, k, k, k])
    most = 2e-4 if level == "precomputed" else 1e-9
    assert abs(wrench[1] - wrench[0]).max() < most * abs(wrench[0]).max()
