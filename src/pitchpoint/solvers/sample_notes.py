# SPDX-License-Identifier: Apache-2.0
"""Notes on the samples of a run."""

from __future__ import annotations

import math

from pitchpoint.core.errors import Message
from pitchpoint.core.status import INTERRUPTED, OK
from pitchpoint.model.remarks.sampling import coarse_samples
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.step_choice import mesh_frequencies
from pitchpoint.solvers.time_summary import TimeSummary
from pitchpoint.system.system import System


def sample_notes(
    system: System, scenario: Scenario, done: TimeSummary, rate: float | None
) -> tuple[Message, ...]:
    """Note on meshes that the samples of a run show as false lines.

    Parameters
    ----------
    system, scenario
        The system and its scenario, which gives the highest speeds of drives.
    done
        The run; a machine that runs up under its loads is fastest at the end.
    rate
        Sample rate that the user requested [Hz]; None if every step is a sample: then there is no note.
    """
    if rate is None:
        return ()
    highest = mesh_frequencies(system, scenario) if system.model is not None else {}
    if done.status in (OK, INTERRUPTED):
        for name, omega in mesh_orders(system, done.state.v).items():
            highest[name] = max(highest.get(name, 0.0), omega / math.tau)
    return coarse_samples(rate, highest, "sample_rate")
