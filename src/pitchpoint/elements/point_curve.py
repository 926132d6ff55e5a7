# SPDX-License-Identifier: Apache-2.0
"""Cam and follower: contact of a point or roller of body i with a planar curve of body j, with friction.

The plane is that of the marker of body j; the centre of the roller is the origin of the marker of body i,
at any distance from the plane. Up to four points are in contact simultaneously (a pin in a slot, a roller in
a corner).
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
    """Set curve and roller of a contact.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    pool
        Pool of the kind.
    curve
        Curve of body j.
    radius
        Radius of the roller of body i, 0 for a point [m].
    depth
        Maximum overlap in contact [m]. None: 5 % of the size of both; if every overlap is larger, the nearest
        point is in contact: at any overlap with a closed outline, up to half the size of an open curve.
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
    """Entry point of the kind."""
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
