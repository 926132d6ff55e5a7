# SPDX-License-Identifier: Apache-2.0
"""Damping of the whole model: Rayleigh and modal."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import component, quantity


@dataclass(frozen=True, kw_only=True)
class Rayleigh(Component):
    """Damping matrix a M + b K, computed once; free rotation of a gear train is not damped."""

    mass: float = quantity(
        "rate",
        "factor a of the mass matrix, without the free rotation of gear trains",
        0.0,
        minimum=0.0,
    )
    stiffness: float = quantity(
        "time",
        "factor b of the stiffness matrix at the initial state of a run. The matrix is constant: it also "
        "acts within the backlash, and omits flanks without contact at the start (start: assembled)",
        0.0,
        minimum=0.0,
    )


@dataclass(frozen=True, kw_only=True)
class Damping(Component):
    """Global damping of all bodies and supports: one constant matrix from the initial state of a run."""

    rayleigh: Rayleigh | None = component(Rayleigh, "damping proportional to mass and stiffness")
    modal: float | None = quantity(
        "dimensionless",
        "damping ratio of every mode about the initial state of a run. The matrix is constant: it also acts "
        "within the backlash, and omits flanks without contact at the start (start: assembled)",
        None,
        minimum=0.0,
        maximum=1.0,
    )
