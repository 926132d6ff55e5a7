# SPDX-License-Identifier: Apache-2.0
"""Eccentric and wobbling gears: tangents, balance, energy, whole turns, no fault."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.invariants.test_tangents import LOSSES, compare, gears, pressed
from tests.support.forces import along
from tests.support.machines import compiled

ONE = {"e": {"type": "eccentricity", "amount": 40e-6, "phase": 0.7}, "w": {"type": "wobble", "amount": 4e-4}}
TWO = {
    "e": {"type": "eccentricity", "amount": 60e-6, "phase": -2.0, "severity": 0.5},
    "w": {"type": "wobble", "amount": 3e-4, "phase": 1.0},
}
CONSTANT = "law: constant, value: 3e8"
PAIR = "law: din3990, stiffness_ratio: 0.7, tip_relief_factor: 0.4"


def machine(kind, beta, motion, losses="", law=CONSTANT, one=ONE, two=TWO):
    """System of a pair whose gears have these faults."""
    model = compiled(gears(kind, beta, motion, losses, law))[0]
    return compile_model(model.replace_all({"gears.g1.faults": one, "gears.g2.faults": two}))


@pytest.mark.parametrize("losses", LOSSES)
@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize(
    ("kind", "beta", "motion"),
    [
        ("external", 0, "free"),
        ("external", 20, "free"),
        ("internal", 20, "free"),
        ("external", 20, "planar"),
        ("internal", 20, "torsion"),
    ],
)
def test_matrices_of_displaced_gears_are_the_whole_derivative(kind, beta, motion, flank, losses):
    system = machine(kind, beta, motion, LOSSES[losses])
    for speed in (0.0, 100.0, -1500.0):
        state = pressed(system, np.random.default_rng(7), speed, flank, 1e-4)
        if speed == 0.0:
            state.v[:] = 0.0
        values = evaluate.observe(system, state)
        assert values[system.layout.channel("contact_state[m]")] == flank
        compare(system, state, 1e-8)


@pytest.mark.nojit
def test_matrices_of_one_displaced_pair_without_the_compiler():
    system = machine("external", 20, "free", LOSSES["damping"])
    compare(system, pressed(system, np.random.default_rng(7), 100.0, 1, 1e-4), 1e-8)


def mesh_wrenches(system, state):
    """Wrenches of the mesh alone on ground and both bodies."""
    evaluate.residual(system, state)
    whole = system.workspace.fr["F"].copy()
    records = system.records["gear_mesh"]
    kept = records.copy()
    for name in ("c_prime", "d_gap"):
        records[name] = 0.0
    for name in ("d_in", "d_out", "mu", "mu_s"):
        records["contact"][name] = 0.0
    evaluate.residual(system, state)
    bare = system.workspace.fr["F"].copy()
    records[:] = kept
    evaluate.residual(system, state)
    return whole - bare


def mesh_powers(system, state):
    """Friction, damping and parametric power of the mesh m, its energy, and the rate of this energy."""

    def told(at):
        values = evaluate.observe(system, at)
        names = ("friction_power", "damping_power", "parametric_power", "elastic_energy")
        return np.array([values[system.layout.channel(f"{name}[m]")] for name in names])

    h = 1e-8
    near, far = (told(along(system, state, s * h))[3] for s in (-1.0, 1.0))
    return (*told(state), (far - near) / (2.0 * h))


def assert_balance(F, fr):
    """Action is reaction: wrenches on bodies 1 and 2 about a common point."""
    moment = sum(F[k, 3:] + np.cross(fr["r"][k], F[k, :3]) for k in (1, 2))
    assert np.abs(F[1, :3] + F[2, :3]).max() < 1e-11 * np.abs(F).max()
    assert np.abs(moment).max() < 1e-11 * np.abs(F).max()


def energy_slopes(system, state, channels):
    """Derivatives of the sum of some channels by all coordinates."""
    slopes = []
    for c in range(state.q.size):
        found = []
        for side in (-1.0, 1.0):
            moved = state.copy()
            moved.q[c] += side * 1e-8
            found.append(evaluate.observe(system, moved)[channels].sum())
        slopes.append((found[1] - found[0]) / 2e-8)
    return np.array(slopes)


@pytest.mark.parametrize("kind", ["external", "internal"])
@pytest.mark.parametrize("law", [CONSTANT, PAIR])
@pytest.mark.parametrize("flank", [1, -1])
def test_balance_and_power_of_displaced_gears(kind, law, flank):
    """Action is reaction, and what the gears do to their bodies is what energy and losses account for."""
    losses = ", damping: {d_in: 2e4, d_out: 2e4}, damper: {value: 1e3}"
    losses += ", friction: {mu: 0.08}" if law == PAIR else ""
    system = machine(kind, 20, "free", losses, law)
    state = pressed(system, np.random.default_rng(5), 300.0, flank, 1e-4)
    friction, damping, parametric, energy, stored = mesh_powers(system, state)
    assert energy > 0.0
    F = mesh_wrenches(system, state)
    fr = system.workspace.fr
    assert_balance(F, fr)
    power = sum(F[k] @ fr["tw"][k] for k in (1, 2))
    scale = abs(parametric) + abs(stored) + friction + damping
    assert -power + parametric == pytest.approx(stored + friction + damping, abs=1e-6 * scale)


@pytest.mark.parametrize("motion", ["torsion", "free"])
@pytest.mark.parametrize("law", [CONSTANT, PAIR])
def test_no_severity_and_whole_turns_change_nothing(motion, law):
    """Gears that only spin leave their short cut for the general path, with next to no fault: 1e-9 of it."""
    none, little = ({k: {**f, "severity": s} for k, f in ONE.items()} for s in (0.0, 1e-12))
    healthy = machine("external", 20, motion, LOSSES["damping"], law, {}, {})
    same = machine("external", 20, motion, LOSSES["damping"], law, none, {})
    assert same.records["gear_mesh"][0] == healthy.records["gear_mesh"][0]
    faulty = machine("external", 20, motion, LOSSES["damping"], law, little, {})
    assert faulty.records["gear_mesh"]["displaced"] == 1
    assert healthy.layout.channels == faulty.layout.channels
    state = pressed(healthy, np.random.default_rng(2), 100.0, 1, 1e-4)
    for a, b in zip(evaluate.linearize(healthy, state), evaluate.linearize(faulty, state), strict=True):
        np.testing.assert_allclose(b, a, atol=1e-9 * np.abs(a).max())
    one, two = evaluate.observe(healthy, state), evaluate.observe(faulty, state)
    np.testing.assert_allclose(two, one, rtol=1e-7, atol=1e-9 * np.abs(one).max())
    system = machine("external", 20, motion, LOSSES["damping"], law)
    before = evaluate.residual(system, state)
    state.turns[1] += 45
    state.turns[2] -= 23
    np.testing.assert_array_equal(evaluate.residual(system, state), before)


@pytest.mark.parametrize("motion", ["torsion", "free"])
@pytest.mark.parametrize("kind", ["external", "internal"])
def test_forces_of_displaced_gears_have_a_potential(kind, motion):
    """At rest a constant stiffness pushes along the slope of its energy, torques of turning gears included.

    What is left is the shared width of tilted gears, by the square of the tilt (see `test_gear_mesh`).
    """
    system = machine(kind, 20, motion)
    state = pressed(system, np.random.default_rng(2), 0.0, 1, 1e-4)
    state.v[:] = 0.0
    force = evaluate.residual(system, state)
    slopes = energy_slopes(system, state, [system.layout.channel("elastic_energy[m]")])
    assert force == pytest.approx(slopes, abs=1e-5 * np.abs(force).max())
