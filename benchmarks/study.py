# SPDX-License-Identifier: Apache-2.0
"""A tolerance study of the two-stage starter: slow rolls of 200 variants on two cores."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

from benchmarks.rows import Row

CORES = 2
PLAN = """\
model: gearbox.yaml
scenario: roll
samples: 200
factors:
  a_1: {type: tolerance, path: parameters.a_1, limits: [-20 um, 20 um], capability: 1.33}
  a_2: {type: tolerance, path: parameters.a_2, limits: [-25 um, 25 um], capability: 1.33}
  allowance: {type: normal, path: parameters.allowance, deviation: 5 um}
  torque: {type: normal, path: parameters.input_torque, deviation: 5 %, apply: multiply}
results:
  te: {channel: "transmission_error[stage_1]", statistic: peak_to_peak}
  force: {channel: "mesh_force[stage_2]", statistic: magnitude}
  bearing: {channel: "bearing_force[middle_1.radial]", statistic: max}
"""
ROLL = "\n  roll: {speed: {input: input_speed}, quasi_static: {mesh: stage_1, points: 16}}\n"


def rows() -> list[Row]:
    """Wall time of the whole study with its files; the kernels are loaded by one case before."""
    from pitchpoint.cli.new import starter_text
    from pitchpoint.core.status import OK
    from pitchpoint.io.study_store import StudyFolder
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.io.yaml_plan import load_study
    from pitchpoint.model.reading.plan import model_path
    from pitchpoint.sweep.study.check import check_study
    from pitchpoint.sweep.study.run import Record, compute_cases, evaluated, planned
    from pitchpoint.sweep.study.summary import study_dataset

    with tempfile.TemporaryDirectory() as name:
        here = Path(name)
        (here / "plan.yaml").write_text(PLAN, encoding="utf-8")
        (here / "gearbox.yaml").write_text(starter_text("two-stage").rstrip() + ROLL, encoding="utf-8")
        plan = load_study(here / "plan.yaml")
        study = check_study(plan, load_model(model_path(plan)))
        cases = planned(study)
        evaluated(study, cases[0][0])
        folder = StudyFolder(here / "study")
        folder.begin("", "")
        known: dict[str, Record] = {}
        begun, used = time.perf_counter(), time.process_time()
        compute_cases(study, cases, known.__setitem__, keep=folder.write, jobs=CORES)
        study_dataset(study, cases, known)
        wall, cpu = time.perf_counter() - begun, time.process_time() - used
    assert {record["status"] for record in known.values()} == {OK} and len(known) == 201
    text = f"slow rolls of 16 points on {CORES} cores, files and sensitivities included; CPU time {cpu:.0f} s"
    return [Row("tolerance study, 200 variants of a two-stage gearbox", wall, "s", "<= 60", text)]
