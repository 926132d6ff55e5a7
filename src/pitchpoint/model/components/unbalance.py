# SPDX-License-Identifier: Apache-2.0
"""Unbalance: point masses on bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import positive, quantities, text


@dataclass(frozen=True, kw_only=True)
class Unbalance(Component):
    """An additional point mass fixed to a body."""

    body: str = text("name of the body", names="bodies")
    mass: float = positive("mass", "point mass, added to the mass of the body")
    position: tuple[float, float, float] = quantities(
        "length", "position relative to the origin of the body, in its axes", length=(3, 3)
    )
