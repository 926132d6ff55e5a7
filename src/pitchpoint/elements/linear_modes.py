# SPDX-License-Identifier: Apache-2.0
"""Blocks of a condensed linear part that join bodies to modal coordinates: they hold no rotation."""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.linear_part import OUTPUTS, RECORD, linear_part, part_args

__all__ = ["OUTPUTS", "RECORD", "SPINS", "entry"]

SPINS = "free"


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, q, v, a, R, A = part_args(ctl)
    return linear_part(view(rec, n, RECORD), c, fr, q, v, a, R, A)
