# SPDX-License-Identifier: Apache-2.0
"""Loads of blades that are extrapolated over several time steps: order, equality with the full run, bits."""

from __future__ import annotations

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.rotors import AERODYN
from tests.unit.elements.test_blade_station import two_bodies

TEXT = """
title: rotor and generator in a gust
bodies:
  hub: {{inertia: 4.37e7 kg m^2, position: [-5 m, 0, 90 m], axes: {{z: [1, 0, 0], x: [0, 0, 1]}}}}
  generator: {{inertia: 5.0255e6 kg m^2, position: [1 m, 0, 90 m], axes: {{z: [1, 0, 0], x: [0, 0, 1]}}}}
torsion_springs:
  shaft: {{bodies: [hub, generator], stiffness: 8.67637e8 N m/rad, damping: 6.215e6 N m s/rad}}
winds:
  gust: {{speed: 8 m/s, height: 90 m, profile: power, exponent: 0.2,
    gust: {{shape: operating_gust, start: 0 s, duration: 2 s, amplitude: 3 m/s}}}}
wind_rotors:
  rotor: {{hub: hub, aerodyn: "{file}", hub_radius: 1.5 m, precone: 2.5 deg,
    tower_position: [5 km, 0], {keys}}}
loads:
  torque: {{body: generator, torque: "-2.1286e6*speed^2"}}
scenarios:
  gust: {{speed: {{hub: 11 rpm}}, duration: 2 s, step: 2.5 ms, method: {method}}}
"""
NAMES = ("rotor_thrust[rotor]", "rotor_torque[rotor]", "speed[hub]")


def model(keys="", method="generalized_alpha"):
    """Rigid rotor and generator, with further keys of the rotor."""
    return loads_model(TEXT.format(file=AERODYN, keys=keys, method=method))


def run(keys="", method="generalized_alpha"):
    """Time response."""
    return solve_time(compile_model(model(keys, method), "gust"))


@pytest.mark.nojit
@pytest.mark.parametrize(("inflow", "stall"), [(0, 0), (1, 1)])
def test_error_is_of_second_order_in_the_change_of_the_state(inflow, stall):
    """Half the distance from the origin, a quarter of the error; at the origin the loads are exact."""
    system, state = two_bodies(inflow, stall)
    records, control = system.records["blade_station"], system.workspace.ctl[0]
    rng = np.random.default_rng(3)
    q, v = state.q.copy(), state.v.copy()
    by_q, by_v = rng.normal(size=(2, len(q)))
    errors = []
    for share in (0.0, 1e-5, 0.5e-5):
        found = []
        for held in (1, 0):
            state.q, state.v = q, v
            records["hold"], records["since"], control["held"] = 1.0, np.nan, held
            evaluate.residual(system, state)
            state.q, state.v = q + share * by_q, v + share * by_v
            found.append(evaluate.residual(system, state).copy())
        control["held"] = 0
        errors.append(np.abs(found[0] - found[1]).max() / np.abs(found[1]).max())
    assert errors[0] == 0.0
    assert 0.0 < errors[1] < 1e-5
    assert errors[2] == pytest.approx(0.25 * errors[1], rel=0.1)


@pytest.fixture(scope="module")
def full():
    """Run with the balance of momentum at every evaluation."""
    return run()


@pytest.mark.parametrize("method", ["generalized_alpha", "adams", "rk4"])
def test_gust_with_extrapolated_loads(full, method):
    """Thrust, torque and speed against the full run, by the rms of the difference, in all fixed steps.

    The oldest loads in steps of 2.5 ms are 17.5 ms old with 20 ms, 7.5 ms with 10 ms: the errors of second
    order have the ratio (7.5/17.5)^2 = 0.18.
    """
    plain = full if method == "generalized_alpha" else run(method=method)
    errors = []
    for time in (20, 10):
        held = run(f"step: {time} ms", method)
        found = [held[name] - plain[name] for name in NAMES]
        errors.append(
            [float(np.sqrt((e**2).mean() / plain[n].max() ** 2)) for n, e in zip(NAMES, found, strict=True)]
        )
        power = held["rotor_torque[rotor]"] * held["speed[hub]"]
        rounding = 1e-6 if method == "adams" else 1e-12  # Adams observes with predicted rates
        np.testing.assert_allclose(held["aerodynamic_power[rotor]"], power, rtol=rounding)
    assert max(errors[0]) < 2e-4
    assert np.array(errors[1]) / np.array(errors[0]) == pytest.approx(0.18, abs=0.06)


def test_saved_and_restored_states_continue_with_the_same_bits():
    """The origin of the extrapolation is part of a saved state."""
    stepper = pp.Stepper(model("step: 20 ms, inflow: dynamic, stall: dynamic"), "gust")
    stepper.advance(0.05)
    saved = stepper.save()
    stepper.advance(0.1)
    first = stepper.outputs()
    stepper.restore(saved)
    stepper.advance(0.1)
    assert stepper.outputs() == first


def test_second_run_of_a_system_has_the_same_bits():
    """A run starts without an origin, whatever was computed before."""
    system = compile_model(model("step: 20 ms"), "gust")
    one, other = solve_time(system), solve_time(system)
    assert np.array_equal(one["rotor_torque[rotor]"], other["rotor_torque[rotor]"])


def test_methods_with_variable_steps_are_refused():
    with pytest.raises(ModelError, match=r"wind_rotors.rotor.step .*dassl is the method of scenario gust"):
        model("step: 20 ms", "dassl")
