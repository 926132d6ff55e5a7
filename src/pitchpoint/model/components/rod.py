# SPDX-License-Identifier: Apache-2.0
"""Massless rods that keep two points at a constant distance."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import ends, positive


@dataclass(frozen=True, kw_only=True)
class Rod(Component):
    """A rigid massless rod with a ball joint at each end."""

    ends: tuple[str, str] = ends("the two ends, each of them ground, a body or BODY.MARKER", length=(2, 2))
    length: float | None = positive(
        "length", "distance between the ends", None, display="from the positions of the ends"
    )
