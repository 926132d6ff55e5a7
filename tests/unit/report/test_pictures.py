# SPDX-License-Identifier: Apache-2.0
"""Every kind of result has its picture, from memory and from its file; names that do not exist list the others."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report import result_pictures
from pitchpoint.report.main_channels import main_channels
from pitchpoint.report.result_kinds import KINDS, kind_of
from pitchpoint.solvers.contact_analysis.on_shafts import ContactsOnShafts
from pitchpoint.viz.picture import Picture
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.report_data import pair

TEXT = (
    TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.05 s")
    .replace("points: 81", "points: 4")
    .replace("settle_periods: 200, measure_periods: 50", "settle_periods: 20, measure_periods: 10")
    + "  up: {drive: {driver: {speed: '150 + 2000*t'}}, duration: 0.2 s, sample_rate: 20 kHz}\n"
    + "  roll: {quasi_static: {mesh: stage, points: 40}}\n"
)
CONTACT = TEXT.replace("    transmission_error: {cosine: [1.0e-6, 0.5e-6]}", "").replace(
    "stiffness: {law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]}", "contact: {level: flexible, planes: 5}"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("pictures")
    (made / "pair.yaml").write_text(TEXT)
    return made


@pytest.fixture(scope="module")
def results() -> dict[str, xr.Dataset]:
    """One result of each kind, in memory."""
    model = loads_model(TEXT)

    def system(name: str) -> Any:
        return pp.compile_model(model, name)

    steady = system("steady")
    run = pp.solve_time(steady)
    varied = [{"meshes.stage.damper.ratio": ratio} for ratio in (0.03, 0.06, 0.1)]
    contact = pp.solve_contact(loads_model(CONTACT), torque=[50.0, 100.0, 150.0], positions=12)
    return {
        "time": run,
        "analysis": pp.analyse(run, "amplitude_spectrum", channel=["mesh_force[stage]", "normal_force[stage]"]),
        "modes": pp.solve_modal(steady),
        "campbell": pp.solve_campbell(steady, np.linspace(0.0, 400.0, 5), "driver"),
        "frequency_response": pp.solve_frequency_response(
            steady, ["transmission_error[stage]"], ["mesh_force[stage]", "driver.spin"], [500.0, 2000.0]
        ),
        "mesh_response": pp.solve_mesh_response(
            steady, ["mesh_force[stage]"], "driver", np.linspace(100.0, 400.0, 7)
        ),
        "equilibrium": pp.solve_equilibrium(steady),
        "quasi_static": pp.solve_quasistatic(system("roll")),
        "sweep": pp.sweep_speed(system("sweep")),
        "cases": pp.cases_dataset(pp.run_cases(model, varied, "steady")),
        "contact": contact,
    }


def test_every_kind_has_a_function() -> None:
    for kind in [*KINDS, "analysis"]:
        assert kind == "time" or callable(getattr(result_pictures, f"{kind}_figures"))


def test_every_result_has_a_picture(results: dict[str, xr.Dataset]) -> None:
    # relief designs take longer: tests/unit/viz/test_relief_plot.py
    assert set(results) | {"relief"} == {*KINDS, "analysis"}
    for kind, data in results.items():
        assert kind_of(data) == kind
        figure = pp.plot(data)
        assert len(figure.data) > 0, kind
        with pytest.raises(PitchpointError, match=r"has no picture 'nothing'.*there are \w+"):
            pp.plot(data, "nothing")
