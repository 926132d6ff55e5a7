# SPDX-License-Identifier: Apache-2.0
"""Check of the lubricant: its viscosity is known, and decreases with the temperature."""

from __future__ import annotations

from pitchpoint.contact.lubricant import LIGHTEST
from pitchpoint.core.units import format_quantity
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader

KEY = "lubricant"
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
