# SPDX-License-Identifier: Apache-2.0
"""Contact of planar curves of two bodies with contact force and friction: cam and follower, tooth profiles.

The curves are in the planes of their markers, whose third axes have (nearly) the same direction; a tilt above
84 deg is refused. Up to four points are in contact simultaneously; straight segments that touch along their
length have contact points at their ends.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.curve import Curve
from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.planar import planar_entry
from pitchpoint.elements.contacts.record import EVENTS, PATHS, RECORD, RESULTS, set_curve
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.elements.signal import Pool

__all__ = ["EVENTS", "KIND", "OUTPUTS", "RECORD", "entry", "set_curves"]

OUTPUTS = RESULTS + PATHS


def set_curves(
    record: np.void,
    pool: Pool,
    curves: tuple[Curve, Curve],
    depth: float | None = None,
    margin: float | None = None,
) -> None:
    """Set both curves of a contact.

    Parameters
    ----------
    record
        Record of the contact (`contacts.record.new_records`); markers and law are set separately.
    pool
        Pool of the kind.
    curves
        Curves of bodies i and j.
    depth
        Maximum overlap in contact [m]. None: 5 % of the smaller curve; if every overlap is larger, the
        nearest point is in contact: two outlines at any overlap, an outline on an open curve up to the size
        of the outline, two open curves up to half the smaller one.
    margin
        Maximum gap that is searched and reported [m]; None: half the smaller curve. Small values save time.
    """
    size = min(curve.circle()[2] for curve in curves)
    outlines = [curve.circle()[2] for curve in curves if curve.closed]
    set_curve(record, "i", pool, curves[0])
    set_curve(record, "j", pool, curves[1])
    record["depth"] = record["deepest"] = 0.05 * size if depth is None else depth
    if depth is None:
        record["deepest"] = np.inf if len(outlines) == 2 else max(outlines, default=0.5 * size)
    record["margin"] = 0.5 * size if margin is None else margin


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    return planar_entry(ctl, rec, n)


KIND = Kind(
    name="curve_curve",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    events=EVENTS,
    body_fixed=True,
    sections={"curve_contacts": ""},
)
