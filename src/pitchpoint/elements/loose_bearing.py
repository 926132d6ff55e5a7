# SPDX-License-Identifier: Apache-2.0
"""Linear bearing with a loose ring: radial clearance of the seat in series with the bearing springs.

With rho = |(X, Y)| the eccentricity of the shaft in the seat and g the radial clearance, the ring touches its
seat for x = rho - g + w/2 > 0, and the spring of radial stiffness k has the force

    N = max(0, k p(x) + d s(x) rho'),   p = x^2/(2 w) up to x = w, x - w/2 beyond: k (rho - g)

towards the centre. The seat yields over the width w, so that stiffness and damping rise from zero
(s = t^2 (3 - 2 t), t = x/w); N never pulls. The seat is frictionless: tangentially, the spring rotates with
the shaft, and its damper acts on the fraction (p/rho)^2 of that motion. Axial displacement and tilts have a
separate linear 3 x 3 stiffness and damping. g = 0 and w = 0 give the linear bearing.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, FREE, Kind
from pitchpoint.elements.ring import OUTPUTS as RING_OUTPUTS
from pitchpoint.elements.ring import (
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
        ("gap", "f8"),  # radial clearance g [m]
        ("seat", "f8"),  # width w over which the seat yields [m]
        ("k", "f8"),  # radial stiffness [N/m]
        ("d", "f8"),  # radial damping [N s/m]
        ("Kt", "f8", (3, 3)),  # stiffness against Z and the tilts n_x, n_y
        ("Dt", "f8", (3, 3)),
        ("ev", "i8"),
        ("out", "i8"),
    ],
    align=True,
)

EVENTS = (("contact", "ring touches its seat or leaves it"),)
OUTPUTS = RING_OUTPUTS


@kernel
def _seat(b, x):
    """Compression p and damping factor s with their slopes, at the distance x beyond first contact [m]."""
    w = b["seat"]
    if x >= w:
        return x - 0.5 * w, 1.0, 1.0, 0.0
    t = x / w
    return 0.5 * x * t, t, t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / w


@kernel
def _others(b, jac):
    """Write the linear forces of axial displacement and tilt to the scratch; all other slopes are zero."""
    for r in range(6):
        b["f"][r] = 0.0
        if jac != 0:
            for c in range(6):
                inner = r > 1 and r < 5 and c > 1 and c < 5
                b["K"][r, c] = b["Kt"][r - 2, c - 2] if inner else 0.0
                b["D"][r, c] = b["Dt"][r - 2, c - 2] if inner else 0.0
    for r in range(3):
        for c in range(3):
            b["f"][2 + r] -= b["Kt"][r, c] * b["x"][2 + c] + b["Dt"][r, c] * b["w"][2 + c]


@kernel
def _radial(b, jac):
    """Add the radial force of the ring in its seat; returns the distance x beyond first contact [m]."""
    rho = math.sqrt(b["x"][0] * b["x"][0] + b["x"][1] * b["x"][1])
    x = rho - b["gap"] + 0.5 * b["seat"]
    if not (x > 0.0 and rho > 0.0):
        return x
    c = b["x"][0] / rho
    s = b["x"][1] / rho
    out = c * b["w"][0] + s * b["w"][1]
    round_ = c * b["w"][1] - s * b["w"][0]
    p, p_slope, share, share_slope = _seat(b, x)
    d = b["d"] * share
    N = b["k"] * p + d * out
    if N <= 0.0:
        return x
    q = p / rho
    T = d * q * q * round_
    b["f"][0] -= N * c - T * s
    b["f"][1] -= N * s + T * c
    if jac != 0:
        by_x = b["d"] * share_slope
        A = b["k"] * p_slope + by_x * out
        B = by_x * q * q * round_ + 2.0 * d * q * round_ * (p_slope - q) / rho
        rr = A  # rows and columns: radial and tangential direction
        rt = (d * round_ - T) / rho
        tr = B
        tt = (N - d * q * q * out) / rho
        _turned(b["K"], c, s, rr, rt, tr, tt)
        _turned(b["D"], c, s, d, 0.0, 0.0, d * q * q)
    return x


@kernel
def _turned(M, c, s, rr, rt, tr, tt):
    """Rotate a 2 x 2 matrix from radial and tangential directions to x and y."""
    M[0, 0] = rr * c * c - (rt + tr) * c * s + tt * s * s
    M[0, 1] = (rr - tt) * c * s + rt * c * c - tr * s * s
    M[1, 0] = (rr - tt) * c * s - rt * s * s + tr * c * c
    M[1, 1] = rr * s * s + (rt + tr) * c * s + tt * c * c


@kernel
def loose_bearing(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all bearings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        line = ring_motion(b, f, g)
        _others(b, c["jac"])
        x = _radial(b, c["jac"])
        if c["ev"] != 0:
            events(ctl)[b["ev"]] = x
        if c["out"] != 0:
            ring_observations(b, fr, line, observations(ctl))
        ring_forces(b, f, g, line)
        if c["jac"] != 0:
            ring_tangents(b, f, g, kk, ctl, line)
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return loose_bearing(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="loose_bearing",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    events=EVENTS,
    body_fixed=True,
    spins=FREE,
    close=close_ring,
    sections={"bearings": ""},
    plural="bearings with play",
    arrow="ring",
)
