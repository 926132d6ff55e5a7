# SPDX-License-Identifier: Apache-2.0
"""Bearings and gears whose bore does not fit their shaft: a wrong designation, position or section."""

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


def gears_thinner_than_their_shafts(model: Model) -> tuple[Message, ...]:
    """A remark for every gear with a bore smaller than its shaft: its mass does not depend on the bore."""
    found = []
    for shaft in model.shafts:
        for at, low, high in _seats(model, shaft):
            section, gear = at
            bore, mass = (getattr(getattr(model, section)[gear], key) for key in ("bore_diameter", "mass"))
            sizes = [d for a, b, d, _ in model.shafts[shaft].pieces_from(0.0) if a < high and b > low]
            if mass is None and sizes and 0.0 < bore < max(sizes) * (1.0 - FIT):
                found.append(
                    remark(
                        f"{section}.{gear}.bore_diameter",
                        f"{1e3 * bore:.6g} mm is less than the {1e3 * max(sizes):.6g} mm of the shaft "
                        f"{shaft} there; the mass of the gear is that of its part outside the shaft",
                        "correct the bore, or the section of the shaft",
                        line=model.line((*at, "bore_diameter")),
                    )
                )
    return tuple(found)


def _seats(model: Model, shaft: str) -> list[tuple[tuple[str, str], float, float]]:
    """External and bevel gears of a shaft with the ends of their bores [m]."""
    body, found = model.bodies[shaft], []
    for name, place in body.gears.items():
        gear = model.gears[name]
        if gear.type == "external":
            found.append((("gears", name), place - 0.5 * gear.face_width, place + 0.5 * gear.face_width))
    for name, apex in body.bevel_gears.items():
        part = model.bevel_gears[name]
        low, high = sorted(apex + part.direction * z for z in (part.blank.toe[1], part.blank.back[1]))
        found.append((("bevel_gears", name), low, high))
    return found
