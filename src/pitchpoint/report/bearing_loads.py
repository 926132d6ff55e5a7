# SPDX-License-Identifier: Apache-2.0
"""Bearing forces above the static load rating, as notes of a result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, note
from pitchpoint.core.extremes import greatest
from pitchpoint.core.units import format_quantity

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def loads_above_ratings(model: Model, channels: Mapping[str, Any]) -> tuple[Message, ...]:
    """A note for every rolling bearing with a force above its static load rating C0.

    The radial force, of thrust bearings the axial one: the static equivalent load of ISO 76 is not smaller.

    Parameters
    ----------
    model
        The model.
    channels
        Statistics by channel; bearings without channels are omitted.
    """
    found = []
    for name, bearing in model.rolling_bearings.items():
        rating = bearing.geometry.static
        way = "axial" if bearing.geometry.kind == "thrust_ball" else "radial"
        row = channels.get(f"bearing_force[{name}.{way}]")
        if rating is None or row is None or abs(greatest(row)) <= rating:
            continue
        force, limit = (format_quantity(f, "force", 4) for f in (abs(greatest(row)), rating))
        found.append(
            note(
                f"the largest {way} force, {force}, exceeds the static load rating C0 = {limit}",
                f"rolling_bearings.{name}",
                "use a larger bearing, or correct the load",
            )
        )
    return tuple(found)
