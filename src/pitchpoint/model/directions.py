# SPDX-License-Identifier: Apache-2.0
"""Checks of the directions of axes: neither zero nor oblique."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.marker import Axes
    from pitchpoint.model.parts import Parts

SQUARE = 1e-6
"""Cosine of the angle up to which two directions count as perpendicular."""


def check_directions(parts: Parts, report: Reader) -> None:
    """Axes are directions, and x is at right angles to z."""
    for name, body in parts.bodies.items():
        check_axes(body.axes, ("bodies", name, "axes"), report)
        for word, marker in body.markers.items():
            check_axes(marker.axes, ("bodies", name, "markers", word, "axes"), report)
    for name, joint in parts.joints.items():
        check_axes(joint.axes, ("joints", name, "axes"), report)


def check_axes(axes: Axes | None, at: Place, report: Reader) -> None:
    """Directions are not zero, and at right angles to each other."""
    if axes is None:
        return
    for key in ("z", "x"):
        given = getattr(axes, key)
        if given is not None and not any(given):
            report.problem(
                (*at, key),
                "is not a direction: all its numbers are zero",
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
            "is not at right angles to z",
            value=f"{math.degrees(math.acos(max(-1.0, min(1.0, cosine)))):.6g} deg",
            limit="90 deg",
            remedy="correct one of them, or leave x out",
        )
