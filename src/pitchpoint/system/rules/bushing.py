# SPDX-License-Identifier: Apache-2.0
"""Bushings as records."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pitchpoint.elements import bushing as element
from pitchpoint.model.components.bushing import Bushing
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.places import Places


def bushing_bank(bushings: Mapping[str, Bushing], places: Places) -> Bank:
    """All bushings."""
    rows = []
    for part in bushings.values():
        row = np.zeros(1, element.RECORD)[0]
        places.mark(row, part.ends)
        row["K"] = part.stiffness.matrix6()
        if part.damping is not None:
            row["D"] = part.damping.matrix6()
        rows.append(row)
    return pack("bushing", element.RECORD, rows, list(bushings))
