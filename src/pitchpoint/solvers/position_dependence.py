# SPDX-License-Identifier: Apache-2.0
"""Position dependence of a linearisation: bodies and elements whose matrices change as bodies rotate."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import BETWEEN, SINGLE
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.element_tangents import switched
from pitchpoint.solvers.gear_trains import driven_coordinates, held_spins, rotations
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Choice = dict[str, NDArray[np.int64]]

FACTORS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""Factors of acceleration, rate and coordinate for the matrices M, D and K."""
LATER = (1.0, 2.3)
"""Rotation [rad] of the fastest spin to the positions at which the matrices are compared."""
SAME = 1e-8
"""Relative change of a mass-scaled matrix that counts as rounding."""


def ways_to_turn(system: System, state: State, turning: Collection[int]) -> Array:
    """Rates of the rotation of a system, scaled to a maximum of 1.

    Parameters
    ----------
    system, state
        The system and its operating point, whose rates are used unless the system is at rest.
    turning
        For a system at rest: bodies that may rotate, with their trains, if they are free.

    Returns
    -------
    ndarray, shape (nd,)
        Zeros if nothing rotates or can rotate.
    """
    rates = state.v
    if not rates.any():
        free = rotations(system, held_spins(system)[len(driven_coordinates(system)) :])
        own = [int(s) for s in system.program["body"]["spin"][sorted(turning)] if s >= 0]
        free = free[:, np.abs(free[own]).any(axis=0)]
        # trains at different rates, so that their changes do not cancel
        rates = free @ (1.0 + 0.37 * np.arange(free.shape[1]))
    top = float(np.abs(rates).max(initial=0.0))
    return rates / top if top > 0.0 else np.zeros(rates.size)


def _later(state: State, rates: Array) -> list[State]:
    """Copies of the operating point with all rotations advanced."""
    found = []
    for angle in LATER:
        moved = state.copy()
        moved.q = state.q + rates * angle
        found.append(moved)
    return found


def changing(system: System, state: State, eligible: Choice, rates: Array) -> tuple[Choice, list[int]]:
    """Elements and bodies whose matrices change as the system rotates.

    Parameters
    ----------
    system, state
        The system and its operating point.
    eligible
        Records of the elements to check, by kind.
    rates
        Rates of the rotation, see `ways_to_turn`.
    """
    states = [state, *_later(state, rates)]
    rows, columns, places = system.layout.entries
    scale = np.sqrt(np.diag(evaluate.matrix(system, state, 1.0, 0.0, 0.0)))
    size = scale[rows] * scale[columns]
    rate = float(np.abs(state.v).max(initial=0.0)) or 1.0

    def request() -> list[Array]:
        """Entries of M, D and K at all positions, scaled by the masses and the fastest spin."""
        return [
            np.array(
                [evaluate.blocks(system, s, *f).reshape(-1)[places] / (size * rate**power) for s in states]
            )
            for power, f in enumerate(FACTORS)
        ]

    with switched(system, {}):
        bare = request()
    elements: Choice = {}
    for kind in [k for k in eligible if registry.find(k).scope == BETWEEN and eligible[k].size]:
        found = []
        for k in eligible[kind]:
            with switched(system, {kind: slice(int(k), int(k) + 1)}):
                own = [a - b for a, b in zip(request(), bare, strict=True)]
            if any(_varies(a).any() for a in own):
                found.append(int(k))
        if found:
            elements[kind] = np.array(found, np.int64)
    single = [kind for kind in eligible if registry.find(kind).scope == SINGLE]
    if single:
        with switched(system, dict.fromkeys(single, slice(None))):
            bare = [np.where(_varies(a - b), a, b) for a, b in zip(request(), bare, strict=True)]
    varies = np.any([_varies(a) for a in bare], axis=0)
    own_rows = np.unique(rows[varies])
    body = system.program["body"]
    moving = [
        b
        for b in range(1, body.size)
        if np.any((own_rows >= body[b]["dof"]) & (own_rows < body[b]["dof"] + body[b]["n"]))
    ]
    return elements, [b for b in moving if body[b]["joint"] == GENERAL]


def _varies(entries: Array) -> NDArray[np.bool_]:
    """Entries that differ between the positions (first axis)."""
    return np.asarray(np.ptp(entries, axis=0) > SAME * np.abs(entries).max(initial=1.0))
