# SPDX-License-Identifier: Apache-2.0
"""The receiver of the samples of a run, and the summary of a finished run."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system.system import State


class Sink(Protocol):
    """Anything that takes samples as they come, such as a result file."""

    def append(self, t: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Take n samples: times [s], shape (n,), and all channels, or those requested, shape (n, no)."""


@dataclass
class Memory:
    """A sink that keeps everything."""

    times: list[NDArray[np.float64]] = field(default_factory=list)
    rows: list[NDArray[np.float64]] = field(default_factory=list)

    def append(self, t: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Keep samples."""
        self.times.append(t)
        self.rows.append(values)


@dataclass(frozen=True)
class TimeSummary:
    """What a run did.

    Parameters
    ----------
    status, sentence
        How it ended, as a number and in words.
    steps, step, wall_s
        Accepted steps, time step (0 if adaptive) [s], wall time [s]. A last step may be shorter.
    t_end
        Time reached [s].
    window
        Begin and end of the statistics [s].
    channels
        Statistics by channel over all steps of the window: unit, mean, rms of the alternating part, min, max,
        and share_zero of a contact state: the share of the steps without contact; NaN if it ended before any.
    events
        Time [s], index in `event_names`, direction; shape (n, 3).
    event_names
        Names of the event functions.
    notes
        What the user should know, in sentences.
    state
        State reached. A run can continue from it, but a drive by formula or function is followed up to the
        duration of its scenario only.
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
