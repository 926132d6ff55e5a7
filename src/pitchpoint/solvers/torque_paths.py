# SPDX-License-Identifier: Apache-2.0
"""Elements that transmit torque, as linear relations between the spins: meshes, ratios, couplings, beams.

A row contains factors by spin. Its sum is zero for consistent spin rates; by virtual work, the same factors
times the torque of the element are the torques on the spins.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pitchpoint.elements import registry
from pitchpoint.elements.kind import GEARED, MESH, RATIO, TOGETHER
from pitchpoint.elements.ratio import place_of
from pitchpoint.multibody.bodies import base_of
from pitchpoint.solvers.resistance import SAME
from pitchpoint.system.meshes import is_bevel
from pitchpoint.system.system import System

Row = dict[int, float]


@dataclass(frozen=True)
class TorquePath:
    """An element that transmits torque.

    Parameters
    ----------
    kind, number
        Kind of the element and index of its record.
    row
        Factors by spin coordinate; for a mesh those of the travel of its front flank.
    to_ground
        Whether one of its ends cannot rotate.
    """

    kind: str
    number: int
    row: Row
    to_ground: bool


def spins_of(system: System) -> list[int]:
    """Spin coordinates of all bodies, in the order of the bodies."""
    return [int(s) for s in dict.fromkeys(system.program["body"]["spin"].tolist()) if s >= 0]


def turning(system: System, b: int, sense: float = 1.0) -> Row:
    """Absolute rotation of a body about its axis per rate of every spin; reversed with `sense` -1."""
    body = system.program["body"]
    found: Row = {}
    while b and sense != 0.0:
        spin = int(body[b]["spin"])
        if spin >= 0:
            found[spin] = found.get(spin, 0.0) + sense
        sense *= float(body[b]["sense"])
        b = int(body[b]["parent"])
    return found


def against_the_base(system: System, record: np.void, end: str) -> Row:
    """Rotation of a gear of a mesh relative to the carrier of the line of centres, by spin."""
    return _sum((1.0, turning(system, int(record[end]))), (-1.0, _base(system, record, end)))


def torque_paths(system: System) -> list[TorquePath]:
    """All elements that transmit torque between spins, or between a spin and ground."""
    found = []
    for kind, records in system.records.items():
        described = registry.find(kind)
        for k, record in enumerate(records):
            to_ground = False
            if described.role == RATIO:
                row = _ratio(system, record)
            elif described.spins_of(record) not in (GEARED, TOGETHER):
                continue
            else:
                one, two = (turning(system, int(record[end])) for end in "ij")
                to_ground = not (one and two)
                row = _sum((1.0, one), (-1.0, two))
                if described.role == MESH:
                    teeth = {end: float(record[f"z{n}"]) for n, end in ((1, "i"), (2, "j"))}
                    row = _sum(*((z, against_the_base(system, record, end)) for end, z in teeth.items()))
            if row:
                found.append(TorquePath(kind, k, row, to_ground))
    return found


def _sum(*terms: tuple[float, Mapping[int, float]]) -> Row:
    """Linear combination of rows, without zeros."""
    found: Row = {}
    for factor, row in terms:
        for spin, value in row.items():
            found[spin] = found.get(spin, 0.0) + factor * value
    return {spin: value for spin, value in found.items() if value != 0.0}


def _base(system: System, record: np.void, end: str) -> Row:
    """Rotation of the carrier of the line of centres about the axis of a gear, by spin.

    The axes of cylindrical gears are parallel, those of bevel gears differ. A housing that rotates about
    another axis carries both gears and does not change their relative rotation.
    """
    body = system.program["body"]
    carried = "i" if record["carried"] == 1 else "j"
    if is_bevel(record) and carried != end:
        return _bevel_base(system, (int(record[carried]), int(record[end])))
    gear = int(record[carried])
    own = int(body[gear]["spinner"]) or gear
    return turning(system, base_of(body, gear), float(body[own]["sense"]))


def _bevel_base(system: System, gears: tuple[int, int]) -> Row:
    """Rotation of the base of the first bevel gear about the axis of the second, if parallel, by spin."""
    base = base_of(system.program["body"], gears[0])
    if base == 0:
        return {}
    one, two = (np.asarray(system.bodies[b - 1].axes, float)[:, 2] for b in (base, gears[1]))
    along = float(one @ two)
    return turning(system, base, float(np.sign(along)) if abs(abs(along) - 1.0) < SAME else 0.0)


def _ratio(system: System, record: np.void) -> Row:
    """Row of a rigid ratio; empty if it includes a coordinate that is not a spin."""
    row: Row = {}
    for end in "ijk":
        if record[f"c_{end}"] != 0.0:
            place = place_of(record, end)
            if place not in system.program["body"]["spin"]:
                return {}
            row[place] = row.get(place, 0.0) + float(record[f"c_{end}"])
    return row
