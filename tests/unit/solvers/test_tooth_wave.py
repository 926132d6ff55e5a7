# SPDX-License-Identifier: Apache-2.0
"""Shuttling forces of helical teeth: closed form of the contact lines, slow rolls, and time responses."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.mesh_law import mesh_law
from pitchpoint.solvers.mesh_response import find_mesh_response
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

RPM = math.pi / 30.0
LEVER = 60e-3
TORQUE = 200.0


def pair(
    beta: float = 12.0,
    *,
    internal: bool = False,
    speed: float = 300.0,
    torque: float = TORQUE,
    law: str = "{law: din3990}",
    stiffness: float = 2e8,
    axes: str = "{x: [1, 0, 0], z: [0, 0, 1]}",
    run: str = "duration: 1 s",
) -> str:
    """Helical pair on two bearings per shaft, 60 mm on both sides of the gears; `beta` < 0: left hand."""
    tooth = (
        f"normal_module: 3 mm, helix_angle: {abs(beta)} deg, face_width: 30 mm, profile_shift_coefficient: 0"
    )
    hand, other = ("right", "left") if beta > 0.0 else ("left", "right")
    wheel = f"type: internal, number_of_teeth: 75, hand: {hand}" if internal else "number_of_teeth: 50"
    wheel += "" if internal else f", hand: {other}"
    bearings = "".join(
        f"""
  {body}_{n}:
    body: {body}
    position: [0, 0, {place}]
    stiffness: {{radial: {stiffness}, axial: {0.5 * stiffness}}}
    damping: {{radial: 3000, axial: 1000}}"""
        for body in ("in", "out")
        for n, place in ((1, -LEVER), (2, LEVER))
    )
    return f"""\
gears:
  a: {{number_of_teeth: 25, hand: {hand}, {tooth}}}
  b: {{{wheel}, {tooth}}}
bodies:
  in: {{gears: [a], motion: free, position: [0, 0, 0], axes: {axes}, mass: 3, inertia: 3e-3,
    transverse_inertia: 0.01}}
  out: {{gears: [b], motion: free, axes: {axes}, mass: 8, inertia: 0.03, transverse_inertia: 0.04}}
bearings:{bearings}
meshes:
  m: {{gears: [a, b], stiffness: {law}, damping: {{ratio: 0.05}}, backlash: {{normal: 80 um}}}}
loads: {{drive: {{body: in, torque: {torque} N m}}, brake: {{body: out, torque: balance}}}}
scenarios: {{s: {{speed: {{in: {speed} rpm}}, {run}}}}}
"""


UNIFORM = "{law: din3990, stiffness_ratio: 1}"
RIGID = 2e10


@pytest.mark.parametrize(
    "text",
    [
        pair(12.0, law=UNIFORM, stiffness=RIGID),
        pair(-20.0, law=UNIFORM, stiffness=RIGID),
        pair(12.0, internal=True, law=UNIFORM, stiffness=RIGID),
    ],
    ids=["external", "left hand", "internal"],
)
def test_moment_of_uniformly_stiff_contact_lines(text: str) -> None:
    """Uniform force per length of contact line: its centre (x, z) in the plane of action is theirs.

    The force has the components F along the base tangent and F tan(beta_b) along the axis, so that the
    moment across both is F (z + x tan(beta_b)): 12.5 N m at the first harmonic of the pair with 12 degrees.
    The lines are sampled in 8001 sections, 2e-4; bearings of 2e10 N/m let the flanks tilt, which takes 1e-4
    of the moment.
    """
    model = loads_model(text)
    geometry = model.pairs["m"]
    z = np.linspace(-15e-3, 15e-3, 8001)
    slope = math.tan(geometry.gear1.beta_b)
    centre = []
    for phase in np.arange(256) / 256:
        x = (phase + np.arange(-8, 9))[:, None] * geometry.p_et + slope * z
        touches = (x >= 0.0) & (x <= geometry.g_alpha)
        arm = z + slope * (x - 0.5 * geometry.g_alpha)
        centre.append((arm * touches).sum() / touches.sum())
    force = TORQUE / (0.5 * geometry.gear1.d_b)
    wanted = force * 2.0 * np.abs(np.fft.rfft(centre)[1:4]) / 256
    system = compile_model(model, "s")
    linear = linearise(system, "s")
    shuttling = mesh_law(linear.system, linear.at_rest, 0).excitation(3)[1]
    for body in ("in", "out"):
        tilts = [linear.system.layout.coordinate(f"{body}.{word}") for word in ("alpha", "beta")]
        assert np.linalg.norm(shuttling[:, tilts], axis=1) == pytest.approx(wanted, rel=2e-3)


OUTPUTS = [
    f"bearing_force[{b}_{n}.{f}]" for b in ("in", "out") for n in (1, 2) for f in ("fx", "fy", "axial")
]
MACHINES = {
    "external": pair(),
    "left hand": pair(-20.0),
    "internal": pair(internal=True),
    "backwards": pair(speed=-300.0),
    "back flank": pair(torque=-TORQUE),
    "internal, back flank, backwards": pair(15.0, internal=True, torque=-TORQUE, speed=-300.0),
    "along x": pair(axes="{x: [0, 1, 0], z: [1, 0, 0]}"),
}


@pytest.mark.parametrize("name", MACHINES)
def test_at_vanishing_speed_bearing_forces_are_those_of_the_slow_roll(name: str) -> None:
    """Sizes and phases of the first two orders, within 0.5 % and 2 % of the largest force.

    Between two kinks of the mesh cycle the excitation is taken as a parabola; products of the varying
    stiffness and the tilt are of higher degree.
    """
    system = compile_model(loads_model(MACHINES[name]), "s")
    chain = find_mesh_response(
        system, OUTPUTS[:2] + OUTPUTS[3:5] + OUTPUTS[6:8], "in", [0.2 * RPM], "s", harmonics=2
    )
    roll = roll_through(system, "s", points=64, mesh="m")
    rows = roll.rows[:-1, [system.layout.channel(c) for c in chain.outputs]]
    wanted = 2.0 * np.fft.rfft(rows, axis=0)[1:3] / 64
    largest = np.abs(wanted).max()
    assert largest > 20.0
    assert np.all(np.abs(chain.response[0] - wanted).max(axis=1) < np.array([0.005, 0.02]) * largest)


@pytest.mark.parametrize("speed", [300.0, 2300.0])
def test_bearing_forces_are_those_of_time_responses(speed: float) -> None:
    """Below the modes, and at the tilting mode of the wheel, which the transmission error does not excite.

    At 2300 rpm the force of the bearing out_2 is 1000 N of 5.6 kN in the mesh; the product of the varying
    stiffness and the vibration, which is neglected, changes it by 1.2 %.
    """
    mesh = 25.0 * speed / 60.0
    periods = round(0.1 * mesh)
    run = f"duration: {0.15 + periods / mesh} s, sample_rate: {64 * mesh} Hz, step: 20 us"
    system = compile_model(loads_model(pair(speed=speed, run=run)), "s")
    names = [f"bearing_force[{name}]" for name in ("in_1.fy", "out_2.fx", "out_2.fy")]
    chain = find_mesh_response(system, names, "in", [speed * RPM], "s", harmonics=1)
    found = solve_time(system)
    rows = np.array([found[name].values[-64 * periods :] for name in names])
    wanted = 2.0 * np.abs(np.fft.rfft(rows, axis=1)[:, periods]) / rows.shape[1]
    assert np.abs(chain.response[0, 0]) == pytest.approx(wanted, abs=0.02 * wanted.max())
