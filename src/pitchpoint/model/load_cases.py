# SPDX-License-Identifier: Apache-2.0
"""The load case in effect: its speeds and loads in place of those of the file.

Loads and scenarios with the values of a load case keep the component as given, which is written and replaced.
A scenario may name its own load case: its speeds replace those of the scenario in the model, its loads and
temperature are those of `in_own_load_case`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.checks.references import known, speed_as_written
from pitchpoint.model.components.law import Constant
from pitchpoint.model.frames import split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.speed_ratios import start_speeds

if TYPE_CHECKING:
    from pitchpoint.model.components.load_case import CaseLoad, LoadCase
    from pitchpoint.model.components.lubricant import Lubricant
    from pitchpoint.model.model import Model
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.scenario import Scenario

SECTION = "load_cases"
KEY = "load_case"
"""Key of the load case in effect."""
ROUNDING = 1e-6
"""Excess of the sum of the shares of the time over 1 that is due to rounded numbers."""


def apply_load_case(parts: Parts, report: Reader) -> None:
    """Check all load cases, and put the values of the one in effect into loads and scenarios."""
    for name, case in parts.load_cases.items():
        _check(parts, name, case, report)
    _check_times(parts, report)
    shares = {n: c.load_duration_fraction for n, c in parts.load_cases.items()}
    total = sum(share for share in shares.values() if share is not None)
    if total > 1.0 + ROUNDING:
        report.problem(
            (SECTION,),
            "is the sum of the shares of the time",
            value=f"{100.0 * total:.6g} %",
            limit="100 %",
            remedy="correct load_duration_fraction",
        )
    chosen = parts.load_case
    own = {name: each.load_case for name, each in parts.scenarios.items() if each.load_case is not None}
    for name, named in own.items():
        case = _named(parts, named, ("scenarios", name, KEY), report)
        if case is not None and chosen is None:
            _put_speeds(parts, name, case)
    case = None if chosen is None else _named(parts, chosen, (KEY,), report)
    if case is None:
        return
    speeds = start_speeds(parts, case.speed)[0] if case.speed else {}
    for name, change in case.loads.items():
        load = parts.loads[name]
        parts.loads[name] = replace(load, **_values(load, change, speeds), given=load)
    for name in parts.scenarios:
        _put_speeds(parts, name, case)


def _named(parts: Parts, name: str, at: Place, report: Reader) -> LoadCase | None:
    """Load case that a key names; None if it does not exist or has problems."""
    if at in report.tainted or not known(parts, SECTION, name, at, report):
        return None
    return None if (SECTION, name) in report.tainted else parts.load_cases.get(name)


def _put_speeds(parts: Parts, name: str, case: LoadCase) -> None:
    """Replace the speeds of a scenario by those of a load case."""
    if case.speed:
        scenario = parts.scenarios[name]
        parts.scenarios[name] = replace(_at_speed(scenario, case), given=scenario)


def in_own_load_case(model: Model, scenario: Scenario) -> tuple[Model, Scenario]:
    """Model and scenario in the load case that the scenario names, unless one is in effect for all.

    Parameters
    ----------
    model
        The model.
    scenario
        One of its scenarios or another one.

    Returns
    -------
    tuple of Model, Scenario
        The arguments themselves if nothing differs.

    Raises
    ------
    ModelError
        If the load case does not exist.

    Examples
    --------
    >>> from pitchpoint import Body, Load, LoadCase, Model, Scenario
    >>> from pitchpoint.model.components.load_case import CaseLoad
    >>> peak = LoadCase(loads={"motor": CaseLoad(torque="80 N m")})
    >>> model = Model(
    ...     bodies={"rotor": Body(mass="1 kg", inertia="0.01 kg m^2")},
    ...     loads={"motor": Load(body="rotor", torque="50 N m")},
    ...     load_cases={"peak": peak},
    ...     scenarios={"start": Scenario(load_case="peak", duration="1 s")},
    ... )
    >>> in_own_load_case(model, model.scenarios["start"])[0].loads["motor"].torque.value
    80.0
    """
    if scenario.load_case is None or model.load_case is not None:
        return model, scenario
    changed = model.replace(KEY, scenario.load_case)
    case = changed.load_cases[scenario.load_case]
    if scenario.given is None and case.speed:  # not a scenario of the model, whose speeds are replaced
        scenario = replace(_at_speed(scenario, case), given=scenario)
    return changed, scenario


def _check_times(parts: Parts, report: Reader) -> None:
    """Check that all load cases with a share of the time give it in the same way."""
    timed = [name for name, case in parts.load_cases.items() if case.load_duration is not None]
    for name, case in parts.load_cases.items():
        if timed and case.load_duration_fraction is not None:
            report.problem(
                (SECTION, name, "load_duration_fraction"),
                f"is a share of the time, and {timed[0]} has a load_duration",
                remedy="give load_duration of all load cases, or load_duration_fraction of all",
            )


def shares_of_time(cases: Mapping[str, LoadCase]) -> dict[str, float | None]:
    """Share of the time of every load case; from `load_duration` that of the sum of all.

    Examples
    --------
    >>> from pitchpoint import LoadCase
    >>> shares_of_time({"rated": LoadCase(load_duration="6000 h"), "peak": LoadCase(load_duration="2000 h")})
    {'rated': 0.75, 'peak': 0.25}
    """
    total = sum(case.load_duration or 0.0 for case in cases.values())
    return {
        name: case.load_duration_fraction if case.load_duration is None else case.load_duration / total
        for name, case in cases.items()
    }


def _check(parts: Parts, name: str, case: LoadCase, report: Reader) -> None:
    """Check the names and values of one load case."""
    at: Place = (SECTION, name)
    if at in report.tainted:
        return
    if not (case.speed or case.loads or case.temperature is not None):
        report.problem(
            at, "has neither speed nor loads nor temperature", remedy="give what differs, or remove it"
        )
    for key, group, word in (("speed", "bodies", "body"), ("loads", "loads", "load")):
        for named in getattr(case, key):
            if not parts.has(group, named):
                names = parts.known(group)
                report.problem(
                    (*at, key, named),
                    f"names a {word} that does not exist",
                    value=named[:40],
                    remedy=did_you_mean(named, names) + f"there are {', '.join(sorted(names)) or 'none'}",
                )
    if at in report.tainted:
        return
    speeds, wrong = start_speeds(parts, case.speed) if case.speed else ({}, [])
    for body, right in wrong:
        report.problem(
            (*at, "speed", body),
            "contradicts the other speeds and the gear ratios",
            value=speed_as_written(case.speed[body], (*at, "speed", body), report),
            limit=speed_as_written(right, (*at, "speed", body), report),
            remedy="give one speed of each gear train",
        )
    for load, change in case.loads.items():
        _check_load(parts, (*at, "loads", load), change, speeds, report)


def _check_load(parts: Parts, at: Place, change: CaseLoad, speeds: dict[str, float], report: Reader) -> None:
    """Check the values of one load of a load case."""
    if change.torque is not None and change.power is not None:
        report.problem(at, "gives torque and power together", remedy="give one of them")
    elif change.torque is None and change.power is None and change.force is None:
        report.problem(at, "gives neither torque nor power nor force", remedy="give one, or remove it")
    part = parts.loads.get(str(at[-1]))
    if change.power is None or part is None or split(part.body)[0] not in parts.bodies:
        return
    if not speeds.get(split(part.body)[0]):
        report.problem(
            (*at, "power"),
            f"requires a speed of {part.body}, which is at rest in this load case",
            remedy="add speed: {BODY: 1500 rpm} of a body in its gear train, or give torque",
        )


def _values(load: Any, change: CaseLoad, speeds: dict[str, float]) -> dict[str, Any]:
    """Keys of a load with the values of a load case."""
    found: dict[str, Any] = {}
    torque = change.torque
    if change.power is not None:
        torque = change.power / speeds[split(load.body)[0]]
    if torque is not None:
        found["torque"] = Constant(torque)
    if change.force is not None:
        found["force"] = tuple(Constant(component) for component in change.force)
    return found


def _at_speed(scenario: Scenario, case: LoadCase) -> Scenario:
    """Scenario with the speeds of a load case; a prescribed speed of one of its bodies follows, too."""
    if scenario.sweep is not None:
        return scenario
    drive = {
        body: replace(law, speed=Constant(case.speed[body]))
        if body in case.speed and law.speed is not None
        else law
        for body, law in scenario.drive.items()
    }
    speed = {body: rate for body, rate in case.speed.items() if body not in drive}
    return replace(scenario, speed=speed, drive=drive)


def oil_of(machine: Any) -> Lubricant | None:
    """Lubricant of a model or its parts, at its temperature in the load case in effect; None without one."""
    oil: Lubricant | None = machine.lubricant
    case = machine.load_cases.get(machine.load_case or "")
    return oil if oil is None or case is None else oil.at(case.temperature)


def speeds_in_effect(machine: Any) -> dict[str, float]:
    """Speeds by body of the load case in effect [rad/s]; empty without one."""
    case = machine.load_cases.get(machine.load_case or "")
    return {} if case is None else dict(case.speed)
