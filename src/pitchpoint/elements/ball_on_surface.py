# SPDX-License-Identifier: Apache-2.0
"""Permanent contact of a point or sphere of body i with a plane, sphere, cylinder, cone or torus of body j.

Shapes as in `point_surface`. The contact point on the surface is eliminated through the curvature of the
distance function; the constraint row and its multiplier are those of `contacts.permanent`.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.contacts.permanent import FORCE, hold
from pitchpoint.elements.contacts.record import RECORD, RESULTS
from pitchpoint.elements.contacts.wrench import place_markers
from pitchpoint.elements.kind import CONSTRAINT, Kind
from pitchpoint.elements.point_surface import place_on_shape, set_surface
from pitchpoint.multibody.channels import constraint_args, constraint_rates, observations
from pitchpoint.multibody.vectors import column, dot, plus, triple

__all__ = ["KIND", "OUTPUTS", "RECORD", "ball_on_surface", "entry", "set_surface"]

OUTPUTS = (FORCE, *(result for result in RESULTS if result[0].startswith("contact_location")))


@kernel
def ball_on_surface(rec, ctl, fr, q, g, G):
    """Constraint rows of all spheres on surfaces, their second derivatives and constraint forces."""
    c = ctl[0]
    v, gt, gtt, Gf = constraint_rates(ctl)
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        o = fr[b["j"]]
        place_markers(b, f, o)
        b["side"] = 1.0
        m = place_on_shape(b, f, o)
        lam = hold(b, c, f, o, g, gtt, Gf)
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = -lam
            away = plus(plus(triple(b["oi"], 0), -b["radius"], m), -1.0, triple(b["oj"], 0))
            for k in range(3):
                out[b["out"] + 1 + k] = dot(away, column(b["Ej"], k))
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return ball_on_surface(view(rec, n, RECORD), c, fr, q, g, G)


KIND = Kind(
    name="ball_on_surface",
    channel=CONSTRAINT,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    rows=1,
    row_unit=lambda record: "m",
    body_fixed=True,
    sections={"surface_contacts": ""},
)
