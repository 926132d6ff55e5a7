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
from pitchpoint.solvers.initial_state.start import prepare_start
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
        Position at equilibrium, speeds of the scenario.
    held
        Held spins: the driven ones, and one of every group that can rotate freely.
    notes
        Notes for the user.
    """

    system: System
    state: State
    held: tuple[int, ...]
    notes: tuple[str, ...] = ()


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
    """Find the state that a scenario starts from, or the system at rest under its loads.

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
    own = system.copy()
    forget_contacts(own)
    held = held_spins(own)
    if own.model is None or start is not None:
        return OperatingPoint(own, find_equilibrium(own, start, held).state, held)
    begin = prepare_start(own, scenario or own.scenario or Scenario())
    return OperatingPoint(begin.system, begin.steady, held, (*begin.notes, *held_outputs(own)))
