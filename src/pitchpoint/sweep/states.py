# SPDX-License-Identifier: Apache-2.0
"""Evaluation of a case without a time response: its loaded equilibrium, or the modes about it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.progress import Progress, silent

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import System

MODE_NUMBERS = (
    ("natural_frequency", "Hz", "natural frequency"),
    ("undamped_frequency", "Hz", "undamped natural frequency"),
    ("damping_ratio", "1", "damping ratio"),
)
"""Numbers of each mode: name, unit, description. Modes are counted from 1 by undamped frequency, as in the
output of `modes --json`."""

Found = tuple[dict[str, dict[str, Any]], tuple[str, ...]]
"""Statistics of single numbers by name, and notes."""


def at_equilibrium(system: System, scenario: Scenario | None) -> Found:
    """All channels at the loaded state from which a scenario starts, or at rest.

    Parameters
    ----------
    system
        Compiled with the scenario.
    scenario
        The scenario; None: at rest.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    from pitchpoint.solvers.equilibrium.solve import find_equilibrium
    from pitchpoint.solvers.operating_point import operating_point

    point = operating_point(system, scenario)
    values = find_equilibrium(point.system, point.state, point.held).observe(point.system)
    channels = point.system.layout.channels
    rows = {c.name: _row(c.unit, float(v)) for c, v in zip(channels, values, strict=True)}
    return rows, point.notes


def mode_numbers(system: System, scenario: Scenario | None, progress: Progress = silent) -> Found:
    """Frequencies and damping ratios of all modes.

    Parameters
    ----------
    system, scenario
        As for `at_equilibrium`.
    progress
        Called after every element.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    from pitchpoint.solvers.modal import find_modes

    found = find_modes(system, scenario, progress=progress)
    columns = (found.damped_frequency, found.frequency, found.damping_ratio)
    rows = {
        f"{name}[{k + 1}]": _row(unit, float(value))
        for (name, unit, _), column in zip(MODE_NUMBERS, columns, strict=True)
        for k, value in enumerate(column)
    }
    return rows, found.notes


def _row(unit: str, value: float) -> dict[str, Any]:
    """A single number as a row of statistics."""
    return {"unit": unit, "mean": value, "rms": 0.0, "min": value, "max": value}
