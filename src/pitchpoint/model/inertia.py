# SPDX-License-Identifier: Apache-2.0
"""Mass and moments of inertia of bodies: as given, else from the solid, else the sum over the gears."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.solids import solid_mass, solid_of_gear

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from pitchpoint.geometry.mass_properties import ShaftPiece
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.solid import SolidReference

Added = tuple[float, float, float, float]
"""Mass [kg], polar inertia, inertia about a diameter through the centre of mass [kg m^2] and position of the
centre of mass along the axis [m]."""


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
    off_axis: tuple[float, float] = (0.0, 0.0)
    """Offset of the centre of mass from the axis, x and y of the body [m]."""
    tensor: tuple[float, ...] | None = None
    """Ixx, Iyy, Izz, Ixy, Iyz, Izx about the centre of mass of a body that is not axisymmetric [kg m^2]."""

    @property
    def place(self) -> tuple[float, float, float]:
        """Centre of mass relative to the origin, in the axes of the body [m]."""
        return (*self.off_axis, self.center)

    def about_center(self) -> NDArray[np.float64]:
        """Inertia about the centre of mass in the axes of the body, shape (3, 3) [kg m^2]."""
        return matrix(self.tensor or (self.central, self.central, self.polar, 0.0, 0.0, 0.0))

    @property
    def transverse(self) -> float:
        """Moment of inertia about the x or y axis through the origin [kg m^2]."""
        return self.central + self.mass * self.center * self.center


def gear_inertia(gear: Gear) -> tuple[float, float, float]:
    """Mass [kg], polar and transverse moment of inertia about the centre [kg m^2] of one gear.

    Given values take precedence, then those of the solid, then geometry and density of the material.
    """
    return _gear_outside(gear, ())[:3]


def gear_by_geometry(gear: Gear) -> tuple[float, float, float]:
    """Mass [kg], polar and transverse moment of inertia [kg m^2] of teeth and blank."""
    found = gear.mass_properties
    return found.mass, found.polar_inertia, found.transverse_inertia


def bevel_gear_inertia(gear: BevelGear) -> tuple[float, float, float, float]:
    """Mass [kg], polar and transverse moment of inertia [kg m^2] and axial position [m] of the centre of
    mass.

    The moments are about the centre of mass; its position is relative to the apex along the z axis of the
    body and does not depend on a given mass.
    """
    return _bevel_gear_outside(gear, ())


def gears_of_body(
    body: Body, gears: Mapping[str, Gear], bevel_gears: Mapping[str, BevelGear] | None = None
) -> dict[str, Added]:
    """What the gears of a body add to its mass.

    The sections of a shaft and its gears may share space, where only the material of the shaft counts: a gear
    adds the part outside the shaft. Given masses and those of solids are added as they are.

    Parameters
    ----------
    body
        The body.
    gears, bevel_gears
        All gears of the model by name.

    Returns
    -------
    dict
        By gear: mass [kg], polar inertia and inertia about a diameter through the centre of mass [kg m^2],
        and position of the centre of mass along the body [m].
    """
    found = {}
    for name, place in body.gears.items():
        shaft = body.shaft.pieces_from(place) if body.shaft is not None else ()
        mass, polar, central, at = _gear_outside(gears[name], shaft)
        found[name] = mass, polar, central, place + at
    for name, apex in body.bevel_gears.items():
        shaft = body.shaft.pieces_from(apex) if body.shaft is not None else ()
        mass, polar, central, at = _bevel_gear_outside((bevel_gears or {})[name], shaft)
        found[name] = mass, polar, central, apex + at
    return found


def _gear_outside(gear: Gear, shaft: Sequence[ShaftPiece]) -> Added:
    """Mass, inertias and centre of mass from mid-face of the part of a gear outside a shaft."""
    given = (gear.mass, gear.polar_inertia, gear.transverse_inertia)
    if None not in given:
        return (*given, 0.0)  # type: ignore[return-value]
    if gear.solid is not None:
        return (*_first(given, solid_of_gear(gear)), 0.0)
    found = gear.mass_properties_on(shaft) if shaft else gear.mass_properties
    computed = found.mass, found.polar_inertia, found.transverse_inertia
    return (*_first(given, computed), found.center if gear.mass is None else 0.0)


def _bevel_gear_outside(gear: BevelGear, shaft: Sequence[ShaftPiece]) -> Added:
    """Mass, inertias and centre of mass from the apex of the part of a bevel gear outside a shaft."""
    from pitchpoint.geometry.bevel.blank import bevel_mass

    way = gear.direction
    along = [(min(way * a, way * b), max(way * a, way * b), outer, bore) for a, b, outer, bore in shaft]
    density, blank = gear.material_data.density, (gear.bore_diameter, gear.rim_thickness)
    found = bevel_mass(gear.geometry, density, *blank, shaft=along)
    whole = bevel_mass(gear.geometry, density, *blank) if gear.mass is not None else found
    given = (gear.mass, gear.polar_inertia, gear.transverse_inertia)
    computed = (found.mass, found.polar_inertia, found.transverse_inertia)
    return (*_first(given, computed), way * whole.center)


def _first(given: Sequence[float | None], computed: Sequence[float]) -> tuple[float, float, float]:
    """Given values, computed ones for the others."""
    mass, polar, transverse = (c if g is None else g for g, c in zip(given, computed, strict=True))
    return mass, polar, transverse


def asks_gears(body: Body) -> bool:
    """Whether the inertia of a body depends on its gears."""
    if body.solid is not None:
        return False
    aside = bool(body.bevel_gears) or any(offset != 0.0 for offset in body.gears.values())
    if body.inertia_tensor is not None:
        return body.mass is None or (body.center_of_mass is None and aside)
    if None in (body.mass, body.inertia, body.transverse_inertia):
        return True
    return body.center_of_mass is None and aside


def body_inertia(
    body: Body, gears: Mapping[str, Gear], bevel_gears: Mapping[str, BevelGear] | None = None
) -> BodyInertia:
    """Inertia of a body: given values, the others from its solid or else from its gears.

    The centre of mass is that of the gears, or the origin if they have no mass. A given mass changes neither
    the centre of mass nor the inertia about it. The transverse inertia of the gears is summed about the
    effective centre of mass; a given transverse inertia refers to the origin.

    Parameters
    ----------
    body
        The body.
    gears, bevel_gears
        All gears of the model by name.
    """
    if body.solid is not None:
        return _of_solid(body, body.solid)
    found: list[Added] = []
    if asks_gears(body):
        found += gears_of_body(body, gears, bevel_gears).values()
    if body.shaft is not None:
        found += body.shaft.pieces()
    mass = sum(m for m, _, _, _ in found)
    x, y, center = body.center or (0.0, 0.0, None)
    if center is None:
        center = sum(m * at for m, _, _, at in found) / mass if mass > 0.0 else 0.0
    if not math.isfinite(center):
        center = 0.0
    central = sum(j_t + m * (at - center) * (at - center) for m, _, j_t, at in found)
    mass = mass if body.mass is None else body.mass
    if body.transverse_inertia is not None:
        central = body.transverse_inertia - mass * center * center
    polar = sum(j_p for _, j_p, _, _ in found) if body.inertia is None else body.inertia
    if body.is_round:
        return BodyInertia(mass, polar, central, center)
    tensor = body.inertia_tensor
    if tensor is None:
        tensor = _of_gears(found, (x, y, center))
    i_xx, i_yy, i_zz = tensor[:3]
    off_axis = mass * (x * x + y * y)
    return BodyInertia(mass, i_zz + off_axis, 0.5 * (i_xx + i_yy), center, (x, y), tensor)


def _of_solid(body: Body, part: SolidReference) -> BodyInertia:
    """Inertia of a body with a solid; given values replace those of the solid."""
    found = solid_mass(part)
    mass = found.mass if body.mass is None else body.mass
    x, y, center = body.center or found.center
    tensor = body.inertia_tensor or found.tensor
    if tensor is None and (x, y) == (0.0, 0.0):
        polar = found.polar if body.inertia is None else body.inertia
        central = found.central
        if body.transverse_inertia is not None:
            central = body.transverse_inertia - mass * center * center
        return BodyInertia(mass, polar, central, center)
    if tensor is None:
        tensor = (found.central, found.central, found.polar, 0.0, 0.0, 0.0)
    about_z = tensor[2] + mass * (x * x + y * y)
    return BodyInertia(mass, about_z, 0.5 * (tensor[0] + tensor[1]), center, (x, y), tensor)


def _of_gears(
    found: list[tuple[float, float, float, float]], center: tuple[float, float, float]
) -> tuple[float, ...]:
    """Inertia of gears about a point off their axis, in the order of `inertia_tensor`."""
    total = [0.0] * 6
    for m, j_p, j_t, at in found:
        x, y, z = -center[0], -center[1], at - center[2]
        about = (
            j_t + m * (y * y + z * z),
            j_t + m * (z * z + x * x),
            j_p + m * (x * x + y * y),
            -m * x * y,
            -m * y * z,
            -m * z * x,
        )
        total = [a + b for a, b in zip(total, about, strict=True)]
    return tuple(total)


def matrix(tensor: Sequence[float]) -> NDArray[np.float64]:
    """Symmetric matrix (3, 3) of Ixx, Iyy, Izz, Ixy, Iyz, Izx."""
    import numpy as np

    xx, yy, zz, xy, yz, zx = tensor
    return np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
