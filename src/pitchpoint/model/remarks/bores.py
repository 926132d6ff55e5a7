# SPDX-License-Identifier: Apache-2.0
"""Bearings whose bore is far from the diameter of their shaft: a wrong designation or position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.frames import body_frame
from pitchpoint.model.rings import rings_of
from pitchpoint.model.shafts import section_at

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

APART = 1.25
"""Ratio of bore and shaft diameter, either way, from which there is a remark: shafts of a model are often
simplified."""


def bores_off_their_shafts(model: Model) -> tuple[Message, ...]:
    """A remark for every bearing with a bore that does not fit the sections of its shaft."""
    found = []
    for name, part in model.rolling_bearings.items():
        bore, ring = part.geometry.bore, rings_of(model, part)[0]
        shaft = model.shafts.get(ring.body)
        if bore is None or shaft is None or ring.place is None:
            continue
        origin, axes = body_frame(model, ring.body)
        if origin is None:
            continue
        middle = float((ring.place - origin) @ axes[:, 2])
        half = 0.5 * (part.geometry.width or 0.0)
        there = [section_at(shaft, middle + x)[0] for x in (-half, 0.0, half)]
        if not min(there) / APART < bore < max(there) * APART:
            size = " to ".join(f"{1e3 * d:.6g}" for d in sorted({min(there), max(there)}))
            found.append(
                remark(
                    f"rolling_bearings.{name}",
                    f"has a bore of {1e3 * bore:.6g} mm on a shaft of {size} mm diameter",
                    "correct the designation or the position, or the section of the shaft",
                )
            )
    return tuple(found)
