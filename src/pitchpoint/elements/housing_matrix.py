# SPDX-License-Identifier: Apache-2.0
"""Blocks of the matrices between the nodes of a housing."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.kind import COORDINATE, FREE, HOLDS, NOTHING, OWN, Kind, Power
from pitchpoint.elements.linear_part import OUTPUTS, RECORD, linear_part, part_args

__all__ = ["KIND", "OUTPUTS", "RECORD", "entry"]


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, q, v, a, R, A = part_args(ctl)
    return linear_part(view(rec, n, RECORD), c, fr, q, v, a, R, A)


def _own(record: np.void) -> bool:
    """Whether a record is the block of one node."""
    return bool(record["i"] == record["j"])


KIND = Kind(
    name="housing_matrix",
    channel=COORDINATE,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    spins=lambda record: HOLDS if _own(record) else FREE,
    resists=lambda record: OWN if _own(record) else NOTHING,
    label="matrix",
    linear=True,
    fine=True,
    excites=False,
    power=Power(),
)
