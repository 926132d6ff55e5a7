# SPDX-License-Identifier: Apache-2.0
"""The NREL 5 MW turbine of the examples, with wind and pitch control, as a unit: bits of our run, speed."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.solvers.exported_run import started
from pitchpoint.solvers.fixed_steps import start_fixed_steps
from pitchpoint.solvers.step_choice import choose_step
from pitchpoint.system.compile import compile_model
from tests.support.fmi_host import Unit
from tests.support.fmu_models import need_linker

MODEL = Path(__file__).parents[2] / "examples" / "wind-turbine" / "model.yaml"


@pytest.mark.study
def test_the_turbine_as_a_unit(tmp_path):
    need_linker()
    model = pp.load_model(str(MODEL))
    unit = Unit(pp.export_fmu(model, tmp_path / "turbine.fmu", "production"), tmp_path)
    assert unit.library.stat().st_size < 4e6
    system = compile_model(model, "production")
    start = started(system, system.scenario)
    h, _ = choose_step(start, system.scenario)
    own = start_fixed_steps(start.system, start.state, system.scenario, h)
    one, references = unit.instance().initialise(), unit.references("output")
    ratios = []
    for part in range(6):
        begun = time.process_time()
        want = own.advance(50, every=10).rows[:, 1:]
        between = time.process_time()
        got = one.steps(5 * part, 5, 10 * h, references)
        ratios.append((between - begun) / (time.process_time() - between))
        assert np.array_equal(got.view(np.int64), np.ascontiguousarray(want).view(np.int64))
    assert np.median(ratios) > 0.9
    one.free()
