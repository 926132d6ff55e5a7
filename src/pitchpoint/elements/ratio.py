# SPDX-License-Identifier: Apache-2.0
"""Kinematic ratios of joint coordinates as constraint rows: gears, racks, belts, planetary sets.

c_i q_i + c_j q_j + c_k q_k = constant, where each q is one joint coordinate of a body, spins including their
whole turns. For gears the coefficients are the signed numbers of teeth (both positive for an external pair,
the second negative for an internal one): turns are then summed as integers, without loss of precision after
many revolutions. A planetary set with carrier has three terms, z_s spin_s + z_p spin_p - z_s spin_c, where
the spin of the planet is relative to the carrier.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import CONSTRAINT, GEARED, RATIO, Kind, Power
from pitchpoint.multibody.channels import F8, constraint_args, observations

TWO_PI = 6.283185307179586
SPIN = -1

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "k")]
    + [
        ("dof_i", "i8"),  # first coordinates of the bodies; written by the layout
        ("dof_j", "i8"),
        ("dof_k", "i8"),
        ("spin_i", "i8"),  # their spins, -1 for none; written by the layout
        ("spin_j", "i8"),
        ("spin_k", "i8"),
        ("q_i", "i8"),  # coordinate of each joint; SPIN: its spin
        ("q_j", "i8"),
        ("q_k", "i8"),
        ("c_i", "f8"),  # coefficients; 0 disables the second or third term
        ("c_j", "f8"),
        ("c_k", "f8"),
        ("linear", "i8"),  # 1: the first coordinate is a length
        ("row", "i8"),  # constraint row; written by the layout
        ("u0", "f8"),  # value of q_i + (c_j q_j + c_k q_k) / c_i as assembled [rad or m]
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("torque", "N m", "torque of the ratio on the first body"),)


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Observations of one record: a torque, or a force if the first coordinate is a length."""
    return (("force", "N", "force of the ratio on the first body"),) if record["linear"] else OUTPUTS


def place_of(record: np.void, end: str) -> int:
    """Index of the coordinate of one end, "i", "j" or "k", of a record of this kind or of a drive."""
    q = int(record[f"q_{end}"])
    return int(record[f"spin_{end}"]) if q == SPIN else int(record[f"dof_{end}"]) + q


@kernel
def _coordinate(dof, spin, k):
    return spin if k == SPIN else dof + k


@kernel
def _turns(body, spin, d):
    """Whole turns of a coordinate that is a spin."""
    return float(body["turns"]) if spin == d else 0.0


@kernel
def ratio(rec, ctl, fr, q, g, G):
    """Constraint rows of all ratios, and their torques or forces."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        r = b["row"]
        d_i = _coordinate(b["dof_i"], b["spin_i"], b["q_i"])
        c_i = b["c_i"]
        whole = c_i * _turns(fr[b["i"]], b["spin_i"], d_i)
        part = 0.0
        G[r, d_i] += 1.0
        if b["c_j"] != 0.0:
            d = _coordinate(b["dof_j"], b["spin_j"], b["q_j"])
            whole += b["c_j"] * _turns(fr[b["j"]], b["spin_j"], d)
            part += b["c_j"] * q[d]
            G[r, d] += b["c_j"] / c_i
        if b["c_k"] != 0.0:
            d = _coordinate(b["dof_k"], b["spin_k"], b["q_k"])
            whole += b["c_k"] * _turns(fr[b["k"]], b["spin_k"], d)
            part += b["c_k"] * q[d]
            G[r, d] += b["c_k"] / c_i
        g[r] = q[d_i] + (part + TWO_PI * whole) / c_i - b["u0"]
        if c["out"] != 0:
            observations(ctl)[b["out"]] = -view(c["lam"], c["nc"], F8)[r]
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, g, G = constraint_args(ctl)
    return ratio(view(rec, n, RECORD), c, fr, q, g, G)


KIND = Kind(
    name="ratio",
    channel=CONSTRAINT,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    pairs=(("i", "j"), ("i", "k")),
    rows=1,
    role=RATIO,
    massless=True,
    spins=GEARED,
    sections={"ratios": ""},
    power=Power(),
)
