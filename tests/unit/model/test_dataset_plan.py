# SPDX-License-Identifier: Apache-2.0
"""Plans of data sets: their cases, and every problem of a bad plan with its line."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model
from pitchpoint.io.yaml_plan import load_plan
from pitchpoint.model.dataset_plan import DatasetPlan
from pitchpoint.model.reading.dataset_plan import check_plan
from tests.support.dataset_files import CASES, PLAN, written


def plan_of(folder: Path, text: str = PLAN) -> DatasetPlan:
    return load_plan(written(folder, text))


def problems(folder: Path, text: str) -> list[str]:
    with pytest.raises(ModelError) as caught:
        plan_of(folder, text)
    return [str(p) for p in caught.value.problems]


def test_cases_are_all_combinations_with_all_seeds(tmp_path: Path) -> None:
    plan = plan_of(tmp_path)
    cases = list(plan.cases())
    assert len(plan) == len(cases) == CASES
    assert [c.index for c in cases] == list(range(CASES))
    assert [c.seed for c in cases[:4]] == [1, 2, 1, 2]
    assert [c.labels["damping"] for c in cases[:6:2]] == ["usual", "weak", "weak"]
    assert cases[0].changes == {"loads.input.torque": "100 N m"}
    assert cases[-1].changes == {"loads.input.torque": "150 N m", "meshes.stage.damper.ratio": 0.03}
    assert cases[-1].labels == {"torque": "150 N m", "damping": "weak"}
    assert plan.samples == 100
    assert plan.sample_rate == 20000.0
    assert plan.jitter == {"loads.input.torque": 0.01}
    assert plan.oversampling == 2


def test_lists_of_one_condition_are_combined(tmp_path: Path) -> None:
    text = PLAN.replace("weak: {", "weak: {loads.output.torque: [1 N m, 2 N m], ")
    plan = plan_of(tmp_path, text)
    assert len(plan) == 2 * 5 * 2
    weak = [lv.changes for lv in plan.factors["damping"] if lv.label == "weak"]
    assert weak[1] == {"loads.output.torque": "1 N m", "meshes.stage.damper.ratio": 0.03}


def test_without_factors_there_is_one_case_per_seed(tmp_path: Path) -> None:
    text = PLAN[: PLAN.index("factors:")] + PLAN[PLAN.index("seeds:") :]
    assert [c.changes for c in plan_of(tmp_path, text).cases()] == [{}, {}]


BAD = """\
title: bad
modell: x
factors:
  torque: {loads.input.torque: []}
  seed: {a: {}}
  other: 3
  two: {a.b: [1], c.d: [2]}
  again: {x: {a.e: 1}}
  twice: {y: {a.e: 2}}
  words: {z: 5}
jitter: {loads.input.torque: 200 %}
seeds: 0
sample_rate: 20 mm
length: -1 s
oversampling: 1.5
channels:
  v: {type: observation, channel: "mesh_force[stage]", noise: {snr: 20, rms: 3}}
  t: {type: tach, body: driver, pulses: 10}
  w: {type: tacho, body: driver, pulses: 0}
"""


def test_all_problems_at_once_with_their_lines(tmp_path: Path) -> None:
    found = problems(tmp_path, BAD)
    for line, word in (
        (2, "modell (line 2): is an unknown key; did you mean model?"),
        (4, "is an empty list"),
        (5, "is a reserved column name"),
        (6, "factors.other (line 6): 3 is not a mapping"),
        (7, "has lists for 2 paths"),
        (9, "changes a.e, as does again"),
        (10, "factors.words.z (line 10): 5 is not a mapping of paths"),
        (11, "'200 %' is out of range (limit >= 0 and <= 1)"),
        (12, "seeds (line 12): 0 is out of range"),
        (13, "'mm' is not the unit of a frequency"),
        (14, "length (line 14): '-1 s' is out of range"),
        (15, "is not a whole number"),
        (17, "give exactly one of snr, rms"),
        (18, "did you mean tacho?"),
        (19, "pulses (line 19): 0 is out of range"),
    ):
        assert any(f"(line {line})" in p and word in p for p in found), (line, word, found)
    assert any("model" in p and "is missing" in p for p in found)
    assert len(found) == 16


@pytest.mark.parametrize("text", ["", "3", "- a\n", "a: [", "\tx: 1"])
def test_what_is_no_plan(tmp_path: Path, text: str) -> None:
    assert problems(tmp_path, text)


def test_what_the_model_does_not_know(tmp_path: Path) -> None:
    text = PLAN.replace("title: pair, some torques", "scenario: stead")
    text = text.replace("[100 N m, 150 N m]", "[100 m, 150 N m]").replace(
        "{meshes.stage.damper.ratio: [", "{meshes.stag.damper.ratio: ["
    )
    text = text.replace("jitter: {", "jitter: {title: 1 %, ").replace('"speed[driven]"', '"speed[drive]"')
    text = text.replace("body: driver", "body: driverr")
    plan = plan_of(tmp_path, text)
    model = load_model(tmp_path / "pair.yaml")
    with pytest.raises(ModelError) as caught:
        check_plan(plan, model, ("mesh_force[stage]", "speed[driven]", "angle[driver]"))
    found = [str(p) for p in caught.value.problems]
    assert [p.partition("(line ")[2].partition(")")[0] for p in found] == [
        "1",
        "4",
        "7",
        "7",
        "9",
        "15",
        "17",
    ]
    assert "did you mean steady?" in found[0]
    assert "factors.torque.loads.input.torque[0]" in found[1]
    assert "'m' is not the unit of a torque" in found[1]
    assert "does not exist" in found[2]
    assert "jitter.title (line 9): is not a number of the model" in found[4]
    assert "did you mean speed[driven]" in found[5]
    assert "did you mean driver" in found[6]


def test_the_only_scenario_over_time_is_meant(tmp_path: Path) -> None:
    model = load_model(written(tmp_path).replace("plan.yaml", "pair.yaml"))
    assert check_plan(plan_of(tmp_path), model, ()).scenario == "steady"
    two = model.replace("scenarios", {**model.scenarios, "other": model.scenarios["steady"]})
    with pytest.raises(ModelError, match="is missing; name a time response; there are: steady, other"):
        check_plan(plan_of(tmp_path), two, ())
