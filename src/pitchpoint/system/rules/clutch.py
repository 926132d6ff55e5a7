# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import friction_clutch as element
from pitchpoint.elements.signal import Pool
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.system.rules.load import set_signal

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def clutch_bank(model: Model) -> Bank:
    """All clutches, with regularised friction."""
    number = body_numbers(model)
    pool = Pool()
    rows, names, laws = [], [], []
    for name, part in model.clutches.items():
        row = np.zeros(1, element.RECORD)[0]
        row["i"], row["j"] = (number[b] for b in part.bodies)
        row["sticking"] = element.REGULARISED
        row["ratio"], row["v_s"], row["v_eps"] = part.static_ratio, part.stribeck_speed, part.slip_speed
        laws.append(set_signal(row, pool, part.capacity, f"clutches.{name}.capacity"))
        rows.append(row)
        names.append(name)
    return pack("friction_clutch", element.RECORD, rows, names, pool=pool.array(), laws=tuple(laws))
