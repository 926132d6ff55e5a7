# SPDX-License-Identifier: Apache-2.0
"""Records of Rayleigh and modal damping: one block per pair of moving bodies, set at the start of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import damping as element
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers, count_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def damping_bank(model: Model) -> Bank:
    """Empty records; a solver computes the damping matrix at its operating point."""
    number = body_numbers(model)
    moving = [
        number[name] + k
        for name, seat in model.mechanism.seats.items()
        if seat.coordinates
        for k in range(count_of(model, name))
    ]
    rows = []
    if model.damping is not None:
        for i in moving:
            for j in moving:
                row = np.zeros(1, element.RECORD)[0]
                row["i"], row["j"] = i, j
                rows.append(row)
    return pack("damping", element.RECORD, rows, ["damping"] * len(rows))
