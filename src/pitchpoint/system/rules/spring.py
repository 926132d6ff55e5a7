# SPDX-License-Identifier: Apache-2.0
"""Springs and dampers between two points."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import spring_damper as element
from pitchpoint.elements.signal import OVER_BOTH, Pool
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import end_of, world_place
from pitchpoint.system.rules.load import set_signal

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def spring_bank(model: Model) -> Bank:
    """All springs."""
    pool = Pool()
    rows, names, laws = [], [], []
    for name, part in model.springs.items():
        row = np.zeros(1, element.RECORD)[0]
        for end, place in zip("ij", part.ends, strict=True):
            row[end], row[f"p_{end}"], _ = end_of(model, place)
        row["k"], row["d"] = part.stiffness, part.damping
        row["free"] = part.free_length
        if part.free_length is None:
            row["free"] = np.linalg.norm(world_place(model, part.ends[0]) - world_place(model, part.ends[1]))
        law = None
        if part.tension is not None:
            law = set_signal(row, pool, part.tension, f"springs.{name}.tension", OVER_BOTH)
        laws.append(law)
        rows.append(row)
        names.append(name)
    return pack("spring_damper", element.RECORD, rows, names, pool=pool.array(), laws=tuple(laws))
