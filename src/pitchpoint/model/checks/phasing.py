# SPDX-License-Identifier: Apache-2.0
"""Check of the assembly of the gears: teeth must not overlap by more than the machine can give way."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.checks.gear_pairs import gap
from pitchpoint.model.frames import GROUND
from pitchpoint.model.phasing import assemble
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts

OFFSET_TOLERANCE = 1e-4
"""Base pitches by which an assembly may exceed its backlash: the elastic deflection of the teeth."""


def check_phasing(parts: Parts, report: Reader) -> None:
    """Check that teeth do not overlap if the angle of a gear is determined twice.

    Position errors of the axes are taken up by gears that can move sideways: these centre themselves.
    """
    meshes = {n: m for n, m in parts.meshes.items() if n in parts.pairs}
    found = assemble(parts.gears, meshes)
    for name, offset in found.offset.items():
        if ("meshes", name) in report.tainted:
            continue
        pair, mesh = parts.pairs[name], meshes[name]
        p_bt = abs(pair.p_et)
        room = 0.5 * max(0.0, gap(pair, mesh)) + OFFSET_TOLERANCE * p_bt
        if abs(offset) <= room:
            continue
        second = mesh.gears[1]
        given = all(parts.gears[g].initial_angle is not None for g in mesh.gears)
        small = not given and found.loops_close
        if small and gives_way(parts, meshes, name):
            continue
        report.problem(
            ("gears", second, "initial_angle") if given else ("meshes", name),
            f"lets teeth of {mesh.gears[0]} and {second} overlap by {(abs(offset) - room) * 1e3:.4g} mm",
            limit=f"{room * 1e3:.4g} mm off the middle of the gap",
            remedy="remove initial_angle of one of the gears"
            if given
            else "give more backlash, or let a gear of the loop of meshes move sideways, such as a sun with "
            "motion: planar"
            if small
            else "change the directions or teeth of the loop of meshes",
        )


def gives_way(parts: Parts, meshes: Mapping[str, Mesh], name: str) -> bool:
    """Whether a body of the gear train of a mesh, or one that carries it, can move sideways."""
    gears, open_ = set(meshes[name].gears), list(meshes.values())
    grown = True
    while grown:
        joined = [mesh for mesh in open_ if gears & set(mesh.gears)]
        open_ = [mesh for mesh in open_ if not gears & set(mesh.gears)]
        grown = bool(joined)
        gears.update(gear for mesh in joined for gear in mesh.gears)
    seats = parts.mechanism.seats
    for gear in gears:
        body = parts.body_of(gear)
        while body is not None and body != GROUND and body in seats:
            if parts.bodies[body].elastic is not None or "x" in seats[body].coordinates:
                return True
            body = seats[body].parent
    return False
