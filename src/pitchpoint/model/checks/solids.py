# SPDX-License-Identifier: Apache-2.0
"""Checks of axis directions, of shapes, and of CAD solids of gears, shafts and bodies."""

from __future__ import annotations

import dataclasses
import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, MissingDependencyError
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.marker import Axes
    from pitchpoint.model.components.shape import Shape
    from pitchpoint.model.components.solid import SolidReference


SQUARE = 1e-6
"""Cosine of the angle up to which two directions count as perpendicular."""


def check_directions(parts: Parts, report: Reader) -> None:
    """Check the axes of bodies, markers and joints."""
    for name, body in parts.bodies.items():
        check_axes(body.axes, ("bodies", name, "axes"), report)
        for word, marker in body.markers.items():
            check_axes(marker.axes, ("bodies", name, "markers", word, "axes"), report)
        for word, shape in body.shapes.items():
            at = ("bodies", name, "shapes", word)
            check_axes(shape.axes, (*at, "axes"), report)
            if not any(at == path[: len(at)] for path in report.tainted):
                _check_shape(shape, at, report)
    for name, joint in parts.joints.items():
        check_axes(joint.axes, ("joints", name, "axes"), report)


def check_axes(axes: Axes | None, at: Place, report: Reader) -> None:
    """Check that x and z are non-zero and perpendicular."""
    if axes is None:
        return
    for key in ("z", "x"):
        given = getattr(axes, key)
        if given is not None and not any(given):
            report.problem(
                (*at, key),
                "is not a direction: all components are zero",
                remedy="write for example [1, 0, 0]",
            )
            return
    if axes.x is None:
        return
    cosine = math.fsum(a * b for a, b in zip(axes.z, axes.x, strict=True))
    cosine /= math.hypot(*axes.z) * math.hypot(*axes.x)
    if abs(cosine) > SQUARE:
        report.problem(
            (*at, "x"),
            "is not perpendicular to z",
            value=f"{math.degrees(math.acos(max(-1.0, min(1.0, cosine)))):.6g} deg",
            limit="90 deg",
            remedy="correct one of them, or remove x",
        )


def _check_shape(shape: Shape, at: Place, report: Reader) -> None:
    """Check that a shape is one of a box and a body of revolution."""
    turned = bool(shape.heights or shape.diameters)
    if (shape.box is not None) == turned:
        message = "is two shapes" if turned else "has no size"
        report.problem(at, message, remedy="give box, or heights and diameters")
    elif turned and shape.rounding > 0.0:
        report.problem((*at, "rounding"), "is for boxes", remedy="remove it, or add diameters for the edge")
    elif shape.box is not None:
        if min(shape.box) <= 0.0:
            limit = "> 0"
            report.problem((*at, "box"), "is a size", value=f"{min(shape.box):.6g} m", limit=limit)
        elif shape.rounding > 0.5 * min(shape.box):
            report.problem(
                (*at, "rounding"),
                "is larger than half of the smallest size of the box",
                value=f"{shape.rounding:.6g} m",
                limit=f"<= {0.5 * min(shape.box):.6g} m",
            )
    elif len(shape.heights) != len(shape.diameters) or len(shape.heights) < 2:
        report.problem(
            (*at, "heights"),
            "and the diameters do not make an outline",
            value=f"{len(shape.heights)} and {len(shape.diameters)} values",
            remedy="give at least two heights, and a diameter for each",
        )
    elif any(b < a for a, b in zip(shape.heights, shape.heights[1:], strict=False)):
        report.problem((*at, "heights"), "do not ascend", remedy="order them along z")
    elif shape.heights[0] == shape.heights[-1] or max(shape.diameters) == 0.0:
        report.problem(at, "has no volume", remedy="give different heights, and a diameter above 0")


def check_solids(parts: Parts, report: Reader) -> None:
    """Read the solids of gears, shafts and bodies; remove those that cannot be read."""
    for group in ("gears", "shafts", "bodies"):
        components = getattr(parts, group)
        for name, component in list(components.items()):
            if component.solid is None:
                continue
            at: Place = (group, name, "solid")
            if any((*at, k) in report.tainted for k in ("file", "unit", "axes", "material", "density")):
                good = False
            else:
                good = _check(component.solid, at, group, report)
            if not good:
                components[name] = dataclasses.replace(component, solid=None)
                report.tainted |= {(group, name, k) for k in ("mass", "inertia", "transverse_inertia")}


def _check(part: SolidReference, at: Place, group: str, report: Reader) -> bool:
    if part.density is not None and part.material is not None:
        report.problem((*at, "density"), "cannot be combined with material", remedy="give one of the two")
        return False
    if part.origin is not None and group != "bodies":
        single = group.removesuffix("s")
        report.problem(
            (*at, "origin"),
            f"is for solids of bodies only: the position of a {single} is known",
            remedy="remove it",
        )
        return False
    if part.axes is not None and not _directions(part, at, report):
        return False
    try:
        if group == "bodies":
            part.solid()
        else:
            part.about_axis()
    except GeometryError as error:
        report.hand_on(at if error.problem.where else (*at, "file"), error.problem)
        return False
    except MissingDependencyError as error:
        what, _, remedy = str(error).partition("; ")
        report.problem((*at, "file"), f"cannot be read: {what}", remedy=remedy)
        return False
    return True


def _directions(part: SolidReference, at: Place, report: Reader) -> bool:
    before = len(report.problems)
    check_axes(part.axes, (*at, "axes"), report)
    return len(report.problems) == before
