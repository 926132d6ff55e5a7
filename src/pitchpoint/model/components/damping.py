# SPDX-License-Identifier: Apache-2.0
"""Damping of the whole model: Rayleigh and modal."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.keys import component, quantity


@dataclass(frozen=True, kw_only=True)
class Rayleigh:
    """Damping matrix a M + b K; the rotation of a train that turns freely is not damped."""

    mass: float = quantity(
        "rate",
        "factor a of the mass matrix, without the rotation of trains that turn freely",
        0.0,
        minimum=0.0,
    )
    stiffness: float = quantity("time", "factor b of the stiffness matrix", 0.0, minimum=0.0)


@dataclass(frozen=True, kw_only=True)
class Damping:
    """Damping added to every body and support."""

    rayleigh: Rayleigh | None = component(Rayleigh, "damping proportional to mass and stiffness")
    modal: float | None = quantity(
        "dimensionless",
        "damping ratio of every mode at the operating point",
        None,
        minimum=0.0,
        maximum=1.0,
    )
