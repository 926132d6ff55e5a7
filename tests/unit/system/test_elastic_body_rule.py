# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies in machines: a soft pendulum three ways, places of nodes, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.beam import beam_row
from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.craig_bampton import craig_bampton
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.multibody.structure import beam_line, turned_stiffening
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.rules.elastic_body import elastic_parts
from pitchpoint.system.system import assemble
from tests.support.beam_modes import axial_stiffening, held_modes

N, LENGTH = 6, 0.9
ROD = Beam(section=rectangle(0.01, 0.02), length=LENGTH / N, E=2e9, G=8e8, rho=1500.0)
LEVEL = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Axes of the rod in the world: its first axis along y, its second along z, itself along x."""
POSE = (np.zeros(3), LEVEL)
DOWN = np.array([0.0, -9.81, 0.0])
HINGE = np.eye(3)


def tip_of_modes(modes, structure, frame=None, closed=False):
    """Tip of the rod in the world after 0.25 s, let go level, hinged about z at the origin."""
    parts = elastic_parts(
        "rod", structure, modes, {"eye": 0, "tip": N}, first=1, frame=frame, pose=POSE, gravity=DOWN
    )
    constraints = {}
    if closed:
        rows, _ = cut_joint(TORSION, parts.bodies, parts.nodes["eye"], 0, np.zeros(3), HINGE)
        constraints = {"closure": rows}
    system = assemble(parts.bodies, {"flexible_body": parts.flexible, "guide": parts.guides}, constraints)
    run = start(system, system.initial_state(), 5e-5, rho_inf=0.9)
    run.advance(5000)
    evaluate.residual(system, run.state())
    return system.workspace.fr[parts.nodes["tip"]]["r"].copy()


def tip_of_beams():
    nodes = np.arange(N + 1) * ROD.length
    light = {"mass": 1e-7, "inertia": 1e-10 * np.eye(3)}
    bodies = [Body(motion=TORSION, mass=1e-7, inertia=1e-10 * np.eye(3), name="n0")]
    bodies += [
        Body(motion=FLOATING, position=(x, 0, 0), name=f"n{k}", **light) for k, x in enumerate(nodes) if k
    ]
    rows = [beam_row(ROD, bodies=(k, k + 1), axes=(LEVEL, LEVEL), gravity=DOWN) for k in range(1, N + 1)]
    system = assemble(bodies, {"beam": np.concatenate(rows)})
    run = start(system, system.initial_state(), 5e-5, rho_inf=0.9)
    run.advance(5000)
    evaluate.residual(system, run.state())
    return system.workspace.fr[N + 1]["r"].copy()


def test_a_soft_pendulum_three_ways():
    """Modes in a frame on the hinge, free modes held by a constraint, beams; it bends by a hundredth of it.

    Beams see what modes do not: the shortening of the bent rod, of the order of the square of the bend.
    """
    structure = beam_line([ROD] * N)
    frame = Body(motion=TORSION, axes=HINGE, inertia=np.zeros((3, 3)), name="rod")
    held = tip_of_modes(held_modes(structure, [0], 8), structure, frame)
    free = tip_of_modes(craig_bampton(structure, [0, N], 6), structure, closed=True)
    beams = tip_of_beams()
    fall = 1.5 * 9.81 / LENGTH  # angular acceleration of a stiff rod that starts level
    assert 0.2 < -held[1] / LENGTH < 0.5 * fall * 0.25**2  # it swings through large angles
    np.testing.assert_allclose(free, held, atol=2e-4 * LENGTH)
    np.testing.assert_allclose(beams, held, atol=1e-3 * LENGTH)
    np.testing.assert_allclose(np.linalg.norm(beams), LENGTH, rtol=1e-3)


def test_axes_of_the_frame_do_not_matter():
    """The same rod described in the axes of its structure and in those of the hinge."""
    structure = beam_line([ROD] * N)
    modes = craig_bampton(structure, [0, N], 3)
    rng = np.random.default_rng(4)
    turned, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    turned *= np.linalg.det(turned)
    found = []
    for own in (LEVEL, turned):
        frame = Body(
            motion=FLOATING, position=(0.1, 0.2, 0.3), axes=own, inertia=np.zeros((3, 3)), name="rod"
        )
        parts = elastic_parts(
            "rod", structure, modes, {"tip": N}, first=1, frame=frame, pose=POSE, gravity=DOWN
        )
        system = assemble(parts.bodies, {"flexible_body": parts.flexible, "guide": parts.guides})
        state = system.initial_state()
        at = [system.layout.coordinate(c) for c in parts.coordinates]
        state.q[at] = 0.01 * np.random.default_rng(5).normal(size=len(at))
        evaluate.prepare(system)
        evaluate.load(system, state)
        evaluate.check(system, evaluate.accelerations(system, 0.0))
        now = evaluate.store(system, 0.0)
        evaluate.residual(system, now)
        fr = system.workspace.fr
        found.append(np.concatenate([now.a[at], fr[1]["ac"][:3], fr[parts.nodes["tip"]]["r"]]))
    # groups of three coordinates turn a node one after the other, in whatever axes: 1e-2 * 1e-2 of a turn
    np.testing.assert_allclose(found[1], found[0], atol=1e-4 * np.abs(found[0]).max())


def test_stiffening_in_other_axes():
    rng = np.random.default_rng(1)
    given = rng.normal(size=(9, 2, 2))
    Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    a, w = rng.normal(size=3), rng.normal(size=3)

    def total(K, a, w):
        loads = [*a, w[0] ** 2, w[1] ** 2, w[2] ** 2, w[0] * w[1], w[1] * w[2], w[2] * w[0]]
        return np.einsum("r,rkl->kl", loads, K)

    np.testing.assert_allclose(
        total(turned_stiffening(given, Q), Q.T @ a, Q.T @ w), total(given, a, w), rtol=1e-12
    )


def test_tension_of_a_turning_rod():
    """Sum of the stiffness by omega_x^2: tension at the root is rho A L^2/2 omega^2."""
    line = beam_line([ROD] * N)
    geo = axial_stiffening([ROD] * N, line)
    mass = ROD.rho * ROD.section.A
    middle = 0.5 * ROD.length
    tension = geo[3, 0, 0] * 30.0 * ROD.length / 36.0  # mean in the first element
    exact = mass * (LENGTH**2 / 2 - (middle**2 + ROD.length**2 / 12) / 2)
    assert tension == pytest.approx(exact, rel=1e-12)
    assert geo[2, 0, 0] * 30.0 * ROD.length / 36.0 == pytest.approx(-mass * (LENGTH - middle), rel=1e-12)


def test_what_is_refused():
    structure = beam_line([ROD] * N)
    with pytest.raises(CompileError, match="rod: 31 modes"):
        elastic_parts("rod", structure, craig_bampton(structure, [0, N], 25), {}, first=1)
    frame = Body(motion=FLOATING, mass=1.0, inertia=np.eye(3), name="rod")
    with pytest.raises(CompileError, match="frame has a mass"):
        elastic_parts("rod", structure, craig_bampton(structure, [0, N], 2), {}, first=1, frame=frame)
    assert math.isclose(ROD.mass * N, 1500.0 * 2e-4 * LENGTH)
