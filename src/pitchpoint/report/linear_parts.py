# SPDX-License-Identifier: Apache-2.0
"""Modes and Campbell diagrams of a report: one of each per set of bodies with prescribed motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.progress import silent
from pitchpoint.report.statics import loaded_scenario, part_of
from pitchpoint.viz.quantities import amount

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.linear_system import Linearised
    from pitchpoint.system.system import System
    from pitchpoint.viz.report.build import ModeData

MAX_CONDITIONS = 3
"""Number of sets of prescribed motions whose modes a report shows."""
UNITS_OF_WORK = 2
"""Work units per set: matrices of the linear system, Campbell diagram."""
SPEEDS, FEW_SPEEDS = 41, 21
"""Speeds of a diagram, and of one with rotors in the wind."""


@dataclass(frozen=True)
class Condition:
    """Scenarios with the same prescribed motions and engaged clutches, so that their modes are the same.

    Attributes
    ----------
    scenarios
        Names; the modes are those about the loaded state of the first one.
    held
        Bodies with prescribed motion, which do not vibrate.
    engaged
        Clutches and brakes that these scenarios engage.
    same
        All scenarios of the model with these motions and clutches: they give the operating range.
    """

    scenarios: tuple[str, ...]
    held: tuple[str, ...]
    same: tuple[str, ...]
    engaged: tuple[str, ...] = ()


@dataclass
class LinearParts:
    """Modes and Campbell diagrams by the names of their scenarios.

    Attributes
    ----------
    modes, campbells
        A sentence instead of a diagram gives the reason why there is none.
    remarks
        Remarks for the summary.
    """

    modes: dict[str, ModeData] = field(default_factory=dict)
    campbells: dict[str, xr.Dataset | str] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)


def held_bodies(scenario: Scenario | None) -> list[str]:
    """Bodies with a prescribed motion in a scenario."""
    return [] if scenario is None else list(dict.fromkeys([*scenario.drive, *scenario.hold]))


def _condition(scenario: Scenario) -> tuple[frozenset[str], frozenset[str] | None]:
    """Bodies with a prescribed motion, and engaged clutches; None: by their capacities."""
    engaged = scenario.engaged
    return frozenset(held_bodies(scenario)), None if engaged is None else frozenset(engaged)


def conditions_of(model: Model, used: Iterable[str] = ()) -> list[Condition]:
    """Sets of prescribed motions in the scenarios of some results.

    Parameters
    ----------
    model
        The model.
    used
        Scenarios of the results; slow rolls and unknown names do not count. Without any: the scenario with
        the loads of the report.
    """
    known = model.scenarios
    names = [n for n in dict.fromkeys(used) if n in known and known[n].kind != "quasi_static"]
    if not names:
        chosen = loaded_scenario(model)
        names = [n for n, own in known.items() if own is chosen]
    found: dict[Any, list[str]] = {}
    for name in names:
        found.setdefault(_condition(known[name]), []).append(name)
    conditions = [
        Condition(
            scenarios=tuple(group),
            held=tuple(held_bodies(known[group[0]])),
            same=tuple(n for n, own in known.items() if _condition(own) == kind),
            engaged=known[group[0]].engaged or (),
        )
        for kind, group in found.items()
    ]
    return conditions or [Condition(scenarios=(), held=(), same=())]


def linear_parts(
    model: Model,
    conditions: Sequence[Condition] | None = None,
    progress: Progress = silent,
    before: int = 0,
    *,
    diagrams: bool = True,
) -> LinearParts:
    """Modes about the loaded state and Campbell diagram for each set of prescribed motions.

    Parameters
    ----------
    model
        The model.
    conditions
        As from `conditions_of`, the default.
    progress, before
        Progress callback, and the number of work units completed before.
    diagrams
        Whether to compute Campbell diagrams, too.
    """
    found = LinearParts()
    if not model.bodies:
        return found
    listed = conditions_of(model) if conditions is None else list(conditions)
    if len(listed) > MAX_CONDITIONS:
        left = ", ".join(name for one in listed[MAX_CONDITIONS:] for name in one.scenarios)
        found.remarks.append(
            f"Modes and Campbell diagrams of {len(listed)} sets of prescribed motions"
            f"{' and engaged clutches' if any(one.engaged for one in listed) else ''} would take too long: "
            f"the first {MAX_CONDITIONS} are computed, without those of {left}."
        )
    listed = listed[:MAX_CONDITIONS]
    known = {name for one in listed for name in one.same}
    others = tuple(n for n, own in model.scenarios.items() if n not in known and own.kind != "quasi_static")
    whole = before + UNITS_OF_WORK * len(listed)
    for k, one in enumerate(listed):
        parts = [part_of(progress, before + UNITS_OF_WORK * k + i, whole) for i in range(UNITS_OF_WORK)]
        name = ", ".join(one.scenarios)
        try:
            system, linear = _add_modes(found, name, model, one, others, parts[0])
            if diagrams:
                found.campbells[name] = _diagram(system, one, linear, found.modes[name].frequency, parts[1])
        except PitchpointError as error:
            of = f" of {name}" if len(listed) > 1 else ""
            what = "No Campbell diagram" if name in found.modes else "No modes"
            found.remarks.append(f"{what}{of}: {error}.")
    return found


def _add_modes(
    found: LinearParts,
    name: str,
    model: Model,
    one: Condition,
    others: tuple[str, ...],
    progress: Progress,
) -> tuple[System, Linearised]:
    """Add the modes of one set of prescribed motions; `others` are scenarios with further sets."""
    from pitchpoint.solvers.linear_system import linearise, rates_of
    from pitchpoint.solvers.modal import find_modes
    from pitchpoint.solvers.modes.unstable import is_undamped, sources
    from pitchpoint.solvers.over_speed import over_speed
    from pitchpoint.system.compile import compile_model
    from pitchpoint.viz.report.build import ModeData

    scenario = model.scenarios[one.scenarios[0]] if one.scenarios else None
    system = compile_model(model, scenario)
    linear = linearise(system, scenario, progress=progress)
    in_wind = next(iter(model.wind_rotors.values()), None)
    turning = linear
    if in_wind is not None:
        rates = rates_of(linear, in_wind.hub.partition(".")[0], scenario)
        turning = over_speed(linear, rates).reference
    modes = find_modes(system, scenario, linear=turning)
    found.modes[name] = ModeData(
        names=modes.names,
        frequency=modes.frequency.tolist(),
        damping_ratio=modes.damping_ratio.tolist(),
        scenarios=one.scenarios,
        others=others,
        held=one.held,
        engaged=one.engaged,
        total=modes.total,
        components=modes.groups.components,
        strain_share=modes.energies.strain,
        at=linear.at,
        sources=sources(turning, modes),
        undamped=is_undamped(linear),
    )
    return system, linear


def _diagram(
    system: System, one: Condition, linear: Linearised, frequency: Sequence[float], progress: Progress
) -> xr.Dataset | str:
    """Campbell diagram up to 1.2 times the highest speed, or the reason why there is none."""
    from pitchpoint.analysis.campbell_ranking import select_modes
    from pitchpoint.report.campbell import body_of_speeds, highest_speed
    from pitchpoint.report.operating_range import model_of, operating_range
    from pitchpoint.solvers.campbell import follow_modes
    from pitchpoint.solvers.campbell_dataset import campbell_dataset

    model = model_of(system)
    body = body_of_speeds(model, [model.scenarios[name] for name in (*one.scenarios, *one.same)])
    if body is None:
        return "No body rotates."
    if not frequency:
        return "There are no modes."
    scenario = model.scenarios[one.scenarios[0]] if one.scenarios else None
    operating = operating_range(system, body, [model.scenarios[name] for name in one.same])
    top = 1.2 * operating[1] if operating else highest_speed(system, body, frequency)
    if not 0.0 < top < math.inf:
        return (
            f"No scenario rotates {body}, and it turns no mesh, so its speeds are not known; use pitchpoint "
            "campbell with --speeds."
        )
    # rotors in the wind require an equilibrium at every speed and azimuth
    speeds = np.linspace(0.0, top, FEW_SPEEDS if model.wind_rotors else SPEEDS)
    followed = follow_modes(system, speeds, body, scenario, progress=progress, linear=linear)
    data = campbell_dataset(system, followed, operating=operating)
    # modes far above the excitation would compress the scale of the others
    order = float(np.max(data["excitation_order"].values, initial=0.0))
    reach = 1.2 * order * top / math.tau
    low = float(np.min(np.where(followed.frequency > 0.0, followed.frequency, np.inf), initial=np.inf))
    if not low <= reach:
        lowest = f"the lowest natural frequency, {amount(low, 'Hz')}, is" if low < math.inf else "modes are"
        return (
            f"No critical speed up to {amount(top, 'rad/s')} of {body}: {lowest} above the highest "
            f"excitation frequency, {amount(order * top / math.tau, 'Hz')}."
        )
    data.attrs |= {"scenario": ", ".join(one.scenarios), "held": ", ".join(one.held)}
    return select_modes(data, None, (0.0, reach))
