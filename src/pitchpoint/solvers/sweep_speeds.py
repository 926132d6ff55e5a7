# SPDX-License-Identifier: Apache-2.0
"""Speeds of a sweep, and the machine at one of them.

Analyses of one state (slow rolls, modes, Campbell diagrams, frequency responses) use the lowest speed.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT, NOT_FINITE
from pitchpoint.core.units import format_quantity
from pitchpoint.elements.kind import DRIVE
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.initial_state.speeds import body_rates

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario, Sweep
    from pitchpoint.system.system import System


def _parts(system: System, scenario: Scenario) -> tuple[Model, Sweep]:
    if system.model is None or scenario.sweep is None:
        raise SolverError("the scenario is not a sweep", NOT_FINITE)
    return system.model, scenario.sweep


def sweep_orders(system: System, scenario: Scenario) -> tuple[str, dict[str, float]]:
    """Swept mesh, and the periods of every mesh per revolution of the swept body.

    Raises
    ------
    SolverError
        If the scenario is not a sweep, or the swept mesh has no relative motion when the swept body rotates.
    """
    model, sweep = _parts(system, scenario)
    mesh = model.sweep_mesh(scenario)
    orders = mesh_orders(system, body_rates(system, sweep.body, replace(scenario, speed={})))
    if not orders[mesh] > 0.0:
        raise SolverError(
            f"mesh {mesh} is at rest while {sweep.body} rotates, so it has no mesh frequency; sweep a body "
            "that rotates relative to the line of centres of the mesh",
            INCONSISTENT,
        )
    return mesh, orders


def sweep_range(system: System, scenario: Scenario) -> tuple[float, float]:
    """Speeds of lowest and highest magnitude of the swept body [rad/s]; mesh frequencies: both positive.

    Raises
    ------
    SolverError
        If the scenario is not a sweep, or its mesh frequency is zero at all speeds.
    """
    _, sweep = _parts(system, scenario)
    if sweep.speed is not None:
        return sweep.speed
    if sweep.mesh_frequency is None:
        raise SolverError("the sweep has neither mesh_frequency nor speed", NOT_FINITE)
    mesh, orders = sweep_orders(system, scenario)
    low, high = (math.tau * f / orders[mesh] for f in sweep.mesh_frequency)
    return low, high


def at_speed(system: System, scenario: Scenario, speed: float) -> tuple[System, Scenario]:
    """System with its drives at a speed of the swept body [rad/s], a copy, and a scenario with this speed."""
    model, sweep = _parts(system, scenario)
    own, ratio = system.copy(), model.start_speeds(replace(scenario, speed={sweep.body: 1.0}))
    for record in own.rows(DRIVE):
        record["speed"] = speed * ratio[own.layout.bodies[int(record["i"])]]
    return own, replace(scenario, speed={sweep.body: speed}, sweep=None)


def at_one_speed(system: System, scenario: Scenario) -> tuple[System, Scenario, str]:
    """System and scenario of analyses of one state, and the state in words.

    Of a sweep, these are the system and the scenario at the lowest speed. Other scenarios are unchanged, and
    there are no words.
    """
    if scenario.sweep is None or system.model is None:
        return system, scenario, ""
    low, _ = sweep_range(system, scenario)
    at = format_quantity(low, "angular_speed", 5)
    return *at_speed(system, scenario, low), f"{at} of {scenario.sweep.body}, the lowest speed of the sweep"
