# SPDX-License-Identifier: Apache-2.0
"""Compiled loops of all methods; start of a run with fixed steps: Runge-Kutta, Adams, generalised-alpha."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import ValidityWarning
from pitchpoint.model.scenario import EXPLICIT_METHODS, STIFF_METHODS
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario

FIXED_METHODS = ("adams", "rk4", "generalized_alpha")


def start_run(
    system: System, state: State, scenario: Scenario, h: float, every: int = 1
) -> tuple[Any, float, int]:
    """Start the run of a scenario, with its long steps of bodies outside of gear trains if it has them.

    Parameters
    ----------
    system, state
        The system and its initial state.
    scenario
        Gives the method and the long step.
    h, every
        Step [s] and steps per sample.

    Returns
    -------
    tuple
        The run, its step [s] and steps per sample: `aligned` with long steps, unless controllers require h.
    """
    count = round((scenario.long_step or h) / h)
    if count < 2:
        return start_fixed_steps(system, state, scenario, h), h, every
    from pitchpoint.solvers.implicit import gear_part  # imported and compiled on demand

    if not gear_part.fast_bodies(system):
        return start_fixed_steps(system, state, scenario, h), h, every
    if not system.controllers:
        period = every * h
        count, every = aligned(count, every)
        h = period / every
    return gear_part.start(system, state, h, count), h, every


def without_long_steps(system: System, scenario: Scenario, what: str) -> Scenario:
    """The scenario with equal steps of all bodies; a warning if `long_step` would have an effect.

    Parameters
    ----------
    system, scenario
        The system and the scenario to run.
    what
        Words for what cannot take long steps.
    """
    if scenario.long_step is None:
        return scenario
    if round(scenario.long_step / (scenario.step or scenario.long_step)) > 1:
        text = f"long_step: {what} takes the same step for all bodies; the long step has no effect"
        warnings.warn(text, ValidityWarning, stacklevel=3)
    return replace(scenario, long_step=None)


def aligned(count: int, every: int) -> tuple[int, int]:
    """Steps per long step, up to `count`, and per sample, at least `every`, of which one divides the other.

    The channels of bodies outside of gear trains change at the ends of long steps only.

    Examples
    --------
    >>> aligned(10, 10), aligned(10, 4), aligned(10, 13), aligned(10, 79)
    ((10, 10), (8, 4), (7, 14), (10, 80))
    """
    if count >= every:
        return count - count % every, every
    parts = -(-every // count)
    count = -(-every // parts)
    return count, parts * count


def loop_of(method: str) -> Any:
    """Compiled loop of a method, as an entry for `core.kernel.expect`."""
    if method in ("generalized_alpha", "kinematics"):  # kinematics has no loop
        return generalized_alpha.entry
    if method in STIFF_METHODS:
        from pitchpoint.solvers.multistep import step as multistep

        return multistep.entry
    from pitchpoint.solvers.explicit import dormand_prince, equal_steps  # imported on demand

    return dormand_prince.entry if method == "runge_kutta" else equal_steps.entry


def start_fixed_steps(system: System, state: State, scenario: Scenario, h: float) -> Any:
    """Start the run of a scenario with a method of `FIXED_METHODS`.

    Parameters
    ----------
    system, state
        The system and its initial state.
    scenario
        Gives the method and the index formulation.
    h
        Step [s], > 0.
    """
    if scenario.method not in EXPLICIT_METHODS:
        return generalized_alpha.start(system, state, h, form=scenario.chosen_form)
    from pitchpoint.solvers.explicit import runge_kutta  # imported on demand

    begin = runge_kutta.start_adams if scenario.method == "adams" else runge_kutta.start_classical
    return begin(system, state, h)
