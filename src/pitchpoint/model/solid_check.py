# SPDX-License-Identifier: Apache-2.0
"""Solids of CAD programs in gears, shafts and bodies: what is wrong with them."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, MissingDependencyError
from pitchpoint.model.directions import check_axes
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.solid import SolidReference


def check_solids(parts: Parts, report: Reader) -> None:
    """Read the solids of gears, shafts and bodies; those that cannot be read are omitted later on."""
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
            f"has no effect: a {single} lies where its body or its section is",
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
