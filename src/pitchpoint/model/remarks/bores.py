# SPDX-License-Identifier: Apache-2.0
"""Bearings whose bore is not the diameter of their shaft: a wrong designation or position."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.frames import body_frame
from pitchpoint.model.rings import rings_of
from pitchpoint.model.shafts import diameters_between

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

FIT = 0.005
"""Relative difference of bore and shaft diameter up to which they fit: more than any tolerance of ISO 286."""


def bores_off_their_shafts(model: Model) -> tuple[Message, ...]:
    """A remark for every bearing whose bore is the diameter of none of the shaft sections in its width.

    At a shoulder a bearing may sit on either diameter.
    """
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
        there = diameters_between(shaft, middle - half, middle + half)
        if all(abs(bore - d) > FIT * d for d in there):
            size = " and ".join(f"{1e3 * d:.6g}" for d in sorted(there))
            found.append(
                remark(
                    f"rolling_bearings.{name}",
                    f"has a bore of {1e3 * bore:.6g} mm on a shaft of {size} mm diameter",
                    "correct the designation or the position, or the section of the shaft",
                )
            )
    return tuple(found)
