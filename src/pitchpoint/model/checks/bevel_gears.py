# SPDX-License-Identifier: Apache-2.0
"""Checks of bevel gears and their meshes: keys, geometry, positions, pairing, overlapping teeth."""

from __future__ import annotations

import math
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.model.bevel_places import apex_of, assemble_bevels, bevel_gap, bevel_pair, tooth_phases
from pitchpoint.model.checks.gear_pairs import impossible_shape
from pitchpoint.model.checks.phasing import OFFSET_TOLERANCE
from pitchpoint.model.checks.references import carriers_of_gears
from pitchpoint.model.checks.tooth_faults import check_faults
from pitchpoint.model.keys import Place

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.reading.reader import Reader


def check_bevel_gears(parts: Parts, report: Reader) -> None:
    """Check the geometry of bevel gears, and that each is on one body only.

    Parameters
    ----------
    parts
        The parts of the model; gears with impossible geometry are added to `misshapen`.
    report
        Collects the problems.
    """
    carriers_of_gears(parts, "bevel_gears", report)
    for name, gear in parts.bevel_gears.items():
        at: Place = ("bevel_gears", name)
        if name in parts.known("gears"):
            report.problem(at, "has the name of a gear", remedy="rename one of the two")
        before = len(report.problems)
        _choices(gear, at, report)
        if len(report.problems) > before or at in report.tainted:
            parts.misshapen.add(name)
            continue
        if not impossible_shape(parts, at, partial(_impossible, gear), report):
            check_faults(gear, (*at, "faults"), report)


def _choices(gear: BevelGear, at: Place, report: Reader) -> None:
    """Check the hand of spiral gears and the keys of the shaft angle."""
    if gear.spiral_angle > 0.0 and gear.hand is None:
        report.problem(
            (*at, "hand"),
            "is missing: a spiral bevel gear is left or right handed",
            remedy="add hand: left or hand: right",
        )
    if gear.mate_teeth is None and gear.shaft_angle != math.radians(90.0):
        report.problem((*at, "shaft_angle"), "requires mate_teeth", remedy="give mate_teeth, or remove it")


def _impossible(gear: BevelGear) -> list[Message]:
    """Problems of the geometry of a gear or its blank."""
    problems = gear.geometry.problems()
    if not problems:
        _ = gear.blank
    return problems


PLACE_TOLERANCE = 1e-6
"""Tolerance of the distance of two apexes, relative to the cone distance, and of the shaft angle [rad]."""


def check_bevel_names(parts: Parts, report: Reader) -> None:
    """Check that every bevel mesh connects existing gears of two bodies, and every pair only once."""
    seen: dict[frozenset[str], str] = {}
    for name, mesh in parts.bevel_meshes.items():
        at: Place = ("bevel_meshes", name, "gears")
        if name in parts.known("meshes"):
            report.problem(at[:2], "has the name of a mesh", remedy="rename one of the two")
        if mesh.gears[0] == mesh.gears[1]:
            continue
        first = seen.setdefault(frozenset(mesh.gears), name)
        if first != name:
            report.problem(at, f"are already the gears of {first}", remedy="remove one of the two meshes")
        if all(parts.has("bevel_gears", gear) for gear in mesh.gears):
            _carried(parts, mesh, at, report)


def _carried(parts: Parts, mesh: BevelMesh, at: Place, report: Reader) -> None:
    """Check that the gears of a mesh are on two bodies."""
    bodies = [parts.body_of(gear) for gear in mesh.gears]
    if bodies[0] is not None and bodies[0] == bodies[1]:
        report.problem(at, f"connects two gears of the body {bodies[0]}", remedy="put them on two bodies")
    complete = parts.bodies and set(parts.bodies) == parts.known("bodies")
    for gear, body in zip(mesh.gears, bodies, strict=True):
        if body is None and complete and ("bodies",) not in report.tainted:
            report.problem(
                ("bevel_gears", gear),
                f"is in the mesh {at[1]}, but no body carries it",
                remedy=f"add {gear} to bevel_gears of a body",
            )


def check_bevel_pairs(parts: Parts, report: Reader) -> None:
    """Check the geometry, the position and the parent bodies of the gears of every bevel mesh."""
    sound = {}
    for name, mesh in parts.bevel_meshes.items():
        gears = [g for g in mesh.gears if g in parts.bevel_gears and g not in parts.misshapen]
        tainted = any(("bevel_gears", g) in report.tainted for g in mesh.gears)
        if len(set(gears)) < 2 or tainted or ("bevel_meshes", name) in report.tainted:
            continue
        before = len(report.problems)
        try:
            for problem in bevel_pair(parts, mesh).problems("", mesh.gears, gears=False):
                report.hand_on(("bevel_meshes", name), problem)
        except GeometryError as error:
            report.hand_on(("bevel_meshes", name), error.problem)
        if len(report.problems) == before and _meet(parts, name, mesh, report):
            sound[name] = mesh
    if sound and len(sound) == len(parts.known("bevel_meshes")):
        _check_teeth(parts, report)


def _meet(parts: Parts, name: str, mesh: BevelMesh, report: Reader) -> bool:
    """Check that apexes and shaft angle of a mesh agree with the positions; True without problems."""
    from pitchpoint.model.carried_trains import carrying

    first, second = (apex_of(parts, gear) for gear in mesh.gears)
    if first is None or second is None:
        return False
    at: Place = ("bevel_meshes", name)
    (apex1, way1), (apex2, way2) = first, second
    pair = bevel_pair(parts, mesh)
    one, two = (str(parts.body_of(g)) for g in mesh.gears)
    before = len(report.problems)
    apart = float(np.linalg.norm(apex1 - apex2))
    if apart > PLACE_TOLERANCE * pair.R_m:
        report.problem(
            (*at, "gears"),
            f"have their apexes {1e3 * apart:.6g} mm apart, at {_point(apex1)} and {_point(apex2)}",
            value=" and ".join(mesh.gears),
            limit="one apex",
            remedy=f"correct the positions of {one} and {two}, or of the gears on them",
        )
    angle = math.atan2(float(np.linalg.norm(np.cross(way1, way2))), float(way1 @ way2))
    if abs(angle - pair.Sigma) > PLACE_TOLERANCE:
        report.problem(
            (*at, "shaft_angle") if mesh.shaft_angle is not None else (*at, "gears"),
            f"is the angle between the axes of {' and '.join(mesh.gears)}, from the apex into the gears, "
            f"{math.degrees(abs(angle - pair.Sigma)):.3g} deg off",
            value=f"{math.degrees(angle):.6g} deg",
            limit=f"{math.degrees(pair.Sigma):.6g} deg, "
            + ("as given" if mesh.shaft_angle is not None else "the sum of their pitch cone angles"),
            remedy=f"correct the axes of {one} and {two}, or `opens` of the gears",
        )
    rides = carrying(parts, one, two)
    faulty = [f"bevel_gears.{g}.faults" for g in mesh.gears if parts.bevel_gears[g].faults]
    if rides and faulty:
        report.problem(
            (*at, "gears"),
            "have tooth faults, which are not supported for a gear on a carrier",
            value=" and ".join(faulty),
            limit="gears that rotate relative to one body",
            remedy="remove the faults, or let both gears rotate relative to the same body",
        )
    if rides is None:
        report.problem(
            (*at, "gears"),
            f"are on {one} and {two}, which have different parent bodies, none of which rotates about the "
            "axis of the other gear",
            value=" and ".join(mesh.gears),
            remedy="let both rotate relative to the same body, or one relative to a carrier that rotates "
            "about the axis of the other",
        )
    return len(report.problems) == before


def _point(place: np.ndarray) -> str:
    return "(" + ", ".join(f"{1e3 * x:.6g}" for x in place) + ") mm"


def _check_teeth(parts: Parts, report: Reader) -> None:
    """Check that teeth do not overlap if the angle of a gear is determined twice."""
    angles = assemble_bevels(parts)
    for name, mesh in parts.bevel_meshes.items():
        pair = bevel_pair(parts, mesh)
        p_bt = pair.R_m * pair.sigma_p
        phase = math.remainder(sum(tooth_phases(parts, mesh, angles)) - math.pi, math.tau)
        room = 0.5 * max(0.0, bevel_gap(pair, mesh)) + OFFSET_TOLERANCE * p_bt
        over = abs(phase) / math.tau * p_bt - room
        if over > 0.0:
            report.problem(
                ("bevel_meshes", name),
                f"lets teeth of {mesh.gears[0]} and {mesh.gears[1]} overlap by {over * 1e3:.4g} mm",
                limit=f"{room * 1e3:.4g} mm off the middle of the gap",
                remedy="remove initial_angle of one of the gears, or change the loop of meshes",
            )
