# SPDX-License-Identifier: Apache-2.0
"""Equilibrium of machines in which bodies float within the clearance of their bearings."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.cycle_means import shift
from pitchpoint.solvers.equilibrium import solve
from pitchpoint.solvers.equilibrium.solve import balance_torques, find_equilibrium, solve_equilibrium
from pitchpoint.solvers.gear_trains import free_spins
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.meshes import mesh_records

SPUR = """\
gears:
  s: {number_of_teeth: 20, GEAR}
  r: {type: internal, number_of_teeth: 88, GEAR, tip_diameter: 259.5 mm, bore_diameter: 300 mm}
shafts:
  input: {position: [0, 0, 0], sections: [{length: 250 mm, diameter: 45 mm}], gears: {s: 220 mm}}
  mid:
    position: [0, 0, 280 mm]
    sections: [{length: 250 mm, diameter: 70 mm}]
    markers: {c: {position: [0, 0, 20 mm]}}
bodies:
  carrier: {mass: 8 kg, inertia_tensor: [0.06, 0.06, 0.1, 0, 0, 0], position: [0, 0, 220 mm]}
  case: {gears: [r], motion: fixed}
joints: {f: {type: fixed, bodies: [mid.c, carrier], position: [0, 0, 300 mm]}}
rolling_bearings:
  b1: {body: input, position: [0, 0, 40 mm], designation: 6309}
  b2: {body: input, position: [0, 0, 150 mm], designation: NU 209 E}
  b3: {body: mid, position: [0, 0, 60 mm], designation: 6214}
  b4: {body: mid, position: [0, 0, 140 mm], designation: NU 214 E}
planetary_stages:
  set:
    sun: s
    ring: r
    carrier: carrier
    planets: 3
    planet_name: p
    planet: {number_of_teeth: 34, GEAR, bore_diameter: 40 mm}
    motion: planar
    bearing: {stiffness: {radial: 5e8 N/m}}
    sun_mesh: {stiffness: {law: din3990}}
    ring_mesh: {stiffness: {law: din3990}}
loads: {in: {body: input, torque: 300 N m}, out: {body: mid, torque: balance, position: [0, 0, 200 mm]}}
""".replace(
    "GEAR",
    "normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0, tooth_thickness_allowance: -60 um",
)
"""Spur set whose shafts float along their axes within the clearance of 6309 and 6214."""

HELICAL = """\
gears:
  sun: {number_of_teeth: 28, GEAR, hand: right}
  ring: {type: internal, number_of_teeth: 92, GEAR, hand: left}
bodies:
  sun_shaft: {gears: [sun], position: [0, 0, 0], motion: planar}
  carrier: {inertia: 2 kg m^2, mass: 80 kg, motion: torsion}
  housing: {gears: [ring], motion: fixed}
rolling_bearings:
  p1: {ends: [carrier, planet_1], designation: NUP 2210 E}
  p2: {ends: [carrier, planet_2], designation: NUP 2210 E}
  p3: {ends: [carrier, planet_3], designation: NUP 2210 E}
planetary_stages:
  set:
    sun: sun
    ring: ring
    carrier: carrier
    planets: 3
    planet: {number_of_teeth: 32, GEAR, hand: left, bore_diameter: 90 mm}
    motion: free
    sun_mesh: {stiffness: {law: din3990}}
    ring_mesh: {stiffness: {law: din3990}}
loads: {motor: {body: sun_shaft, torque: 3000 N m}, machine: {body: carrier, torque: balance}}
scenarios: {steady: {speed: {sun_shaft: 600 rpm}, duration: 1 ms, step: 50 us}}
""".replace(
    "GEAR",
    "normal_module: 4 mm, helix_angle: 12 deg, face_width: 60 mm, profile_shift_coefficient: 0, "
    "tooth_thickness_allowance: -80 um",
)
"""Helical set: planets screw along the meshes within the play of their flanges, turned by their rollers."""


@pytest.fixture(scope="module")
def rested():
    """The spur set in equilibrium, and its held spins."""
    system = compile_model(loads_model(SPUR))
    held = free_spins(system)
    system = balance_torques(system, system.initial_state(), held)[0]
    return system, held, find_equilibrium(system, None, held).state


@pytest.mark.parametrize("mesh", [0, 3])
@pytest.mark.parametrize("share", [0.5625, 0.75, 0.875])
def test_floating_shafts_stay_where_they_are(rested, mesh, share):
    """At another mesh phase: the sun meshes carry the torque, shafts move by less than 0.1 um.

    A drift along the axis changes the common face width, and thus every mesh force, without end.
    """
    system, held, begin = rested
    own = system.copy()
    shift(mesh_records(own)[mesh], share)
    found = find_equilibrium(own, begin, held)
    values = evaluate.observe(own, found.state)
    forces = [values[own.layout.channel(f"mesh_force[s-p_{k}]")] for k in (1, 2, 3)]
    r_b = 0.5 * 20 * 3e-3 * math.cos(math.radians(20.0))
    assert abs(sum(forces)) * r_b == pytest.approx(300.0, rel=1e-5)
    along = [k for k, name in enumerate(own.layout.coordinates) if name in ("input.z", "mid.z")]
    assert np.abs(found.state.q - begin.q)[along].max() < 1e-7


@pytest.mark.slow
def test_planets_screw_to_where_their_rollers_hold_them():
    """The rollers turn with the planets: their varying compliance has a negative stiffness on the way.

    The means of the mesh cycle take equilibria at all phases of each mesh. Along its axis a planet touches
    one flange at most, so that its frequencies are those of a set without play.
    """
    found, tight = (
        find_modes(compile_model(loads_model(HELICAL.replace("2210 E", f"2210 E{play}")), "steady"), "steady")
        for play in ("", ", axial_clearance: 0")
    )
    assert found.frequency[0] == 0.0
    assert found.frequency == pytest.approx(tight.frequency, rel=0.01)


def test_a_body_that_is_free_in_its_clearance_is_named(monkeypatch):
    monkeypatch.setattr(solve, "MAX_ITERATIONS", 40)
    with pytest.raises(SolverError) as failure:
        solve_equilibrium(compile_model(loads_model(HELICAL)))
    assert " are unbalanced on planet_" in str(failure.value)
    body = str(failure.value).partition("; planet_")[2][0]
    assert str(failure.value).endswith(
        f"planet_{body} moves freely within the clearance of p{body}, where almost no force holds it: "
        "reduce the clearance (clearance: 0, axial_clearance: 0), or add a load that the bearing supports, "
        "such as gravity"
    )
