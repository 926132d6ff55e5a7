# SPDX-License-Identifier: Apache-2.0
"""Check of the assembly of the gears: teeth must not overlap, except in bodies that can move sideways."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.checks.gear_pairs import gap
from pitchpoint.model.frames import GROUND
from pitchpoint.model.loop_closure import closing_places
from pitchpoint.model.phasing import assemble
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts

CHANGE = "change the directions or teeth of the loop of meshes, or reduce position errors"
MOVE = (
    "give more backlash, or let a gear of the loop of meshes move sideways, such as a sun with motion: planar"
)
OFFSET_TOLERANCE = 1e-4
"""Base pitches by which an assembly may exceed its backlash: the elastic deflection of the teeth."""


def check_phasing(parts: Parts, report: Reader) -> None:
    """Check that teeth do not overlap if the angle of a gear is determined twice.

    Position errors of the axes are taken up by gears that can move sideways: these centre themselves.
    """
    meshes = {n: m for n, m in parts.meshes.items() if n in parts.pairs}
    found = assemble(parts.gears, meshes)
    wrong: dict[str, tuple[float, float]] = {}
    for name, offset in found.offset.items():
        if ("meshes", name) in report.tainted:
            continue
        pair = parts.pairs[name]
        room = 0.5 * max(0.0, gap(pair, meshes[name])) + OFFSET_TOLERANCE * abs(pair.p_et)
        if abs(offset) > room:
            wrong[name] = abs(offset) - room, room
    fixed = {n for n in wrong if all(parts.gears[g].initial_angle is not None for g in meshes[n].gears)}
    loops = [n for n in wrong if n not in fixed]
    if found.loops_close:  # position errors, reported once for a train
        loops = [n for n in loops if not gives_way(parts, meshes, n)]
        loops = [max(loops, key=lambda n: wrong[n][0])] if loops else []
    for name in wrong:
        if name not in fixed and name not in loops:
            continue
        first, second = meshes[name].gears
        overlap, room = wrong[name]
        report.problem(
            ("gears", second, "initial_angle") if name in fixed else ("meshes", name),
            f"lets teeth of {first} and {second} overlap by {overlap * 1e3:.4g} mm",
            limit=f"{room * 1e3:.4g} mm off the middle of the gap",
            remedy="remove initial_angle of one of the gears"
            if name in fixed
            else _remedy(parts, meshes, name, MOVE if found.loops_close else CHANGE),
        )


def _remedy(parts: Parts, meshes: Mapping[str, Mesh], name: str, other: str) -> str:
    """Remedy for a loop that does not close: positions at which it does, if there are any, or another."""
    found = closing_places(parts, meshes, name)
    if not found:
        return other
    listed = []
    for body, at in found.items():
        place = (at.real, at.imag, parts.bodies[body].origin[2])  # type: ignore[index]
        numbers = ", ".join(f"{round(1e3 * x, 5) + 0.0:.9g}" for x in place)
        listed.append(f"{body} at [{numbers}] mm")
    return f"with the same centre distances it closes with {' and '.join(listed)}; or {other}"


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
            if parts.bodies[body].elastic is not None or "x" in seats[body].coordinates or seats[body].beam:
                return True
            body = seats[body].parent
    return False
