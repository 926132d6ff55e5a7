# SPDX-License-Identifier: Apache-2.0
"""The data set of the PHM 2009 rig: a share of its thousand cases on two cores, and what all would take."""

from __future__ import annotations

import dataclasses
import tempfile
import time
from pathlib import Path
from typing import Any

from benchmarks.rows import Row

PLAN = Path(__file__).parents[1] / "examples" / "phm-2009-rig" / "plan.yaml"
EVERY = 83
"""Every so many cases are computed: all speeds, loads and faults come up in turn."""
CORES = 2


def rows() -> list[Row]:
    """Wall time of a share of the plan with files and all, for a thousand cases."""
    from pitchpoint.cli.dataset import checked, header_of
    from pitchpoint.core.status import OK
    from pitchpoint.io.dataset_store import DatasetFolder
    from pitchpoint.io.yaml_plan import load_plan
    from pitchpoint.sweep.dataset import CaseRecord, compute_case, compute_cases, key_maker

    plan, model = checked(load_plan(PLAN), False, True)
    key_of = key_maker(plan, model)
    cases = [(case, key_of(case)) for case in plan.cases()]
    share = cases[::EVERY][: len(cases) // EVERY // CORES * CORES]
    compute_case(
        dataclasses.replace(plan, length=0.01, settle_time=0.0), model, *share[0]
    )  # loads the kernels
    done: list[CaseRecord] = []
    with tempfile.TemporaryDirectory() as name:
        folder = DatasetFolder(Path(name) / "set")
        folder.begin("", "")

        def keep(record: Any) -> None:
            folder.write(record, header_of(plan, model, "", record), plan.sample_rate, plan.samples)

        begun = time.perf_counter()
        compute_cases(plan, model, share, done.append, keep=keep, jobs=CORES)
        wall = time.perf_counter() - begun
        size = sum(p.stat().st_size for p in folder.cases.iterdir()) / len(share)
    assert {record.status for record in done} == {OK}
    steps = sum(record.steps for record in done)
    minutes = wall / len(share) * len(cases) / 60.0
    text = f"{len(share)} of {len(cases)} cases on {CORES} cores in {wall:.3g} s, {size / 1e6:.2g} MB each"
    return [
        Row("PHM 2009 rig, 1000 cases of 1 s at 25.6 kHz", minutes, "min", "<= 10", text),
        Row("PHM 2009 rig, rate of both cores", steps / wall, "steps/s", "", "24 degrees of freedom, adams"),
    ]
