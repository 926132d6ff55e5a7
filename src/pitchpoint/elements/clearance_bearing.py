# SPDX-License-Identifier: Apache-2.0
"""Plain bearing with clearance: free motion of the journal in a radial gap, contact force beyond it.

With e the eccentricity of the journal in the bore and d = e - gap,

    F = K d^p max(0, 1 + chi d')   for d > 0

towards the centre; Hunt-Crossley damping vanishes at separation and never pulls. The journal slides and
rotates freely along and about the axis and may tilt: model a long bearing as two of these.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, FREE, Kind
from pitchpoint.elements.ring import OUTPUTS as RING_OUTPUTS
from pitchpoint.elements.ring import (
    RESULTANTS,
    RING,
    close_ring,
    ring_forces,
    ring_motion,
    ring_observations,
    ring_tangents,
)
from pitchpoint.multibody.channels import events, frame_args, observations

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + RING
    + [
        ("gap", "f8"),  # radial clearance of the centred journal, > 0 [m]
        ("stiffness", "f8"),  # K [N/m^p]
        ("exponent", "f8"),  # p, >= 1
        ("chi", "f8"),  # damping factor [s/m]
        ("ev", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

EVENTS = (("contact", "journal touches its bore or leaves it"),)
OUTPUTS = (*RING_OUTPUTS, ("penetration", "m", "distance of the journal beyond its play; negative inside"))


@kernel
def _press(b, jac):
    """Write force and stiffness of the journal to the scratch; returns its penetration."""
    x = b["x"]
    K = b["K"]
    D = b["D"]
    for r in range(6):
        b["f"][r] = 0.0
        if jac != 0:
            for h in range(6):
                K[r, h] = 0.0
                D[r, h] = 0.0
    e = math.sqrt(x[0] * x[0] + x[1] * x[1])
    d = e - b["gap"]
    if not d > 0.0:
        return d
    c = x[0] / e
    s = x[1] / e
    across = c * b["w"][1] - s * b["w"][0]
    damped = 1.0 + b["chi"] * (c * b["w"][0] + s * b["w"][1])
    if damped <= 0.0:
        return d
    elastic = b["stiffness"] * d ** b["exponent"]
    force = elastic * damped
    b["f"][0] = -force * c
    b["f"][1] = -force * s
    if jac != 0:
        along = b["exponent"] * elastic / d * damped
        rate = elastic * b["chi"]
        swing = rate * across / e  # the radial direction rotates with the journal
        K[0, 0] = along * c * c + force / e * s * s - swing * c * s
        K[0, 1] = (along - force / e) * c * s + swing * c * c
        K[1, 0] = (along - force / e) * c * s - swing * s * s
        K[1, 1] = along * s * s + force / e * c * c + swing * c * s
        D[0, 0] = rate * c * c
        D[0, 1] = rate * c * s
        D[1, 0] = rate * c * s
        D[1, 1] = rate * s * s
    return d


@kernel
def clearance_bearing(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all bearings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        line = ring_motion(b, f, g)
        d = _press(b, c["jac"])
        if c["ev"] != 0:
            events(ctl)[b["ev"]] = d
        if c["out"] != 0:
            out = observations(ctl)
            ring_observations(b, fr, line, out)
            out[b["out"] + RESULTANTS] = d
        if d > 0.0:
            ring_forces(b, f, g, line)
            if c["jac"] != 0:
                ring_tangents(b, f, g, kk, ctl, line)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return clearance_bearing(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="clearance_bearing",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    events=EVENTS,
    body_fixed=True,
    massless=True,
    spins=FREE,
    close=close_ring,
    sections={"plain_bearings": "journal"},
    arrow="ring",
)
