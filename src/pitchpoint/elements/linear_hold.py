# SPDX-License-Identifier: Apache-2.0
"""Blocks of a condensed linear part on one body that constrain the spin of the body."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.kind import COORDINATE, OWN, Kind, Power
from pitchpoint.elements.linear_part import OUTPUTS, RECORD, linear_part, part_args

__all__ = ["KIND", "OUTPUTS", "RECORD", "entry"]


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, v, a, R, A = part_args(ctl)
    return linear_part(view(rec, n, RECORD), c, fr, q, v, a, R, A)


KIND = Kind(
    name="linear_hold",
    channel=COORDINATE,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    resists=OWN,
    power=Power(),
)
