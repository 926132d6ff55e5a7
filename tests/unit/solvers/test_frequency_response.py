# SPDX-License-Identifier: Apache-2.0
"""Frequency response against closed forms: oscillator, absorber, mesh error, unbalance, loop; and a run."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.status import OK
from pitchpoint.elements import gravity, maxwell, spring_damper
from pitchpoint.io.yaml_model import load_model
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import PRISMATIC
from pitchpoint.solvers.frequency_response import find_response, solve_frequency_response
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import assemble
from tests.support.engine import bearings
from tests.support.machines import R_B1, compiled, pair
from tests.support.mechanisms import bar, four_bar

DISC = (
    "bodies:\n  disc: {motion: torsion, inertia: 2.0}\n"
    "bearings:\n  spring: {body: disc, stiffness: {torsion: 800}, damping: {torsion: 4}}\n"
)
HERTZ = np.array([0.0, 0.5, 2.0, 3.1, 3.3, 10.0])


def test_one_freedom():
    found = find_response(compiled(DISC)[1], ["disc.spin"], ["disc.spin", "disc.rz"], HERTZ)
    w = 2.0 * math.pi * HERTZ
    expected = 1.0 / (800.0 - 2.0 * w**2 + 4.0j * w)
    assert found.response[:, 0, 0] == pytest.approx(expected, rel=1e-12)
    assert found.response[:, 1, 0] == pytest.approx(expected, rel=1e-12)
    assert (found.input_units, found.output_units) == (("N m",), ("rad", "rad"))


ABSORBER = (
    "bodies:\n  main: {motion: torsion, inertia: 2.0}\n  absorber: {motion: torsion, inertia: 0.2}\n"
    "bearings:\n  spring: {body: main, stiffness: {torsion: 800}, damping: {torsion: 1}}\n"
    "couplings:\n  link: {bodies: [main, absorber], stiffness: {torsion: 80}, damping: {torsion: 0.5}}\n"
)


def absorber(w):
    """Response of both discs to a torque on the first."""
    found = []
    for s in 1j * np.atleast_1d(w):
        Z = np.array(
            [[2.0 * s**2 + 1.5 * s + 880.0, -0.5 * s - 80.0], [-0.5 * s - 80.0, 0.2 * s**2 + 0.5 * s + 80.0]]
        )
        found.append(np.linalg.solve(Z, [1.0, 0.0]))
    return np.array(found)


def test_absorber_directly_and_by_modes():
    system = compiled(ABSORBER)[1]
    spins = ["main.spin", "absorber.spin"]
    expected = absorber(2.0 * math.pi * HERTZ)
    for modes in (None, 2):
        found = find_response(system, ["main.spin"], spins, HERTZ, modes=modes)
        assert found.response[:, :, 0] == pytest.approx(expected, rel=1e-10)
    # one mode of two: what is left out is the quasi-static share of the second, which falls with its square
    truncated = find_response(system, ["main.spin"], spins, [2.6], modes=1).response[0, 0, 0]
    assert abs(truncated - absorber(2.0 * math.pi * 2.6)[0, 0]) < 0.5 * abs(truncated)


@pytest.mark.parametrize("hertz", [2.0, 3.0])
def test_a_run_settles_to_the_response(hertz):
    """Integrated until the start is forgotten (e^-10): amplitude and phase by correlation over periods."""
    text = ABSORBER + f"loads:\n  shake: {{body: main, torque: '1 N m * sin({2.0 * math.pi * hertz} * t)'}}\n"
    text += "scenarios:\n  go: {duration: 1 s, start: assembled}\n"
    model, system = compiled(text, "go")
    begin = prepare_start(system, model.scenarios["go"])
    per_period = 400
    h = 1.0 / hertz / per_period
    run = generalized_alpha.start(begin.system, begin.state, h, rho_inf=1.0)
    assert run.advance(per_period * math.ceil(40.0 * hertz)).status == OK
    sums = np.zeros(2, complex)
    for _ in range(per_period):
        state = run.state()
        sums += state.q * np.exp(-2j * math.pi * hertz * state.t)
        assert run.advance(1).status == OK
    found = 2j * sums / per_period  # of sin: i e^(-i w t)
    order = [begin.system.spin(b) for b in ("main", "absorber")]
    assert found[order] == pytest.approx(
        absorber(2.0 * math.pi * hertz)[0], rel=2e-3
    )  # (w h)^2/12 at a slope


def test_error_of_the_flanks_of_a_free_pair():
    """Relative motion: m (u'' ) + d (u' - e') + k (u - e) = 0; the mesh force is k (u - e) + d (u' - e')."""
    law = "{law: constant, value: 3.0e8 N/m}, damper: {ratio: 0.05}"
    system = compiled(pair(law))[1]
    reduced = 1.0 / (R_B1**2 / 0.002 + (1.5 * R_B1) ** 2 / 0.01)
    d = 2.0 * 0.05 * math.sqrt(3e8 * reduced)
    hertz = np.array([200.0, 1500.0, 2500.0])
    s = 2j * math.pi * hertz
    found = find_response(
        system,
        ["transmission_error[stage]"],
        ["driver.spin", "driven.spin", "deflection[stage]", "mesh_force[stage]", "transmission_error[stage]"],
        hertz,
    )
    travel = R_B1 * found.response[:, 0, 0] + 1.5 * R_B1 * found.response[:, 1, 0]
    u = (3e8 + d * s) / (reduced * s**2 + d * s + 3e8)
    assert travel == pytest.approx(u, rel=1e-8)
    # differences of channels by 2e-10 m
    assert found.response[:, 2, 0] == pytest.approx(u - 1.0, rel=1e-7)
    assert found.response[:, 3, 0] == pytest.approx((3e8 + d * s) * (u - 1.0), rel=1e-7)
    assert found.response[:, 4, 0] == pytest.approx(u, rel=1e-7)


@pytest.mark.parametrize("axis", ["[0, 0, 1]", "[1, 0, 0]"])
@pytest.mark.parametrize("torque", [2.0, -2.0])
def test_deflection_less_half_the_gap_is_the_mesh_force_over_the_stiffness(torque, axis):
    """A pinion on isotropic springs: its own motion along the line of action opens the gap, too.

    Teeth approach by p = r_b1 phi_1 + r_b2 phi_2 + w - e, w the motion of the pinion along that line:
    p = -e/(1 + k H) with the receptances H = -r_b1^2/(I_1 w^2) - r_b2^2/(I_2 w^2) + 1/(k_b - m w^2).
    """
    k, k_b, mass = 3e8, 5e7, 2.0
    support = "stiffness: {radial: 5e7, axial: 5e7, tilt: 1e6}"
    text = pair("{law: constant, value: 3.0e8 N/m}", torque=f"{torque} N m")
    text = text.replace(
        "[g1], motion: torsion", f"[g1], motion: free, position: [0, 0, 0], axes: {{z: {axis}}}"
    )
    text = text.replace("[g2], motion: torsion", f"[g2], motion: torsion, axes: {{z: {axis}}}")
    text += f"bearings:\n  b: {{body: driver, {support}}}\n"
    outputs = ["deflection[stage]", "backlash[stage]", "mesh_force[stage]"]
    hertz = np.array([100.0, 700.0, 1200.0, 2500.0])
    found = find_response(compiled(text)[1], ["transmission_error[stage]"], outputs, hertz).response[:, :, 0]
    w = 2.0 * math.pi * hertz
    spins = R_B1**2 / 0.002 + (1.5 * R_B1) ** 2 / 0.01
    approach = -1.0 / (1.0 + k * (1.0 / (k_b - mass * w**2) - spins / w**2))
    # rotation of the line of action under the load of 47 N: 47 N/(5e7 N/m)/135 mm
    assert found[:, 2] == pytest.approx(k * approach, rel=2e-4)
    assert found[:, 0] - 0.5 * math.copysign(1.0, torque) * found[:, 1] == pytest.approx(approach, rel=2e-4)
    assert np.abs(found[:, 0] / approach - 1.0).max() > 0.1


def test_deflection_on_elastic_shafts_is_that_of_the_teeth_with_half_the_gap():
    model = load_model(Path(__file__).parents[3] / "examples" / "geared-rotor" / "model.yaml")
    model = model.replace("meshes.stage.damping", None)
    outputs = ["deflection[stage]", "backlash[stage]", "mesh_force[stage]"]
    hertz = np.array([1.0, 100.0, 200.0, 1000.0])
    system = compile_model(model, "fast")
    found = find_response(system, ["transmission_error[stage]"], outputs, hertz, "fast").response[:, :, 0]
    state = evaluate.observe(system, prepare_start(system, model.scenarios["fast"]).state)
    side = math.copysign(1.0, state[system.layout.channel("mesh_force[stage]")])
    teeth = found[:, 2] / 3e8
    assert found[:, 0] - 0.5 * side * found[:, 1] == pytest.approx(teeth, rel=1e-5)
    assert np.abs(found[:, 0] / teeth).max() > 5.0


def test_unbalance_of_a_jeffcott_rotor():
    """Forward whirl at the speed of the rotor: x = U w^2/(k - m w^2 + i w d), y = -i x, no gyroscopics."""
    m, k, d = 3.0, 2e6, 60.0
    body = Body(motion=FREE, mass=m, polar_inertia=0.02, transverse_inertia=0.012, name="disc")
    K, D = np.diag([k, k, 1e7, 1e5, 1e5, 0.0]), np.diag([d, d, 0.0, 0.0, 0.0, 0.0])
    system = assemble([body], {"bearing": bearings([(1, 0, K, D)])})
    hertz = np.array([50.0, 120.0, 200.0])
    w = 2.0 * math.pi * hertz
    found = find_response(system, ["unbalance[disc]"], ["disc.ux", "disc.uy"], hertz, synchronous="disc")
    expected = w**2 / (k - m * w**2 + 1j * w * d)
    assert found.response[:, 0, 0] == pytest.approx(expected, rel=1e-9)
    assert found.response[:, 1, 0] == pytest.approx(-1j * expected, rel=1e-9)


def test_tilting_moment_at_speed_is_gyroscopic():
    """A turning moment m (1, -i) on a spinning disc: theta = m/(k - I_t w^2 + I_p W w)."""
    body = Body(motion=FREE, mass=3.0, polar_inertia=0.02, transverse_inertia=0.012, name="disc")
    K = np.diag([1e8, 1e8, 1e8, 1e4, 1e4, 0.0])
    system = assemble([body], {"bearing": bearings([(1, 0, K, np.zeros((6, 6)))])})
    start = system.initial_state()
    start.v[system.spin("disc")] = 400.0
    hertz = np.array([30.0, 150.0])
    w = 2.0 * math.pi * hertz
    found = find_response(system, ["disc.mx", "disc.my"], ["disc.rx"], hertz, start=start)
    forward = found.response[:, 0, 0] - 1j * found.response[:, 0, 1]
    assert forward == pytest.approx(1.0 / (1e4 - 0.012 * w**2 + 0.02 * 400.0 * w), rel=1e-9)


def test_a_state_of_an_element():
    """Dynamic stiffness of a mass on a spring beside a Maxwell element: k + k_m s/(s + k_m/d) + m s^2."""
    m, k, k_m, d = 2.0, 800.0, 500.0, 40.0
    along_x = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    place = (1.0, 0.0, 0.0)
    bodies = [
        Body(motion=PRISMATIC, axes=along_x, position=place, mass=m, inertia=np.eye(3), name="mass"),
        Body(motion=TORSION, polar_inertia=1.0, name="state", state=True),
    ]
    spring = np.zeros(1, spring_damper.RECORD)
    spring["i"], spring["free"], spring["k"] = 1, 1.0, k
    element = np.zeros(1, maxwell.RECORD)
    element["i"], element["k"], element["stiffness"], element["damping"] = 1, 2, k_m, d
    system = assemble(bodies, {"spring_damper": spring, "maxwell": element})
    found = find_response(system, ["mass.fx"], ["mass.ux"], HERTZ).response[:, 0, 0]
    s = 2j * math.pi * HERTZ
    assert found == pytest.approx(1.0 / (k + k_m * s / (s + k_m / d) + m * s**2), rel=1e-9)


def test_a_loop_moves_as_it_can():
    """A parallelogram of bars under weight: pendulum of mass 1 + 2/3 and weight of two arms and a coupler."""
    points = ((0.0, 0.0), (0.0, -1.0), (1.0, -1.0), (1.0, 0.0))
    bodies = [bar(points[k], points[k + 1], name=n, parent=k) for k, n in enumerate(("a", "b", "c"))]
    weights = gravity.gravity_records(bodies, (0.0, -9.81, 0.0))
    system = four_bar(points, gravity=weights)
    w = 2.0 * math.pi * HERTZ
    found = find_response(system, ["crank.spin"], ["crank.spin", "coupler.spin"], HERTZ).response[:, :, 0]
    expected = 1.0 / (9.81 * (0.5 + 1.0 + 0.5) - w**2 * (1.0 / 3.0 + 1.0 + 1.0 / 3.0))
    assert found[:, 0] == pytest.approx(expected, rel=1e-8)
    assert found[:, 1] == pytest.approx(-expected, rel=1e-8)  # the coupler keeps its attitude


def test_dataset_and_names():
    system = compiled(DISC)[1]
    data = solve_frequency_response(system, ["disc.spin"], ["speed[disc]"], HERTZ)
    assert data["response"].dims == ("frequency", "output", "input")
    w = 2.0 * math.pi * HERTZ
    expected = 1j * w / (800.0 - 2.0 * w**2 + 4.0j * w)
    assert data["response"].values[:, 0, 0] == pytest.approx(expected, rel=1e-6, abs=1e-12)
    with pytest.raises(ModelError, match=r"no input is called 'disk.spin'; did you mean disc.spin"):
        find_response(system, ["disk.spin"], ["disc.spin"], HERTZ)
    with pytest.raises(ModelError, match="no output is called"):
        find_response(system, ["disc.spin"], ["nothing"], HERTZ)
