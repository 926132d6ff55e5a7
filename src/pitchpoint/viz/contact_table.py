# SPDX-License-Identifier: Apache-2.0
"""Contact analysis in tables: columns of the main results, description of the contact."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from pitchpoint.core.units import format_quantity

if TYPE_CHECKING:
    import xarray as xr


class Column(NamedTuple):
    """Column of a table over the torques: key of `contact_numbers`, heading, dimension, digits, factor."""

    key: str
    heading: str
    dimension: str
    digits: int = 5
    factor: float = 1.0

    def text(self, value: float) -> str:
        """Value in a customary unit; an en dash if it is not a number.

        Examples
        --------
        >>> Column("loss_share", "loss [%]", "dimensionless", 3, 100.0).text(0.01)
        '1'
        """
        if not math.isfinite(value):
            return "–"
        return format_quantity(self.factor * value + 0.0, self.dimension, self.digits)


COLUMNS = (
    Column("mean_transmission_error", "TE mean", "length"),
    Column("transmission_error_pp", "TE p–p", "length", 4),
    Column("mean_secant_stiffness", "k secant", "stiffness"),
    Column("mean_mesh_stiffness", "k tangent", "stiffness"),
    Column("flank_pressure", "p flank", "pressure", 4),
    Column("edge_pressure", "p tip edge", "pressure", 4),
    Column("root_stress_1", "σ_F1", "pressure", 4),
    Column("root_stress_2", "σ_F2", "pressure", 4),
    Column("root_stress_fe_1", "σ_F1 FE", "pressure", 4),
    Column("root_stress_fe_2", "σ_F2 FE", "pressure", 4),
    Column("face_load_factor", "K_Hβ", "dimensionless"),
    Column("transverse_load_factor", "K_Hα", "dimensionless"),
    Column("line_load_ratio", "w max/mean", "dimensionless", 4),
    Column("loaded_pairs", "pairs", "dimensionless", 4),
    Column("loss_factor", "H_V", "dimensionless", 4),
    Column("loss_share", "loss [%]", "dimensionless", 4, 100.0),
    Column("max_flash_temperature", "flash", "temperature_difference", 4),
    Column("min_film_thickness", "film", "length", 4),
)
"""Main results of a contact analysis, one row per torque; the last three with operating conditions."""

FLANKS = (
    "d, root side",
    "d, tip side",
    "roll angle, root side",
    "roll angle, tip side",
    "d_Nf",
    "d_Na",
)
"""Columns of the flanks in contact: ends under load, and those of undeformed gears."""
ON_SHAFTS = ("torque", "force", "misalignment")
"""First columns of a table of meshes, means over the positions: torque on gear 1, force along the base
tangent, misalignment in the plane of action over the face width."""

NEGLIGIBLE = 1e-12
"""Misalignment below which it is rounding [rad], also over the face width [m]."""

ORDER = {
    "level": "dimensionless",
    "planes": "dimensionless",
    "body": "dimensionless",
    "clamp": "angle",
    "coupling": "dimensionless",
    "correction": "dimensionless",
    "overlap": "dimensionless",
    "stiffness": "stiffness",
    "exponent": "dimensionless",
    "root_stress": "dimensionless",
}
"""Options of a contact that its description gives, in this order, and their dimensions."""
WORDS = {"correction": "C_M", "overlap": "contact overlap", "root_stress": "root stress at"}


OPERATION = {
    "speed": "angular_speed",
    "friction": "dimensionless",
    "viscosity": "dynamic_viscosity",
    "pressure_viscosity": "pressure_viscosity",
}
"""Operating conditions and their dimensions."""


def columns(numbers: Mapping[str, Any]) -> list[Column]:
    """Columns for the results that are there."""
    return [column for column in COLUMNS if column.key in numbers]


def flank_cells(flank: Mapping[str, Any]) -> list[str]:
    """Ends of the flank in contact of one gear, in the order of `FLANKS`.

    Parameters
    ----------
    flank
        Attributes of an `analysis.flank_contact.active_flank.ActiveFlank` [m, rad].

    Examples
    --------
    >>> flank = {"diameter": (0.07, 0.08), "roll_angle": (0.2, 0.5), "geometric_diameter": (0.071, 0.08)}
    >>> flank_cells(flank)
    ['70 mm', '80 mm', '11.46 deg', '28.65 deg', '71 mm', '80 mm']
    """
    kinds = (("diameter", "length", 6), ("roll_angle", "angle", 4), ("geometric_diameter", "length", 6))
    return [
        format_quantity(float(end), dimension, digits)
        for name, dimension, digits in kinds
        for end in flank[name]
    ]


def gear_names(options: Mapping[str, Any]) -> list[str]:
    """Names of both gears from the options of an analysis."""
    return [str(name) for name in options.get("gears", ("gear 1", "gear 2"))]


def meshes_table(meshes: Mapping[str, tuple[float, float, float, Mapping[str, Any]]]) -> list[list[str]]:
    """Table of meshes on their shafts, first the headings; columns without any value are omitted.

    Parameters
    ----------
    meshes
        By mesh: torque [N m], force [N] and misalignment [m] as in `ON_SHAFTS`, and the results of
        `contact_numbers` for this torque.

    Examples
    --------
    >>> meshes_table({"stage": (100.0, 5e3, 1e-5, {"face_load_factor": [1.2], "edge_pressure": [math.nan]})})
    [['mesh', 'torque', 'force', 'misalignment', 'K_Hβ'], ['stage', '100 N m', '5000 N', '10 µm', '1.2']]
    """
    known = dict.fromkeys(c for *_, found in meshes.values() for c in columns(found))
    kept = [
        c
        for c in known
        if any(math.isfinite(found.get(c.key, [math.nan])[0]) for *_, found in meshes.values())
    ]
    rows = [["mesh", *ON_SHAFTS, *(c.heading for c in kept)]]
    for name, (torque, force, gap, found) in meshes.items():
        first = (
            format_quantity(torque, "torque", 5),
            format_quantity(force, "force", 5),
            format_quantity(gap if abs(gap) > NEGLIGIBLE else 0.0, "length", 3),
        )
        rows.append([name, *first, *(c.text(float(found.get(c.key, [math.nan])[0])) for c in kept)])
    return rows


def operation_words(options: Mapping[str, Any]) -> list[str]:
    """Operating conditions in words.

    Examples
    --------
    >>> operation_words({"speed": 157.07963267948966, "friction": 0.05})
    ['speed of gear 1 1500 rpm', 'friction 0.05']
    """
    return [
        f"{'speed of gear 1' if name == 'speed' else name.replace('_', '-')} "
        f"{format_quantity(float(options[name]), dimension)}"
        for name, dimension in OPERATION.items()
        if name in options
    ]


def options_of(data: xr.Dataset) -> dict[str, Any]:
    """Options of a contact analysis: those of the solver and of the contact, from attributes or a file."""
    stored = data.attrs.get("options", {})
    options = json.loads(stored) if isinstance(stored, str) else dict(stored)
    return {**options, **{name: data.attrs[name] for name in (*ORDER, *OPERATION) if name in data.attrs}}


def contact_words(options: Mapping[str, Any]) -> str:
    """Level and options of the contact in one line.

    Examples
    --------
    >>> contact_words({"level": "rigid", "planes": 1, "stiffness": 2e8, "exponent": 1.0})
    'level rigid, 1 contact plane, stiffness 200 N/µm, exponent 1'
    >>> contact_words({"level": "flexible", "planes": 21, "body": "ring", "clamp": 0.5, "correction": 0.8})
    'level flexible, 21 contact planes, body ring, C_M 0.8'
    """
    parts = []
    for name, dimension in ORDER.items():
        # only Weber and Banaschek's body has a clamp
        if name not in options or (name == "clamp" and options.get("body") != "weber_banaschek"):
            continue
        value = options[name]
        if name == "planes":
            parts.append(f"{value} contact plane{'s' if value != 1 else ''}")
            continue
        if isinstance(value, int | float) and not isinstance(value, bool):
            value = format_quantity(float(value), dimension)
        parts.append(f"{WORDS.get(name, name)} {str(value).replace('_', ' ')}")
    return ", ".join(parts)
