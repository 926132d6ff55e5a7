# SPDX-License-Identifier: Apache-2.0
"""Named points and directions on bodies, to which joints, rods and forces are fixed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from pitchpoint.model.keys import component, quantities

Triple: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True)
class Axes:
    """Directions of a right-handed frame; the third follows from the two."""

    z: Triple = quantities(
        "dimensionless",
        "direction of the z axis, of any length",
        (0.0, 0.0, 1.0),
        length=(3, 3),
        sample="[0, 0, 1]",
    )
    x: Triple | None = quantities(
        "dimensionless",
        "direction of the x axis, at right angles to z",
        None,
        length=(3, 3),
        sample="[1, 0, 0]",
        display="as near as z allows to the x axis they are given in, to its y axis for a z along it",
    )


@dataclass(frozen=True, kw_only=True)
class Marker:
    """A point of a body with a frame, named elsewhere as BODY.MARKER."""

    position: Triple = quantities(
        "length", "from the origin of the body, along the axes of the body", (0.0, 0.0, 0.0), length=(3, 3)
    )
    axes: Axes | None = component(
        Axes, "directions along the axes of the body; without them those of the body itself"
    )
