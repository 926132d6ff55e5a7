# SPDX-License-Identifier: Apache-2.0
"""Time step of a run: a small fraction of the shortest relevant period that divides the sample period."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.scenario import EXPLICIT_METHODS
from pitchpoint.solvers.gear_trains import mesh_rates
from pitchpoint.solvers.initial_state.speeds import highest_speeds, speeds_of
from pitchpoint.solvers.initial_state.start import Start
from pitchpoint.solvers.step_modes import counted_frequency
from pitchpoint.system.meshes import mesh_names, mesh_records

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.system import System

ROUND_OFF = 1e-13
"""Relative rounding error of a time span; smaller than one step of a run with 1e12 steps."""

KINEMATIC_STEPS = 1000
"""Default number of time steps of a purely kinematic run."""
STEPS_PER_PERIOD = 200
"""Steps per period of the fastest mode and of the fastest mesh.

For a spur pair excited at resonance by its mesh, the relative error of the rms deflection is 3e-4 with 200
steps and 1.1e-3 with 100 steps; it is second order in the step.
"""

CHUNK_SECONDS = 0.15
"""Target wall time of one call of the compiled loop; progress and Ctrl-C are handled between calls."""


def fastest_mesh(system: System, scenario: Scenario) -> float:
    """Highest mesh frequency [Hz] of a scenario, see `mesh_frequencies`."""
    return max(mesh_frequencies(system, scenario).values(), default=0.0)


def mesh_frequencies(system: System, scenario: Scenario) -> dict[str, float]:
    """Highest frequency of every mesh in a scenario [Hz], from its initial speeds and drives."""
    names = mesh_names(system)
    if not names:
        return {}
    cases = [speeds_of(system, scenario)]
    driven = highest_speeds(system, scenario)
    if driven and system.model is not None:
        cases.append(system.model.start_speeds(replace(scenario, speed=driven)))
    rates = np.array([mesh_rates(system, speeds) for speeds in cases]).max(axis=0)
    return dict(zip(names, (rates / math.tau).tolist(), strict=True))


def mesh_mode(row: np.void, system: System, driven: Collection[int] = ()) -> float:
    """Torsional natural frequency [Hz] of the two bodies of a mesh on its nominal stiffness.

    It is defined for a mesh that is not in contact, too. The numbers of bodies in `driven` do not vibrate.
    """
    inverse = 0.0
    for body, r_b in ((int(row["i"]), row["r_b1"]), (int(row["j"]), row["r_b2"])):
        polar = float(system.program["body"][body]["i_p"])
        if system.program["body"][body]["joint"] and polar > 0.0 and body not in driven:
            inverse += float(r_b) ** 2 / polar
    return math.sqrt(float(row["k_step"]) * inverse) / (2.0 * math.pi)


def fastest_ripple(system: System, scenario: Scenario) -> float:
    """Highest frequency of the ripples of the drives of a scenario [Hz]."""
    orders = {body: max(w.order for w in d.ripple.values()) for body, d in scenario.drive.items() if d.ripple}
    speeds = highest_speeds(system, scenario) if orders else {}
    found = (order * abs(speeds.get(body, 0.0)) for body, order in orders.items())
    return max(found, default=0.0) / (2.0 * math.pi)


def shortest_period(start: Start, scenario: Scenario) -> float:
    """Period of the fastest mode, mesh or ripple of a run, or a tenth of its duration if that is shorter [s].

    Of the modes of finite-element bodies only the excited ones count: see `step_modes`.
    """
    fastest = max(
        counted_frequency(start, scenario.method in EXPLICIT_METHODS),
        fastest_mesh(start.system, scenario),
        *(mesh_mode(row, start.system) for row in mesh_records(start.system)),
        fastest_ripple(start.system, scenario),
        10.0 / (scenario.duration or 1.0),
    )
    return 1.0 / fastest


def largest_step(start: Start, scenario: Scenario) -> float:
    """Longest step of an adaptive method [s]: the given step, or a quarter of the shortest period.

    Error control evaluates the forces at the stages only: a longer step may miss a whole tooth or a short
    load pulse.
    """
    return scenario.step or 0.25 * shortest_period(start, scenario)


def largest_stiff_step(start: Start, scenario: Scenario) -> float:
    """Longest step of a stiff method with error control [s]: the given step, or a quarter of a period
    of the fastest mesh or ripple.

    Modes do not limit it: stiff methods may step over the periods of modes that are not excited.
    """
    fastest = max(fastest_mesh(start.system, scenario), fastest_ripple(start.system, scenario))
    return scenario.step or 0.25 / max(fastest, 10.0 / (scenario.duration or 1.0))


def choose_step(start: Start, scenario: Scenario) -> tuple[float, int]:
    """Time step [s] and number of steps between samples.

    A given step is the upper limit: it is shortened to divide the sample period, or the duration if every
    step is a sample.

    Parameters
    ----------
    start
        Initial state of the run.
    scenario
        Gives step, sample rate and speeds.
    """
    if scenario.method == "kinematics":  # all time points are independent
        h = scenario.step or (scenario.duration or 1.0) / KINEMATIC_STEPS
    else:
        h = scenario.step or shortest_period(start, scenario) / STEPS_PER_PERIOD
    if scenario.sample_rate is None:
        return divided(scenario.duration or h, h)[0], 1
    return divided(1.0 / scenario.sample_rate, h)


def divided(span: float, longest: float) -> tuple[float, int]:
    """Longest step up to a limit that divides a time span, and the number of steps.

    Examples
    --------
    >>> divided(1.0, 0.3), divided(1.0, 0.25)
    ((0.25, 4), (0.25, 4))
    """
    count = max(1, math.ceil(span / longest * (1.0 - ROUND_OFF)))
    return span / count, count


def whole_steps(span: float, h: float) -> tuple[int, float]:
    """Number of whole steps in a time span, and the remainder [s]; zero if it is round-off.

    Examples
    --------
    >>> whole_steps(0.3, 0.1), whole_steps(1.0, 0.375)
    ((3, 0.0), (2, 0.25))
    """
    count = math.floor(span / h * (1.0 + ROUND_OFF))
    rest = span - count * h
    return count, rest if rest > ROUND_OFF * span else 0.0


def next_chunk(n: int, seconds: float, whole: int = 1) -> int:
    """Number of steps of the next chunk, from the wall time [s] of the last n steps; a multiple of `whole`.

    Examples
    --------
    >>> next_chunk(1000, 0.3), next_chunk(1000, 0.001), next_chunk(1000, 0.3, 30)
    (500, 8000, 480)
    """
    wanted = int(n * min(8.0, max(0.2, CHUNK_SECONDS / max(seconds, 1e-4))))
    return max(whole, wanted - wanted % whole)
