# SPDX-License-Identifier: Apache-2.0
"""Blocks of a condensed linear part between bodies and modal coordinates; they constrain no rotation."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.kind import COORDINATE, FREE, Kind, Power
from pitchpoint.elements.linear_part import OUTPUTS, RECORD, linear_part, part_args

__all__ = ["KIND", "OUTPUTS", "RECORD", "entry"]


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, v, a, R, A = part_args(ctl)
    return linear_part(view(rec, n, RECORD), c, fr, q, v, a, R, A)


KIND = Kind(
    name="linear_modes",
    channel=COORDINATE,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    spins=FREE,
    excites=False,
    power=Power(),
)
