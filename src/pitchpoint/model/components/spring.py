# SPDX-License-Identifier: Apache-2.0
"""Springs and dampers along the line between two points of bodies."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import key, positive, quantity

POINTS = "the two ends, each of them ground, a body or BODY.MARKER"


@dataclass(frozen=True, kw_only=True)
class Spring(Component):
    """Spring and damper in parallel along the line between two points."""

    ends: tuple[str, str] = key("ends", POINTS, length=(2, 2))
    stiffness: float = quantity("stiffness", "stiffness", 0.0, minimum=0.0)
    damping: float = quantity("damping", "damping", 0.0, minimum=0.0)
    free_length: float | None = quantity(
        "length", "free length", None, minimum=0.0, display="initial distance between the ends"
    )
    force: Law | None = key(
        "law",
        "additional tension: a formula of t, elongation, rate, {table: [[x, F], ...], over: "
        "elongation|rate|time}, {python: 'file.py:function', parameters: [...]} with f(t, elongation, "
        "parameters); the rate is appended to the parameters",
        None,
        dimension="force",
        variables=("t", "elongation", "rate"),
    )


@dataclass(frozen=True, kw_only=True)
class Maxwell(Component):
    """Spring and damper in series along the line between two points; zero force at the start."""

    ends: tuple[str, str] = key("ends", POINTS, length=(2, 2))
    stiffness: float = positive("stiffness", "stiffness of the spring")
    damping: float = positive("damping", "damping of the damper")
