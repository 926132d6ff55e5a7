# SPDX-License-Identifier: Apache-2.0
"""Planetary stages from a model file: Willis's speeds, shared load, torques of the members.

Closed forms; tolerances are those of the loaded state: twist of the shafts against the base pitch.
"""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.planet_stages import stage_file


def test_speeds_follow_willis_and_the_load_is_shared():
    model = loads_model(stage_file(torque=300.0).replace("duration: 5 ms", "duration: 20 ms"))
    assert model.start_speeds("steady")["carrier"] == pytest.approx(1000.0 * np.pi / 30 * 21 / 120, rel=1e-12)
    found = solve_time(compile_model(model, "steady"))
    rpm = 30.0 / np.pi
    assert found["speed[carrier]"].values.mean() * rpm == pytest.approx(175.0, rel=1e-4)
    # against the carrier: -(1000 - 175) 21/39
    assert found["speed[planet_1]"].values.mean() * rpm == pytest.approx(-444.2308, rel=1e-4)
    r_b = 0.5 * 21 * 3e-3 * np.cos(np.radians(20.0))
    for k in (1, 2, 3):
        force = 300.0 / (3 * r_b)
        assert found[f"mesh_force[sun-planet_{k}]"].values.mean() == pytest.approx(force, rel=1e-3)
        assert found[f"mesh_force[planet_{k}-ring]"].values.mean() == pytest.approx(-force, rel=1e-3)


def test_the_carrier_takes_the_sum_of_the_torques():
    """z_r/z_s times the torque of the sun on the ring, the sum on the carrier."""
    found = solve_equilibrium(compile_model(loads_model(stage_file(torque=300.0))))
    assert float(found["torque[brake]"]) == pytest.approx(-300.0 * (1.0 + 99 / 21), rel=1e-6)
