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
TILT = 1.0
"""Rotation from the rest position [rad] beyond which springs of a tumbling body are not evaluated."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
"""Points along the way: exact for linear springs, about 1 % of the part beyond a clearance otherwise."""


def elastic_kinds(system: System) -> tuple[str, ...]:
    """Kinds whose energy follows from their forces at rest: springs; no teeth, contacts, loads, winds or
    joints."""
    found = []
    for name, records in system.records.items():
        kind = registry.find(name)
        own = not callable(kind.outputs) and any(row[0] == "elastic_energy" for row in kind.outputs)
        source = kind.power is not None and kind.power.source
        plain = kind.scope == BETWEEN and not (kind.role or kind.rows or own or source)
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
        Whether the result determines them: not in machines with closed loops, with bodies that tumble by more
        than `TILT`, or with displacements that were not stored.
    """

    def __init__(self, system: System, read: Callable[[str], Array | None]) -> None:
        self.system = system
        self.ends, charts, unknown = coordinates(system, 2, read)
        self.tilts = rotation_vectors(charts)
        small = float(np.linalg.norm(self.tilts, axis=-1).max(initial=0.0)) < TILT
        self.known = small and not (unknown or is_looped(system))
        held = list(free_spins(system))
        motions = rotations(system, held)
        share = np.linalg.lstsq(motions, self.ends.T, rcond=None)[0] if held else np.zeros((0, 2))
        self.rigid = (motions @ share).T if held else 0.0 * self.ends

    def change(self, on: Mapping[str, slice | Places]) -> float:
        """Change of the energy of some elements, by kind, over the run [J]."""
        if not on or not self.known:
            return 0.0
        with switched(self.system, on):
            first, last = (self._energy(end) for end in (0, 1))
        return last - first

    def _energy(self, end: int) -> float:
        """Work of the forces from the undeflected position to that at one end, at rest [J]."""
        step = self.ends[end] - self.rigid[end]
        way = step + rates_of_tilts(self.system, self.tilts[end])
        total, state = 0.0, self.system.initial_state()
        for x, weight in zip(NODES, WEIGHTS, strict=True):
            share = 0.5 * (1.0 + x)
            move_to(self.system, state, self.rigid[end] + share * step)
            state.charts[:] = attitudes(share * self.tilts[end])
            total += 0.5 * weight * float(evaluate.residual(self.system, state) @ way)
        return float(total)


def rotation_vectors(charts: Array) -> Array:
    """Rotation vectors [rad] of attitudes, shape (..., 3, 3), from those at rest."""
    from scipy.spatial.transform import Rotation

    found: Array = Rotation.from_matrix(charts.reshape(-1, 3, 3)).as_rotvec() if charts.size else charts
    return found.reshape(charts.shape[:-1])


def attitudes(vectors: Array) -> Array:
    """Attitudes of some rotation vectors, shape (charts, 3)."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_rotvec(vectors).as_matrix() if vectors.size else np.zeros((0, 3, 3))


def rates_of_tilts(system: System, vectors: Array) -> Array:
    """Rotation vectors or angular velocities of tumbling bodies (..., charts, 3) as rates (..., nd).

    At the attitude of its chart, the rates of a tumbling body are the components of its angular velocity
    relative to its parent, in the axes of the body.
    """
    found = np.zeros((*vectors.shape[:-2], system.sizes["nd"]))
    for b, one in enumerate(system.bodies, start=1):
        record = system.program["body"][b]
        if record["chart"] < 0:
            continue
        first = next(k for k, (name, _) in enumerate(one.coordinates) if name == "alpha")
        at = int(record["dof"]) + first
        found[..., at : at + 3] = vectors[..., int(record["chart"]), :]
    return found
