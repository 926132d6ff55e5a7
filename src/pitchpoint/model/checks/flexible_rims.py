# SPDX-License-Identifier: Apache-2.0
"""Checks of the flexible rims of internal gears and of their supports."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.model.keys import Place

if TYPE_CHECKING:
    from pitchpoint.model.components.flexible_rim import FlexibleRim, RimSupports
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.reading.reader import Reader

THICKEST = 0.5
"""Radial thickness of a rim over its mean radius up to which it is a curved beam."""
APART = 1e-6
"""Angle up to which two supports coincide [rad]."""


def check_flexible_rims(parts: Parts, report: Reader) -> None:
    """Check that flexible rims are rings of known thickness on rigid bodies, and that supports differ."""
    for name, gear in parts.gears.items():
        at: Place = ("gears", name, "flexible_rim")
        if gear.flexible_rim is None or at in report.tainted:
            continue
        if gear.type == "external":
            report.problem(at, "is for internal gears only", remedy="remove it, or set type: internal")
        elif gear.flexible_rim.finite_elements is not None:
            _elements(gear.flexible_rim, at, report)
        elif gear.bore_diameter == 0.0 and gear.rim_thickness is None:
            report.problem(
                at,
                "requires the outside of the ring",
                remedy="give rim_thickness, or the outside diameter as bore_diameter",
            )
        elif name not in parts.misshapen:
            _thickness(gear, ("gears", name), report)
        body = parts.body_of(name)
        for group, found in (("shaft", parts.shafts), ("elastic body", parts.elastic_bodies)):
            if body in found:
                report.problem(
                    at,
                    f"is on the {group} {body}",
                    limit="a rigid body",
                    remedy=f"put the gear on a body of its own, and connect it with {body}",
                )
        if gear.flexible_rim.supports is not None:
            _supports(gear.flexible_rim.supports, (*at, "supports"), report)


def _elements(part: FlexibleRim, at: Place, report: Reader) -> None:
    """Check that the nodes that hold the finite elements are the only supports."""
    assert part.finite_elements is not None
    if part.supports is not None:
        report.problem(
            (*at, "supports"),
            "cannot be combined with finite_elements, whose held_nodes are the supports",
            remedy="remove supports, or finite_elements",
        )
    below = (*at, "finite_elements", "held_nodes")
    if not part.finite_elements.held_nodes and below not in report.tainted:
        report.problem(
            below,
            "is empty: the rim is not connected to its body",
            remedy="name the nodes at bolts or splines, such as {bolt_1: {position: [0, 170 mm, 0]}}",
        )


def _thickness(gear: Gear, at: Place, report: Reader) -> None:
    root = 0.5 * abs(gear.geometry.d_f)
    key = "bore_diameter" if gear.bore_diameter > 0.0 else "rim_thickness"
    outer = 0.5 * gear.bore_diameter or root + (gear.rim_thickness or 0.0)
    most = 2.0 * root * THICKEST / (2.0 - THICKEST)
    if outer - root > most * (1.0 + 1e-9):
        report.problem(
            (*at, key),
            f"makes a rim of {1e3 * (outer - root):.6g} mm, too thick to bend as a ring",
            limit=f"<= {1e3 * most:.6g} mm, half its mean radius",
            remedy="remove flexible_rim: the rim is practically rigid",
            taint=False,
        )


def _supports(part: RimSupports, at: Place, report: Reader) -> None:
    if part.radial == 0.0 and part.tangential == 0.0 and at not in report.tainted:
        report.problem(at, "have no stiffness", remedy="give radial, tangential, or both")
    if part.angles is None:
        return
    turned = sorted((a % math.tau, k) for k, a in enumerate(part.angles))
    turned.append((turned[0][0] + math.tau, turned[0][1]))
    for (one, i), (two, k) in zip(turned, turned[1:], strict=False):
        if i != k and two - one < APART:
            report.problem(
                (*at, "angles", max(i, k)),
                f"is the angle of entry {min(i, k) + 1} as well",
                value=f"{math.degrees(part.angles[max(i, k)]):.6g} deg",
                remedy="give each support once; add the stiffnesses of supports at one place",
            )
