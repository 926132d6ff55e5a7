# SPDX-License-Identifier: Apache-2.0
"""Sliders of a live page: which are offered, and their ranges."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.report import live
from pitchpoint.solvers import tunable
from tests.support.fmu_models import pair


def test_each_offered_number_is_studied_once(monkeypatch):
    """Sums of those that change the same words are checked, too; other failures are not hidden."""
    studied, summed = [], []
    place, check = tunable._place, tunable._check_sum
    monkeypatch.setattr(tunable, "_place", lambda *given: studied.append(given[3]) or place(*given))
    monkeypatch.setattr(
        tunable, "_check_sum", lambda *given: summed.append([p.name for p in given[3:]]) or check(*given)
    )
    _, _, places = live.offered(pair("adams"), "steady")
    names = [f"meshes.stage.{word}" for word in ("backlash.normal", "center_distance")]
    assert [p.name for p in places][:2] == names
    assert len(studied) == len(set(studied)) and {p.name for p in places} <= set(studied)
    assert names in summed

    def fails(*_):
        raise SolverError("the disk is full", 1)

    monkeypatch.setattr(live, "tunable_places", fails)
    with pytest.raises(SolverError, match="disk"):
        live.offered(pair("adams"), "steady")


@pytest.mark.parametrize("speed", [3300.0, -3300.0])
def test_the_slider_of_the_initial_speed_is_ordered(speed):
    model = pair("adams").replace("scenarios.steady.speed", {"driver": speed})
    run, _ = live.begin_export(model, "steady")
    (slider,) = live._initial_speed(run, live.fmu_model(run, (), "live", "pair"), model, "steady")
    assert slider["least"] < slider["start"] < slider["most"] and slider["start"] * speed > 0.0
