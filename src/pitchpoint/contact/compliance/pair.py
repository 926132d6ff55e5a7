# SPDX-License-Identifier: Apache-2.0
"""Single stiffness c' of one tooth pair in plane strain, from the slices of both gears.

Derivation: docs/theory/flank_compliance.md, "One pair in plane strain".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.compliance.gear import GearSlice
from pitchpoint.contact.compliance.local import LineContact, line_contact
from pitchpoint.contact.hertz import flank_radius
from pitchpoint.contact.tooth_fe import local_part
from pitchpoint.contact.tooth_fe.contour import Contour
from pitchpoint.geometry.gear_pair import GearPair

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PairSlice:
    """Compliances of one tooth pair per unit face width along the base tangent [m²/N].

    Parameters
    ----------
    teeth
        Teeth on their bodies, gear 1 and gear 2, shape of the positions each.
    contact
        Secant compliance of the local approach, shape of the positions.
    common
        Common part of both gears, torsion of the blanks included; 0 if it does not count.
    """

    teeth: tuple[Array, Array]
    contact: Array
    common: float

    @property
    def stiffness(self) -> Array:
        """Single stiffness c' [N/m²], shape of the positions."""
        return np.asarray(1.0 / (self.teeth[0] + self.teeth[1] + self.contact + self.common))


def contact_depth(part: GearSlice, rho: ArrayLike, beta_b: float) -> Array:
    """Distance from the contact to the centre line of the tooth along the normal of the flank [m].

    Parameters
    ----------
    part
        Slice of the gear.
    rho
        Lengths of roll [m].
    beta_b
        Base helix angle [rad].

    Returns
    -------
    ndarray, shape of rho

    Notes
    -----
    In the transverse section r sin ψ/cos α along the line of action, with the half tooth angle ψ and the load
    angle α; the normal of the flank is inclined to it by β_b. Derivation: docs/theory/flank_compliance.md,
    "Local approach".

    Examples
    --------
    >>> from pitchpoint.contact.compliance.gear import gear_slice
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=43, m_n=1e-3)
    >>> round(1e3 * float(contact_depth(gear_slice(gear), 7.3534e-3, 0.0)), 4)
    0.8252
    """
    contour, roll = Contour(part.tooth.form), np.asarray(rho, dtype=np.float64)
    return local_part.contact_depth(contour, roll) * math.cos(beta_b)


def pair_slice(
    pair: GearPair, T1Y: ArrayLike, line_load: float, parts: tuple[GearSlice, GearSlice], common: bool = False
) -> PairSlice:
    """Compliances of one tooth pair under a uniform line load, alone in the mesh.

    Parameters
    ----------
    pair
        The gear pair.
    T1Y
        Positions on the path of contact, from the tangent point T1 on the base circle of gear 1 [m], any
        shape.
    line_load
        Force along the base tangent per unit face width, > 0 [N/m].
    parts
        Slices of gear 1 and gear 2.
    common
        Whether the common displacement of all teeth, such as torsion of the blanks, counts.

    Notes
    -----
    Load per length of the contact line = load along the base tangent per face width; the normal approach
    counts with 1/cos β_b along the base tangent. Derivation: docs/theory/flank_compliance.md, "One pair in
    plane strain".

    Examples
    --------
    Gears 17/43 of module 1 mm at the pitch point, 300 N/mm, in N/(mm µm):

    >>> from pitchpoint.contact.compliance.gear import gear_slice
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> pair = GearPair(CylindricalGear(z=17, m_n=1e-3), CylindricalGear(z=43, m_n=1e-3), 30e-3)
    >>> parts = gear_slice(pair.gear1), gear_slice(pair.gear2)
    >>> round(float(pair_slice(pair, pair.T1C, 300e3, parts).stiffness) / 1e9, 2)
    17.54
    """
    rho_1 = np.asarray(T1Y, dtype=np.float64)
    rhos = rho_1, np.abs(pair.T1T2 - rho_1)
    beta_b = pair.gear1.beta_b
    bodies = LineContact(
        (parts[0].material.youngs_modulus, parts[1].material.youngs_modulus),
        (parts[0].material.poisson_ratio, parts[1].material.poisson_ratio),
    )
    depths = tuple(contact_depth(part, rho, beta_b) for part, rho in zip(parts, rhos, strict=True))
    radius = flank_radius(rho_1, pair.T1T2, beta_b)
    approach = line_contact(line_load, radius, (depths[0], depths[1]), bodies)
    teeth = tuple(part.own(rho, rho) for part, rho in zip(parts, rhos, strict=True))
    return PairSlice(
        (teeth[0], teeth[1]),
        approach / (line_load * math.cos(beta_b)),
        parts[0].common + parts[1].common if common else 0.0,
    )
