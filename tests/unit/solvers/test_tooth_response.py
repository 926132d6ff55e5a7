# SPDX-License-Identifier: Apache-2.0
"""Ranked critical speeds of mesh orders against frequency responses to the transmission error."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.analysis.campbell_ranking import LARGE, ranked_speeds
from pitchpoint.analysis.planet_frequencies import excited_motion
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.campbell import Campbell, follow_modes
from pitchpoint.solvers.campbell_dataset import campbell_dataset
from pitchpoint.solvers.critical_speeds import CriticalSpeed, critical_speeds
from pitchpoint.solvers.cycle_means import moving_phases
from pitchpoint.solvers.excitation_orders import excitation_orders
from pitchpoint.solvers.frequency_response import matrices_of, respond
from pitchpoint.solvers.inputs_outputs import find_inputs, find_outputs
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.over_speed import at_one_azimuth
from pitchpoint.solvers.tooth_response import Source, teeth_of
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


def excited(found: Campbell, c: CriticalSpeed) -> Source:
    """Excitation of the mesh order of a crossing."""
    laws = {name: found.motions.laws[name] for name in c.order.meshes}
    at_rest = found.modes.modes.whole
    assert at_rest is not None
    phases = moving_phases(found.motions.system, found.motions.state, found.rates)
    source = teeth_of(laws, c.order.harmonic, at_rest, phases)
    assert source is not None
    return source


def response(found: Campbell, c: CriticalSpeed) -> tuple[float, float, float]:
    """Dynamic deflection under an excitation of unit energy at a crossing, and bounds of that of other modes.

    The deflection where the excitation p acts is p^H q = sum_j a_j/(1 - r_j^2 + 2 i zeta_j r_j), with
    a_j = |p^T z_j|^2/omega_j^2 and r_j = f/f_j; without its static value a_j h_j, h_j = (r_j^2 - 2 i zeta_j
    r_j)/(1 - r_j^2 + 2 i zeta_j r_j). The bounds are the sums of a_j |h_j| and a_j |Im h_j| over other modes.
    """
    linear = at_one_azimuth(found.modes.linear, found.rates).at(c.speed)
    source = excited(found, c)
    (port,) = find_inputs(linear, [f"transmission_error[{c.order.meshes[0]}]"])
    none = np.zeros_like(port.force)
    port = replace(port, force=source.forces[0], rate=none, follows=none, direct=0.0)
    outs = find_outputs(linear, list(linear.system.layout.coordinates))
    omega = math.tau * c.frequency
    moved, still = (
        respond(linear, matrices_of(linear), linear.basis, [port], outs, x)[:, 0]
        for x in (omega, 1e-4 * omega)
    )
    rates, shapes = found.modes.modes.whole or (np.zeros(0), np.zeros((0, 0)))
    own = int(np.argmin(np.abs(rates - omega)))
    others = (rates > 0.0) & (np.arange(rates.size) != own)
    z, r = shapes[others], omega / rates[others]
    damping = ((z @ linear.D) * z).sum(axis=1) / rates[others] * 1j * r  # 2 i zeta r
    shares = np.abs(z @ source.forces[0]) ** 2 / rates[others] ** 2
    each = (r**2 - damping) / (1.0 - r**2 + damping)
    peak = float(abs(source.rows[0] @ (moved - still)))
    return peak, float(shares @ np.abs(each)), float(shares @ np.abs(each.imag))


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
    "helical planetary": (planetary(18.0), "sun_shaft", 9e3, 1),
}


@pytest.mark.parametrize("name", MACHINES)
def test_amplification_is_the_response_to_the_excitation(name: str) -> None:
    """Deflection under the excitation at the crossings, by the frequency response.

    The sum over the other modes bounds the difference from the single mode. At resonance their part without
    damping is at right angles to it: modes are well separated where the sum is below 0.2 of it,
    sqrt(1 + 0.2^2) = 1.02.
    """
    text, body, top, separated = MACHINES[name]
    found, listed = crossings(text, body, top)
    checked = 0
    for c in listed:
        peak, bound, in_phase = response(found, c)
        if c.participation == 0.0:
            assert (c.amplification, c.response) == (0.0, 0.0)
            assert peak <= 1.02 * bound
        elif c.damping_ratio > 0.0:
            assert peak == pytest.approx(c.amplification, abs=1.02 * bound + 0.02 * c.amplification)
        if bound < 0.2 * c.amplification < math.inf:
            assert peak == pytest.approx(c.amplification, abs=in_phase + 0.02 * c.amplification)
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
    at = at_one_azimuth(found.modes.linear, found.rates).at(tilting.speed)
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
    at = at_one_azimuth(found.modes.linear, found.rates).at(axial.speed)
    ins, outs = find_inputs(at, ["transmission_error[m]"]), find_outputs(at, ["B.uz"])
    moved = abs(respond(at, matrices_of(at), at.basis, ins, outs, math.tau * axial.frequency)[0, 0])
    mean = math.sqrt(moved * stiffness * moved / found.motions.laws["m"].mean)
    bearing = found.motions.groups.components.index("bearing on_b")
    near = found.energies[int(np.argmin(np.abs(found.speed - axial.speed)))]
    assert mean == pytest.approx(math.sqrt(near.strain[axial.mode, bearing]) * row.response, rel=0.02)


@pytest.mark.parametrize(
    ("planets", "teeth"),
    [(3, (21, 27, 75)), (3, (22, 26, 74)), (4, (22, 26, 74))],
    ids=["0", "1 of 3", "2 of 4"],
)
def test_mesh_phases_of_planets_decide_which_modes_an_order_drives(
    planets: int, teeth: tuple[int, int, int]
) -> None:
    """Modes up to 6 kHz of the type that `excited_motion` derives from the tooth numbers, and no others.

    Unequal deflections of the planets in one position give other types shares of up to 5e-5.

    R. G. Parker: A physical explanation for the effectiveness of planet phasing to suppress planetary gear
    vibration, J. Sound Vib. 236 (2000) 561-573.
    """
    text = planetary(0.0).replace("planets: 3", f"planets: {planets}")
    for z, old in zip(teeth, (21, 27, 75), strict=True):
        text = text.replace(f"number_of_teeth: {old},", f"number_of_teeth: {z},")
    system = built(text)
    found = follow_modes(system, np.linspace(50.0, 2.1e4, 15) * RPM, "sun_shaft", "run")
    orders = excitation_orders(system, found.motions, found.rates, ["mesh", "2mesh"])
    seen: dict[int, set[str]] = {1: set(), 2: set()}
    for c in critical_speeds(found, orders):
        if c.participation > 1e-3 and c.frequency < 6e3:
            seen[c.order.harmonic].add(found.names[c.mode])
    for harmonic, motion in enumerate(excited_motion(teeth[0], planets, 2), 1):
        assert seen[harmonic]
        assert all(f" {motion} mode" in name for name in seen[harmonic]), seen


def test_excitation_at_negative_speeds_is_that_of_the_mirrored_motion() -> None:
    """Whirl and excitation change direction together: tilting modes have the same amplification.

    A(-Omega) is the transpose of A(Omega) but for the torques, which follow the tilting axes and do not
    change with the direction: 1 %.
    """
    system = built(drive(18.0))
    found = []
    for sign in (1.0, -1.0):
        modes = follow_modes(system, sign * np.linspace(50.0, 11e3, 15) * RPM, "A", "run")
        order = excitation_orders(system, modes.motions, modes.rates, ["mesh"])
        rows = sorted((c.frequency, c.amplification) for c in critical_speeds(modes, order))
        found.append(np.array(rows))
    assert len(found[0]) > 5
    assert found[1] == pytest.approx(found[0], rel=0.02)
