# SPDX-License-Identifier: Apache-2.0
"""A rigid body that carries gears and moves in chosen directions."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.keys import choice, derived, key, quantities, quantity

MOTIONS = ("torsion", "planar", "free", "fixed")


@dataclass(frozen=True, kw_only=True)
class Body:
    """A rigid body; its spin axis is the z axis of its own frame."""

    gears: dict[str, float] = key(
        "gears", "names of the gears, or a mapping of names to axial offsets of their mid-faces [m]", {}
    )
    motion: str = choice(
        MOTIONS, "torsion: spin only; planar: x, y, spin; free: all six; fixed: none", "torsion"
    )
    inertia: float | None = quantity(
        "inertia",
        "polar moment of inertia about the spin axis; changes neither mass nor transverse inertia",
        None,
        minimum=0.0,
        range_words="> 0 for a body that moves, else >= 0",
        display="sum over the gears",
    )
    transverse_inertia: float | None = quantity(
        "inertia",
        "moment of inertia about a diameter through the origin, not through the centre of mass: "
        "mass * center_of_mass^2 is part of it",
        None,
        minimum=0.0,
        range_words="> mass * center_of_mass^2 with motion: free, else >= 0",
        display="sum over the gears",
    )
    mass: float | None = quantity(
        "mass",
        "mass; alone it leaves the centre of mass and the inertia about it as the gears make them",
        None,
        minimum=0.0,
        range_words="> 0 with motion: planar or free, else >= 0",
        display="sum over the gears",
    )
    center_of_mass: float | None = quantity(
        "length",
        "axial position of the centre of mass from the origin; alone it leaves the gears where they are and "
        "their transverse inertia is summed about it",
        None,
        display="that of the gears",
    )
    position: tuple[float, float, float] | None = quantities(
        "length", "origin of the body [x, y, z]", None, length=(3, 3), display="from the meshes"
    )
    origin: tuple[float, float, float] | None = derived()
    """Origin of the body in the world [m]: the given position, or the one that follows from the meshes."""
