# SPDX-License-Identifier: Apache-2.0
"""Remarks of a run on mean speeds that leave the scenario: who is watched, from what to what, and why."""

from __future__ import annotations

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import split_notes
from pitchpoint.io.reading import open_result
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.collect import collect
from pitchpoint.report.notebook import dataset_html
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.speed_drift import watched
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.unit.solvers.test_mean_balance import RPM, gearbox

SPRING = '"100 + 50*angle"'


def watch(text):
    model = loads_model(text)
    scenario = model.scenarios["run"]
    return watched(prepare_start(compile_model(model, scenario), scenario), scenario)


def test_a_train_that_should_keep_its_speed_is_watched():
    assert watch(gearbox("100 N m")) == {"driver": ["in", "out"]}
    assert watch(gearbox("-90 N m", driver="-30 N m")) == {"driver": ["in", "out"]}


INTENDED = {
    "a run-up": gearbox("100 N m", driver="20 N m"),
    "a drive": gearbox("100 N m").replace("speed: {driver: 1500 rpm}", "drive: {driver: {speed: 1500 rpm}}"),
    "held": gearbox("100 N m", more=", hold: [driver]"),
    "a load released after 0.1 s": gearbox('"100*(1 - step(t - 0.1))"'),
    "a brake over time": gearbox("{table: [[0 s, 100 N m], [0.1 s, 300 N m]]}"),
    "at rest": gearbox("100 N m").replace("1500 rpm", "0 rpm"),
}


@pytest.mark.parametrize("name", INTENDED)
def test_runs_that_change_the_speed_on_purpose_are_not_watched(name):
    assert watch(INTENDED[name]) == {}


def test_a_ripple_that_the_window_cuts_is_allowed_for():
    """The window of 0.09 s is three quarters of the period of a wave of 6 % of the speed."""
    text = gearbox('"100*(1 + 0.5*sin(angle))"', more=", settle_time: 0.15 s")
    found = solve_time(compile_model(loads_model(text), "run"))
    mean = found["speed[driver]"].attrs["statistics"][0]
    assert abs(mean / (1500.0 * RPM) - 1.0) > 0.01
    assert not [note for note in split_notes(found.attrs["notes"]) if "of the scenario" in note]


def test_the_remark_is_in_the_terminal_the_file_the_report_and_the_notebook(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "model.yaml").write_text(gearbox(SPRING), encoding="utf-8")
    assert run_command(["run", "model.yaml", "-o", "run.h5"]) == 0
    assert "note: the mean speed of driver is" in " ".join(capsys.readouterr().out.split())
    with open_result(tmp_path / "run.h5") as data:
        data.load()
    said = [note for note in split_notes(data.attrs["notes"]) if note.startswith("the mean speed of driver")]
    assert len(said) == 1
    assert "1500 rpm of the scenario" in said[0]
    _, remarks = collect(loads_model(gearbox(SPRING)), [tmp_path / "run.h5"], lambda *_: None)
    assert any(remark.endswith(said[0]) for remark in remarks)
    assert "the mean speed of driver" in dataset_html(data)
