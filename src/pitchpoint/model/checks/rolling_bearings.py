# SPDX-License-Identifier: Apache-2.0
"""Checks of rolling bearings: complete data, rolling elements that fit, keys that apply to the type."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.checks.bearing_faults import check_bearing_faults
from pitchpoint.model.components.bearing_geometry import BearingGeometry
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.show import SI

LOOSE = 0.05
"""Largest clearance over the element diameter: more than any class (C4 of the catalogue: up to 3 %)."""

if TYPE_CHECKING:
    from pitchpoint.model.components.rolling_bearing import RollingBearing
    from pitchpoint.model.parts import Parts


def check_rolling_bearings(parts: Parts, report: Reader) -> None:
    """Check all rolling bearings and their faults."""
    for name, bearing in parts.rolling_bearings.items():
        at: Place = ("rolling_bearings", name)
        if at in report.tainted:
            continue
        try:
            found = bearing.geometry
        except GeometryError as error:
            report.hand_on(at, error.problem)
            continue
        _room(found, at, report)
        _keys(bearing, found, at, report)
        _play(bearing, found, at, report)
        _preload(bearing, found, at, report)
        check_bearing_faults(name, bearing, report)


def _room(found: BearingGeometry, at: Place, report: Reader) -> None:
    """Check that the elements fit on the pitch circle and leave room for the inner ring."""
    if found.element_diameter * found.elements > math.pi * found.pitch_diameter:
        report.problem(
            (*at, "elements"),
            f"do not fit on a pitch circle of {found.pitch_diameter * 1e3:.6g} mm",
            value=str(found.elements),
            limit=f"<= {int(math.pi * found.pitch_diameter / found.element_diameter)}",
            remedy="correct the number or the diameters",
        )
    elif found.element_diameter * math.cos(found.contact_angle) >= found.pitch_diameter:
        report.problem(
            (*at, "element_diameter"),
            "leaves no room for the inner ring",
            value=f"{found.element_diameter * 1e3:.6g} mm",
            limit=f"below {found.pitch_diameter * 1e3:.6g} mm, the pitch diameter",
            remedy="correct one of the diameters",
        )


def _keys(bearing: RollingBearing, found: BearingGeometry, at: Place, report: Reader) -> None:
    """Check keys that apply to some types only."""
    if found.axial_clearance is None:
        for key in ("axial_clearance", "flange_stiffness"):
            if getattr(bearing, key) is not None:
                report.problem(
                    (*at, key),
                    "applies only to cylindrical roller bearings with flanges",
                    remedy="remove it, or use NJ or NUP with axial_force_absorption",
                )
    if found.kind == "thrust_ball" and bearing.clearance is not None:
        report.problem(
            (*at, "clearance"),
            "does not apply to a thrust bearing",
            remedy="remove it, or give preload or preload_distance",
        )
    own, other = ("grooves", "effective_length") if found.is_ball else ("effective_length", "grooves")
    if getattr(bearing, other) is not None:
        report.problem(
            (*at, other),
            f"does not apply to a bearing of type {found.kind}",
            remedy=f"give {own}, or correct type",
        )
    elif bearing.stiffness is None and getattr(found, own) is None and at not in report.tainted:
        report.problem(at, f"gives neither {own} nor stiffness", remedy=f"give {own}")


def _play(bearing: RollingBearing, found: BearingGeometry, at: Place, report: Reader) -> None:
    """Check that clearances are those of a bearing that is in one piece.

    With a clearance of the distance A of the groove centres, the contact angle of an axial load is already
    arccos(1 - 1/2) = 60 deg, which is over the shoulders of a groove.
    """
    size = LOOSE * found.element_diameter
    radial = min(size, found.groove_distance) if found.groove_distance > 0.0 else size
    limits = {"clearance": (radial, f"{100 * LOOSE:g} % of the element diameter")}
    limits["preload_distance"] = limits["clearance"]
    if radial < size:
        limits["clearance"] = (radial, "the distance of the groove centres")
    if found.effective_length is not None:
        limits["axial_clearance"] = (0.5 * found.effective_length, "half the effective length of a roller")
    for key, (limit, what) in limits.items():
        value = getattr(bearing, key)
        if value is None or abs(value) <= limit:
            continue
        report.problem(
            (*at, key),
            "is too large for a rolling bearing",
            value=f"{value * 1e3:.6g} mm",
            limit=f"{limit * 1e3:.4g} mm, {what}",
            remedy="correct the value or its unit"
            if (*at, key) in report.sources
            else f"a bare number is in {SI['length']}; write {value:.6g} mm",
        )


def _preload(bearing: RollingBearing, found: BearingGeometry, at: Place, report: Reader) -> None:
    """Check that an axial preload acts on a bearing that supports an axial force."""
    given = [key for key in ("preload", "preload_distance") if getattr(bearing, key) is not None]
    if len(given) == 2:
        report.problem((*at, given[1]), "is given in addition to preload", remedy="remove one of them")
    elif given and (
        found.floats or found.rows == 2 or (found.contact_angle == 0.0 and found.groove_distance == 0.0)
    ):
        report.problem(
            (*at, given[0]),
            f"does not apply to a {'floating' if found.floats else found.kind.replace('_', ' ')} bearing, "
            "which takes no axial preload",
            remedy="remove it; a radial preload is a negative clearance",
        )
