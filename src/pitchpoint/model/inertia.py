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
    """Inertia of a body whose spin axis is z."""

    mass: float
    """Mass [kg]."""
    polar: float
    """Moment of inertia about the spin axis [kg m^2]."""
    central: float
    """Moment of inertia about a diameter through the centre of mass [kg m^2]."""
    center: float
    """Axial position of the centre of mass from the origin [m]."""

    @property
    def transverse(self) -> float:
        """Moment of inertia about the x or y axis through the origin [kg m^2]."""
        return self.central + self.mass * self.center * self.center


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


def asks_gears(body: Body) -> bool:
    """Whether anything of the inertia of a body is left to its gears."""
    if None in (body.mass, body.inertia, body.transverse_inertia):
        return True
    return body.center_of_mass is None and any(offset != 0.0 for offset in body.gears.values())


def body_inertia(body: Body, gears: Mapping[str, Gear]) -> BodyInertia:
    """Inertia of a body: every value that is given, and the rest from its gears.

    The centre of mass is that of the gears, or the origin where they have no mass. A given mass does not move
    it, and leaves the inertia about it as it is. The transverse inertia of the gears is their sum about the
    centre of mass in force; a given one counts about the origin.

    Parameters
    ----------
    body
        The body.
    gears
        All gears of the model by name.
    """
    found = [(*gear_inertia(gears[name]), at) for name, at in body.gears.items()] if asks_gears(body) else []
    mass = sum(m for m, _, _, _ in found)
    center = body.center_of_mass
    if center is None:
        center = sum(m * at for m, _, _, at in found) / mass if mass > 0.0 else 0.0
    if not math.isfinite(center):
        center = 0.0
    central = sum(j_t + m * (at - center) * (at - center) for m, _, j_t, at in found)
    mass = mass if body.mass is None else body.mass
    if body.transverse_inertia is not None:
        central = body.transverse_inertia - mass * center * center
    polar = sum(j_p for _, j_p, _, _ in found) if body.inertia is None else body.inertia
    return BodyInertia(mass, polar, central, center)
