# SPDX-License-Identifier: Apache-2.0
"""Load shares of planets at the positions of their carrier, against given forces."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import pitchpoint
from pitchpoint.cli.planet_loads import position_words
from pitchpoint.system.planet_loads import as_data, planet_loads
from pitchpoint.system.planet_positions import SECTORS, shares_at_positions

TEETH, MEAN, AMPLITUDE = 99, 190e3, 0.04
MESHES = [f"sun-planet_{k}" for k in (1, 2, 3)]


@pytest.fixture(scope="module")
def model():
    return pitchpoint.load_model(Path(__file__).parents[3] / "examples" / "wind-drive-grc" / "torsion.yaml")


def result_of(turns: float, samples: int = 40, least: float = 1.0) -> xr.Dataset:
    """Forces that vary once per turn, with the mesh frequency, and from 1 to `least` in time."""
    cycles = np.linspace(0.0, TEETH * turns, round(TEETH * turns * samples) + 1)
    angle = math.tau * cycles / TEETH
    torque = np.linspace(1.0, least, cycles.size) * (1.0 + 0.3 * np.sign(np.sin(math.tau * cycles)))
    channels = {"angle[carrier]": angle, f"mesh_phase[{MESHES[0]}]": cycles % 1.0}
    for k, mesh in enumerate(MESHES):
        channels[f"mesh_force[{mesh}]"] = (
            -MEAN * torque * (1.0 + AMPLITUDE * np.cos(angle - k * math.tau / 3.0))
        )
    time = cycles / 36.0
    return xr.Dataset({name: ("time", values) for name, values in channels.items()}, coords={"time": time})


def positions(model, result):
    return planet_loads(model, result)["stage_1"].positions


def test_the_largest_factor_is_that_of_the_variation_once_per_turn(model):
    """1 + A in the mean over 8 of 99 mesh periods, sinc(8/99); the mean over the turn is 1."""
    loads = planet_loads(model, result_of(1.0))["stage_1"]
    sector = np.sinc(int(TEETH / SECTORS) / TEETH)
    assert loads.factor == pytest.approx(1.0, abs=1e-3)
    assert loads.positions.factor == pytest.approx(1.0 + AMPLITUDE * sector, abs=2e-4)
    loads = planet_loads(model, result_of(1.2))["stage_1"]  # with the sectors about its start
    assert loads.positions.largest_share == pytest.approx([(1.0 + AMPLITUDE * sector) / 3.0] * 3, abs=1e-4)
    assert loads.positions.least_share == pytest.approx([(1.0 - AMPLITUDE * sector) / 3.0] * 3, abs=1e-4)
    places = np.degrees(loads.positions.angle) % 120.0
    assert min(places, 120.0 - places) < 3.0  # where a planet is on the side of its load
    assert (
        as_data({"stage_1": loads})["stage_1"]["positions"]["load_sharing_factor"] == loads.positions.factor
    )


def test_a_part_of_a_turn_is_stated(model):
    found = positions(model, result_of(0.4))
    assert found.turns == pytest.approx(0.4, abs=1e-9)
    assert "less than all positions" in position_words(
        as_data(planet_loads(model, result_of(0.4)))["stage_1"]["positions"]
    )


def test_positions_with_little_load_do_not_count(model):
    """Shares follow from the ratio of forces, but below half of the largest load they are not of interest."""
    whole, fading = (positions(model, result_of(1.0, least=least)) for least in (1.0, 0.0))
    assert fading.factor == pytest.approx(whole.factor, abs=2e-4)
    assert positions(model, result_of(1.0).isel(time=slice(0, 1))) is None


@pytest.mark.parametrize("missing", ["angle[carrier]", f"mesh_phase[{MESHES[0]}]"])
def test_nothing_without_angle_or_phase(model, missing):
    assert positions(model, result_of(1.0).drop_vars(missing)) is None


def test_few_samples_per_period_have_no_mean():
    forces = np.ones((30, 3))
    assert not len(shares_at_positions(np.arange(30) / 5.0, forces)[0])
    assert len(shares_at_positions(np.arange(30) / 10.0, forces)[0])
