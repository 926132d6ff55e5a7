# SPDX-License-Identifier: Apache-2.0
"""Steps of an equilibrium iteration that do not carry a body through another one.

Bodies that are not in contact move freely along their loads, and a long step would end behind a cylinder or
ball. A relative motion of length d changes a gap by at most d, so a step is followed in parts that no gap is
too small for, until one closes (conservative advancement: B. Mirtich, *Impulse-based Dynamic Simulation of
Rigid Body Systems*, 1996), and is cut off there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.units import format_quantity
from pitchpoint.elements import registry
from pitchpoint.elements.contacts.record import EVENTS
from pitchpoint.solvers.equilibrium.unknowns import step_on
from pitchpoint.system import evaluate
from pitchpoint.system.source import coordinate_source, source
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

TOUCH = 1e-6
"""Penetration [m] up to which a step may close a gap."""
DEEPER = 10.0
"""Factor by which a step may increase a penetration."""
PARTS = 100
"""Number of parts after which a step is cut off."""
FAR = 1e3
"""Gap [m] of bodies that are too far apart for a contact to be searched."""
ROUNDED = 1e-6
"""Relative error of rates and steps."""


@dataclass(frozen=True)
class Contacts:
    """Contacts whose gaps limit the steps.

    Parameters
    ----------
    names
        Kind and name of each contact.
    events
        Their event functions, which are the gaps [m], shape (n,).
    moves
        Length [m] by which each coordinate moves the bodies of a contact relative to each other, per unit,
        shape (n, nd).
    """

    names: tuple[tuple[str, str], ...]
    events: NDArray[np.int64]
    moves: Array

    @classmethod
    def of(cls, system: System) -> Contacts:
        """All contacts of curves and surfaces of a system."""
        names, events, moves = [], [], []
        for kind, bank in system.records.items():
            if registry.find(kind).events is not EVENTS:
                continue
            for k, record in enumerate(bank):
                names.append((kind, system.names[kind][k] if kind in system.names else str(k + 1)))
                events.append(int(record["ev"]))
                moves.append(_moves(system, int(record["i"]), int(record["j"])))
        return cls(tuple(names), np.array(events, np.int64), np.reshape(moves, (-1, system.sizes["nd"])))

    def gaps(self, system: System, state: State) -> Array:
        """Gaps of a state [m], at most `FAR`, shape (n,)."""
        found: Array = np.minimum(evaluate.event_values(system, state)[self.events], FAR)
        return found

    def step_on(self, system: System, state: State, free: NDArray[np.int64], step: Array) -> State:
        """Copy of a state after a step of the free coordinates, or after its part up to a contact.

        Parameters
        ----------
        system, state
            The system and the state before the step.
        free, step
            Coordinates that may move, and their changes, shape (n,).
        """
        speed = self.moves[:, free] @ np.abs(step)
        if not speed.any():
            return step_on(system, state, free, step)
        gaps = self.gaps(system, state)
        least = np.where(gaps > 0.0, -TOUCH, DEEPER * gaps - TOUCH)
        enough = np.where(gaps > 0.0, TOUCH, -0.5 * least)
        share = 0.0
        for _ in range(PARTS):
            room = gaps - least
            part = min(float(np.min(room[speed > 0.0] / speed[speed > 0.0])), 1.0 - share)
            reached = step_on(system, state, free, (share + part) * step)
            there = self.gaps(system, reached)
            rate = np.abs(there - gaps) / part
            if (rate > speed * (1.0 + ROUNDED)).any():  # more than expected: a shorter part
                speed = np.maximum(speed, rate)
                continue
            share, gaps, speed = share + part, there, np.maximum(rate, 0.5 * speed)
            if share > 1.0 - ROUNDED:
                return reached
            if (gaps - least <= enough).any():
                break
        return step_on(system, state, free, share * step)


def line_and_open_contacts(system: System, state: State, name: str) -> str:
    """Line of a coordinate in the model file, and the open contacts of its body, to follow its name.

    Parameters
    ----------
    system, state
        The system and its initial state.
    name
        Body and coordinate, such as "ball.z".
    """
    contacts = Contacts.of(system)
    line, body = coordinate_source(system, name).removeprefix(name), name.partition(".")[0]
    if not contacts.names or body not in system.layout.bodies:
        return line
    own = list(_coordinates(system, system.layout.bodies.index(body)))
    found = [
        f"{source(system, *of)} is open by {format_quantity(float(gap), 'length', 3)}"
        for of, gap, moves in zip(contacts.names, contacts.gaps(system, state), contacts.moves, strict=True)
        if 0.0 < gap < FAR and moves[own].any()
    ]
    return f"{line}; at the start {' and '.join(found)}" if found else line


def _coordinates(system: System, body: int) -> set[int]:
    """Coordinates that move a body."""
    own = system.program["body"][body]
    paths = system.program["path"][int(own["first"]) : int(own["first"]) + int(own["count"])]
    return {int(p["dof"]) + k for p in paths for k in range(int(p["n"]))}


def _moves(system: System, i: int, j: int) -> Array:
    """Length by which each coordinate moves body i relative to body j, per unit."""
    found = np.zeros(system.sizes["nd"])
    own = list(_coordinates(system, i) ^ _coordinates(system, j))  # common ones move both as one body
    found[own] = system.weight[own]
    return found
