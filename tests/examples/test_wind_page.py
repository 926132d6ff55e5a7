# SPDX-License-Identifier: Apache-2.0
"""The page on wind: its Python runs as it is printed, and its numbers are right."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp

TEXT = (Path(__file__).parents[2] / "docs" / "wind.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```python\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


@pytest.fixture(scope="module")
def names(tmp_path_factory: pytest.TempPathFactory) -> dict:
    found: dict = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("wind"))
        for block in BLOCKS:
            exec(block, found)
    return found


def test_numbers_of_the_gust(names: dict) -> None:
    gust = names["site"].operating_gust(11.4)
    peak = names["field"].velocity([names["hub"]], 25.25)[0, 0]
    assert f"the hub has {peak:.2f} m/s: the gust of {gust.amplitude:.2f} m/s" in TEXT


def test_calls_of_the_table_exist(names: dict) -> None:
    site, wind_class = names["site"], names["wind_class"]
    for call in re.findall(r"`((?:site|wind_class)\.\w+\([^`]*\))`", TEXT):
        scope = {"site": site, "wind_class": wind_class, "speed": 12.0, "hub_height": 90.0}
        assert eval(call, scope) is not None


def test_deviations_of_the_box(names: dict) -> None:
    sigma = names["wind_class"].normal_deviation(12.0)
    deviation = names["box"].velocity.std(axis=0, dtype=float)
    for component, share in ((1, 0.8), (2, 0.5)):
        np.testing.assert_allclose(deviation[..., component], share * sigma, rtol=1e-4)


def test_files_contain_the_same_wind(names: dict) -> None:
    at = [[0.0, 3.0, 77.0], [20.0, -60.0, 150.0]]
    whole = pp.WindField(box=pp.add_mean(names["box"], names["mean"]))
    np.testing.assert_allclose(names["again"].velocity(at, 5.0), whole.velocity(at, 5.0), atol=1e-3)
    assert (names["fluctuations"].velocity == names["box"].velocity).all()


def test_pictures_of_a_box(names: dict) -> None:
    box = names["box"]
    over_time, plane = pp.plot(box), pp.plot(box, "plane")
    assert [trace.name for trace in over_time.data] == ["u, downwind", "v, to the left", "w, upward"]
    middle = box.velocity[:, 15, 15, 0]
    assert (over_time.data[0].y.max(), over_time.data[0].y.min()) == pytest.approx(
        (middle.max(), middle.min())
    )
    np.testing.assert_allclose(plane.data[0].z, box.velocity[0, :, :, 0], atol=0.006)
    assert (plane.layout.xaxis.title.text, plane.layout.yaxis.title.text) == ("y [m]", "z [m]")
