# SPDX-License-Identifier: Apache-2.0
"""Bushings as records."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements import bushing as element
from pitchpoint.model.frames import GROUND
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.places import Places


def bushing_bank(places: Places) -> Bank:
    """All bushings; an end on ground coincides with the other end with all coordinates zero."""
    bushings = places.model.bushings
    rows = []
    for part in bushings.values():
        row = np.zeros(1, element.RECORD)[0]
        places.mark(row, part.ends)
        for letter, end, other in zip("ij", part.ends, part.ends[::-1], strict=True):
            if end == GROUND:
                row["p_" + letter], row["A_" + letter] = places.world(other), places.axes(other)
        row["K"] = part.stiffness.matrix6()
        if part.damping is not None:
            row["D"] = part.damping.matrix6()
        rows.append(row)
    return pack("bushing", element.RECORD, rows, list(bushings))
