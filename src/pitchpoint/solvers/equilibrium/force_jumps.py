# SPDX-License-Identifier: Apache-2.0
"""Equilibrium at a force jump: mesh forces are discontinuous where tooth pairs without relief enter or exit.

If the load is between the forces on both sides, the equilibrium is on the surface of the jump, and the force
there is a weighted mean of both sides (A. F. Filippov, Differential Equations with Discontinuous Righthand
Sides, 1988). The unknowns are the position on the surface and the weight (share) of the other side::

    R(q) + share [R](q) = 0,    g(q) = 0,    0 <= share <= 1

with the residual R, its jump [R] and the distance g from the surface.

A spur pair enters over its whole width simultaneously, a sliced helical pair slice by slice; with the exact
integral over the face width helical pairs enter smoothly. The distances from the surfaces follow from the
event functions of the mesh, in base pitches.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.elements.mesh.record import PHASE
from pitchpoint.solvers.element_batches import blocks_of
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_places, mesh_record, shared_width
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

JUMPS = {"pair_entry": 1.0, "pair_exit": 1.0, "back_pair_entry": -1.0, "back_pair_exit": -1.0}
"""Event functions at whose roots the stiffness without relief jumps, with their flank."""
PROBE = 1e-7
"""Step [m] of the finite differences of the distances, which are smooth."""


class Surface(NamedTuple):
    """Surface of a force jump: event function, mesh, and slope and position of the slice."""

    event: int
    mesh: int
    lean: float
    """Advance of the contact per metre of face width [base pitches/m]."""
    place: float
    """Position of the slice on the common face width, 0 to 1."""


def all_surfaces(system: System) -> list[Surface]:
    """All surfaces at which a force of the system can jump."""
    meshes: dict[str, int] = {}  # events are in the order of the meshes
    found = []
    for k, event in enumerate(system.layout.events):
        kind, _, name = event.name.partition("[")
        if kind not in JUMPS:
            continue
        mesh = meshes.setdefault(name, len(meshes))
        record = mesh_record(system, mesh)
        lean = 0.0 if record["source"] == PHASE else JUMPS[kind] * float(record["tan_b"] / record["p_bt"])
        n = 1 if lean == 0.0 else int(record["slices"])
        found += [Surface(k, mesh, lean, (s + 0.5) / n) for s in range(n)]
    return found


def heights(system: System, state: State, surfaces: Sequence[Surface]) -> Array:
    """Distance of a state from each surface [base pitches], in [-1/2, 1/2]."""
    values = evaluate.event_values(system, state)
    found = np.zeros(len(surfaces))
    for n, (event, mesh, lean, place) in enumerate(surfaces):
        low, high = shared_width(mesh_record(system, mesh))
        height = values[event] + lean * (low + place * (high - low))
        found[n] = height - np.floor(height + 0.5)
    return found


def crossed(system: System, one: State, two: State) -> list[Surface]:
    """Surfaces between two neighbouring states, for flanks in or near contact."""
    surfaces = all_surfaces(system)
    if not surfaces:
        return []
    of_surface = [surface.event for surface in surfaces]
    near = [np.abs(evaluate.event_values(system, state)[of_surface]) <= 0.5 for state in (one, two)]
    before, after = (heights(system, state, surfaces) for state in (one, two))
    between = near[0] & near[1] & (before * after <= 0.0) & (np.abs(after - before) < 0.5)
    return [surface for surface, yes in zip(surfaces, between, strict=True) if yes]


def slopes(system: System, state: State, surfaces: Sequence[Surface], free: Indices) -> Array:
    """Derivatives of the distances with respect to the free coordinates, shape (n, free)."""
    places, layout = mesh_places(system), system.layout
    nodes = {n for mesh in {s.mesh for s in surfaces} for n in blocks_of(system, *places[mesh]).nodes}
    moving = {layout.node_dof[n] + k for n in nodes for k in range(layout.node_size[n])}
    found = np.zeros((len(surfaces), len(free)))
    for column, k in enumerate(free):
        if k not in moving:
            continue
        h = PROBE / system.weight[k]
        ends = []
        for sign in (1.0, -1.0):
            near = state.copy()
            near.q[k] += sign * h
            ends.append(heights(system, near, surfaces))
        found[:, column] = (ends[0] - ends[1]) / (2.0 * h)
    return found


BESIDE = 1e-10
"""Distance of the states on both sides from the surface [base pitches]."""
PARALLEL = 1e-6
"""Sine of the angle between two surfaces up to which they count as equal, if their distance is zero."""
NOTHING = 1e-11
"""Distance [m] below which two states count as equal."""
MAX_ITERATIONS = 40
MAX_PROJECTIONS = 5
MAX_BISECTIONS = 100
FARTHEST = 1e-2
"""Largest step [m] along a surface; a larger one means that no equilibrium is near."""


@dataclass(frozen=True)
class Rest:
    """Result of an equilibrium iteration.

    Parameters
    ----------
    state
        The state.
    residual
        Residual, weighted over both sides of the jumps, shape (nd,).
    other_sides
        For every force jump at the equilibrium: the state on its other side.
    share
        Weight of the forces on that other side, by jump.
    """

    state: State
    residual: Array
    other_sides: tuple[State, ...] = ()
    share: Array = field(default_factory=lambda: np.zeros(0))

    @property
    def holds(self) -> bool:
        """Whether every share is between 0 and 1, as an equilibrium on the surface requires."""
        return bool(((self.share >= 0.0) & (self.share <= 1.0)).all())


def rest_on_surfaces(
    system: System, state: State, surfaces: Sequence[Surface], free: Indices, goal: Array
) -> Rest | None:
    """Equilibrium on as many of the given surfaces as possible, or a state from which to continue.

    Parameters
    ----------
    system, state
        The system and a state near the surfaces.
    surfaces
        The surfaces.
    free
        Coordinates that may move.
    goal
        Largest residual force on each of them [N].

    Returns
    -------
    Rest or None
        If `Rest.holds` is false, its state is where the iteration leaves the surface: no mean of both sides
        is in equilibrium there. None if the iteration fails.
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
    """The surfaces without duplicates: equal meshes between the same bodies jump simultaneously."""
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
    """Equilibrium at a jump between two states whose forces point towards each other.

    For jumps without an event function, such as those of a user-defined law: bisection along the step locates
    the jump; its normal is assumed parallel to the step.
    """
    near, far = evaluate.residual(system, one), evaluate.residual(system, two)
    step = (two.q - one.q)[free]
    for _ in range(MAX_BISECTIONS):  # far from the origin rounding may exceed NOTHING
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
    size = 1.0 / system.weight[free]  # change of each coordinate per metre
    n = len(chosen)
    share = np.full(n, 0.5)
    try:
        for _ in range(MAX_ITERATIONS):
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
            jump = (residuals[free, 1:] - residuals[free, :1]) * size[:, None]
            # the distance between the sides limits the accuracy of a state on a surface
            rounding = BESIDE * np.abs(stiffness @ back).max(axis=(0, 2))
            if (np.abs(rest[free] * size) <= np.maximum(goal, rounding)).all():
                return _aside(
                    Rest(sides[0], rest, tuple(sides[1:]), share), normal @ np.linalg.pinv(K) @ jump
                )
            change = _step(K, jump, normal, rest[free] * size, heights(system, state, chosen))
            if float(np.abs(change[: len(free)]).max()) > FARTHEST:
                return None
            state, share = _moved(state, free, size * change[: len(free)]), share + change[len(free) :]
    except SolverError:
        pass
    return None


def _step(K: Array, jump: Array, normal: Array, rest: Array, height: Array) -> Array:
    """Newton step of position and shares: [[K, jump], [normal, 0]] step = -(rest, height).

    Rows and columns are scaled alike: the pseudo-inverse would omit the shares next to a large stiffness.
    """
    n, nf = normal.shape
    stiff, across = float(np.abs(K).max()), np.linalg.norm(normal, axis=1)
    size = np.linalg.norm(jump, axis=0)
    unit = np.divide(stiff, size, out=np.zeros(n), where=size > 0.0)
    matrix = np.block([[K, jump * unit], [stiff * normal / across[:, None], np.zeros((n, n))]])
    change = -np.linalg.pinv(matrix) @ np.concatenate((rest, stiff * height / across))
    change[nf:] *= unit
    return np.asarray(change)


def _onto(system: System, state: State, chosen: Sequence[Surface], free: Indices, back: Array) -> State:
    """Project a state onto (curved) surfaces, much closer than the distance of its two sides."""
    for _ in range(MAX_PROJECTIONS):
        height = heights(system, state, chosen)
        if np.abs(height).max() < 0.01 * BESIDE:
            break
        state = _moved(state, free, -back @ height)
    return state


def _aside(found: Rest, across: Array) -> Rest:
    """Move a result with shares outside 0 to 1 to the sides from which the residual leads away.

    The residual there is the jump times the excess of the share; `across` is the motion normal to the
    surfaces caused by each jump, shape (n, n).
    """
    if found.holds:
        return found
    state = found.state.copy()
    for k, part in enumerate(found.share):
        if (part > 1.0) == (across[k, k] > 0.0):
            state.q += found.other_sides[k].q - found.state.q
    return Rest(state, found.residual, found.other_sides, found.share)


def _stiffness(system: System, state: State, free: Indices, size: Array) -> Array:
    """Stiffness of the free coordinates, all scaled to metres."""
    K = evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON)
    scaled: Array = K[np.ix_(free, free)] * np.outer(size, size)
    return scaled


def observe_mean(system: System, state: State, other_sides: Sequence[State], share: Array) -> Array:
    """All channels of a state at jumps as the mean of both sides; dimensionless channels are of one side.

    Parameters
    ----------
    system, state
        The system and its state on one side.
    other_sides, share
        By jump: the state on the other side, and its weight.
    """
    row = evaluate.observe(system, state)
    mean = row.copy()
    with_unit = np.array([c.unit != "1" for c in system.layout.channels])
    for other, part in zip(other_sides, share, strict=True):
        mean += np.where(with_unit, part * (evaluate.observe(system, other) - row), 0.0)
    return mean


def _moved(state: State, free: Indices, by: Array) -> State:
    """Copy of a state with displaced free coordinates."""
    new = state.copy()
    new.q[free] += by
    return new
