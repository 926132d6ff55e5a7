# SPDX-License-Identifier: Apache-2.0
"""Rules of the contact of tooth surfaces, for every level, kind of pair and both flanks.

The reference of every force is the stored energy: U(q) is a function of all coordinates of both gears, and
the wrench of a conservative level is its slope by each of them, the spins included. Laws with a prescribed
stiffness over the path meet this for constant phase only.
"""

import functools
import math

import numpy as np
import pytest

from tests.support.energy_slopes import along_spins, shaken, slope_of_energy
from tests.support.flank_levels import N_PAIR, flexible, precomputed, rigid
from tests.support.mesh_alone import wrenches_move_with_the_gearbox
from tests.support.one_mesh import OneMesh, make_pair

PAIRS = {
    "spur": dict(beta=0.0),
    "helical": dict(beta=0.3),
    "left": dict(beta=-0.25),
    "internal spur": dict(beta=0.0, z2=70, internal=True),
    "internal helical": dict(beta=0.2, z2=70, internal=True),
}
LEVELS = {
    "rigid": rigid,
    "rigid, power 1.5": functools.partial(rigid, c_prime=4e12, power=1.5),
    "flexible": flexible,
    "precomputed": precomputed,
}
every_pair = pytest.mark.parametrize("pair", PAIRS)
every_level = pytest.mark.parametrize("level", LEVELS)
both_flanks = pytest.mark.parametrize("flank", [1, -1])


@functools.cache
def laws(pair, level):
    return LEVELS[level](make_pair(**PAIRS[pair]))


def mesh(pair, level, roll=0.0, **widths):
    m = OneMesh(make_pair(**PAIRS[pair]), laws(pair, level), n_pair=N_PAIR)
    for name, value in widths.items():
        m.rec[name] = value
    m.frames["phi"] = [roll, -roll * m.row["r_b1"] / m.row["r_b2"]]
    return m


@every_pair
@every_level
@both_flanks
@pytest.mark.parametrize("tilt", [0.0, 1e-4, 1e-3])
def test_forces_are_the_slopes_of_one_potential(pair, level, flank, tilt):
    """At rolls over a whole mesh cycle, so that tip edges are among the contacts. What is left are the
    differences of second order (1e-7)."""
    for roll in np.linspace(0.0, 2.0 * math.pi / 25, 5):
        m = shaken(mesh(pair, level, roll), tilt)
        m.press(2e-5 + 0.03 * tilt, flank)
        F = along_spins(m, m.evaluate())
        assert abs(F - slope_of_energy(m, spins=True)).max() < 1e-6 * abs(F).max()


@every_level
@pytest.mark.parametrize("widths", [(0.03, 0.04), (0.04, 0.03), (0.03, 0.03)])
def test_the_common_width_is_part_of_the_potential(level, widths):
    """With an axial offset of equal gears the planes become narrower; the axial force is its slope."""
    m = mesh("helical", level, 0.05, b1=widths[0], b2=widths[1])
    m.rec["w_z"] = (0.5 if widths[0] == widths[1] else 0.0 if widths[0] < widths[1] else 1.0) - m.row["w1"]
    m = shaken(m, 1e-3)
    m.press(4e-5)
    F = along_spins(m, m.evaluate())
    assert abs(F - slope_of_energy(m, spins=True)).max() < 1e-6 * abs(F).max()


@every_pair
@every_level
@both_flanks
def test_action_is_reaction_about_a_common_point(pair, level, flank):
    m = shaken(mesh(pair, level, 0.07), 2e-4)
    m.press(2e-5, flank)
    F = m.evaluate()
    moment = F[:, 3:] + np.cross(m.frames["r"], F[:, :3])
    assert abs(F[:, :3].sum(0)).max() < 1e-10 * abs(F).max()
    assert abs(moment.sum(0)).max() < 1e-10 * abs(F).max()


@every_pair
@every_level
def test_moving_the_whole_gearbox_changes_nothing(pair, level):
    m = shaken(mesh(pair, level, 0.07), 2e-4)
    m.press(2e-5)
    assert wrenches_move_with_the_gearbox(m)


@every_pair
@every_level
@both_flanks
def test_tangent_is_the_derivative_of_the_force(pair, level, flank):
    """For the travel of both gears against each other, which changes no phase, apart from the energy slopes,
    whose tangents are not in the Newton matrix: they are the torques by the mean travel."""
    m = mesh(pair, level, 0.07)
    m.press(2e-5, flank)
    m.evaluate(jac=1)
    K = m.tangent()
    r1, r2, h = m.row["r_b1"], m.row["r_b2"], 1e-9
    force = []
    for sign in (1, -1):
        fr = m.frames.copy()
        fr["phi"] += sign * h * np.array([0.5 / r1, 0.5 / r2])
        m.evaluate(fr)
        force.append(m.get("mesh_force"))
    stiffness = (force[0] - force[1]) / (2 * h)
    column = K[:, :, 0, 5] * 0.5 / r1 + K[:, :, 1, 5] * 0.5 / r2
    assert np.allclose(column[:, 5], [stiffness * r1, stiffness * r2], rtol=1e-6, atol=0)


@every_pair
@every_level
def test_the_force_is_continuous_through_the_ends_of_the_path(pair, level):
    """Tip edges take over at A and E with the same force and the same slope: the force over the phase has no
    step. Twice as many samples halve the largest difference of neighbours, which a step would not."""
    m = mesh(pair, level)
    m.press(2e-5)
    n = 2000
    force = np.zeros(n)
    for k in range(n):
        fr = m.frames.copy()
        turn = k / n * 2.0 * math.pi / 25
        fr["phi"] += [turn, -turn * m.row["r_b1"] / m.row["r_b2"]]
        m.evaluate(fr)
        force[k] = m.get("mesh_force")
    coarse, fine = (np.abs(np.diff(force[::every])).max() for every in (2, 1))
    # the slope changes by less than a tenth over a sample at most
    assert fine < 0.55 * coarse + 1e-9 * force.max()
