# SPDX-License-Identifier: Apache-2.0
"""Data of rolling bearings as simulated: of the catalogue, estimated, or given."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import ranges
from pitchpoint.geometry.bearings.designation import by_designation
from pitchpoint.model.components.bearing_geometry import ELEMENTS

if TYPE_CHECKING:
    from pitchpoint.model.components.bearing_geometry import BearingGeometry
    from pitchpoint.model.model import Model

HEAD = ("name", "d x D x B [mm]", "elements", "pitch circle", "angle", "clearance", "axial force")
"""Columns of `bearing_lines`."""


def bearing_data(model: Model) -> dict[str, dict[str, Any]]:
    """Geometry of all rolling bearings [SI units], with the keys whose values are estimated."""
    found = {}
    for name, part in model.rolling_bearings.items():
        geometry = part.geometry
        keys = (*ELEMENTS, "effective_length") if geometry.rated is not None else ()
        guessed = [
            key for key in keys if getattr(part, key) is None and getattr(geometry, key, None) is not None
        ]
        found[name] = {**asdict(geometry), "estimated": guessed}
    return found


def bearing_lines(model: Model) -> tuple[list[list[str]], list[str]]:
    """Rows of a table, and notes on the estimates."""
    rows: list[list[str]] = []
    notes: dict[str, list[str]] = {}  # names by text
    for name, part in model.rolling_bearings.items():
        found = part.geometry
        sizes = (found.bore, found.outside, found.width)
        rows.append(
            [
                f"{name}: {part.designation or found.kind.replace('_', ' ')}",
                " x ".join(f"{1e3 * size:.6g}" if size is not None else "-" for size in sizes),
                _elements(found),
                format_quantity(found.pitch_diameter, "length", 4),
                format_quantity(found.contact_angle, "angle", 4),
                format_quantity(found.clearance, "length", 3)
                + (f" ({found.clearance_class}, middle)" if found.clearance_class else ""),
                found.absorbs.replace("_", " "),
            ]
        )
        if found.axial_clearance is not None:
            given = part.flange_stiffness
            words = "estimated" if given is None else format_quantity(given, "stiffness", 3)
            notes.setdefault(
                f"flanges with an axial clearance of "
                f"{format_quantity(found.axial_clearance, 'length', 3)}, stiffness {words}",
                [],
            ).append(name)
        if part.contact_angle is None and part.designation and by_designation(part.designation).by_maker:
            notes.setdefault(
                f"contact angle of {format_quantity(found.contact_angle, 'angle', 4)}, that of NSK; "
                "it differs between makers: give contact_angle, or the suffix A (SKF), B or BD (FAG)",
                [],
            ).append(name)
        if found.rated is not None and found.dynamic is not None and found.static is not None:
            notes.setdefault(
                f"elements estimated from C0 = {found.static * 1e-3:.4g} kN (reproduced) and "
                f"C = {found.dynamic * 1e-3:.4g} kN (ISO 281 with these elements: "
                f"{found.rated * 1e-3:.4g} kN)",
                [],
            ).append(name)
    return rows, [f"{ranges(names)}: {text}" for text, names in notes.items()]


def _elements(found: BearingGeometry) -> str:
    """Number and size of the rolling elements, such as "2 x 15 rollers 23.7 x 25 mm"."""
    size = f"{1e3 * found.element_diameter:.4g}"
    if found.effective_length is not None:
        size += f" x {1e3 * found.effective_length:.4g}"
    rows = f"{found.rows} x " if found.rows > 1 else ""
    return f"{rows}{found.elements} {'balls' if found.is_ball else 'rollers'}, {size} mm"
