# SPDX-License-Identifier: Apache-2.0
"""Fixed ratios of coordinates as constraint rows."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import ratio as element
from pitchpoint.model.mechanism import coordinate
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.system.rules.places import Places


def ratio_bank(places: Places) -> Bank:
    """All ratios; the weighted sum of coordinates keeps its value at the start values of the joints."""
    model = places.model
    number = body_numbers(model)
    rows, names = [], []
    for name, part in model.ratios.items():
        row = np.zeros(1, element.RECORD)[0]
        first = next(iter(part.terms.values()))
        for end, (word, factor) in zip("ijk", part.terms.items(), strict=False):
            found = coordinate(model.mechanism, model, word)
            if isinstance(found, str):
                raise CompileError(f"ratios.{name}.terms.{word}: {found}")
            body, k, dimension = found
            seat = model.mechanism.seats[body]
            row[end], row[f"q_{end}"], row[f"c_{end}"] = number[body], k, float(factor)
            start = model.joints[seat.joint].start if seat.joint is not None else {}
            row["u0"] += float(factor) / first * start.get(seat.coordinates[k], 0.0)
            if end == "i":
                row["linear"] = dimension == "length"
        rows.append(row)
        names.append(name)
    return pack("ratio", element.RECORD, rows, names)
