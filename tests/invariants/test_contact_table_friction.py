# SPDX-License-Identifier: Apache-2.0
"""Friction with pre-computed contact: it never drives and is that of flexible contact; exact tangents."""

import functools
import math

import numpy as np
import pytest

from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.record import ROWS
from pitchpoint.elements.mesh.surface.tabulated import tabulated_flank
from tests.support.flank_levels import N_PAIR, flexible, precomputed
from tests.support.mesh_alone import moved
from tests.support.one_mesh import OneMesh, make_pair

PAIRS = {"spur": dict(beta=0.0), "helical": dict(beta=0.3), "ring": dict(beta=0.2, z2=70, internal=True)}
every_pair = pytest.mark.parametrize("pair", PAIRS)
MU = 0.08
TURN = 2.0  # spin of gear 1 [rad/s]


@functools.cache
def made(pair, level):
    return {"flexible": flexible, "precomputed": precomputed}[level](make_pair(**PAIRS[pair]))


def rubbing(pair, level, rng, mu=MU, across=0.3):
    """A mesh at a random place with a random motion; `across`: lateral velocities over those of sliding."""
    m = OneMesh(make_pair(**PAIRS[pair]), made(pair, level), n_pair=N_PAIR, backlash=1e-4)
    ratio = m.row["r_b1"] / m.row["r_b2"]
    roll = rng.uniform(0.0, 2.0 * math.pi / 25)
    m.frames["phi"] = roll * np.array([1.0, -ratio])
    m.frames = moved(m.frames, 0, rng.normal(size=6) * [5e-6, 5e-6, 2e-5, 2e-4, 2e-4, 0.0])
    law = m.rec["contact"]
    law["mu"] = law["mu_s"] = mu
    law["v_eps"], law["v_s"], law["normal"] = 2e-3, 1e-3, 1.0 / math.cos(m.pair.gear1.beta_b)
    m.press(2e-5, 1 if rng.random() < 0.5 else -1)
    slide = TURN * 0.01  # at the ends of the path
    m.frames["tw"] = rng.normal(size=(2, 6)) * across * slide * np.array([1, 1, 1, 10, 10, 0])
    for body, spin in enumerate((TURN, -TURN * ratio)):
        m.frames["spin"][body] = spin
        m.frames["tw"][body, 5] += spin
    return m


@every_pair
def test_friction_never_drives(pair):
    """Motions across the line of action may reverse the sliding on either side of the pitch point."""
    rng = np.random.default_rng(5)
    for _ in range(100):
        m = rubbing(pair, "precomputed", rng, across=rng.choice([0.0, 0.1, 1.0, 10.0]))
        m.evaluate()
        assert m.get("friction_power") >= 0.0


@pytest.mark.each_value
@every_pair
@pytest.mark.parametrize(("across", "most"), [(0.0, 0.06), (0.3, 0.3), (3.0, 0.12)])
def test_friction_is_that_of_flexible_contact(pair, across, most):
    """Wrenches with friction less those without, mean error over mu F; moments over the base radius.

    0.05 are the eight phases of the coarse table. Motions of 0.3 times the sliding at the ends of the path
    reverse the sliding of a third of the load on one side of the pitch point, and the table reverses the
    friction of a side as a whole; slow ones reverse little, fast ones nearly always all of it.
    """
    errors = []
    for seed in range(20):
        found = {}
        for level in ("flexible", "precomputed"):
            m = rubbing(pair, level, np.random.default_rng(seed), across=across)
            with_friction = m.evaluate()
            force = abs(m.get("mesh_force"))
            m.rec["contact"]["mu"] = 0.0
            found[level] = (with_friction - m.evaluate()) / (MU * force)
            found[level][:, 3:] /= m.row["r_b1"]
        errors.append(abs(found["precomputed"] - found["flexible"]).max())
    assert np.mean(errors) < most


def flank_sums(m, name=None, place=0, step=0.0):
    """Forces along the rows of the wrench basis and their tangent, with one change of the flank."""
    kept = m.row["now"].copy(), m.row["rate"].copy()
    if name == "rate":
        m.rec["rate"][0, place] += step
    elif name is not None:
        m.rec["now"][name] += step
    m.rec["sums"] = 0
    assert invoke(tabulated_flank, m.rec.ctypes.data, 0, 0) == OK
    m.rec["now"], m.rec["rate"] = kept
    return m.row["sums"]["force"].copy(), m.row["sums"]["tangent"].copy()


@every_pair
@pytest.mark.parametrize("chi", [0.0, 5.0])
def test_tangent_is_the_derivative_by_positions_and_velocities(pair, chi):
    """Of all rows, friction included, by the motions along them: positions along the rows of the normal force
    change approach and misalignment. Central differences; `chi`: damping over force and speed [s/m]."""
    rng = np.random.default_rng(11)
    unit = np.array([1.0, 0.03, 1.0, 0.03, 0.03])  # forces, and moments over the face width
    for _ in range(10):
        m = rubbing(pair, "precomputed", rng, across=0.1)
        m.rec["contact"]["chi"] = chi
        m.rec["contact"]["v_eps"], m.rec["contact"]["v_s"] = 0.2, 0.1
        m.evaluate()
        request = m.rec["request"]
        request["out"], request["jac"] = 0, 1
        changes = [("x_0", 0, 1e-9), ("kappa", 0, -1e-7)], [("rate", p, 1e-6) for p in range(ROWS)]
        for velocities in (0, 1):
            request["ck"], request["cd"] = 1.0 - velocities, float(velocities)
            found = flank_sums(m)[1] / np.outer(unit, unit)
            wanted = np.zeros((ROWS, ROWS))
            for q, (name, place, h) in enumerate(changes[velocities]):
                one, two = (flank_sums(m, name, place, sign * h)[0] for sign in (1, -1))
                wanted[:, q] = (one - two) / (2.0 * abs(h)) / unit / unit[q]
            assert abs(wanted[2:]).max() > 0.0
            assert abs(found - wanted).max() < 1e-6 * abs(wanted).max()
