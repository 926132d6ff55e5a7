# SPDX-License-Identifier: Apache-2.0
"""Envelope of the cylindrical and bevel gears of a body along and around its axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


@dataclass(frozen=True)
class Seated:
    """Envelope of a gear on its body.

    Attributes
    ----------
    low, high
        Ends along the z axis of the body [m].
    hub
        Bore radius, 0 for none [m].
    root
        Radius up to which the whole width is solid; None for a ring [m].
    outer
        Largest radius [m].
    """

    low: float
    high: float
    hub: float
    root: float | None
    outer: float

    @property
    def middle(self) -> float:
        """Middle along the z axis of the body [m]."""
        return 0.5 * (self.low + self.high)


def seated(model: Model, body: str) -> dict[str, Seated]:
    """Envelopes of all gears of a body, by name.

    Parameters
    ----------
    model
        The model.
    body
        Name of the body.
    """
    found = {}
    for name, z in model.bodies[body].gears.items():
        gear = model.gears[name]
        half, shape, hub = 0.5 * gear.face_width, gear.geometry, 0.5 * gear.bore_diameter
        if shape.is_internal:
            found[name] = Seated(z - half, z + half, 0.0, None, max(0.5 * abs(shape.d_a), hub))
        else:
            found[name] = Seated(z - half, z + half, hub, 0.5 * shape.d_f, 0.5 * shape.d_a)
    for name, apex in model.bodies[body].bevel_gears.items():
        bevel = model.bevel_gears[name]
        blank, way = bevel.blank, bevel.direction
        ends = sorted(apex + way * z for z in (blank.toe[1], max(blank.back[1], blank.heel[1])))
        root = min(blank.toe[0], blank.back[0])
        found[name] = Seated(ends[0], ends[1], blank.bore, root, 0.5 * bevel.geometry.d_ae)
    return found
