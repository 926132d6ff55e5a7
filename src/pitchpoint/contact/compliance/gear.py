# SPDX-License-Identifier: Apache-2.0
"""Analytic compliance of the teeth and body of one gear for the contact of flanks.

Derivation: docs/theory/flank_compliance.md, "What the contact needs".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.compliance.blank import Blank, BlankRadii, blank_radii
from pitchpoint.contact.compliance.clamped_tooth import ClampedTooth, clamped_tooth
from pitchpoint.contact.compliance.description import FlankCompliance
from pitchpoint.contact.compliance.foundation import Foundation, foundation
from pitchpoint.contact.compliance.heights import congruence, fitted
from pitchpoint.contact.compliance.plate import PlateTooth
from pitchpoint.contact.compliance.width import plate_coupled, springs, wave_numbers
from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.materials import LIBRARY, Material

Array = NDArray[np.float64]

COUPLINGS = ("plate", "springs", "none")
STEEL = LIBRARY["steel"]

_HEIGHTS = leggauss(24)
_LEAST_WAVES, _MOST_WAVES = 8, 40
_PER_PLANE = 1.5
"""Legendre polynomials along the trace per plane."""


@dataclass(frozen=True)
class GearSlice:
    """Slice of unit face width of a gear in plane strain: tooth, gear body, blank.

    Parameters
    ----------
    tooth
        The clamped tooth.
    radii
        Radii of the blank.
    material
        Material.
    body
        Model of the gear body, see `pitchpoint.contact.compliance.foundation.foundation`.
    """

    tooth: ClampedTooth
    radii: BlankRadii
    material: Material
    body: str

    @cached_property
    def ground(self) -> Foundation:
        """Gear body under a uniform load."""
        return foundation(self.tooth, self.radii, self.material, self.body, np.zeros(1))

    @property
    def common(self) -> float:
        """Displacement along the base tangent that all teeth share, torsion included [m²/N]."""
        return self.ground.common + self.ground.torsion

    def own(self, rho: ArrayLike, rho_load: ArrayLike) -> Array:
        """Displacement of a tooth on its body, without the common part.

        Parameters
        ----------
        rho, rho_load
            Lengths of roll of observed points and forces [m], broadcast against each other.

        Returns
        -------
        ndarray, shape of the arguments broadcast
            Compliance along the base tangent per unit face width [m²/N].
        """
        E, nu = self.material.youngs_modulus, self.material.poisson_ratio
        w, w_load = self.tooth.root_loads(rho), self.tooth.root_loads(rho_load)
        body = self.tooth.cos_beta * np.einsum("...i,ij,...j->...", w, self.ground.own[0], w_load)
        return np.asarray(self.tooth.influence(rho, rho_load, E, nu) + body)

    def next(self, rho: ArrayLike, rho_load: ArrayLike) -> Array:
        """Displacement of a tooth per force on the next one counter-clockwise, without the common part.

        Parameters
        ----------
        rho, rho_load
            Lengths of roll of observed points and forces [m], broadcast against each other.

        Returns
        -------
        ndarray, shape of the arguments broadcast
            Compliance along the base tangent per unit face width [m²/N].
        """
        w, w_load = self.tooth.root_loads(rho), self.tooth.root_loads(rho_load)
        found = np.einsum("...i,ij,...j->...", w, self.ground.next[0], w_load)
        return np.asarray(self.tooth.cos_beta * found)


def gear_slice(
    gear: CylindricalGear,
    *,
    material: Material = STEEL,
    blank: Blank | None = None,
    body: str = "weber_banaschek",
    clamp: float | None = None,
) -> GearSlice:
    """Slice of a gear in plane strain.

    Parameters
    ----------
    gear
        External or internal gear.
    material
        Its material.
    blank
        Its blank; None: solid.
    body
        "weber_banaschek", "half_plane", "ring", "sainsot" or "rigid".
    clamp
        Inclination of the fillet tangent at the clamp [rad]; None: 30°, internal gears 60°.

    Raises
    ------
    GeometryError
        If the blank or the clamp is not possible, or the body is outside its range.
    ModelError
        If the body is not known.

    Examples
    --------
    Tooth and body of Weber and Banaschek at the reference circle, µm mm/N:

    >>> gear = CylindricalGear(z=43, m_n=1e-3)
    >>> rho = 21.5e-3 * math.sin(math.radians(20.0))
    >>> round(float(gear_slice(gear).own(rho, rho)) * 1e12, 2)
    18.28
    """
    return GearSlice(clamped_tooth(gear, clamp), blank_radii(gear, blank or Blank()), material, body)


def flank_compliance(
    gear: CylindricalGear,
    *,
    planes: int,
    width: tuple[float, float] | None = None,
    material: Material = STEEL,
    blank: Blank | None = None,
    body: str = "weber_banaschek",
    clamp: float | None = None,
    coupling: str = "plate",
    order: int = 4,
    C_M: float = 1.0,
) -> FlankCompliance:
    """Analytic compliance of the teeth and the body of one gear.

    Parameters
    ----------
    gear
        External or internal gear.
    planes
        Number of planes n.
    width
        Ends of the common face width from the middle of the face [m], within ±b/2; None: the whole face.
    material, blank, body, clamp
        As for `gear_slice`.
    coupling
        Coupling along the face width: "plate", "springs" (for comparison) or "none".
    order
        Number of Legendre polynomials over the height M.
    C_M
        Correction factor of the stiffness, see `FlankCompliance.scaled`.

    Returns
    -------
    FlankCompliance
        Left flanks; for t from the form circle to the tip end of the involute.

    Raises
    ------
    ModelError
        If an option is not known or out of range.
    GeometryError
        As for `gear_slice`.

    Notes
    -----
    The compliance of a slice is that of `GearSlice`: clamped tooth in plane strain (C. Weber and K.
    Banaschek, 1953/55) on its gear body. A uniform load over the whole face gives it, up to the fit of
    `pitchpoint.contact.compliance.heights.fitted`. Derivation: docs/theory/flank_compliance.md, "What the
    contact needs".

    Examples
    --------
    >>> gear = CylindricalGear(z=43, m_n=1e-3, b=10e-3)
    >>> found = flank_compliance(gear, planes=10)
    >>> rho = np.full(10, 21.5e-3 * math.sin(math.radians(20.0)))
    >>> C = found.matrix(rho) - found.windup
    >>> round(float(C.sum(axis=1).mean()) * 1e-3 * 1e12, 1)          # 18.28 in plane strain
    18.2
    """
    half = 0.5 * gear.b
    low, high = (-half, half) if width is None else width
    _check(planes, order, coupling, (low, high), half)
    part = gear_slice(gear, material=material, blank=blank, body=body, clamp=clamp)
    tooth = part.tooth
    t, weights = _HEIGHTS
    rho = 0.5 * (tooth.roll[0] + tooth.roll[1]) + 0.5 * (tooth.roll[1] - tooth.roll[0]) * t
    target = fitted(t, weights, part.own(rho[:, None], rho[None]), order)
    plate = PlateTooth(tooth, material, order)
    before, following = plate.uniform(part.ground)
    turn = congruence(before, target)
    if coupling == "plate":
        waves = math.ceil(_PER_PLANE * planes * gear.b / (high - low))
        waves = min(_MOST_WAVES, max(_LEAST_WAVES, waves))
        length = gear.b / tooth.cos_beta
        ground = foundation(tooth, part.radii, material, body, wave_numbers(waves, length))
        edges = np.linspace(low, high, planes + 1) / half
        blocks = plate_coupled(plate, ground, edges, length, waves)
    else:
        ground = part.ground
        spread = (np.eye(planes) if coupling == "none" else springs(planes)) * planes / (high - low)
        blocks = (spread[:, :, None, None] * before, spread[:, :, None, None] * following)
    own, next_ = (np.einsum("km,ijmn,ln->ijkl", turn, block, turn) for block in blocks)
    provenance: dict[str, str | float] = {
        "level": "analytic",
        "flank": "left",
        "material": material.name,
        "body": body,
        "clamp": tooth.clamp,
        "coupling": coupling,
        "depth": part.radii.depth,
        "web_share": part.radii.web_share,
        "torsion": ground.torsion / gear.b,
        "common": ground.common / gear.b,
        "normal_coupling_factor": ground.coupling[0],
        "coupling_factor": ground.coupling[1],
        "C_M": 1.0,
    }
    found = FlankCompliance(
        tooth.roll, 0.5 * (own + own.transpose(1, 0, 3, 2)), next_, part.common / gear.b, provenance
    )
    return found if C_M == 1.0 else found.scaled(C_M)


def _check(planes: int, order: int, coupling: str, width: tuple[float, float], half: float) -> None:
    """Raise for options out of range, all of them together."""
    problems = []
    for name, value, most in (("planes", planes, 1000), ("order", order, 12)):
        if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= most:
            problems.append(Message(f"compliance.{name}", "is not possible", repr(value), f"1 to {most}"))
    if coupling not in COUPLINGS:
        limit = ", ".join(COUPLINGS)
        problems.append(Message("compliance.coupling", "is not a coupling", coupling, limit, "choose"))
    low, high = width
    slack = 1e-9 * half
    if not (math.isfinite(low) and math.isfinite(high) and -half - slack <= low < high <= half + slack):
        shown = f"{1e3 * low:.6g} to {1e3 * high:.6g} mm"
        limit = f"within ±{1e3 * half:.6g} mm"
        problems.append(Message("compliance.width", "is not a part of the face width", shown, limit))
    if problems:
        raise ModelError(problems)
