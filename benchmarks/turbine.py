# SPDX-License-Identifier: Apache-2.0
"""The NREL 5 MW turbine and its gearbox against real time, one core, statistics of all channels."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from benchmarks.rows import Row, cpu_seconds

EXAMPLES = Path(__file__).parent.parent / "examples"
TURBINE = EXAMPLES / "wind-turbine" / "model.yaml"
DRIVE = EXAMPLES / "wind-drive-5mw"
UNSTEADY = {"wind_rotors.rotor.inflow": "dynamic", "wind_rotors.rotor.stall": "dynamic"}
SLOW_AIR = {"wind_rotors.rotor.step": "10 ms"}


def rows() -> list[Row]:
    """Simulated time over CPU time: the turbine with three drive trains, the gearbox alone."""
    unsteady = "elastic blades and tower, dynamic inflow and stall, control, h 20 ms"
    gearbox = "elastic blades and tower, 13 meshes, blade loads every 10 ms, h 0.1 ms"
    found = [
        _row(f"turbine, {text}", _turbine(file, 0.02, UNSTEADY), 600, ">= 20", unsteady)
        for text, file in (("two masses", "two_mass.yaml"), ("rigid ratio", "rigid_ratio.yaml"))
    ]
    for text, file, count in (
        ("torsional gearbox, others 1 ms", "gearbox.yaml", 10),
        ("torsional gearbox", "gearbox.yaml", 1),
        ("gearbox in all directions", "gearbox_all_directions.yaml", 1),
    ):
        run = _turbine(file, 1e-4, SLOW_AIR, count)
        found.append(_row(f"turbine, {text}", run, 3000, ">= 1" if count > 1 else "", gearbox))
    for text, file in (("torsion", "torsion.yaml"), ("all directions", "model.yaml")):
        run = _started(DRIVE / file, "rated", 1e-4, {})
        found.append(_row(f"5 MW gearbox, {text}", run, 5000, ">= 1", "rated, 13 meshes, h 0.1 ms"))
    return found


def _turbine(drive_train: str, step: float, changes: dict[str, str], count: int = 1) -> Any:
    """Started run at 8 m/s."""
    return _started(TURBINE, "production", step, {"include": [drive_train], **changes}, count)


def _started(file: Path, scenario: str, step: float, changes: dict[str, Any], count: int = 1) -> Any:
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.solvers.implicit import gear_part, generalized_alpha
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.system.compile import compile_model

    model = load_model(file, changes=changes)
    start = prepare_start(compile_model(model, scenario), model.scenarios[scenario])
    if count > 1:
        return gear_part.start(start.system, start.state, step, count)
    return generalized_alpha.start(start.system, start.state, step)


def _row(name: str, run: Any, steps: int, target: str, text: str) -> Row:
    """Measure a number of steps after the start has faded."""
    from pitchpoint.solvers.contact_counts import new_counts
    from pitchpoint.solvers.sampling import new_statistics

    sums = new_statistics(run.system.sizes["no"], new_counts(run.system))
    run.advance(steps, statistics=sums)
    taken = cpu_seconds(lambda: run.advance(steps, statistics=sums), 5)
    return Row(name, steps * run.h / taken, "times real time", target, text)
