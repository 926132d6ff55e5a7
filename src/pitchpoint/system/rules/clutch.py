# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes as records."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements import friction_clutch as element
from pitchpoint.elements import signal as sig
from pitchpoint.model.components.law import Constant
from pitchpoint.model.engagement import is_open
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.load import set_signal
from pitchpoint.system.rules.places import Places


def clutch_bank(places: Places) -> Bank:
    """All clutches and brakes."""
    clutches = places.model.clutches
    engaged = None if places.scenario is None else places.scenario.engaged
    pool, rows, laws = sig.Pool(), [], []
    for name, part in clutches.items():
        row = np.zeros(1, element.RECORD)[0]
        places.pair(row, part.bodies)
        capacity = Constant(0.0) if is_open(name, part, engaged) else part.capacity
        laws.append(set_signal(row, pool, capacity, f"clutches.{name}.capacity"))
        row["ratio"], row["v_s"], row["v_eps"] = part.static_ratio, part.stribeck_speed, part.slip_speed
        if part.law == "bristles":
            row["sticking"], row["k"] = element.BRISTLE, places.state(name)
            row["stiffness"], row["onset"] = 1.0 / part.wind_up, part.holding
            row["sigma"] = part.damping_time
        rows.append(row)
    return pack("friction_clutch", element.RECORD, rows, list(clutches), pool=pool.array(), laws=tuple(laws))
