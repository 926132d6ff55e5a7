# SPDX-License-Identifier: Apache-2.0
"""Check of the lubricant, whose viscosity decreases with the temperature, and oil films of meshes."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.contact.lubricant import GRADES, LIGHTEST, squeeze_rate
from pitchpoint.core.units import format_quantity
from pitchpoint.model.keys import Place
from pitchpoint.model.load_cases import oil_of
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.lubricant import Lubricant

KEY = "lubricant"
TOLERANCE = 0.1
"""Deviation of the viscosity of an oil from that of its grade (ISO 3448)."""
KEYS = ("viscosity_at_40_degree_celsius", "viscosity_at_100_degree_celsius")


def check_lubricant(parts: Parts, report: Reader) -> None:
    """Check the viscosities of the lubricant."""
    oil = parts.lubricant
    at: Place = (KEY,)
    if oil is None or at in report.tainted:
        return
    missing = [key for key in KEYS if getattr(oil, key) is None]
    if oil.grade is None and missing:
        report.problem(
            at,
            f"has no {' and no '.join(missing)}",
            remedy="give both viscosities, or a grade such as ISO VG 320",
        )
        return
    if oil.grade is not None and KEYS[0] not in missing:
        _contradiction(oil, (*at, KEYS[0]), report)
    at_40, at_100 = oil.viscosities
    shown = [format_quantity(nu, "kinematic_viscosity") for nu in (at_40, at_100)]
    if not at_100 < at_40:
        report.problem(
            (*at, KEYS[1]),
            "is not below that at 40 °C",
            value=shown[1],
            limit=f"< {shown[0]}",
            remedy="exchange them",
        )
    elif at_100 <= 2.0 * LIGHTEST:
        report.problem(
            (*at, KEYS[1]), "is too low for the Walther equation", value=shown[1], limit="> 1.4 mm^2/s"
        )


def _contradiction(oil: Lubricant, at: Place, report: Reader) -> None:
    """Report a viscosity at 40 °C that the grade does not have."""
    own, usual = float(oil.viscosity_at_40_degree_celsius or 0.0), GRADES[str(oil.grade)][0]
    if abs(own - usual) <= (TOLERANCE + 1e-9) * usual:
        return
    low, high = (format_quantity(usual * (1.0 + sign * TOLERANCE), "kinematic_viscosity") for sign in (-1, 1))
    report.problem(
        at,
        f"contradicts the grade {oil.grade}",
        value=format_quantity(own, "kinematic_viscosity"),
        limit=f"{low} to {high}",
        remedy="correct one of them, or remove grade",
    )


def settle_oil_films(parts: Parts, report: Reader) -> None:
    """Compute the damping of oil films without a given rate from the viscosity of the lubricant."""
    oil = oil_of(parts)
    for name, mesh in parts.meshes.items():
        contact: Any = mesh.contact
        film = getattr(contact, "oil", None)
        at: Place = ("meshes", name, "contact", "oil")
        if film is None or film.rate is not None or at in report.tainted or (KEY,) in report.tainted:
            continue
        if oil is None:
            report.problem(
                (*at, "rate"),
                "is missing, and the model has no lubricant",
                remedy="give rate, or lubricant: {grade: ISO VG 220, temperature: 60 degC}",
            )
        elif name in parts.pairs:
            viscosity = oil.dynamic_viscosity
            pair = parts.pairs[name]
            length = pair.b_w / contact.planes / math.cos(pair.gear1.beta_b)
            rate = squeeze_rate(viscosity, pitch_radius(pair), film.thickness, length)
            settled = replace(contact, oil=replace(film, rate=rate))
            parts.meshes[name] = replace(mesh, contact=settled, given=mesh)


def pitch_radius(pair: GearPair) -> float:
    """Reduced radius of curvature of the flanks at the pitch point, normal to the line of contact [m].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.gear_pair import GearPair
    >>> one = CylindricalGear(z=20, m_n=0.002, alpha_n=0.349, beta=0.0, x=0.0, b=0.02)
    >>> round(1e3 * pitch_radius(GearPair.from_profile_shifts(one, one)), 3)
    3.42
    """
    far = pair.T1T2 - pair.T1C
    return abs(pair.T1C * far / pair.T1T2) / math.cos(pair.gear1.beta_b)
