# SPDX-License-Identifier: Apache-2.0
"""Room for Rayleigh and modal damping: a block for every pair of moving bodies, filled when a run starts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import damping as element
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers, count_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def damping_bank(model: Model) -> Bank:
    """Empty records; the matrix belongs to an operating point, which only a solver knows."""
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
