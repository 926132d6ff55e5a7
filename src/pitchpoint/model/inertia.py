# SPDX-License-Identifier: Apache-2.0
"""Mass and moments of inertia of bodies: what the user gives, else the sum over the gears they carry."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.gear import Gear


@dataclass(frozen=True)
class BodyInertia:
    """Inertia of a body about its own origin, the spin axis being z."""

    mass: float
    """Mass [kg]."""
    polar: float
    """Moment of inertia about the spin axis [kg m^2]."""
    transverse: float
    """Moment of inertia about the x or y axis through the origin [kg m^2]."""
    center: float
    """Axial position of the centre of mass from the origin [m]; 0 when the user gives the mass."""


def gear_inertia(gear: Gear) -> tuple[float, float, float]:
    """Mass [kg], polar and transverse moment of inertia about the centre [kg m^2] of one gear.

    Given values first, the rest from the geometry and the density of the material.
    """
    given = (gear.mass, gear.polar_inertia, gear.transverse_inertia)
    if None in given:
        from pitchpoint.geometry.mass_properties import gear_mass_properties

        found = gear_mass_properties(
            gear.geometry,
            gear.material_data.density,
            rim_thickness=gear.rim_thickness,
            web_thickness=gear.web_thickness,
            bore_diameter=gear.bore_diameter,
        )
        computed = (found.mass, found.polar_inertia, found.transverse_inertia)
        given = tuple(c if g is None else g for g, c in zip(given, computed, strict=True))  # type: ignore[assignment]
    return given  # type: ignore[return-value]


def body_inertia(body: Body, gears: Mapping[str, Gear]) -> BodyInertia:
    """Inertia of a body about its origin.

    Parameters
    ----------
    body
        The body; a given mass, inertia or transverse inertia replaces the sum over its gears.
    gears
        All gears of the model by name.
    """
    mass = polar = transverse = first = 0.0
    if None in (body.mass, body.inertia, body.transverse_inertia):
        for name, offset in body.gears.items():
            m, j_p, j_t = gear_inertia(gears[name])
            mass, polar, first = mass + m, polar + j_p, first + m * offset
            transverse += j_t + m * offset * offset
    center = first / mass if body.mass is None and mass > 0.0 else 0.0
    return BodyInertia(
        mass if body.mass is None else body.mass,
        polar if body.inertia is None else body.inertia,
        transverse if body.transverse_inertia is None else body.transverse_inertia,
        center if math.isfinite(center) else 0.0,
    )
