# SPDX-License-Identifier: Apache-2.0
"""Spins that cannot rotate freely: because of springs, contacts, loops, or an eccentric weight."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import ACROSS, NOTHING, OWN, WEIGHT
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.system.system import System

Array = NDArray[np.float64]

SAME = 1e-9
"""Relative singular value, and norm of a unit row, that count as zero."""
ECCENTRIC = 1e-6
"""Eccentricity of a centre of mass [m] from which its weight exerts a torque about the axis."""


def resisted_spins(system: System) -> list[int]:
    """Spins that springs, contacts, loops or eccentric weights prevent from rotating freely."""
    body = system.program["body"]
    held = {int(s) for s in system.states}
    for kind, records in system.records.items():
        described = registry.find(kind)
        for record in records:
            resists = described.resists_of(record)
            if resists == NOTHING:
                continue
            if resists == WEIGHT:
                held |= _eccentric(system)
                break
            if resists == OWN:  # between one body and the body it is mounted on
                held |= {int(body[record["i"]]["spin"])} - {-1}
                continue
            between = set.symmetric_difference(*(_movers(body, int(record[end])) for end in ("i", "j")))
            if resists == ACROSS:
                between -= _along(system, int(record["i"]))
            held |= between - {spin_of(body, int(record[end])) for end in described.lets_turn(record)}
    return sorted(held)


def _along(system: System, b: int) -> set[int]:
    """Spins of all bodies coaxial with body b in the design position."""
    place, axis = (np.asarray(x, float) for x in (system.bodies[b - 1].position, system.bodies[b - 1].axes))
    z = np.array([np.asarray(other.axes, float)[:, 2] for other in system.bodies])
    way = np.array([np.asarray(other.position, float) for other in system.bodies]) - place
    off = [np.linalg.norm(np.cross(x, axis[:, 2]), axis=1) for x in (z, way)]
    spins = system.program["body"]["spin"][1:]
    return {int(s) for s in spins[(off[0] <= SAME) & (off[1] <= SAME)]}


def _movers(body: NDArray[np.void], b: int) -> set[int]:
    """Spins on the path from ground to a body."""
    found = set()
    while b:
        if body[b]["spin"] >= 0:
            found.add(int(body[b]["spin"]))
        b = int(body[b]["parent"])
    return found


def _eccentric(system: System) -> set[int]:
    """Spins with an eccentric weight: the bodies mounted there have a centre of mass off the axis."""
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
