# SPDX-License-Identifier: Apache-2.0
"""Bodies that stand where hardly anybody wants them, because the model leaves their places open."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.model.frames import Array, body_frame, split

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

SAME = 1e-6
"""Distance of two axes as a share of the tip circles on them up to which they count as one."""


def places_left_open(model: Model) -> tuple[str, ...]:
    """A sentence for every axis that a joint has placed, and for gears that stand in each other."""
    return (*_axes_by_joints(model), *_gears_in_gears(model))


def _axes_by_joints(model: Model) -> Iterator[str]:
    """Bodies that turn about an axis of their own, which goes through a joint for want of a position.

    A carrier whose planets have places would turn about the pin of the first of them.
    """
    for name, body in model.bodies.items():
        seat = model.mechanism.seats.get(name)
        if body.position is not None or body.gears or body.bevel_gears:
            continue
        if seat is None or seat.joint is not None:
            continue
        if seat.kind not in ("revolute", "planar"):
            continue
        origin, _ = body_frame(model, name)
        joints = [n for n, j in model.joints.items() if name in (split(end)[0] for end in j.bodies)]
        linked = any(name in coupling.bodies for coupling in model.couplings.values())
        if not joints or linked or origin is None:
            continue
        where = ", ".join(format_quantity(round(float(x), 9) + 0.0, "length", 4) for x in origin)
        yield (
            f"bodies.{name}: has no position and takes that of joints.{joints[0]}, [{where}], so that it "
            "turns about an axis there; if its axis is another one, give position: [x, y, z]"
        )


def _gears_in_gears(model: Model) -> Iterator[str]:
    """External gears of two bodies on one axis that overlap along it, such as planets without directions."""
    spans = [
        (name, gear, *span)
        for name, body in model.bodies.items()
        for gear, offset in body.gears.items()
        if gear in model.gears and (span := _span(model, name, gear, offset)) is not None
    ]
    for (one, a, at, along, low, high), (two, b, other, way, least, most) in combinations(spans, 2):
        apart = other - at
        beside = float(np.linalg.norm(apart - (apart @ along) * along))
        reach = SAME * model.gears[a].geometry.d_a
        if one == two or abs(along @ way) < 1.0 - SAME or beside > reach:
            continue
        ends = sorted(float(other @ along + x * (way @ along)) for x in (least, most))
        here = float(at @ along)
        if min(ends[1], here + high) - max(ends[0], here + low) > reach:
            yield (
                f"bodies.{two}: {b} stands in {a} of {one}, on the same axis; give the meshes that place "
                "them a direction each, or the bodies a position: [x, y, z]"
            )


def _span(model: Model, body: str, gear: str, offset: float) -> tuple[Array, Array, float, float] | None:
    """Place and axis of the body of an external gear, and where along it the gear begins and ends [m]."""
    origin, axes = body_frame(model, body)
    if origin is None or model.gears[gear].geometry.is_internal:
        return None
    half = 0.5 * model.gears[gear].face_width
    return origin, axes[:, 2], offset - half, offset + half
