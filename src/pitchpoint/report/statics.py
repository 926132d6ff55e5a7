# SPDX-License-Identifier: Apache-2.0
"""Slow rolls that a report computes from the model, and the scenario of their loads.

The loads are constant, those of the operating point of the first scenario at t = 0. Results that cannot be
computed (for example loads that no tooth carries) are omitted with a remark.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.words import ranges

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.report.rolls import Train
    from pitchpoint.solvers.quasistatic.roll import Roll
    from pitchpoint.system.system import System
    from pitchpoint.viz.report.build import MeshCycleData


IDLE = 1e-9
"""Torque relative to the largest one up to which a mesh carries no load."""


@dataclass
class Rolled:
    """Results of slow rolls.

    Attributes
    ----------
    cycles
        Mesh cycles by mesh.
    planets
        Load sharing of planetary stages (`system.planet_loads.as_data`).
    notes
        Notes for the summary.
    count
        Number of rolls.
    """

    cycles: dict[str, MeshCycleData]
    planets: dict[str, dict[str, Any]] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    count: int = 0


def with_rolls(
    model: Model, cycles: dict[str, tuple[MeshCycleData, float | None]], progress: Progress, after: int = 0
) -> Rolled:
    """Add transmission errors and load sharing to mesh cycles (with the reference stiffness [N/m]).

    `after` is the number of work units that follow, for `progress`.
    """
    from pitchpoint.core.status import INTERRUPTED
    from pitchpoint.report.rolls import MAX_ROLLS, from_roll, plan_of
    from pitchpoint.solvers.operating_point import operating_point
    from pitchpoint.solvers.quasistatic.loads import loads_at_state
    from pitchpoint.solvers.quasistatic.roll import roll_through
    from pitchpoint.system.compile import compile_model

    scenario = loaded_scenario(model)
    found = Rolled({name: data for name, (data, _) in cycles.items()})
    train, names, notes = _loaded_train(model, cycles, scenario)
    groups = meshes_rolled_together(model, names, train)
    groups, left = groups[:MAX_ROLLS], groups[MAX_ROLLS:]
    try:
        if not groups:
            return replace(found, notes=notes)
        given = compile_model(model, scenario)
        system = loads_at_state(given, operating_point(given, scenario).state)
    except PitchpointError as error:
        return replace(found, notes=[f"No slow roll: {error}."])
    if left:
        notes.append(
            f"Slow rolls of {len(names)} meshes would take too long: those of "
            f"{ranges(name for group in left for name in group)} are omitted. "
            "Use a scenario with a slow roll."
        )
    fewer: list[str] = []
    refused: dict[str, list[str]] = {}
    still = replace(scenario, quasi_static=None) if scenario is not None else None
    for k, group in enumerate(groups):
        first, part = group[0], part_of(progress, k, len(groups) + after)
        plan = plan_of(model, first, system.sizes["nd"], train)
        whole = plan_of(model, first, 0, train)
        try:
            amounts = plan.points, plan.periods
            roll = roll_through(system, still, *amounts, mesh=first, others=group[1:], progress=part)
            if roll.status == INTERRUPTED:  # an incomplete report was not requested
                raise KeyboardInterrupt
            if roll.sentence != "finished":
                notes.append(f"{ranges(group)}: the slow roll stopped: {roll.sentence}.")
            known = {note.partition(":")[0] for note in notes}
            notes += [f"{note}." for note in roll.notes if str(note).partition(":")[0] not in known]
            if len(roll.position) > 2:
                found.cycles |= {n: from_roll(n, *cycles[n], system, roll, plan) for n in group}
                found.planets |= _planets(model, group, system, roll)
                if plan.periods * plan.points < whole.periods * whole.points:
                    fewer += group
        except PitchpointError as error:
            refused.setdefault(str(error), []).extend(group)
        progress(k + 1, len(groups) + after, first)
    notes += [f"{ranges(meshes)}: no slow roll: {error}." for error, meshes in refused.items()]
    return replace(found, notes=[*notes, *_fewer(fewer)], count=len(groups))


def _planets(model: Model, group: Sequence[str], system: System, roll: Roll) -> dict[str, dict[str, Any]]:
    """Load sharing of the planets whose meshes a roll contains, by the means of its points."""
    from pitchpoint.system.planet_loads import as_data, loads_of_planets

    def mean(channel: str) -> float:
        """Mean over the periods; the last point repeats the first one."""
        return float(roll.rows[:-1, system.layout.channel(channel)].mean())

    loads = loads_of_planets(model, mean)
    return as_data({name: one for name, one in loads.items() if {*one.meshes} & {*group}})


def _fewer(meshes: Sequence[str]) -> list[str]:
    """Remark on rolls with fewer points."""
    from pitchpoint.report.rolls import ALL_POINTS, LARGE, POINTS_OF_LARGE

    if not meshes:
        return []
    return [
        f"Slow rolls have at most {POINTS_OF_LARGE} points instead of {ALL_POINTS}, because the machine "
        f"has more than {LARGE} coordinates: {ranges(meshes)}. "
        "A scenario with a slow roll sets its own number."
    ]


def _loaded_train(
    model: Model, meshes: Iterable[str], scenario: Scenario | None
) -> tuple[Train, list[str], list[str]]:
    """Meshes that move and carry load in a scenario, those to roll, and remarks on the others."""
    from pitchpoint.report.rolls import Train

    idle, locked = idle_meshes(model, scenario), locked_meshes(model, scenario)
    turning, notes = [name for name in meshes if rolls(model, name)], []
    for names, reason in (
        (idle - locked, "since they carry no load in this scenario"),
        (locked, "since the engaged clutches lock their gears"),
    ):
        omitted = ranges(name for name in turning if name in names)
        notes += [f"{omitted}: no slow roll, {reason}."] if omitted else []
    loaded = [name for name in model.every_mesh if name not in idle | locked]
    engaged = None if scenario is None else scenario.engaged
    return Train(loaded, engaged), [name for name in turning if name in loaded], notes


def meshes_rolled_together(
    model: Model, meshes: Sequence[str], train: Train | None = None
) -> list[list[str]]:
    """Groups of meshes with the same period in one train, such as those of all planets: one roll for each."""
    from pitchpoint.report.rolls import ALL, equal_periods

    found: list[list[str]] = []
    for name in meshes:
        same = (group for group in found if equal_periods(model, group[0], name, train or ALL))
        group = next(same, None)
        if group is None:
            found.append([name])
        else:
            group.append(name)
    return found


def part_of(progress: Progress, before: int, parts: int) -> Progress:
    """Progress callback for one of several equal parts."""
    return partial(_report_part, progress, before, parts)


def _report_part(
    progress: Progress, before: int, parts: int, done: float, total: float, note: str = ""
) -> None:
    progress(before + done / total, parts, note)


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


def locked_meshes(model: Model, scenario: Scenario | None) -> set[str]:
    """Meshes of gears without relative rotation while the engaged clutches of a scenario stick."""
    from pitchpoint.report.frequencies import frequencies_of, turning_speeds

    if scenario is None or not scenario.engaged:
        return set()
    moving: set[str] = set()
    loaded = [load.body for load in model.loads.values()]
    geared = [model.body_of(gear) for mesh in model.every_mesh.values() for gear in mesh.gears]
    for body in dict.fromkeys([*loaded, *geared]):
        if body is None or model.bodies[body].moves == "fixed":
            continue
        try:
            meshes = frequencies_of(model, turning_speeds(model, {body: 1.0}, scenario))["meshes"]
        except PitchpointError:  # held by a brake
            continue
        moving |= {name for name, row in meshes.items() if row["frequency"]}
    return set(model.every_mesh) - moving


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
