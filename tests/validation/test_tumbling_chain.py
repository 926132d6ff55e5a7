# SPDX-License-Identifier: Apache-2.0
"""A free chain of three bodies without forces: energy, momentum and angular momentum are kept.

A tumbling body carries another on a spherical joint, and that one a third on a revolute joint; nothing acts
from outside. What a scheme loses of energy and of both momenta falls with its order; no numbers of others
are needed. The frame is the world; momenta are taken about its origin, from the frames of the bodies.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import FLOATING, SPHERICAL
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.multistep import bdf
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame
from tests.support.trees import positive_inertia

DURATION = 2.0


def chain():
    """Three bodies of random masses and joints, moving."""
    rng = np.random.default_rng(4)
    motions, rates = (
        (FLOATING, SPHERICAL, TORSION),
        [(0.3, -0.2, 0.4, 1.0, -2.0, 3.0), (1.0, 2.0, -2.0), (3.0,)],
    )
    return assemble(
        [
            Body(
                motion=motion,
                parent=k,
                position=np.array([0.5 * k, 0.1 * k, 0.0]),
                axes=frame(rng),
                mass=rng.uniform(0.5, 2.0),
                com=0.2 * rng.normal(size=3),
                inertia=0.1 * positive_inertia(rng),
                rate=rate,
                name=f"b{k}",
            )
            for k, (motion, rate) in enumerate(zip(motions, rates, strict=True))
        ],
        {},
    )


def kept(system, state):
    """Energy, momentum (3,) and angular momentum about the origin (3,), from bodies alone."""
    evaluate.residual(system, state)
    energy, momenta = 0.0, np.zeros(6)
    for f, body in zip(system.workspace.fr[1:], system.bodies, strict=True):
        S, omega = f["S"], f["tw"][3:]
        arm = S @ body.center_of_mass()
        spin = S @ np.asarray(body.inertia) @ S.T @ omega
        push = body.mass * (f["tw"][:3] + np.cross(omega, arm))
        energy += 0.5 * push @ push / body.mass + 0.5 * omega @ spin
        momenta += np.concatenate([push, spin + np.cross(f["r"] + arm, push)])
    return np.concatenate([[energy], momenta])


def lost(system, run):
    """Largest relative change of energy, of momentum and of angular momentum."""
    reached = run.state()  # the workspace is that of the run
    before, after = kept(system, system.initial_state()), kept(system, reached)
    parts = (slice(0, 1), slice(1, 4), slice(4, 7))
    return np.array([np.linalg.norm((after - before)[p]) / np.linalg.norm(before[p]) for p in parts])


def test_an_explicit_method():
    system = chain()
    run = runge_kutta.start_adaptive(system, system.initial_state(), rtol=1e-11, atol=1e-13, atol_rate=1e-11)
    assert run.advance_to(DURATION).status == OK
    assert np.abs(run.state().charts - np.eye(3)).max() > 0.1  # it has tumbled
    assert lost(system, run).max() < 1e-9


@pytest.mark.parametrize(
    ("method", "order"), [("generalized_alpha", 2.0), ("runge_kutta", 4.0), ("adams", 4.0)]
)
def test_equal_steps_lose_by_their_order(method, order):
    """Over four halvings: new charts begin on the grid of the steps, so that one halving is not smooth."""
    found = []
    for n in (500, 8000):
        system = chain()
        if method == "runge_kutta":
            run = runge_kutta.start_classical(system, system.initial_state(), DURATION / n)
        elif method == "adams":
            run = runge_kutta.start_adams(system, system.initial_state(), DURATION / n)
        else:
            run = generalized_alpha.start(system, system.initial_state(), DURATION / n, tolerance=1e-15)
        assert run.advance(n).status == OK
        found.append(lost(system, run))
    assert np.all(np.log2(found[0] / found[1]) / 4.0 > order - 0.3)


def test_a_stiff_method_loses_by_its_tolerance():
    found = []
    for rtol in (1e-4, 1e-6, 1e-8):
        system = chain()
        run = bdf.start(system, system.initial_state(), "wstiff", rtol=rtol)
        assert run.advance_to(DURATION).status == OK
        found.append(lost(system, run))
        assert found[-1].max() < 10.0 * rtol
