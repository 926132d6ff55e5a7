# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies in a floating frame against their point masses, and rotating blades against the literature."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.flexible_body import flexible_row, interface_bodies, modal_bodies
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.craig_bampton import free_modes
from pitchpoint.multibody.joints import FLOATING, GUIDED
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import differences, frame
from tests.support.floating import reference_forces, truss

ORIGIN = np.array([0.1, -0.2, 0.3])


def flying(n=5, gravity=(0.0, 0.0, -9.81), damping=None, axes=None):
    """Truss with n modes, free in space; its structure, shapes, stiffness."""
    body = truss()
    modes = free_modes(body, n)
    stiffness = np.diag((2.0 * math.pi * modes.frequency) ** 2)
    base = Body(
        motion=FLOATING, inertia=np.zeros((3, 3)), axes=np.eye(3) if axes is None else axes, name="frame"
    )
    hidden, guides = modal_bodies("body", n, first=2)
    row = flexible_row(
        mass_invariants(body, modes.shape, ORIGIN),
        stiffness,
        frame=1,
        hidden=tuple(range(2, 2 + len(hidden))),
        gravity=gravity,
        damping=damping,
    )
    system = assemble([base, *hidden], {"flexible_body": row, "guide": guides})
    return system, body, modes.shape, stiffness


def stirred(system, seed=1, size=0.3):
    rng = np.random.default_rng(seed)
    state = system.initial_state()
    n = state.q.size
    state.q, state.v, state.a = size * rng.normal(size=n), rng.normal(size=n), rng.normal(size=n)
    return state


def modal_indices(system, n):
    return [system.layout.coordinate(f"body.{k // 3 + 1}.eta{k + 1}") for k in range(n)]


@pytest.mark.nojit
@pytest.mark.parametrize("n", [2, 5, 12])
def test_forces_are_those_of_the_point_masses(n):
    system, body, shape, stiffness = flying(n)
    state = stirred(system)
    evaluate.residual(system, state)
    at = modal_indices(system, n)
    eta = np.array([state.q[at], state.v[at], state.a[at]])
    fr = system.workspace.fr
    wrench, modal = reference_forces(body, shape, stiffness, fr[1], eta, ORIGIN, np.array([0.0, 0.0, -9.81]))
    np.testing.assert_allclose(fr[1]["F"], wrench, atol=1e-10 * np.abs(wrench).max())
    found = [fr[2 + k // 3]["F"][k % 3] for k in range(n)]
    np.testing.assert_allclose(found, modal, atol=1e-10 * np.abs(modal).max())
    np.testing.assert_allclose(evaluate.residual(system, state)[at], -modal, atol=1e-10 * np.abs(modal).max())


@pytest.mark.nojit
def test_tangents_are_derivatives():
    rng = np.random.default_rng(6)
    root = rng.normal(size=(5, 5))
    system, *_ = flying(damping=root @ root.T, axes=frame(rng))
    state = stirred(system)
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-3), (K, "q", 1e-5)):
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-7 * np.abs(K).max())


def test_stiffening_by_loads_has_its_tangents_too():
    system, *_ = flying()
    rng = np.random.default_rng(8)
    geo = rng.normal(size=(9, 5, 5))
    system.records["flexible_body"]["geo"][0, :, :5, :5] = geo + geo.transpose(0, 2, 1)
    state = stirred(system)
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-3), (K, "q", 1e-5)):
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-7 * np.abs(K).max())


def test_energy_and_momentum_of_a_free_body_stay():
    """Their rates along the motion, by differences of fourth order over a path in time."""
    system, body, shape, stiffness = flying(gravity=(0.0, 0.0, 0.0))
    state = stirred(system)
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.accelerations(system, 0.0))
    start = evaluate.store(system, 0.0)
    at = modal_indices(system, 5)
    masses = body.M.diagonal().reshape(-1, 3)[:, 0]
    h, found = 1e-4, {}
    for k in (-2, -1, 1, 2):
        moved = start.copy()
        moved.q = start.q + k * h * start.v + 0.5 * (k * h) ** 2 * start.a
        moved.v = start.v + k * h * start.a
        evaluate.residual(system, moved)
        f = system.workspace.fr[1]
        x = (body.places - ORIGIN + (shape @ moved.q[at]).reshape(-1, 3)) @ f["S"].T
        speed = f["tw"][:3] + np.cross(f["tw"][3:], x) + (shape @ moved.v[at]).reshape(-1, 3) @ f["S"].T
        energy = 0.5 * np.sum(masses[:, None] * speed**2) + 0.5 * moved.q[at] @ stiffness @ moved.q[at]
        p = (masses[:, None] * speed).sum(axis=0)
        moment = np.cross(f["r"] + x, masses[:, None] * speed).sum(axis=0)
        found[k] = np.concatenate([[energy], p, moment])
    rates = (8 * (found[1] - found[-1]) - (found[2] - found[-2])) / (12 * h)
    # elastic forces alone have powers of 1e4
    np.testing.assert_allclose(rates, 0.0, atol=1e-4)
    assert np.abs(stiffness @ start.q[at]).max() > 1e3


def test_too_many_modes_are_refused():
    body = truss()
    with pytest.raises(CompileError, match="13 modal coordinates"):
        flexible_row(
            mass_invariants(body, free_modes(body, 13).shape), np.ones(13), frame=1, hidden=(2, 3, 4, 5, 6)
        )


def held(n=6, spring=300.0):
    """Truss with two nodes on springs to ground and between themselves, through interface frames."""
    from pitchpoint.elements import spring_damper

    system, body, shape, stiffness = flying(n)
    base, hidden = system.bodies[0], list(system.bodies[1:])
    numbers = tuple(range(2, 2 + len(hidden)))
    bodies, guides = [base, *hidden], [system.records["guide"]]
    for node in (2, 7):
        part = np.zeros((6, n))
        part[:3] = shape[3 * node : 3 * node + 3]
        part[3:] = 0.1 * np.random.default_rng(node).normal(size=(3, n))  # as if the node could turn
        more, rows = interface_bodies(
            f"node{node}",
            part,
            place=body.places[node] - ORIGIN,
            axes=np.eye(3),
            frame=1,
            hidden=numbers,
            first=len(bodies) + 1,
        )
        bodies += more
        guides.append(rows)
    ends = [k for k, b in enumerate(bodies, start=1) if b.name in ("node2", "node7")]
    springs = np.zeros(3, spring_damper.RECORD)
    springs["i"], springs["j"] = (ends[0], ends[1], ends[0]), (0, 0, ends[1])
    springs["p_i"], springs["p_j"] = (0.1, 0.0, 0.2), (1.0, 2.0, 3.0)
    springs["k"], springs["d"], springs["free"] = spring, 2.0, 1.0
    clean = np.concatenate(guides)
    banks = {"flexible_body": system.records["flexible_body"], "guide": clean, "spring_damper": springs}
    return assemble(bodies, banks), body, shape


def test_interface_frames_go_with_their_nodes():
    system, body, shape = held()
    state = stirred(system, size=0.05)
    evaluate.residual(system, state)
    fr = system.workspace.fr
    at = [system.layout.coordinate(f"body.{k // 3 + 1}.eta{k + 1}") for k in range(6)]
    for node in (2, 7):
        f = fr[system.layout.bodies.index(f"node{node}")]
        local = body.places[node] - ORIGIN + shape[3 * node : 3 * node + 3] @ state.q[at]
        expected = fr[1]["r"] + fr[1]["S"] @ local
        # the second group of coordinates moves along axes that the first has turned by 0.1 * 0.05
        np.testing.assert_allclose(f["r"], expected, atol=0.02 * np.abs(shape @ state.q[at]).max())
    assert system.sizes["nd"] == 12


def test_interface_forces_have_exact_tangents():
    system, *_ = held()
    state = stirred(system)
    M, D, K = evaluate.linearize(system, state)
    for found, key, step in ((M, "a", 1e-2), (D, "v", 1e-3), (K, "q", 1e-5)):
        np.testing.assert_allclose(found, differences(system, state, key, step), atol=1e-7 * np.abs(K).max())


def test_only_guided_bodies_share():
    bodies = [Body(mass=1.0, polar_inertia=1.0, name="a"), Body(mass=1.0, polar_inertia=1.0, shares=1, name="b")]
    with pytest.raises(CompileError, match="b: only a guided body"):
        assemble(bodies, {})
    with pytest.raises(CompileError, match="b: shares the coordinates of body 3"):
        assemble([bodies[0], Body(motion=GUIDED, shares=3, name="b")], {})
