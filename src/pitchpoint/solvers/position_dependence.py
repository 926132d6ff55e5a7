# SPDX-License-Identifier: Apache-2.0
"""What of a linearisation changes as bodies turn: masses and linear elements, now and further on."""

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
"""Factors of acceleration, rate and coordinate that make the matrices M, D and K."""
LATER = (1.0, 2.3)
"""Angles [rad] by which the fastest spin has gone on when matrices are compared with those of now."""
SAME = 1e-8
"""Relative change of a matrix in the scale of the masses that counts as rounding."""


def ways_to_turn(system: System, state: State, turning: Collection[int]) -> Array:
    """Rates at which a system continues to turn, largest 1.

    Parameters
    ----------
    system, state
        The system and its operating point, whose rates these are unless all is at rest.
    turning
        Bodies that can begin to turn then, with their trains, if nothing holds them.

    Returns
    -------
    ndarray, shape (nd,)
        Zeros if nothing turns or could turn.
    """
    rates = state.v
    if not rates.any():
        free = rotations(system, held_spins(system)[len(driven_coordinates(system)) :])
        own = [int(s) for s in system.program["body"]["spin"][sorted(turning)] if s >= 0]
        free = free[:, np.abs(free[own]).any(axis=0)]
        # no train at the rate of another, so that one does not hide what another changes
        rates = free @ (1.0 + 0.37 * np.arange(free.shape[1]))
    top = float(np.abs(rates).max(initial=0.0))
    return rates / top if top > 0.0 else np.zeros(rates.size)


def _later(state: State, rates: Array) -> list[State]:
    """The operating point a while on: all that turns has turned."""
    found = []
    for angle in LATER:
        moved = state.copy()
        moved.q = state.q + rates * angle
        found.append(moved)
    return found


def changing(system: System, state: State, eligible: Choice, rates: Array) -> tuple[Choice, list[int]]:
    """Elements, and bodies, whose matrices change as the system turns.

    Parameters
    ----------
    system, state
        The system and its operating point.
    eligible
        Records of the elements that are tried, by kind.
    rates
        Of `ways_to_turn`.
    """
    states = [state, *_later(state, rates)]
    rows, columns, places = system.layout.entries
    scale = np.sqrt(np.diag(evaluate.matrix(system, state, 1.0, 0.0, 0.0)))
    size = scale[rows] * scale[columns]
    rate = float(np.abs(state.v).max(initial=0.0)) or 1.0

    def request() -> list[Array]:
        """Entries of M, D and K at all moments, in the scale of the masses and of the fastest spin."""
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
    """Entries that are not the same at all moments (first axis)."""
    return np.asarray(np.ptp(entries, axis=0) > SAME * np.abs(entries).max(initial=1.0))
