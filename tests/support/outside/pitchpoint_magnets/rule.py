# SPDX-License-Identifier: Apache-2.0
"""Rule: from components to records."""

from __future__ import annotations

import numpy as np

from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.places import Places
from pitchpoint_magnets.element import RECORD


def magnet_bank(places: Places) -> Bank:
    """All magnetic couplings of a model."""
    rows = []
    couplings = places.model.magnet_couplings
    for part in couplings.values():
        row = np.zeros(1, RECORD)[0]
        places.pair(row, part.bodies)
        row["stiffness"], row["damping"] = part.stiffness, part.damping
        rows.append(row)
    return pack("magnet_coupling", RECORD, rows, list(couplings))
