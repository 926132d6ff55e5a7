# SPDX-License-Identifier: Apache-2.0
"""Checks of the meshes of planets: their places follow from the file and do not change with the carrier."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.model.carried_trains import line_carrier
from pitchpoint.model.frames import GROUND, body_frame
from pitchpoint.model.mechanism import base_of, seat_frame
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.scissor_gears import mesh_name

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

SAME = 1e-6
"""Distance up to which two axes coincide [m]."""
LARGEST = 0.1
"""Distance of the axes of a carrier and of a central gear, in normal modules, above which it exceeds any
error: the centre distances of the planets vary by twice as much in a revolution."""


@dataclass(frozen=True)
class OffAxis:
    """Carrier whose axis is not that of a central gear.

    Parameters
    ----------
    mesh
        Mesh of the central gear with a planet.
    carrier, central
        Names of both bodies.
    distance
        Distance of the axes [m].
    module
        Normal module [m].
    """

    mesh: str
    carrier: str
    central: str
    distance: float
    module: float

    @property
    def words(self) -> str:
        """Statement of the difference."""
        size = format_quantity(self.distance, "length", 3)
        return (
            f"has its axis {size} off that of {self.central}, so that the centre distance of {self.mesh} "
            f"varies by {format_quantity(2.0 * self.distance, 'length', 3)} in a revolution of the carrier"
        )

    @property
    def remedy(self) -> str:
        """Corrective action."""
        return f"give {self.carrier} the position of {self.central}"


def off_axis(machine: Any) -> Iterator[OffAxis]:
    """Carriers whose axis is not that of the central gears of their planets, each pair of bodies once."""
    seen = set()
    mechanism = machine.mechanism
    for name, mesh in machine.meshes.items():
        one, two = (machine.body_of(g) for g in mesh.gears)
        if one is None or two is None or not {one, two} <= mechanism.seats.keys():
            continue
        bases = [base_of(machine, mechanism, body) for body in (one, two)]
        carrier = line_carrier(machine, one, two)
        central = two if bases[0] == carrier else one
        if carrier == GROUND or bases[0] == bases[1] or carrier not in mechanism.seats:
            continue
        if base_of(machine, mechanism, carrier) != base_of(machine, mechanism, central):
            continue
        origin, axes = body_frame(machine, central)
        if origin is None or (carrier, central) in seen:
            continue
        seen.add((carrier, central))
        apart = seat_frame(machine, mechanism.seats[carrier])[0] - origin
        distance = float(np.linalg.norm(apart - (apart @ axes[:, 2]) * axes[:, 2]))
        if distance > SAME:
            gear = machine.gears[mesh.gears[0]]
            yield OffAxis(name, carrier, central, distance, gear.normal_module)


def check_carried_meshes(parts: Parts, report: Reader) -> None:
    """Report carriers far from the axis of their central gears, and rings located at 0 deg by default."""
    for found in off_axis(parts):
        if found.distance > LARGEST * found.module and ("bodies", found.carrier) not in report.tainted:
            limit = format_quantity(LARGEST * found.module, "length", 3)
            report.problem(
                ("bodies", found.carrier, "position"),
                found.words,
                limit=f"{limit}, a tenth of a module",
                remedy=found.remedy,
            )
    _placed_by_default(parts, report)


def _placed_by_default(parts: Parts, report: Reader) -> None:
    """Report meshes without direction that locate a ring or planet, where another mesh makes it matter."""
    located = {name for kind, name, _ in parts.placed.values() if kind == "mesh"}
    for name, mesh in parts.meshes.items():
        bare = any(parts.body_of(gear) is None for gear in mesh.gears)
        if mesh.direction is not None or not (bare or name in located) or mesh.a_w is None:
            continue
        gear1, gear2 = (parts.gears.get(g) for g in mesh.gears)
        if gear1 is None or gear2 is None or gear2.type != "internal":
            continue
        same = {name, *(mesh_name(name, free) for free in parts.scissor_gears)}
        others = [
            n
            for n, m in parts.meshes.items()
            if n not in same and mesh.gears[0] in m.gears and m.a_w is not None
        ]
        if not others:
            continue
        other = parts.meshes[others[0]]
        along = other.theta + (math.pi if other.gears[1] == mesh.gears[0] else 0.0)
        degrees = math.degrees(math.remainder(along, math.tau))
        report.problem(
            ("meshes", name, "direction"),
            f"is missing: {mesh.gears[0]} is also in {others[0]}, so that the direction is not arbitrary",
            remedy=f"give direction: {degrees:.9g} deg, with {mesh.gears[1]} on the axis of "
            f"{next(g for g in other.gears if g != mesh.gears[0])}, or the positions of the bodies",
        )
