# SPDX-License-Identifier: Apache-2.0
"""Meshes on flexible rims: tangents, balance, power, potential, limit of a rigid rim, whole turns."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.invariants.test_eccentric_meshes import (
    CONSTANT,
    ONE,
    PAIR,
    TWO,
    assert_balance,
    energy_slopes,
    mesh_powers,
    mesh_wrenches,
)
from tests.invariants.test_tangents import LOSSES, compare, gears, pressed, shaken
from tests.support.machines import compiled

RIM = {
    "gears.g2.bore_diameter": "246 mm",
    "gears.g2.flexible_rim": {"waves": 4, "damping_ratio": 0.02},
}


def machine(beta, motion, losses="", law=CONSTANT, **changes):
    """System of an internal pair whose ring has a flexible rim."""
    model = compiled(gears("internal", beta, motion, losses, law))[0]
    return compile_model(model.replace_all({**RIM, **changes}))


@pytest.mark.parametrize("losses", LOSSES)
@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize(("beta", "motion"), [(0, "free"), (20, "free"), (20, "planar"), (20, "torsion")])
def test_matrices_are_the_whole_derivative(beta, motion, flank, losses):
    system = machine(beta, motion, LOSSES[losses])
    for speed in (0.0, 100.0, -1500.0):
        state = pressed(system, np.random.default_rng(7), speed, flank, 1e-4)
        if speed == 0.0:
            state.v[:] = 0.0
        values = evaluate.observe(system, state)
        assert values[system.layout.channel("contact_state[m]")] == flank
        compare(system, state, 1e-8)


@pytest.mark.parametrize("motion", ["free", "torsion"])
def test_matrices_with_eccentric_gears(motion):
    faults = {"gears.g1.faults": ONE, "gears.g2.faults": TWO}
    for losses in ("elastic", "damping"):
        system = machine(20, motion, LOSSES[losses], **faults)
        compare(system, pressed(system, np.random.default_rng(7), 100.0, 1, 1e-4), 1e-8)


@pytest.mark.nojit
def test_matrices_without_the_compiler():
    system = machine(20, "free", LOSSES["damping"])
    compare(system, pressed(system, np.random.default_rng(7), 100.0, 1, 1e-4), 1e-8)


@pytest.mark.parametrize("law", [CONSTANT, PAIR])
@pytest.mark.parametrize("flank", [1, -1])
def test_balance_and_power(law, flank):
    """Action is reaction, and the power on bodies and modal coordinates is that of energy and losses."""
    losses = ", damping: {d_in: 2e4, d_out: 2e4}, damper: {value: 1e3}"
    losses += ", friction: {mu: 0.08}" if law == PAIR else ""
    system = machine(20, "free", losses, law)
    state = pressed(system, np.random.default_rng(5), 300.0, flank, 1e-4)
    friction, damping, parametric, energy, stored = mesh_powers(system, state)
    assert energy > 0.0
    F = mesh_wrenches(system, state)
    fr = system.workspace.fr
    assert_balance(F, fr)
    power = sum(F[k] @ fr["tw"][k] for k in range(1, len(F)))
    assert abs(sum(F[k] @ fr["tw"][k] for k in range(3, len(F)))) > 1e-3 * abs(friction + damping)
    scale = abs(parametric) + abs(stored) + friction + damping
    assert -power + parametric == pytest.approx(stored + friction + damping, abs=1e-6 * scale)


@pytest.mark.parametrize("motion", ["torsion", "free"])
def test_forces_have_a_potential(motion):
    """At rest the forces on bodies and coordinates are the slope of the energy of mesh and rim."""
    system = machine(20, motion)
    state = pressed(system, np.random.default_rng(2), 0.0, 1, 1e-4)
    state.v[:] = 0.0
    force = evaluate.residual(system, state)
    energy = [system.layout.channel(n) for n in ("elastic_energy[m]", "strain_energy[g2.rim]")]
    assert force == pytest.approx(energy_slopes(system, state, energy), abs=1e-5 * np.abs(force).max())


@pytest.mark.parametrize("motion", ["torsion", "free"])
def test_undeformed_rim_is_rigid_and_whole_turns_change_nothing(motion):
    model = compiled(gears("internal", 20, motion, LOSSES["damping"], PAIR))[0]
    rigid, system = compile_model(model), machine(20, motion, LOSSES["damping"], PAIR)
    small = pressed(rigid, np.random.default_rng(2), 100.0, 1, 1e-4)
    state = system.initial_state()
    for k, name in enumerate(rigid.layout.coordinates):
        at = system.layout.coordinate(name)
        state.q[at], state.v[at] = small.q[k], small.v[k]
    one, two = evaluate.observe(rigid, small), evaluate.observe(system, state)
    for name in ("mesh_force[m]", "transmission_error[m]", "axial_force[m]", "mesh_phase[m]"):
        known = one[rigid.layout.channel(name)]
        assert two[system.layout.channel(name)] == pytest.approx(known, rel=1e-12), name
    before = evaluate.residual(system, state)
    state.turns[1] += 70
    state.turns[2] += 23
    np.testing.assert_array_equal(evaluate.residual(system, state), before)


SUPPORTS = {
    "waves": 4,
    "damping_ratio": 0.02,
    "supports": {"angles": ["20 deg", "130 deg", "250 deg"], "radial": 4e7, "tangential": 2e8},
}


@pytest.mark.parametrize("motion", ["free", "planar", "fixed"])
def test_supports_are_the_slope_of_their_energy(motion):
    """At rest, for displaced, tilted and deflected rims; matrices are the whole derivative at any speed."""
    system = machine(20, motion, **{"gears.g2.flexible_rim": SUPPORTS})
    rng = np.random.default_rng(4)
    state = shaken(system, rng, 0.0, 1e-3, 1e-5)
    state.v[:] = 0.0
    force = evaluate.residual(system, state)
    energy = [c for c, found in enumerate(system.layout.channels) if "energy" in found.name]
    assert len(energy) == 3
    assert force == pytest.approx(energy_slopes(system, state, energy), abs=1e-6 * np.abs(force).max())
    compare(system, shaken(system, rng, 3.0, 1e-3, 1e-5), 1e-8)


@pytest.mark.nojit
def test_supports_without_the_compiler():
    system = machine(20, "free", **{"gears.g2.flexible_rim": SUPPORTS})
    compare(system, shaken(system, np.random.default_rng(4), 3.0, 1e-3, 1e-5), 1e-8)


def test_energy_of_a_planet_in_a_ring_is_kept():
    """A planet on a spring rattles in a ring that bends, without losses: 1e-6 of its energy for 2 ms.

    The ring is at rest: in a spinning one the reaction of the hoop force is neglected (decision 0015).
    """
    system = machine(0, "fixed", **{"gears.g2.flexible_rim": {"waves": 3}})
    state = system.initial_state()
    start = {"a.spin": 25.0, "a.x": 0.02, "a.y": -0.05}
    for name, speed in start.items():
        state.v[system.layout.coordinate(name)] = speed
    stored = [c for c, found in enumerate(system.layout.channels) if "energy" in found.name]
    rim_energy = system.layout.channel("strain_energy[g2.rim]")
    total, touched, most = [], set(), 0.0
    run = runge_kutta.start_adaptive(system, state, rtol=1e-10, atol=1e-15, atol_rate=1e-11)
    for t in np.linspace(5e-5, 2e-3, 40):
        assert run.advance_to(t).status == 1
        state = run.state()
        row = evaluate.observe(system, state)
        M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
        total.append(0.5 * state.v @ M @ state.v + row[stored].sum())
        most = max(most, float(row[rim_energy]))
        touched.add(float(row[system.layout.channel("contact_state[m]")]))
    assert touched == {1.0, 0.0, -1.0}
    assert most > 0.01 * total[0]
    assert np.ptp(total) < 1e-6 * total[0]
