# SPDX-License-Identifier: Apache-2.0
"""Units for model exchange: derivatives, event indicators, and an integration from outside."""

from __future__ import annotations

import ctypes as ct

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from tests.support.fmi_host import Unit
from tests.support.fmu_models import DRIVEN, PAIR, need_linker, own_run, unit_of

VARYING = "{law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.0}"


@pytest.fixture(scope="module", params=[2, 3])
def unit(request, tmp_path_factory):
    """Unpacked unit."""
    need_linker()
    folder = tmp_path_factory.mktemp("unit")
    return Unit(unit_of("adams", folder, request.param), folder)


def indicators(unit, one):
    """Number of event indicators by the description, and their values."""
    if unit.version == 2:
        n = int(unit.root.get("numberOfEventIndicators"))
    else:
        n = len(unit.root.findall("ModelStructure/EventIndicator"))
    return one.vector("GetEventIndicators", n)


def test_derivatives_are_those_of_the_system(unit):
    """Bit by bit, at the start and at disturbed states."""
    system = own_run("adams").system
    one = unit.instance(exchange=True).initialise()
    w, nd = system.workspace, system.sizes["nd"]
    start = one.vector("GetContinuousStates", 2 * nd)
    np.testing.assert_array_equal(start, np.concatenate([w.q, w.v]))
    for k in range(5):
        x = start + k * 1e-5 * np.array([1.0, -0.7, 30.0, 10.0])
        w.q[:], w.v[:] = x[:nd], x[nd:]
        assert evaluate.accelerations(system, 1e-3 * k) == 1
        np.testing.assert_array_equal(one.slopes(1e-3 * k, x), np.concatenate([w.v, w.a]))
    one.free()


def test_an_indicator_is_positive_in_contact(unit):
    """The sign of the indicator of the front flank is that of contact_state, over the whole backlash."""
    one = unit.instance(exchange=True).initialise()
    x = one.vector("GetContinuousStates", 4)
    state = unit.names("output").index("contact_state[stage]")
    seen = set()
    for change in np.linspace(-3e-3, 1e-3, 41):
        one.slopes(0.0, x + np.array([change, 0.0, 0.0, 0.0]))
        front, back = indicators(unit, one)
        contact = one.get(unit.references("output"))[state]
        assert (front > 0.0) == (contact in (1.0, 2.0)) and (back > 0.0) == (contact in (-1.0, 2.0))
        seen.add(contact)
    assert seen >= {1.0, 0.0, -1.0}
    one.free()


def test_an_integration_from_outside(unit):
    """The classical Runge-Kutta method, programmed here, against that of our own run: round-off."""
    own = own_run("rk4")
    want = own.advance(200, every=200).rows[0, 1:]
    one = unit.instance(exchange=True).initialise()
    x, h = one.vector("GetContinuousStates", 4), own.h
    for k in range(200):
        t = k * h
        a = one.slopes(t, x)
        b = one.slopes(t + h / 2, x + h / 2 * a)
        c = one.slopes(t + h / 2, x + h / 2 * b)
        d = one.slopes(t + h, x + h * c)
        x = x + h / 6 * (a + 2 * b + 2 * c + d)
    one.slopes(200 * h, x)
    got = one.get(unit.references("output"))
    for name in ("deflection[stage]", "mesh_force[stage]", "speed[driver]"):
        k = unit.names("output").index(name)
        assert got[k] == pytest.approx(want[k], rel=1e-9)
    one.free()


@pytest.mark.parametrize("version", [2, 3])
def test_directional_derivatives_are_those_of_the_linearisation(version, tmp_path):
    """-M^-1 (K dq + D dv) with the exact matrices of the package, and the inverse inertia for a load.

    With a constant stiffness, as the matrices have no derivatives by the mesh phase.
    """
    need_linker()
    model = loads_model(PAIR.replace("METHOD", "adams").replace(VARYING, "{law: constant, value: 4e8 N/m}"))
    unit = Unit(unit_of("adams", tmp_path, version, model=model), tmp_path)
    own = own_run("adams", model)
    system, state = own.system, own.state()
    M, D, K = evaluate.linearize(system, state)
    one = unit.instance(exchange=True).initialise()
    names = [f"{word}[{c}]" for word in ("coordinate", "rate") for c in system.layout.coordinates]
    reference = {name: int(v.get("valueReference")) for name, v in unit.variables.items()}
    states = [reference[name] for name in names]
    slopes = [reference[f"der({name})"] for name in names]
    outputs = unit.references("output")
    before = one.get([*states, *slopes, *outputs])
    for seed in ((1.0, 0.0, 0.0, 0.0), (0.2, -0.5, 0.0, 0.0), (0.0, 0.0, 1.0, -1.0), (0.3, 1.0, 10.0, -30.0)):
        dq, dv = np.array(seed[:2]), np.array(seed[2:])
        want = np.concatenate([dv, -np.linalg.solve(M, K @ dq + D @ dv)])
        got = one.directional(slopes, states, seed)
        # the forces of both flanks may cancel: relative to the size of their parts
        parts = np.abs(np.linalg.solve(M, K)) @ np.abs(dq) + np.abs(np.linalg.solve(M, D)) @ np.abs(dv)
        np.testing.assert_allclose(got, want, rtol=0, atol=1e-8 * parts.max())
    load = [reference["loads.input.torque"]]
    np.testing.assert_allclose(
        one.directional(slopes, load, [2.0]), [0, 0, 2.0 / 0.0115, 0], rtol=1e-6, atol=1e-6
    )
    np.testing.assert_array_equal(one.get([*states, *slopes, *outputs]), before)
    one.free()


def test_the_speed_of_a_drive_and_its_derivative_are_inputs(tmp_path):
    """A ramp from outside against a table in our own run; a wrong speed is approached with 400 1/s."""
    need_linker()
    model = loads_model(DRIVEN, False, "driven.yaml")
    unit = Unit(unit_of("driven", tmp_path, 3, model=model), tmp_path)
    one, first, gain, h = unit.instance(exchange=True).initialise(), 1000.0 * np.pi / 30.0, 2000.0, 5e-5
    x = one.vector("GetContinuousStates", 8)

    def slopes(t, x):
        """Derivatives with the inputs of a time."""
        speed = {"drive.motor.speed": first + gain * t, "drive.motor.acceleration": gain}
        assert one.set(speed) == 0
        return one.slopes(t, x)

    for k in range(1000):
        t = k * h
        a = slopes(t, x)
        b = slopes(t + h / 2, x + h / 2 * a)
        c = slopes(t + h / 2, x + h / 2 * b)
        x = x + h / 6 * (a + 2 * b + 2 * c + slopes(t + h, x + h * c))
    slopes(0.05, x)
    got = dict(zip(unit.names("output"), one.get(unit.references("output")), strict=True))
    table = f"{{table: [[0 s, 1000 rpm], [0.1 s, {1000 + 0.1 * gain * 30 / np.pi!r} rpm]]}}"
    other = loads_model(DRIVEN.replace("speed: 1000 rpm", f"speed: {table}"), False, "table.yaml")
    own = own_run("rk4", other.replace("scenarios.steady.method", "rk4"))
    rows = own.advance(1000, every=1000).rows[0, 1:]
    want = {c.name: value for c, value in zip(own.system.layout.channels, rows, strict=True)}
    for name in ("speed[motor]", "speed[drum]", "coupling_force[shaft.mz]", "torque[motor]"):
        assert got[name] == pytest.approx(want[name], rel=1e-7)
    slow = {"drive.motor.speed": want["speed[motor]"] + 1.0, "drive.motor.acceleration": 0.0}
    assert one.set(slow) == 0
    derivative = one.slopes(0.05, x)[4 + own.system.layout.coordinate("motor.spin")]
    assert derivative == pytest.approx(400.0, rel=1e-6)
    one.free()


def test_calls_in_a_wrong_order_are_refused(unit):
    """States, time and modes in the order of the standard; nothing is changed by a refused call."""
    update = "NewDiscreteStates" if unit.version == 2 else "UpdateDiscreteStates"
    slopes = "GetDerivatives" if unit.version == 2 else "GetContinuousStateDerivatives"
    room, bytes_ = np.zeros(4), (ct.c_char * 64)()
    flags = [ct.byref(bytes_, 8 * k) for k in range(1 if unit.version == 2 else 6)]
    vector = (room.ctypes.data_as(ct.POINTER(ct.c_double)), ct.c_size_t(4))
    complete = ("CompletedIntegratorStep", ct.c_bool(True), ct.byref(bytes_), ct.byref(bytes_, 8))
    one = unit.instance(exchange=True)

    def refused(words, *call):
        assert one.call(*call) == 3 and words in unit.messages[-1], unit.messages[-1]

    refused("after the initialisation", "SetTime", ct.c_double(1.0))
    for name in ("GetContinuousStates", slopes):
        refused("begin of the initialisation", name, *vector)
    refused("follows the initialisation", "EnterEventMode")
    one.initialise()
    start = one.vector("GetContinuousStates", 4)
    refused("event mode", "EnterContinuousTimeMode")
    refused("event mode", update, *flags)
    assert one.call(*complete) == 0 and one.call("EnterEventMode") == 0
    assert one.call(update, *flags) == 0
    refused("continuous-time mode", *complete)
    refused("continuous-time mode", "SetContinuousStates", *vector)
    np.testing.assert_array_equal(one.vector("GetContinuousStates", 4), start)
    state = one.keep()
    assert one.call("EnterContinuousTimeMode") == 0 and one.call("SetContinuousStates", *vector) == 0
    assert one.restore(state) == 0  # the mode is part of a state
    refused("continuous-time mode", "SetContinuousStates", *vector)
    one.drop(state)
    assert one.call("Terminate") == 0
    refused("before the termination", "SetTime", ct.c_double(1.0))
    np.testing.assert_array_equal(one.vector("GetContinuousStates", 4), start)
    one.free()
    one = unit.instance().initialise()
    refused("for co-simulation", "EnterContinuousTimeMode")
    refused("for co-simulation", "GetContinuousStates", *vector)
    one.free()


def test_the_kinds_of_instances_are_separate(unit):
    one = unit.instance(exchange=True).initialise()
    assert one.step(0.0, 1e-5) == 3 and "model exchange" in unit.messages[-1]
    with pytest.raises(AssertionError, match="number of states"):
        one.vector("GetContinuousStates", 3)
    one.free()
