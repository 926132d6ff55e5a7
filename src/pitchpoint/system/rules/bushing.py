# SPDX-License-Identifier: Apache-2.0
"""Elastic bushings between markers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import bushing as element
from pitchpoint.model.frames import GROUND, axes_of, split
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import end_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def bushing_bank(model: Model) -> Bank:
    """All bushings; both markers take the axes that the second has where the file places the bodies."""
    rows, names = [], []
    for name, part in model.bushings.items():
        row = np.zeros(1, element.RECORD)[0]
        common = axes_of(model, part.ends[1])
        for end, place in zip("ij", part.ends, strict=True):
            row[end], row[f"p_{end}"], _ = end_of(model, place)
            body = split(place)[0]
            own = np.eye(3) if body == GROUND else seat_frame(model, model.mechanism.seats[body])[1]
            row[f"A_{end}"] = own.T @ common
        row["K"] = part.stiffness.matrix6()
        if part.damping is not None:
            row["D"] = part.damping.matrix6()
        rows.append(row)
        names.append(name)
    return pack("bushing", element.RECORD, rows, names)
