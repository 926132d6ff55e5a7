# SPDX-License-Identifier: Apache-2.0
"""Ranked critical speeds of mesh orders against frequency responses to the transmission error."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.analysis.campbell_ranking import LARGE, ranked_speeds
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.campbell import Campbell, at_speeds, follow_modes
from pitchpoint.solvers.campbell_dataset import campbell_dataset
from pitchpoint.solvers.critical_speeds import CriticalSpeed, critical_speeds
from pitchpoint.solvers.excitation_orders import excitation_orders
from pitchpoint.solvers.frequency_response import matrices_of, respond
from pitchpoint.solvers.inputs_outputs import find_inputs, find_outputs
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from pitchpoint.system.system import System

RPM = math.pi / 30.0
TOOTH = (
    "normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0, tooth_thickness_allowance: -30 um"
)
TILTING = f"""\
gears:
  a: {{number_of_teeth: 25, {TOOTH}}}
  b: {{number_of_teeth: 50, {TOOTH}}}
bodies:
  A: {{gears: [a], motion: free, mass: 2 kg, inertia: 4e-3 kg m^2, transverse_inertia: 3e-3 kg m^2}}
  B: {{gears: [b], motion: torsion, inertia: 2e-2 kg m^2}}
bearings:
  br: {{body: A, stiffness: {{radial: 1e9 N/m, axial: 1e8 N/m, tilt: 2e4 N m/rad}}, damping: {{ratio: 0.01}}}}
meshes:
  m: {{gears: [a, b], stiffness: {{law: din3990}}, damping: {{ratio: 0.03}}}}
loads: {{in: {{body: A, torque: 100 N m}}, out: {{body: B, torque: balance}}}}
scenarios: {{run: {{speed: {{A: 1800 rpm}}, duration: 20 ms}}}}
"""
"""Pinion on one bearing in the middle of its face: its tilting deforms the flanks without mean deflection."""


def drive(beta: float, *, internal: bool = False, axial: str = "1e8 N/m") -> str:
    """A pair on bearings to ground, the wheel external or internal."""
    ring = "type: internal, bore_diameter: 300 mm, " if internal else ""
    sides = ("right", "right") if internal else ("right", "left")
    teeth = (21, 79) if internal else (21, 57)
    gears = "".join(
        f"  {name}: {{{kind}number_of_teeth: {z}, helix_angle: {beta} deg, hand: {hand}, {TOOTH}}}\n"
        for name, kind, z, hand in zip(("p", "w"), ("", ring), teeth, sides, strict=True)
    )
    return f"""\
gears:
{gears}bodies:
  A: {{gears: [p], motion: free, mass: 2 kg, inertia: 2e-3 kg m^2, transverse_inertia: 3e-3 kg m^2}}
  B: {{gears: [w], motion: free, mass: 9 kg, inertia: 5e-2 kg m^2, transverse_inertia: 3e-2 kg m^2}}
bearings:
  on_a: {{body: A, position: [0, 0, 10 mm], damping: {{ratio: 0.01}},
    stiffness: {{radial: 4e8 N/m, axial: 2e8 N/m, tilt: 5e5 N m/rad}}}}
  on_b: {{body: B, position: [0, 0, -8 mm], damping: {{ratio: 0.002}},
    stiffness: {{radial: 6e8 N/m, axial: {axial}, tilt: 2e6 N m/rad}}}}
meshes: {{m: {{gears: [p, w], stiffness: {{law: din3990}}, damping: {{ratio: 0.02}}}}}}
loads: {{in: {{body: A, torque: 150 N m}}, out: {{body: B, torque: balance}}}}
scenarios: {{run: {{speed: {{A: 1500 rpm}}, duration: 20 ms}}}}
"""


def planetary(beta: float) -> str:
    """Sun that can move and tilt, planets that move in their plane, driven by a torque that tilts with it."""
    tooth = f"normal_module: 1.5 mm, helix_angle: {beta} deg, face_width: 22 mm, profile_shift_coefficient: 0"
    tooth += ", tooth_thickness_allowance: -25 um"
    return f"""\
gears:
  sun: {{number_of_teeth: 21, hand: right, {tooth}}}
  ring: {{type: internal, number_of_teeth: 75, hand: left, {tooth}}}
bodies:
  sun_shaft: {{gears: [sun], transverse_inertia: 1e-3 kg m^2, motion: free, mass: 0.8 kg,
    inertia: 4e-4 kg m^2, position: [0, 0, 0]}}
  housing: {{gears: [ring], motion: fixed}}
  carrier: {{inertia: 4e-3 kg m^2, mass: 4 kg}}
planetary_stages:
  ps:
    sun: sun
    ring: ring
    carrier: carrier
    planets: 3
    planet: {{number_of_teeth: 27, hand: left, {tooth}, bore_diameter: 20 mm}}
    motion: planar
    bearing: {{stiffness: {{radial: 2e8 N/m}}, damping: {{ratio: 0.03}}}}
    sun_mesh: {{stiffness: {{law: din3990}}, damper: {{ratio: 0.05}}}}
    ring_mesh: {{stiffness: {{law: din3990}}, damper: {{ratio: 0.05}}}}
bearings:
  spline: {{body: sun_shaft, stiffness: {{radial: 2e6 N/m, axial: 5e7 N/m, tilt: 1e4 N m/rad}}}}
loads: {{motor: {{body: sun_shaft, torque: 40 N m}}, mill: {{body: carrier, torque: balance}}}}
scenarios: {{run: {{speed: {{sun_shaft: 2900 rpm}}, duration: 20 ms}}}}
"""


def built(text: str) -> System:
    """Machine with what its scenario prescribes."""
    return compile_model(loads_model(text), "run")


def crossings(text: str, body: str, top: float) -> tuple[Campbell, tuple[CriticalSpeed, ...]]:
    """Modes up to a speed [rpm] and their crossings with the mesh order."""
    system = built(text)
    found = follow_modes(system, np.linspace(50.0, top, 15) * RPM, body, "run")
    return found, critical_speeds(found, excitation_orders(system, found.motions, found.rates, ["mesh"]))


def response(found: Campbell, c: CriticalSpeed) -> float:
    """Largest mean tooth deflection per transmission error at a crossing, of all amplitudes and phases."""
    linear, laws = at_speeds(found.modes.linear, c.speed * found.rates), found.motions.laws
    root = np.sqrt([laws[name].mean for name in c.order.meshes])
    ins = find_inputs(linear, [f"transmission_error[{name}]" for name in c.order.meshes])
    outs = find_outputs(linear, [f"mesh_force[{name}]" for name in c.order.meshes])
    force = respond(linear, matrices_of(linear), linear.basis, ins, outs, math.tau * c.frequency)
    return float(np.linalg.norm(force / np.outer(root, root), 2))


SINGLE = """\
gears:
  p: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {A: {gears: [p], inertia: 1e-3 kg m^2}, B: {gears: [w], inertia: 2e-2 kg m^2}}
meshes: {m: {gears: [p, w], stiffness: {law: constant, value: 4e8 N/m}, damping: {ratio: 0.01}}}
loads: {brake: {body: B, torque: -50 N m}}
scenarios: {run: {drive: {A: {speed: {table: [[0 s, 600 rpm], [1 s, 900 rpm]]}}}, duration: 1 s}}
"""
"""Wheel on the teeth of a driven pinion: one degree of freedom."""

MACHINES = {
    "driven pinion": (SINGLE, "A", 6e3, 1),
    "tilting spur pinion": (TILTING, "A", 14e3, 2),
    "external spur": (drive(0.0), "A", 11e3, 2),
    "external helical": (drive(18.0), "A", 11e3, 3),
    "internal helical": (drive(12.0, internal=True), "A", 11e3, 2),
    "spur planetary": (planetary(0.0), "sun_shaft", 9e3, 1),
    "helical planetary": (planetary(18.0), "sun_shaft", 9e3, 2),
}


@pytest.mark.parametrize("name", MACHINES)
def test_amplification_is_the_response_to_the_transmission_error(name: str) -> None:
    """Force on the teeth over stiffness and error at the crossings, by the frequency response.

    The force is k (u - e); mode j adds p_j r^2/(1 - r^2) with r = f/f_j. The sum over the other modes bounds
    the difference from the single mode, up to 2 % for their damping. At resonance they are at right angles
    to it: modes are well separated where the sum is below 0.2 of it, sqrt(1 + 0.2^2) = 1.02.
    """
    text, body, top, separated = MACHINES[name]
    found, listed = crossings(text, body, top)
    modes = find_modes(built(text), "run")
    shares = modes.energies.teeth.sum(axis=1)
    vibrates = modes.frequency > 1.0
    checked = 0
    for c in listed:
        own = int(np.argmin(np.abs(modes.damped_frequency - c.frequency)))
        others = vibrates & (np.arange(len(shares)) != own)
        r2 = (c.frequency / modes.frequency[others]) ** 2
        bound = float((shares[others] * r2 / np.abs(1.0 - r2)).sum())
        peak = response(found, c)
        if c.participation == 0.0:
            assert (c.amplification, c.response) == (0.0, 0.0)
            assert peak <= 1.02 * bound
        elif c.damping_ratio > 0.0:
            assert peak == pytest.approx(c.amplification, abs=1.02 * bound + 0.02 * c.amplification)
        if bound < 0.2 * c.amplification < math.inf:
            assert peak == pytest.approx(c.amplification, rel=0.02)
            checked += 1
    assert checked >= separated


def test_tilted_flanks_take_no_energy_from_the_transmission_error() -> None:
    """Mode with 83 % of its strain energy in the mesh, by k b^2/12: a uniform error does not excite it."""
    found, listed = crossings(TILTING, "A", 14e3)
    (tilting,) = [c for c in listed if 900.0 < c.frequency < 1100.0]
    assert found.names[tilting.mode].startswith("tilting of A (")
    assert (tilting.participation, tilting.response) == (0.0, 0.0)
    energies = found.energies[-1]
    mesh = found.motions.groups.components.index("mesh m")
    assert energies.strain[-1:, mesh] > 0.5
    assert energies.strain[tilting.mode, mesh] == pytest.approx(0.83, abs=0.01)
    assert energies.teeth[tilting.mode] == pytest.approx([0.0], abs=1e-12)
    assert energies.strain[1:].sum(axis=1) == pytest.approx(1.0, abs=1e-12)
    assert np.all(energies.teeth[:, 0] <= energies.strain[:, mesh] + 1e-3)  # less the geometric stiffness
    system = built(TILTING)
    at = at_speeds(found.modes.linear, tilting.speed * found.rates)
    ins, outs = find_inputs(at, ["transmission_error[m]"]), find_outputs(at, ["A.rx", "A.ry", "A.ux"])
    moved = np.abs(respond(at, matrices_of(at), at.basis, ins, outs, math.tau * tilting.frequency))[:, 0]
    assert moved[:2] == pytest.approx(0.0, abs=1e-9 * moved[2])
    data = campbell_dataset(system, found, orders=["mesh"])
    assert [c.frequency for c in ranked_speeds(data)] == pytest.approx([2231.2, 5483.0], abs=0.5)


def test_tilting_of_the_sun_is_named_by_what_moves() -> None:
    """The sun tilts at 930 Hz, x = y = 0; the first translational pair is that at 1418 Hz."""
    modes = find_modes(built(planetary(0.0)), "run")
    named = dict(zip(modes.names, modes.damped_frequency, strict=True))
    for whirl in ("backward", "forward"):
        assert named[f"tilting of sun_shaft ({whirl})"] == pytest.approx(930.0, abs=15.0)
        name = f"1st translational mode of planetary stage ps ({whirl})"
        assert named[name] == pytest.approx(1418.0, abs=2.0)
    assert not any("tilting of planet" in name for name in modes.names)


@pytest.mark.parametrize(("beta", "listed"), [(18.0, True), (0.0, False)])
def test_axial_mode_on_a_soft_bearing_is_listed_if_the_error_drives_it(beta: float, listed: bool) -> None:
    """Wheel on a soft axial bearing: the teeth hardly deflect, the wheel and its bearing do.

    The bearing responds with the geometric mean of its displacement over e and its force over k e, the root
    of its share of the strain energy times the response of the machine.
    """
    stiffness = 2e7
    found, crossed = crossings(drive(beta, axial=f"{stiffness} N/m"), "A", 3000.0)
    (axial,) = [c for c in crossed if found.names[c.mode] == "axial mode of B"]
    data = campbell_dataset(found.modes.linear.system, found, orders=["mesh"])
    (row,) = [c for c in ranked_speeds(data) if c.mode == "axial mode of B"] or [None]
    assert (row is not None) == listed
    if row is None:
        assert axial.participation < 1e-9
        return
    assert row.participation < 1e-3
    assert row.amplification < 0.1 < LARGE < row.response
    at = at_speeds(found.modes.linear, axial.speed * found.rates)
    ins, outs = find_inputs(at, ["transmission_error[m]"]), find_outputs(at, ["B.uz"])
    moved = abs(respond(at, matrices_of(at), at.basis, ins, outs, math.tau * axial.frequency)[0, 0])
    mean = math.sqrt(moved * stiffness * moved / found.motions.laws["m"].mean)
    bearing = found.motions.groups.components.index("bearing on_b")
    near = found.energies[int(np.argmin(np.abs(found.speed - axial.speed)))]
    assert mean == pytest.approx(math.sqrt(near.strain[axial.mode, bearing]) * row.response, rel=0.02)
