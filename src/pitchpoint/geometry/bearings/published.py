# SPDX-License-Identifier: Apache-2.0
"""Published rolling elements of bearings; of all others of the catalogue they are estimated."""

from __future__ import annotations

import csv
import math
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from pitchpoint.geometry.bearings.designation import by_designation
from pitchpoint.geometry.bearings.inner import inner_geometry


@dataclass(frozen=True)
class RollingElements:
    """Rolling elements of a bearing.

    Attributes
    ----------
    designation
        Designation in the table.
    elements
        Number of rolling elements of one row [-].
    element_diameter, pitch_diameter
        Diameter of a rolling element and pitch diameter [m].
    contact_angle
        Contact angle [rad].
    source
        Source of the data; empty if they are estimated from the load ratings.
    """

    designation: str
    elements: int
    element_diameter: float
    pitch_diameter: float
    contact_angle: float
    source: str = ""


def rolling_elements(designation: str) -> RollingElements:
    """Published rolling elements of a bearing, else those estimated from the catalogue.

    Parameters
    ----------
    designation
        Such as "6205-2RS JEM", "ER-16K" or "NU 208 ECP".

    Raises
    ------
    GeometryError
        If the bearing is in neither table.

    Examples
    --------
    >>> found = rolling_elements("6205-2RS JEM")
    >>> found.elements, round(1e3 * found.pitch_diameter, 2), found.source[:13]
    (9, 39.04, 'Case Western ')
    >>> found = rolling_elements("6205")
    >>> found.elements, round(1e3 * found.pitch_diameter, 2), found.source
    (9, 38.5, '')
    """
    found = _published().get(_plain(designation))
    if found is not None:
        return found
    row = by_designation(designation)
    inner = inner_geometry(
        row.kind, row.bore, row.outside, row.width, row.dynamic, row.static, abs(row.angle)
    )
    return RollingElements(
        row.designation, inner.elements, inner.element_diameter, inner.pitch_diameter, abs(row.angle)
    )


@cache
def _published() -> dict[str, RollingElements]:
    """Bearings of the table by plain designation."""
    text = Path(__file__).with_name("published.csv").read_text(encoding="utf-8")
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    return {
        _plain(row["designation"]): RollingElements(
            row["designation"],
            int(row["elements"]),
            1e-3 * float(row["element_diameter"]),
            1e-3 * float(row["pitch_diameter"]),
            math.radians(float(row["contact_angle"])),
            row["source"],
        )
        for row in rows
    }


def _plain(designation: str) -> str:
    """Letters and digits of a designation, without the maker."""
    plain = re.sub(r"[^A-Z0-9]", "", designation.upper())
    return re.sub(r"^(?:SKF|MB|LDK|REXNORD)", "", plain)
