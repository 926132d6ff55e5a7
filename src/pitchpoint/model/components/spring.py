# SPDX-License-Identifier: Apache-2.0
"""Springs and dampers along the line between two points."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import ends, key, quantity


@dataclass(frozen=True, kw_only=True)
class Spring:
    """A spring and damper between two points: stiffness * elongation + damping * rate + tension."""

    ends: tuple[str, str] = ends("its two ends, each of them ground, a body or BODY.MARKER", length=(2, 2))
    stiffness: float = quantity("stiffness", "tension per elongation", 0.0, minimum=0.0)
    damping: float = quantity("damping", "tension per rate of elongation", 0.0, minimum=0.0)
    free_length: float | None = quantity(
        "length", "distance of the ends without force", None, minimum=0.0, display="as the ends are placed"
    )
    tension: Law | None = key(
        "law",
        "further tension: a quantity, a formula of t, elongation, rate without units (SI), "
        "{table: [[elongation, N], ...], over: elongation|rate|time}, or {python: 'file.py:function'}, "
        "f(t, elongation, [*parameters, rate])",
        None,
        dimension="force",
        variables={"elongation": "length", "rate": "speed"},
    )
