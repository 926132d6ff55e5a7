# SPDX-License-Identifier: Apache-2.0
"""Blade stations on moving bodies: tangents with states, power, and the turned world."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.rotor.station import STATES
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.blade_stations import stations_between
from tests.support.engine import differences

EACH = len(STATES)


def two_bodies(inflow=0, stall=0, motion=FREE, seed=7):
    """System with the stations between a hub and a second body, and a state that is shaken."""
    rng = np.random.default_rng(seed)
    inertia = {"inertia": np.diag([0.1, 0.1, 0.2])} if motion == FLOATING else {}
    bodies = [
        Body(
            motion=motion,
            position=p,
            mass=1.0,
            polar_inertia=0.2,
            transverse_inertia=0.1,
            name=n,
            **inertia,
        )
        for n, p in (("hub", (0.0, 0.0, 0.0)), ("tip", (0.0, 0.0, 0.03)))
    ]
    records, pool = stations_between(rng)
    records["inflow"], records["stall"] = inflow, stall
    if inflow:
        for n, record in enumerate(records):
            for m, name in enumerate(STATES):
                record[name] = len(bodies) + 1
                bodies.append(Body(polar_inertia=1.0, state=True, name=f"{n}.{m}.state"))
    system = assemble(bodies, {"blade_station": records}, pools={"blade_station": pool})
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v = 0.05 * rng.normal(size=n), rng.normal(size=n)
    state.v[system.spin("hub") if motion == FREE else 5] = 8.0
    for k, name in enumerate(system.layout.coordinates):
        if ".state" in name:
            state.v[k] = rng.uniform(0.2, 0.8)
    return system, state


@pytest.mark.parametrize(("inflow", "stall"), [(0, 0), (1, 0), (1, 1)])
@pytest.mark.parametrize("motion", [FREE, FLOATING])
@pytest.mark.parametrize("seed", [7, 8, 9])
def test_exact_tangents_are_derivatives_of_the_force(inflow, stall, motion, seed):
    """Positions, rates and states, to 1e-6 of the largest entry, that of the differences."""
    system, state = two_bodies(inflow, stall, motion, seed)
    _, D, K = evaluate.linearize(system, state)
    for found, key in ((D, "v"), (K, "q")):
        wanted = differences(system, state, key, 1e-6)
        scale = np.abs(wanted).max()
        assert scale > 0.0
        np.testing.assert_allclose(found, wanted, atol=2e-6 * scale)


@pytest.mark.parametrize("inflow", [0, 1])
def test_power_is_that_of_the_wrenches(inflow):
    """The power of the air on the stations is that of the wrenches on both bodies: shape functions of the
    motion and of the forces are the same."""
    system, state = two_bodies(inflow)
    row = evaluate.observe(system, state)
    evaluate.residual(system, state)
    frames = system.workspace.fr[1:3]
    power = sum(float(f["F"] @ f["tw"]) for f in frames)
    inertia = two_bodies(inflow)[0]
    inertia.records["blade_station"]["length"] = 0.0
    evaluate.residual(inertia, state)
    power -= sum(float(f["F"] @ f["tw"]) for f in inertia.workspace.fr[1:3])
    assert row[system.layout.channel("aerodynamic_power[blade_station0]")] == pytest.approx(power, rel=1e-12)
