# SPDX-License-Identifier: Apache-2.0
"""Cam and follower: a point or a roller of body i against a planar curve of body j, with force and friction.

The plane is that of the marker of body j; the centre of the roller is the origin of the marker of body i,
however far it is from the plane. Up to four places touch at once (a pin in a slot, a roller in a corner).
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.curve import Curve, chain, vertex
from pitchpoint.contact.surface import SPHERE
from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.planar import planar_entry
from pitchpoint.elements.contacts.record import EVENTS, PATHS, RECORD, RESULTS, set_curve
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.elements.signal import Pool

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "entry", "set_cam"]

OUTPUTS = RESULTS + PATHS


def set_cam(
    record: np.void, pool: Pool, curve: Curve, radius: float = 0.0, depth: float | None = None
) -> None:
    """Give a contact its curve and its roller.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`), markers and law apart.
    pool
        Pool of the kind.
    curve
        Curve of body j.
    radius
        Radius of the roller of body i, 0 for a point [m].
    depth
        Deepest overlap that counts as contact [m]. None = a twentieth of the size of both, and where nothing
        overlaps less, the nearest place at any overlap: an outline is never fallen through. Behind an open
        curve it counts up to half the size of the curve.
    """
    size = curve.circle()[2]
    set_curve(record, "i", pool, chain([vertex()], True))
    set_curve(record, "j", pool, curve)
    record["form_i"], record["radius"] = SPHERE, radius
    record["depth"] = record["deepest"] = 0.05 * (size + radius) if depth is None else depth
    if depth is None:
        record["deepest"] = np.inf if curve.closed else 0.5 * size + radius
    record["margin"] = 100.0 * (size + math.hypot(*curve.circle()[:2]) + radius)


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    return planar_entry(ctl, rec, n)


KIND = Kind(
    name="point_curve",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    events=EVENTS,
    body_fixed=True,
    sections={"cam_contacts": ""},
)
