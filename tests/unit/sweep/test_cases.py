# SPDX-License-Identifier: Apache-2.0
"""Independent cases: same bits in any number of threads, failures with a status, the dataset of it all."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

from pitchpoint.core import status as st
from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.sweep.cases import CaseResult, cases_dataset, grid, run_case, run_cases
from tests.support.cli_files import TORSION

TORQUE, RATIO = "loads.input.torque", "meshes.stage.damper.ratio"


@pytest.fixture(scope="module")
def model() -> Model:
    text = TORSION.replace("duration: 0.5 s", "duration: 0.01 s").replace("points: 81", "points: 3")
    text = text.replace("settle_periods: 200, measure_periods: 50", "settle_periods: 2, measure_periods: 2")
    return loads_model(text + "  roll: {quasi_static: {points: 12}}\n")


def test_threads_change_no_bit_and_no_order(model: Model) -> None:
    cases = grid({TORQUE: ["50 N m", "100 N m", 150.0], RATIO: [0.02, 0.05]})
    one, four = (run_cases(model, cases, "steady", jobs=n) for n in (1, 4))
    assert [r.index for r in four] == list(range(6))
    assert [dict(r.values) for r in four] == cases
    for a, b in zip(one, four, strict=True):
        assert (a.status, a.steps) == (b.status, b.steps)
        np.testing.assert_equal(a.channels, b.channels)  # nan where a statistic does not exist
    alone = run_case(model, cases[3], "steady")
    np.testing.assert_equal(alone.channels, four[3].channels)
    assert four[2].numbers[TORQUE] == (100.0, "N m")


def test_a_failed_case_has_a_status_and_stops_nobody(model: Model) -> None:
    cases: list[dict[str, Any]] = [
        {},
        {TORQUE: float("nan")},
        {"meshes.stage.center_distance": "300 mm"},
        {"no.such.path": 1},
        {TORQUE: "150 N m * sqrt(0.005 - t)"},
        {RATIO: 0.1},
    ]
    found = run_cases(model, cases, "steady", jobs=2)
    assert [r.status for r in found] == [
        st.OK, st.REFUSED, st.REFUSED, st.REFUSED, st.NOT_FINITE, st.OK,
    ]  # fmt: skip
    assert "not a finite number" in found[1].sentence
    assert "tips apart" in found[2].sentence
    assert "no" in found[3].sentence
    assert "t = 0.00499" in found[4].sentence


def test_values_that_only_fit_together(model: Model) -> None:
    """Centre distance and profile shifts change at once."""
    case = {
        "meshes.stage.center_distance": "151 mm",
        "gears.g1.profile_shift_coefficient": 0.2,
        "gears.g2.profile_shift_coefficient": 0.1,
    }
    (found,) = run_cases(model, [case], "steady")
    assert found.status == st.OK
    assert found.numbers["meshes.stage.center_distance"] == (0.151, "m")


def test_sink_and_progress_see_every_case(model: Model) -> None:
    seen: list[int] = []
    told: list[float] = []
    run_cases(
        model,
        grid({RATIO: [0.02, 0.03, 0.04]}),
        "steady",
        progress=lambda done, total, note="": told.append(done),
        sink=lambda result: seen.append(result.index),
    )
    assert sorted(seen) == [0, 1, 2]
    assert told == [1, 2, 3]


def test_interruption_keeps_what_is_finished(model: Model) -> None:
    seen: list[int] = []

    def interrupt(result: CaseResult) -> None:
        seen.append(result.index)
        if len(seen) == 1:
            raise KeyboardInterrupt

    found = run_cases(model, grid({RATIO: [0.02, 0.03, 0.04, 0.05]}), "steady", jobs=1, sink=interrupt)
    assert found[0].status == st.OK
    assert {r.status for r in found[1:]} <= {st.OK, st.INTERRUPTED}
    assert found[-1].status == st.INTERRUPTED
    assert [r.index for r in found if r.status == st.OK] == seen[: sum(r.status == st.OK for r in found)]
    stop = threading.Event()
    stop.set()
    assert run_case(model, {}, "steady", stop=stop).status == st.INTERRUPTED


def test_dataset(model: Model) -> None:
    data = cases_dataset(run_cases(model, grid({TORQUE: ["100 N m", "150 N m"], RATIO: [0.05]}), "steady"))
    assert data["deflection[stage]"].dims == ("case", "statistic")
    assert data["deflection[stage]"].attrs["symbol"] == "u_bt − e"
    assert data[TORQUE].values.tolist() == [100.0, 150.0]
    assert data[TORQUE].attrs["units"] == "N m"
    assert bool(np.isfinite(data["mesh_force[stage]"]).all())
    swept = cases_dataset(run_cases(model, [{RATIO: 0.05}, {RATIO: float("inf")}], "sweep"))
    assert dict(swept.sizes) == {"case": 2, "statistic": 4, "direction": 2, "point": 3}
    assert swept["mesh_frequency"].values[0, 0] == pytest.approx([1000.0, 3000.0, 5000.0])
    assert bool(np.isnan(swept["deflection"][1]).all())
    rolled = cases_dataset(run_cases(model, [{RATIO: 0.05}], "roll"))
    # half the backlash of 0.1 mm, the static error and 150 N m on the mean stiffness
    assert float(rolled["transmission_error[stage]"].sel(statistic="mean")[0]) == pytest.approx(
        55.5e-6, rel=0.01
    )


def test_unknown_scenario(model: Model) -> None:
    with pytest.raises(SolverError, match="steady, sweep, roll"):
        run_cases(model, [{}], "stedy")
