# SPDX-License-Identifier: Apache-2.0
"""The page on solids, and the gears of the shovel gearbox as solids."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.geometry.shaft_solid import shaft_solid
from pitchpoint.io.gear_export import export_gear, export_shaft
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.inertia import gear_inertia
from pitchpoint.report.masses import masses
from tests.support import stl
from tests.support.occ import needs_occ
from tests.support.scripts import script

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "examples" / "shovel-gearbox" / "solids.py"
PAGE = (ROOT / "docs" / "solids.md").read_text(encoding="utf-8")
MODEL = re.search(r"```yaml\n(.*?)```", PAGE, re.DOTALL)[1]


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


def test_the_shovel_gearbox_takes_its_masses_from_solids(tmp_path: Path, monkeypatch) -> None:
    """The pinion with the broken tooth and its shaft as STL: the model moves with what the solids weigh."""
    example = script(SCRIPT)
    monkeypatch.setattr(example, "GEARS", ("Z5",))
    monkeypatch.setattr(example, "SHAFTS", ("third",))
    model = load_model(ROOT / "examples" / "shovel-gearbox" / "model.yaml")
    drawn = example.write(model, tmp_path, "stl")
    (pinion, *of_pinion), (shaft, *of_shaft) = example.compared(drawn)
    assert (pinion, shaft) == ("Z5", "third")
    mass, in_mass, in_inertia = of_pinion
    # 40 points a flank, slices of half a degree; circles of 180 corners lack 2.0e-4 of their area, 4.1e-4 of
    # its second moment, and the bore of 270 mm takes 1.8 times what the ring about it has
    assert mass == pytest.approx(gear_inertia(model.gears["Z5"])[0], rel=1e-12)
    assert abs(in_mass) < 3.7e-4
    assert abs(in_inertia) < 7.5e-4
    assert of_shaft[1:] == pytest.approx([-2.03e-4, -4.06e-4], rel=1e-2)
    assert gear_inertia(drawn.gears["Z5"])[0] == pytest.approx(mass * (1.0 + in_mass), rel=1e-12)


@needs_occ
@pytest.mark.slow
def test_step_files_of_the_shovel_agree_to_eight_digits(tmp_path: Path) -> None:
    example = script(SCRIPT)
    model = load_model(ROOT / "examples" / "shovel-gearbox" / "model.yaml")
    rows = example.compared(example.write(model, tmp_path))
    assert [row[0] for row in rows] == [*example.GEARS, *example.SHAFTS]
    for name, _, in_mass, in_inertia in rows:
        most = 1e-8 if name in example.GEARS else 1e-12
        assert abs(in_mass) < most
        assert abs(in_inertia) < most
