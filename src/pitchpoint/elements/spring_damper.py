# SPDX-License-Identifier: Apache-2.0
"""Spring and damper along the line between two body-fixed points (body 0 = ground).

    tension = k x + d w + L(t, x, w)

x is the elongation, length less free length, w its rate. L is a signal: a table over elongation (angle) or
rate (speed), a formula in which `angle` is x and `speed` is w, or a user law.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import NOT_FINITE, OK
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.elements.line import line_between, pull, tension_tangent
from pitchpoint.elements.signal import CONSTANT, SIGNAL, signal
from pitchpoint.multibody.channels import frame_args, observations

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("p_i", "f8", 3),  # point on body i from its origin, axes of the body [m]
        ("p_j", "f8", 3),  # point on body j likewise
        ("free", "f8"),  # free length [m]
        ("k", "f8"),  # stiffness [N/m]
        ("d", "f8"),  # damping [N s/m]
    ]
    + SIGNAL  # additional tension, function of t, x and w [N]
    + [("out", "i8")],
    align=True,
)

OUTPUTS = (
    ("tension", "N", "tension of a spring, positive in tension"),
    ("elongation", "m", "length of a spring less its free length"),
)


@kernel
def spring_damper(rec, ctl, fr, kk):
    """Wrenches, tangents and observations of all springs."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        line = line_between(b, f, g)
        arm_i, arm_j, along, length, w, rate = line
        x = length - b["free"]
        tension = b["k"] * x + b["d"] * rate
        by_length = b["k"]
        by_rate = b["d"]
        if b["form"] != CONSTANT or b["value"] != 0.0:
            more, slope, faster = signal(b, c["t"], x, 0, rate, c["jac"])
            tension += more
            by_length += slope
            by_rate += faster
        if not math.isfinite(tension):
            c["bad"] = e
            return NOT_FINITE
        pull(f, g, arm_i, arm_j, along, tension)
        if c["jac"] != 0:
            tension_tangent(b, f, g, kk, ctl, line, tension, by_length, by_rate)
        if c["out"] != 0:
            out = observations(ctl)
            out[b["out"]] = tension
            out[b["out"] + 1] = x
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return spring_damper(view(rec, n, RECORD), c, fr, kk)


def _linear(record: np.void, spinning: bool) -> bool:
    """Linear without an additional law."""
    return bool(record["form"] == CONSTANT)


def law_call(record: np.void, frames: Any, pool: Any, t: float) -> tuple[float, int, int]:
    """Elongation [m] and parameters of the user's force law."""
    length = line_between(record, frames[int(record["i"])], frames[int(record["j"])])[3]
    return length - float(record["free"]), int(record["start"]), int(record["n"])


KIND = Kind(
    name="spring_damper",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    body_fixed=True,
    massless=True,
    linear=_linear,
    large=True,
    sections={"springs": "spring"},
    names_modes=False,
    law_call=law_call,
)
