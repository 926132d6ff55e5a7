# SPDX-License-Identifier: Apache-2.0
"""Check of gears on fixed joints: rings in a housing, gears fixed to a shaft."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.frames import GROUND
from pitchpoint.model.mechanism import COUNTED, Seat, base_of
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts


def check_standing_gear(parts: Parts, name: str, seat: Seat, report: Reader) -> None:
    """Check that a fixed gear rests in the world or a body that carries its mates, or rotates with a body.

    Parameters
    ----------
    parts
        Parts of the model.
    name
        Body of the gear, on a fixed joint.
    seat
        Its place in the mechanism.
    report
        Takes the problem.
    """
    root = seat
    while root.kind == "fixed" and root.parent in parts.mechanism.seats:
        root = parts.mechanism.seats[root.parent]
    if root.kind in ("fixed", "prismatic") or (
        root.body == seat.parent and all(_rides_on(parts, mate, seat.parent) for mate in _mates(parts, name))
    ):
        return
    remedy = f"give {name} and {root.body} the same z axis"
    if root.kind not in COUNTED:
        remedy = f"use a revolute, cylindrical, screw, planar or shaft joint for {root.body}"
        if root.body in parts.elastic_bodies:
            remedy = (
                f"write rotor: true at the elastic body {root.body}, whose z axis is the axis of the gears"
            )
    report.problem(
        ("bodies", name, "gears"),
        f"are fixed to {root.body}, which does not count revolutions about their axis",
        value=", ".join((*parts.bodies[name].gears, *parts.bodies[name].bevel_gears)),
        remedy=remedy,
    )


def _mates(parts: Parts, name: str) -> list[str]:
    """Bodies with gears in mesh with those of a body; empty names for gears without body."""
    own = {*parts.bodies[name].gears, *parts.bodies[name].bevel_gears}
    pairs = [mesh.gears for mesh in (*parts.meshes.values(), *parts.bevel_meshes.values())]
    return [parts.body_of(a if b in own else b) or "" for a, b in pairs if (a in own) != (b in own)]


def _rides_on(parts: Parts, body: str, carrier: str) -> bool:
    """Whether the spin of a body refers to a carrier, also by way of other bodies."""
    while body not in (GROUND, carrier) and body in parts.mechanism.seats:
        body = base_of(parts, parts.mechanism, body)
    return body == carrier
