# SPDX-License-Identifier: Apache-2.0
"""Carriers that yield: wind-up of a two-plate carrier, and pins that are fixed at one end.

A pin between two plates is tilted by their relative rotation phi = T_2/k_t, with the torque T_2 that the
second plate passes on to the first: by phi a/s for plates s apart and pins a from the axis. The forces F_1
and F_2 of both bearings of stiffness k add (F_1 - F_2)/(k s).

A pin fixed at one end is a cantilever of the length l: a force F and a moment M at the planet deflect it by
F l^3/(3 E I) + M l^2/(2 E I) and tilt it by F l^2/(2 E I) + M l/(E I).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model
from tests.support.planet_stages import ARM, stage_file

APART, BEARING, WINDING = 60e-3, 1e9, 2e6


def test_wind_up_of_a_two_plate_carrier():
    """The stage is on the first plate; the second has one more bearing per planet. Tolerance: deflections
    against the radius of the pins, 1e-3."""
    plate = (
        "  plate: {inertia: 0.05 kg m^2, mass: 4 kg, position: [0, 0, 0]}\n"
        "couplings:\n"
        f"  webs: {{bodies: [carrier, plate], stiffness: {{torsion: {WINDING!r} N m/rad}}}}\n"
        "bearings:\n"
    )
    plate += "".join(
        f"  {planet}{side}: {{body: {planet}, housing: {housing}, position: [0, 0, {sign * APART / 2!r} m], "
        f"stiffness: {{radial: {BEARING!r} N/m, axial: {axial!r} N/m}}}}\n"
        for planet in ("planet_1", "planet_2", "planet_3")
        for side, housing, sign, axial in (("a", "carrier", -1, 1e7), ("b", "plate", 1, 0.0))
    )
    text = stage_file("planets: 3\nmotion: free").replace("loads:\n", plate + "loads:\n")
    found = solve_equilibrium(compile_model(loads_model(text)))
    # planet 1 is on the x axis: its pin is loaded along y and tilts about x
    forces = [float(found[f"bearing_force[planet_1{side}.fy]"]) for side in "ab"]
    torque = 3.0 * forces[1] * ARM
    twist = float(found["angle[plate]"] - found["angle[carrier]"])
    assert abs(twist) == pytest.approx(abs(torque) / WINDING, rel=1e-3)
    offsets = [force / BEARING for force in forces]
    tilt = (abs(offsets[1]) + abs(torque) / WINDING * ARM - abs(offsets[0])) / APART
    assert tilt > 1e-4
    assert abs(float(found["displacement[planet_1.rx]"])) == pytest.approx(tilt, rel=1e-3)
    # both bearings together have the force of sun and ring
    sun = 600.0 / (3 * 31.5e-3)
    assert abs(sum(forces)) == pytest.approx(2.0 * sun, rel=1e-3)


def test_pins_fixed_at_one_end():
    """The flexibility of the cantilever as matrix of the bearing; it tilts the planets under load."""
    length, stiffness = 40e-3, 2.1e11 * math.pi / 64 * 40e-3**4
    bend, both, turn = (
        length**3 / (3 * stiffness),
        length**2 / (2 * stiffness),
        length / stiffness,
    )
    flexible = np.zeros((6, 6))
    for force, moment, sign in ((0, 4, 1.0), (1, 3, -1.0)):  # a force along y tilts about -x
        flexible[force, force], flexible[moment, moment] = bend, turn
        flexible[force, moment] = flexible[moment, force] = sign * both
    flexible[2, 2], flexible[5, 5] = 1e-7, 1.0
    matrix = np.linalg.inv(flexible)
    matrix[5, 5] = 0.0
    rows = [[float(f"{v:.12g}") for v in row] for row in 0.5 * (matrix + matrix.T)]
    text = stage_file(f"planets: 3\nmotion: free\nbearing: {{stiffness: {{matrix: {rows}}}}}")
    found = solve_equilibrium(compile_model(loads_model(text)))
    values = {key: float(found[f"bearing_force[planet_1-bearing.{key}]"]) for key in ("fy", "mx")}
    moved = float(found["displacement[planet_1.y]"]), float(found["displacement[planet_1.rx]"])
    # forces of the bearing on the planet: opposite to the deflection
    assert moved[0] == pytest.approx(-(bend * values["fy"] - both * values["mx"]), rel=1e-6)
    assert moved[1] == pytest.approx(-(turn * values["mx"] - both * values["fy"]), rel=1e-6)
    assert abs(moved[1]) > 1e-5
