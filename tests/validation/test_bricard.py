# SPDX-License-Identifier: Apache-2.0
"""Bricard's mechanism: five rods along the edges of a cube, six revolute joints, one freedom too many rows.

R. Bricard, Lecons de cinematique II (1927): six equal links whose axes follow each other at right angles
move although a count of joints gives no freedom. As problem of the IFToMM library: rods of 1 m and 1 kg,
ground is the sixth link, gravity 9.81 m/s^2. Here ground lies between (0, 0, 1) and (0, 0, 0), the rods
follow the edges to (1, 0, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1) and back, each axis is the third edge at its
corner; gravity along -y.

The reference knows no joints: five angles solve the closure of the loop for a given sixth (least squares of
twelve numbers), the rods are point masses on the curves that follow (tests/support/one_freedom.py).
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.solvers.constraints.row_notes import row_notes
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.one_freedom import ROD, OneFreedom, along_rod, turn_about

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1], [0, 0, 1]], float)
JOINT_AXES = np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]], float)
GRAVITY = np.array([0.0, -9.81, 0.0])


def mechanism(backwards=False):
    """Five rods in a chain from one end of ground to the other, the last joint cut."""
    order = range(5, -1, -1) if backwards else range(6)
    corners, joint_axes = CORNERS[list(order)], JOINT_AXES[list(order)]
    bodies = []
    for k in range(5):
        along, z = corners[k + 1] - corners[k], joint_axes[k]
        bodies.append(
            Body(
                motion=TORSION,
                parent=k,
                position=corners[k],
                axes=np.column_stack([along, np.cross(z, along), z]),
                mass=1.0,
                com=(0.5, 0.0, 0.0),
                inertia=np.diag([0.0, 1.0, 1.0]) / 12.0,
                name=f"rod{k + 1}",
            )
        )
    z, x = joint_axes[5], np.roll(joint_axes[5], 1)
    rows, words = cut_joint(TORSION, bodies, 5, 0, corners[5], np.column_stack([x, np.cross(z, x), z]))
    names = {"closure": [f"last joint {word}" for word in words]}
    return assemble(bodies, {"gravity": gravity_records(bodies, GRAVITY)}, {"closure": rows}, names=names)


def chain(angles):
    """Motions (4, 4) of the five rods and of what is ground again behind the last joint."""
    found, T = [], np.eye(4)
    for point, axis, angle in zip(CORNERS, JOINT_AXES, angles, strict=True):
        T = T @ turn_about(point, axis, angle)
        found.append(T)
    return found


def closed(second, guess):
    """All six angles for a given second one: Newton's method with differences on the closed loop."""
    angles = guess.copy()
    angles[1] = second
    others = np.delete(np.eye(6), 1, axis=0)

    def gap(x):
        return (chain(x)[-1] - np.eye(4))[:3].ravel()

    for _ in range(30):
        off = gap(angles)
        if np.abs(off).max() < 3e-15:
            break
        slope = np.transpose([(gap(angles + 1e-6 * e) - gap(angles - 1e-6 * e)) / 2e-6 for e in others])
        angles -= others.T @ np.linalg.lstsq(slope, off, rcond=1e-7)[0]
    assert np.abs(gap(angles)).max() < 1e-13
    return angles


def places(second):
    """Places of the fifteen masses of the five rods."""
    angles = np.zeros(6)
    for part in np.linspace(0.0, second, int(abs(second) / 0.2) + 2)[1:]:
        angles = closed(part, angles)
    rods = zip(chain(angles)[:5], CORNERS[:-1], CORNERS[1:], strict=True)
    return np.concatenate([along_rod(a, b) @ T[:3, :3].T + T[:3, 3] for T, a, b in rods])


TIMES = np.array([0.3, 0.6, 0.9, 1.2])


@pytest.fixture(scope="module")
def reference():
    """The reduction, and its coordinate and rate at the times."""
    reduced = OneFreedom(np.tile(ROD, 5), places, (-3.5, 0.2), GRAVITY)
    return reduced, reduced.motion(0.0, 0.0, TIMES)


def points(system, state):
    """Places and velocities of the middles of all rods."""
    evaluate.residual(system, state)
    fr = system.workspace.fr[1:]
    arms = np.array([f["S"] @ (0.5, 0.0, 0.0) for f in fr])
    speeds = fr["tw"][:, :3] + np.cross(fr["tw"][:, 3:], arms)
    return fr["r"] + arms, speeds


def energy(system, state):
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
    return 0.5 * state.v @ M @ state.v + 9.81 * points(system, state)[0][:, 1].sum()


def test_one_row_repeats_others_and_is_named():
    """Five coordinates, five rows, one freedom: a count gives none."""
    system = mechanism()
    found = assemble_state(system)
    assert found.freedoms == 1
    assert len(found.redundant) == 1
    assert found.redundant[0].startswith("closure last joint")
    assert runge_kutta.start_adaptive(system, found.state).advance_to(1e-3).status == OK
    (note,) = row_notes(system)
    assert note.startswith("last joint") and "redundant with other joints" in note


def check(advance, run, reference, most):
    """Middles of the rods, their speeds and the energy at all times."""
    reduced, (second, rate) = reference
    system = mechanism()  # not that of the run, whose matrix is in use
    begun = energy(system, run.state())
    for k, t in enumerate(TIMES):
        assert advance(t).status == OK
        state = run.state()
        place, speed = points(system, state)
        np.testing.assert_allclose(place, reduced.places(second[k])[1::3], atol=most)
        np.testing.assert_allclose(speed, reduced.places(second[k], 1)[1::3] * rate[k], atol=8.0 * most)
        assert abs(energy(system, state) - begun) < 40.0 * most


@pytest.mark.study
def test_an_explicit_method(reference):
    """Every step leaves a part of 1e-11; angles turn at up to 8 rad/s."""
    system = mechanism()
    state = assemble_state(system).state
    run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    check(run.advance_to, run, reference, 1e-10)


@pytest.mark.each_value
@pytest.mark.parametrize("form", bdf.FORMS)
@pytest.mark.parametrize("kind", ["gstiff", "wstiff", "dassl"])
def test_stiff_methods(kind, form, reference):
    """A few hundred steps at 1e-7 each, without a word about the row that repeats others."""
    system = mechanism()
    run = bdf.start(system, assemble_state(system).state, kind, form=form, rtol=1e-7)
    check(run.advance_to, run, reference, 2e-6)


def test_equal_steps(reference):
    """Steps of 1 ms at 8 rad/s: (8e-3)^2."""
    system = mechanism()
    run = generalized_alpha.start(system, assemble_state(system).state, 1e-3, form="SI2")
    check(lambda t: run.advance(round(t / 1e-3) - run.steps), run, reference, 1e-4)


def test_the_chain_may_hang_from_its_other_end():
    """Other coordinates, another joint cut, another row that repeats: the same motion to the tolerance."""
    found = []
    for backwards in (False, True):
        system = mechanism(backwards)
        state = assemble_state(system).state
        run = runge_kutta.start_adaptive(system, state, rtol=1e-11, atol=1e-13, atol_rate=1e-11)
        assert run.advance_to(TIMES[-1]).status == OK
        found.append(points(system, run.state()))
    (place, speed), (other_place, other_speed) = found
    np.testing.assert_allclose(other_place[::-1], place, atol=1e-9)
    np.testing.assert_allclose(other_speed[::-1], speed, atol=1e-8)
