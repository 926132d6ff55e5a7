# SPDX-License-Identifier: Apache-2.0
"""Timoshenko beam of any section between two bodies (body 0 = ground), for rotations of any size.

Nodes and section axes are fixed to the bodies and rotate with them. For round shafts that spin between bodies
on ground, `shaft_beam` gives the same forces independent of the spin angle. Formulas: `beams.forces`.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.beams.forces import internal, loads, node, turned
from pitchpoint.elements.beams.record import OUTPUTS, RECORD, beam_row
from pitchpoint.elements.beams.tangent import tangent
from pitchpoint.elements.kind import FRAME, Kind
from pitchpoint.multibody.channels import frame_args, observations

__all__ = ["KIND", "OUTPUTS", "RECORD", "beam", "beam_row", "entry"]


@kernel
def beam(rec, ctl, fr, kk):
    """Forces, tangents and observations of all beams."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        second_i = node(b, 0, f, f["S"], b["p_i"], b["B_i"])
        second_j = node(b, 1, g, g["S"], b["p_j"], b["B_j"])
        loads(b, f, g, turned(b, second_i, second_j))
        if c["jac"] != 0:
            tangent(b, kk, c["cm"], c["cd"], c["ck"])
        elif c["cm"] != 0.0 and b["mass"] > 0.0:
            tangent(b, kk, c["cm"], 0.0, 0.0)
        if c["out"] != 0:
            internal(b, observations(ctl), b["out"], f["S"], g["S"])
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return beam(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="beam",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    body_fixed=True,
    linear=True,
    fine=True,
    excites=False,
    sections={"beams": ""},
)
