# SPDX-License-Identifier: Apache-2.0
"""External torques of a scenario for the power flow at constant speed: loads, drives, supports at rest."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import ranges
from pitchpoint.model.components.actuator import TorqueActuator
from pitchpoint.model.components.law import Balance, Constant, FormulaLaw, Law, PythonLaw, TableLaw
from pitchpoint.model.engagement import braked_body, engaged_brakes, is_open
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.mechanism import coordinate
from pitchpoint.model.torque_balance import SAME, External
from pitchpoint.report.scissor_gears import scissors_of_model

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.model.speed_ratios import Link
    from pitchpoint.model.torque_balance import TorqueBalance

REVOLUTIONS, SAMPLES = 12, 8640
"""Revolutions of a mean over an angle, whole periods of orders 1/2, 1/3, 1/4 and 1/6; and its instants."""


def external_torques(
    model: Model, scenario: Scenario, speeds: Mapping[str, float]
) -> tuple[list[External], list[Link], list[str]]:
    """External torques of a scenario, and remarks on their means.

    Parameters
    ----------
    model
        The model.
    scenario
        The scenario.
    speeds
        Speeds of all bodies relative to their parents [rad/s].

    Returns
    -------
    tuple
        Torques, None for those that follow from the balance: of drives, supports at rest, `torque: balance`
        and Python functions; clutches without slip as links; and remarks on loads that vary.
    """
    from pitchpoint.model.torsional_supports import supported_bodies

    machine: Any = model
    found: list[External] = []
    remarks: list[str] = []
    alike: dict[str, list[str]] = {}
    for name, load in model.loads.items():
        if load.torque is None or load.body not in model.bodies:
            continue
        reaction = load.reaction or GROUND
        base = speeds.get(reaction, 0.0)
        value, words = mean_torque(load.torque, scenario, speeds.get(load.body, 0.0) - base)
        found.append(External(("loads", name), load.body, value, reaction))
        if words:
            alike.setdefault(words, []).append(name)
    remarks += [f"{ranges(names)}: {words}" for words, names in alike.items()]
    for key in scenario.drive:
        end = coordinate(model.mechanism, model, key)
        if not isinstance(end, str) and model.mechanism.seats[end[0]].coordinates[end[1]] == "spin":
            found.append(External(("drive", key), end[0], reaction=model.mechanism.seats[end[0]].parent))
    for body in scenario.hold:
        found.append(External(("hold", body), body, reaction=model.mechanism.seats[body].parent))
    for name, actuator in model.actuators.items():
        if isinstance(actuator, TorqueActuator):
            bodies = [split(end)[0] for end in (*actuator.bodies, GROUND)][:2]
            found.append(External(("actuators", name), bodies[0], reaction=bodies[1]))
    for name, rotor in model.wind_rotors.items():
        found.append(External(("wind_rotors", name), split(rotor.hub)[0]))
    for name, row in scissors_of_model(model).items():  # preload of the spring
        found.append(External(("torsion_springs", name), name, row["spring_torque"], row["body"]))
    sticking: list[Link] = []
    for name, clutch in model.clutches.items():
        # of a scissor gear: between halves at rest to each other
        if clutch.stage is not None or is_open(name, clutch, scenario.engaged):
            continue
        bodies = [split(end)[0] for end in (*clutch.bodies, GROUND)][:2]
        slip = speeds.get(bodies[0], 0.0) - speeds.get(bodies[1], 0.0)
        capacity, words = mean_torque(clutch.capacity, scenario, slip)
        if capacity == 0.0:
            continue
        if abs(slip) > SAME * max(map(abs, speeds.values()), default=0.0):
            torque = None if capacity is None else -math.copysign(capacity, slip)
            found.append(External(("clutches", name), bodies[0], torque, bodies[1]))
            remarks += [f"{name}: slips; {words}" if words else f"{name}: slips"]
        elif braked_body(machine, clutch) is None:
            sticking.append((("clutches", name), bodies[0], bodies[1], 1.0))
    moved = {one.body for one in found if one.name[0] in ("drive", "hold")}
    brakes = engaged_brakes(machine, scenario.engaged)
    found += [External(("clutches", brake), body) for body, brake in brakes.items() if body not in moved]
    moved |= {*brakes}
    for body in supported_bodies(machine, scenario.engaged):
        if speeds.get(body, 0.0) == 0.0 and body not in moved:
            found.append(External(("support", body), body))
    return found, sticking, remarks


def overloaded_clutches(model: Model, scenario: Scenario, balance: TorqueBalance) -> list[str]:
    """Remarks on engaged clutches and brakes that transmit more than their capacity, and therefore slip."""
    found = []
    machine: Any = model
    for name, clutch in model.clutches.items():
        place = ("clutches", name)
        if place in balance.links:
            torque = abs(balance.links[place].torques[0])
        elif place in balance.external and name in engaged_brakes(machine, scenario.engaged).values():
            torque = abs(balance.external[place])
        else:
            continue
        capacity, _ = mean_torque(clutch.capacity, scenario, 0.0)
        static = clutch.static_ratio if clutch.stribeck_speed > 0.0 else 1.0
        limit = math.inf if capacity is None else capacity * static
        if torque > limit * (1.0 + SAME):
            words = [format_quantity(t, "torque", 5) for t in (torque, limit)]
            found.append(f"{name}: {words[0]} exceed its capacity of {words[1]}, so that it slips")
    return found


def mean_torque(law: Law, scenario: Scenario, speed: float) -> tuple[float | None, str]:
    """Torque of a load at constant speed [N m], and in words what it is if it varies.

    Loads over time count with their mean over the evaluated part of the run, loads over an angle with their
    mean over twelve revolutions or the period, loads over a speed at this speed.

    Parameters
    ----------
    law
        Law of the torque.
    scenario
        Scenario with the evaluated part of the run.
    speed
        Speed of the body relative to the reaction [rad/s].

    Examples
    --------
    >>> from pitchpoint.model.scenario import Scenario
    >>> run = Scenario(duration=2.0, settle_time=1.0)
    >>> mean_torque(FormulaLaw("10 + 5*sin(3*angle)"), run, 1.0)
    (10.0, 'mean over 12 revolutions')
    >>> mean_torque(TableLaw((0.0, 1.0), (0.0, 8.0)), run, 0.0)
    (8.0, 'mean from 1 s to 2 s')
    """
    if isinstance(law, Constant):
        return law.value, ""
    if isinstance(law, Balance | PythonLaw):
        return None, "" if isinstance(
            law, Balance
        ) else "a Python function, so its torque follows from the balance"
    first, last = scenario.statistics_start, scenario.duration or 0.0
    # midpoints: exact for periodic functions over whole periods, no jump of a table at an end
    share = (np.arange(SAMPLES) + 0.5) / SAMPLES
    over_time = f"mean from {first:.6g} s to {last:.6g} s" if last > first else "value at the start"
    t = first + (last - first) * share
    if isinstance(law, FormulaLaw):
        from pitchpoint.core.formula.formula import Formula

        formula = Formula.parse(law.text, law.variables)
        timed, turned = formula.uses("t"), formula.uses("angle")
        angle = REVOLUTIONS * math.tau * share if turned else np.zeros(SAMPLES)
        values = formula(t if timed else 0.0 * t, angle, np.full(SAMPLES, speed))
        if not timed and not turned:
            return float(values[0]), ""
        words = " and ".join([over_time] * timed + [f"mean over {REVOLUTIONS} revolutions"] * turned)
        return round_off(float(np.mean(values)), float(np.abs(values).max())), words
    if isinstance(law, TableLaw) and law.over == "time":
        return float(np.mean(np.interp(t, law.abscissa, law.values))), over_time
    if isinstance(law, TableLaw):
        x, y = np.array(law.abscissa), np.array(law.values)
        mean = float(np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x)) / (x[-1] - x[0]))
        return round_off(mean, float(np.abs(y).max())), "mean over its period"
    return None, ""


def round_off(value: float, size: float) -> float:
    """Value without the rounding error of a sum of terms of some size.

    Examples
    --------
    >>> round_off(10.000000000000004, 15.0), round_off(2e-16, 1.0)
    (10.0, 0.0)
    """
    if size == 0.0:
        return value
    digits = 12 - math.ceil(math.log10(size))
    return round(value, digits) + 0.0
