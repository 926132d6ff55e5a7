# SPDX-License-Identifier: Apache-2.0
"""Mean mesh frequencies of a run from the angles of its bodies."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.run_frequencies import mean_mesh_frequencies

GEARS = """
gears:
  one: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  two: {number_of_teeth: 30, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {input: {gears: [one]}, output: {gears: [two]}}
meshes: {stage: {gears: [one, two]}}
"""


def run_of(speed: float, **names: float) -> xr.Dataset:
    """Angles [rad] over a second, in rad/s times `speed` by name."""
    time = np.linspace(0.0, 1.0, 201)
    angles = {f"angle[{name}]": ("time", factor * speed * time) for name, factor in names.items()}
    return xr.Dataset(angles, coords={"time": time})


def test_mesh_frequency_is_teeth_times_speed() -> None:
    """20 teeth at 25 revolutions per second; both senses of rotation."""
    model = loads_model(GEARS)
    for sign in (1.0, -1.0):
        found = mean_mesh_frequencies(model, run_of(sign * 50 * np.pi, input=1.0, output=-2 / 3))
        assert found == {"stage": pytest.approx(500.0)}


def test_unknown_angles_and_rest_give_no_frequency() -> None:
    model = loads_model(GEARS)
    assert mean_mesh_frequencies(model, run_of(100.0, input=1.0)) == {}
    assert mean_mesh_frequencies(model, run_of(0.0, input=1.0, output=1.0)) == {}
