# SPDX-License-Identifier: Apache-2.0
"""The time step of a run: small against the shortest period that matters, and a divisor of the sample
period."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.scenario import EXPLICIT_METHODS
from pitchpoint.solvers.gear_trains import mesh_rates
from pitchpoint.solvers.initial_state.start import Start, highest_speeds, speeds_of
from pitchpoint.solvers.step_modes import counted_frequency
from pitchpoint.system.meshes import mesh_records

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import System

ROUND_OFF = 1e-13
"""Share of a span of time that is rounding: less than a step for the 1e12 steps that a run may have."""

KINEMATIC_STEPS = 1000
"""Times of a motion without dynamics."""
STEPS_PER_PERIOD = 200
"""Steps in the period of the fastest mode and of the fastest mesh.

On a spur pair whose mesh excites its resonance 200 steps leave 3e-4 in the rms of the deflection, 100 steps
1.1e-3; the error falls with the square.
"""


def fastest_mesh(system: System, scenario: Scenario) -> float:
    """Highest mesh frequency [Hz] of a scenario, from its start speeds and drives."""
    if not mesh_records(system):
        return 0.0
    speeds = speeds_of(system, scenario)
    highest = _mesh_frequency(system, speeds)
    driven = highest_speeds(system, scenario)
    if driven and system.model is not None:
        highest = max(
            highest, _mesh_frequency(system, system.model.start_speeds(replace(scenario, speed=driven)))
        )
    return highest


def _mesh_frequency(system: System, speeds: dict[str, float]) -> float:
    if not mesh_records(system):
        return 0.0
    return max(mesh_rates(system, speeds)) / (2.0 * math.pi)


def mesh_mode(row: np.void, system: System) -> float:
    """Natural frequency of the usual stiffness of a mesh between the spins of its two bodies [Hz].

    Counts for a mesh that is not in contact yet, too.
    """
    inverse = 0.0
    for body, r_b in ((int(row["i"]), row["r_b1"]), (int(row["j"]), row["r_b2"])):
        polar = float(system.program["body"][body]["i_p"])
        if system.program["body"][body]["joint"] and polar > 0.0:
            inverse += float(r_b) ** 2 / polar
    return math.sqrt(float(row["k_step"]) * inverse) / (2.0 * math.pi)


def shortest_period(start: Start, scenario: Scenario) -> float:
    """Period of the fastest mode or mesh of a run, or a tenth of its duration if that is less [s].

    Of the modes of finite elements those count that something excites: see `step_modes`.
    """
    fastest = max(
        counted_frequency(start, scenario.method in EXPLICIT_METHODS),
        fastest_mesh(start.system, scenario),
        *(mesh_mode(row, start.system) for row in mesh_records(start.system)),
        10.0 / (scenario.duration or 1.0),
    )
    return 1.0 / fastest


def largest_step(start: Start, scenario: Scenario) -> float:
    """Longest step of an adaptive method [s]: the given step, else a quarter of the shortest period.

    Step control sees errors, not what happens between its stages: a step longer than that may pass over a
    whole tooth or a short load.
    """
    return scenario.step or 0.25 * shortest_period(start, scenario)


def largest_stiff_step(start: Start, scenario: Scenario) -> float:
    """Longest step of a stiff method with error control [s]: the given step, else a quarter of a mesh period.

    Modes do not count: steps longer than the periods of those that are not excited are what it is for.
    """
    mesh = fastest_mesh(start.system, scenario)
    return scenario.step or 0.25 / max(mesh, 10.0 / (scenario.duration or 1.0))


def choose_step(start: Start, scenario: Scenario) -> tuple[float, int]:
    """Time step [s] and number of steps between samples.

    A given step counts as the largest one: it is shortened to divide the sample period, or the duration if
    every step is a sample.

    Parameters
    ----------
    start
        Where the run begins.
    scenario
        Its step, sample rate and speeds count.
    """
    if scenario.method == "kinematics":  # every time is independent
        h = scenario.step or (scenario.duration or 1.0) / KINEMATIC_STEPS
    else:
        h = scenario.step or shortest_period(start, scenario) / STEPS_PER_PERIOD
    if scenario.sample_rate is None:
        return divided(scenario.duration or h, h)[0], 1
    return divided(1.0 / scenario.sample_rate, h)


def divided(span: float, longest: float) -> tuple[float, int]:
    """Step that divides a span of time and is no longer than another, and how often it does.

    Examples
    --------
    >>> divided(1.0, 0.3), divided(1.0, 0.25)
    ((0.25, 4), (0.25, 4))
    """
    count = max(1, math.ceil(span / longest * (1.0 - ROUND_OFF)))
    return span / count, count


def whole_steps(span: float, h: float) -> tuple[int, float]:
    """Steps that fit into a span of time, and what is left over [s]; nothing if that is round-off.

    Examples
    --------
    >>> whole_steps(0.3, 0.1), whole_steps(1.0, 0.375)
    ((3, 0.0), (2, 0.25))
    """
    count = math.floor(span / h * (1.0 + ROUND_OFF))
    rest = span - count * h
    return count, rest if rest > ROUND_OFF * span else 0.0
