# SPDX-License-Identifier: Apache-2.0
"""Rings of rolling and plain bearings in the fields of a record."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.model.rings import Ring, following, rings_of
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
    if part.ends is None or any(part.position):
        inner, outer = rings_of(places.model, part)
        _put(places, row, "ij", (inner, outer))
        return inner.axes, outer.axes
    places.mark(row, part.ends)
    turned = [places.axes(end) for end in part.ends]
    if (k := following(places.model, part)) is not None:
        place, turned[k] = places.world(part.ends[1 - k]), turned[1 - k]
        _put(places, row, "ij"[k], [Ring(part.ends[k], place, place, turned[k])])
    return turned[0], turned[1]


def _put(places: Places, row: Any, letters: str, rings: Sequence[Ring]) -> None:
    """Set body, point and axes of rings that coincide with the other ring."""
    for letter, ring in zip(letters, rings, strict=True):
        number, at, axes = frame_at(places.model, ring.body, ring.seat)
        place = np.zeros(3) if ring.place is None else ring.place
        row[letter], row["p_" + letter] = number, axes.T @ (place - at)
        row["A_" + letter] = axes.T @ ring.axes
