# SPDX-License-Identifier: Apache-2.0
"""Operating point of linear analyses: the loaded state of a scenario, with its held spins."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.controls import held_outputs
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import held_spins
from pitchpoint.solvers.initial_state.speeds import body_rates
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.load_cycle import LoadCycle
from pitchpoint.solvers.load_orders import mean_loads
from pitchpoint.solvers.locked_clutches import with_locked_clutches
from pitchpoint.solvers.sweep_speeds import at_one_speed
from pitchpoint.system.meshes import forget_contacts
from pitchpoint.system.system import State, System


@dataclass(frozen=True)
class OperatingPoint:
    """A loaded state.

    Parameters
    ----------
    system
        Copy of the system with balancing torques and damping.
    state
        Position at equilibrium, mean speeds of the scenario.
    held
        Held spins: the driven ones, and one of every group that can rotate freely.
    notes
        Notes for the user.
    at
        Which state of a sweep this is, in words; else empty.
    cycle
        Mean torques of pulsating loads that balancing torques balance, if there are any.
    """

    system: System
    state: State
    held: tuple[int, ...]
    notes: tuple[str, ...] = ()
    at: str = ""
    cycle: LoadCycle | None = None


def scenario_named(system: System, scenario: Scenario | str | None) -> Scenario | None:
    """The scenario of the model with this name; a scenario or None is returned unchanged."""
    if not isinstance(scenario, str):
        return scenario
    if system.model is None or scenario not in system.model.scenarios:
        known = [] if system.model is None else list(system.model.scenarios)
        raise SolverError(f"no scenario {scenario!r}; there are: {', '.join(known) or 'none'}", INCONSISTENT)
    return system.model.scenarios[scenario]


def operating_point(
    system: System, scenario: Scenario | str | None = None, start: State | None = None
) -> OperatingPoint:
    """Find the state that a scenario starts from, a sweep at its lowest speed; or the system at rest.

    Parameters
    ----------
    system
        The compiled model, with the same scenario if it drives bodies.
    scenario
        Scenario or its name; default the one the system was compiled with, else at rest.
    start
        Initial state of the equilibrium iteration, instead of a scenario. Its rates are retained: the result
        is the equilibrium of a steady rotation.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    scenario = scenario_named(system, scenario)
    own = with_locked_clutches(system.copy(), scenario or system.scenario)
    forget_contacts(own)
    held = held_spins(own)
    if own.model is None or start is not None:
        return OperatingPoint(own, find_equilibrium(own, start, held).state, held)
    own, chosen, words = at_one_speed(own, scenario or own.scenario or Scenario())
    begin = prepare_start(own, chosen)
    notes = (f"state at {words}",) if words else ()
    notes = (*notes, *begin.notes, *held_outputs(own))
    return OperatingPoint(begin.system, begin.mean, held, notes, words, begin.cycle)


def steady_point(
    system: System,
    scenario: Scenario | str | None = None,
    start: State | None = None,
    turning: str | None = None,
) -> tuple[OperatingPoint, tuple[str, ...]]:
    """Operating point in which torques that pulsate with the angle of a rotating body have their mean.

    Parameters
    ----------
    system, scenario, start
        As for `operating_point`.
    turning
        Body that rotates, if the scenario is at rest.

    Returns
    -------
    tuple
        The operating point, and the names of the pulsating loads.
    """
    point = operating_point(system, scenario, start)
    rates = point.state.v
    if turning is not None and not rates.any():
        rates = body_rates(point.system, turning, scenario_named(system, scenario))
    steady, pulsating = mean_loads(system, point.state, rates)
    return operating_point(steady, scenario, start) if pulsating else point, pulsating
