# SPDX-License-Identifier: Apache-2.0
"""Unbalance: point masses on bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.keys import positive, quantities, text


@dataclass(frozen=True, kw_only=True)
class Unbalance:
    """A further point mass on a body, which turns with it."""

    body: str = text("name of the body", names="bodies")
    mass: float = positive("mass", "mass that is added to that of the body")
    position: tuple[float, float, float] = quantities(
        "length", "from the origin of the body, along its axes", length=(3, 3)
    )
