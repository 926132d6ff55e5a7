# SPDX-License-Identifier: Apache-2.0
"""Rings of rolling and plain bearings in the fields of a record."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.model.rings import Ring, following, rings_of
from pitchpoint.multibody.joints import GUIDED, TUMBLING
from pitchpoint.system.rules.bodies import frame_at

if TYPE_CHECKING:
    from pitchpoint.model.rings import Ringed
    from pitchpoint.multibody.bodies import Body
    from pitchpoint.system.rules.places import Array, Places

ASIDE = 1e-5
"""Distance of the centre of a bearing from the spin axis of a body up to which it is on the axis [m]."""
ACROSS = 1e-3
"""Angle between their axes up to which these are parallel [rad]."""


def mark_rings(places: Places, row: Any, part: Ringed) -> tuple[Array, Array]:
    """Set bodies, points and axes of both rings and the axes of the results.

    Returns the axes of the rings in the world.

    Parameters
    ----------
    places
        Context of the rules.
    row
        Record of the element.
    part
        The bearing.
    """
    turned = _mark(places, row, part)
    put_rest(places.tree, row)
    return turned


def _mark(places: Places, row: Any, part: Ringed) -> tuple[Array, Array]:
    """Set bodies, points and axes of both rings; returns the axes of the rings in the world."""
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


def put_rest(tree: Sequence[Body], row: Any) -> None:
    """Set the axes of the results: those of the outer ring without its spin about the bearing axis.

    They are fixed to the frame R of the last body, from the outer ring towards ground, that spins about the
    axis of the bearing: of a planet, which its carrier moves in a circle, but of the carrier for a sun that
    it supports. A ring off the axis of its body, such as that of a planet shaft in its carrier, goes round
    with the body; so do the axes. Floating bodies have no spin axis.

    Parameters
    ----------
    tree
        Bodies by their numbers, from 1.
    row
        Record of the bearing with the outer ring.
    """
    k = int(row["j"])
    if k == 0:
        return
    frame = np.asarray(tree[k - 1].axes, dtype=float)
    centre = np.asarray(tree[k - 1].position) + frame @ row["p_j"]
    turned = frame @ row["A_j"]
    while k:
        body = tree[k - 1]
        own = np.asarray(body.axes, dtype=float)
        if _spins(body):
            aside = np.cross(centre - np.asarray(body.position), own[:, 2])
            across = np.cross(turned[:, 2], own[:, 2])
            if np.linalg.norm(aside) > ASIDE or np.linalg.norm(across) > ACROSS:
                return
            row["rest"], row["A_rest"] = k, own.T @ turned
        elif body.motion in TUMBLING:
            return
        k = body.parent


def _spins(body: Body) -> bool:
    """Whether the frame R of a body does not follow a rotation about its axis."""
    spins = body.motion == GUIDED or any(name == "spin" for name, _ in body.coordinates)
    return body.spinner > 0 or (spins and body.motion not in TUMBLING)
