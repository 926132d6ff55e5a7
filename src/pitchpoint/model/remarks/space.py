# SPDX-License-Identifier: Apache-2.0
"""Gears and bearings of one shaft in the same place: a wrong position or width."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.model.frames import body_frame
from pitchpoint.model.rings import rings_of

if TYPE_CHECKING:
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.model import Model

TOUCH = 1e-6
"""Overlap [m] of parts that touch, attributed to rounding."""


def gears_in_one_place(model: Model) -> Iterator[Message]:
    """A remark for every two cylindrical gears of one body whose face widths overlap.

    Without axial positions, as in models of torsion, all gears of a body are at its origin. Teeth in
    different rings, such as outside and inside a rim, do not meet.
    """
    for body, part in model.bodies.items():
        if part.stage is not None:
            continue
        for one, two in combinations(part.gears, 2):
            if part.shaft is None and part.gears[one] == part.gears[two] == 0.0:
                continue
            (low, high), (begin, end) = (_face(model, part, gear) for gear in (one, two))
            both = min(high, end) - max(low, begin)
            if both > TOUCH and _rings_meet(model.gears[one], model.gears[two]):
                section = "shafts" if part.shaft is not None else "bodies"
                yield remark(
                    f"{section}.{body}.gears.{two}",
                    f"overlaps {one} by {_mm(both)}: {two} extends from {_range(begin, end)}, {one} from "
                    f"{_range(low, high)}",
                    "correct the positions, which are those of the middle of the face, or the face widths",
                )


def bearings_in_gears(model: Model) -> Iterator[Message]:
    """A remark for every bearing of an elastic shaft within the face width of a gear on the same shaft.

    A bearing in the bore of an idler or a planet has its outer ring on the gear. One below the rim of a gear
    is recognised by the `rim_thickness`.
    """
    for name, bearing in model.rolling_bearings.items():
        inner, outer = rings_of(model, bearing)
        part = model.bodies.get(inner.body)
        if part is None or part.shaft is None or inner.place is None or outer.body == inner.body:
            continue
        origin, axes = body_frame(model, inner.body)
        if origin is None:
            continue
        middle, half = float((inner.place - origin) @ axes[:, 2]), 0.5 * (bearing.geometry.width or 0.0)
        for gear in part.gears:
            low, high = _face(model, part, gear)
            both = min(high, middle + half) - max(low, middle - half)
            if both <= (TOUCH if half else 0.0) or _below_rim(model.gears[gear], bearing.geometry.outside):
                continue
            size = f" by {_mm(both)}" if half else ""
            yield remark(
                f"rolling_bearings.{name}.{'position' if bearing.ends is None else 'ends'}",
                f"overlaps the gear {gear} on {inner.body}{size}: the bearing extends from "
                f"{_range(middle - half, middle + half)}, the gear from {_range(low, high)}",
                "correct the position, which is that of the middle, or give rim_thickness of a gear that "
                "covers the bearing",
            )


def _face(model: Model, body: Body, gear: str) -> tuple[float, float]:
    """Ends of the face width of a gear on its body [m]."""
    half = 0.5 * model.gears[gear].face_width
    return body.gears[gear] - half, body.gears[gear] + half


def _rings_meet(one: Gear, two: Gear) -> bool:
    """Whether the radial ranges of two gears of one axis overlap."""
    (low, high), (begin, end) = _radii(one), _radii(two)
    return min(high, end) > max(low, begin)


def _radii(gear: Gear) -> tuple[float, float]:
    """Diameters between which a gear is solid, with its teeth [m]."""
    teeth = sorted(abs(d) for d in (gear.geometry.d_a, gear.geometry.d_f))
    return (teeth[0], teeth[1]) if gear.type == "internal" else (gear.bore_diameter, teeth[1])


def _below_rim(gear: Gear, outside: float | None) -> bool:
    """Whether a bearing of an outside diameter [m] fits below the rim of a gear."""
    if gear.type == "internal":
        return outside is None or outside < abs(gear.geometry.d_a)
    if gear.rim_thickness is None or outside is None:
        return False
    return outside < gear.geometry.d_f - 2.0 * gear.rim_thickness


def _range(low: float, high: float) -> str:
    return f"{round(1e3 * low, 6):.6g} to {_mm(high)}"


def _mm(length: float) -> str:
    return format_quantity(round(length, 9), "length", 6)
