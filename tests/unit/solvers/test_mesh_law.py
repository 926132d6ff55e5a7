# SPDX-License-Identifier: Apache-2.0
"""Mesh forces of linear systems by momentum: torque on a free gear over its base radius."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.mesh_response import find_mesh_response
from pitchpoint.solvers.state_space import state_space
from pitchpoint.system.compile import compile_model
from tests.support.contact_trains import planets

LAWS = {
    "law": "stiffness: {law: din3990, tip_relief_factor: 0.2}, damper: {ratio: 0.05}",
    "level": "contact: {level: rigid, planes: 5}, damper: {ratio: 0.05}",
    "normal damping": "stiffness: {law: din3990}, damping: {ratio: 0.05}",
}
INERTIA = (1e-3, 6e-3)
BASE = math.radians(20.0)


def text(law: str, *, helix: float = 0.0, torque: float = 50.0, motion: str = "torsion") -> str:
    """Spur or helical pair 25/40, 2 mm."""
    hands = [f", helix_angle: {helix} deg, hand: {hand}" if helix else "" for hand in ("right", "left")]
    size = "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    distance = 65.05 / math.cos(math.radians(helix))
    bodies = [
        f"  {b}: {{gears: [{g}], motion: {motion}, inertia: {J} kg m^2, mass: 2 kg, "
        f"transverse_inertia: {0.6 * J}}}"
        for b, g, J in zip("ab", "pw", INERTIA, strict=True)
    ]
    support = "stiffness: {radial: 2e8, axial: 2e8, tilt: 1e5}"
    bearings = [f"  {b}: {{body: {b}, {support}}}" for b in "ab"]
    return "\n".join(
        [
            "gears:",
            f"  p: {{number_of_teeth: 25, {size}{hands[0]}}}",
            f"  w: {{number_of_teeth: 40, {size}{hands[1]}}}",
            "bodies:",
            *bodies,
            *(["bearings:", *bearings] if motion != "torsion" else []),
            f"meshes:\n  st: {{gears: [p, w], center_distance: {distance} mm, {law}}}",
            f"loads:\n  i: {{body: a, torque: {torque} N m}}\n  o: {{body: b, torque: balance}}",
            "scenarios:\n  steady: {speed: {a: 1200 rpm}, duration: 0.1 s}\n",
        ]
    )


def radii(helix: float) -> tuple[float, float]:
    """Base radii [m] of 25 and 40 teeth."""
    tilt = math.radians(helix)
    pressure = math.atan(math.tan(BASE) / math.cos(tilt))
    return tuple(0.5 * z * 2e-3 / math.cos(tilt) * math.cos(pressure) for z in (25, 40))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("helix", "torque"), [(0.0, 50.0), (0.0, -50.0), (20.0, 50.0)])
def test_two_inertias_in_mesh(law: str, helix: float, torque: float):
    """m u'' + d (u' - e') + k (u - e) = 0: the force is -m u'' and J_1 alpha_1/r_b1."""
    system = compile_model(loads_model(text(LAWS[law], helix=helix, torque=torque)), "steady")
    one, two = radii(helix)
    mass = 1.0 / (one**2 / INERTIA[0] + two**2 / INERTIA[1])
    linear = linearise(system, "steady")
    k, d = (A[0, 0] / one**2 for A in (linear.at_rest.K, linear.at_rest.D))
    resonance = math.sqrt(k / mass) / (2.0 * math.pi)
    hertz = resonance * np.array([1e-4, 1e-2, 0.1, 0.3, 0.7, 1.0, 1.7, 3.0])
    outputs = ["mesh_force[st]", "a.spin", "transmission_error[st]", "normal_force[st]", "deflection[st]"]
    found = find_response(system, ["transmission_error[st]"], outputs, hertz, "steady").response[:, :, 0]
    s = 2j * math.pi * hertz
    u = (k + d * s) / (mass * s**2 + d * s + k)
    force = -mass * s**2 * u
    assert found[:, 0] == pytest.approx(force, rel=1e-6)
    assert -INERTIA[0] * s**2 * found[:, 1] / one == pytest.approx(found[:, 0], rel=1e-6)
    assert found[:, 2] == pytest.approx(u, rel=1e-6)
    assert found[:, 4] == pytest.approx(-mass * s**2 / (k + d * s) * u, rel=1e-6)
    if law != "normal damping":  # a parallel damper is no part of the contact force
        tilt = math.atan(math.tan(math.radians(helix)) * one / (25e-3 / math.cos(math.radians(helix))))
        normal = math.copysign(k / math.cos(tilt), torque)
        assert found[:, 3] == pytest.approx(normal * found[:, 4], rel=1e-6)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("helix", [0.0, 20.0])
@pytest.mark.parametrize("motion", ["planar", "free"])
def test_free_gears_on_bearings(law: str, helix: float, motion: str):
    """The torque on each gear is its moment of inertia times its acceleration, however the shafts yield.

    At high frequencies free gears tilt, which couples with their rotation under load.
    """
    system = compile_model(loads_model(text(LAWS[law], helix=helix, motion=motion)), "steady")
    outputs = ["mesh_force[st]", "a.spin", "b.spin"]
    rounding = 1e-14 * 4e8
    hertz = np.array([0.1, 1.0, 10.0, 100.0, *([400.0, 1500.0] if motion == "planar" else [])])
    found = find_response(system, ["transmission_error[st]"], outputs, hertz, "steady").response[:, :, 0]
    torque = -np.outer((2.0 * math.pi * hertz) ** 2, INERTIA) * found[:, 1:3]
    for gear, radius in enumerate(radii(helix)):
        assert -torque[:, gear] / radius == pytest.approx(found[:, 0], rel=1e-6, abs=rounding)


@pytest.mark.parametrize("law", LAWS)
def test_at_other_speeds_than_those_of_the_scenario(law: str):
    """Dampers turn with the line of action: this has no torque about the axis of a gear."""
    system = compile_model(loads_model(text(LAWS[law], motion="planar")), "steady")
    speeds = np.array([60.0, 300.0, 4000.0]) * math.pi / 30.0
    found = find_mesh_response(system, ["mesh_force[st]", "a.spin"], "a", speeds, "steady", harmonics=1)
    omega, force = 2.0 * math.pi * found.frequency[:, 0], found.response[:, 0, 0]
    one = radii(0.0)[0]
    assert INERTIA[0] * omega**2 * found.response[:, 0, 1] / one == pytest.approx(force, rel=1e-6)


def test_by_mesh_order_and_in_state_space():
    """The published case: 1.167 N at the first order at 240 rpm."""
    system = compile_model(loads_model(text(LAWS["law"])), "steady")
    speeds = np.array([2.4, 240.0, 600.0]) * math.pi / 30.0
    names = ["mesh_force[st]", "transmission_error[st]"]
    found = find_mesh_response(system, names, "a", speeds, "steady", harmonics=2)
    one, two = radii(0.0)
    mass = 1.0 / (one**2 / INERTIA[0] + two**2 / INERTIA[1])
    omega = 2.0 * math.pi * found.frequency
    assert found.response[:, :, 0] == pytest.approx(mass * omega**2 * found.response[:, :, 1], rel=1e-6)
    assert abs(found.response[1, 0, 0]) == pytest.approx(1.167, abs=2e-3)
    bare = compile_model(loads_model(text("stiffness: {law: din3990, tip_relief_factor: 0.2}")), "steady")
    ports = (["transmission_error[st]"], ["mesh_force[st]"])
    space = state_space(bare, *ports, "steady")
    hertz = np.array([5.0, 50.0, 200.0])
    wanted = find_response(bare, *ports, hertz, "steady").response[:, 0, 0]
    s = 2j * math.pi * hertz
    reached = [
        (space.C @ np.linalg.solve(x * np.eye(len(space.A)) - space.A, space.B) + space.D)[0, 0] for x in s
    ]
    # a difference of k e and k u in the matrices C and D: rounding is relative to the stiffness
    assert np.array(reached) == pytest.approx(wanted, rel=1e-6)


def test_planetary_set():
    """The mesh forces on the sun are its moment of inertia times its acceleration, at all frequencies."""
    system = compile_model(loads_model(planets()))
    meshes = [f"s{k}" for k in range(3)]
    inputs = [f"transmission_error[{m}]" for m in (*meshes, "r1")]
    hertz = np.array([0.1, 10.0, 300.0, 900.0])
    found = find_response(system, inputs, [*(f"mesh_force[{m}]" for m in meshes), "sun.spin"], hertz).response
    sun = system.layout.coordinate("sun.spin")
    inertia = linearise(system).at_rest.M[sun, sun]
    base = 0.5 * 21 * 3e-3 * math.cos(BASE)
    torque = -inertia * (2.0 * math.pi * hertz[:, None]) ** 2 * found[:, 3]
    total = -base * found[:, :3].sum(axis=1)
    assert torque == pytest.approx(total, rel=1e-6, abs=1e-10 * base * np.abs(found[:, :3]).max())
