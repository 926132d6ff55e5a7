# SPDX-License-Identifier: Apache-2.0
"""Rods without mass that hold two points at a distance."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.keys import ends, positive


@dataclass(frozen=True, kw_only=True)
class Rod:
    """A rigid rod without mass with a ball at either end."""

    ends: tuple[str, str] = ends("its two ends, each of them ground, a body or BODY.MARKER", length=(2, 2))
    length: float | None = positive("length", "distance of its ends", None, display="as the ends are placed")
