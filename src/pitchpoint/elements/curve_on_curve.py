# SPDX-License-Identifier: Apache-2.0
"""Permanent contact of planar curves of two bodies: a cam and its positively guided follower.

The curves are in the planes of their markers as in `curve_curve`. Of several common normals the one with the
gap nearest to zero is used. The motion of the contact points along both curves is eliminated
(`contacts.planar`); row and multiplier are those of `contacts.permanent`.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.curve import Curve
from pitchpoint.contact.curve_pair import nearest_normal
from pitchpoint.contact.curve_point import WIDTH, arc_length
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import INCONSISTENT, OK, REFUSED
from pitchpoint.elements.contacts.permanent import FORCE, hold
from pitchpoint.elements.contacts.planar import MIN_COSINE, place_contact
from pitchpoint.elements.contacts.record import PATHS, RECORD, set_curve
from pitchpoint.elements.contacts.wrench import place_markers
from pitchpoint.elements.kind import CONSTRAINT, Kind
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.channels import F8, constraint_args, constraint_rates, observations

__all__ = ["KIND", "OUTPUTS", "RECORD", "curve_on_curve", "entry", "set_held_curves"]

OUTPUTS = (FORCE, *PATHS)


def set_held_curves(record: np.void, pool: Pool, curves: tuple[Curve, Curve]) -> None:
    """Set both curves of a constraint.

    Parameters
    ----------
    record
        Record with bodies i and j and their markers (`contacts.record.new_records`).
    pool
        Pool of the kind.
    curves
        Curves of bodies i and j.
    """
    set_curve(record, "i", pool, curves[0])
    set_curve(record, "j", pool, curves[1])


@kernel
def curve_on_curve(rec, ctl, fr, q, g, G):
    """Constraint rows of all curve pairs, their second derivatives and constraint forces."""
    c = ctl[0]
    v, gt, gtt, Gf = constraint_rates(ctl)
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        o = fr[b["j"]]
        place_markers(b, f, o)
        if not b["M"][2, 2] > MIN_COSINE:
            c["bad"] = e
            return REFUSED
        A = view(b["pool"] + 8 * b["start_i"], (b["rows_i"], WIDTH), F8)
        B = view(b["pool"] + 8 * b["start_j"], (b["rows_j"], WIDTH), F8)
        if not nearest_normal(A, B, b["M"], b["d"], 1e300, b["hits"]):
            c["bad"] = e
            return INCONSISTENT
        place_contact(b, f, o, A, B, 0)
        lam = hold(b, c, f, o, g, gtt, Gf)
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = -lam
            out[b["out"] + 1] = arc_length(A, int(b["hits"][0, 2]), b["hits"][0, 1])
            out[b["out"] + 2] = arc_length(B, int(b["hits"][0, 4]), b["hits"][0, 3])
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return curve_on_curve(view(rec, n, RECORD), c, fr, q, g, G)


KIND = Kind(
    name="curve_on_curve",
    channel=CONSTRAINT,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    rows=1,
    row_unit=lambda record: "m",
    body_fixed=True,
    sections={"curve_contacts": ""},
)
