# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of a speed sweep: loads depend on the speed, and so does the ripple that they cause."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import note
from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import listed
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
from pitchpoint.solvers.gear_trains import driven_coordinates, held_spins
from pitchpoint.solvers.initial_state.start import Start
from pitchpoint.solvers.load_cycle import load_cycle
from pitchpoint.solvers.speed_drift import instability
from pitchpoint.solvers.speed_stability import UnstableSpeed
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


class Balances:
    """Balancing torques and ripples at every speed of a sweep.

    Parameters
    ----------
    begin
        Start of the sweep at its first speed.
    speeds
        All speeds [rad/s] in the order of computation.
    start_at
        Start at a speed; raises SolverError if there is none.
    """

    def __init__(self, begin: Start, speeds: Iterable[float], start_at: Callable[[float], Start]) -> None:
        self.loads = balancing_loads(begin.system)
        self.own = begin.system.copy()
        """System for computations outside the run."""
        first, *others = dict.fromkeys(speeds)
        self.starts = {first: begin} | {speed: start_at(speed) for speed in others if self.loads}
        self.torques = {
            speed: start.system.records[LOAD]["value"][self.loads].copy()
            for speed, start in self.starts.items()
            if self.loads
        }

    def set(self, system: System, now: State, before: float, after: float) -> Array | float:
        """Set the torques of the speed `after`; returns the change of the ripple of the rates [rad/s].

        The phases of the loads are those of the present state.
        """
        if before == after or not self.loads:
            return 0.0
        system.records[LOAD]["value"][self.loads] = self.torques[after]
        return self._ripple(now, after) - self._ripple(now, before)

    def _ripple(self, now: State, speed: float) -> Array | float:
        """Ripple of the rates [rad/s] in the steady motion at a speed, at the present phases of the loads."""
        start = self.starts[speed]
        if start.cycle is None:
            return 0.0
        state = now.copy()
        state.v[:] = start.mean.v
        own = self.own
        cycle = load_cycle(own, state, held_spins(own), driven_coordinates(own))
        return 0.0 if cycle is None else cycle.offset

    def allowance(self, spin: int, speed: float, window: float) -> float:
        """Deviation of a mean rate [rad/s] over a window [s] that cuts the ripple of the loads."""
        start = self.starts.get(speed)
        return 0.0 if start is None or start.cycle is None else start.cycle.allowance(spin, window)

    def unstable(self, speed: float) -> UnstableSpeed | None:
        """Growth of a deviation from a speed, if it is unstable."""
        start = self.starts.get(speed)
        return None if start is None else instability(start)

    def notes(self) -> tuple[str, ...]:
        """Note on speeds after the first one at which the ripple is unknown."""
        speeds = [s for s, start in self.starts.items() if start.cycle is not None and not start.cycle.steady]
        if not speeds[1:]:
            return ()
        words = listed([format_quantity(speed, "angular_speed", 4) for speed in speeds])
        remedy = "drive the body, increase its inertia or speed, or reduce the ripple of the load"
        return (note(f"no steady motion under the loads was found at {words}", "", remedy),)
