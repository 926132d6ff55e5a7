# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies in a floating frame against their point masses, and rotating blades against the
literature."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import eigh

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import bushing, guide, spring_damper
from pitchpoint.elements.flexible_body import flexible_row, interface_bodies, modal_bodies
from pitchpoint.multibody.beam_section import Beam, Section, tube
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.craig_bampton import craig_bampton
from pitchpoint.multibody.joints import FLOATING, GUIDED
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.multibody.structure import beam_line
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.beam_modes import axial_stiffening, free_modes, held_modes
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
@pytest.mark.parametrize("n", [2, 5, 20])
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


@pytest.mark.parametrize("n", [pytest.param(5, marks=pytest.mark.nojit), 20])
def test_tangents_are_derivatives(n):
    rng = np.random.default_rng(6)
    root = rng.normal(size=(n, n))
    system, *_ = flying(n, damping=root @ root.T, axes=frame(rng))
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
    shape = np.tile(free_modes(body, 16).shape, 2)[:, :31]
    with pytest.raises(CompileError, match="31 modal coordinates"):
        flexible_row(mass_invariants(body, shape), np.ones(31), frame=1, hidden=tuple(range(2, 13)))


def held(n=6, spring=300.0):
    """Truss with two nodes on springs to ground and between themselves, through interface frames."""
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
    first = Body(mass=1.0, polar_inertia=1.0, name="a")
    with pytest.raises(CompileError, match="b: only a guided body"):
        assemble([first, Body(mass=1.0, polar_inertia=1.0, shares=1, name="b")], {})
    with pytest.raises(CompileError, match="b: shares the coordinates of body 3"):
        assemble([first, Body(motion=GUIDED, shares=3, name="b")], {})


def blade(speed, start=0.0, n=24, modes=12):
    """Uniform thin blade of length 1 along z that turns about x; stiffness such that E I = rho A = 1.

    Returns damped frequencies over sqrt(E I / rho A L^4), of bending towards x (out of the plane of
    rotation) and towards y (in it).
    """
    thin = Section(A=1e-2, I_1=1e-8, I_2=1e-8, J=2e-8, kappa_1=0.0, kappa_2=0.0)
    beams = [Beam(section=thin, length=1.0 / n, E=1e8, G=4e13, rho=1e2)] * n
    line = beam_line(beams)
    found = held_modes(line, [0], modes)
    shape, frequency = found.shape, found.frequency
    geo = np.einsum("ka,rkl,lb->rab", shape, axial_stiffening(beams, line, start), shape)
    base = Body(motion=GUIDED, guided_by=(), inertia=np.zeros((3, 3)), name="hub")
    turn = np.zeros(1, guide.RECORD)
    turn["i"], turn["m"], turn["k"], turn["slope"], turn["first"] = 1, 3, guide.TIME, speed, 1
    hidden, guides = modal_bodies("blade", modes, first=2)
    row = flexible_row(
        mass_invariants(line, shape, (0.0, 0.0, -start)),
        (2.0 * math.pi * frequency) ** 2,
        frame=1,
        hidden=tuple(range(2, 2 + len(hidden))),
        stiffening=geo,
    )
    system = assemble([base, *hidden], {"flexible_body": row, "guide": np.concatenate([turn, guides])})
    state = system.initial_state()
    M, D, K = evaluate.linearize(system, state)
    order = [system.layout.coordinate(f"blade.{k // 3 + 1}.eta{k + 1}") for k in range(modes)]
    M, D, K = (X[np.ix_(order, order)] for X in (M, D, K))
    # straight bending has no Coriolis coupling
    np.testing.assert_allclose(D, 0.0, atol=1e-6 * np.abs(K).max())
    values, vectors = eigh(K, M)
    towards = np.abs(shape[0::6] @ vectors).max(axis=0) > np.abs(shape[1::6] @ vectors).max(axis=0)
    return np.sqrt(values[towards]), np.sqrt(values[~towards])


@pytest.mark.parametrize(
    ("speed", "first", "second"),
    [(0.0, 3.5160, 22.0345), (2.0, 4.1373, 22.6149), (6.0, 7.3604, 26.8091), (12.0, 13.1702, 37.6031)],
)
def test_rotating_blade(speed, first, second):
    """Wright, Smith, Thresher, Wang, J. Appl. Mech. 49 (1982) 197-202, Table 1, hub radius 0; to 1e-3.

    Six modes of the blade at rest in either direction make the error; without stiffening the first flapping
    frequency would not rise at all. Southwell: omega^2 = omega_0^2 + 1.19 speed^2 at low speed.
    """
    flap, lag = blade(speed)
    assert flap[0] == pytest.approx(first, rel=1e-3)
    assert flap[1] == pytest.approx(second, rel=1e-3)
    assert lag[0] == pytest.approx(math.sqrt(first**2 - speed**2), rel=4e-3)
    if speed == 2.0:
        assert (flap[0] ** 2 - 3.5160**2) / speed**2 == pytest.approx(1.19, abs=0.01)


def test_reduced_shaft_on_springs_is_the_full_one():
    """Craig-Bampton modes in the floating frame, ends on bushings: frequencies of the full model to 0.1 %."""
    sizes = [0.05] * 8 + [0.08] * 8 + [0.04] * 8
    full = beam_line([Beam(section=tube(d), length=0.05, E=2.1e11, G=8.1e10, rho=7850.0) for d in sizes])
    found = craig_bampton(full, [0, 24], 6)  # with the six of the interface all that a body can have here
    base = Body(motion=FLOATING, inertia=np.zeros((3, 3)), name="frame")
    hidden, guides = modal_bodies("shaft", 12, first=2)
    numbers = tuple(range(2, 6))
    row = flexible_row(
        mass_invariants(full, found.shape),
        (2.0 * math.pi * found.frequency) ** 2,
        frame=1,
        hidden=numbers,
    )
    bodies, rows, springs = [base, *hidden], [guides], np.zeros(2, bushing.RECORD)
    k = np.array([2e6, 3e6, 1e6, 1e3, 1e3, 1e3])
    for end, (node, spring) in enumerate(zip((0, 24), springs, strict=True)):
        more, records = interface_bodies(
            f"end{end}",
            found.at_node(full, node),
            place=full.places[node],
            axes=np.eye(3),
            frame=1,
            hidden=numbers,
            first=len(bodies) + 1,
        )
        bodies += more
        rows.append(records)
        bushing.defaults(spring)
        spring["i"], spring["p_j"], spring["K"] = len(bodies), full.places[node], np.diag(k)
    banks = {"flexible_body": row, "guide": np.concatenate(rows), "bushing": springs}
    system = assemble(bodies, banks)
    M, _, K = evaluate.linearize(system, system.initial_state())
    got = np.sqrt(eigh(0.5 * (K + K.T), M, eigvals_only=True))
    held = np.zeros(full.size)
    held[:6], held[-6:] = k, k
    expected = np.sqrt(eigh(full.K.toarray() + np.diag(held), full.M.toarray(), eigvals_only=True))
    # six modes of the rigid body on its bushings and the first bending pair; torsion needs more held modes
    np.testing.assert_allclose(got[:6], expected[:6], rtol=1e-3)
