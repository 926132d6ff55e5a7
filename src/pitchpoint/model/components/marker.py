# SPDX-License-Identifier: Apache-2.0
"""Named points with axes on bodies, for joints, rods and forces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.keys import component, quantities

Triple: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True)
class Axes(Component):
    """Axes of a right-handed frame, given by z and x."""

    z: Triple = quantities(
        "dimensionless",
        "direction of the z axis, of any length",
        (0.0, 0.0, 1.0),
        length=(3, 3),
        sample="[0, 0, 1]",
    )
    x: Triple | None = quantities(
        "dimensionless",
        "direction of the x axis, perpendicular to z",
        None,
        length=(3, 3),
        sample="[1, 0, 0]",
        display="the projection of the reference x axis, or of its y axis for z along x",
    )


@dataclass(frozen=True, kw_only=True)
class Marker(Component):
    """A point of a body with axes, referred to as BODY.MARKER."""

    position: Triple = quantities(
        "length", "position relative to the origin of the body, in its axes", (0.0, 0.0, 0.0), length=(3, 3)
    )
    axes: Axes | None = component(
        Axes, "directions of the axes in the axes of the body; default: those of the body"
    )
