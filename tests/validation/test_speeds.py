# SPDX-License-Identifier: Apache-2.0
"""Dynamics at vanishing speed equal statics: one mesh law serves both solvers.

No published numbers: two ways through the package to the same state. At 1e-3 rev/s of a mesh that vibrates at
kilohertz, inertia and damping forces are below 1e-6 of the load.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

PAIRS = {
    "spur": ("", 45, "", "200 N m"),
    "helical": (", helix_angle: 20 deg, hand: right", 45, ", helix_angle: 20 deg, hand: left", "200 N m"),
    "internal": (
        ", helix_angle: 15 deg, hand: left",
        80,
        ", type: internal, helix_angle: 15 deg, hand: left",
        "-200 N m",
    ),
}
CHANNELS = ("transmission_error", "mesh_force", "mesh_stiffness", "radial_force", "pair_force")


@pytest.mark.parametrize("name", PAIRS)
def test_slow_dynamics_are_statics(name):
    one, z2, two, load = PAIRS[name]
    text = (
        "gears:\n"
        "  g1: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, "
        f"profile_shift_coefficient: 0{one}}}\n"
        f"  g2: {{number_of_teeth: {z2}, normal_module: 3 mm, face_width: 20 mm, "
        f"profile_shift_coefficient: 0{two}}}\n"
        "bodies:\n  driver: {gears: [g1]}\n  driven: {gears: [g2]}\n"
        "meshes:\n  stage: {gears: [g1, g2], backlash: {normal: 0.1 mm}, damping: {ratio: 0.2},\n"
        "    stiffness: {law: din3990, tip_relief_factor: 0.5}}\n"
        f"loads:\n  brake: {{body: driven, torque: {load}}}\n"
        "scenarios:\n  slow: {drive: {driver: {speed: 0.06 rpm}}, duration: 40 s, step: 10 ms, "
        "sample_rate: 1 Hz}\n"
    )
    model = loads_model(text)
    data = solve_time(compile_model(model, "slow"))
    free = compile_model(model)
    for angle, t in list(zip(data["angle[driver]"].values, data["time"].values, strict=True))[4::7]:
        rest = solve_equilibrium(free, {"driver": float(angle)})
        for channel in data.data_vars:
            if channel.startswith(CHANNELS):
                size = np.abs(data[channel].values).max()
                moving = float(data[channel].sel(time=t))
                assert moving == pytest.approx(float(rest[channel]), abs=5e-6 * size), (channel, t)
