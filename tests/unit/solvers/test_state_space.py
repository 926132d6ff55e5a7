# SPDX-License-Identifier: Apache-2.0
"""State space against the direct frequency response, damped modes and closed forms."""

from __future__ import annotations

import math
import sys
import types

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.elements import gravity, maxwell, spring_damper
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.state_space import state_space
from pitchpoint.system.system import assemble
from tests.support.machines import R_B1, compiled, pair
from tests.support.mechanisms import bar, four_bar

LAW = "{law: constant, value: 3.0e8 N/m}"
HELICAL = pair(
    LAW + ", damper: {ratio: 0.05}",
    beta="20 deg",
    motion="free",
    rest=(
        "bearings:\n"
        "  front: {body: driver, stiffness: {radial: 2e8, axial: 1e8, tilt: 1e5}, damping: {radial: 500}}\n"
        "  rear: {body: driven, stiffness: {radial: 3e8, axial: 1e8, tilt: 2e5}, damping: {tilt: 4}}\n"
        "scenarios:\n  go: {speed: {driver: 3000 rpm}, duration: 1 s}\n"
    ),
)
HERTZ = np.array([60.0, 300.0, 1500.0, 2500.0, 9000.0])


def response(found, hertz):
    """C (i omega - A)^-1 B + D."""
    unit = np.eye(len(found.A))
    return np.array(
        [found.C @ np.linalg.solve(s * unit - found.A, found.B) + found.D for s in 2j * math.pi * hertz]
    )


def agree(system, inputs, outputs, hertz=HERTZ, **options):
    """Compare with the direct response, relative to the largest of each output and input."""
    found = state_space(system, inputs, outputs, **options)
    expected = find_response(system, inputs, outputs, hertz, **options)
    ours = response(found, hertz)
    size = np.abs(expected.response).max(axis=0)
    worst = np.abs(ours - expected.response).max(axis=0) / np.where(size > 0.0, size, 1.0)
    assert worst.max() < 1e-9, worst
    assert (found.inputs, found.outputs) == (expected.inputs, expected.outputs)
    assert (found.input_units, found.output_units) == (expected.input_units, expected.output_units)
    return found


def test_one_freedom():
    """J s^2 + d s + k: matrices as in a textbook."""
    disc = (
        "bodies:\n  disc: {motion: torsion, inertia: 2.0}\n"
        "bearings:\n  spring: {body: disc, stiffness: {torsion: 800}, damping: {torsion: 4}}\n"
    )
    found = state_space(compiled(disc)[1], ["disc.spin"], ["disc.spin", "disc.rz"])
    assert np.allclose(found.A, [[0.0, 1.0], [-400.0, -2.0]], rtol=1e-12, atol=0.0)
    assert np.allclose(found.B, [[0.0], [0.5]], rtol=1e-12, atol=0.0)
    assert np.array_equal(found.C, [[1.0, 0.0], [1.0, 0.0]])
    assert not found.D.any()
    assert found.states == ("disc.spin", "disc.spin rate")
    assert found.state_units == ("rad", "rad/s")
    assert repr(found) == "<StateSpace: 2 states; inputs disc.spin; outputs disc.spin, disc.rz>"


@pytest.mark.parametrize("damper", ["", ", damper: {ratio: 0.05}"])
def test_spur_pair_and_the_error_of_its_flanks(damper):
    """With a damper the rate of the error acts, too; u = (k + d s)/(m s^2 + d s + k) e."""
    system = compiled(pair(LAW + damper))[1]
    outputs = ["driver.spin", "deflection[stage]", "transmission_error[stage]", "speed[driven]"]
    found = agree(system, ["transmission_error[stage]", "driver.mz"], outputs)
    reduced = 1.0 / (R_B1**2 / 0.002 + (1.5 * R_B1) ** 2 / 0.01)
    d = 2.0 * 0.05 * math.sqrt(3e8 * reduced) if damper else 0.0
    s = 2j * math.pi * HERTZ
    u = (3e8 + d * s) / (reduced * s**2 + d * s + 3e8)
    assert response(found, HERTZ)[:, 1, 0] == pytest.approx(u - 1.0, rel=1e-6)  # differences of channels


def test_the_force_of_a_damper_has_no_state_space():
    inputs, outputs = ["transmission_error[stage]"], ["mesh_force[stage]"]
    agree(compiled(pair(LAW))[1], inputs, outputs)  # without damper k (u - e) has one
    with pytest.raises(SolverError, match=r"rate of the input .* mesh_force\[stage\] of transmission_error"):
        state_space(compiled(pair(LAW + ", damper: {ratio: 0.05}"))[1], inputs, outputs)
    with pytest.raises(SolverError, match=r"unbalance\[driver\] rotates.*driver.fx"):
        state_space(compiled(HELICAL)[1], ["unbalance[driver]"], ["driver.ux"])


def test_geared_rotor_on_bearings_at_speed():
    """Helical gears, free shafts, gyroscopic terms: the response and all damped modes."""
    system = compiled(HELICAL)[1]
    inputs = ["driver.mz", "driven.fx", "transmission_error[stage]"]
    outputs = ["driven.spin", "driver.ux", "bearing_force[front.fx]", "deflection[stage]"]
    found = agree(system, inputs, outputs, scenario="go")
    expected = find_modes(system, "go").eigenvalue
    poles = np.linalg.eigvals(found.A)
    for value in expected[np.abs(expected) > 1.0]:
        assert np.abs(poles - value).min() < 1e-7 * abs(value)
    reduced = agree(system, inputs, outputs, scenario="go", modes=6)
    assert len(reduced.states) == 12
    assert reduced.states[0] == "mode 1"


def test_constraints_are_eliminated():
    """A four-bar has one free coordinate; its joint reactions are outputs."""
    points = ((0.0, 0.0), (0.0, -1.0), (1.0, -1.0), (1.0, 0.0))
    bodies = [bar(points[k], points[k + 1], name=n, parent=k) for k, n in enumerate(("a", "b", "c"))]
    system = four_bar(points, gravity=gravity.gravity_records(bodies, (0.0, -9.81, 0.0)))
    outputs = ["crank.spin", "coupler.spin", "rocker.ux", "reaction_force[pivot x]"]
    found = agree(system, ["crank.spin", "coupler.fx"], outputs, np.array([0.0, 0.2, 1.0, 5.0]))
    assert len(found.states) == 2
    omega = math.sqrt(9.81 * 2.0 / (1.0 + 2.0 / 3.0))  # as in the test of the frequency response
    assert np.abs(np.linalg.eigvals(found.A)) == pytest.approx([omega, omega], rel=1e-7)


def test_states_of_elements_are_states():
    """A mass on a spring beside a Maxwell element has three poles."""
    m, k, k_m, d = 2.0, 800.0, 500.0, 40.0
    along_x = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    bodies = [
        Body(motion=PRISMATIC, axes=along_x, position=(1, 0, 0), mass=m, inertia=np.eye(3), name="mass"),
        Body(motion=TORSION, polar_inertia=1.0, name="state", state=True),
    ]
    spring = np.zeros(1, spring_damper.RECORD)
    spring["i"], spring["free"], spring["k"] = 1, 1.0, k
    element = np.zeros(1, maxwell.RECORD)
    element["i"], element["k"], element["stiffness"], element["damping"] = 1, 2, k_m, d
    system = assemble(bodies, {"spring_damper": spring, "maxwell": element})
    found = agree(system, ["mass.fx"], ["mass.ux"], np.array([0.0, 0.5, 2.0, 3.1, 10.0]))
    expected = np.roots([m, m * k_m / d, k + k_m, k * k_m / d])
    assert np.sort_complex(np.linalg.eigvals(found.A)) == pytest.approx(np.sort_complex(expected), rel=1e-9)


def test_control_library(monkeypatch):
    """The matrices and names reach `control.StateSpace`; a stub takes its place."""
    found = state_space(compiled(pair(LAW))[1], ["driver.mz"], ["driven.spin"])
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(SolverError, match=r"pip install 'pitchpoint\[control\]'"):
        found.to_control()
    stub = types.ModuleType("control")
    stub.StateSpace = lambda *matrices, **names: (matrices, names)
    monkeypatch.setitem(sys.modules, "control", stub)
    matrices, names = found.to_control()
    assert all(one is two for one, two in zip(matrices, (found.A, found.B, found.C, found.D), strict=True))
    assert names == {key: list(getattr(found, key)) for key in ("states", "inputs", "outputs")}


def test_control_library_itself():
    control = pytest.importorskip("control", reason="the extra `control` is not installed")
    found = state_space(compiled(pair(LAW))[1], ["driver.mz"], ["driven.spin"])
    theirs = found.to_control()(2j * math.pi * HERTZ)
    assert np.squeeze(theirs) == pytest.approx(np.squeeze(response(found, HERTZ)), rel=1e-9)
    assert isinstance(found.to_control(), control.StateSpace)
