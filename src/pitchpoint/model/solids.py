# SPDX-License-Identifier: Apache-2.0
"""Mass and inertia of gears, shafts and bodies from CAD solids."""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.model.frames import frame

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.marker import Triple
    from pitchpoint.model.components.solid import SolidReference

ROUND = 1e-6
"""Relative tolerance of axisymmetry about the z axis: STL files have seven digits."""


@dataclasses.dataclass(frozen=True)
class SolidMass:
    """Mass properties of a solid in the axes of its body."""

    mass: float
    """[kg]."""
    center: Triple
    """Centre of mass relative to the origin of the body [m]; x and y are exactly zero if axisymmetric."""
    polar: float
    """Moment of inertia about an axis along z through the centre of mass [kg m^2]."""
    central: float
    """Mean moment of inertia about diameters through the centre of mass [kg m^2]."""
    tensor: tuple[float, ...] | None
    """Ixx, Iyy, Izz, Ixy, Iyz, Izx about the centre of mass [kg m^2]; None if axisymmetric about z."""


@functools.lru_cache(maxsize=64)
def _placed(part: SolidReference, density: float, volume: float, center: Any, moments: Any) -> SolidMass:
    """Mass properties from the integrals of a solid, rotated into the axes of the body."""
    xx, yy, zz, xy, yz, zx = moments
    turn = frame(part.axes)
    about = density * turn.T @ np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]) @ turn
    at = turn.T @ (np.array(center) - np.array(part.origin or (0.0, 0.0, 0.0)))
    mass = density * volume
    polar, central = float(about[2, 2]), 0.5 * float(about[0, 0] + about[1, 1])
    off_axis = max(abs(about[0, 0] - about[1, 1]), *(abs(about[i, k]) for i, k in ((0, 1), (1, 2), (2, 0))))
    size = math.sqrt((polar + 2.0 * central) / mass)
    if off_axis <= ROUND * max(polar, central) and math.hypot(at[0], at[1]) <= ROUND * size:
        return SolidMass(mass, (0.0, 0.0, float(at[2])), polar, central, None)
    entries = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))
    tensor = tuple(float(about[i, k]) for i, k in entries)
    return SolidMass(mass, (float(at[0]), float(at[1]), float(at[2])), polar, central, tensor)


def solid_mass(part: SolidReference) -> SolidMass:
    """Mass properties of the solid of a body.

    Parameters
    ----------
    part
        The solid.

    Raises
    ------
    GeometryError
        If the file does not contain a solid with a mass.
    """
    solid = part.solid()
    return _placed(part, part.density_for(), solid.volume, solid.center, solid.moments)


def solid_of_gear(gear: Gear) -> tuple[float, float, float]:
    """Mass [kg], polar and transverse moment of inertia about the centre [kg m^2] of the solid of a gear."""
    part = gear.solid
    if part is None:
        raise ValueError("the gear has no solid")
    density = part.density_for(gear.material)
    found = part.about_axis()
    return density * part.solid().volume, density * found.polar, density * found.transverse


# --- checks -------------------------------------------------------------------------------------------------
