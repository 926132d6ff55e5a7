# SPDX-License-Identifier: Apache-2.0
"""Spins that an actuator positions, such as the pitch of a blade: they have an equilibrium and are not held.

A spin without springs, contacts or eccentric weights is free to rotate, and an equilibrium holds it. This is
not so if the torque of an actuator restores its position: the torque then decreases linearly with the angle.
A torque that varies in a revolution, as that of an engine, does not position its shaft.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.equilibrium.unknowns import without_limits
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.signals import kind_of_signals, only_signals
from pitchpoint.system.system import State, System

FARTHER = 2.5
"""Rotation after which the stiffness must be the same [rad]: no part of a revolution."""
SAME = 1e-6


def without_positioned(
    system: System, state: State, held: Sequence[int], known: Collection[int]
) -> list[int]:
    """Spins to hold, without those at rest that actuators position.

    Parameters
    ----------
    system, state
        The system and its initial guess.
    held
        Spins that would rotate freely without actuators, or are driven.
    known
        Driven ones; they remain.
    """
    asked = [k for k in held if k not in known and state.v[k] == 0.0]
    if not asked or not kind_of_signals(system):
        return list(held)
    loose = without_limits(system)
    stiffness = _stiffness(loose, state, asked)
    moved = state.copy()
    moved.q[asked] += FARTHER
    change = np.abs(_stiffness(loose, moved, asked) - stiffness)
    positioned = {k for k, s, d in zip(asked, stiffness, change, strict=True) if s > 0.0 and d <= SAME * s}
    return [k for k in held if k not in positioned]


def _stiffness(system: System, state: State, places: Sequence[int]) -> NDArray[np.float64]:
    """Derivative of the torque of actuators on each coordinate by the coordinate [N m/rad], shape (n,)."""
    rows, columns, where = system.layout.entries
    own = [int(where[(rows == k) & (columns == k)][0]) for k in places]
    found = []
    for signals in (True, False):
        with only_signals(system, signals):
            found.append(evaluate.blocks(system, state, 0.0, 0.0, 1.0, NEWTON).reshape(-1)[own])
    return np.asarray(found[0] - found[1])
