# SPDX-License-Identifier: Apache-2.0
"""The helical pair on bearings (12 degrees of freedom), speed sweeps, and a stiffness table."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path
from typing import Any

from benchmarks.rows import Row, cpu_seconds, in_turn

HERE = Path(__file__).parent
STEPS = 100_000


def pair_runs() -> dict[str, Any]:
    """A started run of the 12-DOF pair for both width integrals."""
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.solvers.implicit import generalized_alpha
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.system.compile import compile_model

    model = load_model(HERE / "pair_12dof.yaml")
    runs = {}
    for width in ("slices", "exact"):
        system = compile_model(model.replace("meshes.stage.width", width), "steady")
        start = prepare_start(system, model.scenarios["steady"])
        runs[width] = generalized_alpha.start(start.system, start.state, 5e-6)
        runs[width].advance(2000)
    return runs


def rows(bare_rate: float) -> list[Row]:
    """Measure, given the steps per second of the bare loop in this run."""
    runs = pair_runs()
    taken = in_turn({width: lambda r=run: r.advance(STEPS) for width, run in runs.items()})
    rate = {width: STEPS / seconds for width, seconds in taken.items()}
    loop = f"bare loop {bare_rate:.3g} steps/s in this run"
    return [
        Row("pair-12dof", rate["slices"], "steps/s", ">= 700000", f"11 slices, h 5 us; {loop}"),
        Row("pair-12dof against bare loop", rate["slices"] / bare_rate, "times", ">= 0.05", loop),
        Row("pair-12dof exact width", rate["exact"], "steps/s", "", "exact width integral, same run"),
        Row("exact width against 11 slices", rate["exact"] / rate["slices"], "times", ">= 1", "same run"),
        *sweep_rows(),
        stiffness_row(),
    ]


def sweep_rows() -> list[Row]:
    """100 speeds, 200 mesh periods each, up and down, 100 steps per period."""
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.sweep.speed import run_sweep
    from pitchpoint.system.compile import compile_model

    found = []
    for name, file, target in (
        ("sweep 2 DOF", "pair_2dof.yaml", "<= 2"),
        ("sweep 12 DOF", "pair_12dof.yaml", "<= 15"),
    ):
        model = load_model(HERE / file)
        scenario = model.scenarios["sweep"]
        assert scenario.sweep is not None
        short = replace(
            scenario, sweep=replace(scenario.sweep, points=2, settle_periods=1, measure_periods=1)
        )
        system = compile_model(model, scenario)
        run_sweep(system, short)
        begun = time.perf_counter()
        done = run_sweep(system, scenario)
        wall = time.perf_counter() - begun
        text = f"wall time, warm; {done.steps} steps, {len(done.jumps)} jumps"
        found.append(Row(name, wall, "s", target, text))
    return found


def stiffness_row() -> Row:
    """Energy method, 1000 points along the path of contact."""
    from pitchpoint.contact.stiffness.energy import energy_compliance
    from pitchpoint.io.yaml_model import load_model

    pair = load_model(HERE / "pair_2dof.yaml").pairs["stage"]
    energy_compliance(pair, points=1000)
    taken = cpu_seconds(lambda: energy_compliance(pair, points=1000), 9)
    return Row("energy stiffness, 1000 points", taken * 1e3, "ms", "<= 5", "both gears, one pass")
