# SPDX-License-Identifier: Apache-2.0
"""Planets on nodes of an elastic carrier: tangents, whole turns, energy and moment of momentum."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.body_shapes import base_momenta
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.invariants.test_tangents import compare
from tests.support.elastic_carriers import files, models, two_wall_carrier

MESH = "stiffness: {law: constant, value: 5e8 N/m}, backlash: {normal: 20 um}"
BEARING = "bearing: {stiffness: {radial: 8e8 N/m, axial: 2e8 N/m, tilt: 1e6 N m/rad}}"
SOFT = (
    "stiffness: {law: constant, value: 1e6 N/m}, backlash: {normal: 2 mm}, damping: {d_in: 200, d_out: 200}"
)


def begin(model):
    """System and state at the start of the scenario steady."""
    found = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    return found.system, found.state


@pytest.mark.parametrize("motion", ["torsion", "planar", "free"])
def test_matrices_are_the_whole_derivative(tmp_path, motion):
    """In motion and deflected, with a pin error: against differences to 1e-8.

    Soft teeth: of tilted ones the derivative by the axial shift is not exact, in proportion to their
    stiffness. Few modes, so that the highest does not hide what the forces add.
    """
    more = f"planets: 3\nmotion: {motion}\npin_errors: {{planet_1: {{tangential: 5 um}}}}\n"
    more += "" if motion == "torsion" else BEARING
    few = {"modes": 6, "static_shapes": "false"}
    _, model = models(tmp_path, two_wall_carrier(), more, mesh=SOFT, torque=60.0, **few)
    system, state = begin(model)
    rng = np.random.default_rng(3)
    state.v += rng.normal(scale=1e-3, size=state.v.size)
    state.a = rng.normal(scale=1.0, size=state.v.size)
    compare(system, state, 1e-8)


def test_whole_turns_change_nothing(tmp_path):
    """Multiples of whole turns of the set, for 10^9 revolutions of the carrier; planets turn against it."""
    _, model = models(tmp_path, two_wall_carrier(), "planets: 3\nmotion: torsion", modes=24, mesh=MESH)
    system, state = begin(model)
    found = evaluate.residual(system, state).copy()
    turns = 7 * 13 * 10**9
    wanted = {"carrier": turns, "sun": turns * 120 // 21}
    wanted |= {f"planet_{k}": -turns * 99 // 39 for k in (1, 2, 3)}
    for name, number in wanted.items():
        state.turns[system.layout.bodies.index(name)] += number
    np.testing.assert_array_equal(evaluate.residual(system, state), found)


def test_a_free_set_keeps_energy_and_moment_of_momentum(tmp_path):
    """Sun, ring, planets and elastic carrier without losses and loads rattle for 0.4 ms."""
    text = files(
        tmp_path, two_wall_carrier(), "planets: 3\nmotion: torsion", modes=24, mesh=MESH, torque=0.0
    )[1]
    file = tmp_path / "free.yaml"
    file.write_text(text.replace("motion: fixed", "motion: torsion, inertia: 0.3 kg m^2"), encoding="utf-8")
    model = load_model(file)
    system, state = begin(model)
    place = system.layout.coordinate
    state.v[place("ring.spin")] += 3.0
    state.v[place("carrier.x")] += 0.05
    state.v[[place(f"carrier.{k // 3 + 1}.eta{k + 1}") for k in range(8)]] += 0.05
    stored = [k for k, c in enumerate(system.layout.channels) if "energy" in c.name]
    held = [f"bearing_force[{at}.f{d}]" for at in ("at_out", "at_in") for d in "xyz"]
    held = [system.layout.channel(name) for name in held]
    watch = begin(model)[0]  # a run shares the arrays of its system
    total, moment, touched, strain = [], [], set(), 0.0
    run = runge_kutta.start_adaptive(system, state, rtol=1e-10, atol=1e-14, atol_rate=1e-10)
    for t in np.linspace(2e-5, 4e-4, 20):
        assert run.advance_to(t).status == 1
        state = run.state()
        row = evaluate.observe(watch, state)
        M = evaluate.matrix(watch, state, 1.0, 0.0, 0.0)
        total.append(0.5 * state.v @ M @ state.v + row[stored].sum() + 0.5 * (row[held] ** 2).sum() / 2e9)
        moment.append(base_momenta(watch, state, state.v[None])[0, 5])
        strain = max(strain, float(row[system.layout.channel("strain_energy[carrier]")]))
        touched.add(float(row[system.layout.channel("contact_state[sun-planet_1]")]))
    assert len(touched) > 1
    assert np.ptp(total) < 1e-5 * strain
    assert np.ptp(moment) < 1e-9 * abs(moment[0])
