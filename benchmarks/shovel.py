# SPDX-License-Identifier: Apache-2.0
"""The crawler gearbox of a mining shovel: 15 s from rest at full load, one core, every law of contact."""

from __future__ import annotations

import sys
import time
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

from benchmarks.rows import Row

HERE = Path(__file__).parents[1] / "examples" / "shovel-gearbox"
ELASTIC = 3.0
"""Seconds of the gearbox on elastic shafts that are run; the rest continues at the same speed."""


def _levels() -> Any:
    """The script of the example that knows the laws."""
    spec = spec_from_file_location("shovel_levels", HERE / "levels.py")
    assert spec is not None and spec.loader is not None
    module = sys.modules[spec.name] = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _wall(model: Any) -> tuple[float, int]:
    """Wall time of the rated scenario [s] and its steps; everything is compiled before."""
    from pitchpoint.solvers.time import run_time
    from pitchpoint.system.compile import compile_model

    short = {"scenarios.rated.duration": 0.01, "scenarios.rated.settle_time": 0.0}
    run_time(compile_model(model.replace_all(short), "rated"))
    system = compile_model(model, "rated")
    begun = time.perf_counter()
    done = run_time(system)
    assert done.status == 1, done.sentence
    return time.perf_counter() - begun, done.steps


def rows() -> list[Row]:
    """Both detail levels of the example."""
    from pitchpoint.io.yaml_model import load_model

    levels = _levels()
    paper = load_model(HERE / "paper.yaml")
    found = []
    for law in levels.LAWS:
        wall, steps = _wall(levels.with_law(paper, law))
        text = f"rigid shafts, 12 gears, both sides; {steps} steps, {15.0 / wall:.2g} times real time"
        found.append(Row(f"shovel gearbox, 15 s, {law}", wall, "s", "<= 15", text))
    times = {"scenarios.rated.duration": ELASTIC, "scenarios.rated.settle_time": 1.0}
    wall, steps = _wall(load_model(HERE / "model.yaml").replace_all(times))
    text = f"200 degrees of freedom; {steps} steps of {ELASTIC:g} s, start-up included"
    found.append(Row("shovel gearbox on elastic shafts", wall / ELASTIC, "s per s", "", text))
    return found
