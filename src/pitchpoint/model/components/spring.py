# SPDX-License-Identifier: Apache-2.0
"""Springs and dampers along the line between two points of bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import key, positive, quantity

POINTS = "its two ends, each of them ground, a body or BODY.MARKER"


@dataclass(frozen=True, kw_only=True)
class Spring:
    """Spring and damper side by side along the line between two points."""

    ends: tuple[str, str] = key("ends", POINTS, length=(2, 2))
    stiffness: float = quantity("stiffness", "force per elongation", 0.0, minimum=0.0)
    damping: float = quantity("damping", "force per rate of elongation", 0.0, minimum=0.0)
    free_length: float | None = quantity(
        "length", "length without force", None, minimum=0.0, display="distance of its ends as placed"
    )
    force: Law | None = key(
        "law",
        "further tension: a formula of t, elongation, rate, {table: [[x, F], ...], over: elongation|rate|"
        "time}, {python: 'file.py:function', parameters: [...]} with f(t, elongation, parameters), the rate "
        "behind the parameters",
        None,
        dimension="force",
        variables=("t", "elongation", "rate"),
    )


@dataclass(frozen=True, kw_only=True)
class Maxwell:
    """Spring and damper in series along the line between two points; no force at the start."""

    ends: tuple[str, str] = key("ends", POINTS, length=(2, 2))
    stiffness: float = positive("stiffness", "of the spring")
    damping: float = positive("damping", "of the damper")
