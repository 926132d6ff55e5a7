# SPDX-License-Identifier: Apache-2.0
"""Slow rolls that a report computes from the model, and the scenario of their loads.

The loads are constant, those of the operating point of the first scenario at t = 0. Results that cannot be
computed (for example loads that no tooth carries) are omitted with a remark.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.words import ranges

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.quasistatic.roll import Roll
    from pitchpoint.viz.report.build import MeshCycleData


IDLE = 1e-9
"""Torque relative to the largest one up to which a mesh carries no load."""


def with_rolls(
    model: Model, cycles: dict[str, tuple[MeshCycleData, float | None]], progress: Progress, after: int = 0
) -> tuple[dict[str, MeshCycleData], list[str]]:
    """Add transmission errors and load sharing to mesh cycles (with the reference stiffness [N/m]).

    `after` is the number of work units that follow, for `progress`.
    """
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
    from pitchpoint.solvers.operating_point import operating_point
    from pitchpoint.solvers.quasistatic.loads import loads_at_state
    from pitchpoint.solvers.quasistatic.roll import roll_through
    from pitchpoint.system.compile import compile_model

    plain = {name: data for name, (data, _) in cycles.items()}
    scenario = loaded_scenario(model)
    found = dict(plain)
    notes: list[str] = []
    rolled, left = rolled_meshes(model, cycles)
    idle = [name for name in rolled if name in idle_meshes(model, scenario)]
    if idle:
        rolled = [name for name in rolled if name not in idle]
        notes.append(f"{ranges(idle)}: no slow roll, since they carry no load in this scenario.")
    try:
        if not rolled:
            return found, notes
        given = compile_model(model, scenario)
        system = loads_at_state(given, operating_point(given, scenario).state)
    except PitchpointError as error:
        return found, [f"No slow roll: {error}."]
    fewer: list[str] = []
    common = meshes_rolled_together(model, rolled)
    shared: dict[str, tuple[Roll, int]] = {}
    if left:
        notes.append(
            f"Slow rolls of {len(rolled) + left} meshes would take too long: the first {len(rolled)} are "
            "computed. Use a scenario with a slow roll for the others."
        )
    for k, name in enumerate(rolled):
        data, unit = cycles[name]
        try:
            still = replace(scenario, quasi_static=None) if scenario is not None else None
            most = points_to_roll(system.sizes["nd"])
            periods = periods_to_roll(model, name, most)
            points = points_per_period(periods, most)
            if periods * points < (whole := periods_to_roll(model, name)) * points_per_period(whole):
                fewer.append(name)
            part = part_of(progress, k, len(rolled) + after)
            first = common[name][0]
            if first not in shared:
                same = common[name][1:]
                roll = roll_through(system, still, points, periods, mesh=name, others=same, progress=part)
                shared[first] = roll, points
            roll, points = shared[first]
            if roll.status == INTERRUPTED:  # an incomplete report was not requested
                raise KeyboardInterrupt
            if roll.sentence != "finished":
                notes.append(f"{name}: the slow roll stopped: {roll.sentence}.")
            notes += [said for note in roll.notes if (said := f"{note}.") not in notes]
            if len(roll.position) > 2:
                found[name] = from_roll(model, name, data, unit, system, roll, points)
        except PitchpointError as error:
            notes.append(f"{name}: no slow roll: {error}.")
        progress(k + 1, len(rolled) + after, name)
    if fewer:
        notes.append(
            f"Slow rolls have at most {POINTS_OF_LARGE} points instead of {ALL_POINTS}, because the machine "
            f"has more than {LARGE} coordinates: {', '.join(fewer)}. "
            "A scenario with a slow roll sets its own number."
        )
    return found, notes


def meshes_rolled_together(model: Model, meshes: Sequence[str]) -> dict[str, list[str]]:
    """Meshes with the same period in one train, by mesh, such as those of all planets: one roll for all."""
    from pitchpoint.report.rolls import equal_periods

    found: dict[str, list[str]] = {}
    for name in meshes:
        if name not in found:
            group = [
                name,
                *(n for n in meshes if n not in found and n != name and equal_periods(model, name, n)),
            ]
            found |= dict.fromkeys(group, group)
    return found


def part_of(progress: Progress, before: int, parts: int) -> Progress:
    """Progress callback for one of several equal parts."""
    return partial(_report_part, progress, before, parts)


def _report_part(
    progress: Progress, before: int, parts: int, done: float, total: float, note: str = ""
) -> None:
    progress(before + done / total, parts, note)


def rolled_meshes(model: Model, meshes: Iterable[str]) -> tuple[list[str], int]:
    """Meshes rolled for a report, and the number of further meshes that could be rolled."""
    from pitchpoint.report.rolls import MAX_MESHES

    turning = [name for name in meshes if rolls(model, name)]
    return turning[:MAX_MESHES], len(turning[MAX_MESHES:])


def idle_meshes(model: Model, scenario: Scenario | None) -> set[str]:
    """Meshes without torque in a scenario in which others have one, such as the pairs of other gears."""
    from pitchpoint.report.static_power import static_power

    if scenario is None:
        return set()
    try:
        links = static_power(model, replace(scenario, sweep=None))["links"]
    except PitchpointError:
        return set()
    torques = {name: links[name]["torques"][0] for name in model.every_mesh if name in links}
    largest = max((abs(t) for t in torques.values() if t), default=0.0)
    return {name for name, t in torques.items() if t is not None and largest and abs(t) <= IDLE * largest}


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
