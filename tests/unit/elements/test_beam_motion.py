# SPDX-License-Identifier: Apache-2.0
"""Beams and elastic bodies that fly: energy and momentum through the time loop, over whole revolutions."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.elements.beam import beam_row
from pitchpoint.elements.flexible_body import flexible_row, modal_bodies
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.solvers.implicit.generalized_alpha import start
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.beam_modes import free_modes
from tests.support.floating import truss


def beam_chain():
    """Four soft flat beams between five light bodies, turning and thrown at the middle."""
    beam = Beam(section=rectangle(0.03, 0.02), length=0.25, E=2e9, G=8e8, rho=2000.0)
    bodies = [
        Body(motion=FLOATING, position=(0, 0, 0.25 * k), mass=0.1, inertia=1e-4 * np.eye(3), name=f"n{k}")
        for k in range(5)
    ]
    rows = np.concatenate([beam_row(beam, bodies=(k + 1, k + 2)) for k in range(4)])
    system = assemble(bodies, {"beam": rows})
    state = system.initial_state()
    spin = np.array([6.0, 4.0, 9.0])
    for k in range(5):
        speed = np.cross(spin, [0.0, 0.0, 0.25 * k - 0.5])
        for words, values in ((("x", "y", "z"), speed), (("alpha", "beta", "spin"), spin)):
            for word, value in zip(words, values, strict=True):
                state.v[system.layout.coordinate(f"n{k}.{word}")] = value
    state.v[system.layout.coordinate("n2.x")] += 3.0
    return system, state


def beam_energy(system, state):
    """Energy, momentum and angular momentum about the origin of the world, and strain energy (NumPy)."""
    evaluate.residual(system, state)
    energy, p, turn, strain = 0.0, np.zeros(3), np.zeros(3), 0.0
    for body, f in zip(system.bodies, system.workspace.fr[1:], strict=True):
        v, o = f["tw"][:3], f["tw"][3:]
        inertia = f["S"] @ body.inertia @ f["S"].T
        energy += 0.5 * body.mass * v @ v + 0.5 * o @ inertia @ o
        p += body.mass * v
        turn += inertia @ o + body.mass * np.cross(f["r"], v)
    for b in system.records["beam"]:
        w, w1 = b["w"], b["w1"][:5]
        spins = np.array([b["omega"][k] @ w[3 + k] for k in range(2)])
        energy += 0.5 * np.einsum("kl,ki,li->", b["M"], w1, w1) + 0.5 * spins @ b["polar"] @ spins
        p += (b["M"][:2] @ w1).sum(axis=0)
        turn += np.cross(w[:5], b["M"] @ w1).sum(axis=0) + (b["polar"] @ spins) @ w[3:5]
        angle = math.atan2(np.linalg.norm(np.cross(w[3], w[4])), w[3] @ w[4])
        across = (w[3] + w[4]) - (w[3] + w[4]) @ w[2] * w[2]
        y = w[5:7] @ w[2]
        strain += 0.5 * b["axial"] ** 2 / b["k_u"] + 0.5 * b["torque"] ** 2 / b["k_t"]
        strain += 0.5 * b["k_d"] * angle**2 + 0.5 * b["k_s"] * across @ across
        strain += 0.5 * b["c_a"] * y @ y + b["c_b"] * y[0] * y[1]
    return energy + strain, p, turn, strain


def test_tumbling_and_bending_beam():
    """Over almost two revolutions; charts of the attitude start afresh on the way."""
    drift = []
    for h in (2e-4, 1e-4):
        system, state = beam_chain()
        energy, p, turn, _ = beam_energy(system, state)
        run = start(system, state, h, rho_inf=1.0)
        off, strain = [], 0.0
        for _ in range(10):
            run.advance(round(0.1 / h))
            now = run.state()
            found = beam_energy(system, now)
            evaluate.load(system, now)
            off.append(found[0] - energy)
            strain = max(strain, found[3])
            np.testing.assert_allclose(found[1], p, atol=1e-4 * np.linalg.norm(p))
            # polar inertia goes with the chord: the moment of momentum holds to the square of the bends
            np.testing.assert_allclose(found[2], turn, atol=1e-4 * np.linalg.norm(turn))
        drift.append(np.sqrt(np.mean(np.square(off))) / energy)
        assert strain > 0.05 * energy
    assert drift[1] < 5e-5
    assert drift[0] / drift[1] > 3.0  # second order


def test_tumbling_truss():
    body = truss()
    modes = free_modes(body, 6)
    stiffness = (2.0 * math.pi * modes.frequency) ** 2
    hidden, guides = modal_bodies("body", 6, first=2)
    row = flexible_row(mass_invariants(body, modes.shape), stiffness, frame=1, hidden=(2, 3))
    base = Body(motion=FLOATING, inertia=np.zeros((3, 3)), name="frame")
    system = assemble([base, *hidden], {"flexible_body": row, "guide": guides})
    state = system.initial_state()
    state.v = np.random.default_rng(3).normal(size=state.q.size)
    state.v[3:6] = 5.0, 8.0, 3.0
    masses = body.M.diagonal().reshape(-1, 3)[:, 0]
    at = [system.layout.coordinate(f"body.{k // 3 + 1}.eta{k + 1}") for k in range(6)]

    def sums(s):
        evaluate.residual(system, s)
        f = system.workspace.fr[1]
        x = (body.places + (modes.shape @ s.q[at]).reshape(-1, 3)) @ f["S"].T
        own = (modes.shape @ s.v[at]).reshape(-1, 3) @ f["S"].T
        speed = f["tw"][:3] + np.cross(f["tw"][3:], x) + own
        energy = 0.5 * np.sum(masses[:, None] * speed**2) + 0.5 * stiffness @ s.q[at] ** 2
        return energy, np.cross(f["r"] + x, masses[:, None] * speed).sum(axis=0)

    before = sums(state)
    run = start(system, state, 2e-4, rho_inf=1.0)
    run.advance(10_000)
    after = sums(run.state())
    assert after[0] == pytest.approx(before[0], rel=1e-4)  # (omega h)^2 of the modes is 2e-3
    np.testing.assert_allclose(after[1], before[1], atol=1e-4 * np.linalg.norm(before[1]))
