# SPDX-License-Identifier: Apache-2.0
"""Flank modifications: tip and root relief, crowning, slopes, end relief.

Amounts are normal to the flank, as on drawings; `base_tangent` converts them to the transverse base tangent
direction, in which the contact laws are formulated. Positive results are removed material.
Along the profile the coordinate is the roll length L = √(r² − r_b²); along the face width it is z, from
−b/2 to b/2.

Source: ISO 21771.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.core.plain_numbers import real_number

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel.gear import BevelGear
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]

SHAPES = {"linear": 1, "parabolic": 2}

# Relative tolerance of lengths that end exactly at the end of the flank, for rounded input.
_FIT = 1e-6


def _length(where: str, value: float, limit: str, low: float = -math.inf, strict: bool = False) -> None:
    good = (number := real_number(value)) is not None and math.isfinite(number)
    if not good or value < low or (strict and value == low):
        raise GeometryError("is not possible", where=where, value=f"{value!r}", limit=limit)


def _shape(shape: str) -> None:
    if shape not in SHAPES:
        raise GeometryError("is unknown", where="shape", value=f"{shape!r}", limit=" or ".join(SHAPES))


@dataclass(frozen=True, kw_only=True)
class Relief:
    """Tip or root relief: zero at its start, `amount` at the end of the usable flank.

    Parameters
    ----------
    amount
        Material removed at the tip or root form circle, normal to the flank [m], ≥ 0.
    start_diameter
        Diameter at the start of the relief [m], positive.
    length
        Roll length of the relief [m]; exactly one of `start_diameter` and `length` is given.
    shape
        "linear" or "parabolic" over the roll length.
    """

    amount: float
    start_diameter: float | None = None
    length: float | None = None
    shape: str = "linear"

    def __post_init__(self) -> None:
        _length("amount", self.amount, "finite, >= 0", 0.0)
        _shape(self.shape)
        if (self.start_diameter is None) == (self.length is None):
            raise GeometryError(
                "must have one start", where="relief", remedy="give either start_diameter or length"
            )
        for where in ("start_diameter", "length"):
            value = getattr(self, where)
            if value is not None:
                _length(where, value, "finite, > 0", 0.0, strict=True)


@dataclass(frozen=True, kw_only=True)
class EndRelief:
    """Relief of both ends of the teeth.

    Parameters
    ----------
    amount
        Material removed at the end faces, normal to the flank [m], ≥ 0.
    length
        Axial length from each face [m], > 0.
    shape
        "linear" or "parabolic".
    """

    amount: float
    length: float
    shape: str = "linear"

    def __post_init__(self) -> None:
        _length("amount", self.amount, "finite, >= 0", 0.0)
        _length("length", self.length, "finite, > 0", 0.0, strict=True)
        _shape(self.shape)


@dataclass(frozen=True, kw_only=True)
class FlankModifications:
    """Modifications of the left or the right flanks; omitted ones are zero.

    Parameters
    ----------
    tip_relief, root_relief
        Reliefs of the profile.
    profile_crowning
        Profile crowning (barrelling) C_α [m]: C_α at both form circles, zero at mid-roll.
    lead_crowning
        Lead crowning C_β [m]: C_β at both end faces, zero at mid-face.
    profile_slope
        Profile slope deviation over the usable roll length [m]; positive adds material towards the tip (sign
        of f_Hα in ISO 1328-1). Zero at mid-roll, so that pitch and backlash are unchanged.
    helix_slope
        Helix slope deviation over the face width [m]; positive adds material towards z = +b/2. Zero at
        mid-face.
    end_relief
        Relief of both ends.
    """

    tip_relief: Relief | None = None
    root_relief: Relief | None = None
    profile_crowning: float = 0.0
    lead_crowning: float = 0.0
    profile_slope: float = 0.0
    helix_slope: float = 0.0
    end_relief: EndRelief | None = None

    def __post_init__(self) -> None:
        for where in ("profile_crowning", "lead_crowning", "profile_slope", "helix_slope"):
            _length(where, getattr(self, where), "finite")


def roll_length(gear: CylindricalGear, d: ArrayLike) -> FloatArray:
    """Roll length L = √(d² − d_b²)/2 of flank points, 0 inside the base circle [m].

    Parameters
    ----------
    gear
        External or internal gear.
    d
        Diameters [m], any shape, either sign.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> float(roll_length(CylindricalGear(z=50, m_n=3e-3), 0.150).round(9))
    0.025651511
    """
    return 0.5 * np.sqrt(np.maximum(np.asarray(d, dtype=float) ** 2 - gear.d_b**2, 0.0))


def flank_range(gear: CylindricalGear) -> tuple[float, float]:
    """Roll lengths at the root form circle and at the tip form circle [m]; the first is larger for rings.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> [round(length, 9) for length in flank_range(CylindricalGear(z=50, m_n=3e-3))]
    [0.016880381, 0.03342155]
    """
    return float(roll_length(gear, gear.d_Ff)), float(roll_length(gear, gear.d_Fa))


def base_tangent(normal: ArrayLike, gear: CylindricalGear) -> FloatArray:
    """Convert a length normal to the flank to the transverse base tangent, u_n / cos β_b.

    Parameters
    ----------
    normal
        Normal lengths [m], any shape.
    gear
        The gear.

    Notes
    -----
    u_n = u_bt cos β_b: the flank normal is inclined to the transverse plane by β_b.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> helical = CylindricalGear(z=17, m_n=8e-3, beta=math.radians(15.8))
    >>> float(base_tangent(1.0, helical).round(6))
    1.034432
    """
    return np.asarray(normal, dtype=float) / math.cos(gear.beta_b)


def modification_problems(
    modifications: FlankModifications, gear: CylindricalGear, where: str = ""
) -> list[Message]:
    """Problems of modifications that do not fit the flanks of a gear.

    Parameters
    ----------
    modifications
        Modifications of the left or the right flanks.
    gear
        External or internal gear.
    where
        Path of the modifications in the model, prefix of the key in each message.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> long = FlankModifications(tip_relief=Relief(amount=2e-5, length=0.04))
    >>> print(modification_problems(long, gear, "both")[0])
    both.tip_relief.length: 40 mm is longer than the flank (limit 16.5412 mm of roll); shorten it
    """
    place = f"{where}." if where else ""
    root, tip = flank_range(gear)
    flank = abs(tip - root)
    found = size_problems(
        {
            **{
                f"{place}{key}.amount": part.amount
                for key in ("tip_relief", "root_relief", "end_relief")
                if (part := getattr(modifications, key)) is not None
            },
            **{
                f"{place}{key}": getattr(modifications, key)
                for key in ("profile_crowning", "lead_crowning", "profile_slope", "helix_slope")
            },
        },
        gear,
    )
    for key, relief in (("tip_relief", modifications.tip_relief), ("root_relief", modifications.root_relief)):
        if relief is None:
            continue
        if relief.length is not None and relief.length > flank * (1.0 + _FIT):
            found.append(
                Message(
                    f"{place}{key}.length",
                    "is longer than the flank",
                    f"{1e3 * relief.length:.6g} mm",
                    f"{1e3 * flank:.6g} mm of roll",
                    "shorten it",
                )
            )
        d = relief.start_diameter
        low, high = sorted((abs(gear.d_Ff), abs(gear.d_Fa)))
        own_end = abs(gear.d_Fa if key == "tip_relief" else gear.d_Ff)
        if d is not None and (not low * (1.0 - _FIT) <= d <= high * (1.0 + _FIT) or d == own_end):
            found.append(
                Message(
                    f"{place}{key}.start_diameter",
                    "does not lie on the usable flank",
                    f"{1e3 * d:.6g} mm",
                    f"{1e3 * low:.6g} to {1e3 * high:.6g} mm",
                    "give a diameter between root form and tip form circle, or a length",
                )
            )
    ends = modifications.end_relief
    if ends is not None and ends.length > 0.5 * gear.b * (1.0 + _FIT):
        found.append(
            Message(
                f"{place}end_relief.length",
                "reaches over the middle of the teeth",
                f"{1e3 * ends.length:.6g} mm",
                f"half the face width, {500.0 * gear.b:.6g} mm",
                "shorten it, or use lead_crowning",
            )
        )
    return found


def size_problems(amounts: Mapping[str, float], gear: CylindricalGear | BevelGear) -> list[Message]:
    """Problems of flank deviations larger than the module, usually due to a missing unit.

    Parameters
    ----------
    amounts
        Amounts by their paths in the model [m].
    gear
        The gear.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> print(size_problems({"runout.amount": 20.0}, CylindricalGear(z=50, m_n=3e-3))[0])
    runout.amount: 20000 mm is larger than the module (limit 3 mm); give it with a unit, such as 20 um
    """
    return [
        Message(
            place,
            "is larger than the module",
            f"{1e3 * amount:.6g} mm",
            f"{1e3 * gear.m_n:.6g} mm",
            "give it with a unit, such as 20 um",
        )
        for place, amount in amounts.items()
        if abs(amount) > gear.m_n
    ]


def _relief(
    relief: Relief | None, gear: CylindricalGear, length: FloatArray, end: float, out: int
) -> FloatArray:
    """Removed material of a relief [m]; `out` is +1 if the roll length increases towards its end."""
    if relief is None:
        return np.zeros_like(length)
    if relief.length is not None:
        extent = relief.length
    else:
        assert relief.start_diameter is not None
        extent = out * (end - float(roll_length(gear, relief.start_diameter)))
    share = np.maximum(0.0, 1.0 - out * (end - length) / extent)
    return relief.amount * share ** SHAPES[relief.shape]


def deviation(
    modifications: FlankModifications,
    gear: CylindricalGear,
    roll: ArrayLike,
    z: ArrayLike = 0.0,
    *,
    coordinate: str = "roll_length",
) -> FloatArray:
    """Material removed from a flank by its modifications, normal to the flank.

    Parameters
    ----------
    modifications
        Modifications of this flank.
    gear
        External or internal gear.
    roll
        Position along the profile: roll lengths [m], or diameters [m] with `coordinate="diameter"`.
    z
        Position along the face width [m], −b/2 to b/2.
    coordinate
        "roll_length" or "diameter".

    Returns
    -------
    ndarray
        Removed material [m], positive = removed; shape of roll and z broadcast against each other.

    Raises
    ------
    GeometryError
        If a relief does not fit the flank (see `modification_problems`), or `coordinate` is unknown.

    Notes
    -----
    With t from 0 at the root form circle to 1 at the tip form circle and ζ = 2 z/b: crownings
    C_α (2t − 1)² and C_β ζ², slopes −C_Hα (t − ½) and −C_Hβ ζ/2, reliefs linear or quadratic from their
    start (definitions of ISO 21771). The formulas also hold outside the usable flank.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> relieved = FlankModifications(tip_relief=Relief(amount=20e-6, length=4e-3), lead_crowning=5e-6)
    >>> (1e6 * deviation(relieved, gear, [gear.d, gear.d_a], [0.0, 0.01], coordinate="diameter")).round(9)
    array([ 0., 25.])
    """
    if coordinate == "diameter":
        length = roll_length(gear, roll)
    elif coordinate == "roll_length":
        length = np.asarray(roll, dtype=float)
    else:
        raise GeometryError(
            "is unknown", where="coordinate", value=f"{coordinate!r}", limit="roll_length or diameter"
        )
    m = modifications
    for problem in modification_problems(m, gear):
        raise GeometryError(
            problem.text,
            where=problem.where,
            value=problem.value,
            limit=problem.limit,
            remedy=problem.remedy,
        )
    root, tip = flank_range(gear)
    t = (length - root) / (tip - root)
    zeta = np.asarray(z, dtype=float) / (0.5 * gear.b)
    profile = m.profile_crowning * (2.0 * t - 1.0) ** 2 - m.profile_slope * (t - 0.5)
    profile = profile + _relief(m.tip_relief, gear, length, tip, gear.sign)
    profile = profile + _relief(m.root_relief, gear, length, root, -gear.sign)
    lead = m.lead_crowning * zeta**2 - 0.5 * m.helix_slope * zeta
    if m.end_relief is not None:
        share = np.maximum(0.0, 1.0 - (1.0 - np.abs(zeta)) * 0.5 * gear.b / m.end_relief.length)
        lead = lead + m.end_relief.amount * share ** SHAPES[m.end_relief.shape]
    return np.asarray(profile + lead)
