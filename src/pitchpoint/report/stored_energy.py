# SPDX-License-Identifier: Apache-2.0
"""Energy that elastic elements store between the ends of a run: the work of their own forces at rest.

The energy at a position is the integral of the forces along the way to it from the undeflected machine with
the same rotation of its trains. Teeth and contacts record their energy as a channel.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import BETWEEN, COORDINATE, FRAME
from pitchpoint.report.scene.motion import coordinates
from pitchpoint.solvers.element_tangents import switched
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.gear_trains import free_spins, rotations
from pitchpoint.system import evaluate

if TYPE_CHECKING:
    from collections.abc import Callable

    from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Places = NDArray[np.int64]

TURN = 2.0 * math.pi
NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
"""Points along the way: exact for linear springs, about 1 % of the part beyond a clearance otherwise."""


def elastic_kinds(system: System) -> tuple[str, ...]:
    """Kinds whose energy follows from their forces at rest: springs; no teeth, contacts, loads or joints."""
    found = []
    for name, records in system.records.items():
        kind = registry.find(name)
        own = not callable(kind.outputs) and any(row[0] == "elastic_energy" for row in kind.outputs)
        plain = kind.scope == BETWEEN and not (kind.role or kind.rows or own)
        if records.size and plain and kind.channel in (FRAME, COORDINATE):
            found.append(name)
    return tuple(found)


def move_to(system: System, state: State, q: Array) -> None:
    """Put a state to rest at some coordinates, with whole turns."""
    spins = system.program["body"]["spin"]
    state.q[:], state.v[:] = q, 0.0
    turning = np.flatnonzero(spins >= 0)
    state.turns[turning] = np.rint(q[spins[turning]] / TURN)
    state.q[spins[turning]] -= TURN * state.turns[turning]


class Deflections:
    """Deflections of a machine at both ends of a run.

    Parameters
    ----------
    system
        The machine.
    read
        Function that returns a channel at both ends, shape (2,), or None.

    Attributes
    ----------
    known
        Whether the result determines them: not in machines with closed loops, tumbling bodies, or
        displacements that were not stored.
    """

    def __init__(self, system: System, read: Callable[[str], Array | None]) -> None:
        self.system = system
        self.ends, _, unknown = coordinates(system, 2, read)
        self.known = not (unknown or is_looped(system) or len(system.initial_state().charts))
        held = list(free_spins(system))
        motions = rotations(system, held)
        share = np.linalg.lstsq(motions, self.ends.T, rcond=None)[0] if held else np.zeros((0, 2))
        self.rigid = (motions @ share).T if held else 0.0 * self.ends

    def change(self, on: Mapping[str, slice | Places]) -> float:
        """Change of the energy of some elements, by kind, over the run [J]."""
        if not on or not self.known:
            return 0.0
        with switched(self.system, on):
            first, last = (self._energy(begin, end) for begin, end in zip(self.rigid, self.ends, strict=True))
        return last - first

    def _energy(self, begin: Array, end: Array) -> float:
        """Work of the forces from one position to another at rest [J]."""
        step = end - begin
        return float(
            sum(
                0.5
                * weight
                * (evaluate.residual(self.system, self._at(begin + 0.5 * (1.0 + x) * step)) @ step)
                for x, weight in zip(NODES, WEIGHTS, strict=True)
            )
        )

    def _at(self, q: Array) -> State:
        """State at rest at some coordinates."""
        state = self.system.initial_state()
        move_to(self.system, state, q)
        return state
