# SPDX-License-Identifier: Apache-2.0
"""Contact of tooth surfaces: evaluation and steps at each level, contact analysis, table, relief design."""

from __future__ import annotations

import tempfile
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.rows import Row, cpu_seconds

HERE = Path(__file__).parent
STEPS = 20_000
COPIES = 500
"""Records evaluated in one call: few enough for the caches, as a run evaluates the same one each time."""
SHAKEN = 2e-9
"""Differences of the travel between the evaluations [m], as between steps."""
RELIEF = {"amount": (0.0, 30e-6), "length": (1e-3, 8e-3)}
"""Bounds of the tip reliefs of a design [m]."""
LEVELS = {
    "law": "stiffness: {law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.2}",
    "rigid": "contact: {level: rigid}",
    "flexible": "contact: {level: flexible}",
}


def model_of(contact: str, planes: int = 11) -> Any:
    """The helical pair with relief on bearings, with a law or a contact."""
    from pitchpoint.io.yaml_model import loads_model

    text = (HERE / "pair_12dof.yaml").read_text(encoding="utf-8")
    if contact != LEVELS["law"]:
        text = text.replace("    width: slices\n    slices: 11\n", "")
    if "rigid" in contact or "flexible" in contact:
        contact = contact.replace("}", f", planes: {planes}}}")
    return loads_model(text.replace(LEVELS["law"], contact), file=str(HERE / "pair_12dof.yaml"))


def evaluations(model: Any) -> float:
    """CPU time of one evaluation of the mesh at the start of the scenario [s]."""
    from pitchpoint.core.kernel import invoke
    from pitchpoint.elements.gear_mesh import entry
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.system import evaluate
    from pitchpoint.system.compile import compile_model

    start = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    evaluate.residual(start.system, start.state)
    many = np.repeat(start.system.records["gear_mesh"], COPIES)
    many["u0"] += SHAKEN * np.random.default_rng(0).normal(size=COPIES)
    ctl = start.system.workspace.ctl
    taken = cpu_seconds(lambda: invoke(entry, ctl.ctypes.data, many.ctypes.data, COPIES), 5)
    return taken / COPIES


def steps(model: Any) -> float:
    """Steps per second of a time response."""
    from pitchpoint.solvers.implicit import generalized_alpha
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.system.compile import compile_model

    start = prepare_start(compile_model(model, "steady"), model.scenarios["steady"])
    run = generalized_alpha.start(start.system, start.state, 5e-6)
    run.advance(2000)
    return STEPS / cpu_seconds(lambda: run.advance(STEPS), 5)


def table_rows(folder: str) -> tuple[list[Row], Any]:
    """Time and size of a contact table on all cores; the model with it."""
    from pitchpoint.io.contact_table import write_contact_table
    from pitchpoint.model.contact_inputs import contact_inputs
    from pitchpoint.solvers.contact_analysis.precompute import TableRequest, contact_table
    from pitchpoint.sweep.threads import on_all_cores

    model = model_of(LEVELS["flexible"])
    request = TableRequest(torque=200.0, misalignment=2e-3, centre_distance=3e-5)
    begun = time.perf_counter()
    tables = {
        name: contact_table(model, "stage", request, flank, run=on_all_cores)
        for name, flank in (("front", 1), ("back", -1))
    }
    wall = time.perf_counter() - begun
    inputs = contact_inputs(model, "stage", model.meshes["stage"].contact)
    file = write_contact_table(Path(folder, "stage.gcp.h5"), tables, inputs)
    worst = max(table.errors["force"][0] for table in tables.values())
    rows = [
        Row(
            "contact table, both flanks",
            wall,
            "s",
            "<= 10",
            f"all cores; force error rms {100 * worst:.3f} %",
        ),
        Row("size of the table", file.stat().st_size / 1e6, "MB", "<= 10", "both flanks"),
    ]
    return rows, model_of(f"contact: {{level: precomputed, file: {file}}}")


def analysis_rows() -> list[Row]:
    """Contact analysis of 64 positions and 31 planes, and 25 torques with 11 planes."""
    from pitchpoint.solvers.contact_analysis.flank_states import FlankStates

    found = []
    for name, planes, torques, target in (
        ("contact analysis, 64 positions x 31 planes", 31, [100.0], "<= 0.05"),
        ("Harris map of 25 torques, 64 positions", 11, list(np.linspace(10.0, 200.0, 25)), "<= 1"),
    ):
        flanks = FlankStates(model_of(LEVELS["flexible"], planes), "stage")

        def work(flanks: FlankStates = flanks, torques: list[float] = torques) -> None:
            for torque in torques:
                states = flanks.states(np.arange(64) / 64)
                states["by_force"], states["force"] = 1, flanks.force_of(torque)
                flanks.solve(states)

        work()
        found.append(Row(name, cpu_seconds(work, 5), "s", target, "flexible, equilibrium at each position"))
    return found


def relief_row() -> Row:
    """Relief design: amounts and lengths on both gears, five torques, tolerances of both amounts."""
    from pitchpoint.solvers.contact_analysis.relief.design import design_relief
    from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan

    reliefs = [f"gears.{gear}.modifications.both.tip_relief" for gear in ("pinion", "wheel")]
    plan = ReliefPlan(
        vary={f"{relief}.{name}": most for relief in reliefs for name, most in RELIEF.items()},
        torques=list(np.linspace(60.0, 200.0, 5)),
        tolerances={f"{relief}.amount": 2e-6 for relief in reliefs},
        analyses=2000,
    )
    model = model_of(LEVELS["flexible"])
    design_relief(model, "stage", replace(plan, analyses=200))  # the kernels
    begun = time.perf_counter()
    found = design_relief(model, "stage", plan)
    wall = time.perf_counter() - begun
    peer = f"all cores; {found.attrs['analyses']} analyses, 64 positions, 5 torques, 11 planes"
    return Row("relief design of 2000 analyses", wall, "s", "<= 120", peer)


def rows(bare_rate: float) -> list[Row]:
    """Measure, given the steps per second of the bare loop in this run."""
    models = {level: model_of(contact) for level, contact in LEVELS.items()}
    loop = f"bare loop {bare_rate:.3g} steps/s in this run"
    rigid = evaluations(models["rigid"])
    flexible = evaluations(models["flexible"])
    with tempfile.TemporaryDirectory() as folder:
        of_table, models["precomputed"] = table_rows(folder)
        rate = {level: steps(model) for level, model in models.items()}
    return [
        Row("rigid contact, one evaluation", rigid * 1e6, "us", "<= 1", f"11 planes, both flanks; {loop}"),
        Row("flexible contact", 1.0 / flexible, "evaluations/s", ">= 50000", "11 planes, warm; same run"),
        Row("pair-12dof, rigid contact", rate["rigid"], "steps/s", "", loop),
        Row("pair-12dof, flexible contact", rate["flexible"], "steps/s", ">= 20000", loop),
        Row("pair-12dof, pre-computed contact", rate["precomputed"], "steps/s", ">= 400000", loop),
        Row(
            "pre-computed contact against the law",
            rate["precomputed"] / rate["law"],
            "times",
            "",
            "11 slices, same run",
        ),
        *of_table,
        *analysis_rows(),
        relief_row(),
    ]
