# SPDX-License-Identifier: Apache-2.0
"""Every kind of result has its picture, from memory and from its file; unknown names list the others."""

from __future__ import annotations

import html
import json
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
from pitchpoint.report import notebook
from pitchpoint.report.result_kinds import KINDS, kind_of
from pitchpoint.solvers.contact_analysis.on_shafts import ContactsOnShafts
from tests.support.model_files import TORSIONAL_PAIR

TEXT = (
    TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.05 s")
    .replace("points: 81", "points: 4")
    .replace("settle_periods: 200, measure_periods: 50", "settle_periods: 20, measure_periods: 10")
    + "  up: {drive: {driver: {speed: '150 + 2000*t'}}, duration: 0.2 s, sample_rate: 20 kHz}\n"
    + "  roll: {quasi_static: {mesh: stage, points: 40}}\n"
)
CONTACT = TEXT.replace("    transmission_error: {cosine: [1.0e-6, 0.5e-6]}", "").replace(
    "stiffness: {law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]}",
    "contact: {level: flexible, planes: 5}",
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
        "analysis": pp.analyse(
            run, "amplitude_spectrum", channel=["mesh_force[stage]", "normal_force[stage]"]
        ),
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


def test_every_result_has_a_picture(results: dict[str, xr.Dataset]) -> None:
    # relief designs take longer: tests/unit/viz/test_relief_plot.py; studies: tests/unit/cli/test_study.py
    assert set(results) | {"relief", "study"} == {*KINDS, "analysis"}
    for kind, data in results.items():
        assert kind_of(data) == kind
        figure = pp.plot(data)
        assert len(figure.data) > 0, kind
        with pytest.raises(PitchpointError, match=r"has no picture 'nothing'.*there are \w+") as caught:
            pp.plot(data, "nothing")
        assert str(caught.value).count("there are") == 1, kind
        assert "this cases" not in str(caught.value)


COMMANDS = {
    "time": ("run", "--scenario", "steady"),
    "modes": ("modes", "--scenario", "steady"),
    "campbell": ("campbell", "--scenario", "steady", "--speeds", "0..3000rpm"),
    "frequency_response": (
        *("frf", "--scenario", "steady", "-i", "transmission_error[stage]", "--to", "2 kHz"),
        *("-r", "mesh_force[stage]", "-r", "driver.spin"),
    ),
    "mesh_response": (
        *("frf", "--scenario", "steady", "-r", "mesh_force[stage]", "--mesh-orders", "3"),
        *("--speed-of", "driver", "--from-speed", "1000 rpm", "--to-speed", "4000 rpm", "--points", "7"),
    ),
    "quasi_static": ("run", "--scenario", "roll"),
    "sweep": ("sweep", "--scenario", "sweep"),
    "cases": ("run", "--scenario", "steady", "--vary", "meshes.stage.damper.ratio=0.03,0.06,0.1"),
}


def test_files_have_the_pictures_of_their_datasets(folder: Path, results: dict[str, xr.Dataset]) -> None:
    for kind, (command, *options) in COMMANDS.items():
        path = folder / f"{kind}.h5"
        assert 0 == run_command([command, str(folder / "pair.yaml"), *options, "-o", str(path), "--quiet"])
        with pp.open_result(path) as data:
            assert kind_of(data) == kind
            figure, expected = pp.plot(data), pp.plot(results[kind])
            if kind != "campbell":  # the command also marks the operating speed
                assert len(figure.data) == len(expected.data), kind
            assert figure.layout.yaxis.title.text == expected.layout.yaxis.title.text, kind


def test_a_run_shows_its_main_channels_first(results: dict[str, xr.Dataset]) -> None:
    figure = pp.plot(results["time"])
    names = [trace.name for trace in figure.data]
    assert names[:2] == ["speed, driver", "speed, driven"]
    assert "mesh force, stage" in names
    speed = results["time"]["speed[driver]"].values * 30.0 / np.pi
    assert figure.data[0].y.max() == pytest.approx(speed.max(), rel=1e-6)
    assert figure.layout.yaxis.title.text == "[rpm]"


def test_named_pictures_are_those_of_the_report(results: dict[str, xr.Dataset]) -> None:
    run = results["time"]
    force = pp.plot(run, "mesh_force")
    assert force.data[0].y.max() == pytest.approx(float(run["mesh_force[stage]"].max()), rel=1e-6)
    assert pp.plot(run, "mesh_force[stage]").data[0].name == "mesh force, stage"
    spectrum = pp.plot(run, "spectrum")
    assert spectrum.data[0].name == "mesh force, stage"
    assert pp.plot(run, "order_spectrum[deflection[stage]]").data[0].name == "deflection, stage"
    assert pp.plot(run, "tooth_force").layout.yaxis.title.text == "tooth force [N]"
    assert pp.plot(run, "elastic_energy").data[0].name == "elastic energy, stage"
    with pytest.raises(PitchpointError, match=r"'order_map'; there are spectrum\[mesh_force\[stage\]\]"):
        pp.plot(run, "order_map")  # the speed is constant
    up = pp.solve_time(pp.compile_model(loads_model(TEXT), "up"))
    assert pp.plot(up, "order_map").data[0].type == "heatmap"
    contact = results["contact"]
    assert pp.plot(contact, "harris_map").layout.xaxis.title.text.startswith("torque")
    assert pp.plot(contact, "contact_pattern[gear 2]") != pp.plot(contact, "contact_pattern")
    one = contact.isel(torque=[0]).assign(misalignment=0.0)  # as in equilibrium with shafts
    shafts = ContactsOnShafts(meshes={"one": one, "two": one})
    assert {trace.name for trace in pp.plot(shafts).data} >= {"one", "two"}
    assert pp.plot(shafts, "load_share[two]").data
    title = pp.plot(results["sweep"], "mesh_force").layout.yaxis.title.text
    assert title.startswith("maximum magnitude of mesh force")
    assert pp.plot(results["equilibrium"]).data[0].x[0] == pytest.approx(
        float(results["equilibrium"]["mesh_force[stage]"]), rel=1e-12
    )


def test_modes_of_the_same_name_are_those_of_the_campbell_diagram(results: dict[str, xr.Dataset]) -> None:
    """`frequency` and `name` mean the same in both: the damped mesh mode at the speed of the scenario."""
    modes, campbell = results["modes"], results["campbell"]
    mesh = modes["frequency"].values[modes["name"].values == "mesh mode of stage"]
    curve = campbell["frequency"].values[:, campbell["name"].values == "mesh mode of stage"]
    assert curve == pytest.approx(np.full_like(curve, mesh[0]), rel=1e-6)
    assert modes["frequency"].attrs["long_name"] == campbell["frequency"].attrs["long_name"]


def test_what_has_no_picture(results: dict[str, xr.Dataset]) -> None:
    with pytest.raises(PitchpointError, match="a dataset over place is not a result"):
        pp.plot(xr.Dataset({"a": ("place", [1.0])}))
    with pytest.raises(PitchpointError, match="no channel with two samples"):
        pp.plot(results["time"].isel(time=slice(1)))
    with pytest.raises(PitchpointError, match=r"spectrum \(limit 64\)"):
        pp.plot(results["time"].isel(time=slice(20)), "spectrum")


def test_notebooks_show_the_picture_without_requests(results: dict[str, xr.Dataset]) -> None:
    for kind in ("sweep", "modes", "campbell", "frequency_response"):
        text = notebook.dataset_html(results[kind])
        frames = re.findall(r'<iframe [^>]*title="([^"]*)"[^>]*srcdoc="([^"]*)"', text)
        assert frames[0][0] == kind.replace("_", " ")
        page = html.unescape(frames[0][1])
        assert "default-src 'none'" in page
        assert not re.search(r"<(script|link|img|iframe)[^>]*(src|href)=", page)
        assert len(frames[0][1]) < 2e6
        name = pp.plot(results[kind]).data[0].name
        assert json.dumps(name) in page, kind
