# SPDX-License-Identifier: Apache-2.0
"""Reduced systems with bodies that are not round: a housing, what hangs on it, what turns with a gear."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.reduction import reduce
from pitchpoint.solvers.reduction.reduce import reduce_system
from pitchpoint.system import evaluate
from tests.support.gearbox_files import GEARBOX
from tests.support.machines import compiled

SPEED, RADIUS, ARM = 200.0, 0.12, 0.03
PENDULUM = f"""\
gears:
  g1: {{number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
  g2: {{number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  driver:
    {{gears: [g1], MOTION, position: [0, 0, 0], inertia: 0.02 kg m^2, mass: 2 kg,
     transverse_inertia: 0.015 kg m^2, markers: {{pin: {{position: [{1e3 * RADIUS} mm, 0, 0]}}}}}}
  driven: {{gears: [g2], inertia: 0.01 kg m^2}}
  arm:
    {{mass: 0.4 kg, center_of_mass: [{1e3 * ARM} mm, 0, 0], inertia_tensor: [1e-9, 1e-9, 1e-9, 0, 0, 0],
     position: [{1e3 * RADIUS} mm, 0, 0]}}
joints:
  hinge: {{type: revolute, bodies: [driver.pin, arm], axes: {{z: [0, 0, 1]}}}}
meshes:
  stage:
    {{gears: [g1, g2], backlash: {{base_tangent: 0.1 mm}}, damping: {{ratio: 0.02}},
     stiffness: {{law: fourier, mean: 3e8 N/m, cosine: [-0.15]}}}}
loads: {{input: {{body: driver, torque: LOAD N m}}, output: {{body: driven, torque: balance}}}}
scenarios: {{run: {{speed: {{driver: {SPEED} rad/s}}, duration: 10 ms, step: 10 us}}}}
"""
"""A gear pair whose driver carries a centrifugal pendulum without a spring."""


def run(system, state, h, steps, channel="mesh_force[stage]"):
    """A channel every ten steps."""
    o = system.layout.channel(channel)
    machine = generalized_alpha.start(system, state, h)
    found = []
    for _ in range(steps // 10):
        assert machine.advance(10).status == OK
        found.append(evaluate.observe(system, machine.state())[o])
    return np.array(found)


BLADE = """\
bodies:
  hub:
    {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0], markers: {root: {position: [100 mm, 0, 0]}}}
  tip: {mass: 1 g, position: [1100 mm, 0, 0], inertia_tensor: [1e-7, 1e-7, 1e-7, 0, 0, 0]}
joints: {f: {type: free, bodies: [hub, tip], position: [1100 mm, 0, 0]}}
beams: {b: {ends: [hub.root, tip], section: {width: 40 mm, height: 8 mm}, axis: [0, 1, 0], pieces: 4}}
scenarios: {spin: {speed: {hub: 600 rpm}, hold: [hub], duration: 20 ms, step: 20 us}}
"""
"""A blade on a hub that turns: centrifugal forces stiffen it across its plane and soften it within."""


def test_turning_blades_are_compared_at_speed():
    """Both systems have the natural frequencies that the modes of the full one at speed have."""
    _, system = compiled(BLADE, "spin")
    error = reduce_system(system, "spin", limit=50.0).error
    expected = find_modes(system, "spin").frequency
    assert error.full == pytest.approx(expected[: error.full.size], rel=1e-9)
    assert error.full.size == 3
    assert error.coordinates[1] < error.coordinates[0]
    assert error.frequency < 1e-6
    still = find_modes(compiled(BLADE)[1]).frequency
    assert np.abs(still[:3] / error.full - 1.0).max() > 1e-2  # the speed matters here


@pytest.fixture(scope="module")
def housing():
    _, system = compiled(GEARBOX, "run")
    return system, reduce_system(system, "run", limit=2000.0)


def test_a_housing_and_what_hangs_on_it_are_condensed(housing):
    """Seven coordinates become seven modes, as all lie below four times the limit: nothing is lost,
    and damped eigenvalues at speed, with gyroscopic terms, agree up to rounding (1e-10)."""
    system, reduced = housing
    assert reduced.kept == ("driver", "driven")
    assert reduced.notes == ()
    assert reduced.error.coordinates == (19, 19)
    assert reduced.error.frequency < 1e-9
    assert reduced.error.compliance < 1e-9
    assert "bushing" not in reduced.system.records
    one = find_modes(system, "run", mean=False).eigenvalue
    two = find_modes(reduced.system, start=reduced.state, mean=False).eigenvalue
    assert two == pytest.approx(one, rel=1e-8, abs=1e-6)


def test_truncated_modes_of_a_housing_state_their_error(monkeypatch):
    """Fixed modes of the housing between its stiffly held gears lie high, and carry most of its mass: four
    times the limit would leave an error of 0.4 %, so more of them are kept until it is 0.1 % as asked for."""
    _, system = compiled(GEARBOX, "run")
    assert reduce_system(system, "run", limit=100.0).error.frequency < 1e-3
    monkeypatch.setattr(reduce, "BEYOND", (4.0,))
    found = reduce_system(system, "run", limit=100.0)
    assert found.error.coordinates == (19, 16)
    one = find_modes(system, "run", mean=False).frequency[1:5]
    two = find_modes(found.system, start=found.state, mean=False).frequency[1:5]
    assert 2e-3 < found.error.frequency == pytest.approx(np.abs(two / one - 1.0).max(), rel=1e-6)


def test_response_of_the_reduced_gearbox(housing):
    """Mesh force by the transmission error, up to the limit; both linear systems are the same (see above)."""
    system, reduced = housing
    hertz = np.linspace(20.0, 2000.0, 23)
    where = (["transmission_error[stage]"], ["mesh_force[stage]", "driver.x"], hertz)
    one = find_response(system, *where, "run").response
    two = find_response(reduced.system, *where, start=reduced.state).response
    size = np.abs(one).max(axis=0)
    assert np.abs(two - one).max(axis=0) / size == pytest.approx(np.zeros((2, 1)), abs=1e-6)


def test_time_response_of_the_reduced_gearbox(housing):
    """Twenty milliseconds with the mesh parted by a blow: what is condensed is linear, the mesh is not.

    The housing moves by micrometres: what linear parts miss is the square of that over its size, 1e-5 of it.
    """
    _, reduced = housing
    found = []
    for system, state in ((reduced.full, reduced.full_state), (reduced.system, reduced.state)):
        begun = state.copy()
        begun.v[system.spin("driven")] -= 10.0  # the wheel runs away from the pinion
        found.append(run(system, begun, 5e-6, 4000))
    full, less = found
    assert np.mean(full == 0.0) > 0.02
    assert np.abs(less - full).max() < 1e-4 * np.ptp(full)


def test_a_centrifugal_pendulum_is_condensed_at_its_speed():
    """Order of a pendulum: sqrt(R/l); with the driver still, its fixed-interface frequency is that times the
    speed. The mass is a point, its own inertia 1e-9 against m l^2 = 3.6e-4: 3e-6.
    """
    _, system = compiled(PENDULUM.replace("MOTION", "motion: torsion").replace("LOAD", "50"), "run")
    reduced = reduce_system(system, "run", limit=300.0)
    assert reduced.kept == ("driver", "driven")
    assert reduced.notes == ()
    couplings = reduced.system.records["coupling"]
    assert math.sqrt(couplings["k"][0]) == pytest.approx(SPEED * math.sqrt(RADIUS / ARM), rel=1e-5)
    one = find_modes(system, "run", mean=False).eigenvalue
    two = find_modes(reduced.system, start=reduced.state, mean=False).eigenvalue
    assert two == pytest.approx(one, rel=1e-7, abs=1e-3)


def test_a_pendulum_over_time():
    """Small swings for several of its periods with a blow on the driven gear that parts the flanks."""
    _, system = compiled(PENDULUM.replace("MOTION", "motion: torsion").replace("LOAD", "50"), "run")
    reduced = reduce_system(system, "run", limit=300.0)
    found = []
    for own, state in ((reduced.full, reduced.full_state), (reduced.system, reduced.state)):
        begun = state.copy()
        begun.v[own.spin("driven")] -= 0.5
        found.append(run(own, begun, 1e-5, 2000))
    full, less = found
    assert np.ptp(full) > 100.0
    # swings below 0.01 rad: sine and speed differ from what is linear by their squares
    assert np.abs(less - full).max() < 1e-4 * np.ptp(full)


def test_what_changes_with_the_angle_is_kept():
    """The same pendulum on a driver that also moves sideways shakes it once a turn: it stays."""
    text = PENDULUM.replace("MOTION", "motion: free").replace("LOAD", "50")
    text += (
        "bearings:\n  b: {body: driver, stiffness: {radial: 1e8, axial: 1e8, tilt: 1e6}}\n"
        "springs:\n  s: {ends: [driver, arm], stiffness: 1e4 N/m}\n"
    )
    _, system = compiled(text, "run")
    reduced = reduce_system(system, "run", limit=300.0)
    assert "arm" in reduced.kept
    assert any("inertia changes" in note and "arm" in note for note in reduced.notes)


def test_what_nothing_holds_is_kept():
    """At rest nothing holds the pendulum against its driver."""
    text = PENDULUM.replace("MOTION", "motion: torsion").replace("LOAD", "50")
    text = text.replace(f"speed: {{driver: {SPEED} rad/s}}, ", "")
    _, system = compiled(text, "run")
    reduced = reduce_system(system, limit=300.0)
    assert "arm" in reduced.kept
    assert reduced.notes[-1] == "kept because no spring of their part constrains them: arm"
