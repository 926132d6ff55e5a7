# SPDX-License-Identifier: Apache-2.0
"""Lines of centres of the meshes: their directions, and centre distances from the places of the bodies.

Places given by hand, and those of planets on their pins, are the centre distance of a mesh that does not give
one. A distance or direction that is given twice must agree.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.model.checks.gear_pairs import pair_at_distance
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.gear_axes import mesh_frame
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader

SAME = 1e-6
"""Difference of two lengths up to which they agree: an absolute length [m], and relative to the distance.
Places are often given to a micrometre."""
ROUNDING = 1e-12
"""Relative rounding error of a distance between places."""


def line_up(parts: Parts, report: Reader) -> None:
    """Compute direction and centre distance of every mesh; places that contradict them are problems."""
    for name, mesh in parts.meshes.items():
        if ("meshes", name, "gears") in report.tainted:
            continue
        theta = mesh.direction or 0.0
        bodies = [parts.body_of(g) for g in mesh.gears]
        ends = [parts.bodies[b].origin for b in bodies if b is not None]
        if (
            len(ends) == 2
            and ends[0] is not None
            and ends[1] is not None
            and mesh.a_w
            and bodies[0] != bodies[1]
        ):
            dx, dy, _ = mesh_frame(parts, bodies[0]).T @ np.subtract(ends[1], ends[0])
            theta = _along(parts, name, mesh, (math.hypot(dx, dy), math.atan2(dy, dx)), report)
        parts.meshes[name] = replace(parts.meshes[name], theta=theta)


def _along(parts: Parts, name: str, mesh: Mesh, polar: tuple[float, float], report: Reader) -> float:
    """Direction of one mesh whose bodies are `polar`, distance [m] and angle [rad], apart."""
    distance, angle = polar
    a = abs(mesh.a_w or 0.0)
    allowed = SAME * max(1.0, a)
    if _by_hand(parts, mesh) and abs(distance - a) > ROUNDING * a:
        pair_at_distance(parts, name, distance, report)
    elif abs(distance - a) > allowed:
        _contradiction(parts, name, mesh, distance, report)
        return angle
    if mesh.direction is None:
        return angle
    if abs(math.remainder(angle - mesh.direction, math.tau)) * max(distance, a) > allowed:
        report.problem(
            ("meshes", name, "direction"),
            f"does not fit the positions of its bodies, which give {math.degrees(angle):.9g} deg",
            value=f"{math.degrees(mesh.direction):.9g} deg",
            remedy="remove direction or the positions" + by_couplings(parts, mesh),
        )
    return mesh.direction


def _by_hand(parts: Parts, mesh: Mesh) -> bool:
    """Whether the places of both bodies are the centre distance: that of planets on their pins, and those
    that no mesh locates if the mesh gives none."""
    if mesh.stage is not None:
        return True
    if mesh.center_distance is not None:
        return False
    return not any(_located_by_mesh(parts, parts.body_of(gear)) for gear in mesh.gears)


def _located_by_mesh(parts: Parts, body: str | None) -> bool:
    while body is not None and body in parts.placed:
        kind, _, body = parts.placed[body]
        if kind == "mesh":
            return True
    return False


def _contradiction(parts: Parts, name: str, mesh: Mesh, distance: float, report: Reader) -> None:
    """Report a centre distance that differs from the distance of the bodies."""
    a = abs(mesh.a_w or 0.0)
    size = format_quantity(abs(distance - a), "length", 3)
    what = "more" if a > distance else "less"
    source = "" if mesh.center_distance is not None else " (without backlash, from the profile shifts)"
    report.problem(
        ("meshes", name, "center_distance"),
        f"is {size} {what} than the distance between the positions of its bodies, {distance * 1e3:.9g} mm",
        value=f"{a * 1e3:.9g} mm{source}",
        limit="a difference of 1 µm",
        remedy="correct center_distance or the positions, or remove the positions" + by_couplings(parts, mesh)
        if mesh.center_distance is not None
        else f"give center_distance: {distance * 1e3:.9g} mm, or correct the profile shifts or the positions"
        + by_couplings(parts, mesh),
    )


def by_couplings(parts: Parts, mesh: Mesh) -> str:
    """Text on the couplings that determine the positions of the bodies of a mesh."""
    found = []
    for gear in mesh.gears:
        name = parts.body_of(gear)
        while name is not None and name in parts.placed:
            kind, link, before = parts.placed[name]
            if kind == "coupling":
                found.append(f"couplings.{link} locates {name} at {before}")
            name = before
    return f" ({', '.join(dict.fromkeys(found))})" if found else ""
