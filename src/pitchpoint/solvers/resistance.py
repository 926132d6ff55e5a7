# SPDX-License-Identifier: Apache-2.0
"""What keeps single spins from turning freely: springs, contacts, loops, and weight beside an axis."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.system.meshes import KINDS
from pitchpoint.system.system import System

Array = NDArray[np.float64]

SAME = 1e-9
"""Singular value over the largest, and length of a row over one, that count as zero."""
ECCENTRIC = 1e-6
"""Distance of a centre of mass from an axis [m] from which weight turns what hangs there."""


def resisted_spins(system: System) -> list[int]:
    """Spins that springs, contacts, loops or eccentric weight keep from turning freely."""
    body = system.program["body"]
    held = {int(s) for s in system.states}
    for kind, records in system.records.items():
        if kind in (*KINDS, "ratio"):
            continue
        module = registry.find(kind).load()
        if getattr(module, "SPINS", "holds") != "holds" or "i" not in (records.dtype.names or ()):
            continue
        for record in records:
            if kind == "bearing" and record["housed"] == 0:
                continue
            if kind == "gravity":
                held |= _leaning(system)
                break
            fields = records.dtype.names or ()
            if kind == "linear_hold":  # on one body, against what it hangs on
                held |= {int(body[record["i"]]["spin"])} - {-1}
                continue
            ends = [_movers(body, int(record[end])) for end in ("i", "j") if end in fields]
            between = set.symmetric_difference(*ends) if len(ends) == 2 else ends[0]
            if kind == "bearing":
                between -= _along(system, int(record["i"]))
            held |= between - (_unresisted(body, record) if kind == "bushing" else set())
    return sorted(held)


def _along(system: System, b: int) -> set[int]:
    """Spins of all bodies about the axis of body b, where they are drawn."""
    place, axis = (np.asarray(x, float) for x in (system.bodies[b - 1].position, system.bodies[b - 1].axes))
    z = np.array([np.asarray(other.axes, float)[:, 2] for other in system.bodies])
    way = np.array([np.asarray(other.position, float) for other in system.bodies]) - place
    off = [np.linalg.norm(np.cross(x, axis[:, 2]), axis=1) for x in (z, way)]
    spins = system.program["body"]["spin"][1:]
    return {int(s) for s in spins[(off[0] <= SAME) & (off[1] <= SAME)]}


def _unresisted(body: NDArray[np.void], record: np.void) -> set[int]:
    """Spins of the two bodies of a bushing that it lets turn: on the axis, and soft about it."""
    found = set()
    axis = np.array([0.0, 0.0, 1.0])
    K = record["K"] + record["K"].T
    for end in "ij":
        A = record[f"A_{end}"]
        x = np.concatenate([A.T @ np.cross(axis, record[f"p_{end}"]), A.T @ axis])
        if np.abs(K @ x).max() <= SAME * np.abs(K).max():
            found.add(spin_of(body, int(record[end])))
    return found


def _movers(body: NDArray[np.void], b: int) -> set[int]:
    """Spins on the way from ground to a body."""
    found = set()
    while b:
        if body[b]["spin"] >= 0:
            found.add(int(body[b]["spin"]))
        b = int(body[b]["parent"])
    return found


def _leaning(system: System) -> set[int]:
    """Spins about whose axes the weight of what hangs there has a lever."""
    body = system.program["body"]
    places = [np.zeros(3), *(np.asarray(b.position, float) for b in system.bodies)]
    turning: dict[int, list[int]] = {}
    for k in range(1, len(body)):
        if body[k]["spin"] >= 0:
            turning.setdefault(int(body[k]["spin"]), []).append(k)
    lever, mass = np.zeros((len(body), 3)), np.zeros(len(body))
    for b in range(1, len(body)):
        own = system.bodies[b - 1]
        center = places[b] + np.asarray(own.axes, float) @ own.center_of_mass()
        for k in (k for spin in _movers(body, b) for k in turning[spin] if k <= b):
            lever[k] += own.mass * (center - places[k])
            mass[k] += own.mass
    found = set()
    for spin, bodies in turning.items():
        for k in bodies:
            axis = np.asarray(system.bodies[k - 1].axes, float)[:, 2]
            if np.linalg.norm(lever[k] - (lever[k] @ axis) * axis) > ECCENTRIC * mass[k]:
                found.add(spin)
    return found
