# SPDX-License-Identifier: Apache-2.0
"""Results that a report computes from the model: slow roll of every mesh, modes, Campbell diagram.

The loads are those of the first scenario at t = 0. Results that cannot be computed (for example loads that no
tooth carries) are omitted with a remark.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError, SolverError
from pitchpoint.core.progress import silent
from pitchpoint.core.status import INCONSISTENT

if TYPE_CHECKING:
    from collections.abc import Iterable

    import xarray as xr
    from numpy.typing import NDArray

    from pitchpoint.core.progress import Progress
    from pitchpoint.model.components.law import Law
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario
    from pitchpoint.system.system import System
    from pitchpoint.viz.report.build import MeshCycleData, ModeData

LINEAR = 2
"""Work units of a report in addition to slow rolls: matrices of the linear system, Campbell diagram."""
SPEEDS = 41
MOMENTS = 1001
"""Number of times at which the speed of a drive is evaluated."""


def with_rolls(
    model: Model, cycles: dict[str, tuple[MeshCycleData, float | None]], progress: Progress
) -> tuple[dict[str, MeshCycleData], list[str]]:
    """Add transmission errors and load sharing to mesh cycles (with the reference stiffness [N/m])."""
    from pitchpoint.core.status import INTERRUPTED
    from pitchpoint.report.rolls import (
        ALL_POINTS,
        LARGE,
        POINTS_OF_LARGE,
        from_roll,
        periods_to_roll,
        points_per_period,
        points_to_roll,
    )
    from pitchpoint.solvers.quasistatic.roll import roll_through
    from pitchpoint.system.compile import compile_model

    plain = {name: data for name, (data, _) in cycles.items()}
    scenario = loaded_scenario(model)
    found = dict(plain)
    notes: list[str] = []
    try:
        steady = at_start(model, scenario) if model.bodies else model
    except PitchpointError as error:
        return found, [f"No slow roll: {error}."]
    fewer: list[str] = []
    rolled, left = rolled_meshes(model, cycles)
    if left:
        notes.append(
            f"Slow rolls of {len(rolled) + left} meshes would take too long: the first {len(rolled)} are "
            "computed. Use a scenario with a slow roll for the others."
        )
    for k, name in enumerate(rolled):
        data, unit = cycles[name]
        try:
            system = compile_model(steady, scenario)
            still = replace(scenario, quasi_static=None) if scenario is not None else None
            most = points_to_roll(system.sizes["nd"])
            periods = periods_to_roll(model, name, most)
            points = points_per_period(periods, most)
            if periods * points < (whole := periods_to_roll(model, name)) * points_per_period(whole):
                fewer.append(name)
            part = partial(_part_of, progress, k, len(rolled) + LINEAR)
            roll = roll_through(system, still, points, periods, mesh=name, others=False, progress=part)
            if roll.status == INTERRUPTED:  # an incomplete report was not requested
                raise KeyboardInterrupt
            if roll.sentence != "finished":
                notes.append(f"{name}: the slow roll stopped: {roll.sentence}.")
            notes += [f"{note}." for note in roll.notes]
            if len(roll.position) > 2:
                found[name] = from_roll(model, name, data, unit, system, roll, points)
        except PitchpointError as error:
            notes.append(f"{name}: no slow roll: {error}.")
        progress(k + 1, len(rolled) + LINEAR, name)
    if fewer:
        notes.append(
            f"Slow rolls have at most {POINTS_OF_LARGE} points instead of {ALL_POINTS}, because the machine "
            f"has more than {LARGE} coordinates: {', '.join(fewer)}. "
            "A scenario with a slow roll sets its own number."
        )
    return found, notes


def _part_of(progress: Progress, before: int, parts: int, done: float, total: float, note: str = "") -> None:
    """Progress callback for one of several equal parts."""
    progress(before + done / total, parts, note)


def rolled_meshes(model: Model, meshes: Iterable[str]) -> tuple[list[str], int]:
    """Meshes rolled for a report, and the number of further meshes that could be rolled."""
    from pitchpoint.report.rolls import MAX_MESHES

    turning = [name for name in meshes if rolls(model, name)]
    return turning[:MAX_MESHES], len(turning[MAX_MESHES:])


def rolls(model: Model, mesh: str) -> bool:
    """Whether both gears of a mesh are on bodies and one of these rotates."""
    bodies = [model.body_of(g) for g in model.every_mesh[mesh].gears]
    return all(bodies) and any(model.bodies[str(b)].moves != "fixed" for b in bodies)


def loaded_scenario(model: Model) -> Scenario | None:
    """Scenario that defines loads and drives: a slow roll, else a time response, else a sweep."""
    for kind in ("quasi_static", "time", "sweep"):
        for scenario in model.scenarios.values():
            if scenario.kind == kind:
                return scenario
    return None


def at_start(model: Model, scenario: Scenario | None) -> Model:
    """Model with loads constant at their initial values: angle-dependent loads would vary during the roll."""
    from pitchpoint.model.components.law import Balance, Constant
    from pitchpoint.solvers.operating_point import operating_point
    from pitchpoint.system import evaluate
    from pitchpoint.system.compile import compile_model

    changing = [
        name
        for name, load in model.loads.items()
        if load.torque is not None and not isinstance(load.torque, Constant | Balance)
    ]
    if not changing:
        return model
    point = operating_point(compile_model(model, scenario), scenario)
    row = evaluate.observe(point.system, point.state)
    found = {n: float(row[point.system.layout.channel(f"torque[{n}]")]) for n in changing}
    return model.replace_all({f"loads.{name}.torque": value for name, value in found.items()})


def linear_parts(
    model: Model, progress: Progress = silent, before: int = 0
) -> tuple[ModeData | None, xr.Dataset | None, list[str]]:
    """Modes about the loaded state and Campbell data over the speed of the first body in mesh.

    `before` is the number of completed work units reported to `progress`.
    """
    from pitchpoint.analysis.campbell_ranking import select_modes
    from pitchpoint.solvers.campbell import follow_modes
    from pitchpoint.solvers.campbell_dataset import campbell_dataset
    from pitchpoint.solvers.linear_system import linearise
    from pitchpoint.solvers.modal import find_modes
    from pitchpoint.system.compile import compile_model
    from pitchpoint.viz.report.build import ModeData

    if not model.bodies:
        return None, None, []
    scenario = loaded_scenario(model)
    parts = [partial(_part_of, progress, before + k, before + LINEAR) for k in range(LINEAR)]
    try:
        system = compile_model(model, scenario)
        linear = linearise(system, scenario, progress=parts[0])
        found = find_modes(system, scenario, linear=linear)
        modes = ModeData(
            names=found.names,
            frequency=found.frequency.tolist(),
            damping_ratio=found.damping_ratio.tolist(),
            held=held_bodies(scenario),
            total=found.total,
            components=found.groups.components,
            strain_share=found.energies.strain,
        )
        body = reference_body(model)
        top = highest_speed(system, body, found.frequency) if body else 0.0
        if body is None or not top > 0.0:
            return modes, None, []
        speeds = np.linspace(0.0, top, SPEEDS)
        followed = follow_modes(system, speeds, body, scenario, progress=parts[1], linear=linear)
        reached = speeds_of_scenarios(system, None, body)
        operating = (min(reached), max(reached)) if reached else None
        data = campbell_dataset(system, followed, operating=operating)
    except PitchpointError as error:
        return None, None, [f"No modes: {error}."]
    # modes far above the excitation would compress the scale of the others
    reach = 1.2 * float(np.max(data["excitation_order"].values, initial=0.0)) * top / (2.0 * math.pi)
    low = float(np.min(np.where(followed.frequency > 0.0, followed.frequency, np.inf), initial=np.inf))
    if not (followed.frequency.size and low <= reach):
        return modes, None, []
    return modes, select_modes(data, None, (0.0, reach)), []


def held_bodies(scenario: Scenario | None) -> list[str]:
    """Bodies with a prescribed motion in a scenario."""
    return [] if scenario is None else list(dict.fromkeys([*scenario.drive, *scenario.hold]))


def reference_body(model: Model) -> str | None:
    """First rotating body with a gear in mesh."""
    in_mesh = {g for mesh in model.every_mesh.values() for g in mesh.gears}
    for name, body in model.bodies.items():
        if body.moves != "fixed" and in_mesh & {*body.gears, *body.bevel_gears}:
            return name
    return None


def highest_speed(system: System, body: str, frequency: Any) -> float:
    """End of the Campbell diagram [rad/s]: 1.2 times the highest speed of all scenarios.

    If no scenario rotates the body: speed at which the slowest mesh frequency exceeds every mode.
    """
    from pitchpoint.solvers.gear_trains import mesh_orders
    from pitchpoint.solvers.initial_state.start import body_rates

    scenarios = model_of(system).scenarios.values()
    reached = max((highest_of_scenario(system, s, body) for s in scenarios), default=0.0)
    if reached > 0.0:
        return 1.2 * reached
    orders = mesh_orders(system, body_rates(system, body)).values()
    lowest = min((o for o in orders if o > 0.0), default=math.inf)
    return 1.2 * 2.0 * math.pi * float(np.max(frequency, initial=0.0)) / lowest


def speeds_of_scenarios(system: System, scenario: str | None, body: str) -> list[float]:
    """Highest speeds of the body in the scenario, or in all scenarios [rad/s]."""
    known = model_of(system).scenarios
    chosen = known.values() if scenario is None else [known[scenario]]
    found = [highest_of_scenario(system, one, body) for one in chosen]
    return [speed for speed in found if speed > 0.0]


def model_of(system: System) -> Model:
    """Model from which a system of a report was compiled."""
    if system.model is None:
        raise SolverError("the system was not compiled from a model", INCONSISTENT)
    return system.model


def highest_of_scenario(system: System, scenario: Scenario, body: str) -> float:
    """Highest speed of a body in a scenario [rad/s], if the model file defines it."""
    from pitchpoint.model.scenario import Scenario

    speeds = [scenario.speed, *({name: speed} for name, speed in prescribed(system, scenario))]
    reached = 0.0
    for given in speeds:
        ratios = model_of(system).start_speeds(Scenario(speed=dict(given)))
        reached = max(reached, abs(ratios.get(body, 0.0)))
    return reached


def prescribed(system: System, scenario: Scenario) -> list[tuple[str, float]]:
    """Highest prescribed speeds of bodies [rad/s]: drives, and the end of a sweep."""
    from pitchpoint.solvers.gear_trains import mesh_orders
    from pitchpoint.solvers.initial_state.start import body_rates

    end = scenario.duration or 0.0
    found = [(name, _fastest(drive, end)) for name, drive in scenario.drive.items()]
    sweep = scenario.sweep
    if sweep is not None and sweep.speed is not None:
        found.append((sweep.body, sweep.speed[1]))
    elif sweep is not None and sweep.mesh_frequency is not None:
        order = mesh_orders(system, body_rates(system, sweep.body, scenario))[
            model_of(system).sweep_mesh(scenario)
        ]
        found.append((sweep.body, 2.0 * math.pi * sweep.mesh_frequency[1] / order if order > 0.0 else 0.0))
    return [(name, speed) for name, speed in found if speed > 0.0]


def _fastest(drive: Drive, duration: float) -> float:
    """Highest speed of a drive up to the end of the scenario [rad/s]; 0 if its law is Python code."""
    moments = np.linspace(0.0, duration, MOMENTS)
    if drive.speed is not None:
        return float(np.max(np.abs(_values(drive.speed, moments, "angular_speed"))))
    if drive.angle is not None and duration > 0.0:
        return float(np.max(np.abs(np.diff(_values(drive.angle, moments, "angle")))) / moments[1])
    return 0.0


def _values(law: Law, moments: NDArray[np.float64], dimension: str) -> NDArray[np.float64]:
    """Values of a law at some times; zeros if it can only be evaluated in a run."""
    from pitchpoint.core.formula.formula import Formula
    from pitchpoint.model.components.law import Constant, FormulaLaw, TableLaw

    if isinstance(law, Constant):
        return np.full(moments.size, law.value)
    if isinstance(law, TableLaw):
        return np.interp(moments, law.abscissa, law.values)
    if isinstance(law, FormulaLaw):
        rest = (0.0,) * (len(law.variables) - 1)
        formula = Formula.parse(law.text, law.variables, dimension)
        return np.array([float(formula(t, *rest)) for t in moments])
    return np.zeros(moments.size)
