# SPDX-License-Identifier: Apache-2.0
"""Diagnosis of diverging runs: which quantity diverged, when, and whether the step is too long."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.status import BAD_CENTRE, DIVERGED, NOT_FINITE, SLOW, UNBOUNDED
from pitchpoint.solvers.implicit.gear_part import fast_bodies
from pitchpoint.solvers.sampling import GREATEST
from pitchpoint.solvers.step_choice import choose_step

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.initial_state.start import Start
    from pitchpoint.solvers.sampling import Chunk
    from pitchpoint.system.system import System

FASTEST = 299_792_458.0
"""Divergence limit of the rate of a coordinate, as a velocity: the speed of light [m/s]."""
SHORTENED = ("runge_kutta", "gstiff", "wstiff", "dassl", "constant_bdf", "kinematics")
"""Methods that reduce a failed step automatically, or whose steps are independent of each other."""


FAILURES = (NOT_FINITE, DIVERGED, SLOW, BAD_CENTRE, UNBOUNDED)
"""Ends of a run that diverged."""


def fastest(system: System) -> tuple[str, float, bool]:
    """Coordinate in the workspace with the largest rate, that rate, and whether it has diverged.

    States of controllers and elements have no such limit.
    """
    w = system.workspace
    moves = np.ones(len(w.v), bool)
    for number, body in enumerate(system.bodies, start=1):
        if body.state:
            moves[int(system.program["body"][number]["dof"])] = False
    rates = np.where(moves, np.abs(w.v) * w.arrays["weight"], 0.0)
    if not rates.size:
        return "", 0.0, False
    k = int(np.argmax(np.where(np.isfinite(rates), rates, np.inf)))
    return system.layout.coordinates[k], float(w.v[k]), not rates[k] < FASTEST


def sentence_of(system: System, chunk: Chunk, t: float, channels: NDArray[np.int64]) -> str:
    """Sentence on which quantity diverged, and when.

    Parameters
    ----------
    system
        Its workspace contains the state reached.
    chunk
        The last chunk.
    t
        Time reached [s].
    channels
        Indices of the channels in its samples, in this order; empty: all.
    """
    if chunk.lost is not None:
        column = int(np.argmax(~(np.abs(chunk.lost[1:]) < GREATEST)))
        channel = system.layout.channels[channels[column] if len(channels) else column]
        value, time = chunk.lost[1 + column], chunk.lost[0]
        unit = "" if channel.unit == "1" else f" {channel.unit}"
        return f"{channel.name} is {value:.3g}{unit} at t = {time:.6g} s"
    name, rate, _ = fastest(system)
    return f"the rate of {name} is {rate:.3g} at t = {t:.6g} s" if name else f"t = {t:.6g} s"


def remedy(start: Start, scenario: Scenario, status: int, h: float) -> str:
    """Suggestion of shorter steps: long steps, or the given fixed step if it is longer than the default one.

    Parameters
    ----------
    start, scenario
        Start and scenario of the run.
    status
        Final status of the run.
    h
        Step of the run [s].
    """
    if status not in FAILURES or scenario.method in SHORTENED:
        return ""
    long = scenario.long_step
    if long is not None and long > 1.5 * h and fast_bodies(start.system):
        return "; shorten or remove `long_step`"
    own = choose_step(start, replace(scenario, step=None, sample_rate=None))[0]
    if h <= 1.01 * own:
        return ""
    return f"; the step of {h:.3g} s is {h / own:.3g} times the default step: reduce `step`"
