# SPDX-License-Identifier: Apache-2.0
"""Sinks for the samples of a run, and the summary of a run."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.contact_counts import CONTACT_NUMBERS
from pitchpoint.system.no_load import unloaded_meshes
from pitchpoint.system.system import State

if TYPE_CHECKING:
    from pitchpoint.solvers.sampling import Statistics
    from pitchpoint.system.system import System


class Sink(Protocol):
    """Receiver of samples during a run, such as a result file."""

    def append(self, t: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Append n samples: times [s], shape (n,), and all or the requested channels, shape (n, no)."""


@dataclass
class Memory:
    """A sink that stores all samples in memory."""

    times: list[NDArray[np.float64]] = field(default_factory=list)
    rows: list[NDArray[np.float64]] = field(default_factory=list)

    def append(self, t: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Store samples."""
        self.times.append(t)
        self.rows.append(values)


@dataclass(frozen=True)
class TimeSummary:
    """Summary of a run.

    Parameters
    ----------
    status, sentence
        Status code and its description.
    steps, step, wall_s
        Accepted steps, time step (0 if adaptive) [s], wall time [s]. A last step may be shorter.
    t_end
        Time reached [s].
    window
        Start and end of the statistics [s].
    channels
        Statistics by channel over all steps of the window: unit, mean, rms of the alternating part, min, max,
        and of a contact state also share_zero, the fraction of the steps without contact, and the numbers of
        `analysis.rattle.Rattle`. NaN without steps.
    events
        Time [s], index in `event_names`, direction; shape (n, 3).
    event_names
        Names of the event functions.
    notes
        Notes for the user.
    state
        State reached. A run can continue from it, but drives by formula or function are defined up to the
        duration of their scenario only.
    contact_solver
        Counters of the contact solver by mesh with flexible contact (`system.flank_remarks`).
    """

    status: int
    sentence: str
    steps: int
    step: float
    wall_s: float
    t_end: float
    window: tuple[float, float]
    channels: dict[str, dict[str, Any]]
    events: NDArray[np.float64]
    event_names: tuple[str, ...]
    notes: tuple[str, ...]
    state: State
    contact_solver: dict[str, dict[str, int]]


def channel_statistics(
    system: System, found: Statistics, rattle: Mapping[str, Mapping[str, Any]]
) -> dict[str, dict[str, Any]]:
    """Statistics by name of the channel, see `TimeSummary`; `rattle` by mesh.

    The flanks of a mesh without load touch and leave at each step: its contact numbers are NaN.
    """
    rows: dict[str, dict[str, Any]] = {}
    for k, channel in enumerate(system.layout.channels):
        row = rows[channel.name] = {
            "unit": channel.unit,
            "mean": float(found.mean[k]),
            "rms": float(found.rms[k]),
            "min": float(found.least[k]),
            "max": float(found.most[k]),
        }
        if channel.name.startswith("contact_state["):
            row["share_zero"] = float(found.share_zero[k])
            row |= rattle[channel.name[len("contact_state[") : -1]]
    for mesh in unloaded_meshes(system.model, rows):
        row = rows.get(f"contact_state[{mesh}]", {})
        if row.get("share_zero", 1.0) < 1.0:  # a mesh that never touches keeps its contact loss
            row |= dict.fromkeys(CONTACT_NUMBERS, math.nan)
    return rows
