# SPDX-License-Identifier: Apache-2.0
"""Rings of rolling and plain bearings in the fields of a record."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.model.frames import GROUND
from pitchpoint.model.rings import rings_of
from pitchpoint.system.rules.bodies import frame_at

if TYPE_CHECKING:
    from pitchpoint.model.rings import Ringed
    from pitchpoint.system.rules.places import Array, Places


def mark_rings(places: Places, row: Any, part: Ringed) -> tuple[Array, Array]:
    """Set bodies, points and axes of both rings; returns the axes of the rings in the world.

    Parameters
    ----------
    places
        Context of the rules.
    row
        Record of the element.
    part
        The bearing.
    """
    if part.ends is None:
        rings = rings_of(places.model, part)
        for letter, ring in zip("ij", rings, strict=True):
            number, at, axes = frame_at(places.model, ring.body, ring.seat)
            place = np.zeros(3) if ring.place is None else ring.place
            row[letter], row["p_" + letter] = number, axes.T @ (place - at)
            row["A_" + letter] = axes.T @ ring.axes
        return rings[0].axes, rings[1].axes
    places.mark(row, part.ends)
    inner, outer = part.ends
    for letter, end, other in (("i", inner, outer), ("j", outer, inner)):
        if end == GROUND:
            row["p_" + letter], row["A_" + letter] = places.world(other), places.axes(other)
    return (
        places.axes(outer if inner == GROUND else inner),
        places.axes(inner if outer == GROUND else outer),
    )
