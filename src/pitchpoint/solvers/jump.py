# SPDX-License-Identifier: Apache-2.0
"""Rest at a jump: where a tooth pair without relief enters or leaves, a mesh force jumps with the position.

The load may lie between the forces of both sides. The machine then rests on the surface of the jump, and what
acts there is a mean of both sides (A. F. Filippov, Differential Equations with Discontinuous Righthand Sides,
1988). Unknown are the position on the surface and the share of the other side::

    R(q) + share [R](q) = 0,    g(q) = 0,    0 <= share <= 1

with the residual R, its jump [R] and the height g over the surface.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.surfaces import Surface, heights, slopes
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

BESIDE = 1e-10
"""Distance of the states on both sides from the surface, in base pitches."""
PARALLEL = 1e-6
"""Sine of the angle between two surfaces up to which they are one, if they are nowhere apart."""
NOTHING = 1e-11
"""Distance [m] of two states that are one place."""
MOST_ITERATIONS = 40
MOST_PROJECTIONS = 5
MOST_BISECTIONS = 100
FARTHEST = 1e-2
"""Largest step [m] along a surface; an equilibrium on it is near."""


@dataclass(frozen=True)
class Rest:
    """Where an iteration came to rest.

    Parameters
    ----------
    state
        The state.
    residual
        Residual with the shares of the other sides, shape (nd,).
    other_sides
        For every jump the state rests on: the state on its other side.
    share
        Share in which that other side acts, by jump.
    """

    state: State
    residual: Array
    other_sides: tuple[State, ...] = ()
    share: Array = field(default_factory=lambda: np.zeros(0))

    @property
    def holds(self) -> bool:
        """Whether every share is one of a mean."""
        return bool(((self.share >= 0.0) & (self.share <= 1.0)).all())


def rest_on_surfaces(
    system: System, state: State, surfaces: Sequence[Surface], free: Indices, goal: Array
) -> Rest | None:
    """Rest on as many of some surfaces as possible, if there is one near a state; else where to continue.

    Parameters
    ----------
    system, state
        The system and a state near the surfaces.
    surfaces
        The surfaces.
    free
        Coordinates that may move.
    goal
        Largest force that may be left over on each of them [N].

    Returns
    -------
    Rest or None
        If it does not `Rest.holds`, its state is the one from which an iteration leaves the surface: no
        mean of both sides keeps it there. None if the iteration fails.
    """
    different = _different(system, state, surfaces, free)
    aside = None
    for n in range(len(different), 0, -1):
        for chosen in combinations(different, n):
            found = _rest_on(system, state, chosen, free, goal)
            if found is not None and found.holds:
                return found
            aside = aside or found
    return aside


def _different(system: System, state: State, surfaces: Sequence[Surface], free: Indices) -> list[Surface]:
    """One of each group of surfaces that are one: equal meshes between the same bodies jump together."""
    normal = slopes(system, state, surfaces, free) / system.weight[free]
    size = np.linalg.norm(normal, axis=1)
    unit = normal / size[:, None]
    place = heights(system, state, surfaces) / size
    kept: list[int] = []
    for k in range(len(surfaces)):
        along = unit[kept] @ unit[k]
        apart = np.linalg.norm(unit[kept] - along[:, None] * unit[k], axis=1)
        off = np.abs(place[kept] - np.sign(along) * place[k]) * size[k]
        if not ((apart < PARALLEL) & (off < BESIDE)).any():
            kept.append(k)
    return [surfaces[k] for k in kept]


def rest_between(system: System, one: State, two: State, free: Indices, goal: Array) -> Rest | None:
    """Rest at a jump between two states that push towards each other.

    For jumps that no event function knows, as those of a law of the user: bisection along the step finds the
    jump, its direction is taken for that of the step.
    """
    near, far = evaluate.residual(system, one), evaluate.residual(system, two)
    step = (two.q - one.q)[free]
    for _ in range(MOST_BISECTIONS):  # of two states so far out no two numbers may be this close
        if float(np.abs((two.q - one.q) * system.weight)[free].max()) <= NOTHING:
            break
        middle = one.copy()
        middle.q[:] = 0.5 * (one.q + two.q)
        between = evaluate.residual(system, middle)
        if float(between[free] @ step) > 0.0:
            two, far = middle, between
        else:
            one, near = middle, between
    across = float((far - near)[free] @ step)
    share = -float(near[free] @ step) / across if across > 0.0 else -1.0
    rest = near + share * (far - near)
    if not 0.0 <= share <= 1.0 or bool((np.abs(rest / system.weight)[free] > goal).any()):
        return None
    return Rest(one, rest, (two,), np.array([share]))


def _rest_on(
    system: System, state: State, chosen: Sequence[Surface], free: Indices, goal: Array
) -> Rest | None:
    """Newton's method for position and shares, from a state near the surfaces."""
    size = 1.0 / system.weight[free]  # of one metre in every coordinate
    n = len(chosen)
    share = np.full(n, 0.5)
    try:
        for _ in range(MOST_ITERATIONS):
            normal = slopes(system, state, chosen, free) * size
            back = np.linalg.pinv(normal)
            state = _onto(system, state, chosen, free, size[:, None] * back)
            sides = [_moved(state, free, -size * back.sum(axis=1) * BESIDE)]
            sides += [_moved(sides[0], free, 2.0 * BESIDE * size * across) for across in back.T]
            residuals = np.stack([evaluate.residual(system, side) for side in sides], axis=1)
            stiffness = np.stack([_stiffness(system, side, free, size) for side in sides])
            parts = np.concatenate(([1.0 - share.sum()], share))  # R_0 + share (R_k - R_0)
            rest = residuals @ parts
            K = np.tensordot(parts, stiffness, 1)
            scale = float(np.abs(K).max())
            jump = (residuals[free, 1:] - residuals[free, :1]) * size[:, None]
            # on a surface a state is as exact as the distance between its sides
            rounding = BESIDE * np.abs(stiffness @ back).max(axis=(0, 2))
            if (np.abs(rest[free] * size) <= np.maximum(goal, rounding)).all():
                return _aside(
                    Rest(sides[0], rest, tuple(sides[1:]), share), normal @ np.linalg.pinv(K) @ jump
                )
            matrix = np.block([[K, jump], [scale * normal, np.zeros((n, n))]])
            values = scale * heights(system, state, chosen)
            change = -np.linalg.pinv(matrix) @ np.concatenate((rest[free] * size, values))
            if float(np.abs(change[: len(free)]).max()) > FARTHEST:
                return None
            state, share = _moved(state, free, size * change[: len(free)]), share + change[len(free) :]
    except SolverError:
        pass
    return None


def _onto(system: System, state: State, chosen: Sequence[Surface], free: Indices, back: Array) -> State:
    """A state moved onto surfaces, which are curved, so closely that both sides lie on different sides."""
    for _ in range(MOST_PROJECTIONS):
        height = heights(system, state, chosen)
        if np.abs(height).max() < 0.01 * BESIDE:
            break
        state = _moved(state, free, -back @ height)
    return state


def _aside(found: Rest, across: Array) -> Rest:
    """A rest whose shares are not a mean, moved to the sides where the residual leads away.

    There that is the jump times the excess of the share; `across` is where a jump leads, shape (n, n).
    """
    if found.holds:
        return found
    state = found.state.copy()
    for k, part in enumerate(found.share):
        if (part > 1.0) == (across[k, k] > 0.0):
            state.q += found.other_sides[k].q - found.state.q
    return Rest(state, found.residual, found.other_sides, found.share)


def _stiffness(system: System, state: State, free: Indices, size: Array) -> Array:
    """Stiffness of the free coordinates, all in metres."""
    K = evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON)
    scaled: Array = K[np.ix_(free, free)] * np.outer(size, size)
    return scaled


def observe_mean(system: System, state: State, other_sides: Sequence[State], share: Array) -> Array:
    """All observations of a state at jumps, the mean of both sides; plain numbers stay those of one side.

    Parameters
    ----------
    system, state
        The system and its state on one side.
    other_sides, share
        Per jump the state on the other side, and its share.
    """
    row = evaluate.observe(system, state)
    mean = row.copy()
    with_unit = np.array([c.unit != "1" for c in system.layout.channels])
    for other, part in zip(other_sides, share, strict=True):
        mean += np.where(with_unit, part * (evaluate.observe(system, other) - row), 0.0)
    return mean


def _moved(state: State, free: Indices, by: Array) -> State:
    """A copy of a state with its free coordinates moved."""
    new = state.copy()
    new.q[free] += by
    return new
