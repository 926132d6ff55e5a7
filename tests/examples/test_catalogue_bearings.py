# SPDX-License-Identifier: Apache-2.0
"""The example `catalogue-bearings`: bearing forces of a two-stage gearbox against statics by hand."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model

FILE = Path(__file__).parents[2] / "examples" / "catalogue-bearings" / "model.yaml"
Z = np.array([0.0, 0.0, 1.0])


def gear_force(torque, radius, way, alpha_wt, thrust):
    """Force on a gear: torque of the mesh about z [N m], direction to the mate, F_a over F_t."""
    tangential = torque / radius
    across = np.cross(Z, way)
    return tangential * across - abs(tangential) * math.tan(alpha_wt) * way + thrust * abs(tangential) * Z


def reactions(gears, places):
    """Radial forces of two bearings that hold the gears; gears as (position on the shaft, arm, force)."""
    low, high = places
    force = sum(f for _, _, f in gears)
    moment = sum(np.cross(np.array([*arm[:2], z - low]), f) for z, arm, f in gears)
    far = np.array([-moment[1], moment[0]]) / (high - low)
    return -force[:2] - far, far


@pytest.fixture(scope="module")
def seen():
    """Bearing forces at rest under load."""
    model = load_model(FILE)
    found = solve_equilibrium(compile_model(model))
    return model, {name: found[name].item() for name in found if "bearing_force" in name}


def by_hand(model):
    """Gear forces (F_t, F_r, F_a as vectors) by shaft, from torque, working circles and helix angles."""
    found = {"input": [], "middle": [], "output": []}
    torque, turning = 40.0, 1.0
    for (one, two), mesh, (first, second) in (
        (("z1", "z2"), "first", ("input", "middle")),
        (("z3", "z4"), "second", ("middle", "output")),
    ):
        pair, gear = model.pairs[mesh], model.gears[one]
        theta = model.meshes[mesh].theta
        way = np.array([math.cos(theta), math.sin(theta), 0.0])
        alpha_wt = pair.working_pressure_angle(pair.a_w)
        z_1, z_2 = (model.gears[g].number_of_teeth for g in (one, two))
        r_1, r_2 = (pair.a_w * z / (z_1 + z_2) for z in (z_1, z_2))
        reference = 0.5 * z_1 * gear.normal_module / math.cos(gear.helix_angle)
        tan_beta_w = math.tan(gear.helix_angle) * r_1 / reference
        # the thrust on the driver has the direction of its rotation for right hand
        side = turning * (1.0 if gear.hand == "right" else -1.0)
        force = gear_force(-torque, r_1, way, alpha_wt, side * tan_beta_w)
        found[first].append((model.bodies[first].gears[one], r_1 * way, force))
        found[second].append((model.bodies[second].gears[two], -r_2 * way, -force))
        torque, turning = -torque * z_2 / z_1, -turning
    return found


def test_resultant_of_each_shaft(seen):
    """Both bearings of a shaft carry the gear forces; 0.5 %: the working circles of the loaded shafts."""
    model, forces = seen
    for shaft, gears in by_hand(model).items():
        wanted = -sum(force for _, _, force in gears)
        names = [n for n, part in model.rolling_bearings.items() if part.body == shaft]
        total = [sum(forces[f"bearing_force[{n}.{c}]"] for n in names) for c in ("fx", "fy", "fz")]
        np.testing.assert_allclose(total, wanted, atol=5e-3 * np.linalg.norm(wanted))


def test_radial_force_of_each_bearing(seen):
    """Statics with the pressure centres of the tapered bearings, a = (d_m/2) tan(alpha) inside.

    10 % of the larger force: the bearings resist tilting, and bent shafts move the load along the faces.
    """
    model, forces = seen
    for shaft, gears in by_hand(model).items():
        names = sorted(
            (n for n, part in model.rolling_bearings.items() if part.body == shaft),
            key=lambda n: model.rolling_bearings[n].position[2],
        )
        places = []
        for name in names:
            part = model.rolling_bearings[name]
            inside = 0.5 * part.geometry.pitch_diameter * math.tan(part.geometry.contact_angle)
            places.append(part.position[2] - inside)
        wanted = [float(np.hypot(*force)) for force in reactions(gears, places)]
        found = [forces[f"bearing_force[{name}.radial]"] for name in names]
        np.testing.assert_allclose(found, wanted, atol=0.1 * max(wanted))


def test_axial_forces(seen):
    """One bearing locates each shaft; the tapered pair shares the thrust about its preload."""
    _, forces = seen
    assert forces["bearing_force[input_end.axial]"] == forces["bearing_force[output_low.axial]"] == 0.0
    assert forces["bearing_force[middle_low.axial]"] > 300.0
    assert forces["bearing_force[middle_high.axial]"] < -300.0
