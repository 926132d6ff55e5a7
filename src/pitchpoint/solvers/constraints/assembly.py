# SPDX-License-Identifier: Apache-2.0
"""Consistent initial conditions: closed loops, consistent rates, degrees of freedom.

Positions follow from Gauss-Newton steps of minimum weighted norm, so that every loop closes with the smallest
displacement from the design position; given coordinates are fixed. Rates follow from one linear solution:
given rates are fixed, the others change as little as possible.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.system import evaluate
from pitchpoint.system.elastic import modal_bodies
from pitchpoint.system.source import row_source, row_unit
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

MAX_STEPS = 60
CLOSED = 2e-15
"""Largest residual of a closed row, relative to its coordinates [m/m, rad/rad]."""
OPEN = 1e-8
"""Residual from which a loop counts as open: above the residuals of rounding and double roots."""
REDUNDANT = 1e-9
"""Singular value over the largest below which rows count as redundant."""
STIFF = 1e4
"""Weight of modal coordinates of elastic bodies: loops are closed by rigid motion if possible."""
MAX_TURN = 0.3
"""Largest step of an angle [rad]: the rows are too nonlinear beyond it."""


@dataclass(frozen=True)
class Assembly:
    """A state that satisfies the constraints.

    Parameters
    ----------
    state
        The state; accelerations and multipliers are unchanged.
    freedoms
        Number of degrees of freedom.
    redundant
        Names of redundant rows: their reactions cannot be determined uniquely.
    moved
        Largest change of a coordinate, and its name.
    unit
        Unit of this change, m or rad.
    """

    state: State
    freedoms: int
    redundant: tuple[str, ...]
    moved: tuple[float, str]
    unit: str

    def report(self) -> tuple[str, ...]:
        """Notes in addition to those on redundant rows (`row_notes`)."""
        size, name = self.moved
        return (f"loops were closed by moving {name} by {size:.4g} {self.unit}",) if size > 1e-6 else ()


def assemble_state(
    system: System,
    state: State | None = None,
    *,
    keep: Collection[int] = (),
    keep_rates: Collection[int] = (),
) -> Assembly:
    """Close all loops and make the rates consistent.

    Parameters
    ----------
    system
        The compiled system.
    state
        Initial guess; default the initial state.
    keep, keep_rates
        Coordinates whose value, and whose rate, must not change.

    Raises
    ------
    SolverError
        If a loop cannot be closed or the given rates contradict the constraints; the rows are named.
    """
    found = (system.initial_state() if state is None else state).copy()
    if system.sizes["nc"] == 0:
        return Assembly(found, system.sizes["nd"], (), (0.0, ""), "m")
    begun = found.q.copy()
    _walk(system, found, keep)
    _close(system, found, keep)
    G, gt = _rows(system, found)
    _match_rates(system, found, G, gt, keep_rates)
    weighted = G / system.weight
    redundant = _repeated(weighted)
    # coordinates change, too, if a rotation chart is reset
    change = np.abs(found.q - begun)
    largest = int(np.argmax(change))
    return Assembly(
        found,
        system.sizes["nd"] - (len(G) - len(redundant)),
        tuple(system.layout.rows[r] for r in redundant),
        (float(change[largest]), system.layout.coordinates[largest]),
        "rad" if system.weight[largest] != 1.0 else "m",
    )


def close_loops(system: System, state: State, keep: Collection[int] = (), *, drawn: bool = False) -> State:
    """Close all loops near a state without changing its rates; rows of prescribed motions are omitted.

    Parameters
    ----------
    system, state
        The system and the initial guess.
    keep
        Coordinates that must not change.
    drawn
        Close open loops by moving the coordinates `keep` from the design position in short steps.

    Raises
    ------
    SolverError
        If a loop cannot be closed; the rows are named.
    """
    found = state.copy()
    if drawn:
        evaluate.residual(system, found)
        if np.abs(system.workspace.g[loop_rows(system)]).max(initial=0.0) > OPEN:
            _walk(system, found, keep)
    _close(system, found, keep, loop_rows(system))
    return found


def _walk(system: System, state: State, keep: Collection[int]) -> None:
    """Improve the guess of the other coordinates by moving those of `keep` from the design position in steps.

    From a distant guess loops may not close, or close in the other assembly configuration; the configuration
    of the design position is retained.
    """
    kept = np.fromiter(keep, int, len(keep))
    turns = np.abs(state.q[kept]) / MAX_TURN
    count = int(np.ceil(turns.max(initial=0.0)))
    if count <= 1:
        return
    here = state.copy()
    here.q[:] = 0.0
    here.charts[:] = np.eye(3)
    target = state.q[kept]
    try:
        _close(system, here, (), loop_rows(system))
        for share in np.linspace(0.0, 1.0, count + 1)[1:]:
            here.q[kept] = share * target
            _close(system, here, keep, loop_rows(system))
    except SolverError:
        return  # the loops do not close in the design position or on the path
    others = np.setdiff1d(np.arange(state.q.size), kept)
    state.q[others], state.charts[:] = here.q[others], here.charts


def loop_rows(system: System) -> list[int]:
    """Indices of all rows but those of prescribed motions."""
    return [r for r, name in enumerate(system.layout.rows) if not name.startswith("drive ")]


def _rows(system: System, state: State) -> tuple[Array, Array]:
    """Rows G and their partial time derivatives at a state; g is stored in the workspace."""
    G = evaluate.constraint_jacobian(system, state)
    return G, system.workspace.gt.copy()


def _close(system: System, state: State, keep: Collection[int], rows: list[int] | None = None) -> None:
    """Iterate the coordinates until all rows, or the chosen ones, are satisfied."""
    chosen = slice(None) if rows is None else rows
    if system.sizes["nc"] == 0 or rows == []:
        return
    free = np.setdiff1d(np.arange(system.sizes["nd"]), np.fromiter(keep, int, len(keep)))
    turning = system.weight[free] != 1.0
    weight = _reluctance(system)[free]
    last = np.inf
    for _ in range(MAX_STEPS):
        G = _rows(system, state)[0][chosen]
        g = system.workspace.g[chosen].copy()
        size = float(np.abs(g).max())
        scale = 1.0 + float(np.abs(state.q[free]).max(initial=0.0))
        if size <= CLOSED * scale:
            return
        step = -_least(G[:, free] / weight, g) / weight
        if size <= OPEN and size >= 0.5 * last:
            return  # limited by rounding or a double root
        last = size
        longest = float(np.abs(step[turning]).max(initial=0.0))
        state.q[free] += step * min(1.0, MAX_TURN / longest if longest > 0.0 else 1.0)
    evaluate.residual(system, state)
    if np.abs(system.workspace.g[chosen]).max() <= OPEN:
        return
    _approach(system, state, free, chosen)
    g = np.zeros(system.sizes["nc"])
    g[chosen] = np.abs(system.workspace.g[chosen])
    if g.max() > OPEN:
        raise SolverError(f"loops do not close: {_off(system, g)} at best", INCONSISTENT, state)


def _approach(system: System, state: State, free: NDArray[np.intp], chosen: Any) -> None:
    """Minimise the residual of the rows over the free coordinates, for the error message."""
    from scipy.optimize import least_squares

    def off(q: Array) -> Array:
        """Residual of the chosen rows at coordinates q."""
        state.q[free] = q
        _rows(system, state)
        return system.workspace.g[chosen].copy()

    def slope(q: Array) -> Array:
        """Derivative of the chosen rows with respect to the free coordinates."""
        state.q[free] = q
        return _rows(system, state)[0][chosen][:, free]

    off(least_squares(off, state.q[free], slope).x)


def _reluctance(system: System) -> Array:
    """Weights of the coordinates in closing loops; elastic bodies deform only if necessary."""
    found = system.weight.copy()
    body = system.program["body"]
    for hidden in modal_bodies(system):
        first, n = int(body[hidden]["dof"]), int(body[hidden]["n"])
        found[first : first + n] *= STIFF
    return found


def _off(system: System, g: Array) -> str:
    """List of the rows with the largest residuals, as text."""
    worst = [r for r in np.argsort(-g)[:3] if g[r] > max(OPEN, 0.01 * g.max())]
    return "; ".join(f"{row_source(system, r)} is off by {g[r]:.3g}{row_unit(system, r)}" for r in worst)


def _least(A: Array, b: Array) -> Array:
    """Minimum-norm solution of A x = b; rows may be redundant."""
    return np.asarray(np.linalg.lstsq(A, b, rcond=REDUNDANT)[0])


def _match_rates(system: System, state: State, G: Array, gt: Array, keep: Collection[int]) -> None:
    """Change the rates as little as possible until G v = -gt."""
    free = np.setdiff1d(np.arange(system.sizes["nd"]), np.fromiter(keep, int, len(keep)))
    weight = _reluctance(system)[free]
    off = G @ state.v + gt
    state.v[free] -= _least(G[:, free] / weight, off) / weight
    left = np.abs(G @ state.v + gt)
    scale = max(float((np.abs(G) @ np.abs(state.v)).max(initial=0.0)), float(np.abs(gt).max(initial=0.0)))
    if left.max() > OPEN * max(scale, 1e-3):
        worst = int(np.argmax(left))
        given = ", ".join(system.layout.coordinates[k] for k in keep) or "none"
        raise SolverError(
            f"the initial rates contradict each other: {row_source(system, worst)} would move apart at "
            f"{left[worst]:.3g}{row_unit(system, worst)} per second (given rates: {given})",
            INCONSISTENT,
            state,
        )


def _repeated(G: Array) -> list[int]:
    """Indices of rows that depend linearly on the rows before them."""
    kept: list[Array] = []
    found = []
    scale = float(np.linalg.norm(G, axis=1).max(initial=0.0))
    for r, row in enumerate(G):
        rest = row.copy()
        for _ in range(2):
            for unit in kept:
                rest = rest - (unit @ rest) * unit
        size = float(np.linalg.norm(rest))
        if size <= REDUNDANT * scale:
            found.append(r)
        else:
            kept.append(rest / size)
    return found
