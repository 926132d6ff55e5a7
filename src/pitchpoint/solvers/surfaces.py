# SPDX-License-Identifier: Apache-2.0
"""Surfaces at which mesh forces jump with the position: where tooth pairs without relief enter or leave.

A spur pair does so over its whole width at once, a helical one that is cut into slices slice by slice; with
the exact width integral helical pairs do it smoothly. The heights over the surfaces follow from the event
functions of the mesh, in base pitches.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.mesh.record import PHASE
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_record, shared_width
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

JUMPS = {"pair_entry": 1.0, "pair_exit": 1.0, "back_pair_entry": -1.0, "back_pair_exit": -1.0}
"""Event functions at whose roots a stiffness without relief jumps, with the flank they belong to."""
PROBE = 1e-7
"""Displacement [m] of the difference quotients of the heights, which are smooth."""


class Surface(NamedTuple):
    """One surface: its event function, its mesh, and the slice by its tilt and its place."""

    event: int
    mesh: int
    lean: float
    """Base pitches by which a pair comes sooner per metre of the face width."""
    place: float
    """Where on the shared face width the slice lies, 0 to 1."""


def all_surfaces(system: System) -> list[Surface]:
    """Every surface at which a force of the system can jump."""
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
    """Surfaces between two neighbouring states, of flanks that are in contact or near it."""
    surfaces = all_surfaces(system)
    if not surfaces:
        return []
    of_surface = [surface.event for surface in surfaces]
    near = [np.abs(evaluate.event_values(system, state)[of_surface]) <= 0.5 for state in (one, two)]
    before, after = (heights(system, state, surfaces) for state in (one, two))
    between = near[0] & near[1] & (before * after <= 0.0) & (np.abs(after - before) < 0.5)
    return [surface for surface, yes in zip(surfaces, between, strict=True) if yes]


def slopes(system: System, state: State, surfaces: Sequence[Surface], free: Indices) -> Array:
    """Slopes of the heights over the free coordinates, shape (n, free)."""
    found = np.zeros((len(surfaces), len(free)))
    for column, k in enumerate(free):
        h = PROBE / system.weight[k]
        ends = []
        for sign in (1.0, -1.0):
            near = state.copy()
            near.q[k] += sign * h
            ends.append(heights(system, near, surfaces))
        found[:, column] = (ends[0] - ends[1]) / (2.0 * h)
    return found
