# SPDX-License-Identifier: Apache-2.0
"""Periods of a mesh after which the errors of its gears repeat."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def periods_of_errors(model: Model, mesh: str) -> tuple[int, int]:
    """Periods of a mesh after which the errors of gear 1 and of gear 2 repeat.

    The number of teeth if the teeth of the gear differ, the gear is eccentric or wobbles, or the transmission
    error of the mesh has orders of the shaft; else 1.
    """
    one = model.every_mesh[mesh]
    error = getattr(one, "transmission_error", None)
    shafts = ((), ()) if error is None else (error.shaft1, error.shaft2)
    found = []
    for name, orders in zip(one.gears, shafts, strict=True):
        gear = model.toothed[name]
        z = abs(gear.number_of_teeth)
        differs = gear.teeth_differ or any(order % z for order, *_ in orders)
        found.append(z if differs else 1)
    return found[0], found[1]
