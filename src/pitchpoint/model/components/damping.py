# SPDX-License-Identifier: Apache-2.0
"""Damping of the whole model: Rayleigh and modal."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.keys import component, quantity


@dataclass(frozen=True, kw_only=True)
class Rayleigh:
    """Damping matrix a M + b K, made once; the rotation of a train that turns freely is not damped."""

    mass: float = quantity(
        "rate",
        "factor a of the mass matrix, without the rotation of trains that turn freely",
        0.0,
        minimum=0.0,
    )
    stiffness: float = quantity(
        "time",
        "factor b of the stiffness matrix at the state from which a run starts; it acts on from there, also "
        "inside the gap, and holds no flanks that do not touch at the start (start: assembled)",
        0.0,
        minimum=0.0,
    )


@dataclass(frozen=True, kw_only=True)
class Damping:
    """Damping added to every body and support; one matrix, made at the state from which a run starts."""

    rayleigh: Rayleigh | None = component(Rayleigh, "damping proportional to mass and stiffness")
    modal: float | None = quantity(
        "dimensionless",
        "damping ratio of every mode about the state from which a run starts; the matrix acts on from there, "
        "also inside the gap, and holds no flanks that do not touch at the start (start: assembled)",
        None,
        minimum=0.0,
        maximum=1.0,
    )
