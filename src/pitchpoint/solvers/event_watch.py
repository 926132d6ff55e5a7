# SPDX-License-Identifier: Apache-2.0
"""Events requested by a scenario, and their names by direction of the sign change."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.system.system import System

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario

#: Event functions of each request.
FUNCTIONS = {
    "pair_entry": ("pair_entry", "back_pair_entry"),
    "pair_exit": ("pair_exit", "back_pair_exit"),
    "contact": ("front_gap", "back_gap", "contact"),
    "sliding_reversal": ("sliding_reversal", "back_sliding_reversal", "turning_reversal"),
    "stick_slip": ("slip_reversal", "slip", "forward_slip", "backward_slip"),
}

#: In reverse rotation a pair enters at the end of its path of contact and leaves at the start.
BACKWARDS = {
    "pair_entry": "pair_exit",
    "pair_exit": "pair_entry",
    "back_pair_entry": "back_pair_exit",
    "back_pair_exit": "back_pair_entry",
}

MAX_EVENTS = 100_000
"""Maximum number of events recorded per chunk."""


def bending(system: System) -> NDArray[np.int64]:
    """Flags of event functions at whose zeros forces have a jump or a kink, shape (ne,)."""
    flags = np.zeros(len(system.layout.events), np.int64)
    for name, bank in system.records.items():
        kind = registry.find(name)
        names = [event[0] for event in kind.events]
        for record in bank if names else ():
            bends = kind.bends_of(record)
            first = int(record["ev"])
            flags[first : first + len(names)] = [event in bends for event in names]
    return flags


class EventWatch:
    """Selection of the events of a scenario; false if it requests none.

    Parameters
    ----------
    system
        The system.
    scenario
        The scenario with its `events`.
    """

    def __init__(self, system: System, scenario: Scenario) -> None:
        wanted = {name for request in scenario.events for name in FUNCTIONS[request]}
        index = {event.name: k for k, event in enumerate(system.layout.events)}
        self._named = np.zeros((2, len(index)), np.int64)  # rising, falling
        kept = np.zeros(len(index), bool)
        for name, k in index.items():
            kind, _, mesh = name.partition("[")
            falling = BACKWARDS.get(kind, kind)
            self._named[:, k] = k, index[f"{falling}[{mesh}"]
            kept[k] = kind in wanted
        self._kept = kept
        #: Flags of event functions requested in at least one direction: steps may end at their zeros.
        self.functions = (kept[self._named[0]] | kept[self._named[1]]).astype(np.int64)
        #: The same with all jumps and kinks of forces: explicit methods cannot detect them otherwise.
        self.ends = self.functions | bending(system) if kept.any() else self.functions

    def __bool__(self) -> bool:
        return bool(self._kept.any())

    @property
    def room(self) -> int:
        """Maximum number of events recorded per chunk."""
        return MAX_EVENTS if self else 0

    def pick(self, found: NDArray[np.float64]) -> NDArray[np.float64]:
        """Requested events, named by the direction of the sign change.

        Parameters
        ----------
        found
            Sign changes: time [s], event function, direction; shape (n, 3).

        Returns
        -------
        numpy.ndarray
            Time [s], event, direction (1: value or mesh phase rises); shape (m, 3).
        """
        events = found.copy()
        falls = (found[:, 2] < 0.0).astype(int)
        events[:, 1] = self._named[falls, found[:, 1].astype(int)]
        kept: NDArray[np.float64] = events[self._kept[events[:, 1].astype(int)]]
        return kept
