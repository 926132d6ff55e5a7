# SPDX-License-Identifier: Apache-2.0
"""The page on solids, and the gears of the shovel gearbox as solids."""

from __future__ import annotations

import importlib.util
import math
import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.geometry.solid_file import read_solids, round_inertia
from pitchpoint.io.gear_export import export_gear, export_shaft
from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.masses import masses
from tests.support import stl

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "solids.md").read_text(encoding="utf-8")
MODEL = re.search(r"```yaml\n(.*?)```", PAGE, re.DOTALL)[1]


def script():
    """Module of the example."""
    file = ROOT / "examples" / "shovel-gearbox" / "solids.py"
    spec = importlib.util.spec_from_file_location("shovel_solids", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_file_of_the_page_is_read_and_compared(tmp_path: Path) -> None:
    gear = MODEL.replace("    solid: {file: pinion.stl, unit: 1 mm}\n", "")
    gear = re.sub(r"shafts:.*", "", gear, flags=re.DOTALL)
    (tmp_path / "gear.yaml").write_text(gear)
    pinion = load_model(tmp_path / "gear.yaml").gears["pinion"]
    export_gear(pinion.geometry, tmp_path / "pinion.stl", bore_diameter=0.01)
    export_shaft([(0.1, 0.02, 0.0), (0.05, 0.03, 0.01)], tmp_path / "axle.stl")
    rod = np.roll(shaft_solid([(0.3, 0.03, 0.0)], 60), 1, axis=2)  # along x
    (tmp_path / "lever.stl").write_bytes(stl.binary(1e3 * rod))
    (tmp_path / "model.yaml").write_text(MODEL)
    model = load_model(tmp_path / "model.yaml")
    found = {e["name"]: e for e in masses(model)}
    assert abs(found["pinion"]["differences"]["geometry"]["mass"]) < 2e-4  # 40 points a flank
    assert found["axle"]["differences"]["geometry"]["mass"] == pytest.approx(2.03e-4, rel=1e-2)
    lever = model.body_inertia("lever")
    assert lever.mass == 2.0
    assert lever.place == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)
    moments = lever.about_center()
    own = found["lever"]["sources"]["solid"]["mass"]
    # the rod lies along x of the file, which stays x of the body: z is y of the file
    assert moments[0, 0] == pytest.approx(0.5 * own * 0.015**2, rel=5e-3)  # 60 corners
    across = own * (0.3**2 / 12.0 + 0.015**2 / 4.0)
    assert moments[1, 1] == pytest.approx(across, rel=1e-4)
    assert moments[2, 2] == pytest.approx(across, rel=1e-4)


def test_gears_of_the_shovel_fit_their_centre_distances_without_undercut() -> None:
    gears = script().gears()
    assert list(gears) == ["Z1", "Z2", "Z3", "Z4", "Z5", "Z6"]
    sums = {1: 0.495790, 2: 0.706365, 3: 1.101642}
    for stage, x_sum in sums.items():
        pinion, wheel = gears[f"Z{2 * stage - 1}"], gears[f"Z{2 * stage}"]
        assert pinion.x + wheel.x == pytest.approx(x_sum, abs=5e-7)
        assert pinion.beta == -wheel.beta
        for gear in (pinion, wheel):
            assert not gear.undercut
            assert gear.problems() == []


@pytest.mark.parametrize("name", ["Z5", "Z6"])
def test_solids_of_the_shovel_have_the_mass_of_the_closed_form(name: str, tmp_path: Path) -> None:
    gear = script().gears()[name]
    solid = read_solids(export_gear(gear, tmp_path / "g.stl", n_flank=12, n_slices=12), 1e-3).part()
    exact, found = gear_mass_properties(gear, 1.0), round_inertia(solid)
    assert solid.volume == pytest.approx(exact.mass, rel=2e-3)  # 12 points a flank, slices of 1.7 deg
    assert found.polar == pytest.approx(exact.polar_inertia, rel=4e-3)
    assert found.transverse == pytest.approx(exact.transverse_inertia, rel=4e-3)
    assert abs(found.axis[2]) == pytest.approx(1.0, abs=1e-9)
    assert math.hypot(*solid.center) < 1e-6


@pytest.mark.skipif(importlib.util.find_spec("OCP") is None, reason="OCC (the extra cad) is not installed")
@pytest.mark.slow
def test_step_files_of_the_shovel_agree_to_eight_digits(tmp_path: Path) -> None:
    for _, mass, in_mass, in_inertia in script().write(tmp_path):
        assert mass > 10.0
        assert abs(in_mass) < 1e-8
        assert abs(in_inertia) < 1e-8
