# SPDX-License-Identifier: Apache-2.0
"""Events and notes of a run in the dataset of `solve_time`."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.model_files import TORSIONAL_PAIR


def test_events_have_a_dimension_of_their_own() -> None:
    text = TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.02 s, events: [pair_entry]")
    model = loads_model(text)
    scenario = model.scenarios["steady"]
    data = solve_time(compile_model(model, scenario))
    # 25 Hz, 50 teeth, 0.02 s
    assert data.sizes["event"] == pytest.approx(25, abs=1)
    assert set(data["event_name"].values) == {"pair_entry[stage]"}
    assert set(data["event_direction"].values) == {1}
    np.testing.assert_allclose(np.diff(data["event_time"]), 1.0 / 1250.0, rtol=0.02)
    assert data["mesh_force[stage]"].dims == ("time",)
    assert isinstance(data.attrs["notes"], str)
