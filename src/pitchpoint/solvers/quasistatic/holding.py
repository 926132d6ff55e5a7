# SPDX-License-Identifier: Apache-2.0
"""Holding torques of a slow roll: the drive, balancing torque or held body that each of them belongs to.

At zero speed no inertia takes the alternating part of a load. The torque of a drive and a balancing torque
therefore follow the loads from position to position, and every body is in balance. Other held bodies have a
holding torque only if the loads do not balance.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.elements.kind import DRIVE
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads, balancing_spins
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.solve import Equilibrium, find_equilibrium
from pitchpoint.solvers.gear_trains import driven_coordinates, rotations
from pitchpoint.solvers.quasistatic.path import rolled_on
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system.system import State, System

PRECISE = 1e-9
"""Relative change of a balancing torque below which a position is in balance."""
MAX_ITERATIONS = 10
"""Largest number of equilibria per position for a balancing torque at another body of the train."""

DIVISIONS = (2, 3, 5)
"""Parts of a step of a roll in which the next equilibrium is searched if it is not found at once."""


@dataclass(frozen=True)
class Holding:
    """Owners of the holding torques of a roll.

    Parameters
    ----------
    held
        Held spins.
    drives
        Constraint row of the drive, by position among the held spins.
    balancing
        Record of the balancing torque on the held body, by position among the held spins.
    through
        Record of a balancing torque that holds the rotated body through its train, and its ratio to the
        holding torque there; None if there is none.
    bodies
        Body, of a shaft the station, by position among the held spins without drive and balancing torque.
    """

    held: tuple[int, ...]
    drives: dict[int, int]
    balancing: dict[int, int]
    through: tuple[int, float] | None
    bodies: dict[int, str]

    @classmethod
    def of(cls, system: System, held: Sequence[int]) -> Holding:
        """Owners of the holding torques on some spins, of which the first one is rotated.

        Through closed loops, whose ratios vary, a balancing torque on another body remains constant.
        """
        numbers = (int(record["row"]) for record in system.rows(DRIVE))
        rows = dict(zip(driven_coordinates(system), numbers, strict=True))
        torques = dict(zip(balancing_spins(system), balancing_loads(system), strict=True))
        drives = {k: rows[spin] for k, spin in enumerate(held) if spin in rows}
        balancing = {k: torques[s] for k, s in enumerate(held) if s in torques and k not in drives}
        through = None
        if not is_looped(system) and 0 not in drives and 0 not in balancing:
            # virtual work of a rotation of the first spin with the other held ones at rest
            rates = rotations(system, held)[:, 0]
            through = next(
                ((k, 1.0 / float(rates[s])) for s, k in torques.items() if s not in held and rates[s] != 0.0),
                None,
            )
        owned = {*drives, *balancing, *((0,) if through else ())}
        names = {k: system.layout.coordinates[spin].rsplit(".", 1)[0] for k, spin in enumerate(held)}
        return cls(
            tuple(held), drives, balancing, through, {k: n for k, n in names.items() if k not in owned}
        )

    def equilibrium(self, system: System, start: State) -> Equilibrium:
        """Equilibrium at a position; the balancing torques of the system change in place to hold it.

        The reactions that remain are those of drives and of bodies without a balancing torque.
        """
        torques = system.records[LOAD]["value"] if LOAD in system.records else np.zeros(0)
        found, last = find_equilibrium(system, start, self.held), np.inf
        if self.through is not None:
            record, ratio = self.through
            for _ in range(MAX_ITERATIONS):
                change = ratio * float(found.reaction[0])
                if abs(change) <= PRECISE * abs(torques[record]) or abs(change) > 0.5 * last:
                    break  # in balance, or as close to it as rounding permits
                torques[record] += change
                found, last = find_equilibrium(system, found.state, self.held, near=True), abs(change)
        left = found.reaction.copy()
        for place, record in self.balancing.items():
            torques[record] += left[place]
            left[place] = 0.0
        return replace(found, reaction=left)

    def reach(
        self, system: System, start: State, last: State | None, spin: int, step: float, rates: Array
    ) -> Equilibrium:
        """Equilibrium at the next position of a roll; if it is not found from there, in smaller steps.

        Parameters
        ----------
        system
            The system.
        start
            State in which the search begins.
        last
            Equilibrium at the position before; None at the first one.
        spin, step, rates
            Rotation from there, as in `path.rolled_on`.
        """
        try:
            return self.equilibrium(system, start)
        except SolverError:
            if last is None:
                raise
            for parts in DIVISIONS:
                try:
                    state = last
                    for _ in range(parts):
                        found = self.equilibrium(system, rolled_on(system, state, spin, step / parts, rates))
                        state = found.state
                except SolverError:
                    continue
                return found
            raise

    def observe(self, system: System, found: Equilibrium) -> Array:
        """All channels at an equilibrium, with the torques of the drives."""
        states = (self._driven(state, found.reaction) for state in (found.state, *found.other_sides))
        here, *others = states
        return replace(found, state=here, other_sides=tuple(others)).observe(system)

    def _driven(self, state: State, reaction: Array) -> State:
        """Copy of a state with the torques of the drives."""
        new = state.copy()
        new.lam[list(self.drives.values())] = -reaction[list(self.drives)]
        return new

    def others(self, reaction: Array) -> dict[str, Array]:
        """Holding torques [N m] of bodies without drive and balancing torque, from those of all held spins.

        Shapes (n,) by body from (n, len(held)).
        """
        return {body: reaction[:, k] for k, body in self.bodies.items()}
